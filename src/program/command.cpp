// Tangled from paper/B-command-line.md; edit there.
#include "program/command.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <tuple>
#include <utility>

#include <CLI/CLI.hpp>

#include "program/deliver.hpp"
#include "program/exit_status.hpp"
#include "program/format.hpp"
#include "program/law_output.hpp"
#include "program/manual.hpp"
#include "program/sweep.hpp"
#include "studies/claims.hpp"
#include "studies/figure_data.hpp"
#include "studies/timings.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

constexpr double most_points = 1000000;

[[noreturn]] void refuse_points(const std::string& name, const std::string& text) {
  throw std::invalid_argument(name + " = " + text +
                              " is not allowed: it must be A:B:N with N from 2 to 1000000, "
                              "numbers A,B,... or one number");
}

/// The point i/n of the way from a to b.
double between(double a, double b, double i, double n) {
  const double s = ((n - i) * a + i * b) / n;
  return std::isfinite(s) ? s : a * (1 - i / n) + b * (i / n);
}

/// The text of a scene file without its byte-order mark. Throws std::invalid_argument.
std::string read_all(std::istream& in) {
  constexpr std::size_t longest = 100000;
  const std::string mark = "\xEF\xBB\xBF";
  std::string text(longest + 1, ' ');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > longest)
    throw std::invalid_argument("the scene file has more than " + std::to_string(longest) +
                                " bytes");
  return text.substr(text.find(mark) == 0 ? mark.size() : 0);
}

CLI::Validator readable_file() {
  return {[](const std::string& file) -> std::string {
            std::error_code none;
            const bool is_folder = std::filesystem::is_directory(file, none);
            if (access(file.c_str(), R_OK) == 0 && !is_folder) return "";
            const int reason = is_folder ? EISDIR : errno;
            throw std::invalid_argument("cannot read the scene file " + file + ": " +
                                        std::generic_category().message(reason));
          },
          ""};
}

bool is_key(const CLI::App& command, const std::string& name) {
  const std::set<std::string> others{"output",      "profile", "resume", "part",
                                     "datapackage", "times",   "help"};
  return command.get_option_no_throw("--" + name) != nullptr && others.count(name) == 0;
}

/// Of the command, if there is one of the section's name.
std::string key_meant(const CLI::App* command, const CLI::App& solve, const std::string& name) {
  if (name.find_first_of(":{") != std::string::npos) return " (a line is NAME = VALUE)";
  if (command == nullptr) return "";
  std::vector<std::string> keys;
  for (const CLI::Option* option : command->get_options())
    if (const std::string key = option->get_name().substr(2); is_key(*command, key))
      keys.push_back(key);
  const std::string key = nearest(name, keys), place = instead_of("--" + name);
  if (!place.empty()) return " (" + place + ")";
  if (is_key(solve, name)) return " (a section [solve] may have it)";
  return key.empty() ? "" : " (did you mean " + key + "?)";
}

bool is_replaced(const CLI::App& command, const std::string& name) {
  const std::vector<const CLI::Option*> all = command.get_options();
  return std::any_of(all.begin(), all.end(), [&](const CLI::Option* option) {
    return option->count() > 0 && exclude_each_other(name, option->get_name().substr(2));
  });
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string> values_of_key(const std::string& key, const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::string> values;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || hyphenated(trimmed(line.substr(0, equals))) != key) continue;
    values.push_back(trimmed(line.substr(equals + 1, line.find('#', equals) - equals - 1)));
  }
  return values;
}

/// Null if there is none of this name.
const CLI::App* subcommand(const CLI::App& program, const std::string& name) {
  for (const CLI::App* command : program.get_subcommands({}))
    if (command->get_name() == name) return command;
  return nullptr;
}

class SceneFile : public CLI::ConfigBase {
 public:
  explicit SceneFile(const CLI::App& program) : program_(program) {}

  std::vector<CLI::ConfigItem> from_config(std::istream& in) const override {
    const std::string whole = read_all(in);
    std::istringstream text(whole);
    if (program_.get_subcommands().empty()) return {};  // which is refused next
    const std::vector<std::string> here{program_.get_subcommands().front()->get_name()};
    std::vector<CLI::ConfigItem> known;
    std::set<std::string> seen;
    for (CLI::ConfigItem& item : ConfigBase::from_config(text)) {
      if (item.name == "++" || item.name == "--") continue;  // a section begins or ends
      if (item.parents.empty()) item.parents = here;
      item.name = hyphenated(item.name);
      const CLI::App* solve = subcommand(program_, "solve");
      const CLI::App* command =
          item.parents.size() == 1 ? subcommand(program_, item.parents[0]) : nullptr;
      if (command == nullptr || !is_key(*command, item.name)) {
        const std::string key = item.parents == here ? item.name : item.fullname();
        throw std::invalid_argument("the scene file sets what is no option of " + here[0] + ": " +
                                    key + key_meant(command, *solve, key));
      }
      const std::vector<std::string> values = values_of_key(item.name, whole);
      if (item.inputs.size() > 1 && values.size() == 1) item.inputs = values;
      if (item.inputs.size() > 1 || !seen.insert(item.fullname()).second)
        throw std::invalid_argument("the scene file gives " + item.name + " more than once");
      if (item.parents == here && !is_replaced(*command, item.name)) known.push_back(item);
    }
    return known;
  }

 private:
  const CLI::App& program_;
};

void say_what_is_unused(const SceneOptions& o) {
  const bool scheme = o.approach.method == Method::gauss_chebyshev;
  const std::string method = name_of(method_names, o.approach.method);
  if (scheme ? o.tolerance.has_value() : o.nodes.has_value())
    std::fprintf(stderr, "thermoroll: note: %s makes no difference to --method %s\n",
                 scheme ? "--tolerance" : "--nodes", method.c_str());
}

void say_reference(const SceneOptions& o) {
  const bool has_law = value_of(law_names, o.friction_law).has_value();
  if (has_law && two_bulks(o) && !o.friction_reference_temperature)
    std::fprintf(stderr,
                 "thermoroll: note: --friction holds at the half-space's bulk temperature (see "
                 "--friction-reference-temperature)\n");
}

void say_direction(const Solution& x) {
  const double sign = sign_of(x.scene.direction);
  if (sign * x.value(Quantity::traction) >= 0 && sign * x.value(Quantity::creep) >= 0) return;
  std::fprintf(stderr,
               "thermoroll: note: %s is relative to the state without slip (see no_slip_traction "
               "and no_slip_creep)\n",
               name_of(direction_names, x.scene.direction).c_str());
}

void say_idle_law(const Solution& x) {
  const auto* law = x.scene.law.target<LawOfFriction>();
  const double hottest = x.value(Quantity::max_temperature);
  if (law == nullptr || std::abs(law->of.scale) < std::max(10.0, 1e4 * hottest)) return;
  std::fprintf(stderr,
               "thermoroll: note: the law changes friction by less than 1e-4: max_temperature is "
               "%.3g and --friction-temperature in the same units %.3g\n",
               hottest, law->of.scale);
}

void say_idle_floor(const Solution& x) {
  const auto* law = x.scene.law.target<LawOfFriction>();
  if (law != nullptr && law->of.scale < 0 && law->of.floor > 0)
    std::fputs("thermoroll: note: --friction-floor makes no difference to friction that rises\n",
               stderr);
}

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes)
    std::fprintf(stderr, "thermoroll: note: %s\n", note.c_str());
}

void conclude(const Solution& x, const std::optional<FoundInSi>& physical, const SceneOptions& o) {
  require_contact(x);
  if (physical) print_notes(physical->notes);
  say_what_is_unused(o);
  say_reference(o);
  if (x.scene.bulk_difference != 0) say_direction(x);
  if (!physical) say_idle_law(x);
  const std::string constant = note_on_constant_friction(x);
  if (!physical && !constant.empty()) print_notes({constant});
  say_idle_floor(x);
  if (x.approach.method == Method::closed_form || x.scene.heating == 0) return;
  const double apart = x.scene.peclet * pi / x.approach.nodes;
  if (x.approach.method == Method::gauss_chebyshev && apart > 1)
    std::fprintf(stderr,
                 "thermoroll: note: the nodes are %.3g kernel widths apart: load_ratio, gamma0 and "
                 "max_temperature are not resolved (see --method coupled)\n",
                 apart);
  if (x.approach.formulation == Formulation::printed)
    std::fprintf(stderr,
                 "thermoroll: note: thermal slope with the sign as printed (see --formulation "
                 "corrected)\n");
}

bool may_be_replaced(const std::string& name) {
  std::error_code none;
  return !std::filesystem::exists(name, none) || std::filesystem::is_regular_file(name, none);
}

bool same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path place = place_of(fs::absolute(a), none);
  return a == b || (!place.empty() && place == place_of(fs::absolute(b), none));
}

void check_names(const Options& o) {
  using Named = std::pair<const char*, std::string>;
  const std::vector<Named> written{{"--output", o.output},
                                   {"--profile", o.profile},
                                   {"--resume", o.resume},
                                   {"--datapackage", o.package}};
  std::vector<Named> others{{"the table", o.table == "-" ? "/dev/stdin" : o.table},
                            {"--config", o.config},
                            {"--times", o.times}};
  for (const auto& [option, file] : written) {
    if (file.empty() || file == "-" || !may_be_replaced(file)) continue;
    for (const auto& [other, name] : others)
      if (!name.empty() && same_file(file, name))
        throw std::invalid_argument(std::string(option) + " and " + other + " are the same file, " +
                                    name);
    others.emplace_back(option, file);
  }
}

void print_trace(const std::vector<GridStep>& trace) {
  const auto text = [](const std::optional<double>& x) -> std::string {
    char digits[16];
    std::snprintf(digits, sizeof digits, "%.1e", x.value_or(0));
    return x ? digits : "-";
  };
  std::fprintf(stderr, "%8s %20s %6s %8s %8s %8s\n", "unknowns", "border", "newton", "tail",
               "change", "estimate");
  for (const GridStep& x : trace)
    std::fprintf(stderr, "%8d %20.15g %6d %8s %8s %8s\n", x.unknowns, x.border, x.newton_steps,
                 text(x.tail).c_str(), text(x.change).c_str(), text(x.estimate).c_str());
}

SolvedScene solve_traced(const Options& o) try {
  return solve_scene(read_scene(o.of_scene));
} catch (const NotResolved& failure) {
  if (o.trace) print_trace(failure.trace);
  throw;
}

void run_solve(const Options& o) {
  if (o.profile == "-")
    throw std::invalid_argument("profile = - is not allowed: it must be a file, beside the result");
  if (o.profile_points && o.profile.empty())
    throw std::invalid_argument("--profile-points needs --profile");
  const auto [x, units, physical] = solve_traced(o);
  std::vector<Answer> answers{{present(x, physical, value_of(format_names, o.format)), o.output}};
  if (!o.profile.empty()) {
    const Profile found = o.profile_points ? profile(x, *o.profile_points) : profile(x);
    answers.push_back({profile_csv(found, units), o.profile});
  }
  deliver(answers);
  if (o.trace) print_trace(x.trace);
  conclude(x, physical, o.of_scene);
}

void run_temperature(const Options& o) {
  const std::vector<double> at = read_points("at", o.at), depths = read_points("depth", o.depth);
  const double rows = static_cast<double>(at.size()) * static_cast<double>(depths.size());
  require(rows <= most_points, "number of rows", rows, "at most 1000000");
  for (const double depth : depths) require(depth >= 0, "depth", depth, "zero or positive");
  const auto [x, units, physical] = solve_scene(read_scene(o.of_scene));
  std::vector<DepthCurve> curves;
  curves.reserve(depths.size());
  for (const double depth : depths) curves.push_back({depth, temperature_curve(x, at, depth)});
  deliver({{curve_csv(curves, units), o.output}});
  conclude(x, physical, o.of_scene);
}

struct AllCreeps {
  Scene scene;
  Formulation formulation;
  std::optional<LawUnits> units;
  std::optional<PhysicalScene> physical;
};

AllCreeps read_all_creeps(SceneOptions o) {
  if (o.load && !o.half_width)
    throw std::invalid_argument(
        "all creeps in SI units need --half-width: from a radius it would differ along them");
  o.creep = 1;  // or any other
  const GivenScene c = read_scene(o);
  if (!c.physical) return {c.scene, c.approach.formulation, {}, {}};
  check(*c.physical);
  const double friction = c.scene.friction;
  return {scene_of(*c.physical, friction), c.approach.formulation, law_units(*c.physical, friction),
          c.physical};
}

/// A number with four digits, or more where it is near the limit, between x and the limit.
std::string rounded_towards(double limit, double x) {
  const double inside = x - 5e-4 * (x - limit);
  const auto is_between = [&](const char* digits) {
    const double given = std::atof(digits);
    return std::min(limit, x) <= given && given <= std::max(limit, x);
  };
  char digits[32];
  for (int n = 4; n <= 17; ++n) {
    std::snprintf(digits, sizeof digits, "%.*g", n, inside);
    if (is_between(digits)) break;
  }
  return digits;
}

/// The end of a curve that begins without slip at the creep rest.
std::string note_on(const LawEnd& end, double rest, const std::optional<LawUnits>& units,
                    const std::string& when = "") {
  const double unit = units ? units->creep : 1;
  return (units ? "the curve ends at the creep ratio " : "the curve ends at the creep ") +
         rounded_towards(rest * unit, end.creep * unit) + when + ": " + end.reason;
}

/// Of a curve that was to go from one creep to another.
std::vector<std::string> notes_on_ends(const CreepLaw& law, double from, double to,
                                       const std::optional<LawUnits>& units) {
  std::vector<std::string> notes;
  for (const double creep : {from, to}) {
    const auto& [half, sign, size] = side_of(law, creep);
    if (size <= half.last_creep) continue;
    notes.push_back(note_on({law.no_slip_creep + sign * half.last_creep, half.reason},
                            law.no_slip_creep, units));
  }
  return notes;
}

/// The result of make(); a failure has the notes of @sec:limits in its message.
template <class Make>
auto noted(const AllCreeps& c, const Make& make) try {
  return make();
} catch (const std::exception&) {
  if (!c.physical) throw;
  throw_again_with(in_a_message(notes_on(*c.physical, c.scene.friction, 0, 0)));
}

constexpr double law_tolerance = 1e-4;

CreepLawBySpeed law_of(const AllCreeps& c, const Maybe& to_speed, double tolerance) {
  if (!to_speed) {
    const double speed = c.units ? c.units->speed : 1;
    const CreepLaw law = creep_law(c.scene, c.formulation, tolerance);
    return {{speed}, {law}, law.traction_error, law.border_error, law.temperature_error};
  }
  if (!c.physical) throw std::invalid_argument("for data in SI units only: --to-speed");
  const auto at = [&](double speed) {
    PhysicalScene si = *c.physical;
    si.speed = speed;
    return scene_of(si, c.scene.friction);
  };
  return creep_law_by_speed(at, c.formulation, c.physical->speed, *to_speed, tolerance);
}

void run_law(const Options& o) {
  const AllCreeps c = read_all_creeps(o.of_scene);
  const double tolerance = o.of_scene.tolerance.value_or(law_tolerance);
  const CreepLawBySpeed law = noted(c, [&] { return law_of(c, o.to_speed, tolerance); });
  deliver({{law_text(law, c.scene, c.formulation, c.physical, value_of(language_names, o.language)),
            o.output}});
  say_reference(o.of_scene);
  const double far = 20 * c.scene.friction / pi;
  for (const bool brakes : {true, false}) {
    const LawEnd end = earliest_end(law, brakes);
    const char* when = o.to_speed ? " at the earliest" : "";
    const double rest = law.laws.front().no_slip_creep;
    if (std::abs(end.creep) < far) print_notes({note_on(end, rest, c.units, when)});
  }
  if (c.physical) print_notes(notes_on(*c.physical, c.scene.friction, 0, 0));
}

/// An end in the unit of its option, if it is given.
struct CurveEnd {
  std::string name;
  double unit;  // xi* by its unit
  Maybe asked;
};

CurveEnd end_of(const std::string& name, const Maybe& creep, const Maybe& ratio,
                const Maybe& other_ratio, const std::optional<LawUnits>& units) {
  if (!ratio && (creep || !other_ratio || !units)) return {name, 1, creep};
  if (creep)
    throw std::invalid_argument("--" + name + " and --" + name + "-ratio exclude each other");
  if (!units) throw std::invalid_argument("for data in SI units only: --" + name + "-ratio");
  return {name + "-ratio", 1 / units->creep, ratio};
}

/// The end, or where the curve ends before if it is not given.
double bound(const CurveEnd& end, double creep, const CreepLaw& law) {
  const auto& [half, sign, size] = side_of(law, creep);
  const double rest = law.no_slip_creep;
  double last = rest + sign * half.last_creep;
  while (side_of(law, last).size > half.last_creep) last = std::nextafter(last, rest);
  if (!end.asked) return size > half.last_creep ? last : creep;
  if (size > half.last_creep)
    throw std::invalid_argument(end.name + " = " + shortest(*end.asked) +
                                " is not allowed: it must be " +
                                (sign > 0 ? "at most about " : "at least about ") +
                                rounded_towards(rest / end.unit, last / end.unit) +
                                ", where the curve ends: " + half.reason);
  return creep;
}

CurveRange range_of(const CurveEnd& first, double from, const CurveEnd& last, double to,
                    const CreepLaw& law, int points) {
  const CurveRange range{bound(first, from, law), bound(last, to, law), points};
  if (range.from < range.to) return range;
  throw std::invalid_argument("the curve has no creep between " + shortest(from) + " and " +
                              shortest(to) + ", but " + shortest(law.no_slip_creep) +
                              " without slip: give --from and --to");
}

std::vector<std::string> notes_along(const CreepLaw& law, const std::vector<double>& creeps,
                                     const LawUnits& units, const PhysicalScene& si,
                                     double friction) {
  double creep = 0, rise = 0;
  for (const double x : creeps) {
    if (std::abs(x) * units.creep > std::abs(creep)) creep = x * units.creep;
    if (const auto at = evaluate(law, x))
      rise = std::max(rise, at->temperature * units.temperature);
  }
  return notes_on(si, friction, creep, rise);
}

void refuse_order(const CurveEnd& first, const CurveEnd& last, double from, double to) {
  const bool by_first = first.asked.has_value();
  const CurveEnd &given = by_first ? first : last, &other = by_first ? last : first;
  const double limit = (by_first ? to : from) / other.unit;
  require(false, given.name, *given.asked,
          (by_first ? "below --" : "above --") + other.name + ", " + shortest(limit) +
              (other.asked ? "" : " if that is not given"));
}

void run_creep_curve(const Options& o) {
  const AllCreeps c = read_all_creeps(o.of_scene);
  check(c.scene);
  require(2 <= o.points && o.points <= 100000, "points", o.points, "from 2 to 100000");
  const double far = 6 * c.scene.friction / pi;
  const CurveEnd first_end = end_of("from", o.from, o.from_ratio, o.to_ratio, c.units),
                 last_end = end_of("to", o.to, o.to_ratio, o.from_ratio, c.units);
  const double from = first_end.asked ? *first_end.asked * first_end.unit : -far,
               to = last_end.asked ? *last_end.asked * last_end.unit : far;
  if (!(from < to)) refuse_order(first_end, last_end, from, to);
  const double tolerance = o.of_scene.tolerance.value_or(law_tolerance);
  const CreepLaw law = noted(c, [&] {
    return creep_law(c.scene, c.formulation, tolerance, {from, to});
  });
  const CurveRange range =
      noted(c, [&] { return range_of(first_end, from, last_end, to, law, o.points); });
  const auto points = curve_points(law, range, c.scene.friction);
  deliver({{creep_curve_csv(law, points, c.units), o.output}});
  say_reference(o.of_scene);
  print_notes(notes_on_ends(law, from, to, c.units));
  if (c.physical) print_notes(notes_along(law, points, *c.units, *c.physical, c.scene.friction));
}

[[noreturn]] void refuse_name(const std::string& name, const std::vector<std::string>& names) {
  const std::string other = nearest(name, names);
  throw std::invalid_argument("NAME = " + name +
                              " is not allowed: it must be a name of figure-data --list" +
                              (other.empty() ? "" : " (did you mean " + other + "?)"));
}

void run_figure_data(const Options& o) {
  if (o.list == !o.name.empty())
    throw std::invalid_argument("figure-data needs either a NAME or --list");
  const bool timed = !o.times.empty();
  const std::vector<std::string> names = timed ? timed_data_names() : figure_data_names();
  if (o.list) return deliver({{joined(names, "\n") + '\n', o.output}});
  if (std::find(names.begin(), names.end(), o.name) == names.end()) refuse_name(o.name, names);
  std::ostringstream out;
  if (timed)
    write_timed_data(o.name, read_benchmarks(o.times), out);
  else
    write_figure_data(o.name, out);
  deliver({{out.str(), o.output}});
}

void run_claims(const Options& o) {
  deliver({{present(claims(), value_of(format_names, o.format)), o.output}});
}

std::optional<Part> read_part(const std::string& text) {
  if (text.empty()) return std::nullopt;
  constexpr long most = 1000000;
  const std::size_t slash = text.find('/');
  const std::optional<double> number = to_number(text.substr(0, slash)),
                              of = slash < text.size() ? to_number(text.substr(slash + 1)) : number;
  const bool whole = number && of && *number == std::floor(*number) && *of == std::floor(*of);
  if (slash == std::string::npos || !whole || *number < 1 || *number > *of || *of > most)
    throw std::invalid_argument("part = " + text +
                                " is not allowed: it must be I/N with I from 1 to N and N up to "
                                "1000000");
  return Part{static_cast<long>(*number), static_cast<long>(*of)};
}

int open_table(const std::string& file) {
  if (file != "-") {
    std::error_code none;
    const bool is_folder = std::filesystem::is_directory(file, none);
    const int input = is_folder ? -1 : open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (input < 0)
      throw std::invalid_argument("cannot read the table " + file + ": " +
                                  std::generic_category().message(is_folder ? EISDIR : errno));
    return input;
  }
  if (isatty(STDIN_FILENO) != 0)
    std::fputs("thermoroll: note: the table is read from the terminal (see sweep --help)\n",
               stderr);
  return STDIN_FILENO;
}

void check_files(const Options& o) {
  if (!o.part.empty() && o.table == "-")
    throw std::invalid_argument("--part needs the table as a file: thermoroll sweep TABLE --part " +
                                o.part);
  if (o.resume == "-") throw std::invalid_argument("resume = - is not allowed: it must be a file");
  if (!o.resume.empty() && !o.output.empty())
    throw std::invalid_argument("--output and --resume exclude each other");
  if (!o.package.empty() && (!o.part.empty() || (o.output + o.resume).empty() || o.output == "-"))
    throw std::invalid_argument("--datapackage describes the results of a whole table in a file");
}

void run_sweep(const Options& o) {
  const unsigned processors = std::thread::hardware_concurrency();  // 0 if unknown
  const int jobs = o.jobs.value_or(std::max(1, static_cast<int>(processors)));
  require(1 <= jobs && jobs <= 1024, "jobs", jobs, "from 1 to 1024");
  check_files(o);
  const bool to_terminal = isatty(STDERR_FILENO) != 0;
  const bool to_file = isatty(STDOUT_FILENO) == 0 || !(o.output + o.resume).empty();
  const SweepRequest request{
      open_table(o.table), o.of_table,        o.output, o.resume,
      o.package,           read_part(o.part), jobs,     to_terminal && to_file};
  const SweepCount rows = sweep(request);
  if (to_terminal || o.verbose) std::fprintf(stderr, "thermoroll: %s\n", summary(rows).c_str());
  if (rows.noted > 0)
    std::fprintf(stderr, "thermoroll: note: %ld of %ld%s rows have notes: see their column notes\n",
                 rows.noted, rows.rows - rows.resumed, rows.resumed > 0 ? " more" : "");
  if (rows.failed > 0)
    throw RowsFailed(std::to_string(rows.failed) + " of " + std::to_string(rows.rows) +
                     " rows have an error: see their columns status and error");
}

void add_format(CLI::App& command, Options& o) {
  command.add_option("--format", o.format, "format of the result, text unless given")
      ->type_name(joined(words(format_names), "|"))
      ->check(one_of("format", words(format_names)));
}

void add_output(CLI::App& command, Options& o) {
  command.add_option("--output", o.output, "write to this file, all or nothing")
      ->type_name("FILE")
      ->check(file_name("output"));
  command.add_flag("--verbose", o.verbose, "tell the time taken on standard error");
}

void add_solve(CLI::App& program, Options& o) {
  CLI::App& command = *program.add_subcommand("solve", "Solve one scene and print the result");
  add_scene_options(command, o.of_scene);
  add_format(command, o);
  command
      .add_option(
          "--profile", o.profile,
          "write s, p*, q*, v*, heat flux and T* to this file, f of a law, and the largest "
          "error of each at one distance from the border; s from -1, where the surfaces enter the "
          "contact, to 1 (just inside if bulk temperatures differ)")
      ->type_name("FILE")
      ->check(file_name("profile"));
  command
      .add_option("--profile-points", o.profile_points, "2 to 100000; the solver's unless given")
      ->type_name("NUMBER")
      ->check(whole_number("profile-points"));
  command.add_flag("--trace", o.trace, "tell the grids of the coupled solver on standard error");
  add_output(command, o);
}

void add_temperature(CLI::App& program, Options& o) {
  CLI::App& command =
      *program.add_subcommand("temperature", "Print temperatures of the half-space as CSV");
  add_scene_options(command, o.of_scene);
  command
      .add_option(
          "--at", o.at,
          "s, in half-widths: A:B:N (N points from A to B), a list A,B,..., a number; -1.5:4:551 "
          "unless given; surfaces enter the contact at s = -1, leave it at 1 and cool behind it")
      ->type_name("POINTS");
  command.add_option("--depth", o.depth, "depths in units of a, as --at; 0 unless given")
      ->type_name("POINTS");
  add_output(command, o);
}

void add_all_creeps(CLI::App& command, Options& o) {
  add_scene_options(command, o.of_scene);
  for (const char* name :
       {"--traction", "--creep", "--stick-slip-border", "--direction", "--branch", "--radius",
        "--method", "--nodes", "--tolerance", "--creep-ratio", "--tangential-load"})
    command.remove_option(command.get_option(name));
  add_number(command, "tolerance", o.of_scene.tolerance, "1e-7 to 1e-2; 1e-4 unless given")
      ->group("Method");
}

void add_creep_curve(CLI::App& program, Options& o) {
  CLI::App& command = *program.add_subcommand("creep-curve", "Print traction by creep as CSV");
  add_all_creeps(command, o);
  const char *creep = "creep xi*, negative for braking",
             *ratio = "the same as a fraction of the speed, with SI data";
  const std::tuple<const char*, Maybe*, const char*> ends[] = {{"from", &o.from, creep},
                                                               {"to", &o.to, creep},
                                                               {"from-ratio", &o.from_ratio, ratio},
                                                               {"to-ratio", &o.to_ratio, ratio}};
  for (const auto& [name, value, meaning] : ends) add_number(command, name, *value, meaning);
  command.add_option("--points", o.points, "number of rows, 101 unless given")
      ->type_name("NUMBER")
      ->check(whole_number("points"));
  add_output(command, o);
}

void add_creep_law(CLI::App& program, Options& o) {
  CLI::App& command = *program.add_subcommand("law", "Write traction by creep as a function");
  add_all_creeps(command, o);
  command.add_option("--format", o.language, "language of the function, c unless given")
      ->type_name(joined(words(language_names), "|"))
      ->check(one_of("format", words(language_names)));
  add_number(command, "to-speed", o.to_speed,
             "m/s, with SI data: a law for creep and speed, from --speed to this");
  add_output(command, o);
}

void add_table(CLI::App& command, Options& o) {
  const auto add = [&](const char* name, std::string& value, const char* type,
                       const char* meaning) {
    CLI::Option* option = command.add_option(name, value, meaning)->type_name(type);
    const bool is_file = type == std::string("FILE");
    return option->check(is_file ? file_name(name + 2) : not_empty(name + 2, type));
  };
  command.add_option("TABLE", o.table, "a file; standard input if it is - or not given")
      ->type_name("")
      ->check(file_name("TABLE"));
  add("--columns", o.columns, "A,B,...", "write these columns only, in this order");
  add("--format", o.rows_format, joined(words(row_format_names), "|").c_str(),
      "format of the rows, csv unless given")
      ->check(one_of("format", words(row_format_names)));
  add("--keep", o.keep, "A,B,...", "columns that are labels, as id is");
  add("--given", o.of_table.given, "NAME", "of a table with results: the column that prescribes");
  add("--output", o.output, "FILE", "write to this file, which appears when it is complete");
  add("--resume", o.resume, "FILE", "append to this file, from the row on where it ends");
  add("--datapackage", o.package, "FILE", "describe the columns, with units, symbols and errors");
  add("--part", o.part, "I/N", "the I-th of N parts of the rows; the first has the header");
}

void add_sweep(CLI::App& program, Options& o) {
  CLI::App& command = *program.add_subcommand("sweep", "Solve a table of scenes, row by row");
  add_table(command, o);
  command.add_option("--jobs", o.jobs, "rows solved at a time; as many as processors unless given")
      ->type_name("NUMBER")
      ->check(whole_number("jobs"));
  command.add_flag("--verbose", o.verbose, "tell rows, speed, memory and time on standard error");
  add_scene_options(command, o.of_scene);
  command.get_option("--friction")->required(false);
}

std::vector<Setting> settings_given(const CLI::App& command) {
  SceneOptions none;
  CLI::App scene;
  add_scene_options(scene, none);
  std::vector<Setting> given;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    const bool is_of_scene = name != "--help" && scene.get_option_no_throw(name) != nullptr;
    if (is_of_scene && option->count() > 0) given.push_back({name.substr(2), option->results()[0]});
  }
  return given;
}

void read_table_options(const CLI::App& command, Options& o) {
  if (o.table.empty()) o.table = "-";
  if (!o.keep.empty()) read_cells(o.keep, o.of_table.keep);
  if (!o.columns.empty()) read_cells(o.columns, o.of_table.columns);
  std::replace(o.of_table.given.begin(), o.of_table.given.end(), '_', '-');
  if (!o.of_table.given.empty() && !is_given_option(o.of_table.given))
    throw std::invalid_argument("given = " + o.of_table.given +
                                " is not allowed: it must be traction, creep, stick-slip-border, "
                                "creep-ratio or tangential-load");
  o.of_table.format = value_of(row_format_names, o.rows_format);
  o.of_table.constants = settings_given(command);
}

void add_figure_data(CLI::App& program, Options& o) {
  CLI::App& command =
      *program.add_subcommand("figure-data", "Write the data of a figure or table of the report");
  command.add_option("NAME", o.name, "which data")->type_name("");
  command.add_flag("--list", o.list, "print the names that there are, in place of data");
  command.add_option("--times", o.times, "data on times, from this output of thermoroll-bench")
      ->type_name("FILE")
      ->check(file_name("times"));
  add_output(command, o);
}

void add_claims(CLI::App& program, Options& o) {
  CLI::App& command =
      *program.add_subcommand("claims", "Print the paper's statements beside what was found");
  add_format(command, o);
  add_output(command, o);
}

void add_help(CLI::App& program, Options& o) {
  CLI::App& command =
      *program.add_subcommand("help", "Print the help of the program or of a subcommand");
  command.add_option("SUBCOMMAND", o.name, "whose help")->type_name("");
  command.add_option("--format", o.help, "text unless given; a manual page; completion for bash")
      ->type_name(joined(words(help_format_names), "|"))
      ->check(one_of("format", words(help_format_names)));
  command.add_option("--output", o.output, "write to this file, all or nothing")
      ->type_name("FILE")
      ->check(file_name("output"));
}

constexpr const char* solve_examples = R"(Examples:
  thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --heating 0.0175
  thermoroll solve --friction 0.6 --creep 0.2 --peclet 100 --heating 1 --tolerance 1e-9 \
    --format json --profile profile.csv
  thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --method closed-form --format json
  thermoroll solve --friction 0.6 --traction 0.5 --load 1.2e7 --speed 22.2 --half-width 5.5e-3 \
    --shear-modulus 8.1e10 --poisson 0.3 --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50
  thermoroll solve --friction 0.6 --traction -0.5 --peclet 4360 --heating 0.0175 --roller identical
  thermoroll solve --friction 0.6 --creep 0.5 --peclet 100 --heating 0.0175 \
    --friction-law linear --friction-temperature 0.02
  thermoroll solve --friction 0.3 --creep-ratio 0.002 --load 1.2e7 --speed 22.2 --radius 0.46 \
    --shear-modulus 8.1e10 --poisson 0.3 --expansion 1.1e-5 --diffusivity 1.4e-5 \
    --conductivity 50 --roller identical
  thermoroll solve --config wheel.toml --profile profile.csv --profile-points 401

The last reads the scene from a file of lines such as "friction = 0.6" (TOML or INI).
Errors are estimates, not bounds.
Methods: auto takes the least of the next three that meets the tolerance; coupled solves tractions
and heat together; first-order corrects the closed form for the heat once; closed-form leaves out
what the heat does to the tractions, and asked for by name does not count that in its errors;
gauss-chebyshev is the published scheme and has no error estimate.
With theta the rise above the reference temperature over --friction-temperature, friction is f times
max(floor, 1 - theta) for the law linear, floor + (1 - floor) exp(-theta) for exponential,
floor + (1 - floor) / (1 + theta) for rational and 1 + (floor - 1) min(theta, 1) for
piecewise-linear, whose floor may be above 1; at or below the reference temperature it is f. For
linear a negative --friction-temperature makes friction rise.
Temperatures in degree C are rises over the bulk temperature, but contact_temperature_celsius and
absolute_temperature_celsius, which are there where --bulk-temperature is given. The force Q in N/m
is tangential_load, in JSON and CSV of solve below physical, and traction is Q over the load. With a
law and a given traction, traction_limit or tangential_load_limit is the largest one. Unless --roller
says otherwise, all heat goes into one body, the half-space: two steel bodies (--roller identical)
are about half as hot.)";

constexpr const char* sweep_examples = R"(Examples:
  thermoroll sweep scenes.csv --output results.csv
  thermoroll sweep scenes.csv --columns friction,traction,creep,max_temperature,status
  thermoroll sweep scenes.csv --tolerance 1e-3 --roller identical --format jsonl --jobs 1
  thermoroll sweep scenes.csv --part 1/2 --resume part-1.csv
  thermoroll sweep results.csv --given creep --tolerance 1e-8
  thermoroll sweep <scenes.csv >results.csv

The first row of scenes.csv names the columns: long options of solve, without the dashes, in any
order. An empty cell leaves its option out, and an option of the sweep holds in its place. The
results have the same rows in the same order: the columns given, those of solve --format csv that
are not among them, then status and error, which say what solve would have said of the row. Where
a result has the name of a column that was given, it fills the cells that were left empty. The
column id, and those that --keep names, are labels. To sweep results again, give the same options:
the results do not have them. Loads that vary need a --radius: with one --half-width they would be
those of different rollers. With --resume the same command can be given again after it was stopped.
Parts joined, in order, are the results of the whole table.)";

constexpr const char* temperature_examples = R"(Examples:
  thermoroll temperature --friction 0.6 --traction 0.5 --peclet 1000 --at -1:3:401
  thermoroll temperature --friction 0.6 --traction 0.5 --peclet 100 --at 0,0.5,1 --depth 0.1
  thermoroll temperature --config wheel.toml --output temperature.csv
  thermoroll temperature --config wheel.toml --at -1:3:41 --depth 0:0.2:5 --output map.csv

The columns are s, temperature (T*) and error_estimate (of T*, absolute; empty for gauss-chebyshev),
with depth behind s where there are several. With data in SI units there are x_m, depth_m and
temperature_celsius (the rise over the bulk temperature), each behind its own; with
--bulk-temperature also absolute_temperature_celsius, the sum of both. The last column is then
error_estimate_celsius. Unless --roller says otherwise, all heat goes into one body: two steel bodies
(--roller identical) are about half as hot.)";

constexpr const char* creep_curve_examples = R"(Examples:
  thermoroll creep-curve --friction 0.6 --peclet 4360 --heating 0.0175 --roller identical
  thermoroll creep-curve --friction 0.6 --peclet 100 --heating 0.0175 --from -1 --to 1 --points 41 \
    --friction-law linear --friction-temperature 0.02 --output curve.csv

Without --from and --to, or --from-ratio and --to-ratio, the rows reach to three times the creep at
which the contact slips without heat, or to the end of the curve. They are dense where it bends.
With data in SI units there are columns for the creep as a fraction of the speed, its speed, the
tangential load in N/m and the largest rise in degree C; with --bulk-temperature also the temperature
itself. A curve is of one --half-width: that of a radius is told by solve --radius. If the bulk
temperatures differ, a curve goes on where the bodies separate, or exceed friction, over less than
0.005 of the half-width at the leading edge, and next to no slip, where one slip zone may not be
enough; solve tells that it is no contact. Unless --roller says otherwise, all heat goes into one
body: two steel bodies (--roller identical) are about half as hot.)";

constexpr const char* law_examples = R"(Examples:
  thermoroll law --friction 0.6 --peclet 4360 --heating 0.0175 --roller identical --output law.c
  thermoroll law --friction 0.6 --peclet 100 --heating 0.0175 --friction-law linear \
    --friction-temperature 0.02 --format python --output law.py
  thermoroll law --friction 0.6 --load 1.2e7 --speed 1 --to-speed 60 --half-width 5.5e-3 \
    --shear-modulus 8.1e10 --poisson 0.3 --expansion 1.1e-5 --diffusivity 1.4e-5 \
    --conductivity 50 --roller identical

The function takes a creep and gives traction, its slope, the largest temperature and a status, which
is 1 beyond the end of the law, where the others are 0: xi*, Q*, T*, or with data in SI units the creep
as a fraction of the speed, N/m and the rise in degree C. With --to-speed it takes a speed in m/s,
too; the tolerance is then from 3e-7 on. A law of a wide range of speeds, or to 1e-6, may take a minute
or two; one speed to 1e-3 mostly takes seconds. A law is of one --half-width: that of a radius is told
by solve --radius. Two laws in one C program need names of their own, as by
cc -Dcreep_law=wheel_law. Creeps above 0.1 of the speed have values, too, but are beyond the model. If
the bulk temperatures differ, a law goes on where the bodies separate, or exceed friction, over less
than 0.005 of the half-width at the leading edge, and next to no slip, where one slip zone may not be
enough; solve tells that it is no contact. Unless --roller says otherwise, all heat goes into one
body: two steel bodies (--roller identical) are about half as hot.)";

constexpr const char* figure_data_examples = R"(Examples:
  thermoroll figure-data --list
  thermoroll figure-data traction --output traction.csv
  thermoroll figure-data --list --times times.json)";

constexpr const char* claims_examples = R"(Examples:
  thermoroll claims
  thermoroll claims --format csv --output claims.csv

As in the paper all heat goes into one body: two steel bodies are about half as hot.)";

constexpr const char* help_examples = R"(Examples:
  thermoroll help
  thermoroll help solve
  thermoroll help --format man --output thermoroll.1
  thermoroll help --format bash --output thermoroll.bash

make install puts both where man and bash look for them.)";

constexpr const char* program_footer = R"(Examples:
  thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --heating 0.0175
  thermoroll temperature --friction 0.6 --traction 0.5 --peclet 1000 --at -1:3:401
  thermoroll sweep scenes.csv >results.csv
  thermoroll solve --help

Exit status: 0 done; 1 failed (no solution found, not resolved, a file could not be written);
2 refused (options, numbers or files that make no sense); 3 an iteration did not converge;
4 a sweep is complete, but some of its rows have an error; 5 a solution was found, but it is no
contact: what it violates, and where, is in the result.)";

const Footers footers{{"", program_footer},
                      {"solve", solve_examples},
                      {"sweep", sweep_examples},
                      {"temperature", temperature_examples},
                      {"creep-curve", creep_curve_examples},
                      {"law", law_examples},
                      {"figure-data", figure_data_examples},
                      {"claims", claims_examples},
                      {"help", help_examples}};

std::string help(const CLI::App& program) {
  const auto commands = program.get_subcommands();
  const std::string name = commands.empty() ? "" : commands[0]->get_name();
  std::string text = program.help() + '\n' + footers.at(name) + '\n';
  for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
  return text;
}

std::vector<std::string> with_hyphens(std::vector<std::string> arguments) {
  for (std::string& argument : arguments)
    if (argument.find("--") == 0)
      argument = hyphenated(argument.substr(0, argument.find('='))) +
                 argument.substr(std::min(argument.find('='), argument.size()));
  return arguments;
}

}  // namespace

std::vector<double> read_points(const std::string& name, const std::string& text) {
  const bool grid = text.find(':') != std::string::npos;
  std::vector<double> parts;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(grid ? ':' : ',', begin);
    const std::optional<double> part = to_number(text.substr(begin, end - begin));
    if (!part) refuse_points(name, text);
    parts.push_back(*part);
  }
  if (!grid) return parts;
  if (parts.size() != 3) refuse_points(name, text);
  const double n = parts[2];
  if (!(n >= 2 && n <= most_points && n == std::floor(n))) refuse_points(name, text);
  std::vector<double> points(static_cast<std::size_t>(n));
  double i = 0;
  for (double& s : points) s = between(parts[0], parts[1], i++, n - 1);
  return points;
}

Command read_command(const std::vector<std::string>& arguments) {
  Command c;
  CLI::App program("Rolling contact of a cylinder with frictional heating", "thermoroll");
  program.set_version_flag("--version", std::string("thermoroll ") + version(),
                           "print the version");
  program.set_config("--config", "", "read a scene from this file (TOML or INI)")
      ->type_name("FILE")
      ->check(file_name("config"))
      ->check(readable_file());
  program.config_formatter(std::make_shared<SceneFile>(program));
  program.allow_config_extras(CLI::config_extras_mode::error);
  program.require_subcommand(1)->fallthrough();
  for (const auto add : {add_solve, add_sweep, add_temperature, add_creep_curve, add_creep_law,
                         add_figure_data, add_claims, add_help})
    add(program, c.options);
  try {
    std::vector<std::string> words = with_hyphens(arguments);
    std::reverse(words.begin(), words.end());
    program.parse(words);
    const CLI::App& command = *program.get_subcommands().front();
    c.subcommand = command.get_name();
    if (c.subcommand == "help") {
      const HelpFormat format = value_of(help_format_names, c.options.help);
      const std::string name = c.options.name, file = c.options.output;
      if (format != HelpFormat::text && !name.empty())
        throw std::invalid_argument("--format " + c.options.help +
                                    " is for the whole program, not " + name);
      c = {"", {}, "", file};
      if (format == HelpFormat::man) c.text = manual_page(program, footers, version());
      if (format == HelpFormat::bash)
        c.text = bash_completion(program, {{"--given", joined(given_names(), " ")},
                                           {"--columns", joined(all_results(), " ")}});
      if (format == HelpFormat::text)
        c.text = read_command(name.empty() ? std::vector<std::string>{"--help"}
                                           : std::vector<std::string>{name, "--help"})
                     .text;
    }
    if (c.subcommand == "sweep") read_table_options(command, c.options);
    c.options.config = program.get_option("--config")->as<std::string>();
    check_names(c.options);
  } catch (const CLI::CallForHelp& called) {
    if (program.get_subcommands().empty() && !program.remaining().empty())
      throw std::invalid_argument(reworded(called, program));
    c.text = help(program);
  } catch (const CLI::CallForVersion& version) {
    c.text = version.what() + std::string("\n");
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(reworded(error, program));
  }
  return c;
}

void run(const Command& c) {
  if (c.subcommand.empty()) return deliver({{c.text, c.file}});
  static const std::map<std::string, void (*)(const Options&)> runs{
      {"solve", run_solve},
      {"sweep", run_sweep},
      {"temperature", run_temperature},
      {"creep-curve", run_creep_curve},
      {"law", run_law},
      {"figure-data", run_figure_data},
      {"claims", run_claims}};
  const auto start = std::chrono::steady_clock::now();
  runs.at(c.subcommand)(c.options);
  if (c.options.verbose) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    std::fprintf(stderr, "thermoroll: %.3g s\n", taken.count());
  }
}

}  // namespace thermoroll
