// Tangled from paper/A-command-line.md; edit there.
#include "output.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <system_error>

#include <nlohmann/json.hpp>

#include "numbers.hpp"

namespace thermoroll {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

namespace {

/// A field of T: its name in JSON and CSV, its symbol and its unit in the text.
template <class T>
struct Row {
  const char *name, *symbol, *unit;
  double T::*value;
};

constexpr Row<Results> result_rows[] = {
    {"stick_slip_border", "c0", "", &Results::stick_slip_border},
    {"creep_constant", "C", "", &Results::creep_constant},
    {"creep", "xi*", "", &Results::creep},
    {"load_ratio", "kappa", "", &Results::load_ratio},
    {"gamma0", "gamma0", "", &Results::gamma0},
    {"heat_integral", "int v*p*", "", &Results::heat_integral},
    {"max_temperature", "T*max", "", &Results::max_temperature},
    {"max_temperature_at", "s", "", &Results::max_temperature_at}};

constexpr Row<PhysicalResults> physical_rows[] = {
    {"half_width", "a", "m", &PhysicalResults::half_width},
    {"radius", "R", "m", &PhysicalResults::radius},
    {"creep_ratio", "xi", "", &PhysicalResults::creep_ratio},
    {"hertz_pressure", "p0", "Pa", &PhysicalResults::hertz_pressure},
    {"max_pressure", "max p", "Pa", &PhysicalResults::max_pressure},
    {"max_traction", "max q", "Pa", &PhysicalResults::max_traction},
    {"max_heat_flux", "max phi", "W/m^2", &PhysicalResults::max_heat_flux},
    {"max_temperature_celsius", "Tmax", "degree C", &PhysicalResults::max_temperature_celsius}};

/// A few digits, for the eye.
std::string digits(double x, int significant = 9) {
  std::ostringstream out;
  out << std::setprecision(significant) << x;
  return out.str();
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

template <class T, std::size_t n>
void require_finite(const Row<T> (&rows)[n], const T& values) {
  for (const Row<T>& row : rows)
    if (!std::isfinite(values.*row.value))
      throw NotConverged(std::string("no finite result was found: ") + row.name + " is " +
                         std::to_string(values.*row.value));
}

template <class T, std::size_t n>
json object(const Row<T> (&rows)[n], const T& values) {
  json o;
  for (const Row<T>& row : rows) o[row.name] = values.*row.value;
  return o;
}

json to_json(const Solution& x, const std::optional<PhysicalResults>& physical) {
  json o;
  const bool closed = x.approach.method == Method::closed_form;
  const bool printed = x.approach.formulation == Formulation::printed;
  o["method"] = closed ? "closed-form" : "gauss-chebyshev";
  o["formulation"] = printed ? "printed" : "corrected";
  o["friction"] = x.scene.friction;
  o["traction"] = x.scene.traction;
  o["peclet"] = x.scene.peclet;
  o["heating"] = x.scene.heating;
  o["nodes"] = closed ? json() : json(x.approach.nodes);
  o.update(object(result_rows, x.value));
  o["outer_iterations"] = x.outer_iterations;
  o["inner_iterations"] = x.inner_iterations;
  o["converged"] = x.converged;
  o["error_estimate"] = x.error ? object(result_rows, *x.error) : json();
  if (physical) o["physical"] = object(physical_rows, *physical);
  return o;
}

std::string csv_cell(const json& value) {
  if (value.is_null()) return "";
  if (!value.is_string()) return value.dump();
  std::string text = value;
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  for (std::size_t i = text.find('"'); i != std::string::npos; i = text.find('"', i + 2))
    text.insert(i, "\"");
  return '"' + text + '"';
}

void flatten(const json& o, const std::string& prefix, std::string& header, std::string& cells) {
  for (const auto& [key, value] : o.items()) {
    if (value.is_object()) {
      flatten(value, prefix + key + ".", header, cells);
      continue;
    }
    const char* comma = header.empty() ? "" : ",";
    header.append(comma).append(prefix).append(key);
    cells.append(comma).append(csv_cell(value));
  }
}

std::string remark(const Solution& x) {
  if (x.approach.method == Method::gauss_chebyshev || x.scene.heating == 0) return "";
  return "\nThe closed form leaves out what the heat does to the tractions. The errors are\n"
         "those of its evaluation, not those of leaving the heat out.\n";
}

std::string to_text(const Solution& x, const std::optional<PhysicalResults>& physical) {
  Table table{{"quantity", "symbol", "value", "error", "unit"}};
  const json o = to_json(x, physical);
  const auto plain = [&](const char* name, const char* symbol) {
    const json& cell = o[name];
    table.push_back({name, symbol, cell.is_number_float() ? digits(cell) : csv_cell(cell), "", ""});
  };
  plain("method", "");
  plain("formulation", "");
  plain("friction", "f");
  plain("traction", "Q*");
  plain("peclet", "Pe");
  plain("heating", "H");
  if (!o["nodes"].is_null()) plain("nodes", "n");
  for (const auto& row : result_rows)
    table.push_back({row.name, row.symbol, digits(x.value.*row.value),
                     x.error ? digits(*x.error.*row.value, 1) : "", row.unit});
  if (physical)
    for (const auto& row : physical_rows)
      table.push_back({row.name, row.symbol, digits(*physical.*row.value), "", row.unit});
  if (x.approach.method == Method::gauss_chebyshev) {
    plain("outer_iterations", "");
    plain("inner_iterations", "");
    plain("converged", "");
  }
  return aligned(table) + remark(x);
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

void write_file(const std::string& file, const std::string& text) {
  std::error_code none;
  const auto status = fs::status(file, none);
  const bool special = fs::exists(status) && !fs::is_regular_file(status);
  const std::string target = fs::is_regular_file(status) ? fs::canonical(file).string() : file;
  const std::string aside = special ? target : target + ".tmp";
  errno = 0;
  std::ofstream out(aside, std::ios::binary);
  out << text;
  out.close();
  if (out && (special || std::rename(aside.c_str(), target.c_str()) == 0)) return;
  const int reason = errno;
  if (!special) std::remove(aside.c_str());
  throw std::system_error(reason, std::generic_category(), "cannot write " + file);
}

}  // namespace

std::string present(const Solution& x, const std::optional<PhysicalResults>& physical,
                    Format format) {
  require_finite(result_rows, x.value);
  if (x.error) require_finite(result_rows, *x.error);
  if (physical) require_finite(physical_rows, *physical);
  if (format == Format::text) return to_text(x, physical);
  json o = to_json(x, physical);
  if (format == Format::json) return o.dump(2) + '\n';
  if (!x.error)
    for (const auto& row : result_rows) o["error_estimate"][row.name] = nullptr;
  std::string header, cells;
  flatten(o, "", header, cells);
  return header + '\n' + cells + '\n';
}

std::string present(const std::vector<Claim>& claims, Format format) {
  Table table{{"claim", "paper", "printed", "converged", "verdict"}};
  for (const Claim& c : claims)
    table.push_back({c.claim, c.paper, c.printed, c.converged, c.verdict});
  if (format == Format::text) return aligned(table);
  if (format == Format::json) return claims_json(table).dump(2) + '\n';
  std::string text;
  for (const auto& row : table)
    for (std::size_t i = 0; i < row.size(); ++i)
      text += csv_cell(row[i]) + (i + 1 < row.size() ? ',' : '\n');
  return text;
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

void deliver(const std::string& text, const std::string& file) {
  if (!file.empty()) return write_file(file, text);
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
}

}  // namespace thermoroll
