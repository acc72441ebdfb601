// Tangled from paper/12-coupled-problem.md; edit there.
#pragma once

#include <Eigen/Core>

namespace thermoroll {

/// No grid has more unknowns, and no graded rule more nodes than 24 beyond it.
constexpr int most_unknowns = 480;

/// Gauss-Legendre nodes x and weights w on (-1, 1), and the values p of P_0 ... P_{n-1} at them;
/// for graded rules, rho = (1 + x) / 2 and its cube.
struct GaussLegendre {
  Eigen::ArrayXd x, w, rho, cube;
  Eigen::MatrixXd p;
};

/// The rule of n >= 0 nodes; made once per thread.
const GaussLegendre& gauss_legendre(int n);

/// P_0 ... P_{n-1} at x, a column each.
Eigen::MatrixXd legendre(const Eigen::ArrayXd& x, Eigen::Index n);

/// From values at the nodes to Legendre coefficients, an n x n matrix.
Eigen::MatrixXd to_legendre(const GaussLegendre& rule);

}  // namespace thermoroll
