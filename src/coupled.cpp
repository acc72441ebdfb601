// Tangled from paper/10-coupled-solver.md; edit there.
#include "coupled.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <gsl/gsl_integration.h>

#include <Eigen/LU>

#include "carter.hpp"
#include "fast_kernels.hpp"
#include "numbers.hpp"

namespace thermoroll {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::Infinity;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

/// Gauss-Legendre nodes x and weights w on (-1, 1); the matrices turn values at x into Legendre
/// coefficients and into derivatives at x. For rays, u = (1 + x) / 2 and its cube.
struct Rule {
  ArrayXd x, w, u, cube;
  MatrixXd to_legendre, derivative;
};

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

Rule make_rule(int n) {
  Rule rule{ArrayXd(n), ArrayXd(n), {}, {}, {}, {}};
  gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(n);
  for (int i = 0; i < n; ++i)
    gsl_integration_glfixed_point(-1, 1, i, &rule.x(i), &rule.w(i), table);
  gsl_integration_glfixed_table_free(table);
  rule.u = (1 + rule.x) / 2, rule.cube = rule.u.cube();
  const MatrixXd all = legendre(rule.x, n + 1), p = all.leftCols(n);
  const ArrayXd slope_of_p_n = n * (all.col(n - 1).array() - rule.x * all.col(n).array());
  rule.w = 2 * (1 - rule.x.square()) / slope_of_p_n.square();
  const ArrayXd l = ArrayXd::LinSpaced(n, 0, n - 1);
  rule.to_legendre = (l + 0.5).matrix().asDiagonal() * p.transpose() * rule.w.matrix().asDiagonal();
  MatrixXd slope = MatrixXd::Zero(n, n);  // (x^2 - 1) P_l' = l (x P_l - P_{l-1})
  for (int i = 1; i < n; ++i)
    slope.col(i) = i * (rule.x * p.col(i).array() - p.col(i - 1).array()) / (rule.x.square() - 1);
  rule.derivative = slope * rule.to_legendre;
  return rule;
}

const Rule& gauss_legendre(int n) {
  thread_local std::map<int, Rule> known;
  auto found = known.find(n);
  if (found == known.end()) found = known.emplace(n, make_rule(n)).first;
  return found->second;
}

struct Angles {
  double c0;
  ArrayXd phi, dphi, s;         // slip zone: angles, weights, positions
  ArrayXd theta, dtheta, d, r;  // stick zone: angles from the border, weights, distances, positions
};

Angles angles(double c0, const Rule& slip, const Rule& stick) {
  const ArrayXd phi = pi * slip.u, s = c0 + (1 - c0) * (phi / 2).sin().square();
  const double fine = 3 * std::sqrt((1 - c0) / (1 + c0)), stretch = std::log1p(pi / fine);
  const ArrayXd grown = (stretch * stick.u).exp(), theta = fine * (grown - 1);
  const ArrayXd d = (1 + c0) * (theta / 2).sin().square();
  return {c0, phi, pi / 2 * slip.w, s, theta, fine * stretch / 2 * grown * stick.w, d, c0 - d};
}

/// Quadrature nodes over the slip zone, graded towards the angle phi0 of a target, or, for a target
/// in the stick zone, towards phi0 = 0 across the gap d.
struct Rays {
  ArrayXd x;     // 2 phi / pi - 1, Legendre's variable
  ArrayXd z;     // t - s
  ArrayXd mass;  // what multiplies h: weight times sin(phi) dt
};

void cast(Rays& rays, double c0, double peclet, double phi0, double d, const Rule& rule) {
  const Index n = rule.x.size(), count = phi0 > 0 ? 2 * n : n;  // to the right, then to the left
  const double half = (1 - c0) / 2, sin0 = std::sin(phi0), cos0 = std::cos(phi0);
  const double at_end = std::sqrt((1 / peclet + d) * 2 / half);  // where dt/dphi vanishes
  const double delta = 3 * (phi0 > 0 ? std::min(at_end, 1 / (peclet * half * sin0)) : at_end);
  const double right = std::log1p((pi - phi0) / delta), left = std::log1p(phi0 / delta);
  rays.x.resize(count), rays.z.resize(count), rays.mass.resize(count);
  rays.mass << (right * rule.cube).exp(), (left * rule.cube).exp().head(count - n);
  for (Index i = 0; i < count; ++i) {
    const Index j = i < n ? i : i - n;
    const double k = i < n ? right : left, power = k * rule.cube(j), grown = rays.mass(i);
    const double step = (i < n ? delta : -delta) * (power < 0.1 ? std::expm1(power) : grown - 1);
    const double s2 = std::sin(step / 2), c2 = std::cos(step / 2);
    const double sin_phi = sin0 * (1 - 2 * s2 * s2) + cos0 * 2 * s2 * c2;
    const double dphi = 1.5 * rule.w(j) * rule.u(j) * rule.u(j) * k * delta * grown;
    rays.x(i) = 2 / pi * (phi0 + step) - 1;
    rays.z(i) = 2 * half * (sin0 * c2 + cos0 * s2) * s2 + d;
    rays.mass(i) = dphi * half * sin_phi * sin_phi;
  }
}

/// Column `target` of slope and strain: integrals of N1 and N against P_0, P_1, ... over the rays.
void moments(const Scene& scene, Formulation formulation, const Rays& rays, Index target,
             MatrixXd& slope, MatrixXd& strain) {
  const double in_n = -slope_sign(formulation) * scene.friction;  // N1's share in N, @eq:N
  ArrayXd k1(rays.x.size()), k(rays.x.size());
  for (Index i = 0; i < k.size(); ++i) {
    const auto [n1, n2] = fast_slope_and_strain(scene.peclet * rays.z(i));
    k1(i) = rays.mass(i) * n1;
    k(i) = rays.mass(i) * (n2 / pi + in_n * n1);
  }
  ArrayXd p = ArrayXd::Ones(k.size()), next = rays.x, after(k.size());
  for (Index l = 0; l < slope.rows(); ++l) {
    slope(l, target) = (k1 * p).sum(), strain(l, target) = (k * p).sum();
    const double down = 1 - 1 / static_cast<double>(l + 2);  // (l + 1) / (l + 2)
    after = (1 + down) * rays.x * next - down * p;
    p.swap(next), next.swap(after);
  }
}

/// F and G of @eq:thermal-sides at the slip nodes, then the stick nodes, as matrices on h.
struct ThermalSides {
  MatrixXd f, g;
};

ThermalSides thermal_sides(const Scene& scene, Formulation formulation, const Angles& a,
                           const Rule& slip, const Rule& ray) {
  const Index n = a.phi.size(), m = a.d.size();
  MatrixXd slope(n, n + m), strain(n, n + m);
  Rays rays;
  for (Index i = 0; i < n + m; ++i) {
    const bool slips = i < n;
    cast(rays, a.c0, scene.peclet, slips ? a.phi(i) : 0, slips ? 0 : a.d(i - n), ray);
    moments(scene, formulation, rays, i, slope, strain);
  }
  const double strength = scene.friction * scene.peclet * scene.heating;
  return {slope.transpose() * (-slope_sign(formulation) * strength * slip.to_legendre),
          strain.transpose() * (strength * slip.to_legendre)};
}

/// Weights of dt / sqrt(1 - t^2) at the slip nodes, then the stick nodes.
VectorXd contact_weights(const Angles& a) {
  VectorXd weights(a.phi.size() + a.d.size());
  weights << ((1 - a.c0) / (1 + a.s)).sqrt() * (a.phi / 2).sin() * a.dphi,
      ((1 + a.c0) / (1 - a.r)).sqrt() * (a.theta / 2).sin() * a.dtheta;
  return weights;
}

/// On the slip nodes p-hat = 2/pi + p h and v-hat = 2f/pi + v h; kappa = 1 + kappa h and
/// gamma0 = gamma0 h.
struct Inverses {
  MatrixXd p, v;
  RowVectorXd kappa, gamma0;
};

Inverses invert(const Angles& a, const ThermalSides& sides, const Rule& slip, double friction) {
  const Index n = a.phi.size(), m = a.d.size();
  const VectorXd weights = contact_weights(a);
  VectorXd position(n + m);
  position << a.s, a.r;
  Inverses x;
  x.gamma0 = weights.transpose() * sides.f / pi;
  x.kappa = weights.cwiseProduct(position).transpose() * sides.f;
  const ArrayXd sine = (a.phi / 2).sin(), cosine = (a.phi / 2).cos();
  MatrixXd in_p(n, n + m), in_v(n, m);
  for (Index i = 0; i < n; ++i) {
    const ArrayXd left = cosine(i) * sine, right = sine(i) * cosine;  // t - s by @eq:apart
    in_p.row(i).head(n) = weights.head(n).array() / ((1 - a.c0) * (left - right) * (left + right));
    in_p(i, i) = 0;
    const ArrayXd apart = (1 - a.c0) * sine(i) * sine(i) + a.d;
    in_p.row(i).tail(m) = -weights.tail(m).array() / apart;
    in_v.row(i) = a.dtheta / apart;
  }
  const MatrixXd slope = slip.derivative * sides.f.topRows(n);  // dF/dx, x = 2 phi / pi - 1
  const ArrayXd dx_ds = 4 / (pi * (1 - a.c0) * a.phi.sin());
  x.p = (in_p.rowwise().sum().asDiagonal() * sides.f.topRows(n) - in_p * sides.f) / pi;
  x.p -= (weights.head(n).array() * dx_ds / pi).matrix().asDiagonal() * slope;
  x.v = in_v * sides.g.bottomRows(m) - in_v.rowwise().sum().asDiagonal() * sides.g.topRows(n);
  x.v /= pi;
  x.p.rowwise() += 2 / pi * x.kappa, x.v.rowwise() += 2 * friction / pi * x.kappa;
  return x;
}

/// Solve h = sigma p-hat v-hat from the start h; returns the number of steps, 0 if it fails.
int newton(const Inverses& x, const VectorXd& sigma, double friction, VectorXd& h) {
  for (int step = 1; step <= 25; ++step) {
    const VectorXd p = (x.p * h).array() + 2 / pi, v = (x.v * h).array() + 2 * friction / pi;
    const VectorXd by_p = sigma.cwiseProduct(v), by_v = sigma.cwiseProduct(p);
    MatrixXd jacobian = -(by_p.asDiagonal() * x.p) - (by_v.asDiagonal() * x.v);
    jacobian.diagonal().array() += 1;
    const VectorXd change = jacobian.partialPivLu().solve(h - by_p.cwiseProduct(p));
    h -= change;
    const double relative = change.lpNorm<Infinity>() / h.lpNorm<Infinity>();
    if (!std::isfinite(relative)) return 0;
    if (relative < 1e-7) return step;  // converging quadratically: the next step would be 1e-14
  }
  return 0;
}

/// T* at the slip angle phi0, or in the stick zone at the distance d from the border (phi0 = 0).
double temperature_at(const Angles& a, double peclet, const VectorXd& h, double phi0, double d,
                      const Rule& rule) {
  Rays rays;
  cast(rays, a.c0, peclet, phi0, d, rule);
  ArrayXd b = ArrayXd::Zero(rays.x.size()), above = b, below = b;
  for (Index l = h.size() - 1; l >= 0; --l) {
    const double up = 2 - 1 / static_cast<double>(l + 1), down = 1 - 1 / static_cast<double>(l + 2);
    below = h(l) + up * rays.x * b - down * above;
    above.swap(b), b.swap(below);
  }
  for (Index i = 0; i < b.size(); ++i) b(i) *= rays.mass(i) * fast_temperature(peclet * rays.z(i));
  return b.sum() / pi;
}

/// The angle of the hottest point and how far apart to sample about it.
struct Summit {
  double phi = 2.2, apart = 0.3;
};

template <class Temperature>
Summit climb(const Temperature& at, const Summit& from) {
  const double left = at(from.phi - from.apart), right = at(from.phi + from.apart);
  const double top = at(from.phi);
  const double bend = left - 2 * top + right, uphill = right > left ? 1 : -1;
  const double move = bend < 0 ? std::clamp((left - right) / (2 * bend), -1.0, 1.0) : uphill;
  const double apart = std::abs(move) < 1 ? std::max(0.3 * from.apart, 3e-3) : from.apart;
  return {std::clamp(from.phi + move * from.apart, 1.01 * apart, pi - 1.01 * apart), apart};
}

struct Level {
  Values value;
  VectorXd h;  // Legendre coefficients
  Summit summit;
  int newton_steps = 0;  // 0 where Newton failed
  double least = 0;      // of p-hat and v-hat: negative where the contact opens or slips backwards
};

VectorXd start(const Level& from, const Rule& slip, const VectorXd& sigma, double friction) {
  if (from.h.size() == 0) return 4 * friction / (pi * pi) * sigma;
  return legendre(slip.x, from.h.size()) * from.h;
}

Level solve_level(const Scene& scene, Formulation formulation, int n, double c0,
                  const Level& from) {
  const Rule &slip = gauss_legendre(n), &stick = gauss_legendre(std::max(8, 3 * n / 4));
  const Rule &ray = gauss_legendre(12 + n / 2), &fine_ray = gauss_legendre(20 + n);
  const Angles a = angles(c0, slip, stick);
  const ThermalSides sides = thermal_sides(scene, formulation, a, slip, ray);
  const Inverses x = invert(a, sides, slip, scene.friction);
  const VectorXd sigma = (1 - c0) / 2 * (1 + a.s);
  VectorXd h = start(from, slip, sigma, scene.friction);
  Level level;
  level.newton_steps = newton(x, sigma, scene.friction, h);
  level.h = slip.to_legendre * h;
  const VectorXd p = (x.p * h).array() + 2 / pi, v = (x.v * h).array() + 2 * scene.friction / pi;
  level.least = std::min(p.minCoeff(), v.minCoeff());
  const double f = scene.friction, a0 = (1 + c0) / 2, kappa = 1 + x.kappa.dot(h);
  const ArrayXd g_dtheta = (sides.g.bottomRows(a.d.size()) * h).array() * a.dtheta;
  const double constant = g_dtheta.sum() / pi + f * kappa / pi * (1 - c0);
  const auto at = [&](double phi) {
    return temperature_at(a, scene.peclet, level.h, phi, 0, fine_ray);
  };
  level.summit = climb(at, from.summit);
  level.value << c0, f * (1 - kappa * a0 * a0) + ((a0 - a.d) * g_dtheta).sum(), constant,
      constant - f * x.gamma0.dot(h), kappa, x.gamma0.dot(h),
      (1 - c0) / 2 * (a.phi.sin().square() * h.array() * a.dphi).sum(), at(level.summit.phi),
      c0 + (1 - c0) * std::pow(std::sin(level.summit.phi / 2), 2);
  return level;
}

Values carter_values(double friction, double q) {
  const Carter c = carter(friction, q);
  Values values;
  values << c.c0, q, c.creep, c.creep, 1, 0, carter_heat(c), 0, 0;
  return values;
}

/// Carter's traction for the given quantity, kept inside (0, f).
double carter_traction_given(double friction, const Given& given) {
  const double b = (1 + given.value) / 2;
  const double q = given.quantity == border  ? friction * (1 - b * b)
                   : given.quantity == creep ? carter_creep_curve(friction, given.value)
                                             : given.value;
  return std::clamp(q, 1e-9 * friction, (1 - 1e-9) * friction);
}

/// Solve with eight unknowns for the given quantity; slope receives the derivative of all
/// quantities with respect to it.
Level find_border(const Scene& scene, Formulation formulation, const Given& given, Values& slope) {
  const double f = scene.friction;
  const double nearly = carter_traction_given(f, given), less = 1e-3 * std::min(nearly, f - nearly);
  const Values here = carter_values(f, nearly), below = carter_values(f, nearly - less);
  slope = (here - below) / (here(given.quantity) - below(given.quantity));
  double c0 = here(border);
  Level level;
  for (int k = 0; k < 30; ++k) {
    const Level last = level;
    level = solve_level(scene, formulation, 8, c0, last);
    if (level.newton_steps == 0) break;
    const double moved = k > 0 ? level.value(given.quantity) - last.value(given.quantity) : 0;
    if (moved != 0) slope = (level.value - last.value) / moved;
    const double room = std::min(1 - c0, 1 + c0), near = 1e-3 * room;
    double step = slope(border) * (given.value - level.value(given.quantity));
    if (k > 0 && std::abs(step) <= near) return level;
    if (std::abs(step) < near) step = near;  // a second border, for the derivative
    c0 += std::clamp(step, -0.7 * (1 + c0), 0.7 * (1 - c0));
  }
  throw std::runtime_error("coupled: no solution found near the border " + shortest(c0));
}

/// Size of the last quarter of the coefficients, relative to the largest.
double tail(const VectorXd& h) {
  return h.tail(h.size() / 4).lpNorm<Infinity>() / h.lpNorm<Infinity>();
}

/// Estimated errors, relative to scale, from this change and the one before, and from how much
/// the tail has shrunk meanwhile.
Values estimate(const Values& change, const Values& before, double shrunk, int n) {
  const double believed = std::max(change.maxCoeff(), 0.1 * before.maxCoeff());
  return Values::Constant(3 * std::min(1.0, 2 * shrunk) * believed + 1e-14 * n);
}

/// What the tolerance is relative to: creep, heat and temperature to themselves, others to one.
Values scale_of(const Values& v) {
  Values scale = Values::Ones();
  for (const Quantity q : {creep_constant, creep, heat, hottest}) scale(q) = std::abs(v(q));
  scale(hottest_at) = 1e3;  // a flat maximum: where it is matters a thousand times less
  return scale;
}

CoupledSolution admissible(CoupledSolution x, const Level& level) {
  if (level.least < 0)
    throw std::runtime_error("coupled: no solution with p >= 0 and v >= 0 found at the border " +
                             shortest(x.value(border)));
  x.eccentricity = pi * x.value(gamma0) / (2 * x.value(load_ratio));
  return x;
}

/// sum_j weight_j (y_j - y_i) / (t_j - t_i) for every i; slope stands in at j = i.
ArrayXd divided_sums(const ArrayXd& t, const ArrayXd& y, const ArrayXd& slope,
                     const ArrayXd& weight) {
  ArrayXd sums = weight * slope;
  for (Index i = 0; i < t.size(); ++i)
    for (Index j = 0; j < t.size(); ++j)
      if (j != i) sums(i) += weight(j) * (y(j) - y(i)) / (t(j) - t(i));
  return sums;
}

/// The same profile with ascending s: stick nodes turned round, then slip nodes.
Profile in_order(const Profile& x) {
  std::vector<Index> order(static_cast<std::size_t>(x.s.size()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return x.s(i) < x.s(j); });
  return {x.s(order),    x.pressure(order),  x.traction(order),
          x.slip(order), x.heat_flux(order), x.temperature(order)};
}

}  // namespace

FluxMap flux_map(const Scene& scene, Formulation formulation, int n, double c0) {
  const Rule &slip = gauss_legendre(n), &stick = gauss_legendre(std::max(8, 3 * n / 4));
  const Angles a = angles(c0, slip, stick);
  const ThermalSides sides = thermal_sides(scene, formulation, a, slip, gauss_legendre(12 + n / 2));
  const Inverses x = invert(a, sides, slip, scene.friction);
  return {scene.friction, a.s, (1 - c0) / 2 * (1 + a.s), x.p, x.v, x.kappa};
}

CoupledSolution solve_coupled(const Scene& scene, Formulation formulation, double tolerance,
                              const Given& given) {
  Scene checked = scene;
  checked.traction = scene.friction / 2;  // not used: given takes its place
  check(checked);
  require(tolerance >= 1e-11, "tolerance", tolerance, "at least 1e-11");
  require(given.quantity == traction || given.quantity == creep || given.quantity == border,
          "given quantity", given.quantity, "traction, creep or border");
  if (given.quantity == traction) check(Scene{scene.friction, given.value, 1, 0});
  if (given.quantity == creep) require(given.value > 0, "creep", given.value, "positive");
  if (given.quantity == border)
    require(std::abs(given.value) < 1, "stick-slip-border", given.value, "between -1 and 1");
  Values slope, before = Values::Zero();
  Level level = find_border(scene, formulation, given, slope);
  const auto off = [&] { return given.value - level.value(given.quantity); };
  Values value = level.value + slope * off();
  CoupledSolution x;
  for (int n = 16; n <= 400;) {
    level = solve_level(scene, formulation, n, value(border), Level(level));
    if (level.newton_steps == 0) break;
    const Values last = value, scale = scale_of(level.value);
    value = level.value + slope * off();
    const Values change = (value - last).abs() / scale;
    const Values error = estimate(change, before, n > 16 ? tail(level.h) / tail(x.h) : 1, n);
    x = {value, error * scale, n, level.newton_steps, level.h, 0};
    if (error.maxCoeff() <= tolerance) return admissible(x, level);
    n = error.maxCoeff() > 300 * tolerance ? 2 * n : 3 * n / 2;
    before = change;
  }
  throw std::runtime_error("coupled: not resolved to " + shortest(tolerance) + " with " +
                           std::to_string(x.unknowns) + " unknowns");
}

HeatFlux coupled_flux(const CoupledSolution& x) {
  const double c0 = x.value(border);
  return {c0, 1, [h = x.h, length = 1 - c0](double left, double right) {
            const double phi = 2 * std::atan2(std::sqrt(left), std::sqrt(right));
            const ArrayXd at = ArrayXd::Constant(1, 2 / pi * phi - 1);
            return 2 * std::sqrt(left * right) / length * (legendre(at, h.size()) * h)(0);
          }};
}

Profile profile(const Scene& scene, Formulation formulation, const CoupledSolution& x) {
  const double c0 = x.value(border), kappa = x.value(load_ratio);
  const int n = x.unknowns, m = std::max(8, 3 * n / 4);
  const Rule &slip = gauss_legendre(n), &stick = gauss_legendre(m);
  const Rule &ray = gauss_legendre(12 + n / 2), &fine_ray = gauss_legendre(20 + n);
  const Angles a = angles(c0, slip, stick);
  const ThermalSides sides = thermal_sides(scene, formulation, a, slip, ray);
  const VectorXd h = legendre(slip.x, n) * x.h, f = sides.f * h, g = sides.g * h;
  const ArrayXd dx_dr = -2 * stick.w / ((1 + c0) * a.theta.sin() * a.dtheta);
  VectorXd at(n + m), slope(n + m);
  at << a.s, a.r;
  slope << (slip.derivative * f.head(n)).array() * 4 / (pi * (1 - c0) * a.phi.sin()),
      (stick.derivative * f.tail(m)).array() * dx_dr;
  const ArrayXd p_hat = 2 / pi * kappa - divided_sums(at, f, slope, contact_weights(a)) / pi;
  const ArrayXd g_slope = (stick.derivative * g.tail(m)).array() * dx_dr;
  const ArrayXd q_hat =
      2 * scene.friction / pi * kappa - divided_sums(a.r, g.tail(m), g_slope, a.dtheta) / pi;
  ArrayXd right = 1 - at.array();
  right.head(n) = (1 - c0) * (a.phi / 2).cos().square();  // keeps its digits near s = 1
  Profile profile{at, (right * (1 + at.array())).sqrt() * p_hat, {}, {}, {}, at};
  profile.traction = scene.friction * profile.pressure;
  profile.traction.tail(m) -= ((1 + a.r) * a.d).sqrt() * q_hat;
  profile.heat_flux = profile.slip = ArrayXd::Zero(n + m);
  profile.heat_flux.head(n) = a.phi.sin() * h.array();
  profile.slip.head(n) = profile.heat_flux.head(n) / profile.pressure.head(n);
  for (Index i = 0; i < n + m; ++i) {
    const bool slips = i < n;
    profile.temperature(i) = temperature_at(a, scene.peclet, x.h, slips ? a.phi(i) : 0,
                                            slips ? 0 : a.d(i - n), fine_ray);
  }
  return in_order(profile);
}

}  // namespace thermoroll
