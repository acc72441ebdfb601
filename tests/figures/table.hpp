#pragma once
#include <map>
#include <string>
#include <vector>

namespace thermoroll_test {

/// A CSV file: one header line, then rows of as many cells.
struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

  /// Place of a column; throws std::runtime_error when there is none of that name.
  std::size_t column(const std::string& name) const;
  /// The finite number in a cell; throws std::runtime_error for anything else, NaN and Inf
  /// included.
  double number(std::size_t row, const std::string& name) const;
  const std::string& text(std::size_t row, const std::string& name) const;
};

/// Reads CSV text (cells may be quoted); throws std::runtime_error on a row of the wrong length.
Table parse_table(const std::string& text);
Table read_table(const std::string& path);

/// A cell may differ from the golden one by absolute + relative * |golden|.
struct Tolerance {
  double absolute, relative;
};

/// The tolerances of one file by column, from the sidecar (file,column,absolute,relative,reason).
std::map<std::string, Tolerance> tolerances_of(const Table& sidecar, const std::string& file);

/// What is wrong with `actual`, a line each; nothing when it equals `golden`: the same header and
/// number of rows, finite numbers within the tolerance in the columns that have one, the same text
/// in the others.
std::vector<std::string> differences(const Table& golden, const Table& actual,
                                     const std::map<std::string, Tolerance>& tolerances);

}  // namespace thermoroll_test
