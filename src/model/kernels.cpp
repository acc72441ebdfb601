// Tangled from paper/03-kernels.md; edit there.
#include "thermoroll/kernels.hpp"

#include <cmath>
#include <limits>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_bessel.h>

#include "thermoroll/scene.hpp"

namespace thermoroll::kernel {
namespace {

constexpr double euler_gamma = 0.57721566490153286061;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// By default GSL ends the program where a function overflows.
[[maybe_unused]] const auto abort_no_more = gsl_set_error_handler_off();

constexpr double far = 30;  // from here on the series reaches rounding error

/// S(y) of @eq:tail-series, |y| <= 1/far.
double tail(double y) {
  double term = 0.5, sum = term;
  for (int k = 1; std::abs(term) > epsilon * std::abs(sum); ++k) {
    term *= y * (4.0 * k * k - 1) / (8.0 * k);
    sum += term;
  }
  return sum;
}

/// K_1(x) - 1/x, @eq:K1-regular; 0 < x <= 1.
double K1_regular(double x) {
  const double log_half = std::log(x / 2);
  double term = 1, psi_sum = 1 - 2 * euler_gamma, sum = log_half - psi_sum / 2;
  for (int k = 1; term > epsilon; ++k) {
    term *= x * x / (4.0 * k * (k + 1));
    psi_sum += 1.0 / k + 1.0 / (k + 1);
    sum += term * (log_half - psi_sum / 2);
  }
  return x / 2 * sum;
}

}  // namespace

double M(double zeta, double eta) {
  const double r = std::hypot(zeta, eta);
  const double decay = zeta < 0 ? eta * eta / (r - zeta) : r + zeta;
  return gsl_sf_bessel_K0_scaled(r) * std::exp(-decay);
}

double N1(double zeta) {
  if (!(zeta > 0)) return 0;
  if (zeta < epsilon) return 1;
  if (zeta < far) return gsl_sf_bessel_I0_scaled(zeta) - gsl_sf_bessel_I1_scaled(zeta);
  return tail(1 / zeta) / (zeta * std::sqrt(2 * pi * zeta));
}

double N2(double zeta) {
  const double x = std::abs(zeta);
  if (x < 1) {
    const double bracket = gsl_sf_bessel_K0(x) + std::copysign(1, zeta) * K1_regular(x);
    return std::exp(-zeta) * bracket + std::expm1(-zeta) / zeta;
  }
  if (zeta > 0) {
    const double sum = gsl_sf_bessel_K0_scaled(x) + gsl_sf_bessel_K1_scaled(x);
    return std::exp(-2 * x) * sum - 1 / x;
  }
  if (x < far) return 1 / x - (gsl_sf_bessel_K1_scaled(x) - gsl_sf_bessel_K0_scaled(x));
  return (1 - tail(-1 / x) * std::sqrt(pi / (2 * x))) / x;
}

double N(double zeta, double friction, Formulation formulation) {
  return N2(zeta) / pi - slope_sign(formulation) * friction * N1(zeta);
}

}  // namespace thermoroll::kernel
