// Tangled from paper/A-command-line.md, paper/F-sweeps-and-reliability.md; edit there.
#include "exit_status.hpp"

#include <cctype>

#include "solution.hpp"

namespace thermoroll {

int status_of(const std::exception& error) {
  if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr) return 2;
  if (dynamic_cast<const NotConverged*>(&error) != nullptr) return 3;
  if (dynamic_cast<const NoContact*>(&error) != nullptr) return 5;
  return dynamic_cast<const RowsFailed*>(&error) != nullptr ? 4 : 1;
}

std::string in_one_line(std::string message) {
  for (char& c : message)
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  return message;
}

}  // namespace thermoroll
