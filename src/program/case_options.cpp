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

constexpr CaseOption given_options[] = {
    {"--traction", "NUMBER", "traction Q* = Q/P, above 0 and below f", &CaseOptions::traction},
    {"--creep", "NUMBER", "in place of it: creep xi* = mu a xi / (2 (1-nu) P), positive",
     &CaseOptions::creep},
    {"--stick-slip-border", "NUMBER", "in place of it: border c0, between -1 and 1",
     &CaseOptions::border}};

void declare(CLI::App& command, CaseOptions& o, const CaseOption& option, const char* group) {
  command.add_option(option.name, o.*option.value, option.meaning)
      ->type_name(option.unit)
      ->check(finite_number(option.name + 2))
      ->group(group);
}

void add_approach(CLI::App& command, CaseOptions& o) {
  const auto methods = words(method_names), formulations = words(formulation_names);
  command.add_option("--method", o.method, "auto unless given: the least model for the tolerance")
      ->type_name(joined(methods, "|"))
      ->check(one_of("method", methods))
      ->group("Method");
  const char* range = "1e-11 to 1e-2; 1e-6 unless given";
  declare(command, o, {"--tolerance", "NUMBER", range, &CaseOptions::tolerance}, "Method");
  command.add_option("--nodes", o.nodes, "of gauss-chebyshev, 3 to 5000; 200 unless given")
      ->type_name("NUMBER")
      ->check(whole_number("nodes"))
      ->group("Method");
  command.add_option("--formulation", o.formulation, "sign of the slope, corrected unless given")
      ->type_name(joined(formulations, "|"))
      ->check(one_of("formulation", formulations))
      ->group("Method");
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
  const auto same = [&](const CaseOption& option) { return option.name == "--" + name; };
  return std::any_of(std::begin(si_options), std::end(si_options), same) ||
         std::any_of(std::begin(size_options), std::end(size_options), same);
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
  for (const CaseOption& option : group_options) add(option, "Dimensionless scene");
  const char* si = "The same in SI units, all of them, in place of --peclet and --heating";
  for (const CaseOption& option : si_options) add(option, si);
  for (const CaseOption& option : size_options) add(option, si);
  add_approach(command, o);
}

Case read_case(const CaseOptions& o) {
  std::string given, missing;
  for (const CaseOption& option : si_options)
    (o.*option.value ? given : missing) += std::string(" ") + option.name;
  for (const CaseOption& option : size_options)
    if (o.*option.value) given += std::string(" ") + option.name;
  const Approach approach = read_approach(o);
  const Prescribed x = read_given(o);
  if (given.empty()) {
    if (!o.peclet) throw std::invalid_argument("--peclet is missing (or data in SI units)");
    return {{o.friction, *o.peclet, o.heating.value_or(0)}, x, approach, {}, {}};
  }
  if (o.peclet || o.heating)
    throw std::invalid_argument("--peclet and --heating exclude data in SI units; given:" + given);
  if (!missing.empty()) throw std::invalid_argument("data in SI units lack" + missing);
  if (o.half_width.has_value() == o.radius.has_value())
    throw std::invalid_argument("data in SI units need either --half-width or --radius");
  const PhysicalScene si{*o.load,    *o.speed,     o.half_width.value_or(0), *o.shear_modulus,
                         *o.poisson, *o.expansion, *o.diffusivity,           *o.conductivity};
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
