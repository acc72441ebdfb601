// Tangled from paper/13-border-and-error.md, paper/20-full-slip.md, paper/21-hot-friction.md; edit there.
#include "solver/grid_solution.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/full_slip.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;
using enum Quantity;

namespace {

ArrayXd conducted_upstream(const ContactGrid& grid, const VectorXd& h, const ArrayXd& distance) {
  const ZoneLengths& at = grid.nodes.zones;
  const Conduction conduction(grid.scene, !grid.crossing);
  const VectorXd smooth = without_ripples(grid.scene, h);
  return heat_share(grid.scene) *
         surface_temperature(at, conduction, smooth, at.c0() - distance, grid.rules.fine);
}

ArrayXd crossing_on_stick(const ContactGrid& grid, const VectorXd& h) {
  const Index m = grid.nodes.d.size();
  VectorXd values = grid.thermal.bulk.temperature.tail(m);
  if (grid.crossing) values += grid.crossing->temperature.bottomLeftCorner(m, h.size()) * h;
  return values.array() + std::abs(grid.scene.bulk_difference);
}

double place_on_stick_zone(const ContactGrid& grid, double y) {
  const VectorXd distance = to_legendre(grid.rules.stick, grid.nodes.d.matrix());
  const auto polynomials = legendre(ArrayXd::Constant(1, y), distance.size());
  return grid.nodes.zones.c0() - polynomials.row(0).dot(distance);
}

void compare_with_stick_zone(Results& value, const ContactGrid& grid, const VectorXd& h) {
  const double lowest = std::abs(grid.scene.bulk_difference);
  const ArrayXd crossing = crossing_on_stick(grid, h);
  const double at_border = conducted_upstream(grid, h, ArrayXd::Zero(1))(0);
  if (1.1 * (at_border + crossing.maxCoeff()) < value(max_temperature) + lowest) return;
  const ArrayXd all = conducted_upstream(grid, h, grid.nodes.d) + crossing;
  const HottestPoint top = largest_of_series(to_legendre(grid.rules.stick, all.matrix()));
  const double hottest = top.value - lowest;
  if (hottest <= value(max_temperature)) return;
  value(max_temperature) = hottest;
  value(max_temperature_at) = place_on_stick_zone(grid, top.y);
}

/// The y of a point in another variable.
double place_in(const SlipVariable& by, const SlipPoint& at) {
  const double t = at.t(), rest = at.v * at.v * (1 + 2 * at.u);
  return t < rest ? distance_of_share(t, by) - 1 : 1 - distance_of_share(rest, mirrored(by));
}

/// The hottest point, from which to search; another variable has another curvature.
HottestPoint peak_in(const SlipVariable& by, const GridSolution& x) {
  const SlipVariable& own = x.at.variable;
  if (by == own) return x.peak;
  return {place_in(by, SlipPoint(1 + x.peak.y, 1 - x.peak.y, own)), 0, x.peak.curvature};
}

/// The coefficients of the h of a solution; of one with more unknowns the first ones.
VectorXd carried_to(const ContactGrid& grid, const GridSolution& from) {
  const SlipVariable &own = grid.nodes.zones.variable, &other = from.at.variable;
  VectorXd h = VectorXd::Zero(grid.nodes.y.size());
  const Index shared = std::min(h.size(), from.h.size());
  h.head(shared) = from.h.head(shared);
  if (own == other) return h;
  const ArrayXd y = grid.nodes.y.unaryExpr(
      [&](double place) { return place_in(other, SlipPoint(1 + place, 1 - place, own)); });
  return to_legendre(grid.rules.slip, legendre(y, from.h.size()) * from.h);
}

Results values_on_grid(const ContactGrid& grid, const GridSolution& found) {
  const ZoneLengths& at = found.at;
  const Resultants sum = resultants(grid, found.h);
  const SlipPoint top(1 + found.peak.y, 1 - found.peak.y, at.variable);
  const double creep = sum.constant - grid.scene.friction * sum.gamma0;
  const double heat = at.slip * at.slip * grid.nodes.heat.dot(grid.rules.slip.p * found.h);
  Results value = Results::Zero();
  value << at.c0(), at.slip, sum.traction, sum.constant, creep, sum.kappa, sum.gamma0, heat,
      heat_share(grid.scene) * found.peak.value - std::abs(grid.scene.bulk_difference),
      at.c0() + at.slip * top.t(), 0;
  if (grid.bulk && at.stick > 0) compare_with_stick_zone(value, grid, found.h);
  return value;
}

/// Its Legendre coefficients on the slip zone, divided by the share of the half-space; none if no
/// crossing heat is solved for.
VectorXd temperature_by_exchange(const ContactGrid& grid, const VectorXd& h) {
  if (!grid.crossing && !grid.bulk) return {};
  const Index n = grid.nodes.y.size();
  VectorXd values = VectorXd::Zero(n);
  if (grid.crossing) values = grid.crossing->temperature.topLeftCorner(n, h.size()) * h;
  if (grid.bulk) values += grid.thermal.bulk.temperature.head(n);
  VectorXd series = to_legendre(grid.rules.slip, values);
  series(0) += std::abs(grid.scene.bulk_difference);
  return series / heat_share(grid.scene);
}

std::optional<CrossingHeat> crossing_heat(const ContactGrid& grid, const GridSolution& found) {
  if (!grid.crossing && !grid.bulk) return std::nullopt;
  const double closed_form = effusivity_share(grid.scene) - heat_share(grid.scene);
  CrossingHeat x{closed_form * found.value(heat_integral), 0};
  if (grid.crossing) {
    x.heat = grid.crossing->heat.head(found.h.size()) * found.h;
    x.edge = grid.crossing->edge.head(found.h.size()) * found.h;
  }
  if (grid.bulk) {
    x.heat += grid.scene.bulk_difference * grid.bulk->heat;
    x.edge += grid.scene.bulk_difference * grid.bulk->edge;
  }
  return x;
}

Factors without_edges(Factors at) {
  const auto edge = 1 - at.s.abs() < 1e-4;
  at.pressure = edge.select(1, at.pressure);
  at.slip = (edge && at.s < at.border).select(0, at.slip);
  return at;
}

/// The nodes at which the flux has a maximum.
std::vector<Index> flux_maxima(const ContactGrid& grid, const VectorXd& h) {
  const ArrayXd& t = grid.nodes.t;
  const ArrayXd flux = (t * (1 - t)).sqrt() * (grid.rules.slip.p * h).array();
  const double ripple = 1e-6 * flux.maxCoeff();
  std::vector<Index> maxima;
  Index top = 0, bottom = -1;  // of the way up, or of the way down if there is one
  for (Index i = 1; i < flux.size(); ++i) {
    const bool up = bottom < 0;
    if (up && flux[i] > flux[top]) top = i;
    if (!up && flux[i] < flux[bottom]) bottom = i;
    if (up && flux[i] < flux[top] - ripple) {
      maxima.push_back(top);
      bottom = i;
    } else if (!up && flux[i] > flux[bottom] + ripple) {
      top = i;
      bottom = -1;
    }
  }
  return maxima;
}

const GaussLegendre& rule_for_hottest(const ContactGrid& grid) {
  const auto nodes = static_cast<int>(grid.rules.fine.x.size());
  return quadrature_rule(grid.nodes.y.size() > 12 ? nodes : nodes - 16);
}

HottestPoint hottest_on(const ContactGrid& grid, const VectorXd& h, const GridSolution& last) {
  const Conduction conduction(grid.scene, !grid.crossing);
  const VectorXd smooth = without_ripples(grid.scene, h), more = temperature_by_exchange(grid, h);
  const ZoneLengths& at = grid.nodes.zones;
  const GaussLegendre& rule = rule_for_hottest(grid);
  const bool first = last.newton_steps == 0 || !(last.peak.curvature < 0) || last.peak.y < -0.9;
  HottestPoint top = find_hottest(
      at, conduction, smooth,
      first ? expected_hottest(at, conduction.peclet) : peak_in(at.variable, last), rule, more);
  const auto also_from = [&](const HottestPoint& start) {
    const HottestPoint other = find_hottest(at, conduction, smooth, start, rule, more);
    if (other.value > top.value * (1 + 1e-9)) top = other;
  };
  if (grid.bulk) {
    const GaussLegendre& rough = quadrature_rule(32 + more_graded(at.variable));
    const HottestPoint other = hottest_elsewhere(at, conduction, smooth, top, rough, more);
    if (other.value > 0.97 * top.value) also_from({other.y, 0, -3});
  }
  const std::vector<Index> maxima = flux_maxima(grid, h);
  const double n = static_cast<double>(h.size());
  if (maxima.size() > 1 && maxima.size() <= 8)
    for (const Index i : maxima) also_from({grid.nodes.y[i], 0, -n * n});
  return top;
}

GridSolution solve_on(const ContactGrid& grid, const GridSolution& from) {
  const ZoneLengths& at = grid.nodes.zones;
  GridSolution found;
  found.at = at;
  found.h = carter_h(grid);
  if (from.newton_steps > 0) found.h = carried_to(grid, from);
  found.newton_steps = solve_flux(grid, found.h);
  found.peak = hottest_on(grid, found.h, from);
  found.value = values_on_grid(grid, found);
  found.crossing = crossing_heat(grid, found);
  if (grid.hot) found.kinks = kinks_on(grid, found.h, found.peak.y);
  if (!found.value.allFinite()) found.newton_steps = 0;  // at extreme speeds
  return found;
}

GridSolution judged(GridSolution found, const ContactGrid& grid) {
  Factors at_nodes = factors(grid, found.h);
  const auto sticks = at_nodes.s < at_nodes.border;
  if (found.at.stick < 1e-8) at_nodes.slip = sticks.select(0, at_nodes.slip);
  found.violations = violations(found.crossing ? without_edges(at_nodes) : at_nodes);
  return found;
}

/// At the border of x, which heat moves by this step.
double effect_of_heat(const Scene& scene, const GridSolution& x, double step) {
  const double b = x.at.stick / 2, half = x.at.slip / 2, f = scene.friction;
  const Results cold = carter_values({f, b, half, b - half, 2 * f / pi * half});
  const Results change = (x.value - cold).abs() / scale_of(x.value);
  return std::max(change.head(compared - 1).maxCoeff(),
                  std::abs(step) / std::min(x.at.slip, x.at.stick));
}

/// By c0, without the change of both factors.
double temperature_by_border(const ContactGrid& grid, const GridSolution& x) {
  const double step = 1e-3 * std::min(x.at.slip, x.at.stick);
  const ZoneLengths there = moved_by(x.at, step);
  const ArrayXd grown = (there.stick + there.slip * grid.nodes.t) / grid.nodes.sigma;
  const VectorXd h = grown.matrix().cwiseProduct(grid.rules.slip.p * x.h);
  const TemperatureAndSlope hottest =
      temperature_and_slope(there, Conduction(grid.scene, true), to_legendre(grid.rules.slip, h),
                            1 + x.peak.y, 1 - x.peak.y, 0, rule_for_hottest(grid));
  return heat_share(grid.scene) * (hottest.value - x.peak.value) / step;
}

}  // namespace

GridSolution solve_on_grid(const Scene& scene, Formulation formulation, int n,
                           const ZoneLengths& at, const GridSolution& from) {
  const ContactGrid grid = contact_grid(scene, formulation, at, n);
  return judged(solve_on(grid, from), grid);
}

double residual(const GridSolution& x, const Prescribed& given) {
  if (given.quantity != stick_slip_border) return given.value - x.value(given.quantity);
  return x.at.slip < x.at.stick ? x.at.slip - (1 - given.value) : 1 + given.value - x.at.stick;
}

ZoneLengths moved_by(const ZoneLengths& zones, double step) {
  const double slip = zones.slip - step, stick = zones.stick + step;
  if (slip < stick) return {slip, 2 - slip, zones.variable};
  return {2 - stick, stick, zones.variable};
}

GridSolution find_border(const Scene& scene, Formulation formulation, int n,
                         const Prescribed& given, GridSolution level, Results& slope, double weak) {
  ZoneLengths at = level.at;
  double taken = 0;
  for (int k = 0, failed = 0; k < 30; ++k) {
    const bool solved = taken != 0;  // at another border
    const GridSolution last = level;
    const ContactGrid grid = contact_grid(scene, formulation, at, n);
    level = solve_on(grid, last);
    if (level.newton_steps == 0) {
      const bool may_shorten = scene.law && given.quantity != stick_slip_border;
      if (++failed == 8 || !(solved || may_shorten)) break;
      at = moved_by(at, solved ? (at.slip - last.at.slip) / 2 : at.slip / 2);
      level = last;
      continue;
    }
    if (given.quantity == stick_slip_border) return judged(level, grid);
    const double moved = solved ? level.value(given.quantity) - last.value(given.quantity) : 0;
    const double by_rounding = 4e-15 * std::abs(given.value);
    if (std::abs(moved) > by_rounding) slope = (level.value - last.value) / moved;
    const double noise = std::abs(slope(stick_slip_border)) * by_rounding;
    const double room = std::min(at.slip, at.stick), near = std::max(1e-3 * room, noise);
    const double least = given.quantity == creep ? std::max(noise, 1e-15) : 1e-15;
    double step = slope(stick_slip_border) * residual(level, given);
    if (!(room > least && std::isfinite(step))) break;  // the border leaves the contact
    if (!solved && !grid.crossing && effect_of_heat(scene, level, step) < weak) {
      slope(max_temperature) = slope(stick_slip_border) * temperature_by_border(grid, level);
      return judged(level, grid);
    }
    const bool is_derivative = solved && std::abs(taken) <= std::max(0.06 * room, near);
    if (is_derivative && std::abs(step) <= near) return judged(level, grid);
    const bool leaves = k == 1 && given.quantity == creep && -step > at.stick;
    if (leaves && given.value > creep_next_to_full_slip(scene, formulation, n)) break;
    if (std::abs(step) < near) step = std::copysign(near, step);  // for the derivative
    taken = std::clamp(step, -0.7 * at.stick, 0.7 * at.slip);
    at = moved_by(at, taken);
  }
  level.newton_steps = 0;
  return level;
}

GridSolution next_to_full_slip(const Scene& scene, Formulation formulation, int n) {
  const auto with = [&](double stick, const GridSolution& from) {
    return solve_on_grid(scene, formulation, n, {2 - stick, stick, about_kinks(from, n)}, from);
  };
  GridSolution level = with(1e-6, {});
  if (level.newton_steps == 0)
    for (const double stick : {1.0, 0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
      level = with(stick, level);
  const GridSolution again = misses_kink(level) ? with(1e-6, level) : level;
  return again.newton_steps > 0 ? again : level;
}

double creep_next_to_full_slip(const Scene& scene, Formulation formulation, int n) {
  const GridSolution full = next_to_full_slip(scene, formulation, n);
  return full.newton_steps > 0 ? full.value(creep) : std::numeric_limits<double>::infinity();
}

double creep_of_some_stick(const Scene& scene, Formulation formulation) {
  double known = 0, before = 0;
  GridSolution last;
  for (const double slip : {0.02, 0.06, 0.1, 0.2, 0.4, 0.7, 1.0, 1.3, 1.6, 1.8, 1.9, 1.99}) {
    last = solve_on_grid(scene, formulation, 80, {slip, 2 - slip}, last);
    const double now = last.value(creep);
    if (last.newton_steps == 0 || !last.violations.empty() || !(now > known)) break;
    before = known;
    known = now;
  }
  return before;
}

double unresolved(double tail, int n, bool slow, double of_integrals, double in_layer) {
  const bool early = n <= 100 && n >= 30;
  const double large = slow ? 0 : early ? 2e-4 : 1e-3;
  const double layer = tail > large ? std::min(in_layer * tail, 1.0) : 0;
  return tail * std::max(of_integrals / n / n, layer);
}

GridSolution solve_slipping_grid(SlippingGrids& grids, int n, double creep,
                                 const GridSolution& from, const SlipVariable& by) {
  auto& [scene, formulation, kept] = grids;
  const auto known = kept.find(n);
  if (known != kept.end() && known->second.nodes.zones.variable != by) kept.erase(known);
  if (kept.count(n) == 0) kept.emplace(n, full_slip_grid(scene, formulation, n, by));
  const ContactGrid grid = at_creep(kept.at(n), creep);
  return judged(solve_on(grid, from), grid);
}

/// The places of one or two kinks, the stronger first; at least one kink is known.
std::vector<double> crowded_places(std::vector<Kink> kinks, int n) {
  std::sort(kinks.begin(), kinks.end(), [](auto& a, auto& b) { return a.jump > b.jump; });
  const Kink& strongest = kinks[0];
  const auto counts = [&](const Kink& kink) {
    return kink.jump >= 16 * strongest.jump / (n * n) &&
           std::abs(kink.place - strongest.place) >= 1.2 / n;
  };
  const auto second = std::find_if(kinks.begin(), kinks.end(), counts);
  if (n < 100 || second == kinks.end()) return {strongest.place};
  return {strongest.place, second->place};
}

SlipVariable about_kinks(const GridSolution& from, int n) {
  SlipVariable by;
  if (from.kinks.empty()) return by;
  std::vector<double> places = crowded_places(from.kinks, n);
  std::sort(places.begin(), places.end());
  auto& [first, second] = by.clusters;
  const double width = 0.6 / n;
  first = cluster_at(places.back(), width);
  if (places.size() == 1) return by;
  const double before = distance_before(first, 1 + places.front()) - 1;
  second = cluster_at(before, width / growth_at(first, before));
  return by;
}

SlipVariable variable_after(const GridSolution& from, int n) {
  const bool same = n == from.h.size() || from.kinks.empty();
  return same ? from.at.variable : about_kinks(from, n);
}

bool misses_kink(const GridSolution& x) {
  if (x.newton_steps == 0 || x.kinks.empty()) return false;
  const auto& nodes = x.at.variable.clusters;
  const auto kinks = about_kinks(x, static_cast<int>(x.h.size())).clusters;
  const auto misses = [](const Cluster& a, const Cluster& b) {
    return (a.rate == 0) != (b.rate == 0) || std::abs(a.place - b.place) > b.width / 2;
  };
  return misses(nodes[0], kinks[0]) || misses(nodes[1], kinks[1]);
}

int unknowns_after(int n, bool bulk) {
  if (n < 36) return 3 * n / 2;
  if (n < 54) return bulk ? 8 * n / 5 : n + 12;
  return std::min(2 * n, most_unknowns);
}

double part_with_law(const VectorXd& before, const VectorXd& now) {
  const double finer = static_cast<double>(before.size()) / static_cast<double>(now.size());
  const double least = 0.6 * std::pow(finer, 3), most = now.size() > 200 ? 0.05 : 0.2;
  const double shrunk = 1.2 * tail(now) / (tail(before) + 1e-9);
  return std::min(std::max(shrunk, least), std::max(most, least));
}

bool decays_slowly(const VectorXd& before, const VectorXd& now) {
  const double finer = static_cast<double>(before.size()) / static_cast<double>(now.size());
  return tail(now) > std::max(1e-6, std::pow(finer, 3) * tail(before));
}

double error_of_kinks(const GridSolution& x) {
  double sum = 0;
  for (const Kink& kink : x.kinks) sum += 10 * kink.error;
  return sum;
}

}  // namespace thermoroll
