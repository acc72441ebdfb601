// Tangled from paper/10-coupled-solver.md; edit there.
#include "operators.hpp"

#include <cmath>
#include <map>
#include <new>

#include <gsl/gsl_integration.h>

#include "fast_kernels.hpp"

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

static Rule make_rule(int n) {
  Rule rule{ArrayXd(n), ArrayXd(n), {}, {}, {}};
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

const Rule& gauss_legendre(int n) {
  thread_local std::map<int, Rule> known;
  auto found = known.find(n);
  if (found == known.end()) found = known.emplace(n, make_rule(n)).first;
  return found->second;
}

MatrixXd to_legendre(const Rule& rule) {
  const ArrayXd l = ArrayXd::LinSpaced(rule.x.size(), 0, static_cast<double>(rule.x.size() - 1));
  return (l + 0.5).matrix().asDiagonal() * rule.p.transpose() * rule.w.matrix().asDiagonal();
}

VectorXd carter_h(const Border& at, double friction) {
  const Rule& rule = gauss_legendre(10);
  VectorXd h(10);
  for (Index i = 0; i < 10; ++i)
    h(i) = at.stick + at.slip * Place(1 + rule.x(i), 1 - rule.x(i)).t();
  return 4 * friction / (pi * pi) * (to_legendre(rule) * h);
}

Zones zones(const Border& border, const Rule& slip, const Rule& stick) {
  const Index n = slip.x.size(), m = stick.x.size();
  Zones z{border, slip.x, ArrayXd(n), {}, {}, {}, {}, VectorXd(n + m), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    const Place at(1 + z.y(i), 1 - z.y(i));
    const double du = at.du * slip.w(i), uv = at.u * at.v;
    z.t(i) = at.t(), z.heat(i) = 6 * uv * uv * at.omega() * du;
    z.over_root(i) = 6 * at.u / std::sqrt(1 + 2 * at.u) * du;
  }
  const double fine = std::min(1.0, std::sqrt(border.slip / border.stick));
  const double k = std::log1p(1 / fine);
  const ArrayXd grown = (k * stick.rho).exp(), q = fine * (grown - 1);
  const ArrayXd dq = fine * k / 2 * grown * stick.w;
  z.d = border.stick * q.square() * (3 - 2 * q);
  z.over_w = 6 * dq / ((3 - 2 * q) * (1 + 2 * q)).sqrt();
  z.over_root.tail(m) = dq * 6 * q / (1 + 2 * q).sqrt();
  z.s = border.c0() + border.slip * z.t, z.r = border.c0() - z.d;
  z.over_root.head(n).array() *= (border.slip / (border.stick + border.slip * z.t)).sqrt();
  z.over_root.tail(m).array() *= (border.stick / (border.slip + z.d)).sqrt();
  return z;
}

namespace {

template <int columns>
using RayArrays = Eigen::Array<double, Eigen::Dynamic, columns, 0, most_unknowns + 24, columns>;
using RayArray = RayArrays<1>;
using RayWeights = RayArrays<5>;
using Sums = Eigen::Matrix<double, 5, Eigen::Dynamic>;

struct Ray {
  RayArray y, zeta, heat, by_h, by_dh;  // places, Pe (t - s), and the weights of @eq:ray-weights
  /// Keep the first nodes, eight by eight, up to where zeta is by so much beyond the first.
  void cut(double reach) {
    const Index heard = ((zeta < zeta[0] + reach).count() + 7) / 8 * 8;
    for (RayArray* x : {&y, &zeta, &heat, &by_h, &by_dh})
      x->conservativeResize(std::min(heard, y.size()));
  }
};

/// Quadrature nodes from the target at y0 to y = 1; left = 1 + y0 and right = 1 - y0. The gap, in
/// lengths of the slip zone, is that of a target in the stick zone, with left = 0.
void cast(Ray& ray, double peclet, double gap, double left, double right, const Rule& rule) {
  const Place from(left, right);
  const double at_end = 22 * std::sqrt((1 / peclet + gap) / 27);
  const double delta = 6 * std::min(at_end, 1 / (peclet * 6 * from.u * from.v * from.du));
  const double k = std::log1p(right / delta);
  const RayArray power = k * rule.cube, grown = power.exp();
  RayArray step = delta * (grown - 1);
  for (Index i = 0; i < step.size() && power[i] < 0.1; ++i) step[i] = delta * std::expm1(power[i]);
  const RayArray dy = 1.5 * k * delta * rule.w * rule.rho.square() * grown;
  ray.y = from.y + step;
  const RayArray eta = left + step, rest = right - step;
  const RayArray u = rise(eta), v = rise(rest), du = (3 + 12 * eta * rest) / 22;
  const RayArray slope = (15 - 4 * (from.y * (from.y + ray.y) + ray.y.square())) / 22;
  const auto near_left = u + from.u < 1;
  const RayArray x = near_left.select(u + from.u, v + from.v);
  const RayArray product = near_left.select(u * from.u, v * from.v);
  const RayArray apart = step * slope * (3 * x - 2 * (x.square() - product));
  ray.zeta = peclet * (apart + gap);
  const RayArray omega = ((1 + 2 * u) * (1 + 2 * v)).sqrt(), uv = u * v;
  const RayArray middle = v.square() * (1 + 2 * u) - u.square() * (1 + 2 * v);  // 1 - 2t
  ray.by_dh = uv * omega * dy;
  ray.heat = 6 * uv * du * ray.by_dh;
  ray.by_h = 3 * middle / omega * du * dy;
}

/// N1 with the heat, with h and dh in dg, N2 with the heat, and N2 of the mirrored ray.
void weigh(const Ray& ray, RayWeights& weights) {
  weights.resize(ray.y.size(), 5);
  for (Index i = 0; i < ray.y.size(); ++i) {
    const Kernels k = fast_kernels(ray.zeta(i));
    weights.row(i) << k.n1 * ray.heat(i), k.n1 * ray.by_h(i), k.n1 * ray.by_dh(i),
        k.n2_up * ray.heat(i), k.n2_down * ray.heat(i);
  }
}

/// Column l of sums receives the sums over a ray of its five weights times P_l(y), for all columns.
void legendre_sums(const RayArray& y, const RayWeights& weights, Sums& sums) {
  RayArray now = RayArray::Ones(y.size()), next = y;
  for (Index l = 0; l < sums.cols(); ++l) {
    const double down = 1 - 1 / static_cast<double>(l + 2);  // (l + 1) / (l + 2)
    double a = 0, b = 0, c = 0, d = 0, e = 0;
    for (Index i = 0; i < y.size(); ++i) {
      const double p = now[i];
      a += weights(i, 0) * p, b += weights(i, 1) * p, c += weights(i, 2) * p;
      d += weights(i, 3) * p, e += weights(i, 4) * p;
      now[i] = next[i], next[i] = (1 + down) * y[i] * next[i] - down * p;
    }
    sums.col(l) << a, b, c, d, e;
  }
}

RowVectorXd by_derivatives(const RowVectorXd& sums) {
  RowVectorXd x = RowVectorXd::Zero(sums.size());
  for (Index l = 1; l < x.size(); ++l)
    x(l) = (l > 1 ? x(l - 2) : 0) + static_cast<double>(2 * l - 1) * sums(l - 1);
  return x;
}

RowVectorXd mirrored(RowVectorXd sums) {
  for (Index l = 1; l < sums.size(); l += 2) sums(l) = -sums(l);
  return sums;
}

/// The heat times h at the nodes of a ray to the right (side 1) or, mirrored, to the left (-1);
/// eight nodes at a time, by Clenshaw's recurrence.
RayArray heat_on(const Ray& ray, const VectorXd& h, double side) {
  using Eight = Eigen::Array<double, 8, 1>;
  RayArray heat(ray.y.size());
  for (Index i = 0; i < heat.size(); i += 8) {
    const Eight y = side * ray.y.segment<8>(i);
    Eight now = Eight::Zero(), before = now;
    for (Index l = h.size() - 1; l >= 0; --l) {
      const double down = 1 / static_cast<double>(l + 1), next = 1 / static_cast<double>(l + 2);
      const Eight sum = h(l) + (2 - down) * y * now - (1 - next) * before;
      before = now, now = sum;
    }
    heat.segment<8>(i) = ray.heat.segment<8>(i) * now;
  }
  return heat;
}

/// The sum of M times the heat, at a distance from the start of the ray.
double felt(const Ray& ray, const RayArray& heat, double side, double distance) {
  double sum = 0;
  for (Index i = 0; i < ray.y.size(); ++i)
    sum += fast_temperature(side * (ray.zeta[i] + distance)) * heat[i];
  return sum;
}

}  // namespace

double distance_of_share(double t) {
  const double phi = 2 * std::asin(std::sqrt(t));
  const double u = 2 * std::cos((pi - phi) / 6) * std::sin(phi / 6), root = std::sqrt(5.0);
  const double eta = 1 + root * std::sin(std::asin(22 * (u - 0.5) / (5 * root)) / 3);
  return eta - (rise(eta) - u) * 22 / (3 + 12 * eta * (2 - eta));
}

ArrayXd slope_at_nodes(const Rule& rule, const ArrayXd& values) {
  const VectorXd coefficients = to_legendre(rule) * values.matrix();
  ArrayXd slopes(values.size());
  for (Index i = 0; i < slopes.size(); ++i)
    slopes(i) = by_derivatives(rule.p.row(i)).dot(coefficients);
  return slopes;
}

ThermalSides thermal_sides(const Scene& scene, Formulation formulation, const Zones& z, Index terms,
                           const Rule& rule) {
  const Index n = z.y.size(), m = z.d.size();
  const double slip = z.border.slip, peclet = scene.peclet * slip;
  const double sign = slope_sign(formulation), in_n = -sign * scene.friction;  // @eq:N
  MatrixXd slope(n + m, terms), dslope(n, terms), strain = MatrixXd::Zero(n + m, terms);
  Ray ray;
  RayWeights weights;
  Sums sums(5, terms);
  for (Index i = 0; i < n; ++i) {
    cast(ray, peclet, 0, 1 + z.y(i), 1 - z.y(i), rule);
    weigh(ray, weights);
    legendre_sums(ray.y, weights, sums);
    slope.row(i) = sums.row(0), dslope.row(i) = sums.row(1) + by_derivatives(sums.row(2));
    strain.row(i) += sums.row(3), strain.row(n - 1 - i) += mirrored(sums.row(4));
  }
  const ArrayXd gap = z.d / slip;
  cast(ray, peclet, gap.minCoeff(), 0, 2, rule);
  MatrixXd n1(ray.y.size(), m), n2 = n1;
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < ray.y.size(); ++i) {
      const Kernels k = fast_kernels(ray.zeta(i) + peclet * (gap(j) - gap.minCoeff()));
      n1(i, j) = k.n1, n2(i, j) = k.n2_up;
    }
  const MatrixXd heat = ray.heat.matrix().asDiagonal() * legendre(ray.y, terms);
  slope.bottomRows(m) = n1.transpose() * heat, strain.bottomRows(m) = n2.transpose() * heat;
  const double strength = scene.friction * scene.peclet * scene.heating * slip;
  return {-sign * strength * slip * slope, -sign * strength * dslope,
          strength * slip * (strain / pi + in_n * slope)};
}

Inverses invert(const Zones& z, const ThermalSides& sides, double friction) {
  const Index n = z.y.size(), m = z.d.size();
  VectorXd position(n + m);
  position << z.s, z.r;
  Inverses x;
  x.gamma0 = z.over_root.transpose() * sides.f / pi;
  x.kappa = z.over_root.cwiseProduct(position).transpose() * sides.f;
  MatrixXd in_p(n, n + m), in_v(n, m);
  for (Index i = 0; i < n; ++i) {
    const Place at(1 + z.y(i), 1 - z.y(i));
    for (Index j = 0; j < n; ++j) {
      const Place to(1 + z.y(j), 1 - z.y(j));
      in_p(i, j) = j == i ? 0 : z.over_root(j) / (z.border.slip * apart(at, to, to.y - at.y));
    }
    const ArrayXd away = z.border.slip * z.t(i) + z.d;  // s - r
    in_p.row(i).tail(m) = -z.over_root.tail(m).array() / away;
    in_v.row(i) = z.over_w / away;
  }
  x.p = in_p.rowwise().sum().asDiagonal() * sides.f.topRows(n) - in_p * sides.f;
  x.p -= z.over_root.head(n).asDiagonal() * sides.df;
  x.v = in_v * sides.g.bottomRows(m) - in_v.rowwise().sum().asDiagonal() * sides.g.topRows(n);
  x.p = (x.p.rowwise() + 2 * x.kappa) / pi, x.v = (x.v.rowwise() + 2 * friction * x.kappa) / pi;
  return x;
}

Loads loads(const Zones& z, const ThermalSides& sides, const Inverses& x, double friction,
            const VectorXd& h) {
  const double a0 = z.border.stick / 2, more = x.kappa.dot(h), kappa = 1 + more;
  const double lost = (1 + a0) * z.border.slip / 2 - more * a0 * a0;  // 1 - kappa a0^2
  const ArrayXd g = (sides.g.bottomRows(z.d.size()) * h).array() * z.over_w;
  return {kappa, x.gamma0.dot(h), g.sum() / pi + friction * kappa / pi * z.border.slip,
          friction * lost + ((a0 - z.d) * g).sum()};
}

Warmth warmth(double slip, double peclet, const VectorXd& h, double left, double right, double gap,
              const Rule& rule) {
  Warmth sum{0, 0};
  Ray ray;
  for (const double side : {1.0, -1.0}) {  // right, then left, mirrored
    if (side < 0 && left == 0) continue;
    cast(ray, peclet * slip, gap, side > 0 ? left : right, side > 0 ? right : left, rule);
    if (side > 0) ray.cut(20);
    RayArray value = RayArray::Zero(ray.y.size()), slope = value, now = value + 1, before = value;
    RayArray dnow = value, dbefore = value;
    for (Index l = 0; l < h.size(); ++l) {
      const double part = side < 0 && l % 2 == 1 ? -h(l) : h(l);
      const double up = 2 - 1 / static_cast<double>(l + 1);  // (2l + 1) / (l + 1)
      value += part * now, slope += part * dnow;
      const RayArray next = up * ray.y * now - (up - 1) * before;  // P_{l+1}
      dbefore += static_cast<double>(2 * l + 1) * now;             // P'_{l+1}
      before = now, now = next, dnow.swap(dbefore);
    }
    for (Index i = 0; i < ray.y.size(); ++i) {
      const double m = fast_temperature(side * ray.zeta(i));
      sum.value += m * ray.heat(i) * value(i);
      sum.slope += side * m * (ray.by_h(i) * value(i) + ray.by_dh(i) * slope(i));
    }
  }
  return {slip * slip / pi * sum.value, slip / pi * sum.slope};
}

Summit climb(double slip, double peclet, const VectorXd& h, const Summit& near, const Rule& rule) {
  double low = -1, high = 1, bend = near.bend, y = near.y, last = y, before = 0;
  for (int step = 0;; ++step) {
    const Place at(1 + y, 1 - y);
    const Warmth now = warmth(slip, peclet, h, 1 + y, 1 - y, 0, rule);
    const double slope = now.slope * slip * 6 * at.u * at.v * at.du / now.value;  // of ln T, by y
    if (step > 0) bend = (slope - before) / (y - last);
    (slope > 0 ? low : high) = y;
    const double move = std::clamp(-slope / bend, -0.3, 0.3), next = y + move;
    const bool known = step > 0 || near.value > 0;  // the curvature
    if ((known && std::abs(move) < 1e-5) || step == 60)
      return {next, now.value * (1 + slope * move / 2), bend};
    last = y, before = slope;
    y = low < next && next < high ? next : (low + high) / 2;
  }
}

/// p-hat at all nodes; v-hat at the slip nodes, and on the stick zone the bracket of
/// @eq:corrective-inverse. From s = -1 on: the stick nodes reversed, then the slip nodes.
Factors factors(const Rules& rules, const Zones& z, const ThermalSides& sides, const Inverses& x,
                double friction, const VectorXd& h) {
  const Index n = z.y.size(), m = z.d.size();
  const double kappa = 1 + x.kappa.dot(h);
  const ArrayXd f = sides.f * h, g = sides.g.bottomRows(m) * h;
  const ArrayXd dx_dr = -rules.stick.w / (z.over_w * (z.d * (z.border.stick - z.d)).sqrt());
  const ArrayXd df = dx_dr * slope_at_nodes(rules.stick, f.tail(m));
  const ArrayXd dg = dx_dr * slope_at_nodes(rules.stick, g);
  ArrayXd from_border(m + n), pressure(m + n), slip(m + n), s(m + n);
  from_border << -z.d, z.border.slip * z.t;
  const ArrayXd over_root = z.over_root.array();
  ArrayXd p = 2 * kappa - over_root.tail(m) * df, v = 2 * friction * kappa - z.over_w * dg;
  for (Index i = 0; i < m; ++i) {
    for (Index j = 0; j < n; ++j)
      p(i) -= over_root(j) * (f(j) - f(n + i)) / (z.border.slip * z.t(j) + z.d(i));
    for (Index j = 0; j < m; ++j) {
      if (j == i) continue;
      const double apart = z.d(i) - z.d(j);
      p(i) -= over_root(n + j) * (f(n + j) - f(n + i)) / apart;
      v(i) -= z.over_w(j) * (g(j) - g(i)) / apart;
    }
  }
  p /= pi, v /= pi;
  pressure << p.reverse(), 2 / pi + (x.p * h).array();
  slip << v.reverse(), 2 * friction / pi + (x.v * h).array();
  s << z.r.reverse(), z.s;
  return {friction, z.border.c0(), kappa, s, pressure, slip};
}

ArrayXd surface_temperature(const Border& border, double peclet, const VectorXd& h,
                            const ArrayXd& s, const Rule& rule) {
  const double slip = border.slip;
  Ray first, last, ray;
  cast(first, peclet * slip, 0, 0, 2, rule), cast(last, peclet * slip, 0, 0, 2, rule);
  first.cut(20);
  const RayArray at_first = heat_on(first, h, 1), at_last = heat_on(last, h, -1);
  ArrayXd sums(s.size());
  for (Index i = 0; i < s.size(); ++i) {
    const double right = 1 - s(i);
    const double left = slip < border.stick ? slip - right : 1 + s(i) - border.stick;
    if (left <= 0) {
      sums(i) = felt(first, at_first, 1, -peclet * left);
    } else if (right <= 0) {
      sums(i) = felt(last, at_last, -1, -peclet * right);
    } else {
      const double share = std::min({left, right, slip / 2}) / slip;
      const double near = distance_of_share(share), far = 2 - near;
      const auto from = [&](double behind, double ahead, double side) {
        cast(ray, peclet * slip, 0, behind, ahead, rule);
        if (side > 0) ray.cut(20);
        return felt(ray, heat_on(ray, h, side), side, 0);
      };
      sums(i) = left < right ? from(near, far, 1) + from(far, near, -1)
                             : from(far, near, 1) + from(near, far, -1);
    }
  }
  return slip * slip / pi * sums;
}

}  // namespace thermoroll
