// Tangled from paper/15-speed-and-accuracy.md, paper/17-least-model.md, paper/F-data-files.md; edit there.
#include "studies/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gsl/gsl_sf_bessel.h>

#include "solver/grid_solution.hpp"
#include "solver/least_model.hpp"
#include "solver/surface.hpp"
#include "studies/cached_scheme.hpp"
#include "studies/graded_panels.hpp"
#include "studies/paper_scene.hpp"
#include "studies/sampling.hpp"
#include "support/number_text.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Formulation sign = Formulation::corrected;
constexpr double pull = 0.5;  // Q*, in every regime

Found found(const PublishedSolution& solution, const PublishedPeak& top) {
  if (!solution.converged) return {nan, nan, nan};
  return {solution.load_ratio, top.temperature, solution.creep};
}

Found as_described(const Scene& scene, int nodes) {
  const PublishedSolution solution = solve_published(scene, pull, sign, {nodes});
  return found(solution, published_max_temperature(solution, scene.peclet));
}

Found cached(const Scene& scene, int nodes, NodeKernel kernel) {
  const PublishedSolution solution = solve_cached(scene, pull, sign, kernel, {nodes});
  return found(solution, cached_max_temperature(solution, scene.peclet, kernel));
}

Found on_panels(const Scene& scene, int nodes) {
  const PanelSolution x = solve_on_panels(scene, pull, sign, nodes);
  return {x.load_ratio, x.hottest, x.creep};
}

Found found(const CoupledSolution& x) {
  return {x.value(Quantity::load_ratio), x.value(Quantity::max_temperature),
          x.value(Quantity::creep), x.unknowns};
}

Found coupled_to(const Scene& scene, double tolerance) try {
  return found(solve_coupled(scene, {sign, tolerance}, {Quantity::traction, pull}));
} catch (const std::runtime_error&) {  // not resolved
  return {nan, nan, nan};
}

Found corrected_once(const Scene& scene) {
  return found(first_order(scene, {sign, 1e-6}, {Quantity::traction, pull}));
}

Found without_heat(const Scene& scene) { return {1, nan, carter(scene.friction, pull).creep}; }

Found temperature_without_heat(const Scene& scene) {
  const Carter cold = carter(scene.friction, pull);
  const SmoothFlux flux = smooth_flux(cold);
  return {1, hottest_point(flux, scene.peclet, 1e-9).temperature.value, cold.creep};
}

std::string where(const Scene& scene) {
  return "/Pe:" + shortest(scene.peclet) + "/H:" + shortest(scene.heating);
}

Run coupled_run(const Scene& scene, double tolerance) {
  return {"coupled", tolerance, "coupled/tol:" + shortest(tolerance) + where(scene),
          [=] { return coupled_to(scene, tolerance); }};
}

}  // namespace

std::vector<Sample> random_scenes(int count) {
  Random random{std::mt19937_64(20020101)};
  std::vector<Sample> scenes;
  for (int i = 0; i < count; ++i) {
    const double f = random.log_uniform(0.05, 1), share = random.log_uniform(0.01, 0.999);
    const Scene scene{f, random.log_uniform(1e-2, 1e6), random.log_uniform(1e-4, 3)};
    scenes.push_back(
        {scene, f * share, random.bits() % 2 ? Formulation::printed : Formulation::corrected});
  }
  return scenes;
}

std::vector<std::pair<Scene, Run>> cost_runs() {
  std::vector<std::pair<Scene, Run>> all;
  for (const double heating : {0.0175, 1.0})
    for (const double tolerance : {1e-4, 1e-6, 1e-8})
      for (int decade = -1; decade <= 6; ++decade) {
        const double peclet = std::pow(10, decade);
        const Scene scene{paper::friction, peclet, heating};
        all.emplace_back(scene, coupled_run(scene, tolerance));
      }
  return all;
}

Found on_one_grid(const Regime& regime, int n) {
  const Scene scene{paper::friction, regime.peclet, regime.heating};
  const Prescribed given{Quantity::traction, pull};
  const Carter cold = carter(scene.friction, pull);
  Results slope = carter_slope(cold, Quantity::traction);
  GridSolution x;
  x.at = {2 * cold.slip_half_width, 2 * cold.b};
  x = find_border(scene, sign, n, given, x, slope);
  const auto step = [&] { return slope(Quantity::stick_slip_border) * residual(x, given); };
  for (int k = 0; k < 4 && x.newton_steps > 0; ++k)
    x = solve_on_grid(scene, sign, n, moved_by(x.at, step()), x);
  if (x.newton_steps == 0) return {nan, nan, nan};
  return {x.value(Quantity::load_ratio), x.value(Quantity::max_temperature),
          x.value(Quantity::creep), n};
}

std::vector<Run> runs(const Regime& regime) {
  const Scene scene{paper::friction, regime.peclet, regime.heating};
  const std::string at = where(scene);
  std::vector<Run> all{
      {"closed_form", 0, "closed_form", [=] { return without_heat(scene); }},
      {"closed_form", 0, "closed_form" + at, [=] { return temperature_without_heat(scene); }},
      {"first_order", 0, "first_order" + at, [=] { return corrected_once(scene); }}};
  for (int n = 25; n <= regime.most_nodes; n *= 2) {
    const std::string with = "/n:" + std::to_string(n) + at;
    all.push_back({"gauss_chebyshev", static_cast<double>(n), "gauss_chebyshev" + with,
                   [=] { return as_described(scene, n); }});
    for (const auto& [method, kernel] :
         {std::pair{"thrifty", NodeKernel::sample}, {"moments", NodeKernel::mean}})
      all.push_back({method, static_cast<double>(n),
                     std::string("gauss_chebyshev_") + method + with,
                     [=, kernel = kernel] { return cached(scene, n, kernel); }});
    if (n <= 400)
      all.push_back({"graded_panels", static_cast<double>(n), "graded_panels" + with,
                     [=] { return on_panels(scene, n); }});
  }
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11})
    all.push_back(coupled_run(scene, tolerance));
  return all;
}

Found reference(const Regime& regime) {
  return coupled_run({paper::friction, regime.peclet, regime.heating}, 1e-11).find();
}

CarterErrors carter_errors() {
  const Carter exact = carter(0.3, 0.192);  // 1 - 0.6^2 = 0.64 of the friction
  const Scene scene{0.3, 1, 0};
  const CoupledSolution at_creep =
      solve_coupled(scene, {sign, 1e-6}, {Quantity::creep, exact.creep});
  const CoupledSolution at_force = solve_coupled(scene, {sign, 1e-6}, {Quantity::traction, 0.192});
  const Profile x = profile(at_creep);
  double worst = 0;
  for (Eigen::Index i = 0; i < x.s.size(); ++i)
    worst = std::max(worst, std::abs(x.traction(i) - carter_traction(exact, x.s(i))));
  return {at_creep.unknowns, std::abs(at_creep.value(Quantity::traction) / 0.192 - 1),
          std::abs(at_force.value(Quantity::creep) / exact.creep - 1),
          worst / (0.3 * hertz_pressure(0))};
}

double jaeger_band(double peclet, double s) {
  const double a = peclet * (1 - s), b = peclet * (1 + s);
  const double ahead = gsl_sf_bessel_K0_scaled(a) - gsl_sf_bessel_K1_scaled(a);
  const double behind = gsl_sf_bessel_K0_scaled(b) + gsl_sf_bessel_K1_scaled(b);
  return (a * std::exp(-2 * a) * ahead + b * behind) / (pi * peclet);
}

double blok_factor(double peclet) {
  return 2 * std::sqrt(peclet) * hottest_point(sliding_flux(1), peclet).temperature.value;
}

double error_of(double value, double exact) { return std::max(std::abs(value / exact - 1), 1e-11); }

double right_digits(const Found& found, const Found& exact) {
  if (std::isnan(found.hottest)) return found.hottest;
  return -std::log10(
      std::max({error_of(found.load_ratio, exact.load_ratio),
                error_of(found.hottest, exact.hottest), error_of(found.creep, exact.creep)}));
}

}  // namespace thermoroll
