// Tangled from paper/10-coupled-solver.md; edit there.
#include "fast_kernels.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <Eigen/LU>

#include "kernels.hpp"
#include "scene.hpp"

namespace thermoroll {
namespace {

constexpr int degree = 9;
constexpr int shift = 52 - 3;  // 52 bits of mantissa, the first 3 name one of eight cells

std::uint64_t bits_of(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof x);
  return bits;
}

double double_of(std::uint64_t bits) {
  double x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

using Kernel = double (*)(double);

struct Table {
  explicit Table(Kernel kernel);
  double operator()(double x) const {
    const std::uint64_t bits = bits_of(x), cell = (bits >> shift) - first;
    if (cell >= cells) return exact(x);  // out of the table, or a NaN
    const std::uint64_t inside = bits & ((std::uint64_t{1} << shift) - 1);
    const double u = static_cast<double>(inside) * (2.0 / (std::uint64_t{1} << shift)) - 1;
    const double* c = &coefficients[cell * (degree + 1)];
    double sum = c[degree];
    for (int i = degree - 1; i >= 0; --i) sum = sum * u + c[i];
    return sum;
  }
  Kernel exact;
  std::uint64_t first = bits_of(0x1p-44) >> shift, cells = (bits_of(0x1p+40) >> shift) - first;
  std::vector<double> coefficients;
};

Table::Table(Kernel kernel) : exact(kernel) {
  constexpr int n = degree + 1;
  const Eigen::ArrayXd u = (pi * (Eigen::ArrayXd::LinSpaced(n, 0, degree) + 0.5) / n).cos();
  Eigen::MatrixXd powers(n, n);
  for (int i = 0; i < n; ++i) powers.col(i) = u.pow(i);
  const Eigen::MatrixXd to_powers = powers.inverse();
  for (std::uint64_t cell = first; cell < first + cells; ++cell) {
    const double low = double_of(cell << shift), high = double_of((cell + 1) << shift);
    const Eigen::VectorXd values = ((low + high) / 2 + (high - low) / 2 * u).unaryExpr(exact);
    const Eigen::VectorXd c = to_powers * values;
    coefficients.insert(coefficients.end(), c.begin(), c.end());
  }
}

}  // namespace

SlopeAndStrain fast_slope_and_strain(double zeta) {
  static const Table slope(kernel::N1), up(kernel::N2);
  static const Table down([](double x) { return kernel::N2(-x); });
  return zeta > 0 ? SlopeAndStrain{slope(zeta), up(zeta)} : SlopeAndStrain{0, down(-zeta)};
}

double fast_temperature(double zeta) {
  static const Table scaled([](double x) { return kernel::M(-x); });  // e^x K_0(x)
  return zeta > 0 ? scaled(zeta) * std::exp(-2 * zeta) : scaled(-zeta);
}

}  // namespace thermoroll
