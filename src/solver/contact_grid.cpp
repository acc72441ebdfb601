// Tangled from paper/12-coupled-problem.md, paper/21-hot-friction.md; edit there.
#include "solver/contact_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/graded_rule.hpp"
#include "solver/linear_system.hpp"
#include "solver/product.hpp"
#include "solver/surface.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::Infinity;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// G at the stick nodes.
ArrayXd strain_on_stick(const ContactGrid& grid, const VectorXd& h) {
  const Index m = grid.nodes.d.size();
  ArrayXd g = grid.thermal.g.bottomRows(m) * h;
  if (grid.bulk) g += grid.thermal.bulk.g.tail(m).array();
  return g;
}

/// At the slip nodes: p-hat, T*, phi and its derivative, v-hat, for a share of H.
struct LawAtNodes {
  ArrayXd pressure, temperature, phi, slope, slip;
  ArrayXd by_pressure, by_temperature;  // their derivatives, by the weights of the node
};

ArrayXd times(const Eigen::Ref<const MatrixXd>& a, const VectorXd& x) {
  ArrayXd product(a.rows());
  product.matrix().noalias() = a * x;
  return product;
}

/// The first four values; the others stay empty.
LawAtNodes friction_at_nodes(const ContactGrid& grid, double share, const VectorXd& h) {
  const TractionOperators& x = grid.tractions;
  LawAtNodes at;
  at.pressure = x.p0;
  at.pressure.matrix().noalias() += share * (x.p * h);
  at.temperature = times(grid.thermal.temperature.topRows(x.p.rows()), share * h);
  if (grid.hot->bulk.size() > 0) at.temperature += grid.hot->bulk.head(x.p.rows());
  at.phi = at.slope = at.temperature;
  for (Index i = 0; i < at.phi.size(); ++i) {
    const RelativeFriction friction = grid.scene.law(at.temperature(i));
    at.phi(i) = friction.value;
    at.slope(i) = friction.slope;
  }
  return at;
}

LawAtNodes law_at_nodes(const ContactGrid& grid, double share, const VectorXd& h) {
  const TractionOperators& x = grid.tractions;
  const HotFriction& hot = *grid.hot;
  LawAtNodes at = friction_at_nodes(grid, share, h);
  at.by_pressure = times(hot.at_node, at.pressure.matrix());
  at.by_temperature = times(hot.at_node, at.temperature.matrix());
  at.slip = times(hot.s, ((1 - at.phi) * at.pressure).matrix());
  at.slip += (1 - at.phi) * at.by_pressure - at.slope * at.pressure * at.by_temperature;
  at.slip = x.v0 + grid.scene.friction * at.slip;
  at.slip.matrix().noalias() += share * (x.v * h);
  return at;
}

/// On the values of p-hat or T*, by the derivative of B at each node.
MatrixXd lost_velocity(const HotFriction& hot, const ArrayXd& by) {
  return hot.s * by.matrix().asDiagonal() + by.matrix().asDiagonal() * hot.at_node;
}

MatrixXd jacobian_with_law(const ContactGrid& grid, double share, const LawAtNodes& at) {
  const TractionOperators& x = grid.tractions;
  const ArrayXd bent = at.slope * at.pressure;
  const ArrayXd by_v = share * grid.nodes.sigma * at.pressure * at.phi;
  MatrixXd by_p = lost_velocity(*grid.hot, 1 - at.phi), by_t = lost_velocity(*grid.hot, -bent);
  by_p.diagonal().array() -= at.slope * at.by_temperature;
  by_t.diagonal().array() -= at.slope * at.by_pressure;
  const VectorXd times_v = grid.scene.friction * by_v;
  by_p = times_v.asDiagonal() * by_p;
  by_t = times_v.asDiagonal() * by_t;
  by_p.diagonal().array() += share * grid.nodes.sigma * at.slip * at.phi;
  by_t.diagonal().array() += share * grid.nodes.sigma * at.slip * bent;
  MatrixXd jacobian = grid.rules.slip.p - by_v.matrix().asDiagonal() * x.v;
  add_product(-1, by_p, x.p, jacobian);
  add_product(-1, by_t, grid.thermal.temperature.topRows(x.p.rows()), jacobian);
  return jacobian;
}

/// As newton(), with steps that are halved until the residual falls.
int newton_with_law(const ContactGrid& grid, double share, VectorXd& h) {
  const auto residual = [&](const VectorXd& x, const LawAtNodes& at) -> VectorXd {
    return grid.rules.slip.p * x - (grid.nodes.sigma * at.pressure * at.slip * at.phi).matrix();
  };
  LawAtNodes at = law_at_nodes(grid, share, h);
  VectorXd missing = residual(h, at);
  Eigen::PartialPivLU<MatrixXd> jacobian;
  double moved = 1;
  for (int step = 1; step <= 40; ++step) {
    if (moved > 1e-3) jacobian = factors_of(jacobian_with_law(grid, share, at));
    const VectorXd change = solve(jacobian, missing);
    moved = change.lpNorm<Infinity>() / h.lpNorm<Infinity>();
    if (!std::isfinite(moved)) return 0;
    const VectorXd before = h;
    h -= change;
    if (moved < 1e-10) return step;
    const double missed = missing.norm();
    double part = 1;
    do {
      h = before - part * change;
      at = law_at_nodes(grid, share, h);
      missing = residual(h, at);
      if (moved < 1e-8 || missing.norm() < (1 - 0.1 * part) * missed) break;
      part /= 2;
    } while (part > 1e-4);
    if (!(part > 1e-4)) return 0;
  }
  return 0;
}

ArrayXd slip_factor(const ContactGrid& grid, double share, const VectorXd& h) {
  if (grid.hot) return law_at_nodes(grid, share, h).slip;
  return share * (grid.tractions.v * h).array() + grid.tractions.v0;
}

struct Lost {
  double constant, traction;
};

Lost lost_friction(const ContactGrid& grid, const VectorXd& h) {
  const LawAtNodes at = friction_at_nodes(grid, 1, h);
  const ArrayXd lost = grid.scene.friction * (1 - at.phi) * at.pressure;
  return {(grid.hot->weight * lost).sum() / pi, (grid.hot->moment * lost).sum()};
}

/// Add f S[B] to the brackets v of the stick zone, with p-hat there; phi at the stick nodes.
ArrayXd law_on_stick(const ContactGrid& grid, const VectorXd& h, const LawAtNodes& at,
                     const ArrayXd& p, ArrayXd& v) {
  const Nodes& z = grid.nodes;
  const ArrayXd lost = (1 - at.phi) * at.pressure;
  ArrayXd temperature = grid.thermal.temperature.bottomRows(z.d.size()) * h;
  if (grid.hot->bulk.size() > 0) temperature += grid.hot->bulk.tail(z.d.size());
  ArrayXd phi(z.d.size());
  for (Index i = 0; i < phi.size(); ++i) {
    phi(i) = grid.scene.law(temperature(i)).value;
    const double here = (1 - phi(i)) * p(i);
    const ArrayXd quotient = (lost - here) / (z.zones.slip * z.t + z.d(i));
    v(i) += grid.scene.friction * ((grid.hot->weight * quotient).sum() / pi - here);
  }
  return phi;
}

/// Where the slope of a law jumps between two temperatures, and by how much; 0 where it does not.
struct Jump {
  double temperature, size;
};

Jump jump_between(const FrictionLaw& law, double low, double high) {
  double at_low = law(low).slope, at_high = law(high).slope;
  const double least = 1e-9 * (std::abs(at_low) + std::abs(at_high));
  for (int halving = 0; halving < 40 && at_low != at_high; ++halving) {
    const double middle = (low + high) / 2, at_middle = law(middle).slope;
    const double below = std::abs(at_middle - at_low), above = std::abs(at_high - at_middle);
    if (std::min(below, above) >= std::max(below, above) / 4) return {middle, 0};
    (below > above ? high : low) = middle;
    (below > above ? at_high : at_low) = at_middle;
  }
  const double jump = std::abs(at_high - at_low);
  return {low, jump > least ? jump : 0};
}

/// The y between two at which a Legendre series has a value.
double place_of(const VectorXd& series, double value, double from, double to) {
  const auto at = [&](double y) {
    return legendre(ArrayXd::Constant(1, y), series.size()).row(0).dot(series);
  };
  const bool rises = at(from) < at(to);
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = (from + to) / 2;
    ((at(middle) < value) == rises ? from : to) = middle;
  }
  return from;
}

struct TemperaturesOnZone {
  VectorXd series;
  ArrayXd y, value;
};

TemperaturesOnZone with_ends(const ContactGrid& grid, const ArrayXd& temperature) {
  const Index n = temperature.size();
  const VectorXd series = to_legendre(grid.rules.slip, temperature.matrix());
  const VectorXd ends = legendre(ArrayXd{{-1, 1}}, n) * series;
  TemperaturesOnZone x{series, ArrayXd(n + 2), ArrayXd(n + 2)};
  x.y << -1, grid.nodes.y, 1;
  x.value << ends(0), temperature, ends(1);
  if (!grid.bulk) x.value = x.value.max(std::numeric_limits<double>::min());
  return x;
}

ArrayXd friction_in_gaps(const ContactGrid& grid, const ArrayXd& pressure) {
  const ArrayXd part = grid.hot->moment * pressure;
  ArrayXd gaps(part.size() + 1);
  gaps << part, part(part.size() - 1);
  gaps.tail(part.size()) = gaps.tail(part.size()).max(part);
  return gaps / part.sum();
}

double strain_of_zone(const Scene& scene, const ZoneLengths& at) {
  return scene.friction * heating_of_both(scene) * std::sqrt(at.slip * scene.peclet);
}

/// beta of @eq:angles for a scene with these zones; the numbers are found by trial. A chi of more
/// than 1e6 counts as 1e6, which keeps the sines finite.
double crowding(const Scene& scene, Formulation formulation, const ZoneLengths& at) {
  const double heat = scene.friction * heating_of_both(scene);
  const double strain = strain_of_zone(scene, at);
  const bool other_layers = scene.law || is_unlike(scene) || scene.bulk_difference != 0;
  const bool ripples = formulation == Formulation::printed && scene.direction == Direction::braking;
  if (other_layers || ripples || heat < 0.5 || !(strain >= strain_of_layers)) return 0;
  return std::log(std::min(strain, 1e6) / 9) / 2;
}

TractionOperators traction_operators(const Nodes& z, const ThermalTerms& thermal, double friction) {
  const Index n = z.y.size(), m = z.d.size();
  VectorXd position(n + m);
  position << z.s, z.r;
  TractionOperators tractions{
      ArrayXd::Constant(n, 2 / pi), ArrayXd::Constant(n, 2 * friction / pi), {}, {}, {}, {}};
  tractions.gamma0 = z.over_root.transpose() * thermal.f / pi;
  tractions.kappa = z.over_root.cwiseProduct(position).transpose() * thermal.f;
  MatrixXd in_p(n, n + m), in_v(n, m);
  in_p.leftCols(n) = over_distances(z, -z.over_root.head(n));
  for (Index j = 0; j < m; ++j) {
    in_v.col(j) = z.over_w(j) / (z.zones.slip * z.t + z.d(j));  // s - r
    in_p.col(n + j) = -z.over_root(n + j) / z.over_w(j) * in_v.col(j);
  }
  const VectorXd all_p = in_p.rowwise().sum(), less_v = -in_v.rowwise().sum();
  tractions.p =
      all_p.asDiagonal() * thermal.f.topRows(n) - z.over_root.head(n).asDiagonal() * thermal.df;
  tractions.v = less_v.asDiagonal() * thermal.g.topRows(n);
  add_product(-1, in_p, thermal.f, tractions.p);
  add_product(1, in_v, thermal.g.bottomRows(m), tractions.v);
  tractions.p = (tractions.p.rowwise() + 2 * tractions.kappa) * (1 / pi);
  tractions.v = (tractions.v.rowwise() + 2 * friction * tractions.kappa) * (1 / pi);
  if (thermal.bulk.g.size() > 0) {
    const BulkTerms& bulk = thermal.bulk;
    tractions.p0 += bulk.pressure.head(n).array() + 2 * bulk.kappa / pi;
    VectorXd v = less_v.cwiseProduct(bulk.g.head(n));
    v.noalias() += in_v * bulk.g.tail(m);
    tractions.v0 += (v.array() + 2 * friction * bulk.kappa) / pi;
  }
  return tractions;
}

ContactGrid contact_grid(const Scene& scene, Formulation formulation, const ZoneLengths& zones,
                         const GridRules& rules, Index terms) {
  Nodes nodes = place_nodes(zones, rules.slip, rules.stick, rules.layer);
  const GaussLegendre& graded =
      scene.law ? rule_for_temperatures(scene, zones, rules) : rules.graded;
  ThermalTerms thermal = thermal_terms(scene, formulation, nodes, terms, graded);
  std::optional<Exchange> crossing;
  if (exchanges(scene, zones)) {
    crossing = exchange(scene, formulation, nodes, rules, terms);
    add_exchange(*crossing, thermal);
  }
  if (scene.law && crossing) thermal.temperature += crossing->temperature.leftCols(terms);
  const auto bulk = bulk_exchange(scene, nodes.y.size());
  if (bulk) thermal.bulk = bulk_terms(*bulk, scene, formulation, nodes);
  TractionOperators tractions = traction_operators(nodes, thermal, scene.friction);
  ContactGrid grid{
      scene, rules, std::move(nodes), std::move(thermal), std::move(tractions), std::move(crossing),
      bulk};
  if (!scene.law) return grid;
  grid.hot = hot_friction(grid.nodes, rules.slip);
  grid.hot->bulk = grid.thermal.bulk.temperature;
  return grid;
}

int more_graded(const SlipVariable& by) {
  if (by.clustered()) return 32;
  return by.beta > 0 ? 8 : 0;
}

GridRules rules_of(const Scene& scene, const ZoneLengths& zones, int n) {
  const bool friction_crosses = exchanges(scene, zones), bulk = scene.bulk_difference != 0;
  if (!is_unlike(scene) && !friction_crosses && !bulk)
    return GridRules(n, zones, scene.peclet, more_graded(zones.variable), 0,
                     layer_ahead(n, scene.peclet));
  const Conduction conduction(scene, false);
  int more = static_cast<int>(8 - 8 * std::log10(std::max(conduction.slowest, 1e-30)));
  more += more_graded(zones.variable);
  if (friction_crosses) more += n / 2;
  if (bulk && !friction_crosses) more += std::max(0, n - 48) / 2;
  const bool strained = bulk && !friction_crosses && zones.stick > 0;
  const double layer = friction_crosses || bulk ? 2 : layer_ahead(n, conduction.peclet);
  return GridRules(n, zones, conduction.peclet, more, strained ? 16 : 0, layer);
}

ContactGrid contact_grid(const Scene& scene, Formulation formulation, const ZoneLengths& zones,
                         int n) {
  return contact_grid(scene, formulation, zones, rules_of(scene, zones, n), n);
}

Resultants resultants(const ContactGrid& grid, const VectorXd& h) {
  const Nodes& z = grid.nodes;
  const double f = grid.scene.friction, a0 = z.zones.stick / 2;
  const double more = grid.tractions.kappa.dot(h) + grid.thermal.bulk.kappa, kappa = 1 + more;
  const double gamma0 = grid.tractions.gamma0.dot(h) + grid.thermal.bulk.gamma0;
  const Lost lost_to_heat = grid.hot ? lost_friction(grid, h) : Lost{0, 0};
  if (z.zones.stick == 0)  // full slip
    return {kappa, gamma0, grid.creep + f * gamma0, f - lost_to_heat.traction};
  const double lost = (1 + a0) * z.zones.slip / 2 - more * a0 * a0;  // 1 - kappa a0^2
  const ArrayXd g = strain_on_stick(grid, h) * z.over_w;
  return {kappa, gamma0, g.sum() / pi + f * kappa / pi * z.zones.slip - lost_to_heat.constant,
          f * lost + ((a0 - z.d) * g).sum() - lost_to_heat.traction};
}

int newton(const ContactGrid& grid, double share, VectorXd& h) {
  if (grid.hot) return newton_with_law(grid, share, h);
  const TractionOperators& tractions = grid.tractions;
  const MatrixXd& legendre = grid.rules.slip.p;
  const ArrayXd& sigma = grid.nodes.sigma;
  Eigen::PartialPivLU<MatrixXd> jacobian;
  double moved = 1;
  for (int step = 1; step <= 25; ++step) {
    const ArrayXd p = share * (tractions.p * h).array() + tractions.p0;
    const ArrayXd v = share * (tractions.v * h).array() + tractions.v0;
    if (moved > 1e-3)
      jacobian = factors_of(legendre - share * (sigma * v).matrix().asDiagonal() * tractions.p -
                            share * (sigma * p).matrix().asDiagonal() * tractions.v);
    const VectorXd change = solve(jacobian, legendre * h - (sigma * p * v).matrix());
    h -= change;
    moved = change.lpNorm<Infinity>() / h.lpNorm<Infinity>();
    if (!std::isfinite(moved)) return 0;
    if (moved < 1e-10) return step;  // the remaining error is at most a thousandth of it
  }
  return 0;
}

VectorXd carter_h(const ContactGrid& grid) {
  const double f = grid.scene.friction;
  ArrayXd h = 4 * f / (pi * pi) * grid.nodes.sigma;
  if (grid.nodes.zones.stick == 0) h = grid.tractions.p0 * grid.tractions.v0;  // full slip
  return to_legendre(grid.rules.slip, h.matrix());
}

int picard(const ContactGrid& grid, VectorXd& h) {
  const TractionOperators& tractions = grid.tractions;
  const GaussLegendre& rule = grid.rules.slip;
  VectorXd now = h, p, v, missing;
  double before = 1;
  for (int step = 1; step <= 25; ++step) {
    p.noalias() = tractions.p * now;
    v.noalias() = tractions.v * now;
    missing.noalias() = -rule.p * now;
    missing.array() += grid.nodes.sigma * (p.array() + tractions.p0) * (v.array() + tractions.v0);
    const VectorXd change = to_legendre(rule, missing);
    now += change;
    const double moved = change.lpNorm<Infinity>() / now.lpNorm<Infinity>();
    if (!(moved < before / 10)) return 0;
    if (step > 1) h = now;
    if ((step > 1 ? moved / before : 1) * moved < 1e-15) return step;
    before = moved;
  }
  return 0;
}

int solve_flux(const ContactGrid& grid, VectorXd& h) {
  const auto slips = [&](double share, const VectorXd& at) {
    return (slip_factor(grid, share, at) > 0).all();
  };
  int direct = grid.hot ? 0 : picard(grid, h);
  if (direct == 0) direct = newton(grid, 1, h);
  if (direct > 0 && slips(1, h)) return direct;
  VectorXd continued = carter_h(grid);
  const double shortest = grid.hot ? 1.005 : 1.05;
  for (double share = 0x1p-9, growth = 2; growth > shortest;) {
    const double next = std::min(1.0, share * growth);
    VectorXd trial = continued;
    const int steps = newton(grid, next, trial);
    if (steps == 0 || !slips(next, trial)) {
      growth = std::sqrt(growth);
      continue;
    }
    if (next == 1) {
      h = trial;
      return steps;
    }
    continued = trial;
    share = next;
  }
  return direct;  // on a coarse grid, a flux of the wrong sign is a better start than none
}

/// By r, at the stick nodes, from the values there.
ArrayXd slope_on_stick(const ContactGrid& grid, const VectorXd& values) {
  const Nodes& z = grid.nodes;
  const GaussLegendre& stick = grid.rules.stick;
  const ArrayXd dx_dr = -stick.w / (z.over_w * (z.d * (z.zones.stick - z.d)).sqrt());
  return dx_dr * (stick.p * derivative(to_legendre(stick, values))).array();
}

Factors factors(const ContactGrid& grid, const VectorXd& h) {
  const Nodes& z = grid.nodes;
  const TractionOperators& tractions = grid.tractions;
  const Index n = z.y.size(), m = z.d.size();
  const double friction = grid.scene.friction;
  const double kappa = 1 + (tractions.kappa.dot(h) + grid.thermal.bulk.kappa);
  ArrayXd f = grid.thermal.f * h, g = strain_on_stick(grid, h);
  const ArrayXd df = slope_on_stick(grid, f.tail(m)), dg = slope_on_stick(grid, g);
  const ArrayXd over_root = z.over_root.array();
  ArrayXd p = 2 * kappa - over_root.tail(m) * df, v = 2 * friction * kappa - z.over_w * dg;
  ArrayXd distance(m), from_slip(n);
  for (Index i = 0; i < m; ++i) {
    from_slip = z.zones.slip * z.t + z.d(i);
    p(i) -= (over_root.head(n) * (f.head(n) - f(n + i)) / from_slip).sum();
    distance = z.d(i) - z.d;
    distance(i) = 1;  // any number: f - f is 0 there
    p(i) -= (over_root.tail(m) * (f.tail(m) - f(n + i)) / distance).sum();
    v(i) -= (z.over_w * (g - g(i)) / distance).sum();
  }
  p /= pi;
  v /= pi;
  if (grid.bulk) p += grid.thermal.bulk.pressure.tail(m).array();
  ArrayXd pressure(m + n), slip(m + n), s(m + n), phi;
  if (grid.hot) {
    const LawAtNodes at = law_at_nodes(grid, 1, h);
    phi.resize(m + n);
    phi << law_on_stick(grid, h, at, p, v).reverse(), at.phi;
    slip.tail(n) = at.slip;
  } else {
    slip.tail(n) = slip_factor(grid, 1, h);
  }
  pressure << p.reverse(), tractions.p0 + (tractions.p * h).array();
  slip.head(m) = v.reverse();
  s << z.r.reverse(), z.s;
  return {friction, z.zones.c0(), kappa, s, pressure, slip, phi};
}

std::vector<Kink> kinks_on(const ContactGrid& grid, const VectorXd& h, double hottest) {
  const LawAtNodes at = friction_at_nodes(grid, 1, h);
  const TemperaturesOnZone zone = with_ends(grid, at.temperature);
  const ArrayXd &y = zone.y, &temperature = zone.value;
  const ArrayXd friction = friction_in_gaps(grid, at.pressure);
  const double top = legendre(ArrayXd::Constant(1, hottest), h.size()).row(0).dot(zone.series);
  std::vector<Kink> kinks;
  const auto psi = [&](double place) {
    return SlipPoint(1 + place, 1 - place, grid.nodes.zones.variable).psi;
  };
  const auto look = [&](double from, double to, double at_from, double at_to, double part) {
    const auto [low, high] = std::minmax(at_from, at_to);
    const Jump jump = jump_between(grid.scene.law, low, high);
    if (jump.size == 0) return;
    const double place = place_of(zone.series, jump.temperature, from, to);
    const double step = psi(to) - psi(from), lost = jump.size * (high - low) * part;
    kinks.push_back({psi(place), lost / (step * step), lost / 12});
  };
  for (Index i = 0; i < friction.size(); ++i) {
    const double left = temperature(i), right = temperature(i + 1);
    const bool between = y(i) < hottest && hottest < y(i + 1) && top > std::max(left, right);
    look(y(i), between ? hottest : y(i + 1), left, between ? top : right, friction(i));
    if (between) look(hottest, y(i + 1), top, right, friction(i));
  }
  return kinks;
}

}  // namespace thermoroll
