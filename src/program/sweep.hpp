// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "program/format.hpp"
#include "program/scene_options.hpp"

namespace thermoroll {

/// The progress of a sweep.
struct SweepCount {
  long rows = 0, failed = 0;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// Solve the table that is read from a file descriptor and print it with its results, by so many
/// threads; with progress, tell of it on standard error. Throws std::invalid_argument for a header
/// that is of no use, std::system_error where reading, writing or starting a thread fails.
SweepCount sweep(int file, int jobs, bool progress);

/// Rows and errors, rows per second, and the most memory that the process had so far.
std::string summary(const SweepCount& x);

/// The columns of a table: those read, and the names of the fields that a solved row has.
struct SweepTable {
  std::vector<std::string> columns, fields;
  MoreColumns with{};
};

/// The columns of a table with this header. Throws std::invalid_argument.
SweepTable table_of(const std::string& header);

/// The cells of a line, without what surrounds them.
std::vector<std::string> cells_of(const std::string& line);

/// The scene in the cells of a row. Throws std::invalid_argument.
SceneOptions read_row(const std::vector<std::string>& columns,
                      const std::vector<std::string>& cells);

/// A row of results and whether it is without an error.
struct SweepRow {
  std::string text;
  bool solved;
};

/// A line of the table, solved.
SweepRow answer(const SweepTable& table, const std::string& line);

}  // namespace thermoroll
