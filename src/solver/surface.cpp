// Tangled from paper/14-temperatures-and-profiles.md; edit there.
#include "solver/surface.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/graded_rule.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr double underflow_distance = 350;  // exp(-2 zeta) is 1e-304 here

/// M(side zeta), zeta > 0.
GradedArray temperature_kernel(const Conduction& c, double side, const GradedArray& zeta) {
  const std::vector<Kernels> k = at_distances(c, zeta);
  GradedArray m(zeta.size());
  for (Index i = 0; i < m.size(); ++i) m[i] = k[static_cast<std::size_t>(i)].m_down;
  if (side < 0) return m;
  if (c.pair) return m * upstream_shares(c, zeta);
  return m * (zeta < underflow_distance).select((-2 * zeta).exp(), 0);
}

/// The sum of M times the heat, at a distance from the start of the graded rule.
double temperature_sum(const Conduction& c, const GradedRule& graded, const GradedArray& heat,
                       double side, double distance) {
  if (side > 0 && distance * c.slowest > underflow_distance) return 0;
  return (temperature_kernel(c, side, graded.zeta + distance) * heat).sum();
}

}  // namespace

TemperatureAndSlope temperature_and_slope(double slip, const Conduction& conduction,
                                          const VectorXd& h, double left, double right, double gap,
                                          const GaussLegendre& rule) {
  TemperatureAndSlope sum{0, 0};
  GradedRule graded;
  const VectorXd dh = derivative(h);
  for (const double side : {1.0, -1.0}) {  // right, then left, mirrored
    if (side < 0 && left == 0) continue;
    grade(graded, conduction.peclet * slip, gap, side > 0 ? left : right, side > 0 ? right : left,
          rule);
    if (side > 0) graded.cut(20 / conduction.slowest);
    const GradedArray value = series(side, graded.y, h), slope = series(side, graded.y, dh);
    const GradedArray m = temperature_kernel(conduction, side, graded.zeta);
    sum.value += (m * graded.heat * value).sum();
    sum.slope += (m * (side * graded.by_h * value + graded.by_dh * slope)).sum();
  }
  return {slip * slip / pi * sum.value, slip / pi * sum.slope};
}

TemperatureAndSlope with_series(TemperatureAndSlope sum, double slip, double y,
                                const VectorXd& more) {
  if (more.size() == 0) return sum;
  const SlipPoint at(1 + y, 1 - y);
  const auto polynomials = legendre(ArrayXd::Constant(1, y), more.size());
  sum.value += polynomials.row(0).dot(more);
  sum.slope += polynomials.row(0).dot(derivative(more)) / (slip * 6 * at.u * at.v * at.du);
  return sum;
}

/// The hottest point by temperatures alone, as a function of y.
template <class Temperature>
HottestPoint search(const Temperature& temperature) {
  const auto value = [&](double y) { return std::abs(y) < 1 ? temperature(y).value : 0; };
  HottestPoint top{0, 0};
  double apart = 1.0 / 16;
  for (int round = 0; round < 5; ++round, apart /= 8) {
    const double middle = top.y;
    for (int i = -16; i <= 16; ++i) {
      const double y = middle + i * apart, now = value(y);
      if (now > top.value) top = {y, now};
    }
  }
  return top;
}

HottestPoint find_hottest(double slip, const Conduction& conduction, const VectorXd& h,
                          const HottestPoint& near, const GaussLegendre& rule,
                          const VectorXd& more) {
  const auto temperature = [&](double place) {
    const auto own = temperature_and_slope(slip, conduction, h, 1 + place, 1 - place, 0, rule);
    return with_series(own, slip, place, more);
  };
  double low = -1, high = 1, curvature = near.curvature, y = near.y, last = y, before = 0,
         hottest = 0;
  for (int step = 0;; ++step) {
    const SlipPoint at(1 + y, 1 - y);
    const TemperatureAndSlope now = temperature(y);
    const double slope = now.slope * slip * 6 * at.u * at.v * at.du / now.value;  // of ln T, by y
    if (step > 0) curvature = (slope - before) / (y - last);
    (slope > 0 ? low : high) = y;
    const bool at_edge = 1 - y < 1e-12;
    const double move = at_edge ? 0 : std::clamp(-slope / curvature, -0.3, 0.3), next = y + move;
    const bool known = step > 0 || near.value > 0;  // the curvature
    hottest = std::max(hottest, now.value);
    if ((known && std::abs(move) < 1e-5) || step == 60) {
      if (now.value < hottest * (1 - 1e-6)) return search(temperature);
      return {next, now.value * (1 + slope * move / 2), curvature};
    }
    last = y;
    before = slope;
    y = low < next && next < high ? next : (low + high) / 2;
  }
}

ArrayXd surface_temperature(const ZoneLengths& at, const Conduction& conduction, const VectorXd& h,
                            const ArrayXd& s, const GaussLegendre& rule) {
  const double slip = at.slip;
  GradedRule first, last, graded;
  grade(first, conduction.peclet * slip, 0, 0, 2, rule);
  grade(last, conduction.peclet * slip, 0, 0, 2, rule);
  first.cut(20 / conduction.slowest);
  const GradedArray at_first = first.heat * series(1, first.y, h);
  const GradedArray at_last = last.heat * series(-1, last.y, h);
  ArrayXd sums(s.size());
  for (Index i = 0; i < s.size(); ++i) {
    const double right = 1 - s(i);
    const double left = slip < at.stick ? slip - right : 1 + s(i) - at.stick;
    if (left <= 0) {
      sums(i) = temperature_sum(conduction, first, at_first, 1, -conduction.peclet * left);
    } else if (right <= 0) {
      sums(i) = temperature_sum(conduction, last, at_last, -1, -conduction.peclet * right);
    } else {
      const double share = std::min({left, right, slip / 2}) / slip;
      const double near = distance_of_share(share), far = 2 - near;
      const auto from = [&](double behind, double ahead, double side) {
        grade(graded, conduction.peclet * slip, 0, behind, ahead, rule);
        if (side > 0) graded.cut(20 / conduction.slowest);
        return temperature_sum(conduction, graded, graded.heat * series(side, graded.y, h), side,
                               0);
      };
      sums(i) = left < right ? from(near, far, 1) + from(far, near, -1)
                             : from(far, near, 1) + from(near, far, -1);
    }
  }
  return slip * slip / pi * sums;
}

SmoothFlux smooth_flux(const Carter& c) {
  const ZoneLengths at{2 * c.slip_half_width, 2 * c.b};
  return {at.slip, at.stick, carter_h(at, c.friction)};
}

SmoothFlux smooth_flux(const CoupledSolution& x) {
  return {x.value(Quantity::slip_length), 1 + x.value(Quantity::stick_slip_border),
          without_ripples(x.scene, x.h)};
}

VectorXd without_ripples(const Scene& scene, const VectorXd& h) {
  const double apart = distortions_apart(scene);
  if (scene.bulk_difference == 0 || apart == 0 || h.size() <= 20) return h;
  const ArrayXd degree = ArrayXd::LinSpaced(h.size(), 0, static_cast<double>(h.size() - 1));
  return h.array() * (-36 * (degree / static_cast<double>(h.size())).pow(10)).exp();
}

/// Estimated error of all temperatures, of which the largest is top, from the largest change by
/// eight more nodes.
double quadrature_error(int nodes, double change, double top) {
  return change / 2 + (6 * std::pow(nodes, -6) + 1e-14) * top;
}

SurfaceCurve surface_curve(const SmoothFlux& x, const Conduction& conduction, const ArrayXd& s,
                           double tolerance) {
  require(conduction.peclet > 0, "peclet", conduction.peclet, "positive");
  require(tolerance >= 1e-12, "tolerance", tolerance, "at least 1e-12");
  for (const double place : s) require(true, "s", place, "finite");
  if (s.size() == 0) return {s, 0};
  const Index every = s.size() / 20 + 1, own = (s.size() + every - 1) / every;
  ArrayXd some(own + 4);
  for (Index i = 0; i < own; ++i) some(i) = s(i * every);
  const ArrayXd y = gauss_legendre(4).x;
  for (Index i = 0; i < 4; ++i)
    some(own + i) = 1 - x.slip * (1 - SlipPoint(1 + y(i), 1 - y(i)).t());
  const auto with = [&](int nodes, const ArrayXd& at) {
    return surface_temperature({x.slip, x.stick}, conduction, x.h, at, gauss_legendre(nodes));
  };
  int nodes = 40;
  for (ArrayXd before = with(nodes, some);;) {
    const ArrayXd now = with(nodes += 8, some);
    const double top = now.maxCoeff();
    const double error = quadrature_error(nodes, (now - before).abs().maxCoeff(), top);
    if (error <= tolerance * top || nodes >= most_unknowns) return {with(nodes, s), error};
    before = now;
  }
}

Peak hottest_point(const SmoothFlux& x, const Conduction& conduction, double tolerance) {
  int nodes = 40;
  for (HottestPoint before = find_hottest(x.slip, conduction, x.h, {}, gauss_legendre(nodes));;) {
    const HottestPoint now =
        find_hottest(x.slip, conduction, x.h, before, gauss_legendre(nodes += 8));
    const double error = quadrature_error(nodes, std::abs(now.value - before.value), now.value);
    if (error <= tolerance * now.value || nodes >= most_unknowns) {
      const double moved = std::abs(now.y - before.y) + 1e-9;
      const SlipPoint at(1 + now.y, 1 - now.y);
      const double s = (x.stick - x.slip) / 2 + x.slip * at.t();
      const double at_error = 6 * x.slip * at.u * at.v * at.du * moved;
      return {s, at_error, {now.value, error}};
    }
    before = now;
  }
}

}  // namespace thermoroll
