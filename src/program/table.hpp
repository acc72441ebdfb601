// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "program/format.hpp"
#include "program/scene_options.hpp"

namespace thermoroll {

/// The longest line of a table that is read.
inline constexpr std::size_t longest_line = 10000;

/// A column of a table as read: its name, and the option of solve that it sets, if it sets one.
struct ReadColumn {
  std::string name, option;
  bool is_label = false;  ///< else, without an option, it holds earlier results
};

/// An option of a scene and its value, as in --friction=0.6.
struct Setting {
  std::string option, value;
};

/// The options of a sweep that concern its rows.
struct TableOptions {
  std::vector<Setting> constants{};                ///< for rows that do not have another value
  std::vector<std::string> keep{"id"}, columns{};  ///< labels; what is written, or all if empty
  std::string given{};                             ///< the prescribing option, if results are read
  RowFormat format = RowFormat::csv;
};

/// A column of the results: the cell of the row that it repeats, or if that is empty or there is
/// none, the field of the solution.
struct WrittenColumn {
  std::string name;
  std::optional<std::size_t> cell, field;
};

/// The columns of a table: those read, those written, and the names of the fields of a solved row,
/// of which the last two are status and error.
struct SweepTable {
  TableOptions how;
  std::vector<ReadColumn> columns;
  std::string given{};  ///< of results that are read again
  std::vector<std::string> fields{};
  MoreColumns with{};
  std::vector<WrittenColumn> written{};
};

/// A row of results, whether it is without an error, and whether it has notes.
struct SweepRow {
  std::string text;
  bool solved, noted;
};

/// The rows of results in a file, and where the last whole one ends.
struct RowsSoFar {
  long rows = 0, failed = 0;
  std::uintmax_t bytes = 0;
  std::string last{}, rest{};  ///< the last whole row, and what is behind it
};

/// The names of all results that a row may have.
const std::vector<std::string>& all_results();

/// The columns of a table with this header. Throws std::invalid_argument.
SweepTable table_of(const std::string& header, const TableOptions& how);

/// Append the cells of a line, without what surrounds them. Throws std::invalid_argument at a quote
/// that does not end as it should; the cells before it are there.
void read_cells(const std::string& line, std::vector<std::string>& cells);

/// The options that a row and the sweep set together; cells with earlier results are emptied.
/// Throws std::invalid_argument if there are more or fewer cells than columns.
std::vector<Setting> settings_of(const SweepTable& t, std::vector<std::string>& cells);

/// The scene that the settings of a row describe. Throws std::invalid_argument.
SceneOptions read_row(const std::vector<Setting>& row);

/// A line of the table, solved.
SweepRow answer(const SweepTable& t, const std::string& line);

/// The first line of the results; empty for JSON.
std::string header_of(const SweepTable& t);

/// The rows of results in a file. Throws std::invalid_argument, whose text is what the file does
/// wrong: other columns, or a row of no sweep.
RowsSoFar rows_so_far(const SweepTable& t, std::istream& file, bool has_header);

}  // namespace thermoroll
