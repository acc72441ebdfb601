// Tangled from paper/E-fast-kernels.md; edit there.
#include "model/kernel_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <Eigen/LU>

#include "support/simd.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

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

struct Table {
  Table();
  Kernels operator()(double x) const {
    const std::uint64_t bits = bits_of(x), cell = (bits >> shift) - first;
    if (cell >= cells) return exact(std::max(x, 0x1p-1000));  // out of the table; not 0
    const std::uint64_t inside = bits & ((std::uint64_t{1} << shift) - 1);
    const double u = static_cast<double>(inside) * (2.0 / (std::uint64_t{1} << shift)) - 1;
    const double* c = &coefficients[(cell * (degree + 1) + degree) * 4];
    Pack4 sum, next;
    load(c, sum);
    for (int i = 0; i < degree; ++i) {
      load(c -= 4, next);
      sum = sum * u + next;
    }
    return {sum[0], sum[1], sum[2], sum[3]};
  }
  static Kernels exact(double x) {
    return {kernel::N1(x), kernel::N2(x), kernel::N2(-x), kernel::M(-x)};
  }
  std::uint64_t first = bits_of(0x1p-44) >> shift, cells = (bits_of(0x1p+40) >> shift) - first;
  std::vector<double> coefficients;  // by cell, power and kernel
};

Table::Table() {
  constexpr int n = degree + 1;
  const Eigen::ArrayXd u = (pi * (Eigen::ArrayXd::LinSpaced(n, 0, degree) + 0.5) / n).cos();
  Eigen::MatrixXd powers(n, n), values(n, 4);
  for (int i = 0; i < n; ++i) powers.col(i) = u.pow(i);
  const Eigen::MatrixXd to_powers = powers.inverse();
  for (std::uint64_t cell = first; cell < first + cells; ++cell) {
    const double low = double_of(cell << shift), high = double_of((cell + 1) << shift);
    for (int i = 0; i < n; ++i) {
      const Kernels k = exact((low + high) / 2 + (high - low) / 2 * u(i));
      values.row(i) << k.n1, k.n2_up, k.n2_down, k.m_down;
    }
    const Eigen::Matrix<double, n, 4, Eigen::RowMajor> c = to_powers * values;
    coefficients.insert(coefficients.end(), c.data(), c.data() + c.size());
  }
}

const Table& table() {
  static const Table made;
  return made;
}

}  // namespace

THERMOROLL_CLONES void fast_kernels(std::size_t n, const double* distance, Kernels* k) {
  const Table& look_up = table();
  for (std::size_t i = 0; i < n; ++i) k[i] = look_up(distance[i]);
}

Kernels fast_kernels(double distance) { return table()(distance); }

SlopeAndStrain fast_slope_and_strain(double zeta) {
  const Kernels k = fast_kernels(std::abs(zeta));
  return zeta > 0 ? SlopeAndStrain{k.n1, k.n2_up} : SlopeAndStrain{0, k.n2_down};
}

double fast_temperature(double zeta) {
  if (zeta > 372) return 0;                              // as exp(-2 zeta)
  const double m = fast_kernels(std::abs(zeta)).m_down;  // e^x K_0(x)
  return zeta > 0 ? m * std::exp(-2 * zeta) : m;
}

std::vector<KernelCell> kernel_cells() {
  const Table& of = table();
  std::vector<KernelCell> cells;
  for (std::uint64_t i = 0; i < of.cells; ++i)
    cells.push_back({double_of((of.first + i) << shift), double_of((of.first + i + 1) << shift),
                     &of.coefficients[i * (degree + 1) * 4]});
  return cells;
}

}  // namespace thermoroll
