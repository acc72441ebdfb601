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
  double friction = 0, traction = 0;
  Maybe peclet, heating;
  Maybe load, speed, shear_modulus, poisson, expansion, diffusivity, conductivity;
  Maybe half_width, radius;
  std::string method, formulation = "printed";
  int nodes = 200;
};

struct SiOption {
  const char *name, *unit, *meaning;
  Maybe CaseOptions::*value;
};

constexpr SiOption si_options[] = {
    {"--load", "N/m", "load per unit length P", &CaseOptions::load},
    {"--speed", "m/s", "rolling speed V", &CaseOptions::speed},
    {"--shear-modulus", "Pa", "shear modulus mu of both bodies", &CaseOptions::shear_modulus},
    {"--poisson", "NUMBER", "Poisson ratio nu of both bodies", &CaseOptions::poisson},
    {"--expansion", "1/K", "thermal expansion alpha", &CaseOptions::expansion},
    {"--diffusivity", "m^2/s", "thermal diffusivity k", &CaseOptions::diffusivity},
    {"--conductivity", "W/(m K)", "thermal conductivity K", &CaseOptions::conductivity}};

constexpr SiOption size_options[] = {
    {"--half-width", "m", "half-width a of the contact", &CaseOptions::half_width},
    {"--radius", "m", "radius R of the cylinder, in place of the half-width",
     &CaseOptions::radius}};

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
  const auto add = [&](const SiOption& option, const char* group) {
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
  command.add_option("--traction", o.traction, "traction Q* = Q/P, above 0 and below f")
      ->type_name("NUMBER")
      ->check(finite_number())
      ->required()
      ->group("Case");
  add({"--peclet", "NUMBER", "Peclet number Pe = V a / 2k", &CaseOptions::peclet}, groups);
  add({"--heating", "NUMBER", "heating H = 2 alpha (1+nu) k P / (a K), 0 if not given",
       &CaseOptions::heating},
      groups);
  const char* si = "The same in SI units, all of them, in place of --peclet and --heating";
  for (const SiOption& option : si_options) add(option, si);
  for (const SiOption& option : size_options) add(option, si);
  command.add_option("--method", o.method, o.method + " unless given")
      ->type_name("closed-form|gauss-chebyshev")
      ->check(one_of({"closed-form", "gauss-chebyshev"}))
      ->group("Method");
  command.add_option("--nodes", o.nodes, "of gauss-chebyshev, 3 to 5000; 200 unless given")
      ->type_name("NUMBER")
      ->check(whole_number())
      ->group("Method");
  command.add_option("--formulation", o.formulation, "sign of thermal slope, printed unless given")
      ->type_name("printed|corrected")
      ->check(one_of({"printed", "corrected"}))
      ->group("Method");
}

struct Case {
  Scene scene;
  Approach approach;
  std::optional<PhysicalCase> physical;
};

Approach read_approach(const CaseOptions& o) {
  return {o.method == "closed-form" ? Method::closed_form : Method::gauss_chebyshev,
          o.formulation == "printed" ? Formulation::printed : Formulation::corrected, o.nodes};
}

Case read_case(const CaseOptions& o) {
  std::string given, missing;
  for (const SiOption& option : si_options)
    (o.*option.value ? given : missing) += std::string(" ") + option.name;
  for (const SiOption& option : size_options)
    if (o.*option.value) given += std::string(" ") + option.name;
  const Approach approach = read_approach(o);
  if (given.empty()) {
    if (!o.peclet) throw std::invalid_argument("--peclet is missing (or data in SI units)");
    return {{o.friction, o.traction, *o.peclet, o.heating.value_or(0)}, approach, {}};
  }
  if (o.peclet || o.heating)
    throw std::invalid_argument("--peclet and --heating exclude data in SI units; given:" + given);
  if (!missing.empty()) throw std::invalid_argument("data in SI units lack" + missing);
  if (o.half_width.has_value() == o.radius.has_value())
    throw std::invalid_argument("data in SI units need either --half-width or --radius");
  PhysicalCase c{*o.load,    *o.speed,     o.half_width.value_or(0), *o.shear_modulus,
                 *o.poisson, *o.expansion, *o.diffusivity,           *o.conductivity};
  if (o.radius) c.half_width = half_width_of_radius(c, *o.radius, o.friction, o.traction, approach);
  check(c);
  return {scene_of(c, o.friction, o.traction), approach, c};
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
  std::string at, name, format = "text", output;
  double depth = 0;
  bool list = false, verbose = false;
};

Format read_format(const std::string& name) {
  return name == "json" ? Format::json : name == "csv" ? Format::csv : Format::text;
}

constexpr const char* last_iterate =
    "the iteration did not converge; what is written is its last iterate";

void run_solve(const Options& o) {
  const Case c = read_case(o.of_case);
  const Solution x = solve(c.scene, c.approach);
  std::optional<PhysicalResults> physical;
  if (c.physical) physical = in_si_units(x, *c.physical);
  deliver(present(x, physical, read_format(o.format)), o.output);
  if (!x.converged) throw NotConverged(last_iterate);
}

void run_temperature(const Options& o) {
  const std::vector<double> at = read_points(o.at);
  const Case c = read_case(o.of_case);
  const Curve curve = temperature_curve(c.scene, c.approach, at, o.depth);
  std::optional<Units> units;
  if (c.physical) units = units_of(*c.physical, c.scene.friction);
  deliver(curve_csv(curve, units), o.output);
  if (!curve.converged) throw NotConverged(last_iterate);
}

void run_figure_data(const Options& o) {
  if (o.list == !o.name.empty())
    throw std::invalid_argument("figure-data needs either a NAME or --list");
  const std::vector<std::string> names = figure_data_names();
  if (o.list) return deliver(CLI::detail::join(names, "\n") + '\n', o.output);
  if (std::find(names.begin(), names.end(), o.name) == names.end())
    throw std::invalid_argument("NAME = " + o.name + " is not allowed: it must be one of " +
                                CLI::detail::join(names, ", "));
  std::ostringstream out;
  write_figure_data(o.name, out);
  deliver(out.str(), o.output);
}

void run_claims(const Options& o) { deliver(present(claims(), read_format(o.format)), o.output); }

constexpr const char* solve_examples = R"(Examples:
  thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --heating 0.0175
  thermoroll solve --friction 0.6 --traction 0.5 --peclet 4360 --method closed-form --format json
  thermoroll solve --friction 0.6 --traction 0.5 --load 1.2e7 --speed 22.2 --half-width 5.5e-3 \
    --shear-modulus 8.1e10 --poisson 0.3 --expansion 1.1e-5 --diffusivity 1.4e-5 --conductivity 50
  thermoroll solve --config wheel.toml --traction 0.4

The last reads the case from a file of lines such as "friction = 0.6" (TOML or INI).
The errors that the closed form gives are those of its evaluation; what it leaves out, the effect
of the heat on the tractions, is not counted. The scheme has no error estimate.)";

constexpr const char* temperature_examples = R"(Examples:
  thermoroll temperature --friction 0.6 --traction 0.5 --peclet 1000 --at -1:3:401
  thermoroll temperature --friction 0.6 --traction 0.5 --peclet 100 --at 0,0.5,1 --depth 0.1
  thermoroll temperature --config wheel.toml --at -1:3:41 --output temperature.csv

The columns are s, temperature (T*), temperature_celsius (for data in SI units) and error_estimate
(of T*, absolute; empty for the scheme).)";

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

Exit status: 0 done; 1 failed (a file could not be written, an integral was not resolved);
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
  o.of_case.method = "gauss-chebyshev";
  add_case_options(command, o.of_case);
  add_format(command, o);
  add_output(command, o);
  command.footer(solve_examples);
  command.callback([&o] { run_solve(o); });
}

void add_temperature(CLI::App& program, Options& o) {
  CLI::App& command = *program.add_subcommand("temperature", "Print temperatures as CSV");
  o.of_case.method = "closed-form";
  add_case_options(command, o.of_case);
  command.add_option("--at", o.at, "s: A:B:N (N points from A to B), a list A,B,..., a number")
      ->type_name("POINTS")
      ->required();
  command.add_option("--depth", o.depth, "depth in units of a, 0 unless given; closed form only")
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
    deliver(CLI::detail::find_and_replace(program.help(), "\n\n\n", "\n\n"), "");
  } catch (const CLI::CallForVersion& version) {
    deliver(version.what() + std::string("\n"), "");
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
