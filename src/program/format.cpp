// Tangled from paper/C-output.md; edit there.
#include "program/format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string_view>
#include <variant>

#include <nlohmann/json.hpp>

#include "support/number_text.hpp"

namespace thermoroll {

using json = nlohmann::ordered_json;

namespace {

/// A field of T: its name in JSON and CSV, its symbol and its unit in the text.
template <class T>
struct Row {
  const char *name, *symbol, *unit;
  double T::*value;
};

constexpr Row<PhysicalResults> physical_rows[] = {
    {"half_width", "a", "m", &PhysicalResults::half_width},
    {"radius", "R", "m", &PhysicalResults::radius},
    {"creep_ratio", "xi", "", &PhysicalResults::creep_ratio},
    {"hertz_pressure", "p0", "Pa", &PhysicalResults::hertz_pressure},
    {"max_pressure", "max p", "Pa", &PhysicalResults::max_pressure},
    {"max_traction", "max q", "Pa", &PhysicalResults::max_traction},
    {"max_heat_flux", "max phi", "W/m^2", &PhysicalResults::max_heat_flux},
    {"max_temperature_celsius", "Tmax", "degree C above the half-space's bulk",
     &PhysicalResults::max_temperature_celsius},
    {"half_width_over_radius", "a/R", "", &PhysicalResults::half_width_over_radius},
    {"dissipation", "", "W/m", &PhysicalResults::dissipation},
    {"tangential_load", "Q", "N/m", &PhysicalResults::tangential_load},
    {"max_temperature_at_m", "x", "m", &PhysicalResults::max_temperature_at_m}};

/// Values by their keys, which are constants, in the order in which the keys are first set. A new
/// key makes references to older values invalid.
struct Object {
  struct Entry {
    std::string_view key;
    json value;
  };
  std::vector<Entry> entries;
  json& operator[](std::string_view key) {
    for (Entry& x : entries)
      if (x.key == key) return x.value;
    entries.push_back({key, {}});
    return entries.back().value;
  }
};

json to_json(const Object& values) {
  json o = json::object();
  for (const auto& [key, value] : values.entries) o[std::string(key)] = value;
  return o;
}

void add_heats(Object& o, Object* error, const Solution& x) {
  const Heats heat = heats(x);
  const auto* coupled = std::get_if<CoupledSolution>(&x.found);
  const bool crosses = coupled != nullptr && coupled->crossing;
  const double share = heat.into_half_space.value / x.value(Quantity::heat_integral);
  const bool insulated = x.scene.roller.conductivity_ratio == 0;
  const auto tell = [&](const char* key, const Estimate& found) {
    o[key] = found.value;
    if (error != nullptr) (*error)[key] = found.error;
  };
  tell("heat_1", heat.into_half_space);
  tell("heat_2", heat.into_cylinder);
  o["heat_partition"] = crosses ? json(share) : json(effusivity_share(x.scene));
  if (x.scene.bulk_difference != 0) o["heat_partition"] = nullptr;
  tell("exchanged_heat", heat.exchanged);
  if (!insulated) return;
  o["exchanged_heat"] = nullptr;
  if (error != nullptr) (*error)["exchanged_heat"] = nullptr;
}

void add_no_slip(Object& o, Object* error, const Solution& x) {
  const Scene& scene = x.scene;
  const bool bulk = scene.bulk_difference != 0;
  const NoSlip still = bulk ? no_slip(x) : NoSlip{};
  const auto tell = [&](const char* key, double value, double left) {
    o[key] = bulk ? json(value) : json();
    if (error != nullptr) (*error)[key] = bulk ? json(left) : json();
  };
  tell("no_slip_traction", still.traction, still.traction_error);
  tell("no_slip_creep", still.creep, still.creep_error);
  const auto* coupled = std::get_if<CoupledSolution>(&x.found);
  const CrossingHeat edge = coupled ? coupled->crossing.value_or(CrossingHeat{}) : CrossingHeat{};
  const double apart = distortions_apart(scene);
  const double sign = coupled ? slope_sign(coupled->formulation) : 0;
  const double unit = 2 * sign * scene.friction / pi * apart;
  tell("edge_log_coefficient", unit * edge.edge + 0.0, std::abs(unit) * edge.edge_error);
}

void describe_law(Object& o, const Scene& scene, const CoupledSolution* found) {
  const auto* law = scene.law.target<LawOfFriction>();
  std::optional<LawKind> kind;
  if (law != nullptr) kind = law->kind;
  const bool own = scene.law && law == nullptr;
  o["friction_law"] = own ? "own" : name_of(law_names, kind);
  o["friction_temperature"] = law != nullptr ? json(law->of.scale) : json();
  o["friction_floor"] = law != nullptr ? json(law->of.floor) : json();
  o["friction_reference_temperature"] = law != nullptr ? json(law->of.reference) : json();
  const bool branched = found != nullptr && found->branch;
  o["branch"] = branched ? json(name_of(branch_names, *found->branch)) : json();
}

/// Put in the values, and their errors where there is an object for them.
void add_limits(Object& o, Object* error, const Solution& x) {
  const auto* found = std::get_if<CoupledSolution>(&x.found);
  const std::optional<Estimate> least = least_friction(x);
  const bool limited = found != nullptr && found->limit;
  const double sign = sign_of(x.scene.direction);
  const auto put = [&](const char* key, bool there, double value, double of_it) {
    o[key] = there ? json(value) : json();
    if (error != nullptr) (*error)[key] = there ? json(of_it) : json();
  };
  const Estimate friction = least.value_or(Estimate{});
  const TractionLimit limit = limited ? *found->limit : TractionLimit{};
  put("friction_min", least.has_value(), friction.value, friction.error);
  put("traction_limit", limited, sign * limit.traction, limit.traction_error);
  const bool placed = limited && limit.has_creep();
  put("creep_at_traction_limit", placed, sign * limit.creep, limit.creep_error);
}

struct OptionalRow {
  const char *name, *unit;
  std::optional<Estimate> found;
};

std::array<OptionalRow, 8> optional_rows(const FoundInSi& x) {
  std::optional<Estimate> contact;
  const double error = x.error ? x.error->max_temperature_celsius : 0;
  if (x.contact_temperature_celsius) contact = {*x.contact_temperature_celsius, error};
  return {{{"heat_1", "W/m", x.heat_1},
           {"heat_2", "W/m", x.heat_2},
           {"exchanged_heat", "W/m", x.exchanged_heat},
           {"contact_temperature_celsius", "degree C", contact},
           {"no_slip_tangential_load", "N/m", x.no_slip_load},
           {"no_slip_creep_ratio", "", x.no_slip_creep_ratio},
           {"tangential_load_limit", "N/m", x.tangential_load_limit},
           {"creep_ratio_at_limit", "", x.creep_ratio_at_limit}}};
}

template <class T, std::size_t n>
void add(Object& o, const Row<T> (&rows)[n], const T& values) {
  for (const Row<T>& row : rows) o[row.name] = values.*row.value;
}

void add(Object& o, const Results& values) {
  for (const Reported& row : reported) o[row.key] = values(row.quantity);
}

void add_physical(Object& o, Object& error, const FoundInSi& physical) {
  add(o, physical_rows, physical.value);
  if (physical.error) add(error, physical_rows, *physical.error);
  for (const auto& [name, unit, found] : optional_rows(physical)) {
    o[name] = found ? json(found->value) : json();
    if (physical.error) error[name] = found ? json(found->error) : json();
  }
}

/// The values and errors of a solution by their keys; the errors are empty where none are known.
struct Told {
  Object value, error, physical, physical_error;
};

/// Whether the whole contact slips.
bool all_slips(const Solution& x) { return x.value(Quantity::stick_slip_border) == -1; }

Told told_of(const Solution& x, const std::optional<FoundInSi>& physical) {
  Told told;
  Object &o = told.value, &error = told.error;
  if (x.error) add(error, *x.error);
  const auto* scheme = std::get_if<PublishedSolution>(&x.found);
  o["method"] = name_of(method_names, x.approach.method);
  o["model"] = scheme ? json() : json(name_of(model_names, *x.model));
  o["reason"] = scheme ? json() : json(x.reason);
  o["formulation"] = name_of(formulation_names, x.approach.formulation);
  o["friction"] = x.scene.friction;
  o["traction"] = x.value(Quantity::traction);
  o["peclet"] = x.scene.peclet;
  o["heating"] = x.scene.heating;
  o["nodes"] = scheme ? json(x.approach.nodes) : json();
  const RollerKind kind = kind_of(x.scene);
  const bool insulated = kind == RollerKind::insulated;
  o["roller"] = name_of(roller_names, kind);
  o["direction"] = name_of(direction_names, x.scene.direction);
  o["heating_2"] = insulated ? json() : json(x.scene.roller.heating);
  o["conductivity_ratio"] = insulated ? json() : json(x.scene.roller.conductivity_ratio);
  o["peclet_2"] = insulated ? json() : json(peclet_2(x.scene));
  o["effusivity_ratio"] = insulated ? json() : json(effusivity_ratio(x.scene));
  o["bulk_difference"] = insulated ? json() : json(x.scene.bulk_difference);
  const auto* coupled = std::get_if<CoupledSolution>(&x.found);
  describe_law(o, x.scene, coupled);
  add(o, x.value);
  Object* const errors = x.error ? &error : nullptr;
  add_heats(o, errors, x);
  add_no_slip(o, errors, x);
  o["full_slip"] = all_slips(x);
  add_limits(o, errors, x);
  o["outer_iterations"] = scheme ? scheme->outer_iterations : 0;
  o["inner_iterations"] = scheme ? scheme->inner_iterations : 0;
  o["unknowns"] = coupled ? json(coupled->unknowns) : json();
  o["newton_iterations"] = coupled ? json(coupled->newton_steps) : json();
  o["converged"] = x.converged;
  o["admissible"] = x.violations.empty();
  o["violations"] = json::array();
  for (const auto& [what, from, to] : x.violations)
    o["violations"].push_back({{"what", what}, {"from", from}, {"to", to}});
  if (physical) add_physical(told.physical, told.physical_error, *physical);
  return told;
}

json to_json(const Solution& x, const std::optional<FoundInSi>& physical) {
  const Told told = told_of(x, physical);
  json o = to_json(told.value);
  o["error_estimate"] = x.error ? to_json(told.error) : json();
  if (!physical) return o;
  o["physical"] = to_json(told.physical);
  o["physical"]["error_estimate"] = physical->error ? to_json(told.physical_error) : json();
  o["notes"] = physical->notes;
  const bool conducting = kind_of(x.scene) == RollerKind::conducting;
  for (const SiDatum& data : data_in_si(physical->data, conducting))
    o["data_in_si"][data.name] = data.value;
  return o;
}

void require_finite(const std::string& name, double value) {
  if (!std::isfinite(value))
    throw NotConverged("no finite result was found: " + name + " is " + std::to_string(value));
}

template <class T, std::size_t n>
void require_finite(const Row<T> (&rows)[n], const T& values) {
  for (const Row<T>& row : rows) require_finite(row.name, values.*row.value);
}

void require_finite(const Results& values) {
  for (const Reported& row : reported) require_finite(row.key, values(row.quantity));
}

void require_finite(const Solution& x, const std::optional<FoundInSi>& physical) {
  require_finite(x.value);
  if (x.error) require_finite(*x.error);
  if (physical) require_finite(physical_rows, physical->value);
  if (physical && physical->error) require_finite(physical_rows, *physical->error);
}

/// A few digits, for text.
std::string digits(double x, int significant) {
  std::ostringstream out;
  out << std::setprecision(significant) << x;
  return out.str();
}

std::string list_cell(const json& value) {
  std::string list;
  for (const json& x : value) {
    if (!list.empty()) list += "; ";
    list += x.is_string() ? x.get<std::string>()
                          : x["what"].get<std::string>() + ' ' + digits(x["from"], 6) + ".." +
                                digits(x["to"], 6);
  }
  return list;
}

std::string csv_cell(const json& value) {
  if (value.is_null()) return "";
  if (value.is_array()) return list_cell(value);
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_number_float() || !std::isfinite(value.get<double>())) return value.dump();
  std::array<char, 64> text{};
  char* const first = text.data();  // as dump() does, without its serializer
  return {first, nlohmann::detail::to_chars(first, first + text.size(), value.get<double>())};
}

constexpr std::string_view of_a_roller[] = {
    "roller",   "direction",        "heating_2",       "conductivity_ratio",
    "peclet_2", "effusivity_ratio", "bulk_difference", "heat_1",
    "heat_2",   "heat_partition",   "exchanged_heat",  "edge_log_coefficient"};
constexpr std::string_view of_a_law[] = {"friction_law",   "friction_temperature",
                                         "friction_floor", "friction_reference_temperature",
                                         "branch",         "friction_min"};

bool is_left_out(std::string_view key, const MoreColumns& with) {
  const auto is_in = [&](const auto& keys) {
    return std::find(std::begin(keys), std::end(keys), key) != std::end(keys);
  };
  return (!with.roller && (is_in(of_a_roller) || key.starts_with("no_slip_"))) ||
         (!with.law && (is_in(of_a_law) || key.ends_with("_limit"))) ||
         (!with.roller && !with.law && key == "full_slip") ||
         (!with.bulk && key == "contact_temperature_celsius");
}

void add_fields(std::vector<Field>& fields, const std::string& prefix, const Object& values,
                const MoreColumns& with) {
  for (const auto& [key, value] : values.entries)
    if (!is_left_out(key, with)) fields.push_back({prefix + std::string(key), csv_cell(value)});
}

std::string in_both(double value, const std::optional<Units>& units, double Units::*unit) {
  return shortest(value) + ',' + (units ? shortest(value * (*units).*unit) + ',' : "");
}

/// The absolute temperature; none where the bulk temperature is not known.
std::optional<double> absolute(double temperature, const std::optional<Units>& units) {
  if (!units || !units->bulk_temperature) return std::nullopt;
  return *units->bulk_temperature + temperature * units->temperature;
}

struct ProfileColumn {
  const char *name, *si_name;
  const Eigen::ArrayXd& values;
  double unit, error = 0;
};

std::vector<ProfileColumn> profile_columns(const Profile& x, const Units& unit) {
  const ProfileErrors& error = *x.error;
  std::vector<ProfileColumn> columns = {
      {"pressure", "pressure_pa", x.pressure, unit.traction, error.pressure},
      {"traction", "traction_pa", x.traction, unit.traction, error.traction},
      {"slip", "slip_m_per_s", x.slip, unit.slip, error.slip},
      {"heat_flux", "heat_flux_w_per_m2", x.heat_flux, unit.heat_flux, error.heat_flux},
      {"temperature", "temperature_celsius", x.temperature, unit.temperature, error.temperature}};
  if (x.heat_flux_1.size() == 0) return columns;
  columns.push_back({"heat_flux_1", "heat_flux_1_w_per_m2", x.heat_flux_1, unit.heat_flux});
  columns.push_back({"heat_flux_2", "heat_flux_2_w_per_m2", x.heat_flux_2, unit.heat_flux});
  return columns;
}

/// A column and a cell for each error, with those in units.
Field errors_of(const std::vector<ProfileColumn>& columns, bool in_si) {
  Field all;
  const auto add = [&](const std::string& name, double error) {
    all.name += ",error_estimate." + name;
    all.cell += ',' + (std::isfinite(error) ? shortest(error) : "");
  };
  for (std::size_t i = 0; i < 5; ++i) {
    add(columns[i].name, columns[i].error);
    if (in_si) add(columns[i].si_name, columns[i].error * columns[i].unit);
  }
  return all;
}

using Table = std::vector<std::vector<std::string>>;

/// Characters of a UTF-8 text: all bytes but the continuing ones.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// The table with its columns padded to their widest cell, two blanks apart.
std::string aligned(const Table& table) {
  std::vector<std::size_t> widest(table.front().size(), 0);
  for (const auto& row : table)
    for (std::size_t i = 0; i < row.size(); ++i) widest[i] = std::max(widest[i], width(row[i]));
  std::string text;
  for (const auto& row : table) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(widest[i] - width(row[i]) + 2, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

std::string remark(const Solution& x, bool celsius) {
  std::string text;
  if (x.approach.method == Method::closed_form && heating_of_both(x.scene) > 0)
    text +=
        "\nThe closed form leaves out what the heat does to the tractions. The errors are\n"
        "those of its evaluation, not those of leaving the heat out.\n";
  if (celsius && kind_of(x.scene) == RollerKind::insulated)
    text +=
        "\nAll heat goes into one body, as the roller is an insulator: two steel bodies\n"
        "(--roller identical) are about half as hot.\n";
  return text;
}

struct TextRow {
  const char *name, *symbol;
  double value, error;
  int significant;
  const char* unit;
};

void add_row(Table& table, const TextRow& x) {
  table.push_back({x.name, x.symbol, digits(x.value, x.significant),
                   x.error > 0 ? digits(x.error, 1) : "", x.unit});
}

bool is_heat(std::string_view name) { return name.find("heat") != std::string_view::npos; }

void add_physical(Table& table, const FoundInSi& physical) {
  for (const auto& row : physical_rows) {
    const double error = physical.error ? *physical.error.*row.value : 0;
    add_row(table, {row.name, row.symbol, physical.value.*row.value, error, 6, row.unit});
  }
  for (const auto& [name, unit, found] : optional_rows(physical))
    if (found && !is_heat(name)) add_row(table, {name, "", found->value, found->error, 6, unit});
}

void add_heats(Table& table, const json& o, const std::optional<FoundInSi>& physical) {
  if (physical) {
    for (const auto& [name, unit, found] : optional_rows(*physical))
      if (found && is_heat(name)) add_row(table, {name, "", found->value, found->error, 6, unit});
    return;
  }
  const json& errors = o["error_estimate"];
  std::vector<const char*> names{"heat_1", "heat_2"};
  if (o["bulk_difference"] != 0) names.push_back("exchanged_heat");
  for (const char* name : names) {
    const double error = errors.is_null() ? 0 : errors[name].get<double>();
    add_row(table, {name, "", o[name], error, errors.is_null() ? 6 : 9, ""});
  }
}

std::string to_text(const Solution& x, const std::optional<FoundInSi>& physical) {
  Table table{{"quantity", "symbol", "value", "error", "unit"}};
  const json o = to_json(x, physical);
  const bool insulated = kind_of(x.scene) == RollerKind::insulated;
  const auto plain = [&](const char* name, const char* symbol) {
    const json& cell = o[name];
    const std::string text = cell.is_number_float() ? digits(cell, 9) : csv_cell(cell);
    table.push_back({name, symbol, text, "", ""});
  };
  plain("method", "");
  if (x.approach.method == Method::automatic) {
    plain("model", "");
    plain("reason", "");
  }
  if (x.approach.method != Method::closed_form) plain("formulation", "");
  plain("friction", "f");
  plain("peclet", "Pe");
  plain("heating", "H");
  if (!insulated) {
    plain("roller", "");
    plain("heating_2", "H2");
    plain("conductivity_ratio", "K2/K1");
    plain("peclet_2", "Pe2");
    plain("effusivity_ratio", "e2/e1");
    if (!o["heat_partition"].is_null()) plain("heat_partition", is_unlike(x.scene) ? "" : "omega");
  }
  if (x.scene.bulk_difference != 0) plain("bulk_difference", "");
  for (const char* name : {"no_slip_traction", "no_slip_creep", "edge_log_coefficient"})
    if (x.scene.bulk_difference != 0)
      add_row(table, {name, "", o[name], x.error ? double(o["error_estimate"][name]) : 0, 9, ""});
  if (x.scene.direction == Direction::braking) plain("direction", "");
  if (x.scene.law) {
    plain("friction_law", "");
    plain("friction_temperature", "T0*");
    plain("friction_floor", "");
    plain("friction_reference_temperature", "T*ref");
  }
  if (!o["branch"].is_null()) plain("branch", "");
  if (all_slips(x)) plain("full_slip", "");
  for (const auto& [quantity, key, symbol] : reported) {
    const double error = x.error ? (*x.error)(quantity) : 0;
    add_row(table, {key, symbol, x.value(quantity), error, x.error ? 9 : 6, ""});
  }
  for (const char* key : {"friction_min", "traction_limit", "creep_at_traction_limit"})
    if (!o[key].is_null()) add_row(table, {key, "", o[key], o["error_estimate"][key], 9, ""});
  if (!insulated) add_heats(table, o, physical);
  if (physical) add_physical(table, *physical);
  if (x.approach.method == Method::gauss_chebyshev)
    for (const char* name : {"nodes", "outer_iterations", "inner_iterations", "converged"})
      plain(name, "");
  if (!x.violations.empty())
    for (const char* name : {"admissible", "violations"}) plain(name, "");
  if (std::holds_alternative<CoupledSolution>(x.found))
    for (const char* name : {"unknowns", "newton_iterations"}) plain(name, "");
  return aligned(table) + remark(x, physical.has_value());
}

/// One object a row, with the first row's cells as the keys.
json claims_json(const Table& table) {
  json list = json::array();
  for (std::size_t k = 1; k < table.size(); ++k) {
    json o;
    for (std::size_t i = 0; i < table[k].size(); ++i) o[table[0][i]] = table[k][i];
    list.push_back(o);
  }
  return list;
}

}  // namespace

RollerKind kind_of(const Scene& scene) {
  const Roller& roller = scene.roller;
  if (roller.conductivity_ratio == 0) return RollerKind::insulated;
  const bool alike =
      roller.conductivity_ratio == 1 && roller.heating == scene.heating && roller.peclet == 0;
  return alike ? RollerKind::identical : RollerKind::conducting;
}

std::vector<SiDatum> data_in_si(const PhysicalScene& x, bool conducting) {
  std::vector<SiDatum> all{{"load", x.load, "N/m"},
                           {"speed", x.speed, "m/s"},
                           {"half_width", x.half_width, "m"},
                           {"shear_modulus", x.shear_modulus, "Pa"},
                           {"poisson", x.poisson, ""},
                           {"expansion", x.expansion, "1/K"},
                           {"diffusivity", x.diffusivity, "m^2/s"},
                           {"conductivity", x.conductivity, "W/(m K)"}};
  if (conducting)
    all.insert(all.end(), {{"expansion_2", x.expansion_2, "1/K"},
                           {"diffusivity_2", diffusivity_2(x), "m^2/s"},
                           {"conductivity_2", x.conductivity_2, "W/(m K)"}});
  const auto add = [&](const char* name, const std::optional<double>& value, const char* unit) {
    if (value) all.push_back({name, *value, unit});
  };
  add("bulk_temperature", x.bulk_temperature, "degree C");
  add("bulk_temperature_2", x.bulk_temperature_2, "degree C");
  if (!x.law) return all;
  add("friction_temperature", x.law->of.scale, "K");
  if (x.bulk_temperature)
    add("friction_reference_temperature", *x.bulk_temperature + x.law->of.reference, "degree C");
  return all;
}

ColumnMeaning meaning_of(const std::string& column) {
  const std::string name = column.substr(column.rfind('.') + 1);
  const bool physical = column.find("physical.") == 0, error = name != column && !physical;
  for (const auto& row : physical_rows)
    if (physical && name == row.name) return {row.symbol, *row.unit == 0 ? "1" : row.unit};
  for (const OptionalRow& row : optional_rows({}))
    if (physical && name == row.name) return {"", *row.unit == 0 ? "1" : row.unit};
  for (const Reported& row : reported)
    if (name == row.key) return {error ? "" : row.symbol, "1"};
  return {"", "1"};
}

std::vector<Field> csv_fields(const Solution& x, const std::optional<FoundInSi>& physical,
                              const MoreColumns& with) {
  require_finite(x, physical);
  Told told = told_of(x, physical);
  if (!x.error) {
    for (const Reported& row : reported) told.error[row.key] = nullptr;
    for (const char* key :
         {"heat_1", "heat_2", "exchanged_heat", "no_slip_traction", "no_slip_creep",
          "edge_log_coefficient", "friction_min", "traction_limit", "creep_at_traction_limit"})
      told.error[key] = nullptr;
  }
  if (physical && !physical->error)
    for (const auto& [key, value] : told.physical.entries) told.physical_error[key] = nullptr;
  std::vector<Field> fields;
  add_fields(fields, "", told.value, with);
  add_fields(fields, "error_estimate.", told.error, with);
  add_fields(fields, "physical.", told.physical, with);
  add_fields(fields, "physical.error_estimate.", told.physical_error, with);
  if (physical) fields.push_back({"notes", csv_cell(physical->notes)});
  return fields;
}

std::string quoted(std::string text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  for (std::size_t i = text.find('"'); i != std::string::npos; i = text.find('"', i + 2))
    text.insert(i, "\"");
  return '"' + text + '"';
}

std::string curve_csv(const std::vector<DepthCurve>& curves, const std::optional<Units>& units) {
  const bool deep = curves.size() > 1;
  std::string text = units ? "s,x_m," : "s,";
  if (deep) text += units ? "depth,depth_m," : "depth,";
  text += units ? "temperature,temperature_celsius," : "temperature,";
  if (absolute(0, units)) text += "absolute_temperature_celsius,";
  text += units ? "error_estimate,error_estimate_celsius\n" : "error_estimate\n";
  for (const auto& [depth, curve] : curves)
    for (const auto& [s, t, error] : curve.points) {
      if (!std::isfinite(t))
        throw NotConverged("no finite temperature found at s = " + shortest(s));
      text += in_both(s, units, &Units::length);
      if (deep) text += in_both(depth, units, &Units::length);
      text += in_both(t, units, &Units::temperature);
      if (const auto whole = absolute(t, units)) text += shortest(*whole) + ',';
      text += error ? shortest(*error) : "";
      if (units) text += error ? ',' + shortest(*error * units->temperature) : ",";
      text += '\n';
    }
  return text;
}

std::string profile_csv(const Profile& x, const std::optional<Units>& units) {
  const Units unit = units.value_or(Units{});
  const std::vector<ProfileColumn> columns = profile_columns(x, unit);
  const Field errors = errors_of(columns, units.has_value());
  std::string text = units ? "s,x_m" : "s";
  for (const ProfileColumn& c : columns)
    text.append(",").append(c.name).append(units ? std::string(",") + c.si_name : "");
  if (absolute(0, units)) text += ",absolute_temperature_celsius";
  if (x.friction.size() > 0) text += ",friction";
  text += errors.name;
  for (Eigen::Index i = 0; i < x.s.size(); ++i) {
    text += '\n' + shortest(x.s(i)) + (units ? ',' + shortest(x.s(i) * unit.length) : "");
    for (const ProfileColumn& c : columns)
      text += ',' + shortest(c.values(i)) + (units ? ',' + shortest(c.values(i) * c.unit) : "");
    if (const auto whole = absolute(x.temperature(i), units)) text += ',' + shortest(*whole);
    if (x.friction.size() > 0) text += ',' + shortest(x.friction(i));
    text += errors.cell;
  }
  return text + '\n';
}

std::string present(const Solution& x, const std::optional<FoundInSi>& physical, Format format) {
  require_finite(x, physical);
  if (format == Format::text) return to_text(x, physical);
  if (format == Format::json) return to_json(x, physical).dump(2) + '\n';
  std::string header, cells;
  const MoreColumns with{kind_of(x.scene) != RollerKind::insulated, static_cast<bool>(x.scene.law),
                         physical && physical->contact_temperature_celsius};
  for (const Field& field : csv_fields(x, physical, with)) {
    const char* comma = header.empty() ? "" : ",";
    header.append(comma).append(field.name);
    cells.append(comma).append(quoted(field.cell));
  }
  return header + '\n' + cells + '\n';
}

std::string present(const std::vector<Claim>& claims, Format format) {
  Table table{
      {"claim", "source", "paper", "published_scheme", "converged", "corrected", "verdict"}};
  for (const Claim& c : claims)
    table.push_back(
        {c.claim, c.source, c.paper, c.published, c.converged, c.corrected, c.verdict.words});
  if (format == Format::text) return aligned(table);
  if (format == Format::json) return claims_json(table).dump(2) + '\n';
  std::string text;
  for (const auto& row : table)
    for (std::size_t i = 0; i < row.size(); ++i)
      text += quoted(row[i]) + (i + 1 < row.size() ? ',' : '\n');
  return text;
}

}  // namespace thermoroll
