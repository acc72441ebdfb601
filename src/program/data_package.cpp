// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#include "program/data_package.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>

namespace thermoroll {
namespace {

using nlohmann::ordered_json;

std::string type_of(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  static const std::map<std::string, std::vector<std::string>> types{
      {"string",
       {"method", "model", "reason", "formulation", "roller", "direction", "friction_law", "branch",
        "violations", "notes", "error"}},
      {"boolean", {"converged", "admissible", "full_slip"}},
      {"integer",
       {"nodes", "outer_iterations", "inner_iterations", "unknowns", "newton_iterations",
        "status"}}};
  for (const auto& [type, names] : types)
    if (std::find(names.begin(), names.end(), name) != names.end()) return type;
  return "number";
}

std::string error_column(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  const std::string object = "physical.";
  const bool inner = name.find(object) == 0;
  return (inner ? object : "") + "error_estimate." + name.substr(inner ? object.size() : 0);
}

std::string unit_of_cell(const SweepTable& t, const std::string& option) {
  const bool si = std::any_of(t.fields.begin(), t.fields.end(),
                              [](const std::string& x) { return x.rfind("physical.", 0) == 0; });
  if (si && option == "friction-temperature") return "K";
  if (si && option == "friction-reference-temperature") return "degree C";
  return unit_of_option(option);
}

ordered_json field_of(const SweepTable& t, const WrittenColumn& x) {
  const bool is_label = x.cell && t.columns[*x.cell].is_label;
  ordered_json o{{"name", x.name}, {"type", is_label ? "string" : type_of(x.name)}};
  if (is_label || o["type"] == "string" || o["type"] == "boolean") return o;
  const std::string option = x.cell ? unit_of_cell(t, t.columns[*x.cell].option) : "";
  const ColumnMeaning meaning = meaning_of(x.name);
  if (!meaning.symbol.empty()) o["symbol"] = meaning.symbol;
  const std::string unit = option.empty() ? meaning.unit : option;
  if (!unit.empty()) o["unit"] = unit;
  for (const WrittenColumn& y : t.written)
    if (y.name == error_column(x.name)) o["errorColumn"] = y.name;
  return o;
}

}  // namespace

std::string data_package(const SweepTable& t, const std::string& data, const std::string& package) {
  namespace fs = std::filesystem;
  const fs::path path = fs::absolute(data).lexically_relative(fs::absolute(package).parent_path());
  if (path.empty() || *path.begin() == "..")
    throw std::invalid_argument("datapackage = " + package +
                                " is not allowed: it must stand above or beside the results");
  ordered_json fields = ordered_json::array();
  for (const WrittenColumn& x : t.written) fields.push_back(field_of(t, x));
  const bool lines = t.how.format == RowFormat::jsonl;
  const ordered_json resource{{"name", "results"},
                              {"path", path.generic_string()},
                              {"format", lines ? "jsonl" : "csv"},
                              {"mediatype", lines ? "application/jsonl" : "text/csv"},
                              {"encoding", "utf-8"},
                              {"schema", {{"fields", fields}, {"missingValues", {""}}}}};
  const auto resources = ordered_json::array({resource});
  const ordered_json all{{"name", "thermoroll-sweep"}, {"resources", resources}};
  return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace thermoroll
