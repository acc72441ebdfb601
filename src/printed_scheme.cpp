// Tangled from paper/07-printed-scheme.md; edit there.
#include "printed_scheme.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "carter.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Grid gauss_chebyshev(int n) {
  const double h = pi / (n + 1);
  const ArrayXd node = h * ArrayXd::LinSpaced(n, 1, n);
  const ArrayXd point = h * ArrayXd::LinSpaced(n + 1, 0.5, n + 0.5);
  return {node.cos(), h * node.sin().square(), point.cos()};
}

MatrixXd cauchy_matrix(const Grid& g) {
  const Index n = g.t.size();
  const auto distance = g.t.transpose().replicate(n + 1, 1) - g.s.replicate(1, n);
  return g.w.transpose().replicate(n + 1, 1).cwiseQuotient(distance) / pi;
}

namespace {

/// w_k v*(t_k) at the hot nodes, zero at the others.
VectorXd hot_slip(const PrintedSolution& x) {
  return (x.grid.t.array() > x.c0).select(x.grid.w.cwiseProduct(x.slip), 0);
}

/// What stays fixed while the iterations run.
struct Problem {
  Scene scene;
  Formulation formulation;
  MatrixXd cauchy, slope;
  double coincident;  // what stands for N* at a coincident node
};

/// eps f Pe H N1*(t_k - s_m), row m, column k.
MatrixXd slope_matrix(const Scene& scene, Formulation formulation, const Grid& g) {
  MatrixXd n1(g.s.size(), g.t.size());
  for (Index k = 0; k < n1.cols(); ++k)
    for (Index m = 0; m < n1.rows(); ++m) n1(m, k) = kernel::N1(scene.peclet * (g.t(k) - g.s(m)));
  return slope_sign(formulation) * scene.friction * scene.peclet * scene.heating * n1;
}

/// (2f/pi) kappa s - f Pe H sum_k N*(t_k - s) g_k.
double rigid_strain(const Problem& problem, const PrintedSolution& x, double s) {
  const auto& [friction, traction, peclet, heating] = problem.scene;
  const VectorXd heat = node_heat(x);
  double sum = 0;
  for (Index k = 0; k < heat.size() && x.grid.t(k) > x.c0; ++k) {
    const double z = peclet * (x.grid.t(k) - s);
    sum += heat(k) * (z == 0 ? problem.coincident : kernel::N(z, friction, problem.formulation));
  }
  return 2 * friction / pi * x.load_ratio * s - friction * peclet * heating * sum;
}

/// Solve @eq:discrete-normal and @eq:discrete-load for phi, gamma0 and kappa.
void solve_normal(const Problem& problem, PrintedSolution& x) {
  const auto& [t, w, s] = x.grid;
  const Index n = t.size();
  MatrixXd a(n + 2, n + 2);
  a << problem.cauchy + problem.slope * hot_slip(x).asDiagonal(), VectorXd::Ones(n + 1), 2 / pi * s,
      w.transpose(), 0, 0;
  const VectorXd unknown = a.partialPivLu().solve(VectorXd::Unit(n + 2, n + 1));
  x.phi = unknown.head(n);
  x.gamma0 = unknown(n);
  x.load_ratio = unknown(n + 1);
}

/// Solve @eq:discrete-stick for phi0 and the constant C.
void solve_stick(const Problem& problem, PrintedSolution& x) {
  const Index n = x.grid.t.size();
  const double a0 = (1 + x.c0) / 2, b0 = (1 - x.c0) / 2;
  MatrixXd a(n + 1, n + 1);
  a << problem.cauchy, VectorXd::Constant(n + 1, -1);
  VectorXd right = a0 * x.grid.s.array() - b0;
  right = right.unaryExpr([&](double s) { return rigid_strain(problem, x, s); });
  const VectorXd unknown = a.partialPivLu().solve(right);
  x.phi0 = unknown.head(n);
  x.creep_constant = unknown(n);
}

/// Move c0 until @eq:discrete-traction holds; true if it does. Counts its steps in x.
bool find_border(const Problem& problem, PrintedSolution& x, const PrintedOptions& options) {
  const double wanted = problem.scene.friction - problem.scene.traction;
  for (int step = 1; step <= options.max_inner; ++step) {
    x.inner_iterations = std::max(x.inner_iterations, step);
    solve_normal(problem, x);
    solve_stick(problem, x);
    const double b = (1 + x.c0) / 2, found = -b * x.grid.w.dot(x.phi0);
    if (std::abs(found - wanted) <= options.tolerance * problem.scene.traction) return true;
    if (!(found > 0)) return false;
    x.c0 = 2 * std::min(b * std::sqrt(wanted / found), 1.0) - 1;
  }
  return false;
}

/// v* at the nodes of the slip zone, @eq:discrete-slip; zero at the others.
VectorXd slip_velocity(const Problem& problem, const PrintedSolution& x) {
  const auto& [t, w, s] = x.grid;
  const VectorXd mass = w.cwiseProduct(x.phi0) / pi;
  VectorXd v = VectorXd::Zero(t.size());
  for (Index j = 0; j < t.size() && t(j) > x.c0; ++j) {
    const double tau = (2 * t(j) + 1 - x.c0) / (1 + x.c0);
    const double elastic = (mass.array() / (t.array() - tau)).sum();
    v(j) = x.creep_constant + rigid_strain(problem, x, t(j)) - elastic;
  }
  return v;
}

/// The polynomial through values at the nodes t_k of the grid; barycentric weights (-1)^k w_k.
double interpolate(const Grid& g, const VectorXd& values, double at) {
  double above = 0, below = 0, sign = 1;
  for (Index k = 0; k < g.t.size(); ++k, sign = -sign) {
    if (at == g.t(k)) return values(k);
    const double weight = sign * g.w(k) / (at - g.t(k));
    above += weight * values(k);
    below += weight;
  }
  return above / below;
}

}  // namespace

VectorXd node_heat(const PrintedSolution& x) { return hot_slip(x).cwiseProduct(x.phi); }

PrintedSolution solve_printed(const Scene& scene, Formulation formulation,
                              const PrintedOptions& options) {
  check(scene);
  require(options.nodes >= 3, "nodes", options.nodes, "at least 3");
  PrintedSolution x;
  x.grid = gauss_chebyshev(options.nodes);
  x.c0 = carter(scene.friction, scene.traction).c0;
  x.slip = VectorXd::Zero(options.nodes);
  const double self = -slope_sign(formulation) * scene.friction * options.heaviside_at_zero;
  const Problem problem{scene, formulation, cauchy_matrix(x.grid),
                        slope_matrix(scene, formulation, x.grid), self};
  int failures = 0;
  while (!x.converged && failures < options.max_failures &&
         x.outer_iterations < options.max_outer) {
    ++x.outer_iterations;
    const bool found = find_border(problem, x, options);
    if (!found) ++failures;
    const VectorXd v = slip_velocity(problem, x);
    const double change = (v - x.slip).lpNorm<Eigen::Infinity>();
    x.slip = v;
    x.converged = found && change <= options.tolerance * v.lpNorm<Eigen::Infinity>();
    if (!v.allFinite()) break;
  }
  x.creep = x.creep_constant - scene.friction * x.gamma0;
  return x;
}

double printed_temperature(const PrintedSolution& x, double peclet, double s) {
  const VectorXd heat = node_heat(x);
  double sum = 0;
  for (Index k = 0; k < heat.size(); ++k)
    if (heat(k) != 0) sum += heat(k) * kernel::M(peclet * (x.grid.t(k) - s));
  return sum / pi;
}

PrintedPeak printed_max_temperature(const PrintedSolution& x, double peclet) {
  PrintedPeak peak{0, 0};
  for (const double s : x.grid.s) {
    const double value = printed_temperature(x, peclet, s);
    if (value > peak.temperature) peak = {s, value};
  }
  return peak;
}

double printed_pressure(const PrintedSolution& x, double s) {
  if (std::abs(s) >= 1) return 0;
  return interpolate(x.grid, x.phi, s) * std::sqrt((1 - s) * (1 + s));
}

double printed_traction(const PrintedSolution& x, double friction, double s) {
  const double sliding = friction * printed_pressure(x, s);
  if (s <= -1 || s >= x.c0) return sliding;
  const double tau = (2 * s + 1 - x.c0) / (1 + x.c0);
  return sliding + interpolate(x.grid, x.phi0, tau) * std::sqrt((1 - tau) * (1 + tau));
}

}  // namespace thermoroll
