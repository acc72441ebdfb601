// Tangled from paper/17-least-model.md; edit there.
#include "solver/least_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/contact_grid.hpp"
#include "solver/full_slip.hpp"
#include "solver/surface.hpp"
#include "support/number_text.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::VectorXd;
using enum Quantity;

namespace {

ZoneLengths zones_of(const Carter& c) { return {2 * c.slip_half_width, 2 * c.b}; }

/// The limit @eq:fast-limit: y of the top, T* sqrt(Pe) / (f slip^1.5) there and its curvature, as
/// Legendre series in 2 ell - 1.
struct FastLimit {
  FastLimit() : y(20), value(20), curvature(20) {
    const GaussLegendre& rule = gauss_legendre(20);
    for (Eigen::Index i = 0; i < 20; ++i) {
      const double slip = 1 + rule.x(i), peclet = 1e7 / slip;
      const ZoneLengths at{slip, 2 - slip};
      const HottestPoint top = find_hottest(at, peclet, carter_h(at, 1), {}, quadrature_rule(200));
      y(i) = top.y;
      value(i) = top.value * std::sqrt(peclet) / std::pow(slip, 1.5);
      curvature(i) = top.curvature;
    }
    for (VectorXd* series : {&y, &value, &curvature}) *series = to_legendre(rule, *series);
  }
  VectorXd y, value, curvature;
};

HottestPoint fast_limit(const ZoneLengths& at, double friction, double peclet) {
  static const FastLimit limit;
  const Eigen::RowVectorXd p = legendre(ArrayXd::Constant(1, at.slip - 1), 20).row(0);
  const double unit = friction * std::pow(at.slip, 1.5) / std::sqrt(peclet);
  return {p.dot(limit.y), unit * p.dot(limit.value), p.dot(limit.curvature)};
}

const GaussLegendre& graded_nodes(double tolerance, double lambda) {
  const double digits = std::ceil(-std::log10(tolerance));
  const double by_digits = 8 + std::ceil(7 * digits + 3 * decades_beyond(lambda));
  const double nodes = std::max(by_digits, std::pow(60 / tolerance, 1 / 6.0));
  return rounded_up(8, static_cast<int>(std::min(nodes, most_unknowns + 24.0)));
}

/// The hottest point for Carter's heat, to a tenth of the tolerance.
HottestPoint hottest_of_carter(const ZoneLengths& at, double friction, double peclet,
                               double tolerance) {
  const double lambda = at.slip * peclet;
  const HottestPoint fast = fast_limit(at, friction, peclet);
  if (1.3 / (lambda * lambda) < tolerance / 10) return fast;
  return find_hottest(at, peclet, carter_h(at, friction), fast, graded_nodes(tolerance, lambda));
}

bool sticks_without_heat(double friction, const Prescribed& given) {
  const double x = given.value, in_creep = given.quantity == creep ? pi / 2 : 1;
  return given.quantity == stick_slip_border || (0 < x && in_creep * x < friction);
}

GridRules rules_of_correction(const Scene& scene, const ZoneLengths& at, int least) {
  const double narrow = decades_shorter(at), extreme = std::max(0.0, narrow - 3);
  const double fast = std::max(0.0, std::log10(at.slip * scene.peclet) - 6);
  const double more = 3 * narrow + 5 * extreme + 5 * fast;
  return GridRules(static_cast<int>(std::min(least + more, 1.0 * most_unknowns)));
}

/// The effect of heat on the solution without heat.
struct Correction {
  Carter carter;                      // without the heat that is added here
  VectorXd h;                         // its values of h at the nodes
  Results value, cold;                // all but the temperature, with heat and at the old border
  double most, mean;                  // relative change of the flux, at any node and over the heat
  double sticks = 0;                  // in full slip, a zone that heat may let stick
  std::vector<Violation> violations;  // at the old border
};

Correction correct(const Scene& scene, Formulation formulation, const Prescribed& given,
                   const Carter& cold, const VectorXd& h0, int least) {
  const double f = scene.friction;
  const ZoneLengths before = zones_of(cold);
  const GridRules rules = rules_of_correction(scene, before, least);
  const ContactGrid grid = contact_grid(scene, formulation, before, rules, h0.size());
  const Resultants sum = resultants(grid, h0);
  Results change = Results::Zero();
  change(traction) = sum.traction - carter_values(cold)(traction);
  change(creep_constant) = sum.constant - cold.creep;
  change(creep) = change(creep_constant) - f * sum.gamma0;
  change(load_ratio) = sum.kappa - 1;
  change(gamma0) = sum.gamma0;
  const Prescribed without{given.quantity, given.value - change(given.quantity)};
  const bool near = sticks_without_heat(f, without);
  const Carter c = near ? carter_given(f, without) : cold;
  const double unit = 4 * f / (pi * pi);  // h = unit sigma without heat
  const Nodes& z = grid.nodes;
  const TractionOperators& tractions = grid.tractions;
  const ArrayXd flat = unit * z.sigma;
  const ArrayXd p = tractions.p0 + (tractions.p * h0).array();
  const ArrayXd v = tractions.v0 + (tractions.v * h0).array();
  const ArrayXd gained = z.sigma * p * v - flat;
  Correction x;
  const ZoneLengths at = zones_of(c);
  x.h = unit * (at.stick + at.slip * z.t) + gained;
  change(heat_integral) = at.slip * at.slip * z.heat.dot(gained.matrix());
  x.most = gained.abs().maxCoeff() / flat.maxCoeff();
  x.mean = z.heat.dot(gained.abs().matrix()) / z.heat.dot(flat.matrix());
  x.violations = violations(factors(grid, h0));
  if (!near) x.most = x.mean = std::numeric_limits<double>::infinity();
  x.carter = c;
  x.cold = carter_values(cold);
  x.value = carter_values(c) + change;
  return x;
}

double largest_change(const Correction& x) {
  const Results change = (x.value - x.cold).abs() / scale_of(x.cold);
  return std::max(change.head(compared - 1).maxCoeff(), x.mean);
}

Results grid_error(const Correction& x) {
  const ZoneLengths at = zones_of(x.carter);
  const double unequal = std::max(at.stick / at.slip, 1e-3 * at.slip / at.stick);
  const double in_creep = 1.5e-4 + 1.2e-3 * std::min(1.0, unequal / 10);
  const double slips = 6e-3 * std::min(1.0, 3e-5 * at.slip / at.stick);
  const double in_border = 1.6e-4 + slips;
  Results share;
  share << in_border, in_border, 6e-5, in_creep, in_creep, 2.5e-4 + slips, 6e-5 + slips, 2.2e-3,
      1.8e-3, 0, 0;
  return x.mean * share;
}

Results error_of_closed_form(const Correction& x) {
  Results change = (x.value - x.cold).abs() / scale_of(x.cold);
  change(Quantity::max_temperature) = x.mean + 1.5 * change(slip_length) / x.cold(slip_length);
  const double r = largest_change(x);
  return 1.5 * change + 0.01 * r + r * r + 30 * grid_error(x);
}

double temperature_at(const HottestPoint& top, const Scene& scene, const Correction& x,
                      const GaussLegendre& rule) {
  const VectorXd h = to_legendre(gauss_legendre(static_cast<int>(x.h.size())), x.h);
  const ZoneLengths at = zones_of(x.carter);
  return temperature_and_slope(at, Conduction(scene), h, 1 + top.y, 1 - top.y, 0, rule).value;
}

Scene without_heat(Scene scene) {
  scene.heating = scene.roller.heating = 0;
  return scene;
}

CoupledSolution as_solution(const Scene& scene, Formulation formulation, const VectorXd& h,
                            const Results& value, const Carter& c, const HottestPoint& top,
                            const Results& error, const Prescribed& given) {
  const ZoneLengths at = zones_of(c);
  CoupledSolution x{scene, formulation, value, value, static_cast<int>(h.size()), 0, h, {}, {}};
  x.value(Quantity::max_temperature) = heat_share(scene) * top.value;
  x.value(Quantity::max_temperature_at) = at.c0() + at.slip * SlipPoint(1 + top.y, 1 - top.y).t();
  const Results scale = scale_of(x.value);
  const Results slope = c.b > 0 ? carter_slope(c, given.quantity) : Results::Zero();
  x.error = (error + 1e-13 + rounding(given, slope, scale)) * scale;
  x.error(Quantity::max_temperature_at) = at.slip * std::sqrt(largest_error(x));
  x.value(given.quantity) = given.value;
  add_eccentricity(x.value, x.error);
  return x;
}

bool slips_without_heat(double friction, const Prescribed& given) {
  return given.quantity == creep && pi / 2 * given.value >= friction;
}

Carter carter_in_full_slip(double friction, double creep) { return {friction, 0, 1, -1, creep}; }

/// The changes of all but the temperature, at the given creep.
Correction correct_full_slip(const Scene& scene, Formulation formulation, const Carter& cold,
                             const VectorXd& h) {
  const ContactGrid grid = at_creep(full_slip_grid(scene, formulation, 10), cold.creep);
  const TractionOperators& by = grid.tractions;
  const ArrayXd flat = by.p0 * by.v0, moved = (by.v * h).array();
  const ArrayXd gained = (by.p0 + (by.p * h).array()) * (by.v0 + moved) - flat;
  Correction x;
  const Resultants sum = resultants(grid, h);
  const VectorXd& heat = grid.nodes.heat;
  x.cold = x.value = carter_values(cold);
  x.value(load_ratio) = sum.kappa;
  x.value(gamma0) = sum.gamma0;
  x.value(creep_constant) += scene.friction * sum.gamma0;
  x.value(heat_integral) += 4 * heat.dot(gained.matrix());

  x.carter = cold;
  x.h = (flat + gained).matrix();
  x.most = gained.abs().maxCoeff() / flat.maxCoeff();
  x.mean = heat.dot(gained.abs().matrix()) / heat.dot(flat.matrix());

  const double unit = 2 * scene.friction / pi;
  x.sticks = std::max(0.0, 1 + (2.5 * moved.abs().maxCoeff() - cold.creep) / unit);
  return x;
}

/// With the relative change of the largest temperature.
Results error_in_full_slip(const Correction& x, double hotter) {
  Results change = (x.value - x.cold).abs() / scale_of(x.cold);
  change(max_temperature) = hotter;
  const double r = std::max(largest_change(x), x.most);
  Results error = 1.5 * change + 0.02 * r + r * r + x.sticks * x.sticks / 4;
  error(stick_slip_border) = error(slip_length) = x.sticks;
  error(traction) = x.cold(traction) * x.sticks * x.sticks / 4;
  return error;
}

VectorXd flux_in_full_slip(const Carter& c) {
  const double f = c.friction;
  VectorXd h = carter_h(zones_of(c), f);
  h(0) += 2 / pi * (c.creep - 2 * f / pi);
  return h;
}

CoupledSolution closed_form_in_full_slip(const Scene& scene, const Approach& approach,
                                         const Prescribed& given) {
  const Carter c = carter_in_full_slip(scene.friction, given.value);
  const VectorXd h = flux_in_full_slip(c);
  const GaussLegendre& rule = graded_nodes(approach.tolerance, 2 * scene.peclet);
  const ZoneLengths at = zones_of(c);
  const HottestPoint near = expected_hottest(at, scene.peclet);
  const HottestPoint top = find_hottest(at, Conduction(scene), h, near, rule);
  const Correction x = correct_full_slip(scene, approach.formulation, c, h);
  const double hotter = temperature_at(top, scene, x, rule) / top.value - 1;
  Results error = error_in_full_slip(x, std::abs(hotter));
  error(max_temperature) += 0.1 * approach.tolerance;
  return as_solution(without_heat(scene), approach.formulation, h, x.cold, c, top, error, given);
}

/// The reason; null where a lower level may do.
const char* why_coupled(const Scene& scene) {
  if (scene.law) return "friction depends on temperature";
  if (scene.bulk_difference != 0) return "the bulk temperatures differ";
  if (is_unlike(scene)) return "the bodies have unlike diffusivities";
  return nullptr;
}

std::string brief(double x) { return std::isfinite(x) ? with_exponent(x, 2) : "an unknown part"; }

double expected_change_in_full_slip(const Scene& scene, double creep) {
  return scene.friction * heating_of_both(scene) * creep * std::min(1.0, 2 * scene.peclet);
}

Choice least_in_full_slip(const Scene& scene, const Approach& approach, const Prescribed& given) {
  const double tolerance = approach.tolerance;
  double change = expected_change_in_full_slip(scene, given.value);
  if (change <= tolerance) {
    const CoupledSolution x = closed_form_in_full_slip(scene, approach, given);
    change = largest_error(x);
    if (change <= tolerance)
      return {Model::closed_form, "heat changes no result by more than " + brief(change), x};
  }
  const std::string reason = "heat may change results in full slip by " + brief(change);
  return {Model::coupled, reason, solve_coupled(scene, approach, given)};
}

}  // namespace

double expected_second_order(double change) { return change * (change + 1.5e-3) / 2; }

double expected_change(const Scene& scene, const Carter& c) {
  const double half = c.slip_half_width, own_peclet = 2 * half * scene.peclet;
  return scene.friction * heating_of_both(scene) * std::min(std::sqrt(half), own_peclet);
}

double largest_difference(const Results& x, const Results& exact) {
  return ((x - exact).abs() / scale_of(exact)).head(compared).maxCoeff();
}

double largest_error(const CoupledSolution& x) {
  return (x.error / scale_of(x.value)).head(compared).maxCoeff();
}

CoupledSolution closed_form(const Scene& scene, const Approach& approach, const Prescribed& given) {
  if (slips_without_heat(scene.friction, given))
    return closed_form_in_full_slip(scene, approach, given);
  const Carter c = carter_given(scene.friction, given, scene.direction);
  const ZoneLengths at = zones_of(c);
  const VectorXd h = carter_h(at, scene.friction);
  const HottestPoint top = hottest_of_carter(at, scene.friction, scene.peclet, approach.tolerance);
  Results error = Results::Zero();
  if (heating_of_both(scene) > 0)
    error = error_of_closed_form(correct(scene, approach.formulation, given, c, h, 6));
  error(Quantity::max_temperature) += 0.1 * approach.tolerance;
  return as_solution(without_heat(scene), approach.formulation, h, carter_values(c), c, top, error,
                     given);
}

CoupledSolution first_order(const Scene& scene, const Approach& approach, const Prescribed& given) {
  const Carter cold = carter_given(scene.friction, given, scene.direction);
  const VectorXd h0 = carter_h(zones_of(cold), scene.friction);
  const Formulation formulation = approach.formulation;
  const Correction x = correct(scene, formulation, given, cold, h0, 16);
  const VectorXd h = to_legendre(gauss_legendre(static_cast<int>(x.h.size())), x.h);
  const ZoneLengths at = zones_of(x.carter);
  const HottestPoint near = fast_limit(at, scene.friction, scene.peclet);
  const GaussLegendre& rule = graded_nodes(approach.tolerance, at.slip * scene.peclet);
  const HottestPoint top = find_hottest(at, Conduction(scene), h, near, rule);
  const Correction next = correct(scene, formulation, given, x.carter, h, 13);
  Results later = (next.value - x.value).abs() / scale_of(x.value);
  const double hotter = temperature_at(top, scene, next, rule);
  later(Quantity::max_temperature) = std::abs(hotter / top.value - 1);
  const double r = std::max({largest_change(x), x.most, next.most});
  const double sum = r < 1 ? 1 / (1 - r) : std::numeric_limits<double>::infinity();
  const double most = later.head(compared).maxCoeff();
  Results error = sum * (2 * later + r * most) + grid_error(x);
  error(Quantity::max_temperature) += 0.1 * approach.tolerance;
  CoupledSolution solution =
      as_solution(scene, formulation, h, x.value, x.carter, top, error, given);
  solution.violations = x.violations;
  return solution;
}

Choice least_model(const Scene& scene, const Approach& approach, const Prescribed& given) {
  const double tolerance = approach.tolerance;
  check(scene, given);
  require(tolerance >= 1e-11, "tolerance", tolerance, "at least 1e-11");
  if (const char* why = why_coupled(scene))
    return {Model::coupled, why, solve_coupled(scene, approach, given)};
  if (slips_without_heat(scene.friction, given)) return least_in_full_slip(scene, approach, given);
  double change = expected_change(scene, carter_given(scene.friction, given, scene.direction));
  if (change <= tolerance) {
    CoupledSolution x = closed_form(scene, approach, given);
    change = largest_error(x);
    if (change <= tolerance)
      return {Model::closed_form, "heat changes no result by more than " + brief(change), x};
  }
  double left = expected_second_order(change);
  std::string reason = "one linear correction is expected to leave out " + brief(left);
  if (left <= tolerance) {
    CoupledSolution x = first_order(scene, approach, given);
    left = largest_error(x);
    const bool contact = x.violations.empty();
    if (left <= tolerance && contact)
      return {Model::first_order, "one linear correction leaves out at most " + brief(left), x};
    reason = contact ? "one linear correction may leave out " + brief(left)
                     : "one linear correction is no contact";
  }
  return {Model::coupled, reason, solve_coupled(scene, approach, given)};
}

void check_method(const Scene& scene, Method method) {
  if (method == Method::automatic || method == Method::coupled) return;
  if (scene.law)
    throw std::invalid_argument(
        "friction that depends on temperature needs the method coupled or auto");
  if (scene.bulk_difference != 0)
    throw std::invalid_argument("a bulk difference needs the method coupled or auto");
  if (is_unlike(scene))
    throw std::invalid_argument("bodies of unlike diffusivities need the method coupled or auto");
}

Choice solve_by_method(const Scene& scene, const Approach& a, const Prescribed& given) {
  const std::string asked = "asked for";
  if (a.method == Method::coupled) return {Model::coupled, asked, solve_coupled(scene, a, given)};
  if (a.method == Method::first_order) {
    const CoupledSolution x = first_order(scene, a, given);
    if (x.error.allFinite()) return {Model::first_order, asked, x};
    throw std::runtime_error("first-order: heat is too strong for one linear correction");
  }
  if (a.method == Method::closed_form)
    return {Model::closed_form, asked, closed_form(scene, a, given)};
  return least_model(scene, a, given);
}

}  // namespace thermoroll
