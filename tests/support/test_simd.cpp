// Functions of four numbers at a time, against those of the library in long double.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/simd.hpp"

namespace {

using thermoroll::Pack4;

constexpr long double epsilon = std::numeric_limits<double>::epsilon();

// Their arguments have all magnitudes and both signs. The errors are those that the header
// promises, in roundings of half an epsilon.
TEST(Simd, ExponentialsKeepTheirDigits) {
  for (double x = 1e-300; x < 690; x *= x < 1e-17 ? 9.7 : 1.0013) {
    const Pack4 at = {x, -x, x / 3, 1.01 * x};
    Pack4 whole, less, sine;
    thermoroll::exp_of(at, whole);
    thermoroll::exp_less_one(at, less);
    thermoroll::sinh_of(at, sine);
    for (int i = 0; i < 4; ++i) {
      const long double exact = std::expm1(static_cast<long double>(at[i]));
      const long double half = std::sinh(static_cast<long double>(at[i]));
      EXPECT_LE(std::abs(whole[i] / std::exp(static_cast<long double>(at[i])) - 1), epsilon);
      EXPECT_LE(std::abs(less[i] / exact - 1), 1.5L * epsilon) << at[i];
      EXPECT_LE(std::abs(sine[i] / half - 1), 2.5L * epsilon) << at[i];
    }
  }
}

}  // namespace
