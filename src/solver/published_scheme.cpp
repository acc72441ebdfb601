// Tangled from paper/07-printed-scheme.md, paper/13-where-methods-fail.md; edit there.
#include "thermoroll/published_scheme.hpp"

#include <cmath>

#include <Eigen/LU>

#include "solver/nested_iteration.hpp"

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

VectorXd hot_slip(const PrintedSolution& x) {
  return (x.grid.t.array() > x.c0).select(x.grid.w.cwiseProduct(x.slip), 0);
}

VectorXd node_heat(const PrintedSolution& x) { return hot_slip(x).cwiseProduct(x.phi); }

namespace {

struct Problem {
  Scene scene;
  double traction;
  Formulation formulation;
  MatrixXd cauchy;
  double coincident;  // what stands for N* at a coincident node
};

/// eps f Pe H N1*(t_k - s_m) w_k v*(t_k), row m, column k; zero where the node k is not hot.
MatrixXd slope_matrix(const Problem& problem, const PrintedSolution& x) {
  const auto& [friction, peclet, heating] = problem.scene;
  const auto& [t, w, s] = x.grid;
  MatrixXd n1 = MatrixXd::Zero(s.size(), t.size());
  for (Index k = 0; k < t.size() && t(k) > x.c0; ++k)
    for (Index m = 0; m < s.size(); ++m) n1(m, k) = kernel::N1(peclet * (t(k) - s(m)));
  return slope_sign(problem.formulation) * friction * peclet * heating * n1 *
         hot_slip(x).asDiagonal();
}

/// (2f/pi) kappa s - f Pe H sum_k N*(t_k - s) g_k.
double rigid_strain(const Problem& problem, const PrintedSolution& x, double s) {
  const auto& [friction, peclet, heating] = problem.scene;
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
  a << problem.cauchy + slope_matrix(problem, x), VectorXd::Ones(n + 1), 2 / pi * s, w.transpose(),
      0, 0;
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

PrintedSolution solve_printed(const Scene& scene, double traction, Formulation formulation,
                              const PrintedOptions& options) {
  PrintedSolution x = before_iterating(scene, traction, options);
  const double self = -slope_sign(formulation) * scene.friction * options.heaviside_at_zero;
  const Problem problem{scene, traction, formulation, cauchy_matrix(x.grid), self};
  iterate(problem, x, options);
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

Factors factors(const PrintedSolution& x, double friction) {
  const Index n = x.grid.t.size(), slips = (x.grid.t.array() > x.c0).count();
  const double a0 = (1 + x.c0) / 2;
  const ArrayXd t = x.grid.t.head(slips).reverse();
  ArrayXd s(n + slips), pressure(n + slips), slip(n + slips);
  s << a0 * (1 + x.grid.t.reverse().array()) - 1, t;
  for (Index i = 0; i < s.size(); ++i)
    pressure(i) = printed_pressure(x, s(i)) / std::sqrt((1 - s(i)) * (1 + s(i)));
  slip << -x.phi0.reverse().array() / a0,
      x.slip.head(slips).reverse().array() / ((1 + t) * (t - x.c0)).sqrt();
  return {friction, x.c0, x.load_ratio, s, pressure, slip};
}

}  // namespace thermoroll
