// What the unit tests compare with: quadrature and Bessel functions in long double, written from
// their definitions and sharing nothing with src/. Long double has 64 bits here, so an error of a
// few hundred of its epsilon (1e-17) is nothing beside the double precision under test.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace reference {

using Real = long double;

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();
inline constexpr Real pi = 3.14159265358979323846264338327950288L;
inline constexpr Real euler_gamma = 0.57721566490153286060651209008240243L;

/// |actual - expected| <= tolerance; says how far off it is. False for NaN.
inline ::testing::AssertionResult close(Real actual, Real expected, Real tolerance) {
  const Real error = std::abs(actual - expected);
  if (error <= tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << static_cast<double>(actual) << " instead of " << static_cast<double>(expected)
         << ": error " << static_cast<double>(error) << " above " << static_cast<double>(tolerance);
}

/// Integral of f(left, right) over an interval of the given length, by the tanh-sinh rule; left
/// and right are the distances to its ends, both accurate. Reaches rounding error for integrands
/// that are analytic inside and have algebraic or logarithmic ends.
template <class F>
Real integral(F f, Real length, Real step = 1 / 16.0L) {
  Real sum = 0;
  // At t = 4.5 the distance to the end is exp(-141): nothing integrable is left beyond it.
  for (int i = static_cast<int>(-4.5L / step); i * step <= 4.5L; ++i) {
    const Real t = static_cast<Real>(i) * step;
    const Real ratio = std::exp(-pi * std::sinh(std::abs(t)));  // near distance over far one
    const Real near = length * ratio / (1 + ratio), far = length / (1 + ratio);
    const Real weight = pi * std::cosh(t) * ratio / ((1 + ratio) * (1 + ratio));
    sum += weight * (t < 0 ? f(near, far) : f(far, near));
  }
  return length * step * sum;
}

/// Principal value of the integral of f(t)/(t - s) over [points.front(), points.back()], where f
/// may have square-root kinks at the points and is smooth at s, which is none of them.
template <class F>
Real principal_value(F f, const std::vector<Real>& points, Real s) {
  Real radius = points.back() - points.front();
  for (const Real point : points) radius = std::min(radius, std::abs(point - s) / 2);
  // About s, fold: the odd part of 1/(t - s) leaves [f(s+u) - f(s-u)]/u. Below u = 1e-16 it is
  // replaced by 0, which costs 2e-16 f'(s).
  Real sum =
      integral([&](Real u, Real) { return u < 1e-16L ? 0 : (f(s + u) - f(s - u)) / u; }, radius);
  std::vector<Real> ends = points;
  ends.push_back(s - radius);
  ends.push_back(s + radius);
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i - 1] == s - radius) continue;  // the folded part
    const Real start = ends[i - 1];
    sum += integral([&](Real left, Real) { return f(start + left) / (start + left - s); },
                    ends[i] - start);
  }
  return sum;
}

/// Sum of step * f(t) over t = step/2, 3/2 step, ..., until the terms vanish: for even functions
/// that are analytic in a strip, the integral from 0 to infinity to rounding error.
template <class F>
Real half_line(F f, Real step) {
  Real sum = 0, term = 1;
  for (int i = 0; i < 100000 && std::abs(term) > 1e-22L * std::abs(sum); ++i)
    sum += term = f((static_cast<Real>(i) + 0.5L) * step);
  return step * sum;
}

/// 2 sinh^2(t/2) = cosh t - 1 without cancellation.
inline Real cosh_m1(Real t) { return 2 * std::sinh(t / 2) * std::sinh(t / 2); }

/// A step that resolves exp(-x (cosh t - 1)): its error is exp(-pi^2/step) or, for a narrow
/// Gaussian, exp(-2 pi^2/(x step^2)); both are below 1e-21.
inline Real bessel_step(Real x) { return std::min(0.125L, 0.5L / std::sqrt(x)); }

/// e^x K_0(x), x > 0, from its integral.
inline Real K0_scaled(Real x) {
  return half_line([=](Real t) { return std::exp(-x * cosh_m1(t)); }, bessel_step(x));
}

/// e^x K_1(x), x > 0, from its integral.
inline Real K1_scaled(Real x) {
  return half_line([=](Real t) { return std::exp(-x * cosh_m1(t)) * std::cosh(t); },
                   bessel_step(x));
}

/// e^x [K_1(x) - K_0(x)], x > 0, from its integral, without cancellation.
inline Real K1_less_K0_scaled(Real x) {
  return half_line([=](Real t) { return std::exp(-x * cosh_m1(t)) * cosh_m1(t); }, bessel_step(x));
}

/// K_1(x) - 1/x, 0 < x <= 1. As 1/x is the integral of cosh t exp(-x sinh t), the difference is
/// that of cosh t exp(-x sinh t) [exp(-x e^-t) - 1] over t > 0, which does not cancel.
inline Real K1_less_pole(Real x) {
  const auto f = [=](Real t, Real) {
    return std::cosh(t) * std::exp(-x * std::sinh(t)) * std::expm1(-x * std::exp(-t));
  };
  const Real bend = std::asinh(1 / x), end = std::asinh(50 / x);
  return integral(f, bend) + integral([&](Real t, Real) { return f(bend + t, 0); }, end - bend);
}

/// The thermal slope N1, from e^-x I_n(x) as the mean of exp(x (cos t - 1)) cos(n t).
inline Real N1(Real x) {
  if (x <= 0) return 0;
  const auto f = [=](Real t) {
    const Real chord = 2 * std::sin(t / 2) * std::sin(t / 2);  // 1 - cos t
    return std::exp(-x * chord) * chord;
  };
  // Over [0, pi] the midpoint rule is exact to rounding (periodic); for large x the Gaussian is
  // gone long before pi, and any small step will do.
  const Real step = x < 100 ? pi / 64 : 0.5L / std::sqrt(x);
  const Real end = x < 100 ? pi : 12 / std::sqrt(x);
  Real sum = 0;
  for (int i = 0; (static_cast<Real>(i) + 0.5L) * step < end; ++i)
    sum += f((static_cast<Real>(i) + 0.5L) * step);
  return sum * step / pi;
}

/// The thermal strain N2, x != 0, without cancellation but that of its two terms upstream.
inline Real N2(Real zeta) {
  const Real x = std::abs(zeta);
  if (x < 1)
    return std::exp(-zeta) *
               (K0_scaled(x) * std::exp(-x) + std::copysign(1.0L, zeta) * K1_less_pole(x)) +
           std::expm1(-zeta) / zeta;
  if (zeta > 0) return (K0_scaled(x) + K1_scaled(x)) * std::exp(-2 * x) - 1 / x;
  return 1 / x - K1_less_K0_scaled(x);
}

/// e^x K_0(x), x > 0, for many calls: the ascending series up to 2, the integral beyond.
inline Real K0_scaled_fast(Real x) {
  if (x > 2) return K0_scaled(x);
  const Real y = x * x / 4, log = -std::log(x / 2) - euler_gamma;
  Real term = 1, harmonic = 0, sum = log;
  for (int k = 1; k < 20; ++k) {
    term *= y / static_cast<Real>(k * k);
    harmonic += 1 / static_cast<Real>(k);
    sum += term * (log + harmonic);
  }
  return std::exp(x) * sum;
}

/// What the error of N2 is relative to: near its zero, upstream, the larger of its terms is the
/// pole 1/zeta.
inline Real size_of_N2(double zeta, Real value) {
  return zeta > 0.2 && zeta < 0.4 ? 1 / static_cast<Real>(zeta) : std::abs(value);
}

/// 1e-12 to 1e12, the range of the kernels, 100 points a decade.
inline std::vector<double> decades() {
  std::vector<double> x;
  for (int i = -1200; i <= 1200; ++i) x.push_back(std::pow(10, i / 100.0));
  return x;
}

/// The temperature kernel M at the depth eta >= 0.
inline Real M(Real zeta, Real eta = 0) {
  const Real r = eta == 0 ? std::abs(zeta) : std::hypot(zeta, eta);
  const Real decay = zeta < 0 ? eta * eta / (r - zeta) : r + zeta;
  return K0_scaled_fast(r) * std::exp(-decay);
}

}  // namespace reference
