// Tangled from paper/12-coupled-problem.md, paper/13-border-and-error.md, paper/14-temperatures-and-profiles.md, paper/21-hot-friction.md; edit there.
#include "thermoroll/coupled.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/branch.hpp"
#include "solver/full_slip.hpp"
#include "solver/grid_solution.hpp"
#include "support/number_text.hpp"
#include "thermoroll/carter.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using enum Quantity;

namespace {

Carter nearest_carter(const Scene& scene, const Prescribed& given) {
  Prescribed near = beyond_no_slip(scene, given);
  if (given.quantity == creep) near.value = std::min(near.value, 1.999 * scene.friction / pi);
  return carter_given(scene.friction, near);
}

/// The larger Péclet number.
double faster(const Scene& scene) { return std::max(scene.peclet, peclet_2(scene)); }

/// The larger one over the smaller.
double unevenness(const Scene& scene) {
  return faster(scene) / std::min(scene.peclet, peclet_2(scene));
}

/// Whether that is more than thirty, without a bulk difference.
bool is_uneven(const Scene& scene) {
  return is_unlike(scene) && scene.bulk_difference == 0 && unevenness(scene) > 30;
}

/// Relative, of their results.
double rounding_of_pair(const Scene& scene) {
  return is_uneven(scene) ? 2e-16 * unevenness(scene) : 0;
}

/// With crossing heat, on a grid of n unknowns.
bool is_of_flux(const Scene& scene, int n, double tail) {
  return scene.bulk_difference == 0 && (unevenness(scene) < 1.5 || n < 30 || tail > 0.01);
}

double least_error_of_crossing_heat(const GridSolution& level) {
  const auto more = static_cast<double>(level.h.size()) - 15;
  return level.at.stick == 0 ? 2.5e-4 * std::exp(-0.3 * more) : 2e-4 * std::exp(-0.6 * more);
}

double layer_of_coarse_grid(const Scene& scene, const GridSolution& level, double flat_tail) {
  const auto n = static_cast<double>(level.h.size());
  const double of_flux = least_error_of_crossing_heat(level);
  if (scene.bulk_difference == 0) return std::max(of_flux, flat_tail / (n * n));
  return level.at.stick == 0 ? std::max(of_flux, 2 * tail(level.h) / (n * n)) : of_flux;
}

Results error_of_bulk(const Scene& scene, const GridSolution& level, const Prescribed& given,
                      const Results& slope) {
  Results error = Results::Zero();
  const auto x = bulk_exchange(scene, level.h.size());
  if (!x) return error;
  error(traction) = x->rest.traction_error;
  error(creep) = error(creep_constant) = x->rest.creep_error;
  const bool at_the_edge = 1 - level.value(max_temperature_at) < 0.01;
  error(max_temperature) = (at_the_edge ? 4 : 1) * x->temperature_error;
  error(heat_integral) = 2 / pi * level.value(slip_length) * x->rest.creep_error;
  error += slope.abs() * error(given.quantity);
  error(given.quantity) = 0;
  return std::abs(scene.bulk_difference) * error;
}

/// Large f H, in full slip times the creep in units of 2 f / pi, or a zone of less than a twentieth
/// of the contact.
bool converges_slowly(const Scene& scene, const GridSolution& x) {
  const ZoneLengths& at = x.at;
  const bool short_zone = at.stick > 0 && std::min(at.slip, at.stick) < 0.1;
  const double slides = at.stick == 0 ? pi * x.value(creep) / (2 * scene.friction) : 1;
  return scene.friction * heating_of_both(scene) * std::max(1.0, slides) > 1 || short_zone;
}

/// The unknowns of a grid and of the one before it; slow if errors fall slowly, crowded if nodes
/// are moved to the ends.
struct Convergence {
  int before, n;
  bool slow, crowded, all_slips;
};

Convergence convergence(const GridSolution& before, const GridSolution& now, bool slow) {
  return {static_cast<int>(before.h.size()), static_cast<int>(now.h.size()), slow,
          now.at.variable.beta > 0, now.at.stick == 0};
}

/// The part of a change since the previous grid that is counted as the error of this one.
double part_of_change(const Convergence& at) {
  if (at.slow && at.n <= 200) return 1;
  const bool near = 2 * at.n <= 3 * at.before;
  if (near && (at.crowded || at.n > 200)) return 0.5;
  return at.crowded || at.n <= 200 ? 0.2 : 0.05;
}

/// The factor of the part of a change, by the tail now and before.
double shrinking(double now, double before, const Convergence& at) {
  if (at.n > 200) return 1;
  const double least = at.n < 30 ? 0.2 : at.crowded ? 0.15 : at.slow ? 0.05 : 0.02;
  return std::clamp(15 * now / before, least, at.slow ? 1.0 : 2.5);
}

/// How far each quantity is from its value without heat, relative to its scale and at most 1, with
/// a twentieth of the largest of them, or a tenth with a law; C and the creep both have the larger
/// of theirs, and twice that counts; the heat and the temperature have 1.
Results share_in_effects(const Scene& scene, const GridSolution& level, const Prescribed& given,
                         const Results& value) {
  const bool no_cold = scene.law && given.quantity == traction;
  if (scene.bulk_difference != 0 || level.at.stick == 0 || no_cold) return Results::Ones();
  const Results cold = carter_values(nearest_carter(scene, given));
  Results share = ((value - cold) / scale_of(value)).abs().min(1.0);
  share(creep) = std::max(share(creep), share(creep_constant));
  share(creep_constant) = share(creep);
  share += (scene.law ? 0.1 : 0.05) * share.head(compared - 2).maxCoeff();
  share = (2 * share).min(1.0);
  share(heat_integral) = share(max_temperature) = 1;
  return share;
}

/// Relative errors due to the graded rules of n unknowns.
Results error_of_rules(const Scene& scene, int n) {
  const double strain = scene.friction * heating_of_both(scene) * std::sqrt(scene.peclet);
  const double of_28 = (scene.law ? 1e-7 : 4e-7) * std::min(1.0, strain);
  const double error = of_28 * std::exp(-0.53 * (graded_nodes(n) - 28));
  const double speed = scene.peclet / 10;
  Results errors = Results::Constant(error / 8 * std::clamp(speed, 0.02, 1.0));
  errors(heat_integral) = errors(max_temperature) = error * std::clamp(speed, 0.05, 1.0);
  errors(max_temperature) += is_unlike(scene) ? 6e-12 : 0;  // of the tables of both bodies
  return errors;
}

/// The error of quadrature near the leading edge, on a grid of n unknowns; times the share of heat.
double error_of_leading_edge(const ZoneLengths& at, int n) {
  const double eps = at.stick / at.slip;
  const std::complex<double> u(0, std::sqrt(eps / 3));
  std::complex<double> y = (std::sqrt(9.0 + 1056.0 * u) - 3.0) / 24.0 - 1.0;
  for (const Cluster& c : at.variable.clusters)
    if (c.rate > 0) y = c.middle + std::asinh((y - c.place) / c.width) / c.rate;
  const double beta = at.variable.beta;
  if (beta > 0) y = std::atanh(y * std::tanh(beta)) / beta;
  const auto root = std::sqrt(y * y - 1.0);
  const double semi_axes = std::max(std::abs(y + root), std::abs(y - root));
  return 10 * std::sqrt(eps) * std::pow(semi_axes, -2 * n);
}

Results share_at_leading_edge(const Scene& scene, const Results& share, const Results& scale,
                              const Prescribed& given) {
  Results of_forces = share.min(share.head(compared - 2).maxCoeff());
  if (given.quantity != creep) return of_forces;
  const Results slope = carter_slope(nearest_carter(scene, given), creep);
  return of_forces.max(share(creep) * scale(creep) * slope.abs() / scale);
}

Results errors_near_leading_edge(const Scene& scene, const GridSolution& level,
                                 const Prescribed& given, const Results& share,
                                 const Results& scale, const Results& corrected) {
  const auto n = static_cast<int>(level.h.size());
  const double moved = std::max(corrected(stick_slip_border), 0.0) * scale(stick_slip_border);
  const double part = level.at.stick > 0 ? moved / (2 * level.at.stick) : 0;
  const double error =
      error_of_leading_edge(level.at, n) + part * error_of_leading_edge(level.at, 10);
  return error * share_at_leading_edge(scene, share, scale, given);
}

double error_of_one_temperature(int n) { return 12 * std::pow(24 + std::max(n, 20), -6); }

Results law_error(const Scene& scene, int n, const Prescribed& given, const Results& slope) {
  if (!scene.law || given.quantity != traction) return Results::Zero();
  return error_of_one_temperature(n) * (given.value * slope).abs();
}

/// Estimated errors, each relative to its scale, on a grid with the tail now and before, by the
/// change since the previous grid and the share of each quantity in the effects of heat.
Results estimate(const Results& change, const Results& share, double now, double before,
                 const Convergence& at) {
  const double part = part_of_change(at), product = part * shrinking(now, before, at);
  Results error = product * change;
  const double of_one_point = std::min(product, std::clamp(now / before, part / 4, part));
  if (!at.slow) error(max_temperature) = of_one_point * change(max_temperature);
  const double largest = error.head(compared).maxCoeff(), in_layer = at.slow ? 200 : 30;
  const double of_integrals = at.n < 30 || at.all_slips ? 20 : 10;
  const double of_tail = unresolved(now, at.n, at.slow, of_integrals, in_layer);
  const double stalled = at.n >= 30 && now >= before ? now : 0;
  error = error.max(share * std::max({largest, of_tail, stalled}));
  error(max_temperature) += error_of_one_temperature(at.n);
  return error + 2e-15 * at.n;
}

/// After a grid of n unknowns and the one before it, for an estimate that is so many times the
/// tolerance.
int next_unknowns(const Scene& scene, int n, const GridSolution& last, const GridSolution& level,
                  double missing) {
  const auto before = static_cast<int>(last.h.size()), now = static_cast<int>(level.h.size());
  double next = scene.bulk_difference != 0 ? 1.6 * n : 2 * n;
  const bool steady = !level.crossing && (now > 50 || !converges_slowly(scene, level));
  if (now > before && steady && level.violations.empty()) {
    const double rate = std::log(tail(last.h) / tail(level.h)) / (now - before);
    const bool layers = strain_of_zone(scene, level.at) >= strain_of_layers;
    const double left = std::log(layers ? missing : missing / 4);
    if (rate > 0 && std::isfinite(left)) next = std::clamp(n + left / rate + 4, 1.3 * n, next);
  }
  const int group = static_cast<int>(std::bit_floor(static_cast<unsigned>(next))) / 8;
  const int least = static_cast<int>(std::ceil(next));
  return std::min((least + group - 1) / group * group, most_unknowns);
}

double error_of_temperature_at_kinks(const GridSolution& level, double change) {
  const double n = static_cast<double>(level.h.size()), of_tail = 100 * tail(level.h) / (n * n);
  return n > 200 ? std::clamp(of_tail, change, 10 * change) : std::max(of_tail, 2 * change);
}

/// By the change since the grid before.
Results estimate_with_kinks(const GridSolution& level, const Results& change) {
  const double part = level.crossing ? 2 : 0.5;
  const double largest = part * change.head(compared).maxCoeff();
  Results error = Results::Constant(std::max(largest, error_of_kinks(level)));
  const double hottest = error_of_temperature_at_kinks(level, change(max_temperature));
  error(max_temperature) = std::max(error(max_temperature), hottest);
  return error;
}

/// By the change since the grid before, the share of heat, the coefficients on both grids, and the
/// speed of the slip zone.
Results estimate_with_law(const Results& change, const Results& share, const VectorXd& before,
                          const VectorXd& now, double lambda) {
  const auto n = static_cast<int>(now.size());
  const double of_integrals = n < 30 ? 7 + 8 * decades_beyond(lambda) : 10;
  const double of_tail = unresolved(tail(now), n, false, of_integrals, 1e3);
  const Results of_change = part_with_law(before, now) * change;
  const double largest = of_change.head(compared).maxCoeff();
  Results error = of_change.max(share * std::max(of_tail, largest)) + 2e-15 * n;
  error(max_temperature) += error_of_one_temperature(n);
  return error;
}

/// Of an h of ten coefficients and Carter's.
int unknowns_for_heat(const VectorXd& h, const VectorXd& cold, int digits) {
  const double last = (h - cold).tail(2).lpNorm<Eigen::Infinity>() / h.lpNorm<Eigen::Infinity>();
  const double n = 16 + 6 * (std::log10(last) + digits);
  return n > 25 ? 30 : static_cast<int>(std::max(n, 20.0));
}

/// By a grid of n unknowns, or of as many as tell it from the given creep; infinite if none does.
double creep_of_full_slip(const Scene& scene, Formulation formulation, int n, double given) {
  const auto limit = [&](int unknowns) {
    return creep_next_to_full_slip(scene, formulation, unknowns);
  };
  const double coarse = limit(n);
  if (n >= 160 || std::abs(given - coarse) >= 0.1 * coarse) return coarse;
  const double fine = limit(std::min(2 * n, 160)), left = std::abs(given - fine);
  return left > std::max(4 * std::abs(fine - coarse), 1e-4 * fine) ? fine : limit(160);
}

/// That creep, if it is before the prescribed one.
std::optional<double> full_slip_before(const Scene& scene, Formulation formulation, int n,
                                       const Prescribed& given) {
  if (given.quantity != creep) return {};
  const double from = creep_of_full_slip(scene, formulation, std::max(40, n), given.value);
  return given.value >= from ? std::optional(from) : std::nullopt;
}

/// The creep at which full slip begins, if the whole contact slips at the prescribed one.
std::optional<double> full_slip_at(const Scene& scene, Formulation formulation, int n,
                                   const Prescribed& given) {
  const auto from = full_slip_before(scene, formulation, n, given);
  if (!from || scene.bulk_difference == 0 || given.value > 1.1 * *from) return from;
  SlippingGrids grids{scene, formulation};
  const GridSolution x = solve_slipping_grid(grids, 80, given.value, {});
  return should_stick_at_edge(scene, x) ? std::nullopt : from;
}

/// The end of a message; nothing unless a creep is given, and one with a contact is known.
std::string known_limit(const Scene& scene, Formulation formulation, const Prescribed& given) {
  const double known = given.quantity == creep ? creep_of_some_stick(scene, formulation) : 0;
  if (!(known > 0) || given.value < known) return "";
  if (scene.direction == Direction::driving)
    return "; the creep_limit is at least " + rounded_down(known, 4);
  return "; the creep_limit is at most " + rounded_up(-known, 4);
}

GridSolution slipping_from(double begin) {
  GridSolution level;
  level.value(creep) = begin;
  return level;
}

/// After the last search for it. No newton_steps, and the creep at which full slip begins, if that
/// is before the prescribed one; else throws std::runtime_error.
GridSolution without_border(const Scene& scene, Formulation formulation, const Prescribed& given,
                            const GridSolution& tried) {
  if (scene.bulk_difference != 0)
    if (const auto from = full_slip_before(scene, formulation, 80, given))
      return slipping_from(*from);
  if (std::min(tried.at.slip, tried.at.stick) < 1e-13)
    throw std::runtime_error(
        "coupled: the search for the border ends within 1e-13 of an end of the contact");
  throw std::runtime_error("coupled: no solution found near the border " + shortest(tried.at.c0()) +
                           without_friction(scene) + known_limit(scene, formulation, given));
}

/// The solution on the first grid that has a contact, or else on the finest that has a border; the
/// derivative of all quantities with respect to the prescribed one goes to slope. No newton_steps,
/// and the creep at which full slip begins, if the whole contact slips at the prescribed creep;
/// throws std::runtime_error if there is no border.
GridSolution coarse_solution(const Scene& scene, Formulation formulation, int digits,
                             const Prescribed& given, Results& slope) {
  const bool easy = digits < 4 && scene.friction * heating_of_both(scene) < 0.3;
  const Carter cold = nearest_carter(scene, given);
  slope = carter_slope(cold, given.quantity);
  GridSolution level, tried;
  level.at = {2 * cold.slip_half_width, 2 * cold.b};
  level.at.variable.beta = crowding(scene, formulation, level.at);
  const bool crosses = scene.bulk_difference != 0 || exchanges(scene, level.at);
  const int cautious = crosses && digits > 4 ? 16 : 10;
  const int first = scene.law ? 12 : easy ? 6 : cautious, last = scene.law ? 96 : 80;
  const double weak = scene.law || crosses ? 0 : std::min(0.03, 2 * std::pow(10, -0.5 * digits));
  for (int n = first; n <= last && (level.newton_steps == 0 || !level.violations.empty()); n *= 2) {
    Results better = slope;
    tried = find_border(scene, formulation, n, given, level, better, weak);
    if (tried.newton_steps > 0) {
      level = tried;
      slope = better;
    } else if (const auto from = full_slip_at(scene, formulation, n, given)) {
      return slipping_from(*from);
    }
  }
  if (level.newton_steps == 0) return without_border(scene, formulation, given, tried);
  if (scene.bulk_difference != 0 && given.quantity != stick_slip_border) {
    const auto n = static_cast<int>(level.h.size());
    const double step = 1e-3 * std::min(level.at.slip, level.at.stick);
    const Results change =
        solve_on_grid(scene, formulation, n, moved_by(level.at, step), level).value - level.value;
    slope = change / change(given.quantity);
  }
  return level;
}

/// A step of the border, or as much of it as leaves a hundredth of each zone; none in full slip.
double within_contact(double step, const ZoneLengths& at) {
  if (at.stick == 0) return 0;
  return std::clamp(step, -0.99 * at.stick, 0.99 * at.slip);
}

Results carried_over(const GridSolution& level, const Prescribed& given, const Results& slope) {
  const double left = residual(level, given), step = slope(stick_slip_border) * left;
  Results met = level.value + slope * left;
  if (const double inside = within_contact(step, level.at); inside != step) {
    met(stick_slip_border) = level.at.c0() + inside;
    met(slip_length) = level.at.slip - inside;
  }
  met(given.quantity) = given.value;
  return met;
}

/// The values of a solution so far, corrected for the prescribed quantity, the change since the
/// previous grid and the estimated errors, both relative.
struct Refinement {
  Results value, change = Results::Zero(), error = Results::Ones();
  double worst() const { return error.head(compared).maxCoeff(); }
};

/// On a grid of n unknowns.
double part_with_crossing_heat(const Scene& scene, int n, bool slow) {
  const double resolved = n >= 48 ? std::pow(n, 4) / (1000 * faster(scene)) : 0;
  const double times = is_uneven(scene) ? 8 : 1;
  const bool bulk = scene.bulk_difference != 0;
  if (resolved < 1) return bulk ? 8 : 2 * times;
  if (bulk && slow) return 1;
  return (resolved < 10 ? 0.5 : 0.25) * times;
}

/// The unknowns of the first grid whose error can be told, after a coarse one.
int least_unknowns(const Scene& scene, int digits, const GridSolution& coarse) {
  if (scene.bulk_difference != 0) return edge_unknowns(scene);
  const int by_digits = (scene.law ? 4 : 5) * std::clamp(digits, 2, 6);
  if (coarse.crossing || is_uneven(scene)) return std::max(by_digits, 15);
  const bool plain = !scene.law && !is_unlike(scene) && coarse.at.variable.beta == 0;
  if (!plain || coarse.h.size() != 10) return by_digits;
  const VectorXd cold = carter_h(coarse.at, scene.friction);
  return std::min(by_digits, unknowns_for_heat(coarse.h, cold, digits));
}

/// Relative errors that the correction of a solution for the prescribed quantity leaves.
Results error_of_correction(const Results& value, const Results& slope, const Results& corrected,
                            const ZoneLengths& at) {
  Results error = 0.03 * corrected;
  if (slope(load_ratio) != 0) return error;
  const double most = std::max(std::abs(value(load_ratio) - 1), std::abs(value(gamma0)));
  error(load_ratio) = error(gamma0) = 2 * most * corrected(stick_slip_border) / at.slip;
  return error;
}

double remembered(const Convergence& at, bool layered, bool crossing, bool uneven) {
  const double coarser = static_cast<double>(at.before) / at.n;
  if (layered && !crossing) return coarser * coarser;
  if (crossing && uneven) return 0.02;
  return at.n > 200 || (crossing && !at.slow) ? 0.004 : 0.01;
}

Refinement refined(const Scene& scene, const Refinement& before, const GridSolution& level,
                   const GridSolution& last, const Prescribed& given, const Results& slope) {
  const Results scale = scale_in(scene, level.value), value = carried_over(level, given, slope);
  const Results corrected = (value - level.value).abs() / scale;
  const bool slow = converges_slowly(scene, level);
  const auto n = static_cast<int>(level.h.size());
  const double now = tail(level.h), then = tail(last.h);
  const bool flat = now > std::max(1e-6, 0.05 * then);
  const bool layered = scene.law && level.kinks.empty() && decays_slowly(last.h, level.h);
  const Convergence grids = convergence(last, level, slow);
  const double part = remembered(grids, layered, level.crossing.has_value(), is_uneven(scene));
  const Results change = ((value - before.value).abs() / scale).max(part * before.change);
  const double largest = change.head(compared).maxCoeff();
  const Results share = share_in_effects(scene, level, given, value);
  const Results small =
      error_of_rules(scene, n) + error_of_correction(value, slope, corrected, level.at);
  Results left = estimate(change, share, now, then, grids) + small;
  if (slow && is_unlike(scene) && n <= 200) left = left.max(change);
  if (scene.law && !slow && !level.crossing)
    left = estimate_with_law(change, share, last.h, level.h, level.at.slip * faster(scene)) + small;
  if (level.crossing && !layered) {
    const double flat_tail = slow && scene.bulk_difference != 0 && n <= 200 ? 2 : 0.2;
    const bool of_edges = flat && !is_of_flux(scene, n, now);
    const double tails = of_edges ? flat_tail * now / (n * n) : left.head(compared).maxCoeff();
    const Results whole = change.max(corrected).max(0.3 * largest * share);
    left = (part_with_crossing_heat(scene, n, slow) * whole).max(tails * share) + 2e-15 * n;
    const bool coarse_and_flat = flat && n <= 200;
    double of_layer = layer_of_coarse_grid(scene, level, coarse_and_flat ? now : 0);
    if (slow && n < 48) of_layer = std::max(of_layer, now / 20);
    if (coarse_and_flat && n > 96 && now > then / 2)
      of_layer = std::max(of_layer, 2 * change(max_temperature));
    left(max_temperature) = std::max(left(max_temperature), of_layer);
  }
  if (layered) left.setConstant(std::max(2 * largest, n < 24 ? 40 * now * now : 0));
  if (!level.kinks.empty()) left = left.max(estimate_with_kinks(level, change));
  const double of_rounding = rounding(given, slope, scale);
  left += errors_near_leading_edge(scene, level, given, share, scale, corrected - of_rounding);
  left += (error_of_bulk(scene, level, given, slope) + law_error(scene, n, given, slope)) / scale;
  return {value, change, left + of_rounding + rounding_of_pair(scene)};
}

double error_of_amplitude(double now, double before, double part) {
  return 2 * std::max(std::abs(now - before), part * std::abs(now));
}

void add_errors_of_crossing(const Scene& scene, const GridSolution& last, const Refinement& found,
                            GridSolution& level) {
  CrossingHeat& now = *level.crossing;
  const double moved = std::abs(found.value(stick_slip_border) - level.at.c0());
  const double part = 4 * found.worst() + 3 * moved / level.at.slip;
  const auto bulk = bulk_exchange(scene, level.h.size());
  const double size = std::abs(scene.bulk_difference);
  const double of_bulk = bulk ? size * std::abs(bulk->heat) : 0;
  const double least = part * std::max(std::abs(now.heat), of_bulk);
  now.heat_error = std::max(std::abs(now.heat - last.crossing->heat), least);
  now.edge_error = error_of_amplitude(now.edge, last.crossing->edge, part);
  if (!bulk) return;
  const double of_tail = tail(bulk->flux);
  now.heat_error += of_tail / 100 * of_bulk;
  now.edge_error += size * (of_tail + 2e-9) * std::abs(bulk->edge);
}

GridSolution at_predicted_border(const Scene& scene, Formulation formulation, int n,
                                 const Prescribed& given, GridSolution level, bool is_coarse,
                                 Results& slope) {
  for (int k = 0; k < 5; ++k) {
    const GridSolution last = level;
    const double step = within_contact(slope(stick_slip_border) * residual(last, given), last.at);
    ZoneLengths at = moved_by(last.at, step);
    at.variable = variable_after(last, n);
    level = solve_on_grid(scene, formulation, n, at, last);
    if (level.newton_steps == 0) break;
    const double moved = level.value(given.quantity) - last.value(given.quantity);
    if (k > 0 && moved != 0) slope = (level.value - last.value) / moved;
    const double missing = residual(level, given);
    const Results left = slope * missing / scale_in(scene, level.value);
    const double most = left.head(compared).abs().maxCoeff();
    const double part = missing / residual(last, given);  // that the move has left
    const bool moves = (k == 0 && is_coarse) || !(0.5 < part && part < 2) || most < 1e-9;
    const double room = std::min(level.at.stick, level.at.slip);
    const bool leaps = std::abs(missing) > 1e-13 * std::abs(given.value) &&
                       std::abs(slope(stick_slip_border) * missing) > 0.02 * room;
    if (most < (n > 64 ? 1e-4 : 0.01) && moves && !leaps) break;
  }
  return level;
}

struct LastStick {
  double length, error;  // length < 0 where all slips
  double creep_by_length;
};

LastStick last_stick(const Scene& scene, Formulation formulation, double given) {
  const GridSolution coarse = next_to_full_slip(scene, formulation, 80);
  const GridSolution one = next_to_full_slip(scene, formulation, 160);
  const double length = one.at.stick;
  const auto slope = [&](double step) {
    const ZoneLengths at = moved_by(one.at, step);
    const GridSolution other = solve_on_grid(scene, formulation, 160, at, one);
    return (other.value(creep) - one.value(creep)) / step;
  };
  const double here = slope(-0.5 * length), past = given - one.value(creep);
  const double of_grid = std::abs(one.value(creep) - coarse.value(creep)) / 4;
  const double bend = std::abs(slope(length) / here - 1);
  const double error = of_grid + 1e-14 * given + bend * std::abs(past);
  return {length + past / here, error / std::abs(here), here};
}

/// To the tolerance of the approach; asked is told by a refusal.
CoupledSolution solve_for_stick(const Scene& scene, const Approach& approach, double length,
                                double asked) {
  try {
    return solve_coupled(scene, approach, {stick_slip_border, length - 1});
  } catch (const NotResolved& failure) {
    throw NotResolved("coupled: the last of the stick zone is not resolved to " + shortest(asked),
                      failure.trace);
  }
}

/// The solution with a stick zone of about this length, which is corrected and has its error anew.
CoupledSolution with_last_stick(const Scene& scene, const Approach& approach, double given,
                                LastStick& left) {
  const Approach finer{approach.formulation, std::max(1e-11, approach.tolerance / 10)};
  for (int k = 0;; ++k) {
    CoupledSolution x = solve_for_stick(scene, finer, left.length, approach.tolerance);
    const double miss = given - x.value(creep), missed = miss / left.creep_by_length;
    left.error = std::abs(missed) + x.error(creep) / std::abs(left.creep_by_length);
    const bool met = left.error <= approach.tolerance && std::abs(miss) <= x.error(creep);
    if (met || k == 3 || !(left.length + missed > 0)) return x;
    left.length += missed;
  }
}

void give_creep(CoupledSolution& x, double given) {
  const double miss = given - x.value(creep), size = std::abs(miss);
  x.value(creep_constant) += miss;
  for (const Quantity q : {creep_constant, heat_integral}) x.error(q) += size;
  x.error(max_temperature) += size * std::abs(x.value(max_temperature) / x.value(heat_integral));
  x.value(creep) = given;
  x.error(creep) = 0;
}

CoupledSolution solve_with_little_stick(const Scene& scene, const Approach& approach,
                                        double given) {
  LastStick left = last_stick(scene, approach.formulation, given);
  const bool all_slips = left.length <= 0 || left.length + left.error <= approach.tolerance;
  CoupledSolution x = all_slips ? solve_full_slip(scene, approach, given)
                                : with_last_stick(scene, approach, given, left);
  const double error = std::max(0.0, all_slips ? left.length + left.error : left.error);
  if (!(error <= approach.tolerance))
    throw NotResolved("coupled: not resolved to " + shortest(approach.tolerance) + at_best(error),
                      x.trace);
  x.error(stick_slip_border) = x.error(slip_length) = error;
  give_creep(x, given);
  return x;
}

double error_of_hottest(const Scene& scene, const GridSolution& level, double estimate,
                        double tolerance) {
  const bool by_tail = scene.law || level.at.variable.beta > 0 || converges_slowly(scene, level);
  return std::max(estimate, by_tail ? std::min(tail(level.h), 0.9 * tolerance) : 0);
}

CoupledSolution solution_of(const Scene& scene, const Approach& approach, const GridSolution& level,
                            const Refinement& found, const std::vector<GridStep>& trace) {
  Results error = found.error;
  error(max_temperature) =
      error_of_hottest(scene, level, error(max_temperature), approach.tolerance);
  const double bend = scene.bulk_difference != 0 ? std::abs(level.peak.curvature) : 1;
  const double of_place = std::min(1.0, std::sqrt(error(max_temperature) / std::min(1.0, bend)));
  error *= scale_in(scene, level.value);
  const auto n = static_cast<int>(level.h.size());
  CoupledSolution x{scene,   approach.formulation, found.value, error, n, level.newton_steps,
                    level.h, level.violations,     trace};
  x.variable = level.at.variable;
  const bool where_it_sticks = found.value(max_temperature_at) < level.at.c0();
  x.error(max_temperature_at) = where_it_sticks ? level.at.stick : level.at.slip * of_place;
  if (level.at.stick == 0) x.error(stick_slip_border) = x.error(slip_length) = 0;
  if (level.at.stick == 0 && !scene.law) x.error(traction) = 0;
  add_eccentricity(x.value, x.error);
  x.crossing = level.crossing;
  return x;
}

GridStep step_of(const GridSolution& level) {
  GridStep step{static_cast<int>(level.h.size()), level.at.c0(), level.newton_steps, {}, {}, {}};
  if (level.newton_steps > 0) step.tail = tail(level.h);
  return step;
}

/// The grid of n unknowns at the border of a solution, or in full slip.
ContactGrid grid_of(const CoupledSolution& x, int n) {
  if (x.value(Quantity::stick_slip_border) == -1)
    return at_creep(full_slip_grid(x.scene, x.formulation, n, x.variable),
                    x.value(Quantity::creep));
  return contact_grid(
      x.scene, x.formulation,
      {x.value(Quantity::slip_length), 1 + x.value(Quantity::stick_slip_border), x.variable}, n);
}

}  // namespace

void check(Quantity q) {
  require(q == traction || q == creep || q == stick_slip_border, "given quantity",
          static_cast<int>(q), "traction, creep or border");
}

void check(double friction, const Prescribed& given) {
  const std::string below = "above 0 and below the friction";
  const double x = given.value;
  const Quantity q = given.quantity;
  require(friction > 0, "friction", friction, "positive");
  check(q);
  if (q == traction) require(x > 0, "traction", x, below);
  if (q == traction) require(x < friction, "traction", x, below + ", " + shortest(friction));
  if (q == creep) require(x > 0, "creep", x, "positive");
  if (q == stick_slip_border)  // a stick zone may not be lost in rounding
    require(x < 1 && (1 - x) / 2 < 1, "stick-slip-border", x, "between -1 and 1");
}

void check(const Scene& scene, const Prescribed& given) {
  check(scene);
  const Prescribed more = beyond_no_slip(scene, given);
  const bool any = scene.law && given.quantity == traction;  // friction may rise
  if (std::isfinite(given.value) && more.value != given.value) {
    const std::string beyond = "beyond that of a contact without slip";
    const double asked = sign_of(scene.direction) * given.value;
    if (given.quantity == traction)
      require(more.value > 0 && (any || more.value < scene.friction), "traction", asked,
              beyond + (any ? "" : ", and below the friction"));
    else
      require(more.value > 0, "creep", asked, beyond);
  }
  if (any) require(more.value > 0, "traction", given.value, "positive");
  if (!any) check(scene.friction, more);
}

Carter carter_given(double friction, const Prescribed& given, Direction direction) {
  check(friction, given);
  if (given.quantity == traction) return carter(friction, given.value);
  const bool by_border = given.quantity == stick_slip_border;
  const double half = by_border ? (1 - given.value) / 2 : pi * given.value / (2 * friction);
  const double sign = sign_of(direction);
  require(half < 1, "creep", sign * given.value,
          (sign > 0 ? "below 2 f / pi" : "above -2 f / pi") +
              std::string(" for this method: the whole contact slips from there on"));
  const double b = by_border ? (1 + given.value) / 2 : 1 - half;
  return {friction, b, half, b - half, 2 * friction / pi * half};
}

Results carter_values(const Carter& c) {
  const double q = c.friction * c.slip_half_width * (1 + c.b);
  Results values;
  values << c.c0, 2 * c.slip_half_width, q, c.creep, c.creep, 1, 0, carter_heat(c), 0, 0, 0;
  return values;
}

Results carter_slope(const Carter& c, Quantity by) {
  const double step = 1e-3 * std::min(c.b, c.slip_half_width), half = c.slip_half_width - step;
  const Carter moved{c.friction, c.b + step, half, c.c0 + 2 * step, 2 * c.friction / pi * half};
  Results change = carter_values(moved) - carter_values(c);
  if (c.b < 1e-6) change(traction) = -c.friction * step * (2 * c.b + step);
  return change / change(by);
}

Results scale_in(const Scene& scene, const Results& value) {
  Results scale = scale_of(value);
  const double bulk = std::abs(scene.bulk_difference);
  const double strain = scene.friction * heating_of_both(scene) * std::sqrt(scene.peclet / pi);
  for (const Quantity q : {creep_constant, creep}) scale(q) += strain * bulk;
  scale(max_temperature) += bulk;
  return scale;
}

CoupledSolution refine(const Scene& scene, const Approach& approach, const Prescribed& given,
                       GridSolution level, Results& slope, const NextGrid& next) {
  const double tolerance = approach.tolerance;
  const int digits = static_cast<int>(std::ceil(-std::log10(tolerance)));
  Refinement found{carried_over(level, given, slope)};
  double reached = std::numeric_limits<double>::infinity();
  std::vector<GridStep> trace{step_of(level)};
  int n = std::clamp(3 * static_cast<int>(level.h.size()) / 2, least_unknowns(scene, digits, level),
                     most_unknowns);
  for (int stalled = 0; stalled < 2;) {
    const GridSolution last = level;
    const double best = found.worst();
    level = next(n, last);
    trace.push_back(step_of(level));
    if (level.newton_steps > 0) found = refined(scene, found, level, last, given, slope);
    const double worst = found.worst();
    if (level.newton_steps > 0) {
      trace.back().change = found.change.head(compared).maxCoeff();
      trace.back().estimate = worst;
      if (level.crossing && last.crossing) add_errors_of_crossing(scene, last, found, level);
      const auto agreed = agreed_violations(last.violations, level.violations);
      if (agreed) reached = std::min(reached, worst);
      if (agreed && worst <= tolerance) {
        level.violations = *agreed;
        return solution_of(scene, approach, level, found, trace);
      }
      stalled = n > 64 && worst > 0.5 * best && worst > 100 * tolerance ? stalled + 1 : 0;
    } else {
      level = last;
    }
    if (n == most_unknowns) break;
    n = scene.law ? unknowns_after(n, scene.bulk_difference != 0)
                  : next_unknowns(scene, n, last, level, worst / tolerance);
  }
  const bool only_verdict = found.worst() <= tolerance;
  throw NotResolved((only_verdict ? "coupled: whether it is a contact is not resolved"
                                  : "coupled: not resolved to " + shortest(tolerance)) +
                        " with " + std::to_string(n) + " unknowns" + at_best(reached),
                    trace);
}

std::string at_best(double error) {
  if (!(error < 1)) return "";
  const double unit = std::pow(10, std::floor(std::log10(error)));
  return ", at best to " + rounded(unit * std::ceil(error / unit), 1);
}

CoupledSolution solve_coupled(const Scene& scene, const Approach& approach,
                              const Prescribed& given) {
  const Formulation formulation = approach.formulation;
  const double tolerance = approach.tolerance;
  check(scene, given);
  require(tolerance >= 1e-11, "tolerance", tolerance, "at least 1e-11");
  if (scene.law && given.quantity == traction)
    return solve_on_branch(scene, approach, given.value, given.branch);
  const int digits = static_cast<int>(std::ceil(-std::log10(tolerance)));
  Results slope;
  const GridSolution level = coarse_solution(scene, formulation, digits, given, slope);
  std::optional<double> full_slip;  // the creep at which it begins, if before the prescribed one
  if (level.newton_steps == 0) full_slip = level.value(creep);
  if (level.at.stick < 0.05 && !full_slip) full_slip = full_slip_at(scene, formulation, 40, given);
  if (!full_slip) {
    struct AllSlips : std::exception {};
    try {
      return refine(scene, approach, given, level, slope, [&](int n, const auto& last) {
        const bool is_coarse = last.h.size() == level.h.size();
        GridSolution next =
            at_predicted_border(scene, formulation, n, given, last, is_coarse, slope);
        const bool at_the_edge = n >= 60 && next.at.stick < 1e-3;
        if (at_the_edge) full_slip = full_slip_at(scene, formulation, 160, given);
        if (full_slip) throw AllSlips{};
        return next;
      });
    } catch (const AllSlips&) {
    }
  }
  if (given.value < *full_slip + 1e-6 * scene.friction)
    return solve_with_little_stick(scene, approach, given.value);
  return solve_full_slip(scene, approach, given.value);
}

void add_eccentricity(Results& value, Results& error) {
  const double kappa = value(load_ratio), size = std::abs(kappa);
  value(eccentricity) = pi * value(gamma0) / (2 * kappa);
  const double of_load = std::abs(value(gamma0)) / size * error(load_ratio);
  error(eccentricity) = pi / (2 * size) * (error(gamma0) + of_load);
}

double rounding(const Prescribed& given, const Results& slope, const Results& scale) {
  if (given.quantity == stick_slip_border) return 0;  // both lengths are exact
  return 1e-15 * (given.value * slope / scale).head(compared).abs().maxCoeff();
}

Results scale_of(const Results& v) {
  Results scale = Results::Ones();
  for (const Quantity q : {creep_constant, creep, heat_integral, max_temperature})
    scale(q) = std::max(std::abs(v(q)), 1e-300);  // T* is 0 where no heat is positive
  return scale;
}

void check_unknowns(int n) {
  require(2 <= n && n <= most_unknowns, "unknowns", n,
          "from 2 to " + std::to_string(most_unknowns));
}

FluxMap flux_map(const Scene& scene, Formulation formulation, int n, double c0) {
  check_unknowns(n);
  check(scene, {stick_slip_border, c0});
  const ContactGrid grid = contact_grid(scene, formulation, {1 - c0, 1 + c0}, n);
  const TractionOperators& x = grid.tractions;
  const MatrixXd to = to_legendre(grid.rules.slip);
  return {scene.friction, grid.nodes.s, 1 + grid.nodes.s, x.p * to, x.v * to, x.kappa * to};
}

HeatFlux coupled_flux(const CoupledSolution& x) {
  const double length = x.value(Quantity::slip_length);
  return {x.value(Quantity::stick_slip_border), 1,
          [h = x.h, slip = length, by = x.variable](double left, double right) {
            const double share = std::min({left, right, slip / 2}) / slip;
            const double eta = distance_of_share(share, left < right ? by : mirrored(by));
            const ArrayXd y = ArrayXd::Constant(1, left < right ? eta - 1 : 1 - eta);
            return std::sqrt(left * right) * (legendre(y, h.size()) * h)(0);
          }};
}

/// The part of it that is solved for on a grid.
std::vector<ExchangedFlux> crossing_flux(const ContactGrid& grid, const VectorXd& h) {
  std::vector<ExchangedFlux> all;
  if (grid.crossing) all.push_back(exchanged_flux(*grid.crossing, grid.nodes, h));
  if (grid.bulk) all.push_back({{2, 0}, grid.scene.bulk_difference * grid.bulk->flux, {}});
  return all;
}

std::vector<ExchangedFlux> crossing_flux(const CoupledSolution& x) {
  return crossing_flux(grid_of(x, x.unknowns), x.h);
}

std::vector<ExchangedFlux> exchanged_fluxes(const Scene& scene, Formulation formulation,
                                            const SmoothFlux& by, int nodes) {
  std::vector<ExchangedFlux> all;
  const ZoneLengths at = by.zones();
  const auto n = static_cast<int>(by.h.size());
  const GridRules rules(std::max(n, nodes), at);
  const Nodes z = place_nodes(at, rules.slip, rules.stick);
  if (is_unlike(scene))
    all.push_back(exchanged_flux(exchange(scene, formulation, z, rules, n), z, by.h));
  if (const auto bulk = bulk_exchange(scene, z.y.size()))
    all.push_back({{2, 0}, scene.bulk_difference * bulk->flux, {}});
  return all;
}

ArrayXd exchanged_heat_flux(const CoupledSolution& x, const ArrayXd& s) {
  const SmoothFlux by{x.value(slip_length), 1 + x.value(stick_slip_border), x.h, x.variable};
  ArrayXd flux = ArrayXd::Zero(s.size());
  for (const ExchangedFlux& e : exchanged_fluxes(x.scene, x.formulation, by, 60))
    flux += flux_at(e, s);
  return flux;
}

CrossingFlux flux_for_depths(const Scene& scene, Formulation formulation, const SmoothFlux& by) {
  const ArrayXd s = ArrayXd::LinSpaced(40, -1, 1);
  const auto solved_with = [&](int nodes, ArrayXd& temperature) {
    auto all = exchanged_fluxes(scene, formulation, by, nodes);
    for (const ExchangedFlux& e : all) temperature += temperature_of(e, scene.peclet, s);
    return all;
  };
  ArrayXd coarse = ArrayXd::Zero(s.size()), fine = coarse;
  const int n = std::max(60, static_cast<int>(by.h.size()));
  const bool finer = 3 * most_unknowns >= 4 * n;
  solved_with(finer ? n : 3 * n / 4, coarse);
  CrossingFlux crossing;
  for (const ExchangedFlux& e : solved_with(finer ? 4 * n / 3 : n, fine))
    for (const HeatFlux& zone : heat_fluxes(e)) crossing.zones.push_back(zone);
  crossing.error = (fine - coarse).abs().maxCoeff();
  return crossing;
}

Profile profile(const CoupledSolution& x) {
  const ContactGrid grid = grid_of(x, x.unknowns);
  const Nodes& z = grid.nodes;
  const Index n = z.y.size(), m = z.d.size();
  const Factors at = factors(grid, x.h);
  ArrayXd right(m + n);  // 1 - s
  right << z.zones.slip + z.d.reverse(), z.zones.slip * (1 - z.t);
  Profile profile{at.s, (right * (1 + at.s)).sqrt() * at.pressure, {}, {}, {}, {}};
  profile.traction = x.scene.friction * profile.pressure;
  if (at.phi.size() > 0) profile.traction *= at.phi;
  profile.traction.head(m) -= ((2 - right.head(m)) * z.d.reverse()).sqrt() * at.slip.head(m);
  const double slip = z.zones.slip;
  profile.temperature = profile.heat_flux = profile.slip = ArrayXd::Zero(m + n);
  profile.heat_flux.tail(n) = slip * (z.t * (1 - z.t)).sqrt() * (grid.rules.slip.p * x.h).array();
  profile.slip.tail(n) = profile.heat_flux.tail(n) / profile.pressure.tail(n);
  if (at.phi.size() > 0) profile.slip.tail(n) /= at.phi.tail(n);
  const Conduction conduction(x.scene, !grid.crossing);
  const VectorXd h = smooth_flux(x).h;
  for (Index i = 0; i < m + n; ++i) {
    const bool slips = i >= m;
    const double left = slips ? 1 + z.y(i - m) : 0, gap = slips ? 0 : z.d(m - 1 - i) / slip;
    profile.temperature(i) =
        temperature_and_slope(z.zones, conduction, h, left, 2 - left, gap, grid.rules.fine).value;
  }
  profile.temperature *= heat_share(x.scene);
  for (const ExchangedFlux& e : crossing_flux(grid, x.h))
    profile.temperature += temperature_of(e, x.scene.peclet, at.s, grid.rules.fine);
  return profile;
}

SmoothTractions smooth_tractions(const CoupledSolution& x, int n) {
  check_unknowns(n);
  const ContactGrid grid = grid_of(x, n);
  VectorXd h = VectorXd::Zero(n);
  const Index known = std::min(h.size(), x.h.size());
  h.head(known) = x.h.head(known);
  if (n != x.unknowns) newton(grid, 1, h);
  const Factors found = factors(grid, h);
  const Index m = grid.nodes.d.size();
  const VectorXd stick_pressure = found.pressure.head(m).reverse();
  const VectorXd bracket = found.slip.head(m).reverse();
  const MatrixXd to_stick = to_legendre(grid.rules.stick);
  const ZoneLengths& at = grid.nodes.zones;
  SmoothTractions y{at.slip, at.stick, h, {}, to_stick * stick_pressure, to_stick * bracket};
  y.layer = grid.rules.layer;
  y.variable = at.variable;
  const MatrixXd to_slip = to_legendre(grid.rules.slip);
  y.pressure = to_slip * found.pressure.tail(n).matrix();
  if (!grid.hot) return y;
  const ArrayXd bound = found.phi * found.pressure;
  y.bound = to_slip * bound.tail(n).matrix();
  y.stick_bound = to_stick * bound.head(m).reverse().matrix();
  return y;
}

}  // namespace thermoroll
