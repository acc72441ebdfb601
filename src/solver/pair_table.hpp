// Tangled from paper/23-unlike-bodies.md, paper/E-fast-kernels.md; edit there.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "thermoroll/scene.hpp"

namespace thermoroll {

/// Places u > 0 of exponentials and their weights.
struct Exponentials {
  std::vector<double> u, w;
};

/// The remainders of @eq:pair-kernels, by distance: the slope, the strain and the temperature
/// upstream, then strain and temperature downstream.
using Remainders = Eigen::Matrix<double, 5, 1>;
using Densities = Eigen::Matrix<double, 3, Eigen::Dynamic>;

struct PairTable {
  explicit PairTable(const Scene& pair, bool crossing = true);  // false: the uniform share
  Remainders operator()(double z) const;

  double peclet, other_peclet, slope_1, slope_2;  // Pe1, Pe2, D1 and D2 K2 / K1
  Exponentials up, down;
  Densities up_density, down_density;
  int first = 0;                         // the number of the first cell
  std::vector<Remainders> coefficients;  // by cell and power
};

/// The remainders at the distance z > 0 in half-widths without the table, for its tests.
Remainders all_exponentials(const PairTable& table, double z);

}  // namespace thermoroll
