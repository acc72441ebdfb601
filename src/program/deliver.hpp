// Tangled from paper/C-output.md; edit there.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace thermoroll {

/// A text and the file to write it to; standard output if file is empty or "-".
struct Answer {
  std::string text, file;
};

/// Write the answers, each as a whole, or none where one cannot be written (what has gone to
/// standard output or a device stays there). Throws std::system_error.
void deliver(const std::vector<Answer>& answers);

/// Write to standard output at once. Throws std::system_error.
void print(const std::string& text);

/// Wait until nothing is being written, but no longer than this; whether that is so. If it is,
/// nothing will be written any more.
bool stop_output(std::chrono::milliseconds longest);

}  // namespace thermoroll
