// Tangled from paper/21-hot-friction.md; edit there.
#include "solver/hot_friction.hpp"

#include <cmath>
#include <vector>

#include "solver/exchange.hpp"
#include "solver/graded_rule.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;

/// Weights of sqrt((1 - t) / (t - c0)) dt, or in full slip of sqrt(1 - t^2) dt, at the slip nodes.
ArrayXd measure(const Nodes& z, const GaussLegendre& rule) {
  if (z.zones.stick == 0) return z.zones.slip * z.zones.slip * z.heat;
  ArrayXd weight(z.y.size());
  for (Index i = 0; i < weight.size(); ++i) {
    const SlipPoint at(1 + z.y(i), 1 - z.y(i));
    weight(i) = 6 * at.v * at.v * std::sqrt((1 + 2 * at.u) / (1 + 2 * at.v)) * at.du * rule.w(i);
  }
  return z.zones.slip * weight;
}

MatrixXd lost_friction_matrix(const Nodes& z, const ArrayXd& weight) {
  const Index n = z.y.size();
  MatrixXd s(n, n);
  for (Index i = 0; i < n; ++i) {
    const SlipPoint at(1 + z.y(i), 1 - z.y(i));
    for (Index j = 0; j < n; ++j) {
      const SlipPoint to(1 + z.y(j), 1 - z.y(j));
      s(i, j) = j == i ? 0 : weight(j) / (z.zones.slip * t_difference(at, to, to.y - at.y));
    }
    s(i, i) = -s.row(i).sum();
  }
  s /= pi;
  s.diagonal().array() -= z.zones.stick == 0 ? z.s : ArrayXd::Ones(n);
  return s;
}

MatrixXd derivative_at_node(const Nodes& z, const GaussLegendre& rule, const ArrayXd& weight) {
  ArrayXd share(z.y.size());
  for (Index i = 0; i < share.size(); ++i) {
    const SlipPoint at(1 + z.y(i), 1 - z.y(i));
    share(i) = weight(i) / (pi * z.zones.slip * 6 * at.u * at.v * at.du);
  }
  return share.matrix().asDiagonal() * by_derivatives(rule.p) * to_legendre(rule);
}

MatrixXd temperature_matrix(const Scene& scene, const Nodes& z, const GaussLegendre& rule,
                            Index terms) {
  const Index n = z.y.size(), m = z.d.size();
  const Conduction conduction(scene, !exchanges(scene, z.zones));
  const double slip = z.zones.slip, peclet = conduction.peclet * slip;
  MatrixXd t = MatrixXd::Zero(n + m, terms);
  RowVectorXd mirror = RowVectorXd::Ones(terms);
  for (Index l = 1; l < terms; l += 2) mirror(l) = -1;
  GradedRule graded;
  Sums sums(node_weights, terms);
  for (Index i = 0; i < n; ++i) {
    grade(graded, peclet, 0, 1 + z.y(i), 1 - z.y(i), rule);
    KernelWeights weights = KernelWeights::Zero(graded.y.size(), node_weights);
    const std::vector<Kernels> kernels = at_distances(conduction, graded.zeta);
    for (Index k = 0; k < graded.y.size(); ++k) {
      const double downstream = kernels[static_cast<std::size_t>(k)].m_down * graded.heat(k);
      weights(k, 0) = downstream * upstream_share(conduction, graded.zeta(k));
      weights(k, 1) = downstream;
    }
    legendre_sums(graded.y, weights, sums);
    t.row(i) += sums.row(0);
    t.row(n - 1 - i) += sums.row(1).cwiseProduct(mirror);
  }
  if (m > 0) {
    const ArrayXd gap = z.d / slip, further = peclet * (gap - gap.minCoeff());
    grade(graded, peclet, gap.minCoeff(), 0, 2, rule);
    MatrixXd kernel(m, graded.y.size());
    for (Index k = 0; k < graded.y.size(); ++k) {
      const ArrayXd zeta = graded.zeta(k) + further;
      const std::vector<Kernels> kernels = at_distances(conduction, zeta);
      for (Index j = 0; j < m; ++j)
        kernel(j, k) =
            kernels[static_cast<std::size_t>(j)].m_down * upstream_share(conduction, zeta(j));
    }
    t.bottomRows(m) = kernel * graded.heat.matrix().asDiagonal() * legendre(graded.y, terms);
  }
  return heat_share(scene) * slip * slip / pi * t;
}

HotFriction hot_friction(const Scene& scene, const Nodes& z, const GridRules& rules, Index terms) {
  const double more = 8 + 5 * decades_beyond(scene.peclet * z.zones.slip);
  const auto nodes = static_cast<int>(static_cast<double>(rules.graded.x.size()) + more);
  const ArrayXd weight = measure(z, rules.slip);
  ArrayXd arm = z.s + z.zones.slip / 2;  // t + b0
  if (z.zones.stick == 0) arm.setOnes();
  return {temperature_matrix(scene, z, rounded_up(4, nodes), terms),
          lost_friction_matrix(z, weight), derivative_at_node(z, rules.slip, weight), weight,
          arm * weight};
}

}  // namespace thermoroll
