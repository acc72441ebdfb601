// Tangled from paper/M-certified.md; edit there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/certify/certify.hpp"
#include "model/kernel_table.hpp"

namespace thermoroll::certify {
namespace {

/// Coefficients of powers of u, or of Chebyshev's polynomials.
using Series = std::vector<Ball>;
constexpr int degree = 24;

Series operator+(Series x, const Series& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] + y[i];
  return x;
}

Series operator-(Series x, const Series& y) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] - y[i];
  return x;
}

Series operator*(const Series& x, const Series& y) {
  Series z(x.size(), 0);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; i + j < x.size(); ++j) z[i + j] = z[i + j] + x[i] * y[j];
  return z;
}

Ball sum_of_magnitudes(const Series& x) {
  Ball sum = 0;
  for (const Ball& c : x) sum = sum + magnitude(c);
  return sum;
}

Ball value_at_end(const Series& x) {
  Ball sum = 0;
  for (const Ball& c : x) sum = sum + c;
  return sum;
}

/// The series of A and B about c in u = (x - c) / h, @eq:bessel-pair.
std::pair<Series, Series> bessel_series(double sign, const Ball& a, const Ball& b, double c,
                                        double h) {
  Series first{a}, second{b};
  const Ball tau = Ball(h) / c;
  for (int n = 0; n < degree; ++n) {
    const std::size_t i = static_cast<std::size_t>(n);
    const Ball apart = second[i] - first[i], before = n ? second[i - 1] - first[i - 1] : Ball(0);
    first.push_back(-sign * h * apart / (n + 1));
    second.push_back((sign * h * (apart + tau * before) - (n + 1) * tau * second[i]) / (n + 1));
  }
  return {first, second};
}

std::array<Series, 4> kernel_series(double c, double h) {
  const auto [i0, i1] = bessel_series(-1, scaled_i(0, c), scaled_i(1, c), c, h);
  const auto [k0, k1] = bessel_series(1, scaled_k(0, c), scaled_k(1, c), c, h);
  Series pole{1 / Ball(c)}, decay{exponential(-2 * Ball(c))};
  for (int n = 1; n <= degree; ++n) {
    pole.push_back(-h * pole.back() / c);
    decay.push_back(-2 * h * decay.back() / n);
  }
  return {i0 - i1, decay * (k0 + k1) - pole, pole - (k1 - k0), k0};
}

/// Bounds of the four kernels on the complex disc whose least real part is y > 0.
std::array<Ball, 4> largest_beyond(const Ball& y) {
  const Ball k0 = scaled_k(0, y), k1 = scaled_k(1, y);
  return {scaled_i(0, y) - scaled_i(1, y), exponential(-2 * y) * (k0 + k1) + 1 / y,
          1 / y - (k1 - k0), k0};
}

Series in_chebyshev(const Series& powers) {
  Series sum(powers.size(), 0);
  for (std::size_t n = powers.size(); n-- > 0;) {
    Series next(powers.size(), 0);
    for (std::size_t j = 0; j + 1 < powers.size(); ++j) {
      next[j + 1] = next[j + 1] + sum[j] / 2;
      next[j ? j - 1 : 1] = next[j ? j - 1 : 1] + sum[j] / 2;
    }
    sum = next;
    sum[0] = sum[0] + powers[n];
  }
  return sum;
}

bool near_zero(const KernelCell& cell, bool strain) {
  return strain && cell.high > 0.2 && cell.low < 0.4;
}

Ball magnitude_on(const Series& kernel, const KernelCell& cell, bool strain) {
  if (near_zero(cell, strain)) return 1 / Ball(cell.high);
  const Series t = in_chebyshev(kernel);
  return 2 * magnitude(t[0]) - sum_of_magnitudes(t);
}

/// Relative errors of one kernel on one cell: one that occurs, and a bound.
struct CellErrors {
  double occurs = 0, bound = 0;
};

CellErrors errors_on(const KernelCell& cell, std::size_t kernel, Series off, const Ball& disc) {
  Ball rest = disc / 11 / std::pow(11.9999999, degree);
  const Ball least = magnitude_on(off, cell, kernel == 1) - rest;
  const Ball end = magnitude(value_at_end(off));
  const Ball size = near_zero(cell, kernel == 1) ? least : end + rest;
  for (std::size_t j = 0; j < 10; ++j) {
    const double c = cell.coefficients[4 * j + kernel];
    const double n = static_cast<double>(2 * j + 1) * 0x1p-53;
    off[j] = off[j] - c;
    rest = rest + std::abs(c) * Ball(n) / (1 - Ball(n));
  }
  const Ball most = sum_of_magnitudes(in_chebyshev(off)) + rest;
  return {lower((magnitude(value_at_end(off)) - rest) / size), upper(most / least)};
}

}  // namespace

void certified_tables(const Rows& rows) {
  std::puts("kernel,largest error,radius,library,revision,date");
  bits = 1400;
  const char* const names[] = {"N1", "N2 upstream", "N2 downstream", "M downstream"};
  std::array<CellErrors, 4> most{};
  for (const KernelCell& cell : kernel_cells()) {
    const double c = (cell.low + cell.high) / 2, h = (cell.high - cell.low) / 2;
    const std::array<Series, 4> exact = kernel_series(c, h);
    const std::array<Ball, 4> disc = largest_beyond(c - 12 * h);
    for (std::size_t i = 0; i < 4; ++i) {
      const CellErrors at = errors_on(cell, i, exact[i], disc[i]);
      most[i].occurs = std::max(most[i].occurs, at.occurs);
      most[i].bound = std::max(most[i].bound, at.bound);
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    rows(names[i], between(most[i].occurs, most[i].bound));
  }
}

}  // namespace thermoroll::certify
