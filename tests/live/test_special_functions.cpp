#include <cmath>
#include <limits>

#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>
#include <gtest/gtest.h>

#include "program/live/special_functions.hpp"

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// GSL states its own errors, a few epsilon. The sums have up to 200 terms (K at small x, where
// acosh(40 / x) is up to 30 and the step 0.15) of one sign, each with a few roundings; a rounding
// of an argument up to 40 of exp is 40 epsilon of a term that is e^-40 of the largest.
constexpr double allowed = 100 * epsilon;

TEST(SpecialFunctions, BesselFunctionsAreThoseOfGsl) {
  for (double x = 1e-12; x < 1e5; x *= 1.3) {
    const double k0 = gsl_sf_bessel_K0_scaled(x), k1 = gsl_sf_bessel_K1_scaled(x);
    EXPECT_NEAR(thermoroll::bessel_k_scaled(0, x), k0, allowed * k0) << x;
    EXPECT_NEAR(thermoroll::bessel_k_scaled(1, x), k1, allowed * k1) << x;
    // GSL's scaled I1 leaves e^-x out below 3e-8.
    const double i1 = x < 1 ? std::exp(-x) * gsl_sf_bessel_I1(x) : gsl_sf_bessel_I1_scaled(x);
    const double i0 = gsl_sf_bessel_I0_scaled(x);
    EXPECT_NEAR(thermoroll::bessel_i_scaled(0, x), i0, allowed * i0) << x;
    EXPECT_NEAR(thermoroll::bessel_i_scaled(1, x), i1, allowed * i1) << x;
  }
}

// The recurrence of n steps loses about n epsilon of P_n, whose slope at a zero is at least
// sqrt(2 n / pi) or so; n up to 504, the largest rule of the solver.
TEST(SpecialFunctions, ZerosAreThoseOfGsl) {
  for (const int n : {1, 2, 10, 33, 120, 504}) {
    const auto size = static_cast<std::size_t>(n);
    gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(size);
    for (int i = 0; i < n; ++i) {
      double x = 0, w = 0;
      gsl_integration_glfixed_point(-1, 1, static_cast<std::size_t>(i), &x, &w, table);
      EXPECT_NEAR(thermoroll::legendre_zero(n, i), x, 20 * epsilon) << n << ' ' << i;
    }
    gsl_integration_glfixed_table_free(table);
  }
}

}  // namespace
