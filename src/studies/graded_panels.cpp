// Tangled from paper/15-speed-and-accuracy.md; edit there.
#include "studies/graded_panels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "model/kernel_table.hpp"
#include "solver/gauss_legendre.hpp"
#include "solver/graded_rule.hpp"
#include "solver/linear_system.hpp"
#include "solver/product.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/quadrature.hpp"

namespace thermoroll {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;
using ArrayX3d = Eigen::Array<double, Eigen::Dynamic, 3>;

constexpr Index per_panel = 5;
constexpr int near_nodes = 32;

/// Panels between ascending ends, and their Gauss-Legendre nodes and weights.
struct Panels {
  ArrayXd end, angle, weight;
};

Panels panels(const ArrayXd& end) {
  const GaussLegendre& rule = gauss_legendre(per_panel);
  const Index count = end.size() - 1;
  Panels x{end, ArrayXd(per_panel * count), ArrayXd(per_panel * count)};
  for (Index k = 0; k < count; ++k) {
    const double half = (end(k + 1) - end(k)) / 2;
    x.angle.segment(per_panel * k, per_panel) = end(k) + half * (1 + rule.x);
    x.weight.segment(per_panel * k, per_panel) = half * rule.w;
  }
  return x;
}

ArrayXd towards_both(Index count, double layer) {
  const double reach = pi / 2 + layer, k = 2 * std::atanh(pi / 2 / reach);
  return pi / 2 + reach * (k * ArrayXd::LinSpaced(count + 1, -0.5, 0.5)).tanh();
}

ArrayXd towards_first(Index count, double layer) {
  const double k = std::log1p(pi / layer);
  return layer * ((k * ArrayXd::LinSpaced(count + 1, 0, 1)).exp() - 1);
}

/// The panels of both zones at a border c0; s - c0 on slip, c0 - r on stick at the nodes; and the
/// weights of the heat.
struct PanelZones {
  PanelZones(Index count, double c0, double peclet)
      : slip(1 - c0),
        stick(1 + c0),
        hot(panels(towards_both(count, 2 / std::sqrt(std::max(1.0, slip * peclet))))),
        cold(panels(towards_first(
            (count + 1) / 2, 2 * std::sqrt(std::min({1.0, 1 / (stick * peclet), slip / stick}))))),
        from_border(slip * (hot.angle / 2).sin().square()),
        to_border(stick * (cold.angle / 2).sin().square()),
        heat(hot.weight * hot.angle.sin().square()) {}
  double slip, stick;
  Panels hot, cold;
  ArrayXd from_border, to_border, heat;
};

/// A target, and s - c0 there.
struct PanelTarget {
  double angle, place;
  double gap(const PanelZones& z) const { return std::max(0.0, -place) / z.slip; }
};

/// N1, N2 and M at every zeta, a row each; a coincident source, which no row keeps, is moved apart.
ArrayX3d all_kernels(const ArrayXd& zeta) {
  const ArrayXd x = zeta.abs().max(1e-12);
  std::vector<Kernels> found(static_cast<std::size_t>(x.size()));
  fast_kernels(found.size(), x.data(), found.data());
  ArrayX3d k(x.size(), 3);
  for (Index i = 0; i < x.size(); ++i)
    if (const Kernels& at = found[static_cast<std::size_t>(i)]; zeta(i) > 0)
      k.row(i) << at.n1, at.n2_up, at.m_down * std::exp(-2 * std::min(x(i), 300.0));
    else
      k.row(i) << 0, at.n2_down, at.m_down;
  return k;
}

/// Steps between near and far on one side of a target, and their weights.
struct PanelSteps {
  PanelSteps(double delta, double near, double far) {
    const auto rho_at = [&](double away) { return std::pow(std::log1p(away / delta), 0.2); };
    const GaussLegendre& rule = gauss_legendre(near_nodes);
    const double first = rho_at(near), span = rho_at(far) - first;
    const ArrayXd rho = first + span * rule.rho, fourth = rho.square().square();
    const ArrayXd grown = (rho * fourth).exp();
    step = delta * (grown - 1);
    weight = 2.5 * delta * span * fourth * grown * rule.w;
  }
  ArrayXd step, weight;
};

double scale_of_steps(const PanelZones& z, double peclet, const PanelTarget& at) {
  const double lambda = peclet * z.slip, at_end = std::sqrt(1 / lambda + at.gap(z));
  return 6 * std::min(at_end, 1 / (lambda * std::sin(at.angle)));
}

/// The kernels times sin^2 psi.
ArrayX3d kernels_at_steps(const PanelZones& z, double peclet, const PanelTarget& at,
                          const ArrayXd& step) {
  const double sine = std::sin(at.angle), cosine = std::cos(at.angle);
  const ArrayXd x = (step / 2).sin(), y = (1 - x.square()).sqrt();
  const ArrayXd distance = x * (sine * y + cosine * x) + at.gap(z);
  const ArrayXd source = sine * (1 - 2 * x.square()) + 2 * cosine * x * y;  // sin psi
  return all_kernels(peclet * z.slip * distance).colwise() * source.square();
}

/// Add the integrals of the kernels against the polynomials of the panel between a and b, measured
/// from the target; side is 1 or -1.
void add_side(Eigen::Ref<ArrayX3d> moments, const PanelZones& z, double peclet,
              const PanelTarget& at, double side, double a, double b) {
  const double near = std::max(0.0, side > 0 ? a : -b), far = side > 0 ? b : -a;
  if (far <= 0) return;
  const PanelSteps steps(scale_of_steps(z, peclet, at), near, far);
  const ArrayXd signed_steps = side * steps.step;
  const ArrayX3d kernels = kernels_at_steps(z, peclet, at, signed_steps).colwise() * steps.weight;
  static const MatrixXd to_series = to_legendre(gauss_legendre(per_panel));
  const MatrixXd polynomials =
      product(1, legendre((2 * signed_steps - a - b) / (b - a), per_panel), to_series);
  moments += product(1, polynomials.transpose(), kernels.matrix()).array();
}

/// What stands before h at every slip node in @eq:panel-moments, per slip^2 / 4: N1, N2 and M.
ArrayX3d heat_row(const PanelZones& z, double peclet, const PanelTarget& at) {
  ArrayX3d row = all_kernels(peclet * (z.from_border - at.place)).colwise() * z.heat;
  for (Index k = 0; k + 1 < z.hot.end.size(); ++k) {
    const double a = z.hot.end(k) - at.angle, b = z.hot.end(k + 1) - at.angle;
    const double away = std::max({a, -b, 0.0});
    if (std::hypot(away, 2 * std::sqrt(at.gap(z))) > 2 * (b - a)) continue;
    auto moments = row.middleRows(per_panel * k, per_panel);
    moments.setZero();
    for (const double side : {-1.0, 1.0}) add_side(moments, z, peclet, at, side, a, b);
  }
  return row;
}

/// F and G of @eq:thermal-sides at the slip nodes, then the stick nodes, and T* at the slip nodes.
struct HeatOnPanels {
  MatrixXd f, g, temperature;
};

HeatOnPanels heat_on_panels(const Scene& scene, Formulation formulation, const PanelZones& z) {
  const Index n = z.hot.angle.size(), all = n + z.cold.angle.size();
  const double outward = slope_sign(formulation), share = z.slip * z.slip / 4;
  const double strength = scene.friction * scene.peclet * scene.heating * share;
  HeatOnPanels heat{MatrixXd(all, n), MatrixXd(all, n), MatrixXd(n, n)};
  for (Index i = 0; i < all; ++i) {
    const PanelTarget at =
        i < n ? PanelTarget{z.hot.angle(i), z.from_border(i)} : PanelTarget{0, -z.to_border(i - n)};
    const ArrayX3d row = heat_row(z, scene.peclet, at);
    heat.f.row(i) = -outward * strength * row.col(0);
    heat.g.row(i) = strength * (row.col(1) / pi - outward * scene.friction * row.col(0));
    if (i < n) heat.temperature.row(i) = share / pi * row.col(2);
  }
  return heat;
}

/// p-hat = 2/pi + p h and v-hat = 2f/pi + v h at the slip nodes; kappa = 1 + kappa h, gamma0 h.
struct TractionsOnPanels {
  MatrixXd p, v;
  RowVectorXd kappa, gamma0;
};

/// Weights of ds / sqrt(1 - s^2) at the slip nodes, then the stick nodes.
VectorXd over_root(const PanelZones& z) {
  VectorXd weight(z.hot.angle.size() + z.cold.angle.size());
  weight << z.hot.weight * (z.from_border / (z.stick + z.from_border)).sqrt(),
      z.cold.weight * (z.to_border / (z.slip + z.to_border)).sqrt();
  return weight;
}

/// The integral in @eq:pressure-inverse at the slip nodes, as a matrix on F at all nodes.
MatrixXd divided_differences(const PanelZones& z, const VectorXd& weight) {
  const Panels& hot = z.hot;
  const Index n = hot.angle.size(), m = z.cold.angle.size();
  MatrixXd sums(n, n + m);
  for (Index i = 0; i < n; ++i) {
    const ArrayXd before = (hot.angle - hot.angle(i)) / 2, middle = before + hot.angle(i);
    ArrayXd away = z.slip * before.sin() * middle.sin();  // @eq:panel-distance
    away(i) = std::numeric_limits<double>::infinity();
    sums.row(i) << (weight.head(n).array() / away).transpose(),
        (-weight.tail(m).array() / (z.from_border(i) + z.to_border)).transpose();
    sums(i, i) = -sums.row(i).sum();
    const GaussLegendre& rule = gauss_legendre(per_panel);
    static const MatrixXd slopes = by_derivatives(rule.p) * to_legendre(rule);
    const Index k = i / per_panel;
    const double ds = (hot.end(k + 1) - hot.end(k)) * z.slip * std::sin(hot.angle(i)) / 4;
    sums.row(i).segment(per_panel * k, per_panel) += weight(i) / ds * slopes.row(i % per_panel);
  }
  return sums;
}

TractionsOnPanels tractions_on_panels(const HeatOnPanels& heat, const PanelZones& z,
                                      double friction) {
  const Index n = z.hot.angle.size(), m = z.cold.angle.size();
  const VectorXd weight = over_root(z);
  VectorXd s(n + m);
  s << z.from_border, -z.to_border;
  s.array() += (z.stick - z.slip) / 2;
  const RowVectorXd kappa = weight.cwiseProduct(s).transpose() * heat.f;
  MatrixXd sums(n, m);
  for (Index i = 0; i < n; ++i) sums.row(i) = z.cold.weight / (z.from_border(i) + z.to_border);
  MatrixXd p = product(-1, divided_differences(z, weight), heat.f);
  MatrixXd v = product(1, sums, heat.g.bottomRows(m));
  v -= sums.rowwise().sum().asDiagonal() * heat.g.topRows(n);
  p.rowwise() += 2 * kappa;
  v.rowwise() += 2 * friction * kappa;
  return {p / pi, v / pi, kappa, weight.transpose() * heat.f / pi};
}

/// The values of h, NaN where the steps do not end.
VectorXd heat_by_newton(const TractionsOnPanels& x, const ArrayXd& sigma, double friction) {
  VectorXd h = 4 * friction / (pi * pi) * sigma;
  for (int step = 0; step < 25; ++step) {
    const ArrayXd p = 2 / pi + (x.p * h).array(), v = 2 * friction / pi + (x.v * h).array();
    MatrixXd jacobian = (-sigma * v).matrix().asDiagonal() * x.p;
    jacobian.noalias() -= (sigma * p).matrix().asDiagonal() * x.v;
    jacobian.diagonal().array() += 1;
    const VectorXd change = solve(jacobian, h - (sigma * p * v).matrix());
    h -= change;
    if (change.lpNorm<Eigen::Infinity>() < 1e-8 * h.lpNorm<Eigen::Infinity>()) return h;
  }
  return VectorXd::Constant(h.size(), std::numeric_limits<double>::quiet_NaN());
}

double hottest_on_panels(const PanelZones& z, double peclet, const VectorXd& temperature,
                         const VectorXd& h) {
  Index i = 0;
  const double at_node = temperature.maxCoeff(&i);
  if (i == 0 || i + 1 == h.size() || !(at_node > 0)) return at_node;
  const Panels& hot = z.hot;
  const Index k = i / per_panel;
  const double a = hot.end(k), b = hot.end(k + 1);
  const VectorXd series =
      to_legendre(gauss_legendre(per_panel)) * temperature.segment(per_panel * k, per_panel);
  const auto cold = [&](double angle) {
    return -(legendre(ArrayXd::Constant(1, (2 * angle - a - b) / (b - a)), per_panel) * series)(0);
  };
  const double low = hot.angle(i - 1), high = hot.angle(i + 1);
  if (!(std::min(cold(low), cold(high)) > -at_node)) return at_node;  // too coarse to tell
  const double at = minimum(cold, low, hot.angle(i), high);
  const double place = z.slip * std::pow(std::sin(at / 2), 2);
  return z.slip * z.slip / (4 * pi) * heat_row(z, peclet, {at, place}).col(2).matrix().dot(h);
}

/// c0, Q*, kappa, the largest T*, and xi*; by @eq:pressure-conditions and @eq:stick-conditions.
using AtBorder = Eigen::Array<double, 5, 1>;

AtBorder at_border(const Scene& scene, Formulation formulation, Index nodes, double c0) {
  const double f = scene.friction;
  const PanelZones z(nodes / per_panel, c0, scene.peclet);
  const HeatOnPanels heat = heat_on_panels(scene, formulation, z);
  const TractionsOnPanels x = tractions_on_panels(heat, z, f);
  const VectorXd h = heat_by_newton(x, z.stick + z.from_border, f);
  const double a0 = z.stick / 2, kappa = 1 + x.kappa.dot(h);
  const ArrayXd g = z.cold.weight * (heat.g.bottomRows(z.cold.angle.size()) * h).array();
  const double traction = f - f * kappa * a0 * a0 + ((a0 - z.to_border) * g).sum();
  const double constant = g.sum() / pi + f * kappa / pi * z.slip;
  const double top = hottest_on_panels(z, scene.peclet, heat.temperature * h, h);
  return {c0, traction, kappa, top, constant - f * x.gamma0.dot(h)};
}

PanelSolution results(const AtBorder& x) { return {x(0), x(2), x(3), x(4)}; }

}  // namespace

PanelSolution solve_on_panels(const Scene& scene, double traction, Formulation formulation,
                              int nodes) {
  check(scene);
  require(nodes >= 10 && nodes % per_panel == 0, "nodes", nodes, "a multiple of 5, at least 10");
  const double c0 = carter(scene.friction, traction).c0;
  Index level = 2 * per_panel;
  AtBorder x = at_border(scene, formulation, level, c0);
  AtBorder y = at_border(scene, formulation, level, c0 + 1e-3 * std::min(1 - c0, 1 + c0));
  AtBorder slope = (y - x) / (y(1) - x(1));
  for (int step = 0; step < 20 && y.isFinite().all(); ++step) {
    const double miss = traction - y(1);
    const bool met = std::abs(miss) < 1e-6 * traction;
    if (met && level == nodes) return results(y + slope * miss);
    const double c = y(0), move = std::clamp(slope(0) * miss, -0.7 * (1 + c), 0.7 * (1 - c));
    if (met) level = std::min<Index>(nodes, level < 5 * per_panel ? 5 * per_panel : nodes);
    x = y;
    y = at_border(scene, formulation, level, c + move);
    if (!met) slope = (y - x) / (y(1) - x(1));
  }
  return results(AtBorder::Constant(std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace thermoroll
