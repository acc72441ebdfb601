// Tangled from paper/J-live-page.md; edit there.
#pragma once

#include <cmath>

namespace thermoroll {

inline constexpr double half_turn = 3.14159265358979323846;

/// e^x K0(x), or e^x K1(x), for x > 0, @eq:bessel-k.
inline double bessel_k_scaled(int order, double x) {
  const double step = std::fmin(0.15, 0.55 / std::sqrt(x)), end = std::acosh(1 + 40 / x);
  double sum = 0.5;
  for (double t = step; t < end; t += step) {
    const double half = std::sinh(t / 2), height = 2 * half * half;
    sum += std::exp(-x * height) * (order == 0 ? 1 : 1 + height);
  }
  return step * sum;
}

/// e^-x I0(x), or e^-x I1(x), for x >= 0, @eq:bessel-i.
inline double bessel_i_scaled(int order, double x) {
  const int n = 16 + static_cast<int>(6 * std::sqrt(x));
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double theta = half_turn * (i + 0.5) / n;
    const double half = std::sin(theta / 2), whole = std::sin(theta);
    sum += std::exp(-2 * x * half * half) * (order == 0 ? 1 : x * whole * whole);
  }
  return sum / n;
}

/// The i-th zero of P_n from the left, 0 <= i < n.
inline double legendre_zero(int n, int i) {
  double x = -std::cos(half_turn * (i + 0.75) / (n + 0.5));
  for (int step = 0; step < 6; ++step) {
    double p = 1, before = 0;
    for (int l = 0; l < n; ++l) {
      const double next = ((2 * l + 1) * x * p - l * before) / (l + 1);
      before = p;
      p = next;
    }
    x -= p * (x * x - 1) / (n * (x * p - before));
  }
  return x;
}

}  // namespace thermoroll
