// Tangled from paper/A-command-line.md; edit there.
#include "solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "carter.hpp"
#include "printed_scheme.hpp"
#include "temperature.hpp"

namespace thermoroll {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Peaks carter_peaks(const Carter& c, const HeatFlux& flux) {
  const double h = c.slip_half_width, middle = 3 * h - 2 * c.b;
  const double root = std::sqrt(middle * middle + 16 * h * c.b);
  const double u = middle > 0 ? (middle + root) / (8 * h) : 2 * c.b / (root - middle);
  return {hertz_pressure(0), c.friction * hertz_pressure(std::max(c.c0, 0.0)),
          flux.density(2 * h * u, 2 * h * (1 - u))};
}

Solution solve_closed_form(const Scene& scene, const Approach& approach) {
  const Carter c = carter(scene.friction, scene.traction);
  const HeatFlux flux = carter_flux(c);
  const Peak top = max_temperature(flux, scene.peclet);
  const Estimate t = top.temperature;
  const double heat = carter_heat(c), xi = c.creep, xi_error = 4 * epsilon * xi;
  const Results value{c.c0, xi, xi, 1, 0, heat, t.value, top.at};
  const Results error{3 * epsilon, xi_error,           xi_error, 0,
                      0,           8 * epsilon * heat, t.error,  top.at_error};
  return {scene, approach, value, error, carter_peaks(c, flux)};
}

PrintedSolution run_scheme(const Scene& scene, const Approach& approach) {
  const int n = approach.nodes;
  require(3 <= n && n <= 5000, "nodes", n, "from 3 to 5000");
  PrintedOptions options;
  options.nodes = n;
  return solve_printed(scene, approach.formulation, options);
}

Peaks scheme_peaks(const Scene& scene, const PrintedSolution& x) {
  Peaks peak{0, 0, 0};
  for (Eigen::Index k = 0; k < x.grid.t.size(); ++k) {
    const double s = x.grid.t(k), pressure = printed_pressure(x, s);
    peak.pressure = std::max(peak.pressure, pressure);
    peak.traction = std::max(peak.traction, printed_traction(x, scene.friction, s));
    peak.heat_flux = std::max(peak.heat_flux, pressure * x.slip(k));
  }
  return peak;
}

Solution solve_gauss_chebyshev(const Scene& scene, const Approach& approach) {
  const PrintedSolution x = run_scheme(scene, approach);
  const PrintedPeak top = printed_max_temperature(x, scene.peclet);
  const double heat = node_heat(x).sum();
  Solution y{scene, approach, {}, std::nullopt, scheme_peaks(scene, x)};
  y.value = {x.c0, x.creep_constant, x.creep, x.load_ratio, x.gamma0,
             heat, top.temperature,  top.at};
  y.outer_iterations = x.outer_iterations;
  y.inner_iterations = x.inner_iterations;
  y.converged = x.converged;
  return y;
}

Curve scheme_curve(const Scene& scene, const Approach& approach, const std::vector<double>& at) {
  const PrintedSolution x = run_scheme(scene, approach);
  Curve curve{{}, x.converged};
  for (const double s : at) {
    PrintedSolution others = x;
    others.slip = ((x.grid.t.array() - s).abs() <= 4 * epsilon).select(0, x.slip);
    curve.points.push_back({s, printed_temperature(others, scene.peclet, s), std::nullopt});
  }
  return curve;
}

}  // namespace

Solution solve(const Scene& scene, const Approach& approach) {
  check(scene);
  return approach.method == Method::closed_form ? solve_closed_form(scene, approach)
                                                : solve_gauss_chebyshev(scene, approach);
}

PhysicalResults in_si_units(const Solution& x, const PhysicalCase& c) {
  const Units unit = units_of(c, x.scene.friction);
  const double hertz = hertz_half_width(x.value.load_ratio * c.load, 1, c.shear_modulus, c.poisson);
  return {c.half_width,
          c.half_width * c.half_width / (hertz * hertz),
          x.value.creep * unit.slip / c.speed,
          2 / pi * unit.traction,
          x.peak.pressure * unit.traction,
          x.peak.traction * unit.traction,
          x.peak.heat_flux * unit.heat_flux,
          x.value.max_temperature * unit.temperature};
}

double half_width_of_radius(PhysicalCase c, double radius, double friction, double traction,
                            const Approach& approach) {
  require(radius > 0, "radius", radius, "positive");
  c.half_width = radius;  // any positive length, for the check
  check(c);
  double kappa = 1;
  for (int step = 0; step < 50 && kappa > 0; ++step) {
    const double before = kappa;
    c.half_width = hertz_half_width(kappa * c.load, radius, c.shear_modulus, c.poisson);
    kappa = solve(scene_of(c, friction, traction), approach).value.load_ratio;
    if (std::abs(kappa - before) <= 1e-9 * before) return c.half_width;
  }
  throw NotConverged("no half-width found for radius = " + std::to_string(radius) + " m");
}

Curve temperature_curve(const Scene& scene, const Approach& approach, const std::vector<double>& at,
                        double depth) {
  check(scene);
  require(depth >= 0, "depth", depth, "zero or positive");
  if (approach.method == Method::gauss_chebyshev) {
    require(depth == 0, "depth", depth, "0 with gauss-chebyshev, whose rule is for the surface");
    return scheme_curve(scene, approach, at);
  }
  Curve curve;
  const HeatFlux flux = carter_flux(carter(scene.friction, scene.traction));
  for (const double s : at) {
    const Estimate t = temperature(flux, scene.peclet, s, depth);
    curve.points.push_back({s, t.value, t.error});
  }
  return curve;
}

}  // namespace thermoroll
