#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace thermoroll_test {

namespace {

double to_number(const std::string& cell) {
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0' || !std::isfinite(value))
    throw std::runtime_error("'" + cell + "' is not a finite number");
  return value;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      result.back() += line[++i];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      result.emplace_back();
    else
      result.back() += line[i];
  }
  return result;
}

}  // namespace

std::size_t Table::column(const std::string& name) const {
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) throw std::runtime_error("no column " + name);
  return static_cast<std::size_t>(found - header.begin());
}

double Table::number(std::size_t row, const std::string& name) const {
  return to_number(text(row, name));
}

const std::string& Table::text(std::size_t row, const std::string& name) const {
  return rows.at(row)[column(name)];
}

Table parse_table(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  Table table;
  if (!std::getline(stream, line)) throw std::runtime_error("no header");
  table.header = cells(line);
  while (std::getline(stream, line)) {
    table.rows.push_back(cells(line));
    if (table.rows.back().size() != table.header.size())
      throw std::runtime_error("row " + std::to_string(table.rows.size()) + " has " +
                               std::to_string(table.rows.back().size()) + " cells");
  }
  return table;
}

Table read_table(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (!(text << file.rdbuf())) throw std::runtime_error("cannot read " + path);
  return parse_table(text.str());
}

std::map<std::string, Tolerance> tolerances_of(const Table& sidecar, const std::string& file) {
  std::map<std::string, Tolerance> result;
  for (std::size_t row = 0; row < sidecar.rows.size(); ++row)
    if (sidecar.text(row, "file") == file)
      result[sidecar.text(row, "column")] = {sidecar.number(row, "absolute"),
                                             sidecar.number(row, "relative")};
  return result;
}

std::vector<std::string> differences(const Table& golden, const Table& actual,
                                     const std::map<std::string, Tolerance>& tolerances) {
  if (actual.header != golden.header) return {"the header differs"};
  if (actual.rows.size() != golden.rows.size())
    return {std::to_string(actual.rows.size()) + " rows instead of " +
            std::to_string(golden.rows.size())};
  std::vector<std::string> result;
  for (std::size_t row = 0; row < golden.rows.size(); ++row)
    for (const std::string& name : golden.header) {
      const auto tolerance = tolerances.find(name);
      const std::string& cell = actual.text(row, name);
      const std::string place = "row " + std::to_string(row + 1) + ", " + name + ": ";
      if (tolerance == tolerances.end()) {
        if (cell != golden.text(row, name))
          result.push_back(place + "'" + cell + "' instead of '" + golden.text(row, name) + "'");
        continue;
      }
      try {
        const double expected = golden.number(row, name);
        const double allowed =
            tolerance->second.absolute + tolerance->second.relative * std::abs(expected);
        if (std::abs(actual.number(row, name) - expected) > allowed)
          result.push_back(place + cell + " instead of " + golden.text(row, name));
      } catch (const std::runtime_error& error) {
        result.push_back(place + error.what());
      }
    }
  return result;
}

}  // namespace thermoroll_test
