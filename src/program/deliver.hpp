// Tangled from paper/C-output.md; edit there.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace thermoroll {

/// A text and the file to write it to; standard output if file is empty or "-".
struct Answer {
  std::string text, file;
};

/// Write the answers, each as a whole, or none where one cannot be written (what has gone to
/// standard output, to a device or in the place of another file stays there). Throws
/// std::system_error.
void deliver(const std::vector<Answer>& answers);

/// The file that a name leads to through all links, whether it is there or not.
std::filesystem::path place_of(std::filesystem::path file, std::error_code& problem);

/// A file to be written: its name as given, that without links, and what is to be removed if
/// something fails: where it is written until it is whole, then the file if it is new. Both are
/// empty for a device, which is in its place.
struct Written {
  std::string file, target, aside;
  bool is_new = false;
};

/// A text that is written piece by piece: to standard output if the file is empty or "-", to a file
/// that appears when it is finished, or behind what a file has. Its functions throw
/// std::system_error, and std::invalid_argument if it cannot be appended to.
class Output {
 public:
  enum class Kind { whole, appended };
  Output(const std::string& file, Kind kind);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output();

  void put(const std::string& text, long rows = 0);  ///< at once; so many rows
  void cut(std::uintmax_t bytes);                    ///< keep so much of what it was appended to
  void finish();

 private:
  Written written_;
  std::FILE* file_ = stdout;
};

/// The rows that the output has so far, after stop_output(); below zero if there is none.
long rows_written();

/// Wait until nothing is being written, but no longer than this; whether that is so. If it is,
/// nothing will be written any more. Files that have not been finished are removed in any case.
bool stop_output(std::chrono::milliseconds longest);

}  // namespace thermoroll
