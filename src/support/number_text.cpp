// Tangled from paper/F-data-files.md; edit there.
#include "support/number_text.hpp"

#include <array>
#include <charconv>
#include <iomanip>
#include <locale>
#include <sstream>

namespace thermoroll {

std::string shortest(double value) {
  std::array<char, 32> text{};  // a double needs at most 24 characters
  return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

std::string rounded(double value, int digits) {
  std::array<char, 32> text{};
  char* const end = text.data() + text.size();
  return {text.data(),
          std::to_chars(text.data(), end, value, std::chars_format::general, digits).ptr};
}

double number_of(const std::string& text) {
  double x = 0;
  std::from_chars(text.data(), text.data() + text.size(), x);
  return x;
}

std::string with_exponent(double value, int digits) {
  std::array<char, 32> text{};
  char* const end = text.data() + text.size();
  return {text.data(),
          std::to_chars(text.data(), end, value, std::chars_format::scientific, digits - 1).ptr};
}

std::string fixed(double value, int decimals) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

std::string to_two_digits(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return fixed(unit * std::round(value / unit), value < 10 ? 1 : 0);
}

std::string scientific(double value, int digits) {
  if (value == 0) return "0";
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::scientific << std::setprecision(digits - 1) << value;
  const std::string text = stream.str();  // 2.1e-03
  const std::size_t e = text.find('e');
  const int exponent = std::stoi(text.substr(e + 1));
  return "$" + text.substr(0, e) + "\\cdot10^{" + std::to_string(exponent) + "}$";
}

}  // namespace thermoroll
