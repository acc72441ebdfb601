// Tangled from paper/F-data-files.md; edit there.
#pragma once

#include <cmath>
#include <string>

namespace thermoroll {

/// A number with as many digits as it takes to read it back unchanged, as "0.1" or "1e-300".
std::string shortest(double value);

/// A number rounded to so many digits, at most 20, as "0.1" or "1.2e+06", and the number of such a
/// text; or a number rounded so that it is not above the value, or not below it.
std::string rounded(double value, int digits);
double number_of(const std::string& text);
inline std::string rounded_down(double value, int digits) {
  if (!(std::abs(value) > 0)) return "0";
  const std::string nearest = rounded(value, digits);
  if (!(number_of(nearest) > value)) return nearest;
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) + 1 - digits);
  return rounded(number_of(nearest) - unit, digits);
}

inline std::string rounded_up(double value, int digits) {
  const std::string down = rounded_down(-value, digits);
  return down == "0" ? down : down[0] == '-' ? down.substr(1) : "-" + down;
}

/// A number with so many digits, at most 20, and an exponent, as "2.1e-03".
std::string with_exponent(double value, int digits);

/// A number with so many decimals, as "0.0021"; in any locale.
std::string fixed(double value, int decimals);

/// A positive number with two digits, and without an exponent.
std::string to_two_digits(double value);

/// A number with so many digits, in TeX, as "$2.1\cdot10^{-3}$".
std::string scientific(double value, int digits);

}  // namespace thermoroll
