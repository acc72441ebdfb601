// Tangled from paper/06-published-scheme.md; edit there.
#include "thermoroll/published_scheme.hpp"

#include <cmath>

#include "solver/linear_system.hpp"
#include "solver/nested_iteration.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

struct Problem {
  Scene scene;
  double traction;
  Formulation formulation;
  MatrixXd cauchy;
  double coincident;  // the value taken for N* at a coincident node
};

/// sigma_N f Pe H N1*(t_k - s_m) w_k v*(t_k), row m, column k; zero where the node k is in the
/// stick zone.
MatrixXd slope_matrix(const Problem& problem, const PublishedSolution& solution) {
  const double friction = problem.scene.friction, peclet = problem.scene.peclet;
  const double heating = problem.scene.heating;
  const auto& [t, w, s] = solution.grid;
  MatrixXd n1 = MatrixXd::Zero(s.size(), t.size());
  for (Index k = 0; k < t.size() && t(k) > solution.c0; ++k)
    for (Index m = 0; m < s.size(); ++m) n1(m, k) = kernel::N1(peclet * (t(k) - s(m)));
  return slope_sign(problem.formulation) * friction * peclet * heating * n1 *
         hot_slip(solution).asDiagonal();
}

/// Solve @eq:discrete-normal and @eq:discrete-load for phi, gamma0 and kappa.
void solve_normal(const Problem& problem, PublishedSolution& solution) {
  const auto& [t, w, s] = solution.grid;
  const Index n = t.size();
  MatrixXd a(n + 2, n + 2);
  a << problem.cauchy + slope_matrix(problem, solution), VectorXd::Ones(n + 1), 2 / pi * s,
      w.transpose(), 0, 0;
  const VectorXd unknown = solve(a, VectorXd::Unit(n + 2, n + 1));
  solution.phi = unknown.head(n);
  solution.gamma0 = unknown(n);
  solution.load_ratio = unknown(n + 1);
}

/// (2f/pi) kappa s - f Pe H sum_k N*(t_k - s) g_k.
double rigid_strain(const Problem& problem, const PublishedSolution& solution, double s) {
  const double friction = problem.scene.friction, peclet = problem.scene.peclet;
  const double heating = problem.scene.heating;
  const VectorXd heat = node_heat(solution);
  double sum = 0;
  for (Index k = 0; k < heat.size() && solution.grid.t(k) > solution.c0; ++k) {
    const double z = peclet * (solution.grid.t(k) - s);
    sum += heat(k) * (z == 0 ? problem.coincident : kernel::N(z, friction, problem.formulation));
  }
  return 2 * friction / pi * solution.load_ratio * s - friction * peclet * heating * sum;
}

/// Solve @eq:discrete-stick for phi0 and the constant C.
void solve_stick(const Problem& problem, PublishedSolution& solution) {
  const Index n = solution.grid.t.size();
  const double a0 = (1 + solution.c0) / 2, b0 = (1 - solution.c0) / 2;
  MatrixXd a(n + 1, n + 1);
  a << problem.cauchy, VectorXd::Constant(n + 1, -1);
  VectorXd right = a0 * solution.grid.s.array() - b0;
  right = right.unaryExpr([&](double s) { return rigid_strain(problem, solution, s); });
  const VectorXd unknown = solve(a, right);
  solution.phi0 = unknown.head(n);
  solution.creep_constant = unknown(n);
}

/// v* at the nodes of the slip zone, @eq:discrete-slip; zero at the others.
VectorXd slip_velocity(const Problem& problem, const PublishedSolution& solution) {
  const auto& [t, w, s] = solution.grid;
  const VectorXd mass = w.cwiseProduct(solution.phi0) / pi;
  VectorXd v = VectorXd::Zero(t.size());
  for (Index j = 0; j < t.size() && t(j) > solution.c0; ++j) {
    const double tau = (2 * t(j) + 1 - solution.c0) / (1 + solution.c0);
    const double elastic = (mass.array() / (t.array() - tau)).sum();
    v(j) = solution.creep_constant + rigid_strain(problem, solution, t(j)) - elastic;
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

VectorXd hot_slip(const PublishedSolution& solution) {
  return (solution.grid.t.array() > solution.c0)
      .select(solution.grid.w.cwiseProduct(solution.slip), 0);
}

VectorXd node_heat(const PublishedSolution& solution) {
  return hot_slip(solution).cwiseProduct(solution.phi);
}

PublishedSolution solve_published(const Scene& scene, double traction, Formulation formulation,
                                  const PublishedOptions& options) {
  PublishedSolution solution = before_iterating(scene, traction, options);
  const double self = -slope_sign(formulation) * scene.friction * options.heaviside_at_zero;
  const Problem problem{scene, traction, formulation, cauchy_matrix(solution.grid), self};
  iterate(problem, solution, options);
  return solution;
}

double published_temperature(const PublishedSolution& solution, double peclet, double s) {
  const VectorXd heat = node_heat(solution);
  double sum = 0;
  for (Index k = 0; k < heat.size(); ++k)
    if (heat(k) != 0) sum += heat(k) * kernel::M(peclet * (solution.grid.t(k) - s));
  return sum / pi;
}

PublishedPeak published_max_temperature(const PublishedSolution& solution, double peclet) {
  PublishedPeak peak{0, 0};
  for (const double s : solution.grid.s) {
    const double value = published_temperature(solution, peclet, s);
    if (value > peak.temperature) peak = {s, value};
  }
  return peak;
}

double published_pressure(const PublishedSolution& solution, double s) {
  if (std::abs(s) >= 1) return 0;
  return interpolate(solution.grid, solution.phi, s) * std::sqrt((1 - s) * (1 + s));
}

double published_traction(const PublishedSolution& solution, double friction, double s) {
  const double sliding = friction * published_pressure(solution, s);
  if (s <= -1 || s >= solution.c0) return sliding;
  const double tau = (2 * s + 1 - solution.c0) / (1 + solution.c0);
  return sliding +
         interpolate(solution.grid, solution.phi0, tau) * std::sqrt((1 - tau) * (1 + tau));
}

Factors factors(const PublishedSolution& solution, double friction) {
  const Index n = solution.grid.t.size(), slips = (solution.grid.t.array() > solution.c0).count();
  const double a0 = (1 + solution.c0) / 2;
  const ArrayXd t = solution.grid.t.head(slips).reverse();
  ArrayXd s(n + slips), pressure(n + slips), slip(n + slips);
  s << a0 * (1 + solution.grid.t.reverse().array()) - 1, t;
  for (Index i = 0; i < s.size(); ++i)
    pressure(i) = published_pressure(solution, s(i)) / std::sqrt((1 - s(i)) * (1 + s(i)));
  slip << -solution.phi0.reverse().array() / a0,
      solution.slip.head(slips).reverse().array() / ((1 + t) * (t - solution.c0)).sqrt();
  return {friction, solution.c0, solution.load_ratio, s, pressure, slip};
}

}  // namespace thermoroll
