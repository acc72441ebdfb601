// Tangled from paper/A-command-line.md; edit there.
#include "program/output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <system_error>
#include <variant>

#include <nlohmann/json.hpp>

#include "support/number_text.hpp"

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
    {"traction", "Q*", "", &Results::traction},
    {"stick_slip_border", "c0", "", &Results::stick_slip_border},
    {"creep_constant", "C", "", &Results::creep_constant},
    {"creep", "xi*", "", &Results::creep},
    {"load_ratio", "kappa", "", &Results::load_ratio},
    {"gamma0", "gamma0", "", &Results::gamma0},
    {"eccentricity", "", "", &Results::eccentricity},
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
    {"max_temperature_celsius", "Tmax", "degree C above ambient",
     &PhysicalResults::max_temperature_celsius}};

/// A few digits, for the eye.
std::string digits(double x, int significant) {
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

void require_finite(const Solution& x, const std::optional<FoundInSi>& physical) {
  require_finite(result_rows, x.value);
  if (x.error) require_finite(result_rows, *x.error);
  if (physical) require_finite(physical_rows, physical->value);
  if (physical && physical->error) require_finite(physical_rows, *physical->error);
}

const char* name_of(Method method) {
  const char* const names[] = {"auto", "closed-form", "first-order", "coupled", "gauss-chebyshev"};
  return names[static_cast<int>(method)];
}

template <class T, std::size_t n>
json object(const Row<T> (&rows)[n], const T& values) {
  json o;
  for (const Row<T>& row : rows) o[row.name] = values.*row.value;
  return o;
}

json to_json(const Solution& x, const std::optional<FoundInSi>& physical) {
  json o;
  const bool printed = x.approach.formulation == Formulation::printed;
  const auto* scheme = std::get_if<PublishedSolution>(&x.found);
  o["method"] = name_of(x.approach.method);
  o["model"] = scheme ? json() : json(x.model);
  o["reason"] = scheme ? json() : json(x.reason);
  o["formulation"] = printed ? "printed" : "corrected";
  o["friction"] = x.scene.friction;
  o["traction"] = x.value.traction;
  o["peclet"] = x.scene.peclet;
  o["heating"] = x.scene.heating;
  o["nodes"] = scheme ? json(x.approach.nodes) : json();
  o.update(object(result_rows, x.value));
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
  o["error_estimate"] = x.error ? object(result_rows, *x.error) : json();
  if (physical) {
    o["physical"] = object(physical_rows, physical->value);
    o["physical"]["error_estimate"] =
        physical->error ? object(physical_rows, *physical->error) : json();
  }
  return o;
}

std::string csv_cell(const json& value) {
  if (value.is_null()) return "";
  if (value.is_array()) {
    std::string list;
    for (const json& x : value)
      list += (list.empty() ? "" : "; ") + x["what"].get<std::string>() + ' ' +
              digits(x["from"], 6) + ".." + digits(x["to"], 6);
    return list;
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

std::string remark(const Solution& x) {
  if (x.approach.method != Method::closed_form || x.scene.heating == 0) return "";
  return "\nThe closed form leaves out what the heat does to the tractions. The errors are\n"
         "those of its evaluation, not those of leaving the heat out.\n";
}

std::string to_text(const Solution& x, const std::optional<FoundInSi>& physical) {
  Table table{{"quantity", "symbol", "value", "error", "unit"}};
  const json o = to_json(x, physical);
  const auto plain = [&](const char* name, const char* symbol) {
    const json& cell = o[name];
    const std::string text = cell.is_number_float() ? digits(cell, 9) : csv_cell(cell);
    table.push_back({name, symbol, text, "", ""});
  };
  plain("method", "");
  if (x.approach.method == Method::automatic) plain("model", ""), plain("reason", "");
  if (x.approach.method != Method::closed_form) plain("formulation", "");
  plain("friction", "f");
  plain("peclet", "Pe");
  plain("heating", "H");
  for (const auto& row : result_rows) {
    const double error = x.error ? *x.error.*row.value : 0;
    table.push_back({row.name, row.symbol, digits(x.value.*row.value, x.error ? 9 : 6),
                     error > 0 ? digits(error, 1) : "", row.unit});
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

struct ProfileColumn {
  const char *name, *si_name;
  const Eigen::ArrayXd& values;
  double unit;
};

/// How much of the text could be written; if not all, errno says why.
std::size_t write_all(int file, const std::string& text) {
  pollfd output{file, POLLOUT, 0};
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = write(file, text.data() + done, text.size() - done);
    if (count >= 0)
      done += static_cast<std::size_t>(count);
    else if (errno == EAGAIN)
      poll(&output, 1, -1);
    else if (errno != EINTR)
      break;
  }
  return done;
}

/// A file to be written: its name as given, that without links, and where it is written until it is
/// whole. This is empty for a device, which is in its place.
struct Written {
  std::string file, target, aside;
};

/// Create the file aside; its descriptor, or -1.
int create_beside(Written& x) {
  const fs::path folder = fs::path(x.target).parent_path();
  for (int k = 0;; ++k) {
    const std::string name = "thermoroll-" + std::to_string(getpid()) + '-' + std::to_string(k);
    const fs::path aside = folder / name;
    const int file = open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) x.aside = aside.string();
    if (file >= 0 || errno != EEXIST) return file;
  }
}

std::string end_of_links(fs::path file) {
  std::error_code none;
  for (int links = 0; links < 40 && fs::is_symlink(file, none); ++links)
    file = file.parent_path() / fs::read_symlink(file, none);
  return file.string();
}

int open_aside(Written& x) {
  const char* name = x.file.c_str();
  struct stat old {};
  const bool is_new = stat(name, &old) != 0;
  if (is_new && errno != ENOENT) return -1;
  if (!is_new && !S_ISREG(old.st_mode)) return open(name, O_WRONLY | O_TRUNC | O_CLOEXEC);
  if (!is_new && access(name, W_OK) != 0) return -1;
  x.target = end_of_links(x.file);
  const int file = create_beside(x);
  if (file >= 0 && !is_new) fchmod(file, old.st_mode & 07777U);
  return file;
}

[[noreturn]] void cannot_write(const std::string& what, int reason) {
  throw std::system_error(reason, std::generic_category(), "cannot write " + what);
}

void write_aside(Written& x, const std::string& text) {
  const int file = open_aside(x);
  if (file < 0) cannot_write(x.file, errno);
  const int reason = write_all(file, text) < text.size() ? errno : 0;
  if (close(file) != 0 || reason != 0) cannot_write(x.file, reason != 0 ? reason : errno);
}

void put_in_place(const Written& x) {
  if (std::rename(x.aside.c_str(), x.target.c_str()) != 0) cannot_write(x.file, errno);
}

void take_back(std::size_t count) {
  const off_t end = lseek(STDOUT_FILENO, 0, SEEK_CUR);  // negative for a pipe
  const bool appends = (fcntl(STDOUT_FILENO, F_GETFL) & O_APPEND) != 0;
  if (count == 0 || end < 0 || appends) return;
  [[maybe_unused]] const int none = ftruncate(STDOUT_FILENO, end - static_cast<off_t>(count));
}

}  // namespace

std::string quoted(std::string text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  for (std::size_t i = text.find('"'); i != std::string::npos; i = text.find('"', i + 2))
    text.insert(i, "\"");
  return '"' + text + '"';
}

std::vector<Field> csv_fields(const Solution& x, const std::optional<FoundInSi>& physical) {
  require_finite(x, physical);
  json o = to_json(x, physical);
  if (!x.error)
    for (const auto& row : result_rows) o["error_estimate"][row.name] = nullptr;
  if (physical && !physical->error)
    for (const auto& row : physical_rows) o["physical"]["error_estimate"][row.name] = nullptr;
  std::vector<Field> fields;
  flatten(o, "", fields);
  return fields;
}

std::string present(const Solution& x, const std::optional<FoundInSi>& physical, Format format) {
  require_finite(x, physical);
  if (format == Format::text) return to_text(x, physical);
  if (format == Format::json) return to_json(x, physical).dump(2) + '\n';
  std::string header, cells;
  for (const Field& field : csv_fields(x, physical)) {
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

std::timed_mutex& writing() {
  static std::timed_mutex mutex;
  return mutex;
}

void print(const std::string& text) {
  const std::size_t done = write_all(STDOUT_FILENO, text);
  if (done == text.size()) return;
  const int reason = errno;
  take_back(done);
  cannot_write("to standard output", reason);
}

void deliver(const std::vector<Answer>& answers) {
  const std::lock_guard<std::timed_mutex> whole(writing());
  const auto to_output = [](const Answer& x) { return x.file.empty() || x.file == "-"; };
  std::vector<Written> written;
  try {
    for (const Answer& answer : answers)
      if (!to_output(answer))
        write_aside(written.emplace_back(Written{answer.file, "", ""}), answer.text);
    for (const Answer& answer : answers)
      if (to_output(answer)) print(answer.text);
    for (const Written& x : written)
      if (!x.aside.empty()) put_in_place(x);
  } catch (...) {
    for (const Written& x : written) std::remove(x.aside.c_str());  // nothing, if it has none
    throw;
  }
}

}  // namespace thermoroll
