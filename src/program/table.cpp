// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#include "program/table.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "program/exit_status.hpp"

namespace thermoroll {
namespace {

/// The cell that begins there, which is moved behind the next comma, or to npos.
std::string plain_cell(const std::string& line, std::size_t& at) {
  const std::size_t end = line.find(',', at);
  std::string cell = line.substr(at, end - at);
  cell.erase(0, std::min(cell.find_first_not_of(" \t"), cell.size()));
  cell.erase(cell.find_last_not_of(" \t\r") + 1);
  at = end == std::string::npos ? end : end + 1;
  return cell;
}

/// The same of a cell whose first quote stands before `at`. Throws std::invalid_argument.
std::string quoted_cell(const std::string& line, std::size_t& at) {
  std::string cell;
  for (;; ++at) {
    const std::size_t quote = line.find('"', at);
    if (quote == std::string::npos)
      throw std::invalid_argument("a quote is not closed on its line");
    cell += line.substr(at, quote - at);
    at = quote + 1;
    if (at == line.size() || line[at] != '"') break;
    cell += '"';
  }
  at = line.find_first_not_of(" \t\r", at);
  if (at != std::string::npos && line[at++] != ',')
    throw std::invalid_argument("a quote is followed by text: two quotes stand for one");
  return cell;
}

bool has_name(const std::vector<std::string>& names, const std::string& name) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& x) { return hyphenated(x) == hyphenated(name); });
}

std::vector<std::string> names_of(const std::vector<Field>& fields) {
  std::vector<std::string> names;
  names.reserve(fields.size() + 2);
  for (const Field& field : fields) names.push_back(field.name);
  names.insert(names.end(), {"status", "error"});
  return names;
}

struct RowOptions {
  RowOptions() { add_scene_options(row, values); }
  SceneOptions values;
  CLI::App row;
};

std::string meant(const std::string& name, const std::vector<std::string>& names) {
  std::string other = nearest(name, names);
  if (has_name(names, "physical." + name)) other = "physical." + name;
  return other.empty() ? "" : " (did you mean " + other + "?)";
}

std::string hint_for(const std::string& name, const CLI::App& options) {
  for (const auto& [mark, word] : {std::pair(';', "';'"), std::pair('\t', "a tab")})
    if (name.find(mark) != std::string::npos)
      return std::string(" (are its fields separated by ") + word + "? only commas separate them)";
  std::vector<std::string> names = all_results();
  for (const CLI::Option* option : options.get_options())
    if (option->get_name() != "--help") names.push_back(option->get_name().substr(2));
  return meant(name, names);
}

ReadColumn column_of(const std::string& name, const TableOptions& how, const CLI::App& options) {
  if (has_name(how.keep, name)) return {name, "", true};
  if (name.empty())
    throw std::invalid_argument("the header has a column without a name (a comma at its end?)");
  const std::string option = hyphenated(name);
  if (option != "help" && options.get_option_no_throw("--" + option) != nullptr)
    return {name, option};
  if (has_name(all_results(), name)) return {name, ""};
  throw std::invalid_argument("the header names what is no option of solve: " + name +
                              hint_for(name, options) + "; --keep lets a label pass");
}

std::vector<ReadColumn> read_header(const std::string& line, const TableOptions& how) {
  const std::string mark = "\xEF\xBB\xBF";  // the byte-order mark
  std::vector<std::string> names;
  read_cells(line.substr(line.find(mark) == 0 ? mark.size() : 0), names);
  if (line.find('\r') < line.find_last_not_of('\r'))
    throw std::invalid_argument(
        "the lines end in carriage returns alone: save them with line feeds");
  const RowOptions options;
  std::vector<ReadColumn> columns;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    columns.push_back(column_of(name, how, options.row));
    if (!seen.insert(hyphenated(name)).second)
      throw std::invalid_argument("the header names " + name + " twice");
  }
  return columns;
}

/// Whether the table has a column, or the sweep an option, for which this holds.
template <class Condition>
bool any_option(const SweepTable& t, Condition holds) {
  const auto& all = t.how.constants;
  return std::any_of(t.columns.begin(), t.columns.end(),
                     [&](const ReadColumn& x) { return holds(x.option); }) ||
         std::any_of(all.begin(), all.end(), [&](const Setting& x) { return holds(x.option); });
}

bool has_option(const SweepTable& t, const std::string& name) {
  return any_option(t, [&](const std::string& option) { return option == name; });
}

void check_complete(const SweepTable& t) {
  if (!has_option(t, "friction")) throw std::invalid_argument("the header lacks friction");
  if (!any_option(t, is_given_option))
    throw std::invalid_argument(
        "the header lacks traction, creep, stick-slip-border or, with data in SI units, "
        "creep-ratio or tangential-load");
  std::string missing;
  for (const std::string& name : data_in_si_units())
    if (!has_option(t, name)) missing += ' ' + name;
  if (!has_option(t, "peclet") && !any_option(t, is_si_option))
    throw std::invalid_argument("the header lacks peclet (or data in SI units)");
  if (!has_option(t, "peclet") && !missing.empty())
    throw std::invalid_argument("the header lacks, of data in SI units:" + missing);
  if (!has_option(t, "peclet") && !has_option(t, "half-width") && !has_option(t, "radius"))
    throw std::invalid_argument("the header lacks half-width or radius");
  for (const std::string& name : t.how.keep)
    if (name != "id" && std::none_of(t.columns.begin(), t.columns.end(), [&](const ReadColumn& x) {
          return x.is_label && hyphenated(x.name) == hyphenated(name);
        }))
      throw std::invalid_argument("the header lacks " + name + ", which --keep names");
}

/// Nothing if the table has no results. Throws std::invalid_argument.
std::string given_column(const SweepTable& t) {
  std::vector<std::string> there;
  bool has_results = !t.how.given.empty();
  for (const ReadColumn& x : t.columns) {
    if (is_given_option(x.option)) there.push_back(x.option);
    has_results = has_results || (x.option.empty() && !x.is_label);
  }
  if (!has_results) return "";
  std::string given = t.how.given.empty() && there.size() == 1 ? there[0] : t.how.given;
  if (given.empty())
    throw std::invalid_argument(
        "the table has results: --given says which of its columns prescribes, as in --given creep");
  if (!has_option(t, given))
    throw std::invalid_argument("given = " + given + " is not allowed: the header lacks it");
  return given;
}

std::string value_in(const std::vector<Setting>& row, const std::string& option) {
  const auto at =
      std::find_if(row.begin(), row.end(), [&](const Setting& x) { return x.option == option; });
  return at == row.end() ? "" : at->value;
}

bool was_filled(const std::string& option, const std::string& given,
                const std::vector<Setting>& row) {
  if (is_given_option(option)) return option != given;
  if (option == "direction") return given != "stick-slip-border";
  if (option == "branch") return given != "traction" && given != "tangential-load";
  const bool si =
      std::any_of(row.begin(), row.end(), [](const Setting& x) { return is_si_option(x.option); });
  const std::string roller = value_in(row, "roller");
  return (si && is_group_option(option)) || (roller != "conducting" && is_roller_option(option));
}

std::vector<Setting> cell_settings(const SweepTable& t, const std::vector<std::string>& cells) {
  std::vector<Setting> row;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!cells[i].empty() && !t.columns[i].option.empty())
      row.push_back({t.columns[i].option, cells[i]});
  return row;
}

void add_constants(std::vector<Setting>& row, const std::vector<Setting>& constants) {
  const std::vector<Setting> own = row;
  for (const Setting& x : constants)
    if (std::none_of(own.begin(), own.end(), [&](const Setting& y) {
          return y.option == x.option || exclude_each_other(x.option, y.option);
        }))
      row.push_back(x);
}

void name_fields(SweepTable& t) {
  t.with = {has_option(t, "roller"), has_option(t, "friction-law"),
            has_option(t, "bulk-temperature")};
  std::optional<FoundInSi> physical;
  if (any_option(t, is_si_option)) physical.emplace();
  t.fields = names_of(csv_fields(Solution{}, physical, t.with));
  if (!physical) return;
  for (std::string& name : t.fields)
    if (name == "friction_temperature" || name == "friction_reference_temperature") name.clear();
}

std::optional<std::size_t> place(const std::vector<std::string>& names, const std::string& name) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (hyphenated(names[i]) == hyphenated(name)) return i;
  return std::nullopt;
}

std::vector<WrittenColumn> all_columns(const SweepTable& t) {
  std::vector<WrittenColumn> all;
  std::set<std::size_t> shown;
  for (std::size_t i = 0; i < t.columns.size(); ++i) {
    const ReadColumn& x = t.columns[i];
    if (x.option.empty() && !x.is_label) continue;
    const auto field = x.is_label ? std::nullopt : place(t.fields, x.name);
    if (field) shown.insert(*field);
    all.push_back({x.name, i, field});
  }
  for (std::size_t k = 0; k < t.fields.size(); ++k)
    if (!t.fields[k].empty() && shown.count(k) == 0) all.push_back({t.fields[k], {}, k});
  return all;
}

std::vector<WrittenColumn> wanted_columns(const SweepTable& t) {
  std::vector<WrittenColumn> all = all_columns(t);
  if (t.how.columns.empty()) return all;
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const WrittenColumn& x : all) names.push_back(x.name);
  std::vector<WrittenColumn> wanted;
  std::set<std::size_t> seen;
  for (const std::string& name : t.how.columns) {
    const std::optional<std::size_t> at = place(names, name);
    if (!at)
      throw std::invalid_argument("columns = " + name + " is not allowed: it must be a column" +
                                  meant(name, names));
    if (!seen.insert(*at).second)
      throw std::invalid_argument("columns = " + name + " is not allowed: it is named twice");
    wanted.push_back(all[*at]);
  }
  return wanted;
}

void check_length(const std::string& line, const std::string& what) {
  if (line.size() > longest_line)
    throw std::invalid_argument(what + " has more than " + std::to_string(longest_line) +
                                " characters");
}

std::vector<std::string> values_of(const SweepTable& t, std::vector<Field> found,
                                   const std::string& status, const std::string& error) {
  std::vector<std::string> values;
  values.reserve(t.fields.size());
  auto next = found.begin();
  for (const std::string& name : t.fields) {
    const auto is_it = [&](const Field& field) { return field.name == name; };
    auto at = std::find_if(next, found.end(), is_it);
    if (at == found.end()) at = std::find_if(found.begin(), next, is_it);
    const bool is_found = !name.empty() && at != found.end() && is_it(*at);
    values.push_back(is_found ? std::move(at->cell) : "");
    if (is_found) next = at + 1;
  }
  values.end()[-2] = status;
  values.back() = error;
  return values;
}

const std::string& cell_of(const WrittenColumn& x, const std::vector<std::string>& cells,
                           const std::vector<std::string>& values) {
  static const std::string empty;
  if (x.cell && *x.cell < cells.size() && !cells[*x.cell].empty()) return cells[*x.cell];
  return x.field ? values[*x.field] : empty;
}

nlohmann::ordered_json json_of(const std::string& cell, bool is_label) {
  if (is_label) return cell;
  if (cell.empty()) return nullptr;
  if (cell == "true" || cell == "false") return cell == "true";
  const bool is_whole = cell.find_first_not_of("0123456789") == std::string::npos;
  if (is_whole && cell.size() < 16) return std::stoll(cell);
  const std::optional<double> number = to_number(cell);
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(cell);
}

std::string row_text(const SweepTable& t, const std::vector<std::string>& cells,
                     const std::vector<std::string>& values) {
  if (t.how.format == RowFormat::jsonl) {
    nlohmann::ordered_json o;
    for (const WrittenColumn& x : t.written) {
      const bool is_label = x.cell && t.columns[*x.cell].is_label;
      o[x.name] = json_of(cell_of(x, cells, values), is_label);
    }
    return o.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
  }
  std::string row;
  for (const WrittenColumn& x : t.written) {
    if (&x != t.written.data()) row += ',';
    row += quoted(cell_of(x, cells, values));
  }
  return row + '\n';
}

bool has_failed(const SweepTable& t, const std::string& row) {
  if (t.how.format == RowFormat::jsonl) {
    const auto o = nlohmann::json::parse(row, nullptr, false);
    const auto status = o.find("status");
    const bool has_status = o.is_object() && status != o.end();
    if (!o.is_object() || (has_status && !status->is_number()))
      throw std::invalid_argument("no row of results");
    return has_status && *status != 0;
  }
  std::vector<std::string> cells;
  read_cells(row.substr(0, row.size() - 1), cells);
  if (cells.size() != t.written.size()) throw std::invalid_argument("no row of results");
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (t.written[i].name == "status") {
      if (!to_number(cells[i])) throw std::invalid_argument("no row of results");
      return cells[i] != "0";
    }
  return false;
}

}  // namespace

const std::vector<std::string>& all_results() {
  static const std::vector<std::string> names =
      names_of(csv_fields(Solution{}, FoundInSi{}, {true, true, true}));
  return names;
}

void read_cells(const std::string& line, std::vector<std::string>& cells) {
  for (std::size_t at = 0; at != std::string::npos;) {
    const std::size_t first = line.find_first_not_of(" \t", at);
    const bool is_quoted = first != std::string::npos && line[first] == '"';
    if (is_quoted) at = first + 1;
    cells.push_back(is_quoted ? quoted_cell(line, at) : plain_cell(line, at));
  }
}

void check_labels(const TableOptions& how) {
  for (const std::string& name : how.keep)
    if (has_name(all_results(), name))
      throw std::invalid_argument("keep = " + name +
                                  " is not allowed: it must be no name of a result");
}

std::vector<Setting> settings_of(const SweepTable& t, std::vector<std::string>& cells) {
  if (cells.size() != t.columns.size())
    throw std::invalid_argument("the row has " + std::to_string(cells.size()) +
                                " cells and the header " + std::to_string(t.columns.size()));
  std::vector<Setting> row = cell_settings(t, cells);
  add_constants(row, t.how.constants);
  if (t.given.empty()) return row;
  const std::vector<Setting> all = row;
  const auto filled = [&](const std::string& option) { return was_filled(option, t.given, all); };
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (filled(t.columns[i].option)) cells[i].clear();
  row.erase(
      std::remove_if(row.begin(), row.end(), [&](const Setting& x) { return filled(x.option); }),
      row.end());
  return row;
}

SceneOptions read_row(const std::vector<Setting>& row) {
  std::vector<std::string> arguments;
  arguments.reserve(row.size());
  for (const Setting& x : row) arguments.push_back("--" + x.option + '=' + x.value);
  thread_local std::optional<RowOptions> options;
  if (!options || options->row.parse_order().size() > 10000) options.emplace();
  options->values = {};
  try {
    options->row.parse(arguments);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(reworded(error, options->row));
  }
  return options->values;
}

SweepTable table_of(const std::string& header, const TableOptions& how) {
  check_labels(how);
  check_length(header, "the header");
  SweepTable t{how, read_header(header, how)};
  t.given = given_column(t);
  check_complete(t);
  name_fields(t);
  t.written = wanted_columns(t);
  return t;
}

std::string header_of(const SweepTable& t) {
  if (t.how.format == RowFormat::jsonl) return "";
  std::string row;
  for (const WrittenColumn& x : t.written) row += (row.empty() ? "" : ",") + quoted(x.name);
  return row + '\n';
}

SweepRow answer(const SweepTable& t, const std::string& line) {
  std::vector<std::string> cells;
  std::vector<Field> found;
  try {
    check_length(line, "the row");
    read_cells(line, cells);
    if (line.find('\0') != std::string::npos)
      throw std::invalid_argument("the row holds a null character");
    const SolvedScene x = solve_scene(read_scene(read_row(settings_of(t, cells))));
    found = csv_fields(x.solution, x.physical, t.with);
    require_contact(x.solution);
    const bool noted = x.physical && !x.physical->notes.empty();
    return {row_text(t, cells, values_of(t, std::move(found), "0", "")), true, noted};
  } catch (const std::exception& error) {
    const std::string status = std::to_string(status_of(error));
    return {row_text(t, cells, values_of(t, std::move(found), status, message_of(error))), false,
            false};
  }
}

RowsSoFar rows_so_far(const SweepTable& t, std::istream& file, bool has_header) {
  RowsSoFar x;
  const std::string header = has_header ? header_of(t) : "";
  std::string line;
  for (bool first = !header.empty(); std::getline(file, line) && !file.eof(); first = false) {
    line += '\n';
    x.bytes += line.size();
    if (first && line != header)
      throw std::invalid_argument("has other columns than the results of this sweep");
    if (first) continue;
    ++x.rows;
    try {
      x.failed += has_failed(t, line);
    } catch (const std::invalid_argument&) {
      throw std::invalid_argument("has a row that no sweep has written: row " +
                                  std::to_string(x.rows));
    }
    x.last = line;
  }
  x.rest = line;
  return x;
}

}  // namespace thermoroll
