// Tangled from paper/12-speed-and-accuracy.md; edit there.
#include "comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <gsl/gsl_sf_bessel.h>

#include "numbers.hpp"
#include "paper_case.hpp"
#include "surface.hpp"
#include "temperature.hpp"
#include "thrifty_scheme.hpp"

namespace thermoroll {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Formulation sign = Formulation::corrected;

Found found(const PrintedSolution& x, const PrintedPeak& top) {
  if (!x.converged) return {nan, nan, nan};
  return {x.load_ratio, top.temperature, x.creep};
}

Found as_described(const Scene& scene, int nodes) {
  const PrintedSolution x = solve_printed(scene, sign, {nodes});
  return found(x, printed_max_temperature(x, scene.peclet));
}

Found thriftily(const Scene& scene, int nodes, NodeKernel kernel) {
  const PrintedSolution x = solve_thrifty(scene, sign, kernel, {nodes});
  return found(x, thrifty_max_temperature(x, scene.peclet, kernel));
}

Found coupled_to(const Scene& scene, double tolerance) {
  const CoupledSolution x = solve_coupled(scene, sign, tolerance, {traction, scene.traction});
  return {x.value(load_ratio), x.value(hottest), x.value(creep)};
}

Found without_heat(const Scene& scene) {
  return {1, nan, carter(scene.friction, scene.traction).creep};
}

Found temperature_without_heat(const Scene& scene) {
  const SmoothFlux flux = smooth_flux(carter(scene.friction, scene.traction));
  return {nan, hottest_point(flux, scene.peclet, 1e-9).temperature.value, nan};
}

}  // namespace

std::vector<Run> runs(const Regime& regime) {
  const Scene scene{paper::friction, 0.5, regime.peclet, regime.heating};
  const std::string where = "/Pe:" + shortest(regime.peclet) + "/H:" + shortest(regime.heating);
  std::vector<Run> all;
  const auto add = [&](const std::string& method, double setting, const std::string& name,
                       const std::function<Found()>& find) {
    all.push_back({method, setting, name, find});
  };
  add("closed_form", 0, "closed_form", [=] { return without_heat(scene); });
  add("closed_form", 0, "closed_form" + where, [=] { return temperature_without_heat(scene); });
  for (int n = 25; n <= regime.most_nodes; n *= 2) {
    const std::string with = "/n:" + std::to_string(n) + where;
    add("gauss_chebyshev", n, "gauss_chebyshev" + with, [=] { return as_described(scene, n); });
    for (const auto& [method, kernel] :
         {std::pair{"thrifty", NodeKernel::sample}, {"moments", NodeKernel::mean}})
      add(method, n, std::string("gauss_chebyshev_") + method + with,
          [=, kernel = kernel] { return thriftily(scene, n, kernel); });
  }
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11})
    add("coupled", tolerance, "coupled/tol:" + shortest(tolerance) + where,
        [=] { return coupled_to(scene, tolerance); });
  return all;
}

Found reference(const Regime& regime) {
  return coupled_to({paper::friction, 0.5, regime.peclet, regime.heating}, 1e-11);
}

CarterErrors carter_errors() {
  const Carter exact = carter(0.3, 0.192);  // 1 - 0.6^2 = 0.64 of the friction
  const Scene scene{0.3, 0.192, 1, 0};
  const CoupledSolution at_creep = solve_coupled(scene, sign, 1e-6, {creep, exact.creep});
  const CoupledSolution at_force = solve_coupled(scene, sign, 1e-6, {traction, 0.192});
  const Profile x = profile(scene, sign, at_creep);
  double worst = 0;
  for (Eigen::Index i = 0; i < x.s.size(); ++i)
    worst = std::max(worst, std::abs(x.traction(i) - carter_traction(exact, x.s(i))));
  return {at_creep.unknowns, std::abs(at_creep.value(traction) / 0.192 - 1),
          std::abs(at_force.value(creep) / exact.creep - 1), worst / (0.3 * hertz_pressure(0))};
}

double jaeger_band(double peclet, double s) {
  const double a = peclet * (1 - s), b = peclet * (1 + s);
  const double ahead = gsl_sf_bessel_K0_scaled(a) - gsl_sf_bessel_K1_scaled(a);
  const double behind = gsl_sf_bessel_K0_scaled(b) + gsl_sf_bessel_K1_scaled(b);
  return (a * std::exp(-2 * a) * ahead + b * behind) / (pi * peclet);
}

double blok_factor(double peclet) {
  return 2 * std::sqrt(peclet) * max_temperature(sliding_flux(1), peclet).temperature.value;
}

}  // namespace thermoroll
