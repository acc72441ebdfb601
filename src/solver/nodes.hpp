// Tangled from paper/12-coupled-problem.md; edit there.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

#include "solver/gauss_legendre.hpp"
#include "support/simd.hpp"
#include "thermoroll/slip_variable.hpp"

namespace thermoroll {

/// The lengths of both zones, 1 - c0 and 1 + c0, which add up to 2; and the y of @eq:angles.
struct ZoneLengths {
  double slip, stick;
  SlipVariable variable{};
  double c0() const { return (stick - slip) / 2; }
};

/// The rule of n nodes, rounded up to a multiple of the group, without polynomials.
inline const GaussLegendre& rounded_up(int group, int n) {
  return quadrature_rule((n + group - 1) / group * group);
}

/// By how many decades the speed lambda of a slip zone exceeds 1e4.
inline double decades_beyond(double lambda) { return std::max(0.0, std::log10(lambda) - 4); }

/// By how many decades the slip zone is shorter than a hundredth of the stick zone; at most 20, as
/// the quotient of a length next to zero is infinite.
inline double decades_shorter(const ZoneLengths& at) {
  return std::min(std::max(0.0, std::log10(at.stick / at.slip) - 2), 20.0);  // 0 for NaN
}

/// Nodes of the stick zone on a grid of n unknowns: two more for every such decade, but at most n
/// of them if n > 64. The finest grids occur at large H, which needs G as fine as h. Full slip has
/// no stick zone.
inline int stick_nodes(int n, const ZoneLengths& at, double layer) {
  if (at.stick == 0) return 0;
  if (n > 200) return n;
  const int few = n <= 12 ? 8 : std::max(3 * n / 4 + 2, n / 2 + 11);
  const double decades = decades_shorter({std::min(at.slip, layer), at.stick});
  const int all = few + static_cast<int>(2 * decades);
  return n > 64 ? std::min(n, all) : all;
}

/// Nodes of a graded rule on a grid of n unknowns; those of coarse grids are fewer.
inline int graded_nodes(int n) { return n <= 12 ? 20 : std::max(28, (n + 7) / 4 * 4); }

/// Nodes of a graded rule for temperatures: the more the faster the slip zone, lambda, is.
inline int temperature_nodes(int n, double lambda) {
  const int more = static_cast<int>(8 * decades_beyond(lambda));
  return std::min(most_unknowns, std::max(n, 20) + more) + 24;
}

/// The length of the layer beside the border that the stick nodes resolve; 2, the whole contact, on
/// coarse grids.
inline double layer_ahead(int n, double peclet) { return n <= 12 ? 2 : 30 / std::min(peclet, 1e6); }

/// The rules of a grid of n unknowns: nodes of both zones, of graded rules, which large H
/// needs as fine as h, and of those for temperatures.
struct GridRules {
  explicit GridRules(int n, const ZoneLengths& at = {1, 1}, double peclet = 1, int more = 0,
                     int more_that_stick = 0, double ahead = 2)
      : slip(gauss_legendre(n)),
        stick(gauss_legendre(stick_nodes(n, at, ahead) + more_that_stick)),
        graded(rounded_up(4, std::min(most_unknowns, more + graded_nodes(n)))),
        fine(rounded_up(8, temperature_nodes(n + more, at.slip * peclet))),
        layer(ahead) {}
  const GaussLegendre &slip, &stick, &graded, &fine;
  double layer;  // length of the layer ahead of the border
};

/// Of nodes about a place in [-1, 1], @eq:cluster.
inline Cluster cluster_at(double place, double width) {
  const double a = std::asinh((1 + place) / width), b = std::asinh((1 - place) / width);
  return {place, width, (a + b) / 2, (a - b) / (a + b)};
}

/// The variable of the mirror image.
inline SlipVariable mirrored(SlipVariable x) {
  for (Cluster& c : x.clusters) c = {-c.place, c.width, c.rate, -c.middle};
  return x;
}

/// The step beyond a cluster for a step from x before it.
template <class Number>
[[gnu::always_inline]] inline void step_across(const Cluster& c, double x, Number& step) {
  Number half, middle;
  sinh_of(c.rate / 2 * step, half);
  sinh_of(c.rate / 2 * (x - c.middle + step / 2), middle);
  step = 2 * c.width * half * (1 + 2 * middle * middle);
}

/// The derivative by x; 1 without a cluster.
inline double growth_at(const Cluster& c, double x) {
  return c.rate > 0 ? c.width * c.rate * std::cosh(c.rate * (x - c.middle)) : 1;
}

/// u at the distance eta from psi = -1, or v at that distance from psi = 1; in [0, 1].
template <class Number>
[[gnu::always_inline]] inline void slip_cubic(const Number& eta, Number& u) {
  u = eta * (3 + (12 - 4 * eta) * eta) * (1 / 22.0);
}

/// A point of the slip zone at the distances 1 + y and 1 - y from its ends, @eq:angles.
struct SlipPoint {
  SlipPoint(double left, double right, const SlipVariable& by = {})
      : beta(by.beta), clusters(by.clusters), y((left - right) / 2) {
    if (beta > 0) {
      const double a = std::sinh(beta * left), b = std::sinh(beta * right);
      sum = a + b;
      end = 2 * std::sinh(2 * beta);
      growth = beta * end / (sum * sum);
      left = 2 * a / sum;
      right = 2 * b / sum;
    }
    for (std::size_t i = 2; i-- > 0;) {
      const Cluster& c = clusters[i];
      if (c.rate == 0) continue;
      before[i] = (left - right) / 2;
      growth *= growth_at(c, before[i]);
      right = -right;
      step_across(c, -1, left);
      step_across(c, 1, right);
      right = -right;
    }
    psi = (left - right) / 2;
    slip_cubic(left, u);
    slip_cubic(right, v);
    du = (3 + 12 * left * right) * (1 / 22.0) * growth;
  }
  double beta;
  std::array<Cluster, 2> clusters;
  double y, psi, u, v, du, sum = 0, end = 0, growth = 1;  // du: the derivative of u by y
  double before[2] = {0, 0};                              // the x of each cluster
  double t() const { return u * u * (1 + 2 * v); }
  double omega() const { return std::sqrt((1 + 2 * u) * (1 + 2 * v)); }
};

/// apart = t - from.t() at a step in psi, by u and v there; it subtracts no nearly equal numbers.
template <class Number>
[[gnu::always_inline]] inline void t_beyond(const SlipPoint& from, const Number& step,
                                            const Number& u, const Number& v, Number& apart) {
  const Number psi = from.psi + step;
  const Number slope = (15 - 4 * (from.psi * (from.psi + psi) + psi * psi)) * (1 / 22.0);
  const auto left = u + from.u < 1;
  const Number x = left ? u + from.u : v + from.v, product = left ? u * from.u : v * from.v;
  apart = step * slope * (3 * x - 2 * (x * x - product));
}

/// 1 + x where the distance from -1 is given beyond the cluster.
double distance_before(const Cluster& c, double beyond);

/// The distance 1 + y at which t is the given share, in [0, 1/2].
double distance_of_share(double t, const SlipVariable& by = {});

/// The nodes of both zones, n on the slip zone and m on the stick zone.
struct Nodes {
  ZoneLengths zones;
  Eigen::ArrayXd y, t, s, sigma;  // slip zone (n); sigma = 1 + s, or 1 in full slip
  Eigen::ArrayXd d, r;            // stick zone (m): distances from the border and positions
  Eigen::ArrayXd over_w;          // weights of dr / w at the stick nodes
  Eigen::VectorXd over_root;  // weights of ds / sqrt(1 - s^2) at all n + m, the slip nodes first
  Eigen::VectorXd heat;       // weights of g ds, on h at the slip nodes, per slip^2
};

/// The ten Legendre coefficients of Carter's h for y = psi.
Eigen::VectorXd carter_h(const ZoneLengths& at, double friction);

/// The nodes of both zones of these lengths.
Nodes place_nodes(const ZoneLengths& zones, const GaussLegendre& slip, const GaussLegendre& stick,
                  double layer = 2);

/// weight(j) / (s(i) - s(j)) for each pair of slip nodes, in row i and column j; zero if i = j.
Eigen::MatrixXd over_distances(const Nodes& z, const Eigen::ArrayXd& weight);

}  // namespace thermoroll
