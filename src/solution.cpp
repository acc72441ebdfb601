// Tangled from paper/A-command-line.md; edit there.
#include "solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "least_model.hpp"
#include "numbers.hpp"
#include "quadrature.hpp"
#include "surface.hpp"
#include "temperature.hpp"

namespace thermoroll {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double& the_given_one(Results& x, const Given& given) {
  if (given.quantity == creep) return x.creep;
  return given.quantity == border ? x.stick_slip_border : x.traction;
}

Results named(const Values& x, double eccentricity) {
  return {x(traction), x(border),    x(creep_constant), x(creep),   x(load_ratio),
          x(gamma0),   eccentricity, x(heat),           x(hottest), x(hottest_at)};
}

std::string name_of(Model model) {
  if (model == Model::closed_form) return "closed-form";
  return model == Model::first_order ? "first-order" : "coupled";
}

Choice choose(const Scene& scene, const Approach& a, const Given& given) {
  const std::string asked = "asked for";
  if (a.method == Method::coupled)
    return {Model::coupled, asked, solve_coupled(scene, a.formulation, a.tolerance, given)};
  if (a.method == Method::first_order)
    return {Model::first_order, asked, first_order(scene, a.formulation, a.tolerance, given)};
  return least_model(scene, a.formulation, a.tolerance, given);
}

Solution solve_to_tolerance(Scene scene, const Approach& approach, const Given& given) {
  const double tolerance = approach.tolerance;
  require(1e-11 <= tolerance && tolerance <= 1e-2, "tolerance", tolerance, "from 1e-11 to 1e-2");
  const auto [model, reason, x] = choose(scene, approach, given);
  if (!x.error.allFinite())
    throw std::runtime_error(name_of(model) + ": heat is too strong for one linear correction");
  const Values &v = x.value, &e = x.error;
  const double kappa = v(load_ratio);
  const double drift = pi / (2 * kappa) * (e(gamma0) + std::abs(v(gamma0)) / kappa * e(load_ratio));
  Results value = named(v, x.eccentricity), error = named(e, drift);
  the_given_one(value, given) = given.value;
  the_given_one(error, given) = 0;
  scene.traction = value.traction;
  return {scene, approach, value, error, x, true, name_of(model), reason, x.violations};
}

Solution solve_closed_form(Scene scene, const Approach& approach, const Given& given) {
  const Carter c = carter_given(scene.friction, given);
  const Peak top = hottest_point(smooth_flux(c), scene.peclet, 1e-9);
  const Estimate t = top.temperature;
  const double heat = carter_heat(c), xi = c.creep, xi_error = 4 * epsilon * xi;
  const double q = scene.friction * c.slip_half_width * (1 + c.b);
  Results value{q, c.c0, xi, xi, 1, 0, 0, heat, t.value, top.at};
  Results error{4 * epsilon * q,    3 * epsilon, xi_error,    xi_error, 0, 0, 0,
                8 * epsilon * heat, t.error,     top.at_error};
  the_given_one(value, given) = given.value;
  the_given_one(error, given) = 0;
  scene.traction = value.traction;
  return {scene, approach, value, error, c, true, name_of(Model::closed_form), "asked for"};
}

PrintedSolution run_scheme(const Scene& scene, const Approach& approach) {
  const int n = approach.nodes;
  require(3 <= n && n <= 5000, "nodes", n, "from 3 to 5000");
  PrintedOptions options;
  options.nodes = n;
  try {
    return solve_printed(scene, approach.formulation, options);
  } catch (const std::bad_alloc&) {
    throw std::runtime_error("gauss-chebyshev with " + std::to_string(n) + " nodes needs " +
                             fixed(4e-6 * n * n * sizeof(double), 0) +
                             " MB of memory, too much here");
  }
}

Solution solve_gauss_chebyshev(const Scene& scene, const Approach& approach) {
  const PrintedSolution x = run_scheme(scene, approach);
  const PrintedPeak top = printed_max_temperature(x, scene.peclet);
  const double eccentricity = pi * x.gamma0 / (2 * x.load_ratio), heat = node_heat(x).sum();
  const Results value{scene.traction, x.c0, x.creep_constant, x.creep, x.load_ratio, x.gamma0,
                      eccentricity,   heat, top.temperature,  top.at};
  Solution solution{scene, approach, value, std::nullopt, x, x.converged};
  solution.violations = violations(factors(x, scene.friction));
  return solution;
}

Curve scheme_curve(const Scene& scene, const PrintedSolution& x, const std::vector<double>& at) {
  Curve curve{{}, x.converged};
  for (const double s : at) {
    PrintedSolution others = x;
    others.slip = ((x.grid.t.array() - s).abs() <= 4 * epsilon).select(0, x.slip);
    curve.points.push_back({s, printed_temperature(others, scene.peclet, s), std::nullopt});
  }
  return curve;
}

Eigen::ArrayXd carter_points(const Carter& c, Eigen::Index zone) {
  const Eigen::ArrayXd angle = Eigen::ArrayXd::LinSpaced(zone + 1, 0, pi / 2);
  Eigen::ArrayXd s(2 * zone + 1);
  s.tail(zone + 1) = c.c0 + 2 * c.slip_half_width * angle.sin().square();
  s.head(zone + 1) = -1 + 2 * c.b * angle.sin().square();
  s(zone) = c.c0, s(2 * zone) = 1;
  return s;
}

Profile carter_profile(const Scene& scene, const Carter& c) {
  constexpr Eigen::Index zone = 100;  // intervals to each zone
  const Eigen::ArrayXd s = carter_points(c, zone);
  const SurfaceCurve surface = surface_curve(smooth_flux(c), scene.peclet, s, 1e-9);
  Profile x{s, s, s, s, s, surface.temperature};
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    x.pressure(i) = hertz_pressure(s(i));
    x.traction(i) = carter_traction(c, s(i));
    x.slip(i) = carter_slip(c, s(i));
    x.heat_flux(i) = x.slip(i) * x.pressure(i);
  }
  return x;
}

Peaks peaks_of(const Solution&, const Carter& c) {
  const double h = c.slip_half_width, middle = 3 * h - 2 * c.b;
  const double root = std::sqrt(middle * middle + 16 * h * c.b);
  const double u = middle > 0 ? (middle + root) / (8 * h) : 2 * c.b / (root - middle);
  return {hertz_pressure(0), c.friction * hertz_pressure(std::max(c.c0, 0.0)),
          carter_flux(c).density(2 * h * u, 2 * h * (1 - u))};
}

Peaks peaks_of(const Solution& solution, const PrintedSolution& x) {
  Peaks peak{0, 0, 0};
  for (Eigen::Index k = 0; k < x.grid.t.size(); ++k) {
    const double s = x.grid.t(k), pressure = printed_pressure(x, s);
    peak.pressure = std::max(peak.pressure, pressure);
    peak.traction = std::max(peak.traction, printed_traction(x, solution.scene.friction, s));
    peak.heat_flux = std::max(peak.heat_flux, pressure * x.slip(k));
  }
  return peak;
}

/// y at a point, by the polynomial through the five nodes about it.
double by_five(const Eigen::ArrayXd& s, const Eigen::ArrayXd& y, double at) {
  const Eigen::Index above = (s < at).count();
  const Eigen::Index first = std::clamp<Eigen::Index>(above - 2, 0, s.size() - 5);
  double sum = 0;
  for (Eigen::Index i = first; i < first + 5; ++i) {
    double term = y(i);
    for (Eigen::Index j = first; j < first + 5; ++j)
      if (j != i) term *= (at - s(j)) / (s(i) - s(j));
    sum += term;
  }
  return sum;
}

/// The largest value of a curve and where it is.
struct Top {
  double at, value;
};

/// From the largest y at the nodes s to the top of the curve between its neighbours.
template <class Function>
Top top(const Eigen::ArrayXd& s, const Eigen::ArrayXd& y, const Function& curve) {
  Eigen::Index k = 0;
  const double highest = y.maxCoeff(&k);
  if (k == 0 || k == s.size() - 1) return {s(k), highest};
  const auto depth = [&](double at) { return -curve(at); };
  const double at = minimum(depth, s(k - 1), s(k), s(k + 1));
  return {at, curve(at)};
}

Peaks peaks_of(const Solution& solution, const CoupledSolution& x) {
  const Profile y = profile(solution);
  const double c0 = x.value(border);
  const HeatFlux flux = coupled_flux(x);
  const Eigen::ArrayXd factor = y.pressure / ((1 - y.s) * (1 + y.s)).sqrt();
  const auto pressure = [&](double s) {
    return std::sqrt((1 - s) * (1 + s)) * by_five(y.s, factor, s);
  };
  const auto heat_flux = [&](double s) { return s > c0 ? flux.density(s - c0, 1 - s) : 0; };
  const Top p = top(y.s, y.pressure, pressure);
  return {p.value, solution.scene.friction * (p.at < c0 ? pressure(c0) : p.value),
          top(y.s, y.heat_flux, heat_flux).value};
}

}  // namespace

Solution solve(const Scene& scene, const Approach& approach, const Given& given) {
  check_given(scene, given);
  if (approach.method == Method::closed_form) return solve_closed_form(scene, approach, given);
  if (approach.method != Method::gauss_chebyshev) return solve_to_tolerance(scene, approach, given);
  if (given.quantity != traction)
    throw std::invalid_argument("gauss-chebyshev needs the traction: it cannot start from another");
  return solve_gauss_chebyshev(scene, approach);
}

Solution solve(const Scene& scene, const Approach& approach) {
  return solve(scene, approach, {traction, scene.traction});
}

Profile profile(const Solution& x) {
  if (const auto* found = std::get_if<CoupledSolution>(&x.found)) {
    Scene scene = x.scene;
    if (x.model == name_of(Model::closed_form)) scene.heating = 0;  // as its tractions are
    return profile(scene, x.approach.formulation, *found);
  }
  if (const auto* closed = std::get_if<Carter>(&x.found)) return carter_profile(x.scene, *closed);
  throw std::invalid_argument(
      "gauss-chebyshev has no profile: at its nodes, where it knows the slip velocity, its "
      "temperature is infinite");
}

Peaks peaks(const Solution& x) {
  return std::visit([&](const auto& found) { return peaks_of(x, found); }, x.found);
}

PhysicalResults in_si_units(const Solution& x, const PhysicalCase& c) {
  const Units unit = units_of(c, x.scene.friction);
  const Peaks peak = peaks(x);
  const double hertz = hertz_half_width(x.value.load_ratio * c.load, 1, c.shear_modulus, c.poisson);
  return {c.half_width,
          c.half_width * c.half_width / (hertz * hertz),
          x.value.creep * unit.slip / c.speed,
          2 / pi * unit.traction,
          peak.pressure * unit.traction,
          peak.traction * unit.traction,
          peak.heat_flux * unit.heat_flux,
          x.value.max_temperature * unit.temperature};
}

void require_contact(const Solution& x) {
  if (!x.converged)
    throw NotConverged("the iteration did not converge; what is written is its last iterate");
  if (x.violations.empty()) return;
  const Violation& first = x.violations.front();
  throw NoContact("what is written solves the equations, but is no contact: " + first.what +
                  " at s = " + shortest(first.from) + " to " + shortest(first.to));
}

double half_width_of_radius(PhysicalCase c, double radius, double friction, const Given& given,
                            const Approach& approach) {
  require(radius > 0, "radius", radius, "positive");
  c.half_width = radius;  // any positive length, for the check
  check(c);
  double kappa = 1;
  for (int step = 0; step < 50 && kappa > 0; ++step) {
    const double before = kappa;
    c.half_width = hertz_half_width(kappa * c.load, radius, c.shear_modulus, c.poisson);
    const Solution x = solve(scene_of(c, friction, given.value), approach, given);
    kappa = x.value.load_ratio;
    const double error = x.error ? x.error->load_ratio : 0;
    if (std::abs(kappa - before) <= 1e-9 * before + error) return c.half_width;
  }
  throw NotConverged("no half-width found for radius = " + shortest(radius) + " m");
}

Curve temperature_curve(const Solution& x, const std::vector<double>& at, double depth) {
  require(depth >= 0, "depth", depth, "zero or positive");
  if (const auto* scheme = std::get_if<PrintedSolution>(&x.found)) {
    require(depth == 0, "depth", depth, "0 with gauss-chebyshev, whose rule is for the surface");
    return scheme_curve(x.scene, *scheme, at);
  }
  const auto* coupled = std::get_if<CoupledSolution>(&x.found);
  const Carter* closed = std::get_if<Carter>(&x.found);
  const double flux_error = coupled ? x.error->max_temperature : 0;
  Curve curve;
  if (depth == 0) {
    const auto points = static_cast<Eigen::Index>(at.size());
    const Eigen::ArrayXd s = Eigen::Map<const Eigen::ArrayXd>(at.data(), points);
    const SmoothFlux flux = coupled ? smooth_flux(*coupled) : smooth_flux(*closed);
    const double tolerance = std::min(x.approach.tolerance, 1e-8) / 2;
    const SurfaceCurve found = surface_curve(flux, x.scene.peclet, s, tolerance);
    for (Eigen::Index i = 0; i < s.size(); ++i)
      curve.points.push_back({s(i), found.temperature(i), found.error + flux_error});
  } else {
    const HeatFlux flux = coupled ? coupled_flux(*coupled) : carter_flux(*closed);
    for (const double s : at) {
      const Estimate t = temperature(flux, x.scene.peclet, s, depth);
      curve.points.push_back({s, t.value, t.error + flux_error});
    }
  }
  return curve;
}

}  // namespace thermoroll
