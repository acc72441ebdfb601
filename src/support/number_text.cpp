// Tangled from paper/F-data-files.md; edit there.
#include "support/number_text.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace thermoroll {

std::string shortest(double value) {
  std::array<char, 32> text{};  // a double needs at most 24 characters
  return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

std::string fixed(double value, int decimals) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

/// 1.2e-3 as $1.2\cdot10^{-3}$.
std::string scientific(double value, int digits) {
  if (value == 0) return "0";
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(value))));
  return "$" + fixed(value / std::pow(10, exponent), digits - 1) + "\\cdot10^{" +
         std::to_string(exponent) + "}$";
}

}  // namespace thermoroll
