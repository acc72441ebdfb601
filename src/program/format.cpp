// Tangled from paper/C-output.md; edit there.
#include "program/format.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
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
    {"max_temperature_celsius", "Tmax", "degree C above ambient",
     &PhysicalResults::max_temperature_celsius},
    {"half_width_over_radius", "a/R", "", &PhysicalResults::half_width_over_radius},
    {"dissipation", "", "W/m", &PhysicalResults::dissipation}};

RollerKind kind_of(const Scene& scene) {
  const Roller& roller = scene.roller;
  if (roller.conductivity_ratio == 0) return RollerKind::insulated;
  const bool alike = roller.conductivity_ratio == 1 && roller.heating == scene.heating;
  return alike ? RollerKind::identical : RollerKind::conducting;
}

void share_heat(json& o, const Scene& scene, const Results& x) {
  const double heat = heat_share(scene) * x(Quantity::heat_integral);
  o["heat_1"] = heat;
  o["heat_2"] = scene.roller.conductivity_ratio * heat;
}

template <class T, std::size_t n>
json object(const Row<T> (&rows)[n], const T& values) {
  json o;
  for (const Row<T>& row : rows) o[row.name] = values.*row.value;
  return o;
}

json object(const Results& values) {
  json o;
  for (const Reported& row : reported) o[row.key] = values(row.quantity);
  return o;
}

json to_json(const Solution& x, const std::optional<FoundInSi>& physical) {
  json o;
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
  o.update(object(x.value));
  share_heat(o, x.scene, x.value);
  o["heat_partition"] = heat_share(x.scene);
  o["full_slip"] = x.value(Quantity::stick_slip_border) == -1;
  const auto* coupled = std::get_if<CoupledSolution>(&x.found);
  o["outer_iterations"] = scheme ? scheme->outer_iterations : 0;
  o["inner_iterations"] = scheme ? scheme->inner_iterations : 0;
  o["unknowns"] = coupled ? json(coupled->unknowns) : json();
  o["newton_iterations"] = coupled ? json(coupled->newton_steps) : json();
  o["converged"] = x.converged;
  o["admissible"] = x.violations.empty();
  o["violations"] = json::array();
  for (const auto& [what, from, to] : x.violations)
    o["violations"].push_back({{"what", what}, {"from", from}, {"to", to}});
  o["error_estimate"] = x.error ? object(*x.error) : json();
  if (x.error) share_heat(o["error_estimate"], x.scene, *x.error);
  if (physical) {
    o["physical"] = object(physical_rows, physical->value);
    o["physical"]["error_estimate"] =
        physical->error ? object(physical_rows, *physical->error) : json();
    o["notes"] = physical->notes;
  }
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

/// A few digits, for the eye.
std::string digits(double x, int significant) {
  std::ostringstream out;
  out << std::setprecision(significant) << x;
  return out.str();
}

std::string csv_cell(const json& value) {
  if (value.is_null()) return "";
  if (value.is_array()) {
    std::string list;
    for (const json& x : value) {
      if (!list.empty()) list += "; ";
      list += x.is_string() ? x.get<std::string>()
                            : x["what"].get<std::string>() + ' ' + digits(x["from"], 6) + ".." +
                                  digits(x["to"], 6);
    }
    return quoted(list);
  }
  return value.is_string() ? quoted(value) : value.dump();
}

void flatten(const json& o, const std::string& prefix, std::vector<Field>& fields) {
  for (const auto& [key, value] : o.items())
    if (value.is_object())
      flatten(value, prefix + key + ".", fields);
    else
      fields.push_back({prefix + key, csv_cell(value)});
}

void leave_out_pair(json& o) {
  for (const char* key : {"roller", "direction", "heating_2", "conductivity_ratio", "heat_1",
                          "heat_2", "heat_partition", "full_slip"})
    o.erase(key);
  for (const char* key : {"heat_1", "heat_2"}) o["error_estimate"].erase(key);
}

struct ProfileColumn {
  const char *name, *si_name;
  const Eigen::ArrayXd& values;
  double unit;
};

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
    plain("heat_partition", "omega");
  }
  if (x.scene.direction == Direction::braking) plain("direction", "");
  for (const auto& [quantity, key, symbol] : reported) {
    const double error = x.error ? (*x.error)(quantity) : 0;
    table.push_back({key, symbol, digits(x.value(quantity), x.error ? 9 : 6),
                     error > 0 ? digits(error, 1) : "", ""});
  }
  if (physical)
    for (const auto& row : physical_rows) {
      const double error = physical->error ? *physical->error.*row.value : 0;
      table.push_back({row.name, row.symbol, digits(physical->value.*row.value, 6),
                       error > 0 ? digits(error, 1) : "", row.unit});
    }
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

std::vector<Field> csv_fields(const Solution& x, const std::optional<FoundInSi>& physical,
                              bool with_pair) {
  require_finite(x, physical);
  json o = to_json(x, physical);
  if (!x.error) {
    for (const Reported& row : reported) o["error_estimate"][row.key] = nullptr;
    for (const char* key : {"heat_1", "heat_2"}) o["error_estimate"][key] = nullptr;
  }
  if (!with_pair) leave_out_pair(o);
  if (physical && !physical->error)
    for (const auto& row : physical_rows) o["physical"]["error_estimate"][row.name] = nullptr;
  std::vector<Field> fields;
  flatten(o, "", fields);
  return fields;
}

std::string quoted(std::string text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  for (std::size_t i = text.find('"'); i != std::string::npos; i = text.find('"', i + 2))
    text.insert(i, "\"");
  return '"' + text + '"';
}

std::string curve_csv(const Curve& curve, const std::optional<Units>& units) {
  std::string text = "s,temperature,";
  text += units ? "temperature_celsius,error_estimate\n" : "error_estimate\n";
  for (const auto& [s, t, error] : curve.points) {
    if (!std::isfinite(t)) throw NotConverged("no finite temperature found at s = " + shortest(s));
    text += shortest(s) + ',' + shortest(t) + ',';
    if (units) text += shortest(t * units->temperature) + ',';
    text += (error ? shortest(*error) : "") + '\n';
  }
  return text;
}

std::string profile_csv(const Profile& x, const std::optional<Units>& units) {
  const Units unit = units.value_or(Units{});
  const ProfileColumn columns[] = {
      {"pressure", "pressure_pa", x.pressure, unit.traction},
      {"traction", "traction_pa", x.traction, unit.traction},
      {"slip", "slip_m_per_s", x.slip, unit.slip},
      {"heat_flux", "heat_flux_w_per_m2", x.heat_flux, unit.heat_flux},
      {"temperature", "temperature_celsius", x.temperature, unit.temperature}};
  std::string text = "s";
  for (const ProfileColumn& c : columns)
    text.append(",").append(c.name).append(units ? std::string(",") + c.si_name : "");
  for (Eigen::Index i = 0; i < x.s.size(); ++i) {
    text += '\n' + shortest(x.s(i));
    for (const ProfileColumn& c : columns)
      text += ',' + shortest(c.values(i)) + (units ? ',' + shortest(c.values(i) * c.unit) : "");
  }
  return text + '\n';
}

std::string present(const Solution& x, const std::optional<FoundInSi>& physical, Format format) {
  require_finite(x, physical);
  if (format == Format::text) return to_text(x, physical);
  if (format == Format::json) return to_json(x, physical).dump(2) + '\n';
  std::string header, cells;
  const bool with_pair = kind_of(x.scene) != RollerKind::insulated;
  for (const Field& field : csv_fields(x, physical, with_pair)) {
    const char* comma = header.empty() ? "" : ",";
    header.append(comma).append(field.name);
    cells.append(comma).append(field.cell);
  }
  return header + '\n' + cells + '\n';
}

std::string present(const std::vector<Claim>& claims, Format format) {
  Table table{{"claim", "paper", "printed", "converged", "verdict"}};
  for (const Claim& c : claims)
    table.push_back({c.claim, c.paper, c.published, c.converged, c.verdict});
  if (format == Format::text) return aligned(table);
  if (format == Format::json) return claims_json(table).dump(2) + '\n';
  std::string text;
  for (const auto& row : table)
    for (std::size_t i = 0; i < row.size(); ++i)
      text += quoted(row[i]) + (i + 1 < row.size() ? ',' : '\n');
  return text;
}

}  // namespace thermoroll
