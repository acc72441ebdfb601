// Tangled from paper/B-command-line.md; edit there.
#include "program/scene_options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "program/names.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

struct SceneOption {
  const char *name, *unit, *meaning;
  Maybe SceneOptions::*value;
};

constexpr SceneOption group_options[] = {
    {"--peclet", "NUMBER", "Peclet number Pe = V a / 2k", &SceneOptions::peclet},
    {"--heating", "NUMBER", "heating H = 2 alpha (1+nu) k P / (a K), 0 if not given",
     &SceneOptions::heating}};

constexpr SceneOption si_options[] = {
    {"--load", "N/m",
     "load per unit length P = pi a p0 / 2: of a wheel its load by the contact width, 3/2 of that "
     "in the middle",
     &SceneOptions::load},
    {"--speed", "m/s", "rolling speed V: if they differ much, the mean of both surfaces' speeds",
     &SceneOptions::speed},
    {"--shear-modulus", "Pa",
     "shear modulus mu of both bodies (of two moduli the harmonic mean, without their coupling)",
     &SceneOptions::shear_modulus},
    {"--poisson", "NUMBER", "Poisson ratio nu of both bodies", &SceneOptions::poisson},
    {"--expansion", "1/K", "thermal expansion alpha", &SceneOptions::expansion},
    {"--diffusivity", "m^2/s", "thermal diffusivity k", &SceneOptions::diffusivity},
    {"--conductivity", "W/(m K)", "thermal conductivity K", &SceneOptions::conductivity}};

constexpr SceneOption size_options[] = {
    {"--half-width", "m", "half-width a of the contact", &SceneOptions::half_width},
    {"--radius", "m",
     "radius R of the cylinder, or R1 R2 / (R1 + R2) of two: half-width follows, with kappa, for "
     "this load",
     &SceneOptions::radius}};

constexpr SceneOption roller_group_options[] = {
    {"--conductivity-ratio", "NUMBER", "K2 / K1, the roller's conductivity over the half-space's",
     &SceneOptions::conductivity_ratio},
    {"--heating-2", "NUMBER", "heating H2 = 2 alpha2 (1+nu) k2 P / (a K2)",
     &SceneOptions::heating_2}};

constexpr SceneOption roller_si_options[] = {
    {"--conductivity-2", "W/(m K)", "or, in SI units, its conductivity",
     &SceneOptions::conductivity_2},
    {"--expansion-2", "1/K", "its thermal expansion", &SceneOptions::expansion_2}};

constexpr SceneOption roller_peclet[] = {
    {"--peclet-2", "NUMBER", "its Peclet number Pe2 = V a / 2 k2, --peclet if not given",
     &SceneOptions::peclet_2}};

constexpr SceneOption roller_diffusivity[] = {{"--diffusivity-2", "m^2/s",
                                               "its diffusivity, --diffusivity if not given",
                                               &SceneOptions::diffusivity_2}};

constexpr SceneOption law_options[] = {
    {"--friction-temperature", "NUMBER",
     "T0*, the scale of the law, or in K with SI data; for linear below 0 where friction rises",
     &SceneOptions::friction_temperature},
    {"--friction-floor", "NUMBER",
     "least friction as a fraction of f, 0 unless given (piecewise-linear: where the slope ends)",
     &SceneOptions::friction_floor},
    {"--friction-reference-temperature", "NUMBER",
     "friction is f up to it: T* above the half-space's bulk temperature, degree C in SI; that "
     "bulk unless given",
     &SceneOptions::friction_reference_temperature}};

constexpr SceneOption bulk_options[] = {
    {"--bulk-temperature", "degree C",
     "with SI data: that of both bodies far away; none is assumed",
     &SceneOptions::bulk_temperature},
    {"--bulk-temperature-2", "degree C", "the roller's, if it is another",
     &SceneOptions::bulk_temperature_2}};

constexpr SceneOption bulk_group_options[] = {
    {"--bulk-difference", "NUMBER",
     "Theta, by how much the roller is warmer far away, in units of T*",
     &SceneOptions::bulk_difference}};

constexpr SceneOption given_options[] = {
    {"--traction", "NUMBER",
     "traction Q* = Q/P, between -f and f unless friction rises; negative for braking",
     &SceneOptions::traction},
    {"--creep", "NUMBER", "in place of it: creep xi* = mu a xi / (2 (1-nu) P), of the same sign",
     &SceneOptions::creep},
    {"--stick-slip-border", "NUMBER", "in place of it: border c0, above -1 and below 1",
     &SceneOptions::border},
    {"--creep-ratio", "NUMBER", "in place of it, with SI data: creep xi as a fraction of the speed",
     &SceneOptions::creep_ratio},
    {"--tangential-load", "N/m", "in place of it, with SI data: load Q = Q* P",
     &SceneOptions::tangential_load}};

template <std::size_t n>
bool is_in(const SceneOption (&options)[n], const std::string& name) {
  return std::any_of(std::begin(options), std::end(options),
                     [&](const SceneOption& option) { return option.name == "--" + name; });
}

template <std::size_t n>
std::vector<std::string> names_of(const SceneOption (&options)[n]) {
  std::vector<std::string> names;
  for (const SceneOption& option : options) names.emplace_back(option.name + 2);
  return names;
}

void declare(CLI::App& command, SceneOptions& o, const SceneOption& option, const char* group) {
  add_number(command, option.name + 2, o.*option.value, option.meaning, option.unit)->group(group);
}

template <class T, std::size_t n>
void take_word(CLI::Option* option, const Name<T> (&names)[n], const char* group) {
  option->type_name(joined(words(names), "|"))
      ->check(one_of(option->get_name().substr(2), words(names)))
      ->group(group);
}

template <class T, std::size_t n>
void add_word(CLI::App& command, const std::string& name, std::string& word,
              const Name<T> (&names)[n], const char* meaning, const char* group) {
  take_word(command.add_option("--" + name, word, meaning), names, group);
}

template <class T, std::size_t n>
void add_word(CLI::App& command, const std::string& name, T& value, const Name<T> (&names)[n],
              const char* meaning, const char* group) {
  const auto store = [&](const std::string& word) { value = value_of(names, word); };
  take_word(command.add_option_function<std::string>("--" + name, store, meaning), names, group);
}

void add_approach(CLI::App& command, SceneOptions& o) {
  add_word(command, "method", o.approach.method, method_names,
           "auto unless given: the least model for the tolerance", "Method");
  const char* range = "1e-11 to 1e-2; 1e-6 unless given";
  declare(command, o, {"--tolerance", "NUMBER", range, &SceneOptions::tolerance}, "Method");
  command.add_option("--nodes", o.nodes, "of gauss-chebyshev, 3 to 5000; 200 unless given")
      ->type_name("NUMBER")
      ->check(whole_number("nodes"))
      ->group("Method");
  add_word(command, "formulation", o.approach.formulation, formulation_names,
           "sign of the slope, corrected unless given", "Method");
}

void add_roller(CLI::App& command, SceneOptions& o) {
  add_word(command, "roller", o.roller, roller_names,
           "insulated unless given: all heat goes into the half-space", "Scene");
  add_word(command, "direction", o.direction, direction_names,
           "driving unless given, or as the sign of traction or creep says", "Scene");
}

void add_law(CLI::App& command, SceneOptions& o) {
  const char* group = "Friction that depends on temperature (formulas: solve --help)";
  add_word(command, "friction-law", o.friction_law, law_names, "constant unless given", group);
  for (const SceneOption& option : law_options) declare(command, o, option, group);
  for (const SceneOption& option : bulk_options) declare(command, o, option, group);
  for (const SceneOption& option : bulk_group_options) declare(command, o, option, group);
  add_word(command, "branch", o.branch, branch_names,
           "of the two solutions at one traction, rising unless given", group);
}

Approach read_approach(const SceneOptions& o) {
  Approach a = o.approach;
  a.nodes = o.nodes.value_or(a.nodes);
  a.tolerance = o.tolerance.value_or(a.tolerance);
  return a;
}

const SceneOption& given_option(const SceneOptions& o) {
  const auto is_given = [&](const SceneOption& option) { return (o.*option.value).has_value(); };
  const auto any = [&](const auto& options) {
    return std::any_of(std::begin(options), std::end(options), is_given);
  };
  const bool si = o.creep_ratio || o.tangential_load || any(si_options) || any(size_options);
  if (std::count_if(std::begin(given_options), std::end(given_options), is_given) != 1)
    throw std::invalid_argument(
        si ? "exactly one of --traction, --creep, --stick-slip-border, --creep-ratio and "
             "--tangential-load is needed"
           : "exactly one of --traction, --creep and --stick-slip-border is needed");
  return *std::find_if(std::begin(given_options), std::end(given_options), is_given);
}

Prescribed read_given(const SceneOptions& o) {
  const double value = *(o.*given_option(o).value);
  const Branch branch = o.branch.empty() ? Branch::rising : value_of(branch_names, o.branch);
  if (o.traction) return {Quantity::traction, value, branch};
  if (o.tangential_load) return {Quantity::traction, value / o.load.value_or(1), branch};
  return {o.border ? Quantity::stick_slip_border : Quantity::creep, value};
}

void check_given_in_si(const SceneOptions& o, bool si) {
  if (!si && (o.creep_ratio || o.tangential_load))
    throw std::invalid_argument(std::string("for data in SI units only: ") + given_option(o).name);
  const double most = o.friction.value_or(0) * o.load.value_or(0);
  if (!o.tangential_load || !(most > 0) || value_of(law_names, o.friction_law)) return;
  require(std::abs(*o.tangential_load) <= most, "tangential-load", *o.tangential_load,
          "between -" + shortest(most) + " and " + shortest(most) + " N/m, friction times load");
}

Direction read_direction(const SceneOptions& o, const Prescribed& given) {
  const bool has_sign = given.quantity != Quantity::stick_slip_border;
  if (o.direction.empty()) return Direction::driving;  // unless solve() finds a negative sign
  const Direction direction = value_of(direction_names, o.direction);
  const SceneOption& option = given_option(o);
  if (has_sign && two_bulks(o))
    throw std::invalid_argument(
        std::string("--direction is for a given border where bulk temperatures differ: with ") +
        option.name + " it follows from the state without slip");
  if (has_sign && given.value * sign_of(direction) < 0)
    throw std::invalid_argument("--direction " + o.direction + " contradicts " + option.name + ' ' +
                                shortest(*(o.*option.value)) +
                                ": it is positive for driving and negative for braking");
  return direction;
}

template <std::size_t n>
std::string those(const SceneOption (&options)[n], const SceneOptions& o, bool given) {
  std::string names;
  for (const SceneOption& option : options)
    if ((o.*option.value).has_value() == given) names += std::string(" ") + option.name;
  return names;
}

void check_roller(const SceneOptions& o, bool si) {
  const bool conducting = value_of(roller_names, o.roller) == RollerKind::conducting;
  const std::string groups = those(roller_group_options, o, true) + those(roller_peclet, o, true);
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
}

Roller read_roller(const SceneOptions& o) {
  check_roller(o, false);
  const RollerKind kind = value_of(roller_names, o.roller);
  if (kind == RollerKind::insulated) return {};
  if (kind == RollerKind::identical) return {1, o.heating.value_or(0)};
  require(*o.conductivity_ratio > 0, "conductivity-ratio", *o.conductivity_ratio, "positive");
  const double speed = o.peclet_2.value_or(*o.peclet);
  require(speed > 0, o.peclet_2 ? "peclet-2" : "peclet", speed, "positive");
  return {*o.conductivity_ratio, *o.heating_2, speed == *o.peclet ? 0 : speed};
}

void read_roller(const SceneOptions& o, PhysicalScene& si) {
  check_roller(o, true);
  const RollerKind kind = value_of(roller_names, o.roller);
  if (kind == RollerKind::insulated) return;
  const bool alike = kind == RollerKind::identical;
  si.expansion_2 = alike ? si.expansion : *o.expansion_2;
  si.conductivity_2 = alike ? si.conductivity : *o.conductivity_2;
  require(alike || si.conductivity_2 > 0, "conductivity-2", si.conductivity_2, "positive");
  si.diffusivity_2 = o.diffusivity_2.value_or(si.diffusivity);
  require(si.diffusivity_2 > 0, "diffusivity-2", si.diffusivity_2, "positive");
}

std::string range_without_law(const SceneOptions& o) {
  const std::string f = shortest(o.friction.value_or(0));
  return o.friction.value_or(0) > 0 ? "; the traction is between -" + f + " and " + f : "";
}

void check_law_options(const SceneOptions& o, bool si) {
  const std::string branch = o.branch.empty() ? "" : " --branch";
  const std::string data = those(law_options, o, true) + branch;
  const bool constant = !value_of(law_names, o.friction_law);
  if (constant && !data.empty())
    throw std::invalid_argument("constant friction has none of these:" + data +
                                "; a --friction-law that is not constant is needed" +
                                (branch.empty() ? "" : range_without_law(o)));
  if (!constant && !o.friction_temperature)
    throw std::invalid_argument("--friction-law " + o.friction_law +
                                " lacks --friction-temperature");
  if (!branch.empty() && !o.traction && !o.tangential_load)
    throw std::invalid_argument("--branch is for a given traction only");
  if (const std::string bulk = those(bulk_options, o, true); !si && !bulk.empty())
    throw std::invalid_argument("for data in SI units only:" + bulk);
  if (si && o.bulk_difference)
    throw std::invalid_argument("data in SI units exclude --bulk-difference");
  if (o.bulk_temperature_2 && !o.bulk_temperature)
    throw std::invalid_argument("--bulk-temperature-2 needs --bulk-temperature");
  if (si && two_bulks(o) && value_of(roller_names, o.roller) == RollerKind::insulated)
    throw std::invalid_argument("--bulk-temperature-2 needs a --roller that conducts heat");
  if (si && o.friction_reference_temperature && !o.bulk_temperature)
    throw std::invalid_argument(
        "--friction-reference-temperature in degree C needs --bulk-temperature");
}

std::optional<LawOfFriction> read_law(const SceneOptions& o, bool si) {
  check_law_options(o, si);
  const std::optional<LawKind> kind = value_of(law_names, o.friction_law);
  if (!kind) return std::nullopt;
  LawOfFriction law{*kind, {*o.friction_temperature, o.friction_floor.value_or(0)}};
  if (o.friction_reference_temperature)
    law.of.reference = *o.friction_reference_temperature - (si ? *o.bulk_temperature : 0);
  return law;
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

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      d[i][j] = i + j;
      if (i == 0 || j == 0) continue;
      const std::size_t other = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + other});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d.back().back();
}

/// The options of the program and of the subcommand that is run.
std::vector<const CLI::Option*> all_options(const CLI::App& app) {
  std::vector<const CLI::Option*> all = app.get_options();
  for (const CLI::App* command : app.get_subcommands())
    for (const CLI::Option* option : command->get_options()) all.push_back(option);
  return all;
}

/// The first of them for which this holds; null if there is none.
template <class Condition>
const CLI::Option* first_option(const CLI::App& app, Condition holds) {
  for (const CLI::Option* option : all_options(app))
    if (holds(*option)) return option;
  return nullptr;
}

std::string name_or(const CLI::Option* option, const std::string& other) {
  return option == nullptr ? other : option->get_name();
}

std::string meant(const std::string& word, const CLI::App& app) {
  std::vector<std::string> names;
  if (word.find("--") == 0)
    for (const CLI::Option* option : all_options(app)) names.push_back(option->get_name());
  else if (app.get_subcommands().empty())
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  const std::string own = word.substr(0, word.find('=')), name = nearest(own, names);
  if (!own.empty() && name == own) return " (options stand after the command and before any --)";
  const bool of_a_scene = std::find(names.begin(), names.end(), "--half-width") != names.end();
  const std::string place = instead_of(own);
  if (of_a_scene && !place.empty()) return " (" + place + ")";
  return name.empty() ? " (see --help)" : " (did you mean " + name + "?)";
}

}  // namespace

bool is_si_option(const std::string& name) {
  return is_in(si_options, name) || is_in(size_options, name) || is_in(roller_si_options, name) ||
         is_in(roller_diffusivity, name) || is_in(bulk_options, name) || name == "creep-ratio" ||
         name == "tangential-load";
}

bool is_group_option(const std::string& name) {
  return is_in(group_options, name) || is_in(roller_group_options, name) ||
         is_in(roller_peclet, name) || is_in(bulk_group_options, name);
}

bool is_roller_option(const std::string& name) {
  return is_in(roller_group_options, name) || is_in(roller_peclet, name) ||
         is_in(roller_si_options, name) || is_in(roller_diffusivity, name);
}

bool is_given_option(const std::string& name) { return is_in(given_options, name); }

bool exclude_each_other(const std::string& a, const std::string& b) {
  const auto both = [&](const auto& options) { return is_in(options, a) && is_in(options, b); };
  return a != b && (both(given_options) || both(size_options));
}

std::vector<std::string> data_in_si_units() { return names_of(si_options); }

std::vector<std::string> given_names() { return names_of(given_options); }

std::string unit_of_option(const std::string& name) {
  SceneOptions none;
  CLI::App scene;
  add_scene_options(scene, none);
  const CLI::Option* option = name.empty() ? nullptr : scene.get_option_no_throw("--" + name);
  const std::string unit = option == nullptr ? "" : option->get_type_name();
  return unit == "NUMBER" ? "1" : unit;
}

void add_scene_options(CLI::App& command, SceneOptions& o) {
  const auto add = [&](const SceneOption& option, const char* group) {
    declare(command, o, option, group);
  };
  add_number(command, "friction", o.friction, "friction coefficient f, positive")
      ->required()
      ->group("Scene");
  for (const SceneOption& option : given_options) add(option, "Scene");
  add_roller(command, o);
  for (const SceneOption& option : group_options) add(option, "Dimensionless scene");
  const char* si = "The same in SI units, all of them, in place of --peclet and --heating";
  for (const SceneOption& option : si_options) add(option, si);
  for (const SceneOption& option : size_options) add(option, si);
  add_law(command, o);
  const char* roller = "The roller's own data, for --roller conducting";
  for (const SceneOption& option : roller_group_options) add(option, roller);
  for (const SceneOption& option : roller_si_options) add(option, roller);
  for (const SceneOption& option : roller_peclet) add(option, roller);
  for (const SceneOption& option : roller_diffusivity) add(option, roller);
  add_approach(command, o);
}

GivenScene read_scene(const SceneOptions& o) {
  const std::string given = those(si_options, o, true) + those(size_options, o, true);
  const std::string missing = those(si_options, o, false);
  const Approach approach = read_approach(o);
  const Prescribed x = read_given(o);
  check_given_in_si(o, !given.empty());
  const Direction direction = read_direction(o, x);
  const std::optional<LawOfFriction> law = read_law(o, !given.empty());
  if (given.empty()) {
    if (!o.peclet) throw std::invalid_argument("--peclet is missing (or data in SI units)");
    Scene scene{o.friction.value_or(0), *o.peclet, o.heating.value_or(0), read_roller(o),
                direction};
    if (law) scene.law = *law;
    scene.bulk_difference = o.bulk_difference.value_or(0);
    return {scene, x, approach, {}, {}};
  }
  if (o.peclet || o.heating)
    throw std::invalid_argument("--peclet and --heating exclude data in SI units; given:" + given);
  if (!missing.empty()) throw std::invalid_argument("data in SI units lack" + missing);
  if (o.half_width.has_value() == o.radius.has_value())
    throw std::invalid_argument("data in SI units need either --half-width or --radius" +
                                std::string(o.radius ? ", not both" : ""));
  PhysicalScene si{*o.load,    *o.speed,     o.half_width.value_or(0), *o.shear_modulus,
                   *o.poisson, *o.expansion, *o.diffusivity,           *o.conductivity};
  read_roller(o, si);
  si.direction = direction;
  si.bulk_temperature = o.bulk_temperature;
  si.bulk_temperature_2 = o.bulk_temperature_2;
  si.law = law;
  GivenScene scene{{o.friction.value_or(0), 0, 0}, x, approach, si, o.radius};
  const SceneOption& option = given_option(o);
  if (o.creep_ratio) scene.unit = CreepUnit::ratio;
  if (o.creep_ratio || o.tangential_load)
    scene.as_given = std::string(option.name + 2) + " = " + shortest(*(o.*option.value));
  if (o.tangential_load) scene.as_given += " over load = " + shortest(*o.load);
  return scene;
}

CLI::Option* add_number(CLI::App& command, const std::string& name, Maybe& value,
                        const std::string& meaning, const std::string& unit) {
  const auto store = [&value](const std::string& text) { value = to_number(text); };
  return command.add_option_function<std::string>("--" + name, store, meaning)
      ->type_name(unit)
      ->check(finite_number(name, unit));
}

CLI::Validator finite_number(const std::string& name, const std::string& unit) {
  const auto is_number = [](const std::string& text) { return to_number(text).has_value(); };
  return allow(name, is_number, "a finite number" + (unit == "NUMBER" ? "" : " in " + unit));
}

CLI::Validator not_empty(const std::string& name, const std::string& allowed) {
  return allow(
      name, [](const std::string& text) { return !text.empty(); }, allowed);
}

CLI::Validator file_name(const std::string& name) { return not_empty(name, "the name of a file"); }

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

std::string hyphenated(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::optional<double> to_number(const std::string& text) {
  const bool plus = text.rfind('+', 0) == 0 && text.rfind("+-", 0) != 0;
  const char *begin = text.data() + plus, *end = text.data() + text.size();
  double x = 0;
  const auto [behind, failed] = std::from_chars(begin, end, x);
  if (failed != std::errc() || behind != end || !std::isfinite(x)) return std::nullopt;
  return x;
}

std::string nearest(const std::string& word, const std::vector<std::string>& names) {
  std::string found;
  std::size_t most = word.size() < 3 ? 0 : std::max<std::size_t>(1, word.size() / 5);
  for (const std::string& name : names) {
    if (name.size() > word.size() + most || word.size() > name.size() + most) continue;
    const std::size_t distance = edit_distance(word, name);
    if (distance > most || (distance == most && !found.empty())) continue;
    found = name;
    most = distance;
  }
  return found;
}

std::string instead_of(const std::string& name) {
  static const std::map<std::string, const char*> places{
      {"--radius", "a curve keeps the half-width: that of solve --radius"},
      {"--radius-2", "for two rollers --radius is R1 R2 / (R1 + R2)"},
      {"--hertz-pressure", "--load is pi / 2 times it and the half-width"},
      {"--youngs-modulus", "--shear-modulus is E / (2 (1 + nu))"},
      {"--density", "--diffusivity is conductivity / (density * heat capacity)"},
      {"--heat-capacity", "--diffusivity is conductivity / (density * heat capacity)"},
      {"--specific-heat", "--diffusivity is conductivity / (density * heat capacity)"},
      {"--shear-modulus-2", "both bodies have the same elastic constants"},
      {"--poisson-2", "both bodies have the same elastic constants"}};
  const auto found = places.find(name);
  return found == places.end() ? "" : found->second;
}

std::string reworded(const CLI::ParseError& error, const CLI::App& app) {
  const std::vector<std::string> unclaimed = app.remaining(true);
  if (!unclaimed.empty() && unclaimed.front().empty()) return "unexpected \"\" (see --help)";
  if (!unclaimed.empty()) return "unexpected " + unclaimed.front() + meant(unclaimed.front(), app);
  const std::string text = error.what();
  const std::string first = text.substr(0, text.find_first_of(": "));
  const auto is_named = [&](const CLI::Option& x) { return x.get_name() == first; };
  const auto is_missing = [](const CLI::Option& x) { return x.get_required() && x.count() == 0; };
  const auto kind = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (kind == CLI::ExitCodes::ArgumentMismatch) {
    const CLI::Option* option = first_option(app, is_named);
    const bool again = option != nullptr && option->count() > 1;
    return name_or(option, "an option") + (again ? " is given twice" : " needs exactly one value");
  }
  if (kind == CLI::ExitCodes::RequiredError)
    return name_or(first_option(app, is_missing), "A subcommand") + " is required (see --help)";
  return text + " (see --help)";
}

}  // namespace thermoroll
