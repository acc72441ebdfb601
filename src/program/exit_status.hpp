// Tangled from paper/B-command-line.md, paper/D-sweeps-and-reliability.md; edit there.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>

namespace thermoroll {

/// A sweep is complete, but some of its rows have an error.
struct RowsFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The exit status of @tbl:exit-codes that an error leads to.
int status_of(const std::exception& error);

/// The message of an error in one line: its text, with blanks in place of control characters
/// and the numbers of bytes that are no UTF-8; for std::bad_alloc, how much memory was in use.
std::string message_of(const std::exception& error);

}  // namespace thermoroll
