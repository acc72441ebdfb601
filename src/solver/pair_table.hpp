// Tangled from paper/23-unlike-bodies.md, paper/E-fast-kernels.md; edit there.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "model/kernel_table.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// Places u > 0 of exponentials and their weights.
struct Exponentials {
  std::vector<double> u, w;
};

/// The remainders of @eq:pair-kernels, by distance: those of the four kernels in their order, then
/// that of the temperature upstream.
using Remainders = Eigen::Matrix<double, 5, 1>;
using Densities = Eigen::Matrix<double, 3, Eigen::Dynamic>;

struct PairTable {
  explicit PairTable(const Scene& pair, bool crossing = true);  // false: the uniform share

  double peclet, other_peclet, slope_1, slope_2;  // Pe1, Pe2, D1 and D2 K2 / K1
  Exponentials up, down;
  Densities up_density, down_density;
  int first = 0;                         // the number of the first cell
  std::vector<Remainders> coefficients;  // by cell and power
};

/// The remainders of the four kernels at n distances z > 0 in half-widths, and those of the
/// temperature upstream.
void remainders(const PairTable& table, std::size_t n, const double* z, Kernels* all);
void temperatures_upstream(const PairTable& table, std::size_t n, const double* z, double* all);

/// All of them at one distance without the table.
Remainders all_exponentials(const PairTable& table, double z);

}  // namespace thermoroll
