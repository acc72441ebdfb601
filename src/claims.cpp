// Tangled from paper/11-results.md; edit there.
#include "claims.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "carter.hpp"
#include "coupled.hpp"
#include "numbers.hpp"
#include "printed_scheme.hpp"
#include "temperature.hpp"

namespace thermoroll {
namespace {

constexpr double friction = 0.6, heating = 0.0175;
constexpr Formulation sign = Formulation::printed;

std::string verdict(double paper, double ours) {
  const double percent = 100 * (paper / ours - 1);
  if (std::abs(percent) < 0.5) return "holds";
  return "paper " + fixed(std::abs(percent), 1) + " % " + (percent > 0 ? "high" : "low");
}

std::string verdict(bool holds) { return holds ? "holds" : "does not hold"; }

std::string yes(bool holds) { return holds ? "yes" : "no"; }

/// With the sign as printed, to 1e-7.
CoupledSolution coupled(double q, double peclet) {
  return solve_coupled({friction, q, peclet, heating}, sign, 1e-7, {traction, q});
}

struct Case {
  double traction, peclet;
  PrintedSolution printed;
  double printed_max;  // of T*
  CoupledSolution coupled;
  Profile profile;  // of the coupled solution
};

std::vector<Case> sixteen_cases() {
  PrintedOptions options;
  options.tolerance = 1e-3;
  std::vector<Case> cases;
  for (const double q : {0.2, 0.4, 0.5, 0.59})
    for (const double pe : {100.0, 500.0, 1000.0, 5000.0}) {
      const PrintedSolution x = solve_printed({friction, q, pe, heating}, sign, options);
      const CoupledSolution y = coupled(q, pe);
      cases.push_back({q, pe, x, printed_max_temperature(x, pe).temperature, y,
                       profile({friction, q, pe, heating}, sign, y)});
    }
  return cases;
}

template <class Property>
bool every(const std::vector<Case>& cases, Property holds) {
  return std::all_of(cases.begin(), cases.end(), holds);
}

/// Whether the maximum falls from each case to every other that is slower and carries more.
template <class Maximum>
bool falls_with_speed_and_rises_with_load(const std::vector<Case>& cases, Maximum of) {
  return every(cases, [&](const Case& x) {
    return every(cases, [&](const Case& y) {
      const bool hotter = y.traction >= x.traction && y.peclet <= x.peclet;
      return !hotter || &x == &y || of(y) > of(x);
    });
  });
}

/// T*max of the published scheme at Q* = 0.5.
double scheme_max(double peclet) {
  const PrintedSolution x = solve_printed({friction, 0.5, peclet, heating}, sign);
  return printed_max_temperature(x, peclet).temperature;
}

/// The integral of s^power v* p* / sqrt(1 - s^2) over Carter's slip zone, @eq:first-order.
double moment(const Carter& c, int power) {
  const HeatFlux flux = carter_flux(c);
  const double length = flux.to - flux.from;
  return integrate(
             [&](double left) {
               const double right = length - left, s = flux.from + left;
               return std::pow(s, power) * flux.density(left, right) / std::sqrt(right * (1 + s));
             },
             {0, length})
      .value;
}

std::string gamma0_at(int nodes) {
  PrintedOptions options;
  options.nodes = nodes;
  return fixed(solve_printed({friction, 0.5, 4360, heating}, sign, options).gamma0, 5);
}

/// V = 2 k Pe / a of the wheel on the rail, m/s.
double speed_at(double peclet) {
  const PhysicalCase steel = wheel_on_rail();
  return 2 * steel.diffusivity * peclet / steel.half_width;
}

}  // namespace

double rolling_to_sliding(double traction) {
  const Carter c = carter(friction, traction);
  return max_temperature(carter_flux(c), 1000).temperature.value /
         max_temperature(sliding_flux(carter_heat(c)), 1000).temperature.value;
}

double first_order_load_change(double traction) {
  return slope_sign(sign) * friction * heating * moment(carter(friction, traction), 1);
}

double first_order_gamma0(double traction) {
  return -slope_sign(sign) * friction * heating / pi * moment(carter(friction, traction), 0);
}

double celsius_at(double peclet) {
  PhysicalCase steel = wheel_on_rail();
  steel.speed = speed_at(peclet);
  return units_of(steel, friction).temperature;
}

std::vector<Claim> claims() {
  std::vector<Claim> table;
  const auto add = [&](const std::string& claim, const std::string& paper,
                       const std::string& printed, const std::string& converged,
                       const std::string& verdict_on_it) {
    table.push_back({claim, paper, printed, converged, verdict_on_it});
  };
  const std::vector<Case> cases = sixteen_cases();
  const Scene steel = scene_of(wheel_on_rail(), friction, 0.5);
  add("thermomechanical ratio H of the wheel on the rail", "0.02", "–", fixed(steel.heating, 4),
      verdict(fixed(steel.heating, 2) == "0.02") + ", rounded");
  add("Péclet number of the wheel on the rail", "4360", "–", fixed(steel.peclet, 1),
      verdict(4360, steel.peclet));
  add("Pe = 5000 is a speed of about 25 m/s", "25", "–", fixed(speed_at(5000), 1),
      verdict(fixed(speed_at(5000), 0) == "25"));
  const double top = coupled(0.5, 5000).value(hottest);
  add("T*max at Q* = 0.5, Pe = 5000", "0.002", fixed(scheme_max(5000), 6), fixed(top, 6),
      verdict(fixed(top, 3) == "0.002") + ", to its one digit");
  double rise = 0;
  for (const auto& [pe, celsius] : {std::pair{5000, 272}, {10000, 420}, {15000, 490}}) {
    rise = celsius_at(pe) * coupled(0.5, pe).value(hottest);
    add("largest temperature at Q* = 0.5, Pe = " + std::to_string(pe) + ", °C",
        std::to_string(celsius), fixed(celsius_at(pe) * scheme_max(pe), 1), fixed(rise, 1),
        verdict(celsius, rise));
  }
  add("too cold for a phase transformation of steel (below 727 °C)", "yes", "–",
      "a rise of " + fixed(rise, 0) + " °C at most", verdict(rise < 700));
  const bool varies_printed =
      falls_with_speed_and_rises_with_load(cases, [](const Case& x) { return x.printed_max; });
  const bool varies = falls_with_speed_and_rises_with_load(
      cases, [](const Case& x) { return x.coupled.value(hottest); });
  add("T* is higher at small Pe and at large Q*", "yes", yes(varies_printed), yes(varies),
      verdict(varies));
  add("rolling differs from pure sliding: ratio of T*max at Q* = 0.2 and 0.59",
      "larger at small Q*", "–",
      fixed(rolling_to_sliding(0.2), 2) + ", " + fixed(rolling_to_sliding(0.59), 2),
      verdict(rolling_to_sliding(0.2) > rolling_to_sliding(0.59)));
  const bool slides_printed = every(cases, [](const Case& x) {
    return (x.printed.grid.t.array() <= x.printed.c0 || x.printed.slip.array() > 0).all();
  });
  const bool slides = every(cases, [](const Case& x) {
    return (x.profile.s <= x.coupled.value(border) || x.profile.slip > 0).all();
  });
  const bool sticks = every(cases, [](const Case& x) {
    const Profile& p = x.profile;
    return (p.s >= x.coupled.value(border) || p.traction.abs() < friction * p.pressure).all();
  });
  add("v* is zero in the stick zone", "yes", "by construction", "by construction", "holds");
  add("|q| < f p in the stick zone", "yes", "–", yes(sticks), verdict(sticks));
  add("v* is positive in the slip zone", "yes", yes(slides_printed), yes(slides), verdict(slides));
  const double seen = 1 - solve_printed({friction, 0.5, 4360, heating}, sign).load_ratio;
  const Values steady = coupled(0.5, 4360).value;
  add("thermal deformation is negligible: 1 − κ at Pe = 4360", "small", fixed(seen, 5),
      fixed(1 - steady(load_ratio), 5),
      verdict(1 - steady(load_ratio) < 0.01) + "; the grid does not resolve it");
  add("γ0 tends to zero with n (at n = 50, 400)", "0", gamma0_at(50) + ", " + gamma0_at(400),
      fixed(steady(gamma0), 5), verdict(std::abs(steady(gamma0)) < 1e-6));
  int outer = 0, inner = 0;
  bool converged = true;
  for (const Case& x : cases) {
    outer = std::max(outer, x.printed.outer_iterations);
    inner = std::max(inner, x.printed.inner_iterations);
    converged = converged && x.printed.converged;
  }
  add("to 0.1 %, at most 20 iterations on c0", "20", std::to_string(inner), "–",
      verdict(converged && inner <= 20) + ", with far fewer");
  add("to 0.1 %, at most 35 iterations on v*", "35", std::to_string(outer), "–",
      verdict(converged && outer <= 35) + ", with far fewer");
  const double error = std::abs(cases.back().printed_max / cases.back().coupled.value(hottest) - 1);
  add("relative accuracy 0.1 % with n = 50 … 200", "0.1 %",
      fixed(100 * error, 1) + " % of T*max at Q* = 0.59, Pe = 5000", "–",
      error <= 1e-3 ? "holds" : "of the iteration, not of T*");
  return table;
}

}  // namespace thermoroll
