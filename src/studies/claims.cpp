// Tangled from paper/08-results.md; edit there.
#include "studies/claims.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/solution.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {

namespace {

using Claims = std::vector<Claim>;
using Eigen::ArrayXd;

std::string yes(bool holds) { return holds ? "yes" : "no"; }

/// The integral of s^power v* p* / sqrt(1 - s^2) over Carter's slip zone, @eq:first-order.
double moment(const Carter& c, int power) {
  const HeatFlux flux = carter_flux(c);
  const double length = flux.to - flux.from;
  const auto integrand = [&](double left) {
    const double right = length - left, s = flux.from + left;
    return std::pow(s, power) * flux.density(left, right) / std::sqrt(right * (1 + s));
  };
  return integrate(integrand, {0, length}).value;
}

struct PaperScene {
  double traction, peclet;
  PublishedSolution coarse, fine;  // by the published scheme, n = 50 and 200
  CoupledSolution coupled;
  Profile profile;  // of the coupled solution
};

std::vector<PaperScene> sixteen_scenes() {
  std::vector<PaperScene> scenes;
  for (const double q : paper::tractions)
    for (const double pe : paper::peclets) {
      const CoupledSolution x = paper::coupled(q, pe);
      scenes.push_back({q, pe, paper::scheme(q, pe, {50, 1e-3}), paper::scheme(q, pe, {200, 1e-3}),
                        x, profile(x)});
    }
  return scenes;
}

template <class Property>
bool every(const std::vector<PaperScene>& scenes, Property holds) {
  return std::all_of(scenes.begin(), scenes.end(), holds);
}

/// Whether every run of the published scheme has the property.
template <class Property>
bool every_run(const std::vector<PaperScene>& scenes, Property holds) {
  return every(scenes, [&](const PaperScene& x) { return holds(x.coarse) && holds(x.fine); });
}

/// Whether the maximum rises from each scene to every other that is slower and carries more.
template <class Maximum>
bool rises(const std::vector<PaperScene>& scenes, Maximum of) {
  return every(scenes, [&](const PaperScene& x) {
    return every(scenes, [&](const PaperScene& y) {
      const bool hotter = y.traction >= x.traction && y.peclet <= x.peclet;
      return !hotter || &x == &y || of(y) > of(x);
    });
  });
}

Claims on_the_data() {
  const Scene steel = scene_of(wheel_on_rail(), paper::friction);
  return {{"thermomechanical ratio H of the wheel on the rail", "0.02", "–",
           fixed(steel.heating, 4), verdict_on("0.02", steel.heating)},
          {"Péclet number of the wheel on the rail", "4360", "–", fixed(steel.peclet, 1),
           verdict_on("4360", steel.peclet)},
          {"Pe = 5000 is a speed of about 25 m/s", "25", "–", fixed(speed_at(5000), 2),
           verdict_on("25", speed_at(5000))}};
}

Claims on_the_temperature() {
  const double top = paper::coupled(0.5, 5000).value(Quantity::max_temperature);
  Claims table{{"T*max at Q* = 0.5, Pe = 5000", "0.002", fixed(paper::scheme_max(0.5, 5000), 6),
                fixed(top, 6), verdict_on("0.002", top)}};
  for (const auto& [pe, celsius] : {std::pair{5000, "272"}, {10000, "420"}, {15000, "490"}}) {
    const int speed = pe / 200;  // as the paper has it
    const double unit = celsius_per_unit(speed);
    const double rise = unit * paper::coupled(0.5, pe).value(Quantity::max_temperature);
    table.push_back({"largest temperature at Q* = 0.5, Pe = " + std::to_string(pe) + ", " +
                         std::to_string(speed) + " m/s, °C",
                     celsius, fixed(unit * paper::scheme_max(0.5, pe), 1), fixed(rise, 1),
                     verdict_on(celsius, rise)});
  }
  return table;
}

Claim on_phases() {
  std::string rises, cold, hot;
  const auto add = [](std::string& list, const std::string& item) {
    list += (list.empty() ? "" : ", ") + item;
  };
  for (const double q : paper::tractions) {
    const double rise =
        celsius_per_unit(75) * paper::coupled(q, 15000).value(Quantity::max_temperature);
    add(rises, fixed(rise, 0));
    add(rise < 700 ? cold : hot, shortest(q));
  }
  return {"too cold for a phase transformation of steel (below 727 °C)", "yes", "–",
          "rises of " + rises + " °C at Pe = 15000",
          verdict(!cold.empty(), "at Q* = " + cold + (hot.empty() ? "" : ", not at " + hot))};
}

Claims on_variation(const std::vector<PaperScene>& scenes) {
  const auto of_scheme = [](const PaperScene& x) {
    return published_max_temperature(x.fine, x.peclet).temperature;
  };
  const bool scheme = rises(scenes, of_scheme);
  const bool converged =
      rises(scenes, [](const PaperScene& x) { return x.coupled.value(Quantity::max_temperature); });
  const double small = rolling_to_sliding(0.2), large = rolling_to_sliding(0.59);
  return {{"T* is higher at small Pe and at large Q*", "yes", yes(scheme), yes(converged),
           verdict(converged)},
          {"rolling differs from pure sliding: ratio of T*max at Q* = 0.2 and 0.59",
           "larger at small Q*", "–", fixed(small, 2) + ", " + fixed(large, 2),
           verdict(small > large)}};
}

bool zero_before(double c0, const ArrayXd& s, const ArrayXd& slip) {
  return (s > c0 || slip == 0).all();
}

bool positive_behind(double c0, const ArrayXd& s, const ArrayXd& slip) {
  return (s <= c0 || slip > 0).all();
}

bool below_the_limit(const PublishedSolution& solution) {
  return std::all_of(solution.grid.s.begin(), solution.grid.s.end(), [&](double s) {
    const double q = published_traction(solution, paper::friction, s);
    return s >= solution.c0 || std::abs(q) < paper::friction * published_pressure(solution, s);
  });
}

bool below_the_limit(double c0, const Profile& profile) {
  return (profile.s >= c0 || profile.traction.abs() < paper::friction * profile.pressure).all();
}

Claims on_slip(const std::vector<PaperScene>& scenes) {
  const bool zero_scheme = every_run(scenes, [](const PublishedSolution& solution) {
    return zero_before(solution.c0, solution.grid.t, solution.slip);
  });
  const bool sticks_scheme = every_run(
      scenes, [](const PublishedSolution& solution) { return below_the_limit(solution); });
  const bool slips_scheme = every_run(scenes, [](const PublishedSolution& solution) {
    return positive_behind(solution.c0, solution.grid.t, solution.slip);
  });
  const bool zero = every(scenes, [](const PaperScene& x) {
    return zero_before(x.coupled.value(Quantity::stick_slip_border), x.profile.s, x.profile.slip);
  });
  const bool sticks = every(scenes, [](const PaperScene& x) {
    return below_the_limit(x.coupled.value(Quantity::stick_slip_border), x.profile);
  });
  const bool slips = every(scenes, [](const PaperScene& x) {
    return positive_behind(x.coupled.value(Quantity::stick_slip_border), x.profile.s,
                           x.profile.slip);
  });
  return {
      {"v* is zero in the stick zone", "yes", yes(zero_scheme), yes(zero),
       verdict(zero_scheme && zero, "by construction")},
      {"|q| < f p in the stick zone", "yes", yes(sticks_scheme), yes(sticks), verdict(sticks)},
      {"v* is positive in the slip zone", "yes", yes(slips_scheme), yes(slips), verdict(slips)}};
}

std::string gamma0_at(int nodes) {
  return fixed(paper::scheme(0.5, paper::peclet, {nodes}).gamma0, 5);
}

Claims on_deformation() {
  const CoupledSolution x = paper::coupled(0.5, paper::peclet);
  const double change = 1 - x.value(Quantity::load_ratio);
  const double seen = 1 - paper::scheme(0.5, paper::peclet).load_ratio;
  const bool vanishes = std::abs(x.value(Quantity::gamma0)) <= x.error(Quantity::gamma0);
  return {{"thermal deformation is negligible: 1 − κ at Pe = 4360", "small", fixed(seen, 5),
           fixed(change, 5),
           verdict(std::abs(change) < 0.01,
                   "though n = 200 sees " + fixed(100 * seen / change, 0) + " % of it")},
          {"γ0 tends to zero with n (at n = 50, 400)", "0", gamma0_at(50) + ", " + gamma0_at(400),
           fixed(x.value(Quantity::gamma0), 5), verdict(vanishes)}};
}

Claim on_two_bodies() {
  const auto hottest = [](const Roller& roller) {
    const Scene scene{paper::friction, paper::peclet, paper::heating, roller};
    return solve(scene, {Quantity::traction, 0.5}).value(Quantity::max_temperature);
  };
  const double ratio = hottest({1, paper::heating}) / hottest({});
  return {"both bodies may conduct: T*max of two over that of one at Pe = 4360", "future work", "–",
          fixed(ratio, 3), verdict(std::abs(2 * ratio - 1) < 0.01, "computed: half as hot")};
}

Claim on_hot_friction() {
  const PhysicalScene steel = wheel_on_rail();
  Scene scene = scene_of(steel, paper::friction);
  scene.law = linear_friction({1600 / units_of(steel, paper::friction).temperature});
  const TractionLimit top =
      *solve_coupled(scene, Formulation::corrected, 1e-6, {Quantity::traction, 0.1}).limit;
  const double share = top.traction / paper::friction;
  return {"friction may depend on temperature: largest Q* at Pe = 4360, none left at 1600 °C",
          "possible", "–", fixed(top.traction, 3) + " at the creep " + fixed(top.creep, 3),
          verdict(share > 0.5 && share < 0.99, "computed: " + fixed(100 * share, 0) + " % of f")};
}

/// Count a run of scene x; returns the error of its T*max in per cent.
double count(Record& record, const PaperScene& x, const PublishedSolution& run) {
  record.outer = std::max(record.outer, run.outer_iterations);
  record.inner = std::max(record.inner, run.inner_iterations);
  record.converged = record.converged && run.converged;
  const double found = published_max_temperature(run, x.peclet).temperature;
  return 100 * std::abs(found / x.coupled.value(Quantity::max_temperature) - 1);
}

Record record_of(const std::vector<PaperScene>& scenes) {
  Record record;
  for (const PaperScene& x : scenes) {
    record.coarse_error = std::max(record.coarse_error, count(record, x, x.coarse));
    record.fine_error = std::max(record.fine_error, count(record, x, x.fine));
  }
  return record;
}

Claims on_the_iteration(const std::vector<PaperScene>& scenes) {
  const Record x = record_of(scenes);
  const bool exact = std::max(x.coarse_error, x.fine_error) <= 0.1;
  return {claim_on_steps("c0", 20, x.inner, x.converged),
          claim_on_steps("v*", 35, x.outer, x.converged),
          {"relative accuracy 0.1 % with n = 50 … 200", "0.1 %",
           "T*max within " + fixed(x.coarse_error, 1) + " % … " + fixed(x.fine_error, 1) + " %",
           "–", verdict(x.converged, exact ? "" : "for the iteration, not for T*max")}};
}

}  // namespace

double first_order_load_change(double q) {
  const double sign = slope_sign(paper::formulation);
  return sign * paper::friction * paper::heating * moment(paper::closed_form(q), 1);
}

double first_order_gamma0(double q) {
  const double sign = slope_sign(paper::formulation);
  return -sign * paper::friction * paper::heating / pi * moment(paper::closed_form(q), 0);
}

std::string verdict_on(const std::string& paper, double ours) {
  const double percent = 100 * (std::stod(paper) / ours - 1);
  if (std::abs(percent) < 0.5) return "holds";
  const std::size_t point = paper.find('.');
  const std::size_t decimals = point == paper.npos ? 0 : paper.size() - point - 1;
  if (fixed(ours, static_cast<int>(decimals)) == paper) return "holds, rounded";
  return "paper " + fixed(std::abs(percent), 1) + " % " + (percent > 0 ? "high" : "low");
}

std::string verdict(bool holds, const std::string& how) {
  if (!holds) return "does not hold";
  return how.empty() ? "holds" : "holds, " + how;
}

double speed_at(double pe) {
  const PhysicalScene steel = wheel_on_rail();
  return 2 * steel.diffusivity * pe / steel.half_width;
}

double celsius_per_unit(double speed) {
  PhysicalScene steel = wheel_on_rail();
  steel.speed = speed;
  return units_of(steel, paper::friction).temperature;
}

double celsius_per_unit_at(double pe) { return celsius_per_unit(speed_at(pe)); }

double rolling_to_sliding(double q) {
  const Carter c = paper::closed_form(q);
  return hottest_point(carter_flux(c), 1000).temperature.value /
         hottest_point(sliding_flux(carter_heat(c)), 1000).temperature.value;
}

Record scheme_record() { return record_of(sixteen_scenes()); }

Claim claim_on_steps(const std::string& unknown, int most, int found, bool converged) {
  const std::string bound = std::to_string(most);
  return {"to 0.1 %, at most " + bound + " iterations on " + unknown, bound, std::to_string(found),
          "–", verdict(converged && found <= most)};
}

std::vector<Claim> claims() {
  const std::vector<PaperScene> scenes = sixteen_scenes();
  Claims all;
  for (const Claims& some : {on_the_data(), on_the_temperature(), Claims{on_phases()},
                             on_variation(scenes), on_slip(scenes), on_deformation(),
                             Claims{on_two_bodies(), on_hot_friction()}, on_the_iteration(scenes)})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace thermoroll
