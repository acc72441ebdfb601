// Tangled from paper/08-results.md; edit there.
#include "studies/claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/solution.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {

namespace {

using Claims = std::vector<Claim>;
using Numbers = std::vector<double>;
using Eigen::ArrayXd;

std::string yes(bool holds) { return holds ? "yes" : "no"; }

void raise(double& largest, double value) { largest = std::max(largest, value); }

std::string listed(const Numbers& numbers, int decimals) {
  std::string list;
  for (const double x : numbers) list += (list.empty() ? "" : ", ") + fixed(x, decimals);
  return list;
}

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

Verdict computed(bool holds, const std::string& result) {
  if (!holds) return verdict(false);
  return {Judgement::extended, "computed: " + result};
}

struct PaperScene {
  double traction, peclet;
  PublishedSolution coarse, fine;      // by the published scheme, n = 50 and 200
  CoupledSolution coupled, corrected;  // with the sign as printed, and with the corrected one
  Profile profile, corrected_profile;  // of these
};

std::vector<PaperScene> sixteen_scenes() {
  std::vector<PaperScene> scenes;
  for (const double q : paper::tractions)
    for (const double pe : paper::peclets) {
      const CoupledSolution x = paper::coupled(q, pe);
      const CoupledSolution y = paper::coupled(q, pe, Formulation::corrected);
      scenes.push_back({q, pe, paper::scheme(q, pe, {50, 1e-3}), paper::scheme(q, pe, {200, 1e-3}),
                        x, y, profile(x), profile(y)});
    }
  return scenes;
}

template <class Property>
bool every(const std::vector<PaperScene>& scenes, Property holds) {
  return std::all_of(scenes.begin(), scenes.end(), holds);
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

Claim datum(const std::string& claim, const std::string& paper, double ours, int decimals) {
  return {claim,
          "p. 2580",
          paper,
          "–",
          fixed(ours, decimals),
          fixed(ours, decimals),
          verdict_on(paper, ours),
          {"sec:claims-data",
           "The dimensionless groups from SI data",
           {"Scene.PaperDataGiveThePapersGroups"}}};
}

Claim on_the_load() {
  const PhysicalScene steel = wheel_on_rail();
  const double printed = 1.47e7, across = 3 * printed / (4 * steel.load);
  const double radius = std::pow(
      steel.half_width / hertz_half_width(steel.load, 1, steel.shear_modulus, steel.poisson), 2);
  const std::string found = "half-axis across of " + fixed(across, 2) + " m";
  Verdict judged = verdict(across < radius);
  if (across > radius)
    judged.words = "does not hold: a hundredth of it gives " + fixed(10 * across, 1) + " mm";
  return {
      "load of the ellipse of the same largest pressure, N",
      "p. 2580",
      "1.47e7",
      "–",
      found,
      found,
      judged,
      {"sec:claims-data", "The claim on the wheel's load", {"Claims.LoadOfTheEllipseIsAMisprint"}}};
}

Claims on_the_data() {
  const Scene steel = scene_of(wheel_on_rail(), paper::friction);
  Claim speed = datum("Pe = 5000 is a speed of about 25 m/s", "25", speed_at(5000), 2);
  speed.source = "p. 2583";
  speed.evidence = {"sec:claims-data",
                    "The speed at a Péclet number",
                    {"Claims.CelsiusFollowTheSpeed"},
                    "fig:celsius"};
  return {datum("thermomechanical ratio H of the wheel on the rail", "0.02", steel.heating, 4),
          datum("Péclet number of the wheel on the rail", "4360", steel.peclet, 1), speed,
          on_the_load()};
}

double largest_rise(double pe, double unit, Formulation formulation) {
  return unit * paper::coupled(0.5, pe, formulation).value(Quantity::max_temperature);
}

Claim temperature_claim(const std::string& claim, const std::string& paper, double pe, double unit,
                        int decimals) {
  const double printed = largest_rise(pe, unit, Formulation::printed);
  return {claim,
          "p. 2583",
          paper,
          fixed(unit * paper::scheme_max(0.5, pe), decimals),
          fixed(printed, decimals),
          fixed(largest_rise(pe, unit, Formulation::corrected), decimals),
          verdict_on(paper, printed),
          {"sec:claims-temperature",
           "The four temperatures",
           {"Claims.CelsiusFollowTheSpeed", "CelsiusFigure.MiddleValueIsOffTheSquareRoot"},
           "fig:celsius"}};
}

Claims on_the_temperature() {
  Claims table{temperature_claim("T*max at Q* = 0.5, Pe = 5000", "0.002", 5000, 1, 6)};
  table.front().source = "p. 2583, Fig. 4c";
  table.front().evidence = {"sec:claims-temperature",
                            "Claims on the largest temperature",
                            {"PublishedScheme.ReproducesThePapersTemperature"},
                            "fig:temperatures"};
  for (const auto& [pe, celsius] : {std::pair{5000, "272"}, {10000, "420"}, {15000, "490"}}) {
    const int speed = pe / 200;  // as the paper has it
    table.push_back(
        temperature_claim("largest temperature at Q* = 0.5, Pe = " + std::to_string(pe) + ", " +
                              std::to_string(speed) + " m/s, °C",
                          celsius, pe, celsius_per_unit(speed), 1));
  }
  return table;
}

Claim on_phases() {
  const double unit = celsius_per_unit(25), allowed = 727 - 27;
  const double printed = largest_rise(5000, unit, Formulation::printed);
  const double corrected = largest_rise(5000, unit, Formulation::corrected);
  return {"272 °C are too little for a phase transformation of steel",
          "p. 2583",
          "yes",
          yes(unit * paper::scheme_max(0.5, 5000) < allowed),
          yes(printed < allowed),
          yes(corrected < allowed),
          verdict(printed < allowed),
          {"sec:claims-temperature",
           "The claim on a phase transformation",
           {"Claims.PhaseTransformationIsJudgedAtThePapersTemperature"},
           "fig:celsius"}};
}

Claim on_variation(const std::vector<PaperScene>& scenes) {
  const auto hottest = [](const CoupledSolution& x) { return x.value(Quantity::max_temperature); };
  const bool scheme = rises(scenes, [](const PaperScene& x) {
    return published_max_temperature(x.fine, x.peclet).temperature;
  });
  const bool printed = rises(scenes, [&](const PaperScene& x) { return hottest(x.coupled); });
  const bool corrected = rises(scenes, [&](const PaperScene& x) { return hottest(x.corrected); });
  return {"T* is higher at small Pe and at large Q*",
          "p. 2583, Figs. 4, 5",
          "yes",
          yes(scheme),
          yes(printed),
          yes(corrected),
          verdict(printed),
          {"sec:claims-temperature",
           "The claim on the trend of the temperature",
           {"TemperatureFigure.FallsWithThePecletNumber", "TemperatureFigure.RisesWithTheTraction"},
           "fig:temperatures"}};
}

Claim on_sliding() {
  const double small = rolling_to_sliding(0.2), large = rolling_to_sliding(0.59);
  const std::string found = fixed(small, 2) + ", " + fixed(large, 2);
  return {"rolling differs from pure sliding: ratio of T*max at Q* = 0.2 and 0.59",
          "p. 2583",
          "larger at small Q*",
          "–",
          found,
          found,
          verdict(small > large),
          {"sec:claims-temperature",
           "The claim on pure sliding",
           {"Claims.RollingIsHotterThanSliding"},
           "fig:sliding"}};
}

/// One number for each chart of a figure; ours are for scheme, printed and corrected sign.
Claim figure_claim(const std::string& claim, const std::string& source, const Numbers& axes,
                   const std::array<Numbers, 3>& ours, int decimals, const Evidence& evidence) {
  bool holds = true;
  for (std::size_t i = 0; i < axes.size(); ++i)
    holds = holds && axes[i] / 2 < ours[1][i] && ours[1][i] < axes[i];
  const auto cell = [&](std::size_t k) { return listed(ours[k], decimals); };
  return {claim,   source,  "below " + listed(axes, axes[0] < 0.1 ? 3 : 1), cell(0),
          cell(1), cell(2), verdict(holds, "as far as its axis tells"),     evidence};
}

Evidence drawn(const std::string& chunk, const std::string& figure) {
  return {"sec:claims-figures", chunk, {"Claims.FiguresEndWithinTheirAxes"}, figure};
}

Claims on_tractions_drawn(const std::vector<PaperScene>& scenes) {
  std::array<Numbers, 3> traction{{{0}, {0}, {0}}}, slip = traction;
  for (const PaperScene& x : scenes) {
    raise(slip[0][0], x.fine.slip.maxCoeff());
    for (const double s : x.fine.grid.t)
      raise(traction[0][0], published_traction(x.fine, paper::friction, s));
    for (const auto& [k, p] : {std::pair{1, &x.profile}, {2, &x.corrected_profile}}) {
      raise(traction[static_cast<std::size_t>(k)][0], p->traction.maxCoeff());
      raise(slip[static_cast<std::size_t>(k)][0], p->slip.maxCoeff());
    }
  }
  return {figure_claim("largest traction q* drawn", "Fig. 2", {0.4}, traction, 3,
                       drawn("Claims on the tractions drawn", "fig:traction")),
          figure_claim("largest slip velocity v* drawn", "Fig. 3", {0.8}, slip, 3,
                       drawn("Claims on the tractions drawn", "fig:slip"))};
}

Claims on_temperatures_drawn(const std::vector<PaperScene>& scenes) {
  const auto hottest = [&](double traction, double peclet) {
    const auto x = std::find_if(scenes.begin(), scenes.end(), [&](const PaperScene& at) {
      return at.traction == traction && at.peclet == peclet;
    });
    return std::array{published_max_temperature(x->fine, peclet).temperature,
                      x->coupled.value(Quantity::max_temperature),
                      x->corrected.value(Quantity::max_temperature)};
  };
  std::array<Numbers, 3> slow, fast;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double q : paper::tractions) slow[k].push_back(hottest(q, 100)[k]);
    fast[k] = {hottest(0.59, 1000)[k]};
  }
  return {figure_claim("largest T* drawn, four loads", "Fig. 4", {0.004, 0.01, 0.016, 0.025}, slow,
                       5, drawn("Claims on the temperatures drawn", "fig:temperatures")),
          figure_claim("largest T* drawn, Pe = 1000", "Fig. 5", {0.008}, fast, 5,
                       drawn("Claims on the temperatures drawn", "fig:temperature-load"))};
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

struct Slips {
  bool zero = true, sticks = true, slips = true;
  void add(bool zero_here, bool sticks_here, bool slips_here);
};

void Slips::add(bool zero_here, bool sticks_here, bool slips_here) {
  zero = zero && zero_here;
  sticks = sticks && sticks_here;
  slips = slips && slips_here;
}

Slips slips_of_the_scheme(const std::vector<PaperScene>& scenes) {
  Slips all;
  for (const PaperScene& x : scenes)
    for (const PublishedSolution& run : {x.coarse, x.fine})
      all.add(zero_before(run.c0, run.grid.t, run.slip), below_the_limit(run),
              positive_behind(run.c0, run.grid.t, run.slip));
  return all;
}

void add_to(Slips& all, const CoupledSolution& x, const Profile& p) {
  const double c0 = x.value(Quantity::stick_slip_border);
  all.add(zero_before(c0, p.s, p.slip), below_the_limit(c0, p), positive_behind(c0, p.s, p.slip));
}

Claims on_slip(const std::vector<PaperScene>& scenes) {
  const Slips scheme = slips_of_the_scheme(scenes);
  Slips printed, corrected;
  for (const PaperScene& x : scenes) {
    add_to(printed, x.coupled, x.profile);
    add_to(corrected, x.corrected, x.corrected_profile);
  }
  const auto row = [&](const std::string& claim, bool Slips::*holds, const std::string& how,
                       const std::string& chunk, const std::vector<std::string>& tests,
                       const std::string& figure) {
    return Claim{claim,
                 "p. 2583, (3), (4)",
                 "yes",
                 yes(scheme.*holds),
                 yes(printed.*holds),
                 yes(corrected.*holds),
                 verdict(printed.*holds, how),
                 {"sec:claims-slip", chunk, tests, figure}};
  };
  const std::string slip = "Zero up to the border, positive beyond";
  const std::vector<std::string> of_slip{"SlipFigure.IsZeroInTheStickZoneAndPositiveInTheSlipZone",
                                         "SlipFigure.PublishedSchemeSlipsBehindOneBorder",
                                         "Coupled.ProfilesCarryTheLoads"};
  const std::vector<std::string> of_traction{
      "TractionFigure.ReachesTheFrictionLimitInTheSlipZoneOnly",
      "TractionFigure.LiesBetweenZeroAndTheFrictionLimit", "Coupled.ProfilesCarryTheLoads"};
  return {row("v* is zero in the stick zone", &Slips::zero, "by construction", slip, of_slip,
              "fig:slip"),
          row("|q| < f p in the stick zone", &Slips::sticks, "",
              "The traction below its limit in the stick zone", of_traction, "fig:traction"),
          row("v* is positive in the slip zone", &Slips::slips, "", slip, of_slip, "fig:slip")};
}

std::string gamma0_at(int nodes) {
  return fixed(paper::scheme(0.5, paper::peclet, {nodes}).gamma0, 5);
}

Claims on_deformation() {
  const CoupledSolution x = paper::coupled(0.5, paper::peclet);
  const CoupledSolution y = paper::coupled(0.5, paper::peclet, Formulation::corrected);
  const double change = 1 - x.value(Quantity::load_ratio);
  const double seen = 1 - paper::scheme(0.5, paper::peclet).load_ratio;
  const bool vanishes = std::abs(x.value(Quantity::gamma0)) <= x.error(Quantity::gamma0);
  const std::string share = fixed(100 * seen / change, 0);
  return {{"thermal deformation is small: 1 − κ at Pe = 4360",
           "p. 2582",
           "small",
           fixed(seen, 5),
           fixed(change, 5),
           fixed(1 - y.value(Quantity::load_ratio), 5),
           verdict(std::abs(change) < 0.01, "though n = 200 sees " + share + " % of it"),
           {"sec:claims-deformation",
            "Claims on the load ratio and the constant",
            {"NodesFigure.SchemeSeesASeventhOfTheThermalCorrection"},
            "fig:nodes"}},
          {"γ0 tends to zero with n (at n = 50, 400)",
           "(46)",
           "0",
           gamma0_at(50) + ", " + gamma0_at(400),
           fixed(x.value(Quantity::gamma0), 5),
           fixed(y.value(Quantity::gamma0), 5),
           verdict(vanishes),
           {"sec:eccentricity",
            "The scheme's constant at a number of nodes",
            {"PublishedScheme.GammaTendsToALimit"}}}};
}

struct Changes {
  double pressure = 0, traction = 0, border = 0;
};

void add_to(Changes& largest, const PaperScene& scene, const CoupledSolution& x, const Profile& p) {
  const Carter cold = paper::closed_form(scene.traction);
  for (Eigen::Index i = 0; i < p.s.size(); ++i) {
    raise(largest.pressure, pi / 2 * std::abs(p.pressure(i) - hertz_pressure(p.s(i))));
    raise(largest.traction,
          pi / 2 / paper::friction * std::abs(p.traction(i) - carter_traction(cold, p.s(i))));
  }
  raise(largest.border, std::abs(x.value(Quantity::stick_slip_border) - cold.c0));
}

Claim on_tractions(const std::vector<PaperScene>& scenes) {
  Changes printed, corrected;
  for (const PaperScene& x : scenes) {
    add_to(printed, x, x.coupled, x.profile);
    add_to(corrected, x, x.corrected, x.corrected_profile);
  }
  const auto cell = [](const Changes& x) {
    return "p* by " + fixed(100 * x.pressure, 2) + " %, q* by " + fixed(100 * x.traction, 1) +
           " %, c0 by " + fixed(x.border, 4);
  };
  const std::string next = printed.traction > 0.01 ? "but for q* next to the border" : "";
  return {"the effect of heat on normal and tangential traction can be neglected",
          "p. 2582",
          "yes",
          "–",
          cell(printed),
          cell(corrected),
          verdict(printed.pressure < 0.01 && printed.border < 0.02, next),
          {"sec:claims-deformation",
           "The claim on the tractions",
           {"Claims.HeatChangesTheTractionsLittle"},
           "fig:traction"}};
}

Claim on_the_sign() {
  const auto sign = [](Formulation x) { return slope_sign(x) > 0 ? "+" : "−"; };
  const std::string printed = sign(Formulation::printed), ours = sign(Formulation::corrected);
  Verdict judged = verdict(printed == ours);
  if (printed != ours) judged.words = "does not hold: its own sign convention requires " + ours;
  return {"sign of the thermal term in the normal equation",
          "(7), (11), (25), (39)",
          printed,
          printed,
          printed,
          ours,
          judged,
          {"sec:derivation",
           "The sign of the thermal slope",
           {"HeatedHalfSpace.FollowsTheKernels"},
           "fig:sign"}};
}

Claim on_two_bodies() {
  const auto hottest = [](const Roller& roller) {
    const Scene scene{paper::friction, paper::peclet, paper::heating, roller};
    return solve(scene, {Quantity::traction, 0.5}).value(Quantity::max_temperature);
  };
  const double ratio = hottest({1, paper::heating}) / hottest({});
  return {"both bodies may conduct: T*max of two over that of one at Pe = 4360",
          "p. 2584",
          "future work",
          "–",
          "–",
          fixed(ratio, 3),
          computed(std::abs(2 * ratio - 1) < 0.01, "half as hot"),
          {"sec:claims-future",
           "Claim on two bodies that conduct",
           {"Claims.TwoBodiesAreHalfAsHot"},
           "fig:braking"}};
}

Claim on_hot_friction() {
  const TractionLimit top = paper::largest_traction(paper::wheel(false, true));
  const double share = top.traction / paper::friction;
  return {"friction may depend on temperature: largest Q* at Pe = 4360, none left at 1600 °C",
          "p. 2583",
          "possible",
          "–",
          "–",
          fixed(top.traction, 3) + " at the creep " + fixed(top.creep, 3),
          computed(share > 0.5 && share < 0.99, fixed(100 * share, 0) + " % of f"),
          {"sec:claims-future",
           "Claim on friction that depends on temperature",
           {"Claims.HotFrictionHasALargestTraction"},
           "fig:hot-friction"}};
}

Claims on_what_cannot_be_tested() {
  const auto row = [](const std::string& claim, const std::string& source, const std::string& why,
                      const std::string& figure) {
    const Verdict judged{Judgement::untestable, "not testable: " + why};
    return Claim{claim,
                 source,
                 "yes",
                 "–",
                 "–",
                 "–",
                 judged,
                 {"sec:claims-untestable",
                  "Statements that cannot be tested",
                  {"Claims.VerdictsFollowFromTheTable"},
                  figure}};
  };
  return {row("the formulation is more general than those published before", "p. 2584",
              "about other work", ""),
          row("the temperature can have a great influence on friction", "p. 2583",
              "a law of friction is an input", "fig:hot-friction"),
          row("the number of nodes depends on the input", "p. 2580", "their choice for a scene",
              "fig:seen")};
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
          {"relative accuracy 0.1 % with n = 50 … 200",
           "p. 2580",
           "0.1 %",
           "T*max within " + fixed(x.coarse_error, 1) + " % … " + fixed(x.fine_error, 1) + " %",
           "–",
           "–",
           verdict(x.converged, exact ? "" : "for the iteration, not for T*max"),
           {"sec:claims-iteration",
            "All runs are recorded",
            {"Claims.RecordIsThatOfTheRuns"},
            "fig:nodes"}}};
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

Verdict verdict_on(const std::string& paper, double ours) {
  const double percent = 100 * (std::stod(paper) / ours - 1);
  if (std::abs(percent) < 0.5) return {Judgement::holds, "holds"};
  const std::size_t point = paper.find('.');
  const std::size_t decimals = point == paper.npos ? 0 : paper.size() - point - 1;
  if (fixed(ours, static_cast<int>(decimals)) == paper) return {Judgement::holds, "holds, rounded"};
  const std::string off = fixed(std::abs(percent), 1) + " % " + (percent > 0 ? "high" : "low");
  if (std::abs(percent) < 5) return {Judgement::near, "paper " + off};
  return {Judgement::not_reproduced, "not reproduced: " + off};
}

Verdict verdict(bool holds, const std::string& restriction) {
  if (!holds) return {Judgement::fails, "does not hold"};
  if (restriction.empty()) return {Judgement::holds, "holds"};
  return {Judgement::restricted, "holds, " + restriction};
}

int count_of(const std::vector<Claim>& all, Judgement outcome) {
  return static_cast<int>(std::count_if(
      all.begin(), all.end(), [&](const Claim& c) { return c.verdict.outcome == outcome; }));
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
  Verdict judged = verdict(converged && found <= most && 2 * found >= most);
  if (converged && 2 * found < most)
    judged = {Judgement::not_reproduced, "not reproduced: " + std::to_string(found) + " suffice"};
  const std::string count = std::to_string(most);
  return {"iterations on " + unknown + " to 0.1 %, at most",
          "p. 2580",
          count,
          std::to_string(found),
          "–",
          "–",
          judged,
          {"sec:claims-iteration",
           "A run is recorded",
           {"Claims.RecordIsThatOfTheRuns", "Claims.StepsAreReproducedWithinAFactorOfTwo"}}};
}

std::vector<Claim> claims() {
  const std::vector<PaperScene> scenes = sixteen_scenes();
  Claims all;
  for (const Claims& some :
       {on_the_data(), on_the_temperature(),
        Claims{on_phases(), on_variation(scenes), on_sliding()}, on_tractions_drawn(scenes),
        on_temperatures_drawn(scenes), on_slip(scenes), on_deformation(),
        Claims{on_tractions(scenes), on_the_sign()}, Claims{on_two_bodies(), on_hot_friction()},
        on_the_iteration(scenes), on_what_cannot_be_tested()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace thermoroll
