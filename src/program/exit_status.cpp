// Tangled from paper/B-command-line.md, paper/D-sweeps-and-reliability.md; edit there.
#include "program/exit_status.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <new>

#include "thermoroll/solution.hpp"

namespace thermoroll {
namespace {

/// The bytes of the character that begins there; 0 if there is none.
std::size_t character_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0U;
  };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xC2   ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xC0U) != 0x80) return 0;
  const bool too_long = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool no_letter = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return too_long || no_letter ? 0 : length;
}

/// Below the blank, the one behind the last letter, and U+0080 to U+009F.
bool is_control(const std::string& character) {
  const auto first = static_cast<unsigned char>(character[0]);
  return first < 0x20 || first == 0x7F ||
         (first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

/// A byte as "\xff".
std::string as_number(char byte) {
  const char* digits = "0123456789abcdef";
  const auto value = static_cast<unsigned char>(byte);
  return {'\\', 'x', digits[value / 16], digits[value % 16]};
}

std::string in_one_line(const std::string& message) {
  std::string line;
  for (std::size_t at = 0; at < message.size();) {
    const std::size_t length = character_at(message, at);
    const std::string character = message.substr(at, std::max<std::size_t>(length, 1));
    if (length == 0)
      line += as_number(message[at]);
    else
      line += is_control(character) ? " " : character;
    at += character.size();
  }
  return line;
}

}  // namespace

int status_of(const std::exception& error) {
  if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr) return 2;
  if (dynamic_cast<const NotConverged*>(&error) != nullptr) return 3;
  if (dynamic_cast<const NoContact*>(&error) != nullptr) return 5;
  return dynamic_cast<const RowsFailed*>(&error) != nullptr ? 4 : 1;
}

std::string message_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) == nullptr) return in_one_line(error.what());
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return "there is not enough memory: " + std::to_string(use.ru_maxrss / 1024) + " MB were in use";
}

}  // namespace thermoroll
