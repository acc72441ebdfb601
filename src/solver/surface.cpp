// Tangled from paper/14-temperatures-and-profiles.md; edit there.
#include "solver/surface.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
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
  if (c.pair) return pair_temperatures(c, side, zeta);
  const GradedKernels k = at_distances(c, zeta);
  GradedArray m(zeta.size());
  for (Index i = 0; i < m.size(); ++i) m[i] = k[i].m_down;
  if (side < 0) return m;
  return m * (zeta < underflow_distance).select(exponentials(-2 * zeta), 0);
}

/// The sum of M times the heat, at a distance from the start of the graded rule.
double temperature_sum(const Conduction& c, const GradedRule& graded, const GradedArray& heat,
                       double side, double distance) {
  if (side > 0 && distance * c.slowest > underflow_distance) return 0;
  return (temperature_kernel(c, side, graded.zeta + distance) * heat).sum();
}
/// A flux on the slip zone, and its heat on the rules from both ends; in units of slip^2 / pi.
struct SurfaceHeat {
  ZoneLengths zones;
  const Conduction& conduction;
  const VectorXd& h;
  const GaussLegendre& rule;
  GradedRule first{}, last{};
  GradedArray at_first{}, at_last{};
  double before(double distance) const {
    return temperature_sum(conduction, first, at_first, 1, conduction.peclet * distance);
  }
  double behind(double distance) const {
    return temperature_sum(conduction, last, at_last, -1, conduction.peclet * distance);
  }

  /// Of one body, over exp(-2 Pe distance).
  double growth_before(double distance) const {
    const GradedArray heat = at_first * exponentials(-2 * first.zeta);
    return temperature_sum(conduction, first, heat, -1, conduction.peclet * distance);
  }

  /// At the distances 1 + y and 1 - y from its ends.
  double inside(double left, double right) const {
    return from(left, right, 1) + from(right, left, -1);
  }

  double from(double behind, double ahead, double side) const {
    GradedRule graded;
    grade(graded, conduction.peclet * zones.slip, 0, behind, ahead, rule,
          side > 0 ? zones.variable : mirrored(zones.variable));
    if (side > 0) graded.cut(20 / conduction.slowest);
    return temperature_sum(conduction, graded, graded.heat * series(side, graded.y, h), side, 0);
  }
};

SurfaceHeat surface_heat(const ZoneLengths& zones, const Conduction& conduction, const VectorXd& h,
                         const GaussLegendre& rule) {
  SurfaceHeat x{zones, conduction, h, rule};
  grade(x.first, conduction.peclet * zones.slip, 0, 0, 2, rule, zones.variable);
  grade(x.last, conduction.peclet * zones.slip, 0, 0, 2, rule, mirrored(zones.variable));
  x.first.cut(20 / conduction.slowest);
  x.at_first = x.first.heat * series(1, x.first.y, h);
  x.at_last = x.last.heat * series(-1, x.last.y, h);
  return x;
}

/// The distances from both ends of the slip zone, positive in it.
struct FromEnds {
  double left, right;
};

FromEnds from_ends(const ZoneLengths& at, double s) {
  const double right = 1 - s;
  return {at.slip < at.stick ? at.slip - right : 1 + s - at.stick, right};
}

/// 1 + y and 1 - y of a point in the zone.
FromEnds in_y(const FromEnds& x, const ZoneLengths& at) {
  const double share = std::min({x.left, x.right, at.slip / 2}) / at.slip;
  const bool is_left = x.left < x.right;
  const double near = distance_of_share(share, is_left ? at.variable : mirrored(at.variable));
  return x.left < x.right ? FromEnds{near, 2 - near} : FromEnds{2 - near, near};
}

/// f at all x in [-1, 1]: itself, or a polynomial through n or more of its values; and its error.
SurfaceCurve at_many_places(const std::function<double(double)>& f, const ArrayXd& x, int n,
                            double tolerance) {
  for (; n <= 3 * x.size() / 4 && n <= most_unknowns; n *= 2) {
    const GaussLegendre& rule = gauss_legendre(n);
    const VectorXd c = to_legendre(rule, rule.x.unaryExpr(f).matrix());
    const double error = 2 * c.tail(n / 8).lpNorm<1>();
    if (error <= tolerance) return {legendre(x, n) * c, error};
  }
  return {x.unaryExpr(f), 0};
}

SurfaceCurve on_a_side(const std::function<double(double)>& f, double delta, const ArrayXd& d,
                       double tolerance) {
  if (d.size() < 50 || d.maxCoeff() == 0) return {d.unaryExpr(f), 0};
  const double k = std::log1p(d.maxCoeff() / delta);
  const ArrayXd r = ((d / delta).log1p() / k).sqrt();
  const auto at = [&](double x) { return f(delta * std::expm1(k * (1 + x) * (1 + x) / 4)); };
  return at_many_places(at, 2 * r - 1, 32, tolerance);
}

SurfaceCurve temperatures_before(const SurfaceHeat& heat, double delta, const ArrayXd& d,
                                 double tolerance) {
  if (heat.conduction.pair) return {d.unaryExpr([&](double far) { return heat.before(far); }), 0};
  const auto growth = [&](double far) { return heat.growth_before(far); };
  const SurfaceCurve x = on_a_side(growth, delta, d, tolerance);
  return {x.temperature * (-2 * heat.conduction.peclet * d).exp(), x.error};
}

struct PointsOnSide {
  std::vector<Index> index;
  std::vector<double> place;
  void add(Index i, double at) {
    index.push_back(i);
    place.push_back(at);
  }
  ArrayXd all() const {
    return Eigen::Map<const ArrayXd>(place.data(), static_cast<Index>(place.size()));
  }
};

void put(const PointsOnSide& x, const SurfaceCurve& found, SurfaceCurve& all) {
  for (std::size_t k = 0; k < x.index.size(); ++k)
    all.temperature(x.index[k]) = found.temperature(static_cast<Index>(k));
  all.error = std::max(all.error, found.error);
}

SurfaceCurve at_many_points(const ZoneLengths& at, const SurfaceHeat& heat, const ArrayXd& s,
                            double tolerance) {
  PointsOnSide before, inside, behind;
  for (Index i = 0; i < s.size(); ++i) {
    const FromEnds x = from_ends(at, s(i));
    if (x.left <= 0)
      before.add(i, -x.left);
    else if (x.right <= 0)
      behind.add(i, -x.right);
    else
      inside.add(i, in_y(x, at).left - 1);
  }
  const double unit = at.slip * at.slip / pi, limit = tolerance / unit;
  const double delta = std::min(1 / heat.conduction.peclet, at.slip);
  const int n = 48 + static_cast<int>(20 * std::log10(1 + heat.conduction.peclet * at.slip));
  const auto in_zone = [&](double y) { return heat.inside(1 + y, 1 - y); };
  const auto out_of_zone = [&](double d) { return heat.behind(d); };
  SurfaceCurve all{ArrayXd(s.size()), 0};
  put(before, temperatures_before(heat, delta, before.all(), limit), all);
  put(inside, at_many_places(in_zone, inside.all(), n, limit), all);
  put(behind, on_a_side(out_of_zone, delta, behind.all(), limit), all);
  return {unit * all.temperature, unit * all.error};
}

/// Estimated error of all temperatures, of which the largest is top, from the largest change by
/// eight more nodes.
double quadrature_error(int nodes, double change, double top) {
  return change / 2 + (6 * std::pow(nodes, -6) + 1e-14) * top;
}

}  // namespace

TemperatureAndSlope temperature_and_slope(const ZoneLengths& zones, const Conduction& conduction,
                                          const VectorXd& h, double left, double right, double gap,
                                          const GaussLegendre& rule) {
  const double slip = zones.slip;
  TemperatureAndSlope sum{0, 0};
  GradedRule graded;
  const VectorXd dh = derivative(h);
  for (const double side : {1.0, -1.0}) {  // right, then left, mirrored
    if (side < 0 && left == 0) continue;
    grade(graded, conduction.peclet * slip, gap, side > 0 ? left : right, side > 0 ? right : left,
          rule, side > 0 ? zones.variable : mirrored(zones.variable));
    if (side > 0) graded.cut(20 / conduction.slowest);
    const GradedArray value = series(side, graded.y, h), slope = series(side, graded.y, dh);
    const GradedArray m = temperature_kernel(conduction, side, graded.zeta);
    sum.value += (m * graded.heat * value).sum();
    sum.slope += (m * (side * graded.by_h * value + graded.by_dh * slope)).sum();
  }
  return {slip * slip / pi * sum.value, slip / pi * sum.slope};
}

TemperatureAndSlope with_series(TemperatureAndSlope sum, const ZoneLengths& zones, double y,
                                const VectorXd& more) {
  if (more.size() == 0) return sum;
  const SlipPoint at(1 + y, 1 - y, zones.variable);
  const auto polynomials = legendre(ArrayXd::Constant(1, y), more.size());
  sum.value += polynomials.row(0).dot(more);
  sum.slope += polynomials.row(0).dot(derivative(more)) / (zones.slip * 6 * at.u * at.v * at.du);
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

HottestPoint largest_of_series(const VectorXd& series) {
  return search([&](double y) {
    const auto polynomials = legendre(ArrayXd::Constant(1, y), series.size());
    return TemperatureAndSlope{polynomials.row(0).dot(series), 0};
  });
}

HottestPoint expected_hottest(const ZoneLengths& zones, double peclet) {
  return {0.36 + 0.065 * zones.slip - 0.33 / (1 + 0.8 * peclet * zones.slip), 0,
          -2.7 - zones.slip / 2};
}

HottestPoint find_hottest(const ZoneLengths& zones, const Conduction& conduction, const VectorXd& h,
                          const HottestPoint& near, const GaussLegendre& rule,
                          const VectorXd& more) {
  const auto temperature = [&](double place) {
    const auto own = temperature_and_slope(zones, conduction, h, 1 + place, 1 - place, 0, rule);
    return with_series(own, zones, place, more);
  };
  const double small = more.size() > 0 ? 0 : std::pow(rule.x.size(), -6);
  double low = -1, high = 1, curvature = near.curvature, y = near.y, last = y, before = 0,
         hottest = more.size() > 0 ? temperature(-1).value : 0;
  for (int step = 0;; ++step) {
    const SlipPoint at(1 + y, 1 - y, zones.variable);
    const TemperatureAndSlope now = temperature(y);
    const double slope = now.slope * zones.slip * 6 * at.u * at.v * at.du / now.value;  // of ln T
    if (step > 0) curvature = (slope - before) / (y - last);
    (slope > 0 ? low : high) = y;
    const bool at_edge = 1 - y < 1e-12;
    const double move = at_edge ? 0 : std::clamp(-slope / curvature, -0.3, 0.3), next = y + move;
    const bool known = step > 0 || near.value > 0;  // the curvature
    const double bend = (step > 0 ? 3 * std::abs(y - last) : 0.03) / (1 - std::abs(y));
    hottest = std::max(hottest, now.value);
    if ((known && (std::abs(move) < 1e-5 || bend * std::abs(slope * move) < small)) || step == 60) {
      if (now.value < hottest * (1 - 1e-6)) return search(temperature);
      return {next, now.value * (1 + slope * move / 2), curvature};
    }
    last = y;
    before = slope;
    y = low < next && next < high ? next : (low + high) / 2;
  }
}

HottestPoint hottest_elsewhere(const ZoneLengths& zones, const Conduction& conduction,
                               const VectorXd& h, const HottestPoint& found,
                               const GaussLegendre& rule, const VectorXd& more) {
  std::vector<HottestPoint> all{found};
  for (const double y : {-0.5, 0.0, 0.2, 0.4, 0.6, 0.8, 0.92, 0.98}) {
    const auto own = temperature_and_slope(zones, conduction, h, 1 + y, 1 - y, 0, rule);
    if (std::abs(y - found.y) > 0.15) all.push_back({y, with_series(own, zones, y, more).value});
  }
  std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.y < b.y; });
  HottestPoint top;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool rises = i == 0 || all[i].value > all[i - 1].value;
    const bool falls = i + 1 == all.size() || all[i].value > all[i + 1].value;
    if (all[i].y != found.y && rises && falls && all[i].value > top.value) top = all[i];
  }
  return top;
}

ArrayXd surface_temperature(const ZoneLengths& at, const Conduction& conduction, const VectorXd& h,
                            const ArrayXd& s, const GaussLegendre& rule) {
  const SurfaceHeat heat = surface_heat(at, conduction, h, rule);
  ArrayXd sums(s.size());
  for (Index i = 0; i < s.size(); ++i) {
    const FromEnds x = from_ends(at, s(i)), y = in_y(x, at);
    if (x.left <= 0)
      sums(i) = heat.before(-x.left);
    else
      sums(i) = x.right <= 0 ? heat.behind(-x.right) : heat.inside(y.left, y.right);
  }
  return at.slip * at.slip / pi * sums;
}

SmoothFlux smooth_flux(const Carter& c) {
  const ZoneLengths at{2 * c.slip_half_width, 2 * c.b};
  return {at.slip, at.stick, carter_h(at, c.friction)};
}

SmoothFlux smooth_flux(const CoupledSolution& x) {
  return {x.value(Quantity::slip_length), 1 + x.value(Quantity::stick_slip_border),
          without_ripples(x.scene, x.h), x.variable};
}

VectorXd without_ripples(const Scene& scene, const VectorXd& h) {
  const double apart = distortions_apart(scene);
  if (scene.bulk_difference == 0 || apart == 0 || h.size() <= 20) return h;
  const ArrayXd degree = ArrayXd::LinSpaced(h.size(), 0, static_cast<double>(h.size() - 1));
  return h.array() * (-36 * (degree / static_cast<double>(h.size())).pow(10)).exp();
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
    some(own + i) = 1 - x.slip * (1 - SlipPoint(1 + y(i), 1 - y(i), x.variable).t());
  const auto with = [&](int nodes, const ArrayXd& at) {
    return surface_temperature(x.zones(), conduction, x.h, at, quadrature_rule(nodes));
  };
  int nodes = 40;
  for (ArrayXd before = with(nodes, some);;) {
    const ArrayXd now = with(nodes += 8, some);
    const double top = now.maxCoeff();
    const double error = quadrature_error(nodes, (now - before).abs().maxCoeff(), top);
    if (error <= tolerance * top / 2 || nodes >= most_unknowns) {
      const SurfaceHeat heat = surface_heat(x.zones(), conduction, x.h, quadrature_rule(nodes));
      const SurfaceCurve all = at_many_points(x.zones(), heat, s, tolerance * top / 2);
      return {all.temperature, error + all.error};
    }
    before = now;
  }
}

Peak hottest_point(const SmoothFlux& x, const Conduction& conduction, double tolerance) {
  int nodes = 40;
  const auto find = [&](const HottestPoint& near) {
    return find_hottest(x.zones(), conduction, x.h, near, quadrature_rule(nodes));
  };
  for (HottestPoint before = find(expected_hottest(x.zones(), conduction.peclet));;) {
    nodes += 8;
    const HottestPoint now = find(before);
    const double error = quadrature_error(nodes, std::abs(now.value - before.value), now.value);
    if (error <= tolerance * now.value || nodes >= most_unknowns) {
      const double moved = std::abs(now.y - before.y) + 1e-9;
      const SlipPoint at(1 + now.y, 1 - now.y, x.variable);
      const double s = (x.stick - x.slip) / 2 + x.slip * at.t();
      const double at_error = 6 * x.slip * at.u * at.v * at.du * moved;
      return {s, at_error, {now.value, error}};
    }
    before = now;
  }
}

}  // namespace thermoroll
