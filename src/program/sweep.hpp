// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "program/table.hpp"

namespace thermoroll {

/// The part of this number, from 1, of so many.
struct Part {
  long number, of;
};

/// A table to sweep, and where its results go.
struct SweepRequest {
  int input = 0;  ///< the file descriptor that it is read from
  TableOptions table{};
  std::string output{}, resume{};  ///< a file that is whole, or one that is appended to
  std::string package{};           ///< a data package that describes it
  std::optional<Part> part{};
  int jobs = 1;           ///< threads
  bool progress = false;  ///< whether it is told on standard error
};

/// The progress of a sweep.
struct SweepCount {
  long rows = 0, failed = 0, noted = 0, resumed = 0;  // resumed: those of the file
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// Solve a table and write it with its results. Throws std::invalid_argument for a header or a file
/// to resume that is of no use, std::system_error where reading, writing or starting a thread
/// fails.
SweepCount sweep(const SweepRequest& request);

/// Rows and errors, rows per second, and the most memory that the process had so far.
std::string summary(const SweepCount& x);

}  // namespace thermoroll
