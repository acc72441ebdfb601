// Tangled from paper/12-coupled-problem.md; edit there.
#pragma once

#include <algorithm>

#include <Eigen/Core>

#include "solver/conduction.hpp"
#include "solver/nodes.hpp"

namespace thermoroll {

inline constexpr int node_weights = 5;  // kernels times heat or its derivative, at each node
inline constexpr int hot_weights = 7;   // with those of the temperature, or crossing heat alone
inline constexpr int most_weights = 9;  // of crossing heat, with those of the mirror image
using KernelWeights =
    Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknowns + 24, most_weights>;
using Sums = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_weights, Eigen::Dynamic>;

struct GradedRule {
  GradedArray y, zeta, heat, by_h, by_dh;  // places, Pe (t - s), and the weights of @eq:ray-weights
  /// Keep the first nodes, in groups of eight, up to a zeta that exceeds the first by so much.
  void cut(double reach) {
    const Eigen::Index heard = ((zeta < zeta[0] + reach).count() + 7) / 8 * 8;
    for (GradedArray* x : {&y, &zeta, &heat, &by_h, &by_dh})
      x->conservativeResize(std::min(heard, y.size()));
  }
};

/// Quadrature nodes from the target at y0 to y = 1; left = 1 + y0 and right = 1 - y0. The gap, in
/// lengths of the slip zone, is that of a target in the stick zone, with left = 0. The Péclet
/// number is that of the slip zone, y that of @eq:angles.
void grade(GradedRule& graded, double peclet, double gap, double left, double right,
           const GaussLegendre& rule, const SlipVariable& by = {});

/// N1 with the heat, with h and dh in dg, N2 with the heat, and N2 with the heat of the mirrored
/// rule; if there are seven columns, also M with the heat, and that of the mirrored rule. A row for
/// each node.
void kernel_weights(const Conduction& c, const GradedRule& graded, Eigen::Index columns,
                    KernelWeights& weights);

/// Column l of sums receives the sums of the weights times P_l(y), for all five, seven or nine
/// columns; a multiple of four nodes.
void legendre_sums(const GradedArray& y, const KernelWeights& weights, Sums& sums);

/// From sums with P_l, a column each, to sums with P_l'.
Eigen::MatrixXd by_derivatives(const Eigen::MatrixXd& sums);

/// The sums of c(l) P_l(side y), for a multiple of eight nodes.
GradedArray series(double side, const GradedArray& y, const Eigen::VectorXd& c);

/// The coefficients of the derivative of such a series.
Eigen::VectorXd derivative(const Eigen::VectorXd& c);

}  // namespace thermoroll
