// Tangled from paper/15-speed-and-accuracy.md; edit there.
#include "studies/cached_scheme.hpp"

#include <cmath>

#include "model/kernel_table.hpp"
#include "solver/linear_system.hpp"
#include "solver/nested_iteration.hpp"

namespace thermoroll {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// N1 and N2 from each of the first nodes at a point.
struct KernelRow {
  ArrayXd n1, n2;
};

KernelRow sampled(const Grid& g, double peclet, double s, Index count) {
  KernelRow row{ArrayXd::Zero(count), ArrayXd::Zero(count)};
  for (Index k = 0; k < count; ++k)
    if (const double zeta = peclet * (g.t(k) - s); zeta != 0) {
      const auto [n1, n2] = fast_slope_and_strain(zeta);
      row.n1(k) = n1;
      row.n2(k) = n2;
    }
  return row;
}

/// Means under the hats of the inner knots, all given as zeta = Pe (t - s), descending, of the
/// kernel whose second antiderivative is given.
ArrayXd under_hats(const ArrayXd& zeta, double (*twice)(double)) {
  const Index n = zeta.size() - 2;
  const ArrayXd b = zeta.unaryExpr(twice), length = zeta.head(n + 1) - zeta.tail(n + 1);
  const ArrayXd slope = (b.head(n + 1) - b.tail(n + 1)) / length;
  return 2 * (slope.head(n) - slope.tail(n)) / (length.head(n) + length.tail(n));
}

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

struct CachedProblem {
  Scene scene;
  double traction;
  Formulation formulation;
  KernelRow (*row)(const Grid&, double peclet, double s, Index count);
  MatrixXd normal;  // of the normal system without heat
  MatrixXd slope;   // sigma_N f Pe H N1 from every node at every collocation point
  MatrixXd strain;  // f Pe H N from node to node
  Eigen::PartialPivLU<MatrixXd> stick;  // of the stick system
  VectorXd solved_for;                  // the hot slip of the last normal system
};

/// f Pe H N from each of the first nodes at the point s, @eq:N.
ArrayXd strain_row(const CachedProblem& cached, const Grid& g, double s, Index count) {
  const double friction = cached.scene.friction, peclet = cached.scene.peclet;
  const double heating = cached.scene.heating;
  const auto [n1, n2] = cached.row(g, peclet, s, count);
  return friction * peclet * heating * (n2 / pi - slope_sign(cached.formulation) * friction * n1);
}

CachedProblem cache(const Scene& scene, double traction, Formulation formulation, NodeKernel kernel,
                    const Grid& g) {
  const Index n = g.t.size();
  const double strength = slope_sign(formulation) * scene.friction * scene.peclet * scene.heating;
  MatrixXd normal(n + 2, n + 2), stick(n + 1, n + 1);
  normal << cauchy_matrix(g), VectorXd::Ones(n + 1), 2 / pi * g.s, g.w.transpose(), 0, 0;
  stick << cauchy_matrix(g), VectorXd::Constant(n + 1, -1);
  const auto row = kernel == NodeKernel::sample ? sampled : averaged;
  MatrixXd slope(n + 1, n), strain(n, n);
  const auto factors = factors_of(stick);
  CachedProblem cached{scene, traction, formulation, row, normal, slope, strain, factors, {}};
  for (Index m = 0; m <= n; ++m)
    cached.slope.row(m) = strength * row(g, scene.peclet, g.s(m), n).n1.transpose();
  for (Index j = 0; j < n; ++j) cached.strain.row(j) = strain_row(cached, g, g.t(j), n).transpose();
  return cached;
}

void solve_normal(CachedProblem& cached, PublishedSolution& solution) {
  const VectorXd slip = hot_slip(solution);
  if (cached.solved_for.size() > 0 && slip == cached.solved_for) return;
  cached.solved_for = slip;
  const Index n = slip.size();
  MatrixXd a = cached.normal;
  a.topLeftCorner(n + 1, n) += cached.slope * slip.asDiagonal();
  const VectorXd unknown = solve(a, VectorXd::Unit(n + 2, n + 1));
  solution.phi = unknown.head(n);
  solution.gamma0 = unknown(n);
  solution.load_ratio = unknown(n + 1);
}

Index hot_nodes(const PublishedSolution& solution) {
  return (solution.grid.t.array() > solution.c0).count();
}

void solve_stick(const CachedProblem& cached, PublishedSolution& solution) {
  const Index n = solution.grid.t.size(), hot = hot_nodes(solution);
  const VectorXd heat = node_heat(solution).head(hot);
  VectorXd right = (1 + solution.c0) / 2 * solution.grid.s.array() - (1 - solution.c0) / 2;
  for (double& s : right)
    s = 2 * cached.scene.friction / pi * solution.load_ratio * s -
        strain_row(cached, solution.grid, s, hot).matrix().dot(heat);
  const VectorXd unknown = solve(cached.stick, right);
  solution.phi0 = unknown.head(n);
  solution.creep_constant = unknown(n);
}

VectorXd slip_velocity(const CachedProblem& cached, const PublishedSolution& solution) {
  const auto& [t, w, s] = solution.grid;
  const Index hot = hot_nodes(solution);
  const VectorXd mass = w.cwiseProduct(solution.phi0) / pi;
  VectorXd v = VectorXd::Zero(t.size());
  const double slope = 2 * cached.scene.friction / pi * solution.load_ratio;
  v.head(hot) = solution.creep_constant + slope * t.head(hot).array();
  v.head(hot) -= cached.strain.topLeftCorner(hot, hot) * node_heat(solution).head(hot);
  for (Index j = 0; j < hot; ++j) {
    const double tau = (2 * t(j) + 1 - solution.c0) / (1 + solution.c0);
    v(j) -= (mass.array() / (t.array() - tau)).sum();
  }
  return v;
}

}  // namespace

PublishedSolution solve_cached(const Scene& scene, double traction, Formulation formulation,
                               NodeKernel kernel, const PublishedOptions& options) {
  require(options.heaviside_at_zero == 0, "heaviside_at_zero", options.heaviside_at_zero, "zero");
  PublishedSolution solution = before_iterating(scene, traction, options);
  CachedProblem cached = cache(scene, traction, formulation, kernel, solution.grid);
  iterate(cached, solution, options);
  return solution;
}

PublishedPeak cached_max_temperature(const PublishedSolution& solution, double peclet,
                                     NodeKernel kernel) {
  const Index hot = hot_nodes(solution);
  const ArrayXd heat = node_heat(solution).head(hot);
  PublishedPeak peak{0, 0};
  for (const double s : solution.grid.s) {
    const ArrayXd zeta = knots(solution.grid, peclet, s, hot);
    const ArrayXd m = kernel == NodeKernel::mean
                          ? under_hats(zeta, temperature_twice)
                          : zeta.segment(1, hot).unaryExpr(&fast_temperature);
    if (const double value = (m * heat).sum() / pi; value > peak.temperature) peak = {s, value};
  }
  return peak;
}

}  // namespace thermoroll
