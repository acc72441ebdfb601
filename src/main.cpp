// Tangled from paper/A-command-line.md; edit there.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "claims.hpp"
#include "figure_data.hpp"
#include "output.hpp"
#include "solution.hpp"

namespace thermoroll {
namespace {

using Maybe = std::optional<double>;

struct CaseOptions {
  double friction = 0;
  Maybe traction, creep, border;
  Maybe peclet, heating;
  Maybe load, speed, shear_modulus, poisson, expansion, diffusivity, conductivity;
  Maybe half_width, radius;
  std::string method = "coupled", formulation = "corrected";
  int nodes = 200;
  double tolerance = 1e-6;
};

struct CaseOption {
  const char *name, *unit, *meaning;
  Maybe CaseOptions::*value;
};

constexpr CaseOption si_options[] = {
    {"--load", "N/m", "load per unit length P", &CaseOptions::load},
    {"--speed", "m/s", "rolling speed V", &CaseOptions::speed},
    {"--shear-modulus", "Pa", "shear modulus mu of both bodies", &CaseOptions::shear_modulus},
    {"--poisson", "NUMBER", "Poisson ratio nu of both bodies", &CaseOptions::poisson},
    {"--expansion", "1/K", "thermal expansion alpha", &CaseOptions::expansion},
    {"--diffusivity", "m^2/s", "thermal diffusivity k", &CaseOptions::diffusivity},
    {"--conductivity", "W/(m K)", "thermal conductivity K", &CaseOptions::conductivity}};

constexpr CaseOption size_options[] = {
    {"--half-width", "m", "half-width a of the contact", &CaseOptions::half_width},
    {"--radius", "m", "radius R of the cylinder: half-width follows, with kappa, for this load",
     &CaseOptions::radius}};

constexpr CaseOption given_options[] = {
    {"--traction", "NUMBER", "traction Q* = Q/P, above 0 and below f", &CaseOptions::traction},
    {"--creep", "NUMBER", "in place of it: creep xi* = mu a xi / (2 (1-nu) P), positive",
     &CaseOptions::creep},
    {"--stick-slip-border", "NUMBER", "in place of it: border c0, between -1 and 1",
     &CaseOptions::border}};

Given read_given(const CaseOptions& o) {
  if (o.traction.has_value() + o.creep.has_value() + o.border.has_value() != 1)
    throw std::invalid_argument(
        "exactly one of --traction, --creep and --stick-slip-border is needed");
  if (o.traction) return {traction, *o.traction};
  return o.creep ? Given{creep, *o.creep} : Given{border, *o.border};
}

std::optional<double> to_number(const std::string& text) {
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(x)) return std::nullopt;
  return x;
}

/// A validator with this condition and this description of what is allowed.
template <class Condition>
CLI::Validator allow(Condition condition, const std::string& allowed) {
  return {[=](const std::string& text) {
            return condition(text) ? "" : text + " is not allowed: it must be " + allowed;
          },
          ""};
}

CLI::Validator finite_number() {
  return allow([](const std::string& text) { return to_number(text).has_value(); },
               "a finite number");
}

CLI::Validator whole_number() {
  const auto is_whole = [](const std::string& text) {
    int n = 0;
    std::from_chars(text.data(), text.data() + text.size(), n);
    return std::to_string(n) == text;
  };
  return allow(is_whole, "a whole number");
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto known = [=](const std::string& text) {
    return std::find(words.begin(), words.end(), text) != words.end();
  };
  return allow(known, CLI::detail::join(words, " or "));
}

void add_case_options(CLI::App& command, CaseOptions& o) {
  const auto add = [&](const CaseOption& option, const char* group) {
    return command.add_option(option.name, o.*option.value, option.meaning)
        ->type_name(option.unit)
        ->check(finite_number())
        ->group(group);
  };
  const char* groups = "Dimensionless case";
  command.add_option("--friction", o.friction, "friction coefficient f, positive")
      ->type_name("NUMBER")
      ->check(finite_number())
      ->required()
      ->group("Case");
  for (const CaseOption& option : given_options) add(option, "Case");
  add({"--peclet", "NUMBER", "Peclet number Pe = V a / 2k", &CaseOptions::peclet}, groups);
  add({"--heating", "NUMBER", "heating H = 2 alpha (1+nu) k P / (a K), 0 if not given",
       &CaseOptions::heating},
      groups);
  const char* si = "The same in SI units, all of them, in place of --peclet and --heating";
  for (const CaseOption& option : si_options) add(option, si);
  for (const CaseOption& option : size_options) add(option, si);
  command.add_option("--method", o.method, "coupled unless given")
      ->type_name("coupled|closed-form|gauss-chebyshev")
      ->check(one_of({"coupled", "closed-form", "gauss-chebyshev"}))
      ->group("Method");
  command.add_option("--tolerance", o.tolerance, "of coupled, 1e-11 to 1e-2; 1e-6 unless given")
      ->type_name("NUMBER")
      ->check(finite_number())
      ->group("Method");
  command.add_option("--nodes", o.nodes, "of gauss-chebyshev, 3 to 5000; 200 unless given")
      ->type_name("NUMBER")
      ->check(whole_number())
      ->group("Method");
  command.add_option("--formulation", o.formulation, "sign of the slope, corrected unless given")
      ->type_name("printed|corrected")
      ->check(one_of({"printed", "corrected"}))
      ->group("Method");
}

struct Case {
  Scene scene;  // its traction is the value of what is given, of use only if that is the traction
  Given given;
  Approach approach;
  std::optional<PhysicalCase> physical;
};

std::optional<Units> units_of(const Case& c) {
  if (!c.physical) return std::nullopt;
  return units_of(*c.physical, c.scene.friction);
}

Approach read_approach(const CaseOptions& o) {
  const Method method = o.method == "coupled"       ? Method::coupled
                        : o.method == "closed-form" ? Method::closed_form
                                                    : Method::gauss_chebyshev;
  const bool printed = o.formulation == "printed";
  return {method, printed ? Formulation::printed : Formulation::corrected, o.nodes, o.tolerance};
}

Case read_case(const CaseOptions& o) {
  std::string given, missing;
  for (const CaseOption& option : si_options)
    (o.*option.value ? given : missing) += std::string(" ") + option.name;
  for (const CaseOption& option : size_options)
    if (o.*option.value) given += std::string(" ") + option.name;
  const Approach approach = read_approach(o);
  const Given x = read_given(o);
  if (given.empty()) {
    if (!o.peclet) throw std::invalid_argument("--peclet is missing (or data in SI units)");
    return {{o.friction, x.value, *o.peclet, o.heating.value_or(0)}, x, approach, {}};
  }
  if (o.peclet || o.heating)
    throw std::invalid_argument("--peclet and --heating exclude data in SI units; given:" + given);
  if (!missing.empty()) throw std::invalid_argument("data in SI units lack" + missing);
  if (o.half_width.has_value() == o.radius.has_value())
    throw std::invalid_argument("data in SI units need either --half-width or --radius");
  PhysicalCase c{*o.load,    *o.speed,     o.half_width.value_or(0), *o.shear_modulus,
                 *o.poisson, *o.expansion, *o.diffusivity,           *o.conductivity};
  if (o.radius) c.half_width = half_width_of_radius(c, *o.radius, o.friction, x, approach);
  check(c);
  return {scene_of(c, o.friction, x.value), x, approach, c};
}

constexpr double most_points = 1000000;

[[noreturn]] void refuse_points(const std::string& text) {
  throw std::invalid_argument("at = " + text +
                              " is not allowed: it must be A:B:N with N from 2 to 1000000, "
                              "numbers A,B,... or one number");
}

std::vector<double> read_points(const std::string& text) {
  const bool grid = text.find(':') != std::string::npos;
  std::vector<double> parts;
  for (const std::string& part : CLI::detail::split(text + (grid ? ':' : ','), grid ? ':' : ',')) {
    if (!to_number(part)) refuse_points(text);
    parts.push_back(*to_number(part));
  }
  if (!grid) return parts;
  if (parts.size() != 3) refuse_points(text);
  const double a = parts[0], b = parts[1], n = parts[2];
  if (!(n >= 2 && n <= most_points && n == std::floor(n))) refuse_points(text);
  std::vector<double> points(static_cast<std::size_t>(n));
  double i = 0;
  for (double& s : points) s = ((n - 1 - i) * a + i * b) / (n - 1), ++i;
  return points;
}

class CaseFile : public CLI::ConfigBase {
 public:
  explicit CaseFile(const CLI::App& program) : program_(program) {}

  std::vector<CLI::ConfigItem> from_config(std::istream& in) const override {
    std::vector<CLI::ConfigItem> known;
    std::set<std::string> seen;
    for (CLI::ConfigItem& item : ConfigBase::from_config(in)) {
      if (item.name == "++" || item.name == "--") continue;  // a section begins or ends
      if (item.parents.empty()) item.parents = {program_.get_subcommands().front()->get_name()};
      if (!seen.insert(item.fullname()).second)
        throw std::invalid_argument("the case file gives " + item.name + " twice");
      known.push_back(item);
    }
    return known;
  }

 private:
  const CLI::App& program_;
};

/// The key in CLI11's two complaints, "INI was not able to parse KEY" and "KEY: This option ...".
std::string unknown_key(const std::string& text) {
  const std::string start = "INI was not able to parse ";
  return text.find(start) == 0 ? text.substr(start.size()) : text.substr(0, text.find(':'));
}

/// One line for a mistake on the command line, with the words that no option claimed.
std::string reworded(const CLI::ParseError& error, const std::vector<std::string>& unclaimed) {
  if (!unclaimed.empty()) return "unexpected " + unclaimed.front() + " (see --help)";
  const std::string text = error.what(), name = text.substr(0, text.find(':'));
  switch (static_cast<CLI::ExitCodes>(error.get_exit_code())) {
    case CLI::ExitCodes::ValidationError:
      return name.substr(name.find_first_not_of('-')) + " =" + text.substr(name.size() + 1);
    case CLI::ExitCodes::ArgumentMismatch:
      return name + " needs exactly one value";
    case CLI::ExitCodes::FileError:
      return "cannot read the case file " + text.substr(0, text.find(" was "));
    case CLI::ExitCodes::ConfigError:
      return "the case file sets what is no option for it: " + unknown_key(text);
    default:
      return text + " (see --help)";
  }
}

struct Options {
  CaseOptions of_case;
  std::string at, name, format = "text", output, profile;
  double depth = 0;
  bool list = false, verbose = false;
};

Format read_format(const std::string& name) {
  return name == "json" ? Format::json : name == "csv" ? Format::csv : Format::text;
}

void conclude(const Solution& x) {
  if (!x.converged)
    throw NotConverged("the iteration did not converge; what is written is its last iterate");
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

void run_solve(const Options& o) {
  if (!o.profile.empty() && o.profile == o.output)
    throw std::invalid_argument("--profile and --output are the same file, " + o.output);
  const Case c = read_case(o.of_case);
  const Solution x = solve(c.scene, c.approach, c.given);
  std::optional<PhysicalResults> physical;
  if (c.physical) physical = in_si_units(x, *c.physical);
  std::vector<Answer> answers{{present(x, physical, read_format(o.format)), o.output}};
  if (!o.profile.empty()) answers.push_back({profile_csv(profile(x), units_of(c)), o.profile});
  deliver(answers);
  conclude(x);
}

void run_temperature(const Options& o) {
  const std::vector<double> at = read_points(o.at);
  const Case c = read_case(o.of_case);
  const Solution x = solve(c.scene, c.approach, c.given);
  deliver({{curve_csv(temperature_curve(x, at, o.depth), units_of(c)), o.output}});
  conclude(x);
}

void run_figure_data(const Options& o) {
  if (o.list == !o.name.empty())
    throw std::invalid_argument("figure-data needs either a NAME or --list");
  const std::vector<std::string> names = figure_data_names();
  if (o.list) return deliver({{CLI::detail::join(names, "\n") + '\n', o.output}});
  if (std::find(names.begin(), names.end(), o.name) == names.end())
    throw std::invalid_argument("NAME = " + o.name + " is not allowed: it must be one of " +
                                CLI::detail::join(names, ", "));
  std::ostringstream out;
  write_figure_data(o.name, out);
  deliver({{out.str(), o.output}});
}

void run_claims(const Options& o) {
  deliver({{present(claims(), read_format(o.format)), o.output}});
}

constexpr const char* solve_examples = R"(Examples:
  thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --heating 0.0175
  thermoroll solve --friction 0.6 --creep 0.2 --peclet 100 --heating 1 --tolerance 1e-9 \
    --format json --profile profile.csv
  thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --method closed-form --format json
  thermoroll solve --friction 0.6 --traction 0.5 --load 1.2e7 --speed 22.2 --half-width 5.5e-3 \
    --shear-modulus 8.1e10 --poisson 0.3 --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50
  thermoroll solve --config wheel.toml --traction 0.4

The last reads the case from a file of lines such as "friction = 0.6" (TOML or INI).
Methods: coupled solves tractions and heat together, to the tolerance; closed-form leaves out what
the heat does to the tractions, and that is not counted in its errors; gauss-chebyshev is the
published scheme and has no error estimate.
Temperatures in degree C are rises above ambient.)";

constexpr const char* temperature_examples = R"(Examples:
  thermoroll temperature --friction 0.6 --traction 0.5 --peclet 1000 --at -1:3:401
  thermoroll temperature --friction 0.6 --traction 0.5 --peclet 100 --at 0,0.5,1 --depth 0.1
  thermoroll temperature --config wheel.toml --at -1:3:41 --output temperature.csv

The columns are s, temperature (T*), temperature_celsius (the rise above ambient, for data in SI
units) and error_estimate (of T*, absolute; empty for gauss-chebyshev).)";

constexpr const char* figure_data_examples = R"(Examples:
  thermoroll figure-data --list
  thermoroll figure-data traction --output traction.csv)";

constexpr const char* claims_examples = R"(Examples:
  thermoroll claims
  thermoroll claims --format csv --output claims.csv)";

constexpr const char* program_footer = R"(Examples:
  thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --heating 0.0175
  thermoroll temperature --friction 0.6 --traction 0.5 --peclet 1000 --at -1:3:401
  thermoroll solve --help

Exit status: 0 done; 1 failed (no solution found, not resolved, a file could not be written);
2 refused (options, numbers or files that make no sense); 3 an iteration did not converge.)";

void add_format(CLI::App& command, Options& o) {
  command.add_option("--format", o.format, "format of the result, text unless given")
      ->type_name("text|json|csv")
      ->check(one_of({"text", "json", "csv"}));
}

void add_output(CLI::App& command, Options& o) {
  command.add_option("--output", o.output, "write to this file, all or nothing")->type_name("FILE");
  command.add_flag("--verbose", o.verbose, "tell the time taken on standard error");
}

void add_solve(CLI::App& program, Options& o) {
  CLI::App& command = *program.add_subcommand("solve", "Solve one case and print the result");
  add_case_options(command, o.of_case);
  add_format(command, o);
  command.add_option("--profile", o.profile, "write s, p*, q*, v*, heat flux and T* to this file")
      ->type_name("FILE");
  add_output(command, o);
  command.footer(solve_examples);
  command.callback([&o] { run_solve(o); });
}

void add_temperature(CLI::App& program, Options& o) {
  CLI::App& command = *program.add_subcommand("temperature", "Print temperatures as CSV");
  add_case_options(command, o.of_case);
  command.add_option("--at", o.at, "s: A:B:N (N points from A to B), a list A,B,..., a number")
      ->type_name("POINTS")
      ->required();
  command.add_option("--depth", o.depth, "depth in units of a, 0 unless given")
      ->type_name("NUMBER")
      ->check(finite_number());
  add_output(command, o);
  command.footer(temperature_examples);
  command.callback([&o] { run_temperature(o); });
}

void add_figure_data(CLI::App& program, Options& o) {
  CLI::App& command =
      *program.add_subcommand("figure-data", "Write the data of a figure or table of the report");
  command.add_option("NAME", o.name, "which data")->type_name("");
  command.add_flag("--list", o.list, "print the names that there are, in place of data");
  add_output(command, o);
  command.footer(figure_data_examples);
  command.callback([&o] { run_figure_data(o); });
}

void add_claims(CLI::App& program, Options& o) {
  CLI::App& command =
      *program.add_subcommand("claims", "Print the paper's statements beside what was found");
  add_format(command, o);
  add_output(command, o);
  command.footer(claims_examples);
  command.callback([&o] { run_claims(o); });
}

void run(int argc, char** argv) {
  const auto start = std::chrono::steady_clock::now();
  Options solve, temperature, figure_data, claims;
  CLI::App program("Rolling contact of a cylinder with frictional heating", "thermoroll");
  program.set_version_flag("--version", "thermoroll " THERMOROLL_VERSION, "print the version");
  program.set_config("--config", "", "read a case from this file (TOML or INI)")->type_name("FILE");
  program.config_formatter(std::make_shared<CaseFile>(program));
  program.allow_config_extras(CLI::config_extras_mode::error);
  program.require_subcommand(1)->fallthrough();
  add_solve(program, solve);
  add_temperature(program, temperature);
  add_figure_data(program, figure_data);
  add_claims(program, claims);
  program.footer(program_footer);
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    deliver({{CLI::detail::find_and_replace(program.help(), "\n\n\n", "\n\n"), ""}});
  } catch (const CLI::CallForVersion& version) {
    deliver({{version.what() + std::string("\n"), ""}});
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(reworded(error, program.remaining(true)));
  }
  if (solve.verbose || temperature.verbose || figure_data.verbose || claims.verbose) {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    std::fprintf(stderr, "thermoroll: %.3g s\n", taken.count());
  }
}

/// One line on standard error, whatever the message holds.
int complain(const char* message, int status) {
  std::fputs("thermoroll: ", stderr);
  for (; *message != '\0'; ++message)
    std::fputc(std::iscntrl(static_cast<unsigned char>(*message)) ? ' ' : *message, stderr);
  std::fputc('\n', stderr);
  return status;
}

}  // namespace
}  // namespace thermoroll

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // so that a closed pipe is an error of writing, like a full disk
  try {
    thermoroll::run(argc, argv);
    return 0;
  } catch (const std::invalid_argument& error) {
    return thermoroll::complain(error.what(), 2);
  } catch (const thermoroll::NotConverged& error) {
    return thermoroll::complain(error.what(), 3);
  } catch (const std::exception& error) {
    return thermoroll::complain(error.what(), 1);
  }
}
