// Tangled from paper/13-where-methods-fail.md, paper/14-least-model.md, paper/B-data-files.md; edit there.
#include "studies/figure_data.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <iomanip>
#include <random>
#include <stdexcept>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "solver/least_model.hpp"
#include "studies/asymptotics.hpp"
#include "studies/cached_scheme.hpp"
#include "studies/claims.hpp"
#include "studies/comparison.hpp"
#include "studies/iterations.hpp"
#include "studies/naive_kernels.hpp"
#include "studies/paper_case.hpp"
#include "studies/resolution.hpp"
#include "support/number_text.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {
namespace {

/// Write the cells of one row, separated by commas.
template <class First, class... Rest>
void row(std::ostream& out, const First& first, const Rest&... rest) {
  out << first;
  ((out << ',' << rest), ...);
  out << '\n';
}

/// n + 1 equidistant points from low to high.
std::vector<double> grid(double low, double high, int n) {
  std::vector<double> points;
  for (int i = 0; i <= n; ++i) points.push_back(((n - i) * low + i * high) / n);
  return points;
}

void geometry(std::ostream& out) {
  row(out, "part", "x", "y");
  const double radius = 2, axle = std::sqrt(radius * radius - 1), edge = std::asin(1 / radius);
  for (const double angle : grid(edge, 2 * pi - edge, 180))
    row(out, "cylinder", radius * std::sin(angle), axle - radius * std::cos(angle));
  const double c0 = paper::closed_form(0.5).c0;
  for (const double x : {-4.4, 4.4}) row(out, "half_space", x, 0);
  for (const double x : {-1.0, c0}) row(out, "stick", x, 0);
  for (const double x : {c0, 1.0}) row(out, "slip", x, 0);
}

void kernels(std::ostream& out) {
  row(out, "zeta", "N1", "N2", "M");
  for (const double zeta : grid(-6, 6, 600))
    if (zeta != 0) row(out, zeta, kernel::N1(zeta), kernel::N2(zeta), kernel::M(zeta));
}

void errors(std::ostream& out, const Regime& regime) {
  row(out, "method", "setting", "name", "quantity", "error");
  const Found exact = reference(regime);
  for (const Run& run : runs(regime)) {
    const Found found = run.find();
    const auto compare = [&](const char* quantity, double value, double wanted) {
      const double error = std::max(std::abs(value / wanted - 1), 1e-11);
      if (!std::isnan(value)) row(out, run.method, run.setting, run.name, quantity, error);
    };
    compare("load", found.load_ratio - 1, exact.load_ratio - 1);
    compare("temperature", found.hottest, exact.hottest);
    compare("creep", found.creep, exact.creep);
  }
}

void cost(std::ostream& out) {
  row(out, "tolerance", "heating", "peclet", "name", "unknowns");
  for (const auto& [scene, run] : cost_runs())
    if (const Found found = run.find(); found.unknowns > 0)
      row(out, run.setting, scene.heating, scene.peclet, run.name, found.unknowns);
}

void share_found(std::ostream& out) {
  row(out, "peclet", "n", "load", "temperature");
  for (const double pe : {100.0, paper::peclet}) {
    const CoupledSolution exact = paper::coupled(0.5, pe);
    for (const int n : {25, 35, 50, 70, 100, 140, 200, 280, 400, 560, 800}) {
      const Scene scene = paper::scene(pe);
      const auto x = solve_cached(scene, 0.5, paper::formulation, NodeKernel::sample, {n});
      const double top = cached_max_temperature(x, pe, NodeKernel::sample).temperature;
      row(out, pe, n, (1 - x.load_ratio) / (1 - exact.value(load_ratio)),
          top / exact.value(hottest));
    }
  }
}

void celsius_of_speed(std::ostream& out) {
  row(out, "kind", "speed", "celsius");
  for (const double pe : grid(1000, 17000, 32))
    row(out, "converged", speed_at(pe),
        celsius_per_unit_at(pe) * paper::coupled(0.5, pe).value(hottest));
  for (const double u : grid(0, 1, 44)) row(out, "law", 88 * u * u, 272 * std::sqrt(88.0 / 25) * u);
  for (const double pe : {5000.0, 10000.0, 15000.0})
    row(out, "scheme", speed_at(pe), celsius_per_unit_at(pe) * paper::scheme_max(0.5, pe));
  for (const auto& [speed, celsius] : {std::pair{25, 272}, {50, 420}, {75, 490}})
    row(out, "paper", speed, celsius);
}

void tractions_of_load(std::ostream& out) {
  row(out, "method", "traction", "s", "q");
  for (const double load : paper::tractions) {
    const Carter c = paper::closed_form(load);
    for (const double s : grid(-1, 1, 400)) row(out, "converged", load, s, carter_traction(c, s));
  }
  for (const double load : paper::tractions) {
    const PublishedSolution x = paper::scheme(load, paper::peclet);
    for (const double s : x.grid.t)
      row(out, "printed", load, s, published_traction(x, paper::friction, s));
  }
}

void slip_of_load(std::ostream& out) {
  row(out, "method", "traction", "s", "v");
  for (const double load : paper::tractions) {
    const Carter c = paper::closed_form(load);
    row(out, "converged", load, -1, 0);
    for (const double u : grid(0, 1, 200)) {  // v starts like a square root: crowd the points there
      const double s = c.c0 + (1 - c.c0) * u * u;
      row(out, "converged", load, s, carter_slip(c, s));
    }
  }
  for (const double load : paper::tractions) {
    const PublishedSolution x = paper::scheme(load, paper::peclet);
    for (int k = 0; k < x.slip.size(); ++k) row(out, "printed", load, x.grid.t(k), x.slip(k));
  }
}

void creep_curve(std::ostream& out) {
  row(out, "method", "creep", "traction");
  for (const double xi : grid(0, 2 * paper::friction / pi, 100))
    row(out, "converged", xi, carter_creep_curve(paper::friction, xi));
  for (const double load : grid(0.05, 0.59, 9))
    row(out, "printed", paper::scheme(load, paper::peclet).creep, load);
}

void temperature_curve(std::ostream& out, double key, double load, double pe) {
  const HeatFlux flux = carter_flux(paper::closed_form(load));
  for (const double s : grid(-1, 3, 400))
    row(out, "converged", key, s, temperature(flux, pe, s).value);
  const PublishedSolution x = paper::scheme(load, pe);
  std::vector<double> points(x.grid.s.begin(), x.grid.s.end());
  std::reverse(points.begin(), points.end());
  for (const double s : grid(1.1, 3, 19)) points.push_back(s);
  for (const double s : points) row(out, "printed", key, s, published_temperature(x, pe, s));
}

void temperature_by_peclet(std::ostream& out, double load) {
  row(out, "method", "peclet", "s", "T");
  for (const double pe : paper::peclets) temperature_curve(out, pe, load, pe);
}

void temperature_by_load(std::ostream& out) {
  row(out, "method", "traction", "s", "T");
  for (const double load : paper::tractions) temperature_curve(out, load, load, 1000);
}

void subsurface(std::ostream& out) {
  row(out, "s", "y", "T");
  const HeatFlux flux = carter_flux(paper::closed_form(0.5));
  for (const double y : grid(0, 0.5, 40))
    for (const double s : grid(-1.5, 3, 180)) row(out, s, y, temperature(flux, 100, s, y).value);
}

void sliding(std::ostream& out) {
  row(out, "kind", "traction", "s", "T");
  for (const double load : {0.2, 0.5}) {
    const Carter c = paper::closed_form(load);
    for (const double s : grid(-1, 3, 400))
      row(out, "rolling", load, s, temperature(carter_flux(c), 1000, s).value);
    for (const double s : grid(-1, 3, 400))
      row(out, "sliding", load, s, temperature(sliding_flux(carter_heat(c)), 1000, s).value);
  }
}

void resolution(std::ostream& out) {
  row(out, "$n$", "$c_0$", "$1-\\kappa$", "$\\gamma_0$", "$T^*_{\\max}$", "outer", "inner");
  for (const int nodes : {50, 100, 200, 400}) {
    const PublishedSolution x = paper::scheme(0.5, paper::peclet, {nodes});
    const double top = published_max_temperature(x, paper::peclet).temperature;
    row(out, nodes, fixed(x.c0, 6), scientific(1 - x.load_ratio, 2), scientific(x.gamma0, 2),
        fixed(top, 6), x.outer_iterations, x.inner_iterations);
  }
  const CoupledSolution x = paper::coupled(0.5, paper::peclet);
  row(out, "**coupled**", fixed(x.value(border), 6), scientific(1 - x.value(load_ratio), 2),
      scientific(x.value(gamma0), 2), fixed(x.value(hottest), 6), "–", "–");
}

void coincident(std::ostream& out) {
  row(out, "$\\Theta(0)$", "$T^*_{\\max}$", "outer steps");
  for (const double value : {0.0, 0.5, 1.0}) {
    PublishedOptions options;
    options.heaviside_at_zero = value;
    const PublishedSolution x = paper::scheme(0.5, 5000, options);
    row(out, value, fixed(published_max_temperature(x, 5000).temperature, 6), x.outer_iterations);
  }
}

void bands(std::ostream& out) {
  row(out, "band", "$\\mathrm{Pe}$", "known", "here");
  const HeatFlux uniform{-1, 1, [](double, double) { return 1; }};
  for (const double pe : {0.1, 1.0, 10.0, 100.0, 5000.0}) {
    const Peak top = max_temperature(uniform, pe);
    row(out, "uniform", pe, fixed(jaeger_band(pe, top.at), 9), fixed(top.temperature.value, 9));
  }
  row(out, "semi-elliptic", "∞", "1.11", fixed(blok_factor(1e8), 4));
}

/// The most digits that a formula loses in a quarter of a decade about zeta.
double most_lost(double (*formula)(double), double (*exact)(double), double zeta) {
  double lost = 0;
  for (const double place : grid(-0.125, 0.125, 12)) {
    const double at = zeta * std::pow(10, place);
    lost = std::max(lost, digits_lost(formula(at), exact(at)));
  }
  return lost;
}

void arithmetic(std::ostream& out) {
  row(out, "zeta", "N1", "N1_scaled", "N2", "N2_scaled", "M", "M_scaled");
  const auto M = [](double zeta) { return kernel::M(zeta); };
  for (const double decade : grid(-12, 12, 96)) {
    const double x = std::pow(10, decade);
    row(out, x, most_lost(naive::N1, kernel::N1, x), most_lost(naive_scaled::N1, kernel::N1, x),
        most_lost(naive::N2, kernel::N2, -x), most_lost(naive_scaled::N2, kernel::N2, -x),
        most_lost(naive::M, M, -x), most_lost(naive_scaled::M, M, -x));
  }
}

void seen(std::ostream& out) {
  row(out, "peclet", "nodes", "seen", "law");
  const Carter c = paper::closed_form(0.5);
  for (const double speed : grid(1, 5, 32))
    for (const double size : grid(1, 3.3, 23)) {
      const double peclet = std::pow(10, speed), exact = exact_load_change(c, peclet);
      const int nodes = static_cast<int>(std::lround(std::pow(10, size)));
      row(out, peclet, nodes, scheme_load_change(c, peclet, nodes) / exact,
          1 - missed_load_change(c, peclet, nodes) / exact);
    }
}

void values_on_resolution(nlohmann::ordered_json& v) {
  const Carter half = paper::closed_form(0.5);
  const double all = first_order_load_change(0.5) / (paper::friction * paper::heating);
  const double spacing = pi / 100;
  const double mean_sine = 16 * missed_load_change(half, 1, 99) / (spacing * spacing * all);
  v["fails_c0"] = fixed(half.c0, 4);
  v["fails_mean_sine"] = fixed(mean_sine, 2);
  for (const auto& [name, missed] : {std::pair{"1", 0.01}, {"01", 0.001}}) {
    const double per_speed = pi * std::sqrt(mean_sine / (16 * missed));
    const double nodes = per_speed * paper::peclet;
    v[std::string("fails_nodes_") + name] = fixed(per_speed, 1);
    v[std::string("fails_steel_") + name] = fixed(1000 * std::round(nodes / 1000), 0);
    v[std::string("fails_memory_") + name] = fixed(8e-9 * nodes * nodes, 0);
  }
}

PublishedSolution cycling(int nodes) {
  return solve_published({paper::friction, 100, 0.5}, 0.5, Formulation::corrected, {nodes});
}

void cycle(std::ostream& out) {
  row(out, "nodes", "step", "c0", "traction");
  for (const int nodes : {89, 90, 91}) {
    const PublishedSolution solution = cycling(nodes);
    for (std::size_t i = 0; i < std::min<std::size_t>(solution.steps.size(), 140); ++i)
      row(out, nodes, i + 1, solution.steps[i].c0, solution.steps[i].traction);
  }
}

void values_on_cycle(nlohmann::ordered_json& v) {
  const PublishedSolution undecided = cycling(90);
  Eigen::Index nearest = 0;
  (undecided.grid.t.array() - undecided.c0).abs().minCoeff(&nearest);
  const double node = undecided.grid.t(nearest);
  double hot = 1, cold = 0;  // of the last three steps, the tractions nearest to the gap
  for (auto step = undecided.steps.rbegin(); step != undecided.steps.rbegin() + 3; ++step)
    if (step->c0 < node)
      hot = std::min(hot, step->traction);
    else
      cold = std::max(cold, step->traction);
  int struck = 0;
  for (int nodes = 20; nodes < 120; ++nodes) struck += cycling(nodes).converged ? 0 : 1;
  v["cycle_node"] = fixed(node, 4);
  v["cycle_hot"] = fixed(hot, 4);
  v["cycle_cold"] = fixed(cold, 4);
  v["cycle_struck"] = std::to_string(struck);
}

/// Settled on a contact; its last iterate a contact, or none; settled on what is none.
enum class SchemeEnd { settled = 1, unsettled, lost, wrong };

constexpr PublishedOptions few_nodes{20, 1e-6, 0, 40};  // at most 40 outer steps

SchemeEnd end_of_scheme(const Scene& scene, double traction, Formulation formulation) {
  const PublishedSolution solution = solve_published(scene, traction, formulation, few_nodes);
  if (violations(factors(solution, scene.friction)).empty())
    return solution.converged ? SchemeEnd::settled : SchemeEnd::unsettled;
  return solution.converged ? SchemeEnd::wrong : SchemeEnd::lost;
}

void values_on_contacts(nlohmann::ordered_json& v) {
  constexpr int count = 300;
  int refused = 0, wrong = 0, unsettled = 0, scheme_wrong = 0;
  for (Sample x : random_scenes(count)) {
    x.scene.heating *= 10;
    const Prescribed given{traction, x.traction};
    const Outcome found =
        outcome([&] { return solve_coupled(x.scene, x.formulation, 1e-3, given); });
    refused += found == Outcome::refused ? 1 : 0;
    wrong += found == Outcome::no_contact ? 1 : 0;
    const SchemeEnd end = end_of_scheme(x.scene, x.traction, x.formulation);
    unsettled += end == SchemeEnd::unsettled || end == SchemeEnd::lost ? 1 : 0;
    scheme_wrong += end == SchemeEnd::lost || end == SchemeEnd::wrong ? 1 : 0;
  }
  v["contact_scenes"] = std::to_string(count);
  v["contact_refused"] = std::to_string(refused);
  v["contact_wrong"] = std::to_string(wrong);
  v["contact_nodes"] = std::to_string(few_nodes.nodes);
  v["contact_unsettled"] = std::to_string(unsettled);
  v["contact_scheme_wrong"] = std::to_string(scheme_wrong);
}

/// 1 Picard, 2 relaxed by half, 3 Anderson, 4 Newton, 5 Newton with continuation to the solution h.
int first_to_converge(const FluxMap& map, const Eigen::VectorXd& h) {
  const auto finds = [&](auto iterate) {
    Eigen::VectorXd found = carter_start(map);
    return iterate(found) > 0 && (found - h).norm() < 1e-4 * h.norm();
  };
  if (finds([&](Eigen::VectorXd& x) { return picard(map, x); })) return 1;
  if (finds([&](Eigen::VectorXd& x) { return picard(map, x, 0.5); })) return 2;
  if (finds([&](Eigen::VectorXd& x) { return anderson(map, x); })) return 3;
  return finds([&](Eigen::VectorXd& x) { return newton(map, x); }) ? 4 : 5;
}

/// The solution at one speed, continued from heating to heating for as long as it is a contact's.
struct Continuation {
  FluxMap unit;
  double heating;
  Eigen::VectorXd h = carter_start(unit);
  bool holds = true;

  bool reaches(double next) {
    holds = holds && follow(unit, heating, next, h) > 0;
    holds = holds && pressure_factor(heated(unit, next), h).minCoeff() > 0;
    heating = next;
    return holds;
  }
};

Continuation continuation_at(double peclet, Formulation formulation, int unknowns) {
  const double c0 = paper::closed_form(0.5).c0;
  return {flux_map({paper::friction, peclet, 1}, formulation, unknowns, c0), 1e-3 / peclet};
}

void iteration(std::ostream& out, Formulation formulation) {
  row(out, "peclet", "strength", "method", "picard", "half", "scheme");
  for (const double speed : grid(-1, 5, 30)) {
    const double peclet = std::pow(10, speed), most = 30 * std::max(1.0, 4 / peclet);
    Continuation path = continuation_at(peclet, formulation, 64);
    for (const double size : grid(0, 6, 30)) {
      const double strength = std::pow(10, size), heating = strength / (paper::friction * peclet);
      int method = 0, scheme = 0;  // not tried
      double full = 0, half = 0;
      if (paper::friction * heating <= most) {
        method = 6;  // not reached
        const Scene scene{paper::friction, peclet, heating};
        scheme = static_cast<int>(end_of_scheme(scene, 0.5, formulation));
        if (path.reaches(heating)) {
          const FluxMap map = heated(path.unit, heating);
          method = first_to_converge(map, path.h);
          full = contraction(map, path.h);
          half = contraction(map, path.h, 0.5);
        }
      }
      row(out, peclet, strength, method, fixed(full, 4), fixed(half, 4), scheme);
    }
  }
}

/// The cells of @fig:iteration-a that so many unknowns do not reach; all of them are at Pe > 1000.
int missed(int unknowns) {
  int count = 0;
  for (const double speed : grid(3, 5, 10)) {
    Continuation path = continuation_at(std::pow(10, speed), Formulation::printed, unknowns);
    for (const double size : grid(0, 6, 30)) {
      const double f_h = std::pow(10, size - speed);
      if (f_h <= 30 && !path.reaches(f_h / paper::friction)) ++count;
    }
  }
  return count;
}

void values_on_ways(nlohmann::ordered_json& v) {
  for (const int unknowns : {64, 128, 256})
    v["missed_" + std::to_string(unknowns)] = std::to_string(missed(unknowns));
}

void iteration_steps(std::ostream& out) {
  row(out, "$\\mathrm{Pe}$", "$fH$", "$\\rho_1$", "Picard", "half steps", "Anderson", "Newton",
      "led");
  const auto cell = [](int steps) { return steps > 0 ? std::to_string(steps) : "–"; };
  for (const double peclet : {1.0, 100.0, paper::peclet})
    for (const double f_h : {0.01, 0.3, 1.0, 3.0, 10.0}) {
      const double heating = f_h / paper::friction, c0 = paper::closed_form(0.5).c0;
      const Scene scene{paper::friction, peclet, 1};
      const FluxMap unit = flux_map(scene, Formulation::corrected, 128, c0);
      const FluxMap map = heated(unit, heating);
      Eigen::VectorXd h = carter_start(map), x = h;
      const int led = follow(unit, 1e-3 / peclet, heating, h);
      const auto steps = [&](auto iterate) {
        x = carter_start(map);
        return cell(iterate());
      };
      row(out, peclet, f_h, fixed(contraction(map, h), 2), steps([&] { return picard(map, x); }),
          steps([&] { return picard(map, x, 0.5); }), steps([&] { return anderson(map, x); }),
          steps([&] { return newton(map, x); }), cell(led));
    }
}

/// How many scenes of the corners are solved as contacts, solved as none, refused.
std::array<int, 3> survivors(Formulation formulation, double heating) {
  std::array<int, 3> count{};
  for (int decade = -3; decade <= 8; ++decade)
    for (const double share : {1e-12, 0.5, 1 - 1e-12}) {
      const double f = paper::friction;
      const Scene scene{f, std::pow(10, decade), heating};
      const Prescribed given{traction, f * share};
      const Outcome found = outcome([&] { return solve_coupled(scene, formulation, 1e-3, given); });
      ++count[static_cast<std::size_t>(found)];
    }
  return count;
}

void survival(std::ostream& out) {
  row(out, "$H$", "corrected: solved", "corrected: no contact", "corrected: refused",
      "printed: solved", "printed: no contact", "printed: refused");
  for (const double heating : {0.01, 1.0, 10.0, 100.0, 1000.0}) {
    const auto [a, b, c] = survivors(Formulation::corrected, heating);
    const auto [d, e, g] = survivors(Formulation::printed, heating);
    row(out, shortest(heating), a, b, c, d, e, g);
  }
}

void ends(std::ostream& out) {
  row(out, "peclet", "fast", "slow");
  const HeatFlux flux = carter_flux(paper::closed_form(0.5));
  const double fast = hottest_when_fast(flux);
  for (const double speed : grid(-3, 8, 33)) {
    const double peclet = std::pow(10, speed);
    const Scene scene{paper::friction, peclet, 0};
    const double top =
        solve_coupled(scene, Formulation::corrected, 1e-9, {traction, 0.5}).value(hottest);
    row(out, peclet, std::abs(fast / std::sqrt(peclet) / top - 1),
        std::abs(hottest_when_slow(flux, peclet) / top - 1));
  }
}

/// The largest heating, from 1e-9 to 1e3, at which the error of a rung meets the tolerance.
template <class Rung>
double most_heating(const Rung& rung, double peclet, double tolerance) {
  double low = 1e-9, high = 1e3;
  while (high > 1.01 * low) {
    const double middle = std::sqrt(low * high);
    const Scene scene{paper::friction, peclet, middle};
    const auto x = rung(scene, Formulation::corrected, tolerance, Prescribed{traction, 0.5});
    (x.error(load_ratio) <= tolerance ? low : high) = middle;
  }
  return low;
}

void rungs_by_peclet(std::ostream& out) {
  row(out, "peclet", "closed_2", "first_2", "closed_3", "first_3", "closed_6", "first_6");
  for (const double speed : grid(-2, 6, 48)) {
    out << shortest(std::pow(10, speed));
    for (const double tolerance : {1e-2, 1e-3, 1e-6})
      for (const auto rung : {closed_form, first_order})
        out << ',' << shortest(most_heating(rung, std::pow(10, speed), tolerance));
    out << '\n';
  }
}

/// How an answer to a tolerance did: the rung, 3 where it was refused, and its true error in units
/// of the tolerance, by a coupled solution ten times better.
struct Trial {
  int rung = 3;
  double error = 0;
};

Trial try_ladder(const Sample& x, double tolerance) {
  const Prescribed given{traction, x.traction};
  try {
    const Choice choice = least_model(x.scene, x.formulation, tolerance, given);
    const CoupledSolution better = solve_coupled(x.scene, x.formulation, tolerance / 10, given);
    const double off = largest_difference(choice.solution.value, better.value);
    return {static_cast<int>(choice.model), off / tolerance};
  } catch (const std::runtime_error&) {
    return {};
  }
}

constexpr int random_count = 10002;  // a third for each tolerance
constexpr double random_tolerances[] = {1e-2, 1e-3, 1e-6};

std::vector<Trial> all_trials() {
  const std::vector<Sample> scenes = random_scenes(random_count);
  std::vector<Trial> trials(scenes.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < scenes.size(); i = next++)
      trials[i] = try_ladder(scenes[i], random_tolerances[i % 3]);
  };
  std::thread other(work);
  work(), other.join();
  return trials;
}

void rungs_of_random_scenes(std::ostream& out) {
  row(out, "tolerance", "closed form", "first order", "coupled", "refused", "error below coupled",
      "error of coupled");
  const std::vector<Trial> trials = all_trials();
  for (std::size_t k = 0; k < 3; ++k) {
    int count[4] = {};
    double below = 0, coupled = 0;
    for (std::size_t i = k; i < trials.size(); i += 3) {
      ++count[trials[i].rung];
      double& worst = trials[i].rung < 2 ? below : coupled;
      worst = std::max(worst, trials[i].error);
    }
    row(out, scientific(random_tolerances[k], 1), count[0], count[1], count[2], count[3],
        fixed(below, 2), fixed(coupled, 2));
  }
}

void values_on_least_model(nlohmann::ordered_json& v) {
  const Scene scene{paper::friction, paper::peclet, paper::heating};
  const Prescribed given{traction, 0.5};
  const auto model = [&](double tolerance) {
    const char* const names[] = {"closed form", "first order in the heat", "coupled"};
    const Choice x = least_model(scene, Formulation::corrected, tolerance, given);
    return names[static_cast<int>(x.model)];
  };
  const double lambda = 2 * paper::closed_form(0.5).slip_half_width * paper::peclet;
  const CoupledSolution best = solve_coupled(scene, Formulation::corrected, 1e-8, given);
  const CoupledSolution cold = closed_form(scene, Formulation::corrected, 1e-8, given);
  const double most = largest_difference(cold.value, best.value);
  v["least_scenes"] = std::to_string(random_count);
  v["least_lambda"] = fixed(lambda, 0);
  v["least_limit_error"] = scientific(1.3 / (lambda * lambda), 1);
  v["least_paper_2"] = model(1e-2), v["least_paper_3"] = model(1e-3);
  v["least_paper_6"] = model(1e-6);
  v["least_paper_change"] = scientific(most, 1);
  v["least_paper_square"] = scientific(most * most, 1);
}

const std::pair<std::string, std::string> symbols[] = {
    {"T*max", "$T^*_{\\max}$"},
    {"|q| < f p", "$|q|<fp$"},
    {"1 − κ", "$1-\\kappa$"},
    {"γ0", "$\\gamma_0$"},
    {"Pe", "$\\mathrm{Pe}$"},
    {" n ", " $n$ "},
    {" H ", " $H$ "},
    {"Q*", "$Q^*$"},
    {"T*", "$T^*$"},
    {"v*", "$v^*$"},
    {"c0", "$c_0$"},
};

std::string in_tex(std::string text) {
  for (const auto& [plain, tex] : symbols)
    for (std::size_t at = 0; (at = text.find(plain, at)) != text.npos; at += tex.size())
      text.replace(at, plain.size(), tex);
  return text;
}

void claims_table(std::ostream& out) {
  row(out, "the paper says", "paper", "published scheme", "converged", "verdict");
  const auto cell = [](const std::string& text) { return '"' + in_tex(text) + '"'; };
  for (const Claim& c : claims())
    row(out, cell(c.claim), cell(c.paper), cell(c.published), cell(c.converged), cell(c.verdict));
}

void values(std::ostream& out) {
  nlohmann::ordered_json v;
  const PhysicalCase steel = wheel_on_rail();
  const CoupledSolution contact = paper::coupled(0.5, paper::peclet);
  v["steel_load"] = scientific(steel.load, 2);
  v["steel_speed"] = shortest(steel.speed);
  v["steel_half_width"] = scientific(steel.half_width, 2);
  v["steel_shear_modulus"] = scientific(steel.shear_modulus, 2);
  v["steel_poisson"] = shortest(steel.poisson);
  v["steel_expansion"] = scientific(steel.expansion, 2);
  v["steel_diffusivity"] = scientific(steel.diffusivity, 2);
  v["steel_conductivity"] = shortest(steel.conductivity);
  v["steel_friction"] = shortest(paper::friction);
  const Scene groups = scene_of(steel, paper::friction);
  const double compliance = 4 * (1 - steel.poisson) * steel.load / (pi * steel.shear_modulus);
  v["hertz_p0"] = fixed(2 / pi * units_of(steel, paper::friction).traction / 1e9, 2);
  v["steel_peclet"] = fixed(groups.peclet, 0);
  v["steel_heating"] = fixed(groups.heating, 4);
  v["steel_radius"] = fixed(steel.half_width * steel.half_width / compliance, 3);
  const Carter cold = paper::closed_form(0.5);
  v["steel_creep"] = fixed(contact.value(creep), 4);
  v["steel_creep_difference"] = fixed(paper::friction * std::abs(contact.value(gamma0)), 4);
  v["steel_eccentricity"] = fixed(std::abs(contact.eccentricity), 4);
  const Prescribed half{traction, 0.5};
  const Scene scene = paper::scene(paper::peclet);
  const CoupledSolution corrected = solve_coupled(scene, Formulation::corrected, 1e-8, half);
  v["corrected_kappa"] = fixed(1 - corrected.value(load_ratio), 5);
  for (const auto& [sign, x] : {std::pair{"steel", contact}, {"corrected", corrected}}) {
    const auto change = [&, &x = x](Quantity what) {
      return fixed(100 * std::abs(x.value(what) / cold.creep - 1), 2);
    };
    v[std::string(sign) + "_border"] = fixed(x.value(border), 4);
    v[std::string(sign) + "_constant_change"] = change(creep_constant);
    v[std::string(sign) + "_creep_change"] = change(creep);
  }
  const Peak top = max_temperature(carter_flux(cold), 5000);
  const double top_printed = paper::scheme_max(0.5, 5000);
  const double top_coupled = paper::coupled(0.5, 5000).value(hottest);
  v["tmax_5000"] = fixed(top.temperature.value, 7);
  v["tmax_5000_at"] = fixed(top.at, 4);
  v["tmax_5000_coupled"] = fixed(top_coupled, 5);
  v["tmax_5000_printed"] = fixed(top_printed, 6);
  v["tmax_5000_error"] = fixed(100 * (1 - top_printed / top_coupled), 1);
  v["sliding_ratio_02"] = fixed(rolling_to_sliding(0.2), 1);
  v["sliding_ratio_059"] = fixed(rolling_to_sliding(0.59), 1);
  double worst = 0;
  for (const auto& [pe, celsius] : {std::pair{5000, 272}, {10000, 420}, {15000, 490}}) {
    const double hot = paper::coupled(0.5, pe).value(hottest);
    const double rounded = hot * celsius_per_unit(pe / 200.0);
    v["celsius_" + std::to_string(pe)] = fixed(hot * celsius_per_unit_at(pe), 0);
    v["celsius_" + std::to_string(pe) + "_rounded"] = fixed(rounded, 0);
    worst = std::max(worst, std::abs(celsius / rounded - 1));
  }
  v["celsius_worst"] = fixed(100 * worst, 0);
  v["celsius_of_the_paper"] = fixed(0.002 * celsius_per_unit(25), 0);
  v["celsius_ratio"] = fixed(490.0 / 420, 3);
  v["celsius_root"] = fixed(std::sqrt(1.5), 3);
  v["speed_difference"] = fixed(100 * (speed_at(5000) / 25 - 1), 1);
  const auto rule_error = [&](int nodes) {
    const double found = paper::scheme_max(0.5, paper::peclet, {nodes});
    return fixed(100 * (1 - found / contact.value(hottest)), 1);
  };
  v["rule_error_50"] = rule_error(50);
  v["rule_error_200"] = rule_error(200);
  v["node_distance"] = fixed(pi / 200, 3);
  v["layer"] = fixed(1 / paper::peclet, 5);
  v["layers_per_node"] = fixed(pi / 200 * paper::peclet, 0);
  v["layer_thinner"] = fixed(std::sqrt(paper::peclet / 100), 1);
  const auto loss = [](int nodes) {
    return 1 - paper::scheme(0.5, paper::peclet, {nodes}).load_ratio;
  };
  const double kappa_coupled = 1 - contact.value(load_ratio);
  double largest = 0, largest_corrected = 0;
  for (const double q : paper::tractions) {
    const Scene s = paper::scene(paper::peclet);
    const auto other = solve_coupled(s, Formulation::corrected, 1e-8, {traction, q});
    largest = std::max(largest, 1 - paper::coupled(q, paper::peclet).value(load_ratio));
    largest_corrected = std::max(largest_corrected, other.value(load_ratio) - 1);
  }
  v["kappa_printed"] = fixed(loss(200), 5);
  v["kappa_coupled"] = fixed(kappa_coupled, 5);
  v["kappa_coupled_largest"] = fixed(largest, 4);
  v["kappa_corrected_largest"] = fixed(largest_corrected, 4);
  v["kappa_ratio"] = fixed(kappa_coupled / loss(200), 0);
  v["kappa_growth_50"] = fixed(loss(100) / loss(50), 2);
  v["kappa_growth_200"] = fixed(loss(400) / loss(200), 2);
  v["kappa_seen_400"] = fixed(100 * loss(400) / kappa_coupled, 0);
  const double kappa_first = first_order_load_change(0.5), gamma_first = first_order_gamma0(0.5);
  v["gamma_coupled"] = fixed(contact.value(gamma0), 5);
  v["gamma_first_order"] = fixed(gamma_first, 5);
  v["gamma_first_order_error"] = fixed(100 * (gamma_first / contact.value(gamma0) - 1), 0);
  v["kappa_first_order"] = fixed(kappa_first, 5);
  v["kappa_first_order_error"] = fixed(100 * (kappa_first / kappa_coupled - 1), 0);
  PublishedOptions other;
  other.heaviside_at_zero = 1;
  v["coincident_change"] = fixed(100 * (paper::scheme_max(0.5, 5000, other) / top_printed - 1), 0);
  const Record record = scheme_record();
  v["most_inner"] = std::to_string(record.inner);
  v["most_outer"] = std::to_string(record.outer);
  v["largest_error_50"] = fixed(record.coarse_error, 1);
  v["largest_error_200"] = fixed(record.fine_error, 1);
  const auto semi_axis = [&](double force) { return 3 * force / (4 * steel.load); };
  v["ellipse_as_printed"] = fixed(semi_axis(1.47e7), 2);
  v["ellipse_mended"] = fixed(1000 * semi_axis(1.47e5), 0);
  values_on_resolution(v);
  values_on_cycle(v);
  values_on_ways(v);
  values_on_contacts(v);
  values_on_least_model(v);
  out << v.dump(2) << '\n';
}

using Writer = std::function<void(std::ostream&)>;

const std::vector<std::pair<std::string, Writer>>& writers() {
  const auto of_load = [](double load) {
    return [=](std::ostream& out) { temperature_by_peclet(out, load); };
  };
  const auto of_regime = [](const Regime& regime) {
    return [=](std::ostream& out) { errors(out, regime); };
  };
  static const std::vector<std::pair<std::string, Writer>> table{
      {"geometry", geometry},
      {"kernels", kernels},
      {"traction", tractions_of_load},
      {"slip", slip_of_load},
      {"temperature-a", of_load(0.2)},
      {"temperature-b", of_load(0.4)},
      {"temperature-c", of_load(0.5)},
      {"temperature-d", of_load(0.59)},
      {"temperature-load", temperature_by_load},
      {"subsurface", subsurface},
      {"sliding", sliding},
      {"creep", creep_curve},
      {"nodes", share_found},
      {"celsius", celsius_of_speed},
      {"speed-steel", of_regime(regimes[0])},
      {"speed-slow", of_regime(regimes[1])},
      {"speed-hot", of_regime(regimes[2])},
      {"cost", cost},
      {"arithmetic", arithmetic},
      {"seen", seen},
      {"cycle", cycle},
      {"ends", ends},
      {"rungs", rungs_by_peclet},
      {"iteration-a", [](std::ostream& out) { iteration(out, Formulation::printed); }},
      {"iteration-b", [](std::ostream& out) { iteration(out, Formulation::corrected); }},
      {"resolution", resolution},
      {"coincident", coincident},
      {"bands", bands},
      {"iteration-steps", iteration_steps},
      {"survival", survival},
      {"random-scenes", rungs_of_random_scenes},
      {"claims", claims_table},
      {"values", values},
  };
  return table;
}

}  // namespace

Outcome outcome(const std::function<CoupledSolution()>& solve) try {
  return solve().violations.empty() ? Outcome::contact : Outcome::no_contact;
} catch (const std::runtime_error&) {
  return Outcome::refused;
}

std::vector<std::string> figure_data_names() {
  std::vector<std::string> names;
  for (const auto& [name, write] : writers()) names.push_back(name);
  return names;
}

void write_figure_data(const std::string& name, std::ostream& out) {
  for (const auto& [known, write] : writers())
    if (name == known) {
      out << std::setprecision(10);
      write(out);
      return;
    }
  throw std::invalid_argument("figure-data: unknown name " + name);
}

}  // namespace thermoroll
