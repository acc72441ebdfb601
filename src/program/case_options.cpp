// Tangled from paper/B-command-line.md; edit there.
#include "program/case_options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "program/names.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

struct CaseOption {
  const char *name, *unit, *meaning;
  Maybe CaseOptions::*value;
};

constexpr CaseOption group_options[] = {
    {"--peclet", "NUMBER", "Peclet number Pe = V a / 2k", &CaseOptions::peclet},
    {"--heating", "NUMBER", "heating H = 2 alpha (1+nu) k P / (a K), 0 if not given",
     &CaseOptions::heating}};

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

constexpr CaseOption roller_group_options[] = {
    {"--conductivity-ratio", "NUMBER", "K2 / K1, the roller's conductivity over the half-space's",
     &CaseOptions::conductivity_ratio},
    {"--heating-2", "NUMBER", "heating H2 = 2 alpha2 (1+nu) k P / (a K2)",
     &CaseOptions::heating_2}};

constexpr CaseOption roller_si_options[] = {
    {"--conductivity-2", "W/(m K)", "or, in SI units, its conductivity",
     &CaseOptions::conductivity_2},
    {"--expansion-2", "1/K", "its thermal expansion", &CaseOptions::expansion_2}};

constexpr CaseOption roller_diffusivity[] = {{"--diffusivity-2", "m^2/s",
                                              "its diffusivity, equal to --diffusivity, as if not "
                                              "given",
                                              &CaseOptions::diffusivity_2}};

constexpr CaseOption given_options[] = {
    {"--traction", "NUMBER", "traction Q* = Q/P, between -f and f; negative for braking",
     &CaseOptions::traction},
    {"--creep", "NUMBER", "in place of it: creep xi* = mu a xi / (2 (1-nu) P), of the same sign",
     &CaseOptions::creep},
    {"--stick-slip-border", "NUMBER", "in place of it: border c0, between -1 and 1",
     &CaseOptions::border}};

void declare(CLI::App& command, CaseOptions& o, const CaseOption& option, const char* group) {
  command.add_option(option.name, o.*option.value, option.meaning)
      ->type_name(option.unit)
      ->check(finite_number(option.name + 2))
      ->group(group);
}

template <class T, std::size_t n>
void add_word(CLI::App& command, const std::string& name, std::string& word,
              const Name<T> (&names)[n], const char* meaning, const char* group) {
  command.add_option("--" + name, word, meaning)
      ->type_name(joined(words(names), "|"))
      ->check(one_of(name, words(names)))
      ->group(group);
}

void add_approach(CLI::App& command, CaseOptions& o) {
  add_word(command, "method", o.method, method_names,
           "auto unless given: the least model for the tolerance", "Method");
  const char* range = "1e-11 to 1e-2; 1e-6 unless given";
  declare(command, o, {"--tolerance", "NUMBER", range, &CaseOptions::tolerance}, "Method");
  command.add_option("--nodes", o.nodes, "of gauss-chebyshev, 3 to 5000; 200 unless given")
      ->type_name("NUMBER")
      ->check(whole_number("nodes"))
      ->group("Method");
  add_word(command, "formulation", o.formulation, formulation_names,
           "sign of the slope, corrected unless given", "Method");
}

void add_roller(CLI::App& command, CaseOptions& o) {
  add_word(command, "roller", o.roller, roller_names,
           "insulated unless given: all heat goes into the half-space", "Scene");
  add_word(command, "direction", o.direction, direction_names,
           "driving unless given, or as the sign of traction or creep says", "Scene");
}

Approach read_approach(const CaseOptions& o) {
  Approach a;
  a.method = value_of(method_names, o.method);
  a.formulation = value_of(formulation_names, o.formulation);
  a.nodes = o.nodes.value_or(a.nodes);
  a.tolerance = o.tolerance.value_or(a.tolerance);
  return a;
}

Prescribed read_given(const CaseOptions& o) {
  if (o.traction.has_value() + o.creep.has_value() + o.border.has_value() != 1)
    throw std::invalid_argument(
        "exactly one of --traction, --creep and --stick-slip-border is needed");
  if (o.traction) return {Quantity::traction, *o.traction};
  return o.creep ? Prescribed{Quantity::creep, *o.creep}
                 : Prescribed{Quantity::stick_slip_border, *o.border};
}

Direction read_direction(const CaseOptions& o, const Prescribed& given) {
  const bool has_sign = given.quantity != Quantity::stick_slip_border;
  if (o.direction.empty()) return Direction::driving;  // unless solve() finds a negative sign
  const Direction direction = value_of(direction_names, o.direction);
  if (has_sign && given.value * sign_of(direction) < 0)
    throw std::invalid_argument("--direction " + o.direction + " contradicts " +
                                (o.traction ? "--traction " : "--creep ") + shortest(given.value) +
                                ": it is positive for driving and negative for braking");
  return direction;
}

template <std::size_t n>
std::string those(const CaseOption (&options)[n], const CaseOptions& o, bool given) {
  std::string names;
  for (const CaseOption& option : options)
    if ((o.*option.value).has_value() == given) names += std::string(" ") + option.name;
  return names;
}

void check_roller(const CaseOptions& o, bool si) {
  const bool conducting = value_of(roller_names, o.roller) == RollerKind::conducting;
  const std::string groups = those(roller_group_options, o, true);
  const std::string in_si = those(roller_si_options, o, true) + those(roller_diffusivity, o, true);
  if (!conducting && !(groups + in_si).empty())
    throw std::invalid_argument("--roller " + o.roller + " has no data of its own; for" + groups +
                                in_si + " say --roller conducting");
  if (!conducting) return;
  if (si && !groups.empty()) throw std::invalid_argument("data in SI units exclude" + groups);
  if (!si && !in_si.empty())
    throw std::invalid_argument("--peclet and --heating exclude data in SI units; given:" + in_si);
  const std::string missing =
      si ? those(roller_si_options, o, false) : those(roller_group_options, o, false);
  if (!missing.empty()) throw std::invalid_argument("--roller conducting lacks" + missing);
  if (o.diffusivity_2)
    require(*o.diffusivity_2 == *o.diffusivity, "diffusivity-2", *o.diffusivity_2,
            "equal to --diffusivity: bodies of unlike diffusivities are not modelled");
}

Roller read_roller(const CaseOptions& o) {
  check_roller(o, false);
  const RollerKind kind = value_of(roller_names, o.roller);
  if (kind == RollerKind::insulated) return {};
  if (kind == RollerKind::identical) return {1, o.heating.value_or(0)};
  require(*o.conductivity_ratio > 0, "conductivity-ratio", *o.conductivity_ratio, "positive");
  return {*o.conductivity_ratio, *o.heating_2};
}

void read_roller(const CaseOptions& o, PhysicalScene& si) {
  check_roller(o, true);
  const RollerKind kind = value_of(roller_names, o.roller);
  if (kind == RollerKind::insulated) return;
  const bool alike = kind == RollerKind::identical;
  si.expansion_2 = alike ? si.expansion : *o.expansion_2;
  si.conductivity_2 = alike ? si.conductivity : *o.conductivity_2;
  require(alike || si.conductivity_2 > 0, "conductivity-2", si.conductivity_2, "positive");
}

/// A validator for the option of this name, with this condition and description of what is allowed.
template <class Condition>
CLI::Validator allow(const std::string& name, Condition condition, const std::string& allowed) {
  return {
      [=](const std::string& text) -> std::string {
        if (condition(text)) return "";
        throw std::invalid_argument(name + " = " + text + " is not allowed: it must be " + allowed);
      },
      ""};
}

/// The name of the first option of the program and the subcommand that is run, for which this
/// holds.
template <class Condition>
std::string first_option(const CLI::App& app, Condition holds) {
  std::vector<const CLI::App*> apps{&app};
  for (const CLI::App* command : app.get_subcommands()) apps.push_back(command);
  for (const CLI::App* one : apps)
    for (const CLI::Option* option : one->get_options())
      if (holds(*option)) return option->get_name();
  return "";
}

std::string or_else(const std::string& text, const std::string& other) {
  return text.empty() ? other : text;
}

}  // namespace

bool is_si_option(const std::string& name) {
  const auto is_in = [&](const auto& options) {
    return std::any_of(std::begin(options), std::end(options),
                       [&](const CaseOption& option) { return option.name == "--" + name; });
  };
  return is_in(si_options) || is_in(size_options) || is_in(roller_si_options) ||
         is_in(roller_diffusivity);
}

void add_case_options(CLI::App& command, CaseOptions& o) {
  const auto add = [&](const CaseOption& option, const char* group) {
    declare(command, o, option, group);
  };
  command.add_option("--friction", o.friction, "friction coefficient f, positive")
      ->type_name("NUMBER")
      ->check(finite_number("friction"))
      ->required()
      ->group("Scene");
  for (const CaseOption& option : given_options) add(option, "Scene");
  add_roller(command, o);
  for (const CaseOption& option : group_options) add(option, "Dimensionless scene");
  const char* si = "The same in SI units, all of them, in place of --peclet and --heating";
  for (const CaseOption& option : si_options) add(option, si);
  for (const CaseOption& option : size_options) add(option, si);
  const char* roller = "The roller's own data, for --roller conducting";
  for (const CaseOption& option : roller_group_options) add(option, roller);
  for (const CaseOption& option : roller_si_options) add(option, roller);
  for (const CaseOption& option : roller_diffusivity) add(option, roller);
  add_approach(command, o);
}

Case read_case(const CaseOptions& o) {
  const std::string given = those(si_options, o, true) + those(size_options, o, true);
  const std::string missing = those(si_options, o, false);
  const Approach approach = read_approach(o);
  const Prescribed x = read_given(o);
  const Direction direction = read_direction(o, x);
  if (given.empty()) {
    if (!o.peclet) throw std::invalid_argument("--peclet is missing (or data in SI units)");
    const Scene scene{o.friction, *o.peclet, o.heating.value_or(0), read_roller(o), direction};
    return {scene, x, approach, {}, {}};
  }
  if (o.peclet || o.heating)
    throw std::invalid_argument("--peclet and --heating exclude data in SI units; given:" + given);
  if (!missing.empty()) throw std::invalid_argument("data in SI units lack" + missing);
  if (o.half_width.has_value() == o.radius.has_value())
    throw std::invalid_argument("data in SI units need either --half-width or --radius");
  PhysicalScene si{*o.load,    *o.speed,     o.half_width.value_or(0), *o.shear_modulus,
                   *o.poisson, *o.expansion, *o.diffusivity,           *o.conductivity};
  read_roller(o, si);
  si.direction = direction;
  return {{o.friction, 0, 0}, x, approach, si, o.radius};
}

SolvedCase solve_case(const Case& c) {
  std::optional<PhysicalScene> physical = c.physical;
  Scene scene = c.scene;
  if (c.radius)
    physical->half_width =
        half_width_of_radius(*physical, *c.radius, scene.friction, c.given, c.approach);
  if (physical) {
    check(*physical);
    scene = scene_of(*physical, scene.friction);
  }
  const Solution x = solve(scene, c.given, c.approach);
  if (!physical) return {x, {}, {}};
  return {x, units_of(*physical, scene.friction), in_si_units(x, *physical, c.radius.has_value())};
}

CLI::Validator finite_number(const std::string& name) {
  return allow(
      name, [](const std::string& text) { return to_number(text).has_value(); }, "a finite number");
}

CLI::Validator whole_number(const std::string& name) {
  const auto is_whole = [](const std::string& text) {
    int n = 0;
    std::from_chars(text.data(), text.data() + text.size(), n);
    return std::to_string(n) == text;
  };
  return allow(name, is_whole, "a whole number");
}

CLI::Validator one_of(const std::string& name, const std::vector<std::string>& words) {
  const auto known = [=](const std::string& text) {
    return std::find(words.begin(), words.end(), text) != words.end();
  };
  return allow(name, known, joined(words, " or "));
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::optional<double> to_number(const std::string& text) {
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !std::isfinite(x)) return std::nullopt;
  return x;
}

std::string reworded(const CLI::ParseError& error, const CLI::App& app) {
  const std::vector<std::string> unclaimed = app.remaining(true);
  if (!unclaimed.empty()) return "unexpected " + unclaimed.front() + " (see --help)";
  const std::string text = error.what();
  const auto is_named = [&](const CLI::Option& x) { return text.find(x.get_name()) == 0; };
  const auto is_missing = [](const CLI::Option& x) { return x.get_required() && x.count() == 0; };
  const auto kind = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (kind == CLI::ExitCodes::ArgumentMismatch)
    return or_else(first_option(app, is_named), "an option") + " needs exactly one value";
  if (kind == CLI::ExitCodes::RequiredError)
    return or_else(first_option(app, is_missing), "A subcommand") + " is required (see --help)";
  return text + " (see --help)";
}

}  // namespace thermoroll
