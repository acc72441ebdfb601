// Tangled from paper/12-speed-and-accuracy.md; edit there.
#include "studies/cached_scheme.hpp"

#include <cmath>

#include <Eigen/LU>

#include "model/kernel_table.hpp"
#include "solver/nested_iteration.hpp"

namespace thermoroll {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double slope_twice(double zeta) {
  if (zeta <= 0) return 0;
  const double n1 = fast_slope_and_strain(zeta).n1;
  const double n2 = fast_slope_and_strain(-zeta).n2, m = fast_temperature(-zeta);
  return zeta * (1 + n1 - 2 * (1 + zeta * n1 * m) / (1 + zeta * (2 * m - n2)));
}

double strain_twice(double zeta) {
  if (zeta == 0) return 0;
  const double n2 = fast_slope_and_strain(zeta).n2, m = fast_temperature(zeta);
  return zeta * (1 - std::log(std::abs(zeta)) - 2 * m + n2);
}

double temperature_twice(double zeta) {
  if (zeta == 0) return 0;
  const double n2 = fast_slope_and_strain(zeta).n2, m = fast_temperature(zeta);
  return zeta / 3 * (1 + 2 * zeta * (2 * m - n2) + n2 - m);
}

/// Means under the hats of the inner knots, all given as zeta = Pe (t - s), descending, of the
/// kernel whose second antiderivative is given.
ArrayXd under_hats(const ArrayXd& zeta, double (*twice)(double)) {
  const Index n = zeta.size() - 2;
  const ArrayXd b = zeta.unaryExpr(twice), length = zeta.head(n + 1) - zeta.tail(n + 1);
  const ArrayXd slope = (b.head(n + 1) - b.tail(n + 1)) / length;
  return 2 * (slope.head(n) - slope.tail(n)) / (length.head(n) + length.tail(n));
}

/// N1 and N2 from each of the first nodes at a point.
struct KernelRow {
  ArrayXd n1, n2;
};

KernelRow sampled(const Grid& g, double peclet, double s, Index count) {
  KernelRow row{ArrayXd::Zero(count), ArrayXd::Zero(count)};
  for (Index k = 0; k < count; ++k)
    if (const double zeta = peclet * (g.t(k) - s); zeta != 0) {
      const auto [n1, n2] = fast_slope_and_strain(zeta);
      row.n1(k) = n1, row.n2(k) = n2;
    }
  return row;
}

/// Pe (t - s) for the first nodes and their neighbours, the ends of the contact among them.
ArrayXd knots(const Grid& g, double peclet, double s, Index count) {
  ArrayXd t(g.t.size() + 2);
  t << 1, g.t, -1;
  return peclet * (t.head(count + 2) - s);
}

KernelRow averaged(const Grid& g, double peclet, double s, Index count) {
  const ArrayXd zeta = knots(g, peclet, s, count);
  return {under_hats(zeta, slope_twice), under_hats(zeta, strain_twice)};
}

struct Kept {
  Scene scene;
  double traction;
  Formulation formulation;
  KernelRow (*row)(const Grid&, double peclet, double s, Index count);
  MatrixXd normal;                      // of the normal system without heat
  MatrixXd slope;                       // eps f Pe H N1 from every node at every collocation point
  MatrixXd strain;                      // f Pe H N from node to node
  Eigen::PartialPivLU<MatrixXd> stick;  // of the stick system
  VectorXd solved_for;                  // the hot slip of the last normal system
};

/// f Pe H N from each of the first nodes at the point s, @eq:N.
ArrayXd strain_row(const Kept& kept, const Grid& g, double s, Index count) {
  const auto& [friction, peclet, heating] = kept.scene;
  const auto [n1, n2] = kept.row(g, peclet, s, count);
  return friction * peclet * heating * (n2 / pi - slope_sign(kept.formulation) * friction * n1);
}

Kept keep(const Scene& scene, double traction, Formulation formulation, NodeKernel kernel,
          const Grid& g) {
  const Index n = g.t.size();
  const double strength = slope_sign(formulation) * scene.friction * scene.peclet * scene.heating;
  MatrixXd normal(n + 2, n + 2), stick(n + 1, n + 1);
  normal << cauchy_matrix(g), VectorXd::Ones(n + 1), 2 / pi * g.s, g.w.transpose(), 0, 0;
  stick << cauchy_matrix(g), VectorXd::Constant(n + 1, -1);
  const auto row = kernel == NodeKernel::sample ? sampled : averaged;
  MatrixXd slope(n + 1, n), strain(n, n);
  Kept kept{scene, traction, formulation, row, normal, slope, strain, stick.partialPivLu(), {}};
  for (Index m = 0; m <= n; ++m)
    kept.slope.row(m) = strength * row(g, scene.peclet, g.s(m), n).n1.transpose();
  for (Index j = 0; j < n; ++j) kept.strain.row(j) = strain_row(kept, g, g.t(j), n).transpose();
  return kept;
}

Index hot_nodes(const PrintedSolution& x) { return (x.grid.t.array() > x.c0).count(); }

void solve_normal(Kept& kept, PrintedSolution& x) {
  const VectorXd slip = hot_slip(x);
  if (kept.solved_for.size() > 0 && slip == kept.solved_for) return;
  kept.solved_for = slip;
  const Index n = slip.size();
  MatrixXd a = kept.normal;
  a.topLeftCorner(n + 1, n) += kept.slope * slip.asDiagonal();
  const VectorXd unknown = a.partialPivLu().solve(VectorXd::Unit(n + 2, n + 1));
  x.phi = unknown.head(n);
  x.gamma0 = unknown(n);
  x.load_ratio = unknown(n + 1);
}

void solve_stick(const Kept& kept, PrintedSolution& x) {
  const Index n = x.grid.t.size(), hot = hot_nodes(x);
  const VectorXd heat = node_heat(x).head(hot);
  VectorXd right = (1 + x.c0) / 2 * x.grid.s.array() - (1 - x.c0) / 2;
  for (double& s : right)
    s = 2 * kept.scene.friction / pi * x.load_ratio * s -
        strain_row(kept, x.grid, s, hot).matrix().dot(heat);
  const VectorXd unknown = kept.stick.solve(right);
  x.phi0 = unknown.head(n);
  x.creep_constant = unknown(n);
}

VectorXd slip_velocity(const Kept& kept, const PrintedSolution& x) {
  const auto& [t, w, s] = x.grid;
  const Index hot = hot_nodes(x);
  const VectorXd mass = w.cwiseProduct(x.phi0) / pi;
  VectorXd v = VectorXd::Zero(t.size());
  const double slope = 2 * kept.scene.friction / pi * x.load_ratio;
  v.head(hot) = x.creep_constant + slope * t.head(hot).array();
  v.head(hot) -= kept.strain.topLeftCorner(hot, hot) * node_heat(x).head(hot);
  for (Index j = 0; j < hot; ++j) {
    const double tau = (2 * t(j) + 1 - x.c0) / (1 + x.c0);
    v(j) -= (mass.array() / (t.array() - tau)).sum();
  }
  return v;
}

}  // namespace

PrintedSolution solve_thrifty(const Scene& scene, double traction, Formulation formulation,
                              NodeKernel kernel, const PrintedOptions& options) {
  require(options.heaviside_at_zero == 0, "heaviside_at_zero", options.heaviside_at_zero, "zero");
  PrintedSolution x = before_iterating(scene, traction, options);
  Kept kept = keep(scene, traction, formulation, kernel, x.grid);
  iterate(kept, x, options);
  return x;
}

PrintedPeak thrifty_max_temperature(const PrintedSolution& x, double peclet, NodeKernel kernel) {
  const Index hot = hot_nodes(x);
  const ArrayXd heat = node_heat(x).head(hot);
  PrintedPeak peak{0, 0};
  for (const double s : x.grid.s) {
    const ArrayXd zeta = knots(x.grid, peclet, s, hot);
    const ArrayXd m = kernel == NodeKernel::mean
                          ? under_hats(zeta, temperature_twice)
                          : zeta.segment(1, hot).unaryExpr(&fast_temperature);
    if (const double value = (m * heat).sum() / pi; value > peak.temperature) peak = {s, value};
  }
  return peak;
}

}  // namespace thermoroll
