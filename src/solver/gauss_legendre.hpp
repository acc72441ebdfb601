// Tangled from paper/12-coupled-problem.md; edit there.
#pragma once

#include <Eigen/Core>

namespace thermoroll {

/// No grid has more unknowns, and no graded rule more nodes than 24 beyond it.
constexpr int most_unknowns = 480;

/// Gauss-Legendre nodes x and weights w on (-1, 1), and the values p of P_0 ... P_{n-1} at them;
/// for graded rules, rho = (1 + x) / 2, its cube, and the weights of d rho^3.
struct GaussLegendre {
  Eigen::ArrayXd x, w, rho, cube, dcube;
  Eigen::MatrixXd p;
};

/// A number for each node of a graded rule.
using GradedArray = Eigen::Array<double, Eigen::Dynamic, 1, 0, most_unknowns + 24, 1>;

/// The rule of n >= 0 nodes, made once; and without the polynomials, most of its memory.
const GaussLegendre& gauss_legendre(int n);
const GaussLegendre& quadrature_rule(int n);

/// P_0 ... P_{n-1} at x, a column each.
Eigen::MatrixXd legendre(const Eigen::ArrayXd& x, Eigen::Index n);

/// From values at the nodes to Legendre coefficients, an n x n matrix.
Eigen::MatrixXd to_legendre(const GaussLegendre& rule);

/// Its product with some values.
Eigen::VectorXd to_legendre(const GaussLegendre& rule, const Eigen::VectorXd& values);

/// tau: the last quarter of coefficients, relative to the largest; 0 if all are 0.
double tail(const Eigen::VectorXd& coefficients);

}  // namespace thermoroll
