// Numbers as text, read back.
#include <cmath>
#include <cstdio>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/number_text.hpp"

using thermoroll::fixed;
using thermoroll::rounded;
using thermoroll::rounded_down;
using thermoroll::rounded_up;
using thermoroll::scientific;
using thermoroll::shortest;
using thermoroll::with_exponent;

// The shortest text is read back unchanged; fixed decimals are off by half of the last at most.
TEST(NumberText, IsReadBack) {
  for (const double x : {0.1, 1e-300, 2.5, 1 / 3.0, 4360.714285714286, 1e22, 0.0}) {
    EXPECT_EQ(std::stod(shortest(x)), x);
    EXPECT_EQ(shortest(-x), "-" + shortest(x));
  }
  for (int decimals = 0; decimals < 9; ++decimals) {
    const std::string text = fixed(2 / 3.0, decimals);
    EXPECT_NEAR(std::stod(text), 2 / 3.0, 0.5 * std::pow(10, -decimals));
    EXPECT_EQ(text.size(), decimals == 0 ? 1U : 2U + static_cast<unsigned>(decimals));
  }
}

// As printf has them in English.
TEST(NumberText, RoundsAsPrintf) {
  for (const double x : {0.1, 0.65432, 1e-300, -2.5, 1234567.0, 9.996e8, 0.0})
    for (const int digits : {1, 2, 3, 4, 20}) {
      char text[60];
      std::snprintf(text, sizeof text, "%.*g", digits, x);
      EXPECT_EQ(rounded(x, digits), text);
      std::snprintf(text, sizeof text, "%.*e", digits - 1, x);
      EXPECT_EQ(with_exponent(x, digits), text);
    }
}

// A program may set the decimals and groups of its user's language for all streams.
TEST(NumberText, SameInEveryLocale) {
  struct German : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const auto texts = [] {
    return std::vector{shortest(1234.5), rounded(1234.5, 5), fixed(1234.5, 1),
                       with_exponent(1234.5, 2), scientific(1234.5, 2)};
  };
  const auto by_stream = [] {
    std::ostringstream stream;
    stream << 1234.5;
    return stream.str();
  };
  const std::vector<std::string> expected = texts();
  const std::locale before = std::locale::global(std::locale(std::locale(), new German));
  const std::vector<std::string> found = texts();
  const std::string german = by_stream();
  std::locale::global(before);
  EXPECT_EQ(german, "1.234,5");
  EXPECT_EQ(found, expected);
}

// A number rounded down is not above it, one rounded up not below it, and both are within a unit of
// the last digit.
TEST(NumberText, RoundedToASide) {
  const double below = std::nextafter(6.889152, 0);  // a unit of rounding below a short number
  for (const double x : {0.39776468, 1.0, 2e-7, 123456.7, 9.99999999, 1e12 / 3, 0.3, below})
    for (const double value : {x, -x}) {
      const double low = std::stod(rounded_down(value, 4)), high = std::stod(rounded_up(value, 4));
      const double unit = std::pow(10, std::floor(std::log10(x)) - 3);
      EXPECT_LE(low, value);
      EXPECT_GE(high, value);
      EXPECT_LE(high - low, 1.001 * unit) << value;
    }
  EXPECT_EQ(rounded_down(0.39776468, 6) + ' ' + rounded_up(-0.39776468, 6), "0.397764 -0.397764");
  EXPECT_EQ(rounded_up(-0.0, 6) + rounded_down(-0.0, 6), "00");
  EXPECT_LT(std::stod(rounded_down(below, 7)), 6.889152);
  EXPECT_EQ(rounded_down(0.3, 1), "0.3");
}

// In TeX a number has one digit before its point and the exponent that goes with that: mantissa and
// power make up the number, to half of the last digit. A mantissa that rounds to ten is none.
TEST(NumberText, ScientificHasOneDigitBeforeThePoint) {
  for (const double x : {1.0, 1.2e-3, 9.4, 9.94, 9.97e-3, 99.99999, 2.3e17, 4.56e-290, 7.0, 0.03})
    for (const double sign : {-1.0, 1.0})
      for (const int digits : {1, 2, 4}) {
        const std::string text = scientific(sign * x, digits);
        double mantissa = 0;
        int exponent = 0, end = 0;
        ASSERT_EQ(std::sscanf(text.c_str(), "$%lf\\cdot10^{%d}$%n", &mantissa, &exponent, &end), 2)
            << text;
        EXPECT_EQ(static_cast<std::size_t>(end), text.size()) << text;
        const std::string written = fixed(mantissa, digits - 1);
        EXPECT_EQ(text.substr(1, written.size()), written) << "so many digits: " << text;
        EXPECT_GE(sign * mantissa, 1) << text;
        EXPECT_LT(sign * mantissa, 10) << text;
        EXPECT_NEAR(mantissa * std::pow(10, exponent) / (sign * x), 1,
                    0.5 * std::pow(10, 1 - digits))
            << text;
      }
  EXPECT_EQ(scientific(0, 3), "0");
}
