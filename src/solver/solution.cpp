// Tangled from paper/19-braking-and-alike-bodies.md, paper/A-one-answer.md; edit there.
#include "thermoroll/solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "solver/contact_grid.hpp"
#include "solver/curves.hpp"
#include "solver/full_slip.hpp"
#include "solver/grid_solution.hpp"
#include "solver/least_model.hpp"
#include "solver/surface.hpp"
#include "support/number_text.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {

using enum Quantity;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

void set_given(const Prescribed& given, Results& value, Results& error) {
  value(given.quantity) = given.value;
  error(given.quantity) = 0;
}

Solution solve_to_tolerance(const Scene& scene, const Approach& approach, const Prescribed& given) {
  const auto [model, reason, x] = solve_by_method(scene, approach, given);
  if (!x.error.allFinite()) throw NotConverged("no finite error was found");
  Results value = x.value, error = x.error;
  set_given(given, value, error);
  return {scene, approach, value, error, x, true, model, reason, x.violations, x.trace};
}

Solution solve_closed_form(const Scene& scene, const Approach& approach, const Prescribed& given) {
  const Carter c = carter_given(scene.friction, given, scene.direction);
  const Peak top = hottest_point(smooth_flux(c), Conduction(scene), 1e-9);
  Results value = carter_values(c), error = Results::Zero();
  value(max_temperature) = heat_share(scene) * top.temperature.value;
  value(max_temperature_at) = top.at;
  error(stick_slip_border) = error(slip_length) = 3 * epsilon;
  for (const Quantity q : {traction, creep_constant, creep}) error(q) = 4 * epsilon * value(q);
  error(heat_integral) = 8 * epsilon * value(heat_integral);
  error(max_temperature) = heat_share(scene) * top.temperature.error;
  error(max_temperature_at) = top.at_error;
  set_given(given, value, error);
  return {scene, approach, value, error, c, true, Model::closed_form, "asked for"};
}

PublishedSolution run_scheme(const Scene& scene, double traction, const Approach& approach) {
  const int n = approach.nodes;
  require(3 <= n && n <= 5000, "nodes", n, "from 3 to 5000");
  PublishedOptions options;
  options.nodes = n;
  try {
    return solve_published(scene, traction, approach.formulation, options);
  } catch (const std::bad_alloc&) {
    throw std::runtime_error("gauss-chebyshev with " + std::to_string(n) + " nodes needs " +
                             fixed(4e-6 * n * n * sizeof(double), 0) +
                             " MB of memory, too much here");
  }
}

Solution solve_gauss_chebyshev(const Scene& scene, double traction, const Approach& approach) {
  const PublishedSolution x = run_scheme(scene, traction, approach);
  const PublishedPeak top = published_max_temperature(x, scene.peclet);
  Results value, no_error = Results::Zero();
  value << x.c0, 1 - x.c0, traction, x.creep_constant, x.creep, x.load_ratio, x.gamma0,
      node_heat(x).sum(), top.temperature, top.at, 0;
  add_eccentricity(value, no_error);
  Solution solution{scene, approach, value, std::nullopt, x, x.converged};
  solution.violations = violations(factors(x, scene.friction));
  return solution;
}

void check_with_sign(const Scene& scene, const Prescribed& given) {
  check(given.quantity);
  const double x = given.value, friction = scene.friction;
  const std::string range = "between -" + shortest(friction) + " and " + shortest(friction);
  if (given.quantity == traction && !scene.law)
    require(std::abs(x) <= friction, "traction", x, range + ", the friction");
  if (given.quantity != stick_slip_border && x != 0)
    require(!(std::abs(x) < 1e-150), given.quantity == traction ? "traction" : "creep", x,
            "0 or at least 1e-150 in size");
}

void check_tolerance(double tolerance) {
  require(1e-11 <= tolerance && tolerance <= 1e-2, "tolerance", tolerance, "from 1e-11 to 1e-2");
}

std::string range_of_traction(double friction) {
  return "the traction is between -" + shortest(friction) + " and " + shortest(friction);
}

void check_branch(const Scene& scene, const Prescribed& given) {
  if (given.branch == Branch::rising) return;
  const bool by_traction = given.quantity == traction;
  if (!by_traction)
    throw std::invalid_argument("branch = falling is not allowed: no traction is given");
  if (!scene.law)
    throw std::invalid_argument("branch = falling is not allowed: friction is constant, and " +
                                range_of_traction(scene.friction));
}

bool is_without_slip(const Prescribed& given) {
  return given.quantity != stick_slip_border && given.value == 0;
}

Solution solve_without_slip(const Scene& scene, const Approach& approach, const Prescribed& given) {
  if (given.branch == Branch::falling)
    throw std::invalid_argument("branch = falling is not allowed: without traction nothing slips");
  const Carter c{scene.friction, 1, 0, 1, 0};
  Results value = carter_values(c);
  value(max_temperature_at) = 1;
  const std::string reason = "without traction nothing slips";
  return {scene, approach, value, Results::Zero(), c, true, Model::closed_form, reason};
}

Scene directed(Scene scene, const Prescribed& given) {
  if (given.quantity == stick_slip_border) return scene;
  const NoSlip rest = no_slip_near(scene, given);
  const double least = given.quantity == traction ? rest.traction : rest.creep;
  scene.direction = given.value < least ? Direction::braking : Direction::driving;
  return scene;
}

void turn(Solution& x) {
  const double sign = sign_of(x.scene.direction);
  x.value(traction) *= sign;
  x.value(creep) *= sign;
}

/// The solution of a scene that drives, or of a braking one turned round.
Solution solve_turned(const Scene& scene, const Prescribed& given, const Approach& approach) {
  const bool scheme = approach.method == Method::gauss_chebyshev;
  if (!scheme && scene.bulk_difference == 0 && is_without_slip(given))
    return solve_without_slip(scene, approach, given);
  if (given.quantity == traction && given.value == scene.friction && !scene.law)
    refuse_undetermined_creep(scene, approach.formulation);
  check(scene, given);
  if (approach.method == Method::closed_form) return solve_closed_form(scene, approach, given);
  if (!scheme) return solve_to_tolerance(scene, approach, given);
  if (given.quantity != traction)
    throw std::invalid_argument("gauss-chebyshev needs the traction, and no creep or border");
  return solve_gauss_chebyshev(scene, given.value, approach);
}

Curve scheme_curve(const Scene& scene, const PublishedSolution& x, const std::vector<double>& at) {
  Curve curve{{}, x.converged};
  for (const double s : at) {
    PublishedSolution others = x;
    others.slip = ((x.grid.t.array() - s).abs() <= 4 * epsilon).select(0, x.slip);
    curve.points.push_back({s, published_temperature(others, scene.peclet, s), std::nullopt});
  }
  return curve;
}

/// To nine digits of itself or of the scale; else to the tolerance of the largest.
Estimate temperature_below(const HeatFlux& flux, const Solution& x, double s, double depth,
                           double scale) {
  const double tolerance = x.approach.tolerance;
  const double enough = 1e9 * tolerance * scale_in(x.scene, x.value)(max_temperature);
  for (const double least : {scale, std::max(scale, enough)}) try {
      return temperature(flux, x.scene.peclet, s, depth, least);
    } catch (const std::runtime_error&) {
    }
  throw std::runtime_error("the temperature at s = " + shortest(s) + ", depth = " +
                           shortest(depth) + " is not resolved to " + shortest(tolerance));
}

/// In temperatures on the surface, by the flux for a grid of n unknowns.
double error_of_bulk_flux(const Scene& scene, int n, const Eigen::ArrayXd& s) {
  const auto temperature_with = [&](int unknowns) -> Eigen::ArrayXd {
    const auto bulk = bulk_exchange(scene, unknowns);
    return temperature_of({{2, 0}, scene.bulk_difference * bulk->flux, {}}, scene.peclet, s);
  };
  const auto own = static_cast<int>(bulk_exchange(scene, n)->flux.size());
  const int other = own <= most_unknowns / 2 ? 2 * own : own / 2;
  return 2 * (temperature_with(other) - temperature_with(n)).abs().maxCoeff();
}

/// In temperatures on the surface; 0 where it is not solved for.
double error_of_crossing_flux(const CoupledSolution& x, SmoothFlux by, const Eigen::ArrayXd& s) {
  if (!exchanges(x.scene, by.zones())) return 0;
  Scene alone = x.scene;
  alone.bulk_difference = 0;
  const auto temperature_with = [&](int nodes) {
    Eigen::ArrayXd all = Eigen::ArrayXd::Zero(s.size());
    for (const ExchangedFlux& e : exchanged_fluxes(alone, x.formulation, by, nodes))
      all += temperature_of(e, alone.peclet, s);
    return all;
  };
  const Eigen::ArrayXd own = temperature_with(x.unknowns);
  const int other = x.unknowns <= 360 ? 4 * x.unknowns / 3 : 3 * x.unknowns / 4;
  if (other < x.unknowns) by.h.conservativeResize(other);
  return 4 * (temperature_with(other) - own).abs().maxCoeff();
}

SurfaceCurve on_surface(const Solution& x, const Eigen::ArrayXd& s) {
  const auto* coupled = std::get_if<CoupledSolution>(&x.found);
  const SmoothFlux flux = coupled ? smooth_flux(*coupled) : smooth_flux(std::get<Carter>(x.found));
  const double tolerance = std::min(x.approach.tolerance, 1e-8) / 2, share = heat_share(x.scene);
  const Conduction conduction(x.scene, !exchanges(x.scene, flux.zones()));
  const SurfaceCurve found = surface_curve(flux, conduction, s, tolerance);
  SurfaceCurve all{share * found.temperature, share * found.error};
  if (!coupled) return all;
  for (const ExchangedFlux& e : crossing_flux(*coupled))
    all.temperature += temperature_of(e, x.scene.peclet, s);
  all.error += error_of_crossing_flux(*coupled, flux, s);
  if (x.scene.bulk_difference != 0) all.error += error_of_bulk_flux(x.scene, coupled->unknowns, s);
  return all;
}

double error_of_moved_flux(const Solution& x) {
  const Results& error = *x.error;
  const bool all_slips = x.value(stick_slip_border) == -1;
  if (x.model != Model::closed_form || !all_slips) return 0;
  const double of_heat = error(heat_integral) / x.value(heat_integral);
  return 2.5 * (error(load_ratio) + error(gamma0) + of_heat) * x.value(max_temperature);
}

double flux_error(const Solution& x) {
  if (!std::holds_alternative<CoupledSolution>(x.found) || x.value(slip_length) == 0) return 0;
  const auto place = Eigen::ArrayXd::Constant(1, x.value(max_temperature_at));
  const double top = on_surface(x, place).temperature(0);
  const double missed = 2 * std::abs(top - x.value(max_temperature));
  return std::max((*x.error)(max_temperature) + missed, error_of_moved_flux(x));
}

Eigen::ArrayXd without_underflow(const Eigen::ArrayXd& x) {
  return (x.abs() < std::numeric_limits<double>::min()).select(0, x);
}

/// How many intervals lie between the points in each zone.
struct Intervals {
  Eigen::Index stick, slip;
};

Eigen::ArrayXd carter_points(const Carter& c, const Intervals& of) {
  const auto shares = [](Eigen::Index n) -> Eigen::ArrayXd {
    return Eigen::ArrayXd::LinSpaced(n + 1, 0, pi / 2).sin().square();
  };
  Eigen::ArrayXd s(of.stick + of.slip + 1);
  s.tail(of.slip + 1) = c.c0 + 2 * c.slip_half_width * shares(of.slip);
  s.head(of.stick) = -1 + 2 * c.b * shares(of.stick).head(of.stick);
  s(of.stick) = c.c0;
  s(of.stick + of.slip) = 1;
  return s;
}

Intervals plot_intervals(int points, double stick, double slip) {
  const Eigen::Index all = points - 1;
  if (stick == 0) return {0, all};
  return slip == 0 ? Intervals{all, 0} : Intervals{(all + 1) / 2, all / 2};
}

PlotPoints plot_points(const CoupledSolution& x, int points) {
  const double slip = x.value(slip_length), stick = 1 + x.value(stick_slip_border);
  const Intervals of = plot_intervals(points, stick, slip);
  const double edge = x.scene.bulk_difference == 0 ? 1 : 1 - 1.0 / points;
  const double border = stick == 0 ? -edge : -1;
  return {Eigen::ArrayXd::LinSpaced(of.stick + 1, edge, -1).head(of.stick),
          Eigen::ArrayXd::LinSpaced(of.slip + 1, border, edge)};
}

Peaks carter_peaks(const Carter& c) {
  const double h = c.slip_half_width, middle = 3 * h - 2 * c.b, highest = hertz_pressure(0);
  const double root = std::sqrt(middle * middle + 16 * h * c.b);
  const double u = middle > 0 ? (middle + root) / (8 * h) : 2 * c.b / (root - middle);
  const double at_border = 2 * std::sqrt(h * c.b) * highest;
  return {highest, c.friction * (c.c0 > 0 ? at_border : highest),
          carter_flux(c).density(2 * h * u, 2 * h * (1 - u))};
}

Peaks scheme_peaks(const PublishedSolution& x, double friction) {
  Peaks peak{0, 0, 0};
  for (Eigen::Index k = 0; k < x.grid.t.size(); ++k) {
    const double s = x.grid.t(k), pressure = published_pressure(x, s);
    peak.pressure = std::max(peak.pressure, pressure);
    peak.traction = std::max(peak.traction, published_traction(x, friction, s));
    peak.heat_flux = std::max(peak.heat_flux, pressure * x.slip(k));
  }
  return peak;
}

/// Through the best point and those beside it; of that at an end, its value.
double parabola_top(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y, Eigen::Index best) {
  if (best == 0 || best == x.size() - 1) return y(best);
  const double before = x(best - 1) - x(best), after = x(best + 1) - x(best);
  const double left = (y(best - 1) - y(best)) / before, right = (y(best + 1) - y(best)) / after;
  const double bend = (left - right) / (before - after), slope = left - bend * before;
  return y(best) - (bend < 0 ? slope * slope / (4 * bend) : 0);
}

/// The largest value of a curve and where it is.
struct Top {
  double at, value;
};

/// The maximum of a curve on -1 <= x <= 1, of which the values y at these points are known.
template <class Curve>
Top top(Eigen::ArrayXd x, Eigen::ArrayXd y, const Curve& curve) {
  for (double last = 0;;) {
    Eigen::Index best = 0;
    y.maxCoeff(&best);
    const double value = parabola_top(x, y, best);
    const double low = x(std::max<Eigen::Index>(best - 1, 0));
    const double high = x(std::min(best + 1, x.size() - 1));
    if (std::abs(value - last) <= 1e-14 * std::abs(value) || high - low < 1e-8)
      return {x(best), value};
    last = value;
    x = Eigen::ArrayXd::LinSpaced(9, low, high);
    y = curve(x);
  }
}

/// From one set of series to another, in the zone of each peak.
Peaks largest_change(const SmoothTractions& from, const SmoothTractions& to, double friction) {
  const Eigen::Index points = 4 * std::max(from.h.size(), from.bracket.size()) + 1;
  const Eigen::ArrayXd x = -Eigen::ArrayXd::LinSpaced(points, 0, pi).cos();
  const Curves a = curves_at(x, from, friction), b = curves_at(x, to, friction);
  const auto change = [&](Eigen::ArrayXd Curves::*what) {
    const Eigen::ArrayXd moved = (a.*what - b.*what).abs(), size = (a.*what).abs();
    return (size > 0.99 * size.maxCoeff()).select(moved, 0).maxCoeff();
  };
  const auto of = [&](Eigen::ArrayXd Curves::*slip, Eigen::ArrayXd Curves::*stick) {
    const double inside = from.stick > 0 ? (a.*stick).tail(points - 1).abs().maxCoeff() : 0;
    return change(inside > (a.*slip).maxCoeff() ? stick : slip);
  };
  return {of(&Curves::slip_pressure, &Curves::stick_pressure),
          of(&Curves::slip_traction, &Curves::stick_traction), change(&Curves::heat_flux)};
}

int other_grid(int n) { return n > 320 ? 2 * n / 3 : 3 * n / 2; }

double relative_error_of_heat(const Solution& x) {
  const Results relative = *x.error / scale_in(x.scene, x.value);
  return std::max(relative(heat_integral), relative(max_temperature));
}

FoundPeaks found_peaks(const Solution& x, const CoupledSolution& found) {
  const int n = found.unknowns, other = other_grid(n);
  const double f = x.scene.friction, half = found.value(slip_length) / 2;
  CoupledSolution hot = found;
  hot.scene = x.scene;  // with heat, which the closed form leaves out
  const bool better = other > n && x.model == Model::coupled;
  const SmoothTractions changed_by = smooth_tractions(hot, other);
  const Peaks changed = largest(changed_by, f);
  const bool closed = x.model == Model::closed_form;
  Peaks own = carter_peaks({f, 1 - half, half, found.value(stick_slip_border), found.value(creep)});
  Peaks beside{};
  if (!closed || half == 1) {
    const SmoothTractions by = smooth_tractions(closed ? found : hot, n);
    own = largest(by, f);
    if (!closed) beside = largest_change(by, changed_by, f);
  }
  const double e = relative_error_of_heat(x);
  const auto error = [&](double Peaks::*what) {
    return 2 * std::max(std::abs(changed.*what - own.*what), beside.*what) +
           e * std::abs(own.*what);
  };
  const Peaks errors{error(&Peaks::pressure), error(&Peaks::traction), error(&Peaks::heat_flux)};
  return {better ? changed : own, errors};
}

/// From one set of series to another.
ProfileErrors change_along(const SmoothTractions& from, const SmoothTractions& to,
                           double friction) {
  const Eigen::Index points = 4 * std::max(from.h.size(), from.bracket.size()) + 1;
  const Eigen::ArrayXd x = -Eigen::ArrayXd::LinSpaced(points, 0, pi).cos();
  const Curves a = curves_at(x, from, friction), b = curves_at(x, to, friction);
  const Curves ahead = curves_at(stick_places(x, from, to), to, friction);
  const auto of = [&](Eigen::ArrayXd Curves::*slip, Eigen::ArrayXd Curves::*stick) {
    const double inside = from.stick > 0 ? (a.*stick - ahead.*stick).abs().maxCoeff() : 0;
    return std::max((a.*slip - b.*slip).abs().maxCoeff(), inside);
  };
  return {of(&Curves::slip_pressure, &Curves::stick_pressure),
          of(&Curves::slip_traction, &Curves::stick_traction), (a.slip - b.slip).abs().maxCoeff(),
          (a.heat_flux - b.heat_flux).abs().maxCoeff(), 0};
}

/// Of a profile before it is turned round.
ProfileErrors errors_along(const Solution& x, const Profile& y, const Curve& temperatures) {
  double rounding = 8 * epsilon, hot = 0;
  for (const CurvePoint& at : temperatures.points) hot = std::max(hot, *at.error);
  ProfileErrors moved{};
  if (const auto* found = std::get_if<CoupledSolution>(&x.found)) {
    CoupledSolution with_heat = *found;
    with_heat.scene = x.scene;
    const SmoothTractions own = smooth_tractions(*found, found->unknowns);
    const SmoothTractions other = smooth_tractions(with_heat, other_grid(found->unknowns));
    moved = change_along(own, other, x.scene.friction);
    rounding = relative_error_of_heat(x);
  }
  const auto error = [&](double change, const Eigen::ArrayXd& curve) {
    return 2 * change + rounding * curve.abs().maxCoeff();
  };
  return {error(moved.pressure, y.pressure), error(moved.traction, y.traction),
          error(moved.slip, y.slip), error(moved.heat_flux, y.heat_flux), hot};
}

void share_heat_flux(const Solution& x, Profile& y) {
  y.heat_flux_1 = heat_share(x.scene) * y.heat_flux;
  if (const auto* found = std::get_if<CoupledSolution>(&x.found))
    y.heat_flux_1 += exchanged_heat_flux(*found, y.s);
  y.heat_flux_2 = y.heat_flux - y.heat_flux_1;
}

void add_friction(const Scene& scene, Profile& y) {
  y.friction = y.temperature;
  for (double& at : y.friction) at = scene.friction * scene.law(at).value;
}

void require_profile(const Solution& x) {
  if (std::holds_alternative<PublishedSolution>(x.found))
    throw std::invalid_argument(
        "gauss-chebyshev has no profile: at its nodes, where it knows the slip velocity, its "
        "temperature is infinite");
}

Profile finished(const Solution& x, Profile y, const Curve& temperatures) {
  y.error = errors_along(x, y, temperatures);
  y.temperature = without_underflow(y.temperature);
  if (x.scene.roller.conductivity_ratio > 0) share_heat_flux(x, y);
  if (x.scene.law) add_friction(x.scene, y);
  if (x.scene.direction == Direction::braking) {
    y.traction = 0 - y.traction;  // no zero becomes negative
    y.slip = 0 - y.slip;
  }
  return y;
}

Profile carter_profile(const Solution& x, const Carter& c, const Eigen::ArrayXd& s) {
  Profile y{s, s, s, s, s, 0 * s};
  const Curve curve = temperature_curve(x, {s.begin(), s.end()}, 0);
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    y.pressure(i) = hertz_pressure(s(i));
    y.traction(i) = carter_traction(c, s(i));
    y.slip(i) = carter_slip(c, s(i));
    y.heat_flux(i) = y.slip(i) * y.pressure(i);
    y.temperature(i) = curve.points[static_cast<std::size_t>(i)].temperature;
  }
  return finished(x, y, curve);
}

/// Results and peaks, or their errors, in SI units; without the sizes and Hertz's pressure.
PhysicalResults converted(const Results& x, const Peaks& peak, const Units& unit,
                          const PhysicalScene& si) {
  PhysicalResults y{};
  y.creep_ratio = x(creep) * unit.slip / si.speed;
  y.max_pressure = peak.pressure * unit.traction;
  y.max_traction = peak.traction * unit.traction;
  y.max_heat_flux = peak.heat_flux * unit.heat_flux;
  y.max_temperature_celsius = x(max_temperature) * unit.temperature;
  y.dissipation = x(heat_integral) * unit.heat_flux * si.half_width;
  y.tangential_load = x(traction) * si.load;
  y.max_temperature_at_m = x(max_temperature_at) * si.half_width;
  return y;
}

void set_sizes(PhysicalResults& y, const PhysicalScene& si, double load_ratio) {
  const double size = std::abs(load_ratio) * si.load;
  const double hertz = hertz_half_width(size, 1, si.shear_modulus, si.poisson);
  y.half_width = si.half_width;
  y.radius = std::copysign(si.half_width * si.half_width / (hertz * hertz), load_ratio);
  y.hertz_pressure = 2 / pi * (si.load / si.half_width);
  y.half_width_over_radius = std::copysign(hertz * hertz / si.half_width, load_ratio);
}

bool is_of_a_wheel(const PhysicalResults& x, double least) {
  return x.hertz_pressure < least && x.half_width <= 0.1;
}

bool is_a_room_in_kelvin(double bulk) { return 273 <= bulk && bulk <= 313; }

double largest_friction(const Solution& x) {
  const Scene& scene = x.scene;
  if (!scene.law) return scene.friction;
  return scene.friction * std::max(1.0, scene.law(x.value(max_temperature)).value);
}

double capacity_1(const PhysicalScene& si) { return si.conductivity / si.diffusivity; }

double capacity_2(const PhysicalScene& si) { return si.conductivity_2 / diffusivity_2(si); }

double grueneisen_1(const PhysicalScene& si) {
  return grueneisen(capacity_1(si), si.expansion, si.shear_modulus, si.poisson);
}

double grueneisen_2(const PhysicalScene& si) {
  if (!(si.expansion_2 > 0)) return 0;
  return grueneisen(capacity_2(si), si.expansion_2, si.shear_modulus, si.poisson);
}

std::vector<std::string> beyond_the_model(const PhysicalResults& x, const PhysicalScene& si,
                                          double friction) {
  struct Limit {
    const char* name;
    double value, most;
    const char *meaning, *question;
  };
  const char* units = "are all data in SI units and none in GPa or mm?";
  const char* melts = si.conductivity_2 > 0
                          ? "steel melts there"
                          : "steel melts there with all heat in one body: two steel bodies are "
                            "about half as hot";
  const char* of_gamma =
      "is the modulus that of shear and are expansion and diffusivity and conductivity in SI "
      "units?";
  const double hottest = x.max_temperature_celsius + si.bulk_temperature.value_or(0);
  const char* of_capacity = "solids have 1e6 to 4e6 J/(m^3 K)";
  const double gamma = grueneisen_1(si), gamma_2 = grueneisen_2(si);
  const Limit limits[] = {
      {"half_width_over_radius", x.half_width_over_radius, 0.1, "bodies are no half-spaces there",
       units},
      {"creep_ratio", x.creep_ratio, 0.1, "both surfaces have one speed in the model",
       "are all data in SI units and creeps no percentages?"},
      {"hertz_pressure", x.hertz_pressure, si.shear_modulus / 10, "a tenth of the shear modulus",
       units},
      {"half_width", x.half_width, 0.1, "rolling contacts are centimetres wide at most", units},
      {"friction", friction, 2, "solids have 0.01 to 1.5",
       si.law ? "is it a ratio and no percentage and does its law hold at such temperatures?"
              : "is it a ratio and no percentage?"},
      {"grueneisen", gamma, 3, "solids have 0.5 to 2", of_gamma},
      {"grueneisen_2", gamma_2 == gamma ? 0 : gamma_2, 30, "solids have 0.5 to 2", of_gamma},
      {"heat_capacity", capacity_1(si), 6e6, of_capacity, "do conductivity and diffusivity agree?"},
      {"heat_capacity_2", capacity_2(si) == capacity_1(si) ? 0 : capacity_2(si), 6e6, of_capacity,
       "is diffusivity-2 that of the roller's material?"},
      {"speed", si.speed, 300, "a tenth of that of shear waves in steel",
       "is it in m/s or in mm/s?"},
      {si.bulk_temperature ? "contact_temperature_celsius" : "max_temperature_celsius", hottest,
       1500, melts, units}};
  std::vector<std::string> notes;
  for (const auto& [name, value, most, meaning, question] : limits) {
    if (!(std::abs(value) > most)) continue;
    notes.push_back(std::string(name) + " = " + rounded(value, 3) +
                    (value > 0 ? " is above " : " is below -") + rounded(most, 4) + " (" + meaning +
                    "): " + question);
  }
  if (is_of_a_wheel(x, si.shear_modulus / 500))
    notes.push_back("hertz_pressure = " + rounded(x.hertz_pressure, 3) + " is below " +
                    rounded(si.shear_modulus / 500, 4) +
                    " (a five-hundredth of the shear modulus): is the load that of a metre of "
                    "the contact's width and a radius in m?");
  for (const auto& bulk : {si.bulk_temperature, si.bulk_temperature_2})
    if (bulk && is_a_room_in_kelvin(*bulk))
      notes.push_back("a bulk temperature of " + rounded(*bulk, 4) +
                      " would be that of a room in K: is it in degree C?");
  if (si.law && std::abs(si.law->of.scale) < 1)
    notes.push_back("friction_temperature = " + rounded(si.law->of.scale, 3) +
                    " is below 1 in size (a kelvin): is it in K and not in units of T*?");
  return notes;
}

}  // namespace

Solution solve(const Scene& scene, const Prescribed& given, const Approach& approach) {
  check(scene);
  check_with_sign(scene, given);
  check_method(scene, approach.method);
  check_branch(scene, given);
  if (approach.method != Method::gauss_chebyshev) check_tolerance(approach.tolerance);
  const Scene turned = directed(scene, given);
  const bool braking =
      given.quantity != stick_slip_border && turned.direction == Direction::braking;
  Solution x = solve_turned(
      turned, {given.quantity, braking ? -given.value : given.value, given.branch}, approach);
  turn(x);
  if (turned.law)
    for (int i = 0; i <= 32; ++i) check_friction(turned.law, i / 32.0 * x.value(max_temperature));
  return x;
}

struct Pull {
  double at, traction;  // with its sign
};

Pull strongest(const Eigen::ArrayXd& x, const SmoothTractions& by, double friction) {
  const auto traction = [&](const Eigen::ArrayXd& at) -> Eigen::ArrayXd {
    return curves_at(at, by, friction).stick_traction;
  };
  const auto size = [&](const Eigen::ArrayXd& at) -> Eigen::ArrayXd { return traction(at).abs(); };
  const Top q = top(x, size(x), size);
  return {q.at, std::copysign(q.value, traction(Eigen::ArrayXd::Constant(1, q.at))(0))};
}

Peaks largest(const SmoothTractions& by, double friction) {
  const Eigen::Index points = 4 * std::max(by.h.size(), by.bracket.size()) + 1;
  const Eigen::ArrayXd x = -Eigen::ArrayXd::LinSpaced(points, 0, pi).cos();
  const Curves all = curves_at(x, by, friction);
  const auto highest = [&](Eigen::ArrayXd Curves::*what) {
    return top(x, all.*what, [&](const Eigen::ArrayXd& close) -> Eigen::ArrayXd {
      return curves_at(close, by, friction).*what;
    });
  };
  const Top p = highest(&Curves::slip_pressure), flux = highest(&Curves::heat_flux);
  Peaks peak{p.value, friction * p.value, flux.value};
  if (by.bound.size() > 0) peak.traction = highest(&Curves::slip_traction).value;
  if (by.stick == 0) return peak;
  const Top stick_p = highest(&Curves::stick_pressure);
  if (stick_p.at > -1) peak.pressure = std::max(peak.pressure, stick_p.value);
  const Pull stick = strongest(x, by, friction);
  if (stick.at > -1 && std::abs(stick.traction) > peak.traction) peak.traction = stick.traction;
  return peak;
}

/// The peaks of a scene that is turned round, if it brakes.
FoundPeaks peaks_turned(const Solution& x) {
  if (const auto* scheme = std::get_if<PublishedSolution>(&x.found))
    return {scheme_peaks(*scheme, x.scene.friction), std::nullopt};
  if (const auto* found = std::get_if<CoupledSolution>(&x.found)) return found_peaks(x, *found);
  const Peaks exact = carter_peaks(std::get<Carter>(x.found));
  const double e = 8 * epsilon;
  return {exact, Peaks{e * exact.pressure, e * exact.traction, e * exact.heat_flux}};
}

FoundPeaks peaks(const Solution& x) {
  FoundPeaks found = peaks_turned(x);
  found.value.traction *= sign_of(x.scene.direction);
  return found;
}

Heats heats(const Solution& x) {
  const double all = x.value(heat_integral), left = x.error ? (*x.error)(heat_integral) : 0;
  const double uniform = heat_share(x.scene) * all;
  const double share = effusivity_share(x.scene), ratio = effusivity_ratio(x.scene);
  Estimate heat_1{share * all, share * left};
  Estimate heat_2{ratio * heat_1.value, ratio * heat_1.error};
  const auto* found = std::get_if<CoupledSolution>(&x.found);
  if (found != nullptr && found->crossing) {
    heat_1 = {uniform + found->crossing->heat, left + found->crossing->heat_error};
    heat_2 = {all - heat_1.value, heat_1.error};
  }
  return {heat_1, heat_2, {heat_1.value - uniform, heat_1.error}};
}

NoSlip no_slip(const Solution& x) {
  NoSlip still = no_slip(x.scene, x.approach.tolerance);
  still.traction_error += x.moved.traction_error;
  still.creep_error += x.moved.creep_error;
  return still;
}

std::string note_on_constant_friction(const Solution& x) {
  const auto* law = x.scene.law.target<LawOfFriction>();
  const double hottest = x.value(max_temperature);
  if (law == nullptr) return "";
  const std::string note = "friction does not change ";
  if (law->of.scale > 0 && law->of.floor == 1) return note + "(its floor is all of it)";
  if (!(hottest > 0)) return "";
  const double most = (*law)(std::min(0.0, x.scene.bulk_difference)).value;
  if (hottest <= law->of.reference)
    return note + "(the contact is nowhere as hot as its reference temperature)";
  if (law->of.scale > 0 && std::abs(most - law->of.floor) < 1e-4 * most)
    return note + "(all of the contact is so hot that it is at its floor)";
  return "";
}

std::vector<std::string> notes_on(const PhysicalScene& si, double friction, double creep_ratio,
                                  double rise) {
  PhysicalResults x{};
  set_sizes(x, si, 1);
  x.creep_ratio = creep_ratio;
  x.max_temperature_celsius = rise;
  return beyond_the_model(x, si, friction);
}

Prescribed dimensionless(const PhysicalScene& si, const Prescribed& given, CreepUnit unit) {
  if (unit == CreepUnit::scaled || given.quantity != creep) return given;
  return {creep, given.value * si.speed / units_of(si, 1).slip};
}

/// Relative, of a solution with errors.
double error_of_kappa(const Solution& x) {
  return (*x.error)(load_ratio) / std::abs(x.value(load_ratio));
}

FoundInSi in_si_units(const Solution& x, const PhysicalScene& si, bool from_radius,
                      CreepUnit given) {
  const Units unit = units_of(si, x.scene.friction);
  const FoundPeaks peak = peaks(x);
  FoundInSi y{converted(x.value, peak.value, unit, si), std::nullopt};
  set_sizes(y.value, si, x.value(load_ratio));
  y.data = si;
  y.notes = beyond_the_model(y.value, si, largest_friction(x));
  if (std::string note = note_on_constant_friction(x); !note.empty()) y.notes.push_back(note);
  if (si.bulk_temperature)
    y.contact_temperature_celsius = *si.bulk_temperature + y.value.max_temperature_celsius;
  const Heats heat = heats(x);
  const double of_size = from_radius && x.error ? 5e-10 + error_of_kappa(x) : 0;
  const auto in_units = [&](double all, const Estimate& own) -> Estimate {
    const double value = all * own.value;
    return {value, all * own.error + 2 * of_size * std::abs(value)};
  };
  const double watts = unit.heat_flux * si.half_width;
  y.heat_1 = in_units(watts, heat.into_half_space);
  y.heat_2 = in_units(watts, heat.into_cylinder);
  if (x.scene.bulk_difference != 0) {
    const NoSlip still = no_slip(x);
    y.exchanged_heat = in_units(watts, heat.exchanged);
    y.no_slip_load = in_units(si.load, {still.traction, still.traction_error});
    y.no_slip_creep_ratio = in_units(unit.slip / si.speed, {still.creep, still.creep_error});
  }
  if (!x.error) return y;
  y.error = converted(*x.error, *peak.error, unit, si);
  PhysicalResults& error = *y.error;
  const double of_kappa = error_of_kappa(x);
  error.half_width = of_size * y.value.half_width;
  error.radius = (of_kappa + 2 * of_size) * y.value.radius;
  error.half_width_over_radius = (of_kappa + of_size) * y.value.half_width_over_radius;
  for (const auto field :
       {&PhysicalResults::creep_ratio, &PhysicalResults::hertz_pressure,
        &PhysicalResults::max_pressure, &PhysicalResults::max_traction,
        &PhysicalResults::max_heat_flux, &PhysicalResults::max_temperature_celsius,
        &PhysicalResults::dissipation})
    error.*field += 2 * of_size * std::abs(y.value.*field);
  error.max_temperature_at_m += 2 * of_size * y.value.half_width;
  if ((*x.error)(traction) > 0)
    error.tangential_load += 2 * of_size * std::abs(y.value.tangential_load);
  if (given == CreepUnit::ratio) error.creep_ratio = 0;
  const auto* found = std::get_if<CoupledSolution>(&x.found);
  if (found == nullptr || !found->limit) return y;
  const TractionLimit& limit = *found->limit;
  const double sign = sign_of(x.scene.direction), ratio = unit.slip / si.speed;
  const auto with_size = [&](double value, double own) -> Estimate {
    return {sign * value, own + 2 * of_size * std::abs(value)};
  };
  y.tangential_load_limit = with_size(limit.traction * si.load, limit.traction_error * si.load);
  if (limit.has_creep())
    y.creep_ratio_at_limit = with_size(limit.creep * ratio, limit.creep_error * ratio);
  return y;
}

void require_contact(const Solution& x) {
  if (!x.converged)
    throw NotConverged("the iteration did not converge; what is written is its last iterate");
  if (x.violations.empty()) return;
  const Violation& first = x.violations.front();
  throw NoContact("what is written solves the equations, but is no contact: " + first.what +
                  " at s = " + shortest(first.from) + " to " + shortest(first.to));
}

/// kappa of a scene and its error; 0 if there is no solution, for a reason.
struct FoundKappa {
  double value = 0, error = 0;
  std::exception_ptr reason{};
};

FoundKappa find_kappa(const PhysicalScene& si, double friction, const Prescribed& given,
                      const Approach& approach, CreepUnit unit) try {
  const Solution x = solve(scene_of(si, friction), dimensionless(si, given, unit), approach);
  return {std::max(x.value(load_ratio), 0.0), x.error ? (*x.error)(load_ratio) : 0, {}};
} catch (const std::runtime_error&) {
  return {0, 0, std::current_exception()};
} catch (const std::invalid_argument&) {  // a creep beyond the limit for this half-width
  if (given.quantity != creep) throw;
  return {0, 0, std::current_exception()};
}

double half_width_of_radius(PhysicalScene si, double radius, double friction,
                            const Prescribed& given, const Approach& approach, CreepUnit unit) {
  require(radius > 0, "radius", radius, "positive");
  check_but_half_width(si);
  double least = 0, most = 0, kappa = 1, before = 0, missed_before = 0;
  std::exception_ptr reason;
  for (int step = 0; step < 50; ++step) {
    si.half_width = hertz_half_width(kappa * si.load, radius, si.shear_modulus, si.poisson);
    const FoundKappa found = find_kappa(si, friction, given, approach, unit);
    if (step == 0) reason = found.reason;
    if (reason && found.reason && least == 0 && step == 7) std::rethrow_exception(reason);
    const double missed = found.value - kappa;
    if (!found.reason && std::abs(missed) <= 1e-9 * kappa + found.error) return si.half_width;
    (missed > 0 ? least : most) = kappa;
    if (found.reason && most - least < 1e-3 * most) std::rethrow_exception(found.reason);
    const double secant = kappa - missed * (kappa - before) / (missed - missed_before);
    const double next = step == 0 ? found.value : secant;
    before = kappa;
    missed_before = missed;
    if (least < next && (most == 0 || next < most))
      kappa = next;
    else
      kappa = most == 0 ? 2 * kappa : (least + most) / 2;
  }
  throw NotConverged("no half-width found for radius = " + shortest(radius) + " m");
}

PhysicalScene with_half_width(const GivenScene& c) {
  PhysicalScene si = *c.physical;
  if (c.radius) si.half_width = hertz_half_width(si.load, *c.radius, si.shear_modulus, si.poisson);
  return si;
}

double ratio_of_creep(const PhysicalScene& si) { return units_of(si, 1).slip / si.speed; }

std::string units_told(const GivenScene& c) {
  const PhysicalScene si = with_half_width(c);
  return " (traction 1 is " + rounded(si.load, 6) + " N/m, creep 1 is creep-ratio " +
         rounded(ratio_of_creep(si), 4) + ")";
}

std::string limit_told(const GivenScene& c, const TractionLimit& limit) {
  const PhysicalScene si = with_half_width(c);
  const double most = below(limit) * si.load;
  const std::string in_si = most > 0 ? rounded_down(most, 7) : rounded_up(most, 7);
  if (!limit.has_creep()) return " (" + in_si + " N/m)";
  const std::string creep_ratio = rounded(limit.creep * ratio_of_creep(si), 4);
  return " (" + in_si + " N/m, at the creep-ratio " + creep_ratio + ")";
}

std::string told_in_si(const GivenScene& c, const std::invalid_argument& refusal) {
  const auto* beyond = dynamic_cast<const BeyondLimit*>(&refusal);
  return beyond ? limit_told(c, beyond->limit) : units_told(c);
}

std::string notes_told(const GivenScene& c) {
  const PhysicalScene si = with_half_width(c);
  const Prescribed given = dimensionless(si, c.given, c.unit);
  const double creep_ratio = given.quantity == creep ? given.value * ratio_of_creep(si) : 0;
  return in_a_message(notes_on(si, c.scene.friction, creep_ratio, 0));
}

std::string in_a_message(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "; note: " + note;
  return text;
}

void throw_again_with(const std::string& more) {
  try {
    throw;
  } catch (const NotResolved& failure) {
    throw NotResolved(failure.what() + more, failure.trace);
  } catch (const NotConverged& failure) {
    throw NotConverged(failure.what() + more);
  } catch (const std::runtime_error& failure) {
    throw std::runtime_error(failure.what() + more);
  } catch (const BeyondLimit& failure) {
    throw BeyondLimit(failure.what() + more, failure.limit);
  } catch (const std::invalid_argument& failure) {
    throw std::invalid_argument(failure.what() + more);
  }
}

/// Of a solution for the half-width of si, which follows from a radius.
void add_error_of_size(Solution& x, PhysicalScene si, const GivenScene& c) {
  if (!x.error) return;
  si.half_width *= 1 + 5e-10 + error_of_kappa(x);
  const Prescribed given = dimensionless(si, c.given, c.unit);
  const Solution larger = solve(scene_of(si, x.scene.friction), given, c.approach);
  *x.error += (larger.value - x.value).abs();
  if (x.scene.bulk_difference != 0) {
    const NoSlip here = no_slip(x), there = no_slip(larger);
    x.moved.traction_error = std::abs(there.traction - here.traction);
    x.moved.creep_error = std::abs(there.creep - here.creep);
  }
  auto* one = std::get_if<CoupledSolution>(&x.found);
  const auto* other = std::get_if<CoupledSolution>(&larger.found);
  if (one == nullptr || !one->limit || other == nullptr || !other->limit) return;
  one->limit->traction_error += std::abs(other->limit->traction - one->limit->traction);
  one->limit->creep_error += std::abs(other->limit->creep - one->limit->creep);
}

void check_only_friction(const Scene& x) {
  if (x.law || x.roller.conductivity_ratio != 0 || x.direction == Direction::braking ||
      x.bulk_difference != 0)
    throw std::invalid_argument(
        "a scene with SI data has its law, roller, direction and bulk temperatures in these");
}

SolvedScene solve_scene(const GivenScene& c) try {
  if (!c.physical) return {solve(c.scene, c.given, c.approach), {}, {}};
  check_only_friction(c.scene);
  PhysicalScene si = *c.physical;
  const double friction = c.scene.friction;
  if (c.radius)
    si.half_width = half_width_of_radius(si, *c.radius, friction, c.given, c.approach, c.unit);
  check(si);
  const Prescribed given = dimensionless(si, c.given, c.unit);
  Solution x = solve(scene_of(si, friction), given, c.approach);
  if (c.radius) add_error_of_size(x, si, c);
  return {x, units_of(si, friction), in_si_units(x, si, c.radius.has_value(), c.unit)};
} catch (const std::invalid_argument& refusal) {
  const std::string text = refusal.what();
  const bool about_it = text.find("creep = ") == 0 || text.find("traction = ") == 0;
  if (!c.physical || !about_it) throw;
  const std::string given = c.as_given.empty() ? "" : c.as_given + ": ";
  const std::string told = given + text + told_in_si(c, refusal) + notes_told(c);
  const auto* beyond = dynamic_cast<const BeyondLimit*>(&refusal);
  if (beyond != nullptr) throw BeyondLimit(told, beyond->limit);
  throw std::invalid_argument(told);
} catch (const std::runtime_error& failure) {
  if (!c.physical) throw;
  const bool tells_a_creep = std::string(failure.what()).find(" creep") != std::string::npos;
  throw_again_with((tells_a_creep ? units_told(c) : "") + notes_told(c));
}

Curve temperature_curve(const Solution& x, const std::vector<double>& at, double depth) {
  require(depth >= 0, "depth", depth, "zero or positive");
  for (const double s : at) require(std::isfinite(s), "s", s, "a finite number");
  if (at.empty()) return {};
  if (const auto* scheme = std::get_if<PublishedSolution>(&x.found)) {
    require(depth == 0, "depth", depth, "0 with gauss-chebyshev, whose rule is for the surface");
    return scheme_curve(x.scene, *scheme, at);
  }
  const auto* coupled = std::get_if<CoupledSolution>(&x.found);
  const Carter* closed = std::get_if<Carter>(&x.found);
  const double share = heat_share(x.scene), of_flux = flux_error(x);
  Curve curve;
  if (x.value(slip_length) == 0) {
    for (const double s : at) curve.points.push_back({s, 0, 0});
  } else if (depth == 0) {
    const auto points = static_cast<Eigen::Index>(at.size());
    const SurfaceCurve found = on_surface(x, Eigen::Map<const Eigen::ArrayXd>(at.data(), points));
    const Eigen::ArrayXd temperature = without_underflow(found.temperature);
    for (Eigen::Index i = 0; i < points; ++i)
      curve.points.push_back(
          {at[static_cast<std::size_t>(i)], temperature(i), found.error + of_flux});
  } else {
    const HeatFlux flux = coupled ? coupled_flux(*coupled) : carter_flux(*closed);
    SmoothFlux by = coupled ? smooth_flux(*coupled) : smooth_flux(*closed);
    if (coupled) by.h = coupled->h;
    const CrossingFlux crossing = flux_for_depths(x.scene, x.approach.formulation, by);
    const double scale = crossing.zones.empty() ? 0 : scale_in(x.scene, x.value)(max_temperature);
    for (const double s : at) {
      const Estimate own = temperature_below(flux, x, s, depth, scale);
      CurvePoint point{s, share * own.value, share * own.error + of_flux + crossing.error};
      for (const HeatFlux& zone : crossing.zones) {
        const Estimate more = temperature_below(zone, x, s, depth, scale);
        point.temperature += more.value;
        *point.error += more.error;
      }
      curve.points.push_back(point);
    }
  }
  return curve;
}

Profile profile(const Solution& x) {
  require_profile(x);
  if (const auto* found = std::get_if<CoupledSolution>(&x.found)) {
    const Profile y = profile(*found);
    return finished(x, y, temperature_curve(x, {y.s.begin(), y.s.end()}, 0));
  }
  constexpr Eigen::Index zone = 100;  // intervals to each zone
  const auto& c = std::get<Carter>(x.found);
  const Intervals of{zone, c.slip_half_width > 0 ? zone : 0};
  return carter_profile(x, c, carter_points(c, of));
}

Profile profile(const Solution& x, int points) {
  require_profile(x);
  require(2 <= points && points <= 100000, "profile-points", points, "from 2 to 100000");
  const auto* found = std::get_if<CoupledSolution>(&x.found);
  if (found == nullptr) {
    const auto& c = std::get<Carter>(x.found);
    const Intervals of = plot_intervals(points, c.b, c.slip_half_width);
    return carter_profile(x, c, carter_points(c, of));
  }
  Profile y = profile_at(*found, plot_points(*found, points));
  if (x.scene.bulk_difference == 0) y.s(0) = -1;
  if (x.scene.bulk_difference == 0) y.s(y.s.size() - 1) = 1;
  const Curve curve = temperature_curve(x, {y.s.begin(), y.s.end()}, 0);
  for (Eigen::Index i = 0; i < y.s.size(); ++i)
    y.temperature(i) = curve.points[static_cast<std::size_t>(i)].temperature;
  return finished(x, y, curve);
}

std::optional<Estimate> least_friction(const Solution& x) {
  const double slip = x.value(slip_length), f = x.scene.friction;
  if (!x.scene.law || slip == 0) return std::nullopt;
  std::vector<double> at;
  for (int i = 0; i <= 4; ++i) at.push_back(1 - slip * std::pow(std::cos(i * pi / 8), 2));
  const std::vector<CurvePoint> points = temperature_curve(x, at, 0).points;
  const CurvePoint coldest = *std::min_element(
      points.begin(), points.end(),
      [](const CurvePoint& a, const CurvePoint& b) { return a.temperature < b.temperature; });
  const double top = x.value(max_temperature), error = (*x.error)(max_temperature);
  Estimate least{std::numeric_limits<double>::infinity(), 0};
  for (int i = 0; i <= 32; ++i) {
    const double t = std::lerp(coldest.temperature, top, i / 32.0);
    const double e = std::lerp(coldest.error.value_or(0), error, i / 32.0);
    const auto away = [&](double other) {
      return f * std::abs(x.scene.law(other).value - x.scene.law(t).value);
    };
    const double here = f * x.scene.law(t).value;
    if (here < least.value) least = {here, std::max(away(t - e), away(t + e))};
  }
  return least;
}

}  // namespace thermoroll
