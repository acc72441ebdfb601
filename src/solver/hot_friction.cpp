// Tangled from paper/21-hot-friction.md; edit there.
#include "solver/hot_friction.hpp"

#include <algorithm>
#include <cmath>

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

/// Weights of sqrt((1 - t) / (t - c0)) dt, or in full slip of sqrt(1 - t^2) dt, at the slip nodes.
ArrayXd measure(const Nodes& z, const GaussLegendre& rule) {
  if (z.zones.stick == 0) return z.zones.slip * z.zones.slip * z.heat;
  ArrayXd weight(z.y.size());
  for (Index i = 0; i < weight.size(); ++i) {
    const SlipPoint at(1 + z.y(i), 1 - z.y(i), z.zones.variable);
    weight(i) = 6 * at.v * at.v * std::sqrt((1 + 2 * at.u) / (1 + 2 * at.v)) * at.du * rule.w(i);
  }
  return z.zones.slip * weight;
}

MatrixXd lost_friction_matrix(const Nodes& z, const ArrayXd& weight) {
  MatrixXd s = over_distances(z, -weight / pi);
  s.diagonal() = -s.rowwise().sum();
  s.diagonal().array() -= z.zones.stick == 0 ? z.s : ArrayXd::Ones(z.s.size());
  return s;
}

MatrixXd derivative_at_node(const Nodes& z, const GaussLegendre& rule, const ArrayXd& weight) {
  const Index n = z.y.size();
  ArrayXd c = ((1 - z.y.square()) * rule.w).sqrt(), share(n);
  for (Index j = 1; j < n; j += 2) c(j) = -c(j);
  MatrixXd derivative(n, n);
  for (Index j = 0; j < n; ++j) {
    derivative.col(j) = c(j) / (c * (z.y - z.y(j)));
    derivative(j, j) = z.y(j) / (1 - z.y(j) * z.y(j));
    const SlipPoint at(1 + z.y(j), 1 - z.y(j), z.zones.variable);
    share(j) = weight(j) / (pi * z.zones.slip * 6 * at.u * at.v * at.du);
  }
  return share.matrix().asDiagonal() * derivative;
}

HotFriction hot_friction(const Nodes& z, const GaussLegendre& rule) {
  const ArrayXd weight = measure(z, rule);
  ArrayXd arm = z.s + z.zones.slip / 2;  // t + b0
  if (z.zones.stick == 0) arm.setOnes();
  return {lost_friction_matrix(z, weight), derivative_at_node(z, rule, weight), weight,
          arm * weight};
}

const GaussLegendre& rule_for_temperatures(const Scene& scene, const ZoneLengths& zones,
                                           const GridRules& rules) {
  const double more = 16 + 5 * decades_beyond(scene.peclet * zones.slip);
  const double nodes = static_cast<double>(rules.graded.x.size()) + more;
  return rounded_up(4, static_cast<int>(std::min(nodes, most_unknowns + 24.0)));
}

}  // namespace thermoroll
