// Tangled from paper/12-coupled-problem.md; edit there.
#include "solver/nodes.hpp"

#include <cmath>
#include <vector>

#include "support/simd.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd carter_h(const ZoneLengths& at, double friction) {
  const GaussLegendre& rule = gauss_legendre(10);
  VectorXd h(10);
  for (Index i = 0; i < 10; ++i)
    h(i) = at.stick + at.slip * SlipPoint(1 + rule.x(i), 1 - rule.x(i)).t();
  return 4 * friction / (pi * pi) * to_legendre(rule, h);
}

Nodes place_nodes(const ZoneLengths& zones, const GaussLegendre& slip, const GaussLegendre& stick,
                  double layer) {
  const Index n = slip.x.size(), m = stick.x.size();
  Nodes z{zones, slip.x, ArrayXd(n), {}, {}, {}, {}, {}, VectorXd(n + m), VectorXd(n)};
  for (Index i = 0; i < n; ++i) {
    const SlipPoint at(1 + z.y(i), 1 - z.y(i), zones.variable);
    const double du = at.du * slip.w(i), uv = at.u * at.v;
    z.t(i) = at.t();
    z.heat(i) = 6 * uv * uv * at.omega() * du;
    z.over_root(i) = 6 * at.u / std::sqrt(1 + 2 * at.u) * du;
  }
  const double fine = std::min(1.0, std::sqrt(std::min(zones.slip, layer) / zones.stick));
  const double ell = std::log1p(1 / fine);
  const ArrayXd grown = (ell * stick.rho).exp(), q = fine * (grown - 1);
  const ArrayXd dq = fine * ell / 2 * grown * stick.w;
  z.d = zones.stick * q.square() * (3 - 2 * q);
  z.over_w = 6 * dq / ((3 - 2 * q) * (1 + 2 * q)).sqrt();
  z.over_root.tail(m) = dq * 6 * q / (1 + 2 * q).sqrt();
  z.s = zones.c0() + zones.slip * z.t;
  z.r = zones.c0() - z.d;
  z.sigma = zones.stick + zones.slip * z.t;
  z.over_root.head(n).array() *= (zones.slip / z.sigma).sqrt();
  z.over_root.tail(m).array() *= (zones.stick / (zones.slip + z.d)).sqrt();
  if (zones.stick == 0) z.sigma.setOnes();
  return z;
}

/// Padded to a multiple of four, with ones for the sums and zeros otherwise.
struct Fours {
  GradedArray y, u, v, sum;
};

Fours in_fours(const std::vector<SlipPoint>& points) {
  const auto n = static_cast<Index>(points.size());
  const GradedArray zero = GradedArray::Zero((n + 3) / 4 * 4);
  Fours all{zero, zero, zero, zero + 1};
  for (Index i = 0; i < n; ++i) {
    const SlipPoint& x = points[static_cast<std::size_t>(i)];
    all.y[i] = x.y;
    all.u[i] = x.u;
    all.v[i] = x.v;
    all.sum[i] = x.sum;
  }
  return all;
}

THERMOROLL_CLONES void t_from(const SlipPoint& from, const Fours& to, GradedArray& apart) {
  Pack4 step, u, v, sum, beyond;
  for (Index k = 0; k < to.y.size(); k += 4) {
    load(&to.y[k], step);
    load(&to.u[k], u);
    load(&to.v[k], v);
    load(&to.sum[k], sum);
    step -= from.y;
    if (from.beta > 0) {
      sinh_of(from.beta * step, step);
      step *= from.end / from.sum / sum;
    }
    for (std::size_t i = 2; i-- > 0;)
      if (from.clusters[i].rate > 0) step_across(from.clusters[i], from.before[i], step);
    t_beyond(from, step, u, v, beyond);
    store(beyond, &apart[k]);
  }
}

MatrixXd over_distances(const Nodes& z, const ArrayXd& weight) {
  const Index n = z.y.size();
  std::vector<SlipPoint> points;
  for (const double y : z.y) points.emplace_back(1 + y, 1 - y, z.zones.variable);
  const Fours all = in_fours(points);
  GradedArray apart(all.y.size());
  MatrixXd quotients(n, n);
  for (Index j = 0; j < n; ++j) {
    t_from(points[static_cast<std::size_t>(j)], all, apart);
    quotients.col(j) = weight(j) / z.zones.slip / apart.head(n);
    quotients(j, j) = 0;
  }
  return quotients;
}

double distance_before(const Cluster& c, double beyond) {
  const double x = 1 + c.middle + std::asinh((beyond - 1 - c.place) / c.width) / c.rate;
  double there = x;
  step_across(c, -1, there);
  return x - (there - beyond) / growth_at(c, x - 1);
}

double distance_of_share(double t, const SlipVariable& by) {
  const double phi = 2 * std::asin(std::sqrt(t));
  const double u = 2 * std::cos((pi - phi) / 6) * std::sin(phi / 6), root = std::sqrt(5.0);
  const double eta = 1 + root * std::sin(std::asin(22 * (u - 0.5) / (5 * root)) / 3);
  double there = 0;
  slip_cubic(eta, there);
  double x = eta - (there - u) * 22 / (3 + 12 * eta * (2 - eta));  // 1 + psi
  for (const Cluster& c : by.clusters)
    if (c.rate > 0) x = distance_before(c, x);
  const double beta = by.beta;
  if (beta == 0) return x;
  return std::log1p(x * std::sinh(2 * beta) / (1 + x * std::expm1(-2 * beta) / 2)) / (2 * beta);
}

}  // namespace thermoroll
