// Tangled from paper/10-coupled-solver.md; edit there.
#include "solver/contact_grid.hpp"

#include <cmath>
#include <map>
#include <new>
#include <vector>

#include <gsl/gsl_integration.h>

#include "model/kernel_table.hpp"
#include "support/simd.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// P_0 ... P_{n-1} at x, a column each.
MatrixXd legendre(const ArrayXd& x, Index n) {
  MatrixXd p = MatrixXd::Ones(x.size(), n);
  if (n > 1) p.col(1) = x;
  for (Index l = 1; l + 1 < n; ++l) {
    const double down = 1 - 1 / static_cast<double>(l + 1);  // l / (l + 1)
    p.col(l + 1) = (1 + down) * x * p.col(l).array() - down * p.col(l - 1).array();
  }
  return p;
}

static GaussLegendre make_rule(int n) {
  GaussLegendre rule{ArrayXd(n), ArrayXd(n), {}, {}, {}};
  const auto size = static_cast<std::size_t>(n);
  gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(size);
  if (table == nullptr) throw std::bad_alloc();
  for (std::size_t i = 0; i < size; ++i) {
    const auto k = static_cast<Index>(i);
    gsl_integration_glfixed_point(-1, 1, i, &rule.x(k), &rule.w(k), table);
  }
  gsl_integration_glfixed_table_free(table);
  rule.rho = (1 + rule.x) / 2, rule.cube = rule.rho.cube();
  const MatrixXd all = legendre(rule.x, n + 1);
  rule.p = all.leftCols(n);
  const ArrayXd slope_of_p_n = n * (all.col(n - 1).array() - rule.x * all.col(n).array());
  rule.w = 2 * (1 - rule.x.square()) / slope_of_p_n.square();
  return rule;
}

const GaussLegendre& gauss_legendre(int n) {
  thread_local std::map<int, GaussLegendre> known;
  auto found = known.find(n);
  if (found == known.end()) found = known.emplace(n, make_rule(n)).first;
  return found->second;
}

MatrixXd to_legendre(const GaussLegendre& rule) {
  const ArrayXd l = ArrayXd::LinSpaced(rule.x.size(), 0, static_cast<double>(rule.x.size() - 1));
  return (l + 0.5).matrix().asDiagonal() * rule.p.transpose() * rule.w.matrix().asDiagonal();
}

VectorXd carter_h(const ZoneLengths& at, double friction) {
  const GaussLegendre& rule = gauss_legendre(10);
  VectorXd h(10);
  for (Index i = 0; i < 10; ++i)
    h(i) = at.stick + at.slip * SlipPoint(1 + rule.x(i), 1 - rule.x(i)).t();
  return 4 * friction / (pi * pi) * (to_legendre(rule) * h);
}

Nodes place_nodes(const ZoneLengths& zones, const GaussLegendre& slip, const GaussLegendre& stick) {
  const Index n = slip.x.size(), m = stick.x.size();
  Nodes z{zones, slip.x, ArrayXd(n), {}, {}, {}, {}, {}, VectorXd(n + m), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    const SlipPoint at(1 + z.y(i), 1 - z.y(i));
    const double du = at.du * slip.w(i), uv = at.u * at.v;
    z.t(i) = at.t();
    z.heat(i) = 6 * uv * uv * at.omega() * du;
    z.over_root(i) = 6 * at.u / std::sqrt(1 + 2 * at.u) * du;
  }
  const double fine = std::min(1.0, std::sqrt(zones.slip / zones.stick));
  const double k = std::log1p(1 / fine);
  const ArrayXd grown = (k * stick.rho).exp(), q = fine * (grown - 1);
  const ArrayXd dq = fine * k / 2 * grown * stick.w;
  z.d = zones.stick * q.square() * (3 - 2 * q);
  z.over_w = 6 * dq / ((3 - 2 * q) * (1 + 2 * q)).sqrt();
  z.over_root.tail(m) = dq * 6 * q / (1 + 2 * q).sqrt();
  z.s = zones.c0() + zones.slip * z.t;
  z.r = zones.c0() - z.d;
  z.sigma = zones.stick + zones.slip * z.t;
  z.over_root.head(n).array() *= (zones.slip / z.sigma).sqrt();
  z.over_root.tail(m).array() *= (zones.stick / (zones.slip + z.d)).sqrt();
  return z;
}

namespace {

template <int columns>
using GradedArrays = Eigen::Array<double, Eigen::Dynamic, columns, 0, most_unknowns + 24, columns>;
using GradedArray = GradedArrays<1>;
using KernelWeights = GradedArrays<5>;
using Sums = Eigen::Matrix<double, 5, Eigen::Dynamic>;

struct GradedRule {
  GradedArray y, zeta, heat, by_h, by_dh;  // places, Pe (t - s), and the weights of @eq:ray-weights
  /// Keep the first nodes, eight by eight, up to where zeta is by so much beyond the first.
  void cut(double reach) {
    const Index heard = ((zeta < zeta[0] + reach).count() + 7) / 8 * 8;
    for (GradedArray* x : {&y, &zeta, &heat, &by_h, &by_dh})
      x->conservativeResize(std::min(heard, y.size()));
  }
};

/// Quadrature nodes from the target at y0 to y = 1; left = 1 + y0 and right = 1 - y0. The gap, in
/// lengths of the slip zone, is that of a target in the stick zone, with left = 0.
void grade(GradedRule& ray, double peclet, double gap, double left, double right,
           const GaussLegendre& rule) {
  const SlipPoint from(left, right);
  const double at_end = 22 * std::sqrt((1 / peclet + gap) / 27);
  const double delta = 6 * std::min(at_end, 1 / (peclet * 6 * from.u * from.v * from.du));
  const double k = std::log1p(right / delta);
  const GradedArray power = k * rule.cube, grown = power.exp();
  GradedArray step = delta * (grown - 1);
  for (Index i = 0; i < step.size() && power[i] < 0.1; ++i) step[i] = delta * std::expm1(power[i]);
  const GradedArray dy = 1.5 * k * delta * rule.w * rule.rho.square() * grown;
  ray.y = from.y + step;
  const GradedArray eta = left + step, rest = right - step;
  const GradedArray u = slip_cubic(eta), v = slip_cubic(rest), du = (3 + 12 * eta * rest) / 22;
  const GradedArray slope = (15 - 4 * (from.y * (from.y + ray.y) + ray.y.square())) / 22;
  const auto near_left = u + from.u < 1;
  const GradedArray x = near_left.select(u + from.u, v + from.v);
  const GradedArray product = near_left.select(u * from.u, v * from.v);
  const GradedArray apart = step * slope * (3 * x - 2 * (x.square() - product));
  ray.zeta = peclet * (apart + gap);
  const GradedArray omega = ((1 + 2 * u) * (1 + 2 * v)).sqrt(), uv = u * v;
  const GradedArray middle = v.square() * (1 + 2 * u) - u.square() * (1 + 2 * v);  // 1 - 2t
  ray.by_dh = uv * omega * dy;
  ray.heat = 6 * uv * du * ray.by_dh;
  ray.by_h = 3 * middle / omega * du * dy;
}

/// The kernels at all of these distances.
std::vector<Kernels> at_distances(const ArrayXd& zeta) {
  std::vector<Kernels> k(static_cast<std::size_t>(zeta.size()));
  fast_kernels(k.size(), zeta.data(), k.data());
  return k;
}

/// N1 with the heat, with h and dh in dg, N2 with the heat, and N2 of the mirrored ray.
void kernel_weights(const GradedRule& ray, KernelWeights& weights) {
  const std::vector<Kernels> kernels = at_distances(ray.zeta);
  weights.resize(ray.y.size(), 5);
  for (Index i = 0; i < ray.y.size(); ++i) {
    const Kernels& k = kernels[static_cast<std::size_t>(i)];
    weights.row(i) << k.n1 * ray.heat(i), k.n1 * ray.by_h(i), k.n1 * ray.by_dh(i),
        k.n2_up * ray.heat(i), k.n2_down * ray.heat(i);
  }
}

/// Column l of sums receives the sums over a ray of its five weights times P_l(y), for all columns.
THERMOROLL_CLONES void legendre_sums(const GradedArray& y, const KernelWeights& weights,
                                     Sums& sums) {
  GradedArray now = GradedArray::Ones(y.size()), next = y;
  Pack4 x, p, q, weight;
  for (Index l = 0; l < sums.cols(); ++l) {
    const double down = 1 - 1 / static_cast<double>(l + 2), up = 1 + down;  // (l + 1) / (l + 2)
    Pack4 sum[5] = {};
    for (Index k = 0; k < y.size(); k += 4) {
      load(&y[k], x), load(&now[k], p), load(&next[k], q);
      for (Index w = 0; w < 5; ++w) load(&weights(k, w), weight), sum[w] += weight * p;
      store(q, &now[k]), store(up * x * q - down * p, &next[k]);
    }
    for (Index w = 0; w < 5; ++w) sums(w, l) = sum_of(sum[w]);
  }
}

MatrixXd by_derivatives(const MatrixXd& sums) {
  MatrixXd x = MatrixXd::Zero(sums.rows(), sums.cols());
  for (Index l = 1; l < x.cols(); ++l) {
    x.col(l) = static_cast<double>(2 * l - 1) * sums.col(l - 1);
    if (l > 1) x.col(l) += x.col(l - 2);
  }
  return x;
}

/// The sums of c(l) P_l(side y), twice four nodes at a time, as each term waits for the last.
THERMOROLL_CLONES GradedArray series(double side, const GradedArray& y, const VectorXd& c) {
  GradedArray sums(y.size());
  VectorXd down(c.size());
  for (Index l = 0; l < c.size(); ++l) down(l) = 1 - 1 / static_cast<double>(l + 2);
  for (Index k = 0; k < y.size(); k += 8) {
    Pack4 x, z;
    load(&y[k], x), load(&y[k + 4], z);
    x *= side, z *= side;
    Pack4 a = {}, p = a + 1, q = x, b = {}, u = p, v = z;
    for (Index l = 0; l < c.size(); ++l) {
      a += c(l) * p, b += c(l) * u;
      const Pack4 then = (1 + down(l)) * x * q - down(l) * p;
      const Pack4 next = (1 + down(l)) * z * v - down(l) * u;
      p = q, q = then, u = v, v = next;
    }
    store(a, &sums[k]), store(b, &sums[k + 4]);
  }
  return sums;
}

/// The coefficients of the derivative.
VectorXd derivative(const VectorXd& c) {
  VectorXd d = VectorXd::Zero(c.size());
  for (Index l = c.size() - 2; l >= 0; --l)
    d(l) = static_cast<double>(2 * l + 1) *
           (c(l + 1) + (l + 2 < c.size() ? d(l + 2) / static_cast<double>(2 * l + 5) : 0));
  return d;
}

constexpr double underflow_distance = 350;  // exp(-2 zeta) is 1e-304 here

/// M(side zeta), zeta > 0.
GradedArray temperature_kernel(double side, const GradedArray& zeta) {
  const std::vector<Kernels> k = at_distances(zeta);
  GradedArray m(zeta.size());
  for (Index i = 0; i < m.size(); ++i) m[i] = k[static_cast<std::size_t>(i)].m_down;
  if (side > 0) m *= (zeta < underflow_distance).select((-2 * zeta).exp(), 0);
  return m;
}

/// The sum of M times the heat, at a distance from the start of the ray.
double temperature_sum(const GradedRule& ray, const GradedArray& heat, double side,
                       double distance) {
  if (side > 0 && distance > underflow_distance) return 0;
  return (temperature_kernel(side, ray.zeta + distance) * heat).sum();
}

}  // namespace

double distance_of_share(double t) {
  const double phi = 2 * std::asin(std::sqrt(t));
  const double u = 2 * std::cos((pi - phi) / 6) * std::sin(phi / 6), root = std::sqrt(5.0);
  const double eta = 1 + root * std::sin(std::asin(22 * (u - 0.5) / (5 * root)) / 3);
  return eta - (slip_cubic(eta) - u) * 22 / (3 + 12 * eta * (2 - eta));
}

ThermalTerms thermal_terms(const Scene& scene, Formulation formulation, const Nodes& z, Index terms,
                           const GaussLegendre& rule) {
  const Index n = z.y.size(), m = z.d.size();
  const double slip = z.zones.slip, peclet = scene.peclet * slip;
  const double sign = slope_sign(formulation), in_n = -sign * scene.friction;  // @eq:N
  ThermalTerms x{MatrixXd(n + m, terms), MatrixXd(n, terms), MatrixXd::Zero(n + m, terms)};
  GradedRule ray;
  KernelWeights weights;
  Sums sums(5, terms);
  MatrixXd by_dh(n, terms);
  RowVectorXd mirror = RowVectorXd::Ones(terms);
  for (Index l = 1; l < terms; l += 2) mirror(l) = -1;
  for (Index i = 0; i < n; ++i) {
    grade(ray, peclet, 0, 1 + z.y(i), 1 - z.y(i), rule);
    kernel_weights(ray, weights);
    legendre_sums(ray.y, weights, sums);
    x.f.row(i) = sums.row(0), x.df.row(i) = sums.row(1), by_dh.row(i) = sums.row(2);
    x.g.row(i) += sums.row(3), x.g.row(n - 1 - i) += sums.row(4).cwiseProduct(mirror);
  }
  x.df += by_derivatives(by_dh);
  const ArrayXd gap = z.d / slip;
  grade(ray, peclet, gap.minCoeff(), 0, 2, rule);
  MatrixXd n1(m, ray.y.size()), n2 = n1;
  const ArrayXd further = peclet * (gap - gap.minCoeff());
  for (Index i = 0; i < ray.y.size(); ++i) {
    const std::vector<Kernels> k = at_distances(ray.zeta(i) + further);
    for (Index j = 0; j < m; ++j) {
      const Kernels& at = k[static_cast<std::size_t>(j)];
      n1(j, i) = at.n1, n2(j, i) = at.n2_up;
    }
  }
  const MatrixXd heat = ray.heat.matrix().asDiagonal() * legendre(ray.y, terms);
  x.f.bottomRows(m).noalias() = n1 * heat, x.g.bottomRows(m).noalias() = n2 * heat;
  const double strength = scene.friction * scene.peclet * scene.heating * slip;
  x.g = strength * slip * (x.g / pi + in_n * x.f);
  x.f *= -sign * strength * slip, x.df *= -sign * strength;
  return x;
}

TractionOperators traction_operators(const Nodes& z, const ThermalTerms& thermal, double friction) {
  const Index n = z.y.size(), m = z.d.size();
  VectorXd position(n + m);
  position << z.s, z.r;
  TractionOperators x{2 / pi, 2 * friction / pi, {}, {}, {}, {}};
  x.gamma0 = z.over_root.transpose() * thermal.f / pi;
  x.kappa = z.over_root.cwiseProduct(position).transpose() * thermal.f;
  MatrixXd in_p(n, n + m), in_v(n, m);
  for (Index i = 0; i < n; ++i) {
    const SlipPoint at(1 + z.y(i), 1 - z.y(i));
    for (Index j = 0; j < n; ++j) {
      const SlipPoint to(1 + z.y(j), 1 - z.y(j));
      in_p(i, j) = j == i ? 0 : z.over_root(j) / (z.zones.slip * t_difference(at, to, to.y - at.y));
    }
    const ArrayXd away = z.zones.slip * z.t(i) + z.d;  // s - r
    in_p.row(i).tail(m) = -z.over_root.tail(m).array() / away;
    in_v.row(i) = z.over_w / away;
  }
  const VectorXd all_p = in_p.rowwise().sum(), less_v = -in_v.rowwise().sum();
  x.p = all_p.asDiagonal() * thermal.f.topRows(n) - z.over_root.head(n).asDiagonal() * thermal.df;
  x.v = less_v.asDiagonal() * thermal.g.topRows(n);
  x.p.noalias() -= in_p * thermal.f;
  x.v.noalias() += in_v * thermal.g.bottomRows(m);
  x.p = (x.p.rowwise() + 2 * x.kappa) / pi;
  x.v = (x.v.rowwise() + 2 * friction * x.kappa) / pi;
  return x;
}

ContactGrid contact_grid(const Scene& scene, Formulation formulation, const ZoneLengths& zones,
                         const GridRules& rules, Index terms) {
  const Nodes nodes = place_nodes(zones, rules.slip, rules.stick);
  const ThermalTerms thermal = thermal_terms(scene, formulation, nodes, terms, rules.ray);
  return {scene, rules, nodes, thermal, traction_operators(nodes, thermal, scene.friction)};
}

ContactGrid contact_grid(const Scene& scene, Formulation formulation, const ZoneLengths& zones,
                         int n) {
  return contact_grid(scene, formulation, zones, GridRules(n, zones, scene.peclet), n);
}

Resultants resultants(const ContactGrid& grid, const VectorXd& h) {
  const Nodes& z = grid.nodes;
  const double f = grid.scene.friction, a0 = z.zones.stick / 2;
  const double more = grid.tractions.kappa.dot(h), kappa = 1 + more;
  const double lost = (1 + a0) * z.zones.slip / 2 - more * a0 * a0;  // 1 - kappa a0^2
  const ArrayXd g = (grid.thermal.g.bottomRows(z.d.size()) * h).array() * z.over_w;
  return {kappa, grid.tractions.gamma0.dot(h), g.sum() / pi + f * kappa / pi * z.zones.slip,
          f * lost + ((a0 - z.d) * g).sum()};
}

TemperatureAndSlope temperature_and_slope(double slip, double peclet, const VectorXd& h,
                                          double left, double right, double gap,
                                          const GaussLegendre& rule) {
  TemperatureAndSlope sum{0, 0};
  GradedRule ray;
  const VectorXd dh = derivative(h);
  for (const double side : {1.0, -1.0}) {  // right, then left, mirrored
    if (side < 0 && left == 0) continue;
    grade(ray, peclet * slip, gap, side > 0 ? left : right, side > 0 ? right : left, rule);
    if (side > 0) ray.cut(20);
    const GradedArray value = series(side, ray.y, h), slope = series(side, ray.y, dh);
    const GradedArray m = temperature_kernel(side, ray.zeta);
    sum.value += (m * ray.heat * value).sum();
    sum.slope += (m * (side * ray.by_h * value + ray.by_dh * slope)).sum();
  }
  return {slip * slip / pi * sum.value, slip / pi * sum.slope};
}

/// The hottest point by temperatures alone.
HottestPoint search(double slip, double peclet, const VectorXd& h, const GaussLegendre& rule) {
  const auto value = [&](double y) {
    return std::abs(y) < 1 ? temperature_and_slope(slip, peclet, h, 1 + y, 1 - y, 0, rule).value
                           : 0;
  };
  HottestPoint top{0, 0};
  for (double apart = 1.0 / 16; apart > 1e-5; apart /= 8) {
    const double middle = top.y;
    for (int i = -16; i <= 16; ++i) {
      const double y = middle + i * apart, now = value(y);
      if (now > top.value) top.y = y, top.value = now;
    }
  }
  return top;
}

HottestPoint find_hottest(double slip, double peclet, const VectorXd& h, const HottestPoint& near,
                          const GaussLegendre& rule) {
  double low = -1, high = 1, curvature = near.curvature, y = near.y, last = y, before = 0,
         hottest = 0;
  for (int step = 0;; ++step) {
    const SlipPoint at(1 + y, 1 - y);
    const TemperatureAndSlope now = temperature_and_slope(slip, peclet, h, 1 + y, 1 - y, 0, rule);
    const double slope = now.slope * slip * 6 * at.u * at.v * at.du / now.value;  // of ln T, by y
    if (step > 0) curvature = (slope - before) / (y - last);
    (slope > 0 ? low : high) = y;
    const double move = std::clamp(-slope / curvature, -0.3, 0.3), next = y + move;
    const bool known = step > 0 || near.value > 0;  // the curvature
    hottest = std::max(hottest, now.value);
    if ((known && std::abs(move) < 1e-5) || step == 60) {
      if (now.value < hottest * (1 - 1e-6)) return search(slip, peclet, h, rule);
      return {next, now.value * (1 + slope * move / 2), curvature};
    }
    last = y, before = slope;
    y = low < next && next < high ? next : (low + high) / 2;
  }
}

/// p-hat at all nodes; v-hat at the slip nodes, and on the stick zone the bracket of
/// @eq:corrective-inverse. From s = -1 on: the stick nodes reversed, then the slip nodes.
Factors factors(const ContactGrid& grid, const VectorXd& h) {
  const Nodes& z = grid.nodes;
  const TractionOperators& x = grid.tractions;
  const Index n = z.y.size(), m = z.d.size();
  const double friction = grid.scene.friction, kappa = 1 + x.kappa.dot(h);
  const ArrayXd f = grid.thermal.f * h, g = grid.thermal.g.bottomRows(m) * h;
  const GaussLegendre& stick = grid.rules.stick;
  const ArrayXd dx_dr = -stick.w / (z.over_w * (z.d * (z.zones.stick - z.d)).sqrt());
  const MatrixXd to = to_legendre(stick), slopes = by_derivatives(stick.p);
  const ArrayXd df = dx_dr * (slopes * (to * f.tail(m).matrix())).array();
  const ArrayXd dg = dx_dr * (slopes * (to * g.matrix())).array();
  const ArrayXd over_root = z.over_root.array();
  ArrayXd p = 2 * kappa - over_root.tail(m) * df, v = 2 * friction * kappa - z.over_w * dg;
  for (Index i = 0; i < m; ++i) {
    const ArrayXd to_slip = z.zones.slip * z.t + z.d(i);
    p(i) -= (over_root.head(n) * (f.head(n) - f(n + i)) / to_slip).sum();
    ArrayXd distance = z.d(i) - z.d;
    distance(i) = 1;  // where nothing is divided, as f - f is 0
    p(i) -= (over_root.tail(m) * (f.tail(m) - f(n + i)) / distance).sum();
    v(i) -= (z.over_w * (g - g(i)) / distance).sum();
  }
  p /= pi;
  v /= pi;
  ArrayXd pressure(m + n), slip(m + n), s(m + n);
  pressure << p.reverse(), x.p0 + (x.p * h).array();
  slip << v.reverse(), x.v0 + (x.v * h).array();
  s << z.r.reverse(), z.s;
  return {friction, z.zones.c0(), kappa, s, pressure, slip};
}

ArrayXd surface_temperature(const ZoneLengths& border, double peclet, const VectorXd& h,
                            const ArrayXd& s, const GaussLegendre& rule) {
  const double slip = border.slip;
  GradedRule first, last, ray;
  grade(first, peclet * slip, 0, 0, 2, rule), grade(last, peclet * slip, 0, 0, 2, rule);
  first.cut(20);
  const GradedArray at_first = first.heat * series(1, first.y, h);
  const GradedArray at_last = last.heat * series(-1, last.y, h);
  ArrayXd sums(s.size());
  for (Index i = 0; i < s.size(); ++i) {
    const double right = 1 - s(i);
    const double left = slip < border.stick ? slip - right : 1 + s(i) - border.stick;
    if (left <= 0) {
      sums(i) = temperature_sum(first, at_first, 1, -peclet * left);
    } else if (right <= 0) {
      sums(i) = temperature_sum(last, at_last, -1, -peclet * right);
    } else {
      const double share = std::min({left, right, slip / 2}) / slip;
      const double near = distance_of_share(share), far = 2 - near;
      const auto from = [&](double behind, double ahead, double side) {
        grade(ray, peclet * slip, 0, behind, ahead, rule);
        if (side > 0) ray.cut(20);
        return temperature_sum(ray, ray.heat * series(side, ray.y, h), side, 0);
      };
      sums(i) = left < right ? from(near, far, 1) + from(far, near, -1)
                             : from(far, near, 1) + from(near, far, -1);
    }
  }
  return slip * slip / pi * sums;
}

}  // namespace thermoroll
