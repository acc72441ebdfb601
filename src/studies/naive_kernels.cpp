// Tangled from paper/16-where-methods-fail.md; edit there.
#include "studies/naive_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_bessel.h>

namespace thermoroll {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// By default GSL ends the program where a function overflows.
[[maybe_unused]] const auto abort_no_more = gsl_set_error_handler_off();

constexpr auto I0 = gsl_sf_bessel_I0, I1 = gsl_sf_bessel_I1;
constexpr auto K0 = gsl_sf_bessel_K0, K1 = gsl_sf_bessel_K1;
constexpr auto I0_scaled = gsl_sf_bessel_I0_scaled, I1_scaled = gsl_sf_bessel_I1_scaled;
constexpr auto K0_scaled = gsl_sf_bessel_K0_scaled, K1_scaled = gsl_sf_bessel_K1_scaled;

}  // namespace

/// As they stand: Bessel functions times an exponential. N1 is meant for zeta > 0.
namespace naive {

double N1(double zeta) { return (I0(zeta) - I1(zeta)) * std::exp(-zeta); }

double N2(double zeta) {
  const double x = std::abs(zeta), sign = std::copysign(1, zeta);
  return -1 / zeta + (K0(x) + K1(x) * sign) * std::exp(-zeta);
}

double M(double zeta) { return K0(std::abs(zeta)) * std::exp(-zeta); }

}  // namespace naive

/// The same with e^-x I(x) and e^x K(x).
namespace naive_scaled {

double N1(double zeta) { return I0_scaled(zeta) - I1_scaled(zeta); }

double N2(double zeta) {
  const double x = std::abs(zeta), sign = std::copysign(1, zeta);
  return -1 / zeta + (K0_scaled(x) + K1_scaled(x) * sign) * std::exp(-x - zeta);
}

double M(double zeta) { return K0_scaled(std::abs(zeta)) * std::exp(-std::abs(zeta) - zeta); }

}  // namespace naive_scaled

double digits_lost(double value, double exact) {
  const double error = std::abs(value / exact - 1);
  return error < 1 ? std::max(0.0, std::log10(error / epsilon)) : -std::log10(epsilon);
}

}  // namespace thermoroll
