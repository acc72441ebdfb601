// The results that all methods report through, checked from outside.
#include "driven.hpp"
#include "thermoroll/solution.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <typeinfo>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "solver/contact_grid.hpp"
#include "solver/curves.hpp"
#include "thermoroll/carter.hpp"

using namespace thermoroll;
using enum thermoroll::Quantity;

namespace {

const Approach closed_form{.method = Method::closed_form};
const Approach scheme{.formulation = Formulation::printed, .method = Method::gauss_chebyshev};

/// Scenes with friction 0.05 to 2 and traction / friction down to 1e-6 from either end.
std::vector<Driven> random_scenes(int count) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Driven> scenes;
  for (int i = 0; i < count; ++i) {
    const double friction = 0.05 * std::pow(40, uniform(generator));
    const double near_end = std::pow(10, -6 * uniform(generator)) / 2;
    const double share = uniform(generator) < 0.5 ? near_end : 1 - near_end;
    scenes.push_back({friction, share * friction, 100, 0});
  }
  return scenes;
}

/// A scene with these groups at the load and the half-width of the wheel.
PhysicalScene physical_scene(const Driven& scene) {
  PhysicalScene c = wheel_on_rail();
  c.speed = 2 * c.diffusivity * scene.peclet / c.half_width;
  c.expansion = scene.heating * c.half_width * c.conductivity /
                (2 * (1 + c.poisson) * c.diffusivity * c.load);
  return c;
}

// The peaks of the closed form in long double. The flux (b + h u) sqrt(u (1 - u)) has one maximum,
// which a golden section finds to the root of rounding, and its value to rounding.
Peaks exact_peaks(const Driven& scene) {
  const long double f = scene.friction, q = scene.traction, b = std::sqrt((f - q) / f);
  const long double h = q / f / (1 + b), long_pi = std::acos(-1.0L), golden = 0.6180339887L;
  const auto flux = [&](long double u) {
    return 8 * f / (long_pi * long_pi) * 2 * h * (b + h * u) * std::sqrt(u * (1 - u));
  };
  long double low = 0, high = 1;
  while (high - low > 1e-9L) {
    const long double inner = golden * (high - low);
    if (flux(high - inner) > flux(low + inner))
      high = low + inner;
    else
      low = high - inner;
  }
  const long double root = 2 * b > 1 ? 2 * std::sqrt(h * b) : 1;
  return {static_cast<double>(2 / long_pi), static_cast<double>(2 * f / long_pi * root),
          static_cast<double>(flux(low))};
}

constexpr double Peaks::*all_peaks[] = {&Peaks::pressure, &Peaks::traction, &Peaks::heat_flux};
const double ends[] = {1e-12, 1e-9, 1e-6, 1e-3, 0.5, 1 - 1e-3, 1 - 1e-6, 1 - 1e-12};

/// The peaks to a tolerance of 1e-10. Next to full slip, where rounding of the traction forbids it,
/// they are continued from where it does not, from 2e-4 and 1e-4 as linear functions of Carter's
/// b = sqrt(1 - Q*/f). The next term of the series is smaller by another 1e-4; a thousandth of the
/// change covers it.
FoundPeaks fine_peaks(const Driven& scene, Formulation formulation) {
  const Approach tight{formulation, 1e-10, Method::coupled};
  Driven near = scene, nearer = scene;
  if (scene.traction < (1 - 1e-10) * scene.friction) return peaks(solve(scene, tight));
  near.traction = (1 - 4e-8) * scene.friction;
  nearer.traction = (1 - 1e-8) * scene.friction;
  const Peaks x = peaks(solve(near, tight)).value, y = peaks(solve(nearer, tight)).value;
  const double b = std::sqrt((scene.friction - scene.traction) / scene.friction);
  FoundPeaks end{x, x};
  for (const auto peak : all_peaks) {
    end.value.*peak = y.*peak + (y.*peak - x.*peak) * (1 - b / 1e-4);
    *end.error.*peak = 1e-3 * std::abs(y.*peak - x.*peak) + 1e-9 * y.*peak;
  }
  return end;
}

constexpr double PhysicalResults::*all_in_si[] = {
    &PhysicalResults::half_width,    &PhysicalResults::radius,
    &PhysicalResults::creep_ratio,   &PhysicalResults::hertz_pressure,
    &PhysicalResults::max_pressure,  &PhysicalResults::max_traction,
    &PhysicalResults::max_heat_flux, &PhysicalResults::max_temperature_celsius,
    &PhysicalResults::dissipation,   &PhysicalResults::half_width_over_radius};

}  // namespace

// The formulas of the closed form in long double, whose rounding (2^-64) is 2^-11 of double's and
// so does not count: each error must be below what is claimed, and the claims below 8 epsilon.
TEST(Solution, RoundingStaysWithinItsBounds) {
  static_assert(std::numeric_limits<long double>::digits >= 64, "needs a wider long double");
  const long double long_pi = std::acos(-1.0L);
  for (const Driven& scene : random_scenes(200)) {
    const Solution x = solve(scene, closed_form);
    const long double f = scene.friction, q = scene.traction, b = std::sqrt((f - q) / f);
    const long double h = q / f / (1 + b), creep = 2 * f / long_pi * h;
    const auto error = [](double value, long double exact) {
      return static_cast<double>(std::abs(value - exact));
    };
    EXPECT_LE(error(x.value(stick_slip_border), 2 * b - 1), (*x.error)(stick_slip_border));
    EXPECT_LE(error(x.value(Quantity::creep), creep), (*x.error)(Quantity::creep));
    EXPECT_LE(error(x.value(creep_constant), creep), (*x.error)(creep_constant));
    EXPECT_LE(error(x.value(heat_integral), creep * q / f), (*x.error)(heat_integral));
    EXPECT_EQ(x.value(traction), scene.traction);
    EXPECT_EQ(x.value(load_ratio), 1);
    EXPECT_EQ(x.value(gamma0), 0);
    EXPECT_LE((*x.error)(heat_integral), 8 * 2.3e-16 * x.value(heat_integral));
  }
}

// A law may be wrong at the bulk temperature, or only where the contact gets that hot.
TEST(Solution, LawsOfOnesOwnAreChecked) {
  const auto solved = [](const FrictionLaw& law) {
    Scene scene{0.6, 100, 0.0175};
    scene.law = law;
    return solve(scene, {Quantity::creep, 0.3});
  };
  const auto refusal = [&](const FrictionLaw& law) -> std::string {
    try {
      solved(law);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_NO_THROW(solved([](double) { return thermoroll::RelativeFriction{0.5, 0}; }));
  EXPECT_EQ(refusal([](double) {
              return thermoroll::RelativeFriction{-0.2, 0};
            }),
            "the law of friction at T* = 0 = -0.2 is not allowed: it must be zero or positive");
  EXPECT_NE(refusal([](double) {
              return thermoroll::RelativeFriction{std::nan(""), 0};
            }).find("it must be finite and zero or positive"),
            std::string::npos);
  Scene warmer{0.6, 100, 0.0175, {1, 0.0175, 50}};
  warmer.bulk_difference = 0.05;
  warmer.law = [](double t) { return thermoroll::RelativeFriction{1 - 50 * t, -50}; };
  try {
    solve(warmer, {Quantity::stick_slip_border, 0.2});
    ADD_FAILURE() << "friction below zero";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()).find("the law of friction at T* = 0.0"), 0u);
  }
}

// The largest of 20000 samples is below the peak, and near a smooth maximum by at most half the
// curvature times the square of the distance: below 1e-7 of the peak in coordinates of the slip
// zone, where the flux is (b + h u) sqrt(u (1 - u)). The traction has a corner, near which its
// slope may be large, so the corner is one of the samples, by the lengths of both zones, which keep
// their digits.
TEST(Solution, PeaksAreTheLargestValues) {
  for (const Driven& scene : random_scenes(20)) {
    const Peaks x = peaks(solve(scene, closed_form)).value;
    const Carter c = carter(scene.friction, scene.traction);
    double traction = c.friction * 4 / pi * std::sqrt(c.slip_half_width * c.b), flux = 0;
    for (int i = 0; i <= 20000; ++i) {
      const double u = i / 20000.0, width = 2 * c.slip_half_width;
      traction = std::max(traction, carter_traction(c, 2 * u - 1));
      flux = std::max(flux, carter_flux(c).density(width * u, width * (1 - u)));
    }
    EXPECT_NEAR(x.traction / traction, 1, 1e-14);  // a few roundings, as the corner is a sample
    EXPECT_GE(x.traction, traction * (1 - 1e-15));
    EXPECT_NEAR(x.heat_flux / flux, 1, 1e-7);
    EXPECT_GE(x.heat_flux, flux * (1 - 1e-15));
    EXPECT_DOUBLE_EQ(x.pressure, hertz_pressure(0));
  }
}

// Without heat the scheme's tractions are the closed form's to rounding error at its nodes, which
// are cosines of angles pi/(n+1) apart. The angle theta between the top of the pressure and its
// nearest node is at most half of that, and the pressure there is cos(theta) >= 1 - theta^2/2 of
// the top; the border is left of the middle, so the same holds for the traction. The flux is
// narrower, with the half-width h = 0.59 of the slip zone, and twice as curved.
TEST(Solution, PeaksOfTheSchemeAreThoseAtItsNodes) {
  const Driven scene{0.6, 0.5, 100, 0};
  const Peaks exact = peaks(solve(scene, closed_form)).value;
  const Peaks x = peaks(solve(scene, scheme)).value;
  const double theta = pi / 402, missed = theta * theta / 2;
  EXPECT_NEAR(x.pressure / exact.pressure, 1, missed);
  EXPECT_NEAR(x.traction / exact.traction, 1, missed);
  EXPECT_NEAR(x.heat_flux / exact.heat_flux, 1, 2 * missed / (0.59 * 0.59));
}

// The half-width found must meet its definition with the load ratio of its own solution. The last
// step left kappa unchanged to 1e-9 and its estimated error, and a goes with its root.
TEST(Solution, HalfWidthOfRadiusMeetsItsEquation) {
  PhysicalScene c = wheel_on_rail();
  for (const double load : {1e5, 1.2e7, 1e8}) {
    c.load = load;
    for (const Approach& approach : {scheme, Approach{}}) {
      c.half_width = half_width_of_radius(c, 0.46, 0.6, {traction, 0.5}, approach);
      const Solution x = solve(scene_of(c, 0.6), {traction, 0.5}, approach);
      const double kappa = x.value(load_ratio), error = x.error ? (*x.error)(load_ratio) : 0;
      const double hertz = hertz_half_width(kappa * load, 0.46, c.shear_modulus, c.poisson);
      EXPECT_NEAR(c.half_width / hertz, 1, 1e-9 + error);
      EXPECT_NE(kappa, 1);
    }
  }
}

// A hot steel rail under a cold roller that expands more: their distortion carries most of this
// small load, and a wider contact none of it. The fixed-point iteration ends there.
TEST(Solution, HalfWidthWhereHeatCarriesTheLoad) {
  struct Rail {
    double load, temperature;
  };
  for (const Rail& rail : {Rail{1136.02, 220}, Rail{1.2e4, 420}}) {
    PhysicalScene c{rail.load, 0.1, 0, 8.1e10, 0.3, 1.8e-5, 3.5e-6, 13, 1.1e-5, 50, 1.4e-5};
    c.bulk_temperature = 20;
    c.bulk_temperature_2 = rail.temperature;
    c.direction = Direction::braking;
    const Prescribed given{creep, -7.5e-5};
    c.half_width = half_width_of_radius(c, 0.05, 0.3, given, {}, CreepUnit::ratio);
    const Solution x = solve(scene_of(c, 0.3), dimensionless(c, given, CreepUnit::ratio));
    const double kappa = x.value(load_ratio);
    EXPECT_LT(kappa, rail.load < 2000 ? 1 / 3.0 : 1);
    const double hertz = hertz_half_width(kappa * c.load, 0.05, c.shear_modulus, c.poisson);
    EXPECT_NEAR(c.half_width / hertz, 1, 1e-9 + (*x.error)(load_ratio) / kappa);
  }
}

// A contact narrows as its creep rises: beyond the limit of the creep for one half-width a smaller
// one carries the load of the same cylinder.
TEST(Solution, HalfWidthBeyondTheLimitOfAWiderContact) {
  PhysicalScene c{1.2e7, 5.09e-4, 0, 8.1e10, 0.3, 0.02, 1.4e-5, 50};
  double before = 1;
  for (const double ratio : {0.05, 0.1, 0.3}) {
    const Prescribed given{creep, ratio};
    c.half_width = half_width_of_radius(c, 0.229, 0.6, given, {}, CreepUnit::ratio);
    EXPECT_LT(c.half_width, before);
    before = c.half_width;
    const Solution x = solve(scene_of(c, 0.6), dimensionless(c, given, CreepUnit::ratio));
    EXPECT_TRUE(x.violations.empty());
    const double kappa = x.value(load_ratio);
    const double hertz = hertz_half_width(kappa * c.load, 0.229, c.shear_modulus, c.poisson);
    EXPECT_NEAR(c.half_width / hertz, 1, 1e-9 + (*x.error)(load_ratio) / kappa);
  }
}

// Where the scheme diverges, its load ratio may be negative, and no half-width belongs to that. The
// heat of this scene is far beyond any, and seven nodes are too few.
TEST(Solution, NoHalfWidthWithoutALoadRatio) {
  const Driven scene{0.1, 0.03, 10, 1000};
  const PhysicalScene c = physical_scene(scene);
  const Approach coarse{
      .formulation = Formulation::printed, .method = Method::gauss_chebyshev, .nodes = 7};
  ASSERT_LT(solve(scene, coarse).value(load_ratio), 0);
  const double unit = hertz_half_width(c.load, 1, c.shear_modulus, c.poisson);
  const double radius = std::pow(c.half_width / unit, 2);  // kappa is 1 in the first step
  EXPECT_THROW(half_width_of_radius(c, radius, 0.1, {traction, 0.03}, coarse), NotConverged);
}

// The closed form for the border or the creep that belongs to a traction, against its formulas in
// long double: the errors are within what is claimed, and what is given is repeated as it is.
TEST(Solution, GivenCreepOrBorderIsTheSameScene) {
  for (const Driven& scene : random_scenes(40)) {
    const Solution x = solve(scene, closed_form);
    const long double long_pi = std::acos(-1.0L), f = scene.friction;
    const Solution by_border =
        solve(scene, {stick_slip_border, x.value(stick_slip_border)}, closed_form);
    const long double h = (1 - static_cast<long double>(x.value(stick_slip_border))) / 2;
    const auto error = [](double value, long double exact) {
      return static_cast<double>(std::abs(value - exact));
    };
    EXPECT_LE(error(by_border.value(traction), f * h * (2 - h)), (*by_border.error)(traction));
    EXPECT_LE(error(by_border.value(creep), 2 * f / long_pi * h), (*by_border.error)(creep));
    EXPECT_EQ(by_border.value(stick_slip_border), x.value(stick_slip_border));
    EXPECT_EQ((*by_border.error)(stick_slip_border), 0);
    const Solution by_creep = solve(scene, {creep, x.value(creep)}, closed_form);
    const long double k = long_pi * x.value(creep) / (2 * f);
    EXPECT_LE(error(by_creep.value(traction), f * k * (2 - k)), (*by_creep.error)(traction));
    EXPECT_LE(error(by_creep.value(stick_slip_border), 1 - 2 * k),
              (*by_creep.error)(stick_slip_border));
    EXPECT_LE(error(by_creep.value(heat_integral), x.value(creep) * k * (2 - k)),
              (*by_creep.error)(heat_integral));
    EXPECT_EQ(by_creep.value(creep), x.value(creep));
  }
}

// With heat, ten times the estimated error covers the change to a far finer solution.
TEST(Solution, CoupledErrorsCoverAFinerSolution) {
  const Driven scene{0.6, 0.5, 100, 1};
  for (const Prescribed& given :
       {Prescribed{traction, 0.5}, Prescribed{creep, 0.2}, Prescribed{stick_slip_border, -0.2}}) {
    Approach approach;
    approach.tolerance = 1e-4;
    const Solution x = solve(scene, given, approach);
    approach.tolerance = 1e-9;
    const Solution fine = solve(scene, given, approach);
    for (const auto& [quantity, key, symbol] : reported)
      EXPECT_LE(std::abs(x.value(quantity) - fine.value(quantity)), 10 * (*x.error)(quantity))
          << key;
    EXPECT_LT((*x.error)(eccentricity), pi * 1e-4);
    EXPECT_DOUBLE_EQ(x.value(eccentricity), pi * x.value(gamma0) / (2 * x.value(load_ratio)));
  }
}

// Without heat the profiles of the coupled solver lie on the closed form's curves. They are roots
// of distances from the edges and the border, in which a rounding of s weighs as it weighs in the
// distance.
TEST(Solution, ProfilesOfBothMethodsAgreeWithoutHeat) {
  const Driven scene{0.6, 0.5, 100, 0};
  const Carter c = carter(0.6, 0.5);
  const Profile x = profile(solve(scene)), y = profile(solve(scene, closed_form));
  for (const Profile& z : {x, y})
    for (Eigen::Index i = 0; i < z.s.size(); ++i) {
      EXPECT_NEAR(z.pressure(i), hertz_pressure(z.s(i)), 1e-12);
      EXPECT_NEAR(z.traction(i), carter_traction(c, z.s(i)), 1e-12);
      const double near = std::min(1 - z.s(i), std::abs(z.s(i) - c.c0));
      EXPECT_NEAR(z.slip(i), carter_slip(c, z.s(i)), 1e-12 + 1e-15 / std::max(near, 1e-15));
      EXPECT_NEAR(z.heat_flux(i), z.slip(i) * z.pressure(i), 1e-15);
    }
  EXPECT_EQ(y.s(0), -1);
  EXPECT_EQ(y.s(100), c.c0);
  EXPECT_EQ(y.s(200), 1);
  const std::vector<double> at(x.s.begin(), x.s.end());
  const Curve curve = temperature_curve(solve(scene, closed_form), at, 0);
  for (std::size_t i = 0; i < at.size(); ++i)
    EXPECT_NEAR(x.temperature(static_cast<Eigen::Index>(i)), curve.points[i].temperature, 1e-9);
}

namespace {

/// Scenes of each kind that has profiles of its own, by the least model and on a coarse grid.
std::vector<Solution> profiled() {
  const Scene scene{0.6, 100, 0.5}, cold{0.6, 100, 1e-9}, moved_ends{0.8, 2e5, 0.8};
  Scene pair = scene, warm = scene, hot = scene;
  pair.roller = {2, 0.7, 20};
  warm.roller = {1, 0.5};
  warm.bulk_difference = 0.01;
  hot.law = linear_friction({0.05});
  const Approach rough{.tolerance = 1e-2};
  return {solve(scene, {traction, 0.5}),
          solve(scene, {traction, -0.5}, rough),
          solve(cold, {traction, 0.3}),
          solve(scene, {creep, 0.6}),
          solve(pair, {creep, 0.1}),
          solve(warm, {stick_slip_border, 0.1}, rough),
          solve(hot, {creep, 0.1}),
          solve(hot, {creep, 0.7}, rough),
          solve(scene, {traction, 1e-6}),
          solve(scene, {traction, 0.5999999}),
          solve(moved_ends, {traction, 0.4}, {.tolerance = 1e-4})};
}

}  // namespace

// At the nodes the series of a plot have the values of the solver, which they interpolate: what a
// Legendre series of 480 terms loses to rounding is far below 1e-10 of the largest. The temperature
// is within the error that the curve states.
TEST(Solution, ProfileAtPointsIsThatOfTheNodes) {
  for (const Solution& x : profiled()) {
    const auto& found = std::get<CoupledSolution>(x.found);
    const Profile z = profile(found);
    const int n = found.unknowns, m = static_cast<int>(z.s.size()) - n;
    const Profile y = profile_at(found, {gauss_legendre(m).x.reverse(), gauss_legendre(n).x});
    ASSERT_EQ(y.s.size(), z.s.size());
    for (const auto curve :
         {&Profile::s, &Profile::pressure, &Profile::traction, &Profile::slip, &Profile::heat_flux})
      EXPECT_LE(((y.*curve) - (z.*curve)).abs().maxCoeff(), 1e-10 * (z.*curve).abs().maxCoeff());
    const Profile own = profile(x);
    const Curve curve = temperature_curve(x, {own.s.begin(), own.s.end()}, 0);
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      EXPECT_NEAR(curve.points[i].temperature, own.temperature(static_cast<Eigen::Index>(i)),
                  *curve.points[i].error);
  }
}

std::vector<Scene> scenes_with_profiles() {
  std::vector<Scene> all{{0.6, 4360, 0.0175}, {0.6, 100, 1}, {0.5, 16, 0.2, {1, 0.2, 32}}};
  Scene warm = all.back();
  warm.bulk_difference = -0.2;
  warm.direction = Direction::braking;
  Scene hot{0.6, 100, 0.2};
  hot.law = linear_friction({0.03});
  all.push_back(warm);
  all.push_back(hot);
  return all;
}

/// A solution at the border -0.7, or in full slip.
Solution solved(const Scene& scene, bool slips, double tolerance) {
  const Prescribed partial{stick_slip_border, -0.7}, full{creep, 0.6 * sign_of(scene.direction)};
  return solve(scene, slips ? full : partial, {.tolerance = tolerance});
}

/// The largest differences at 33 places in either zone of x, which is as long to moved in y.
ProfileErrors apart(const Solution& x, const Solution& y, double moved = 1e-7) {
  const auto &a = std::get<CoupledSolution>(x.found), &b = std::get<CoupledSolution>(y.found);
  const SmoothTractions to = smooth_tractions(b, b.unknowns);
  const Eigen::ArrayXd at = Eigen::ArrayXd::LinSpaced(33, -1, 1);
  const Eigen::ArrayXd other = stick_places(at, smooth_tractions(a, a.unknowns), to);
  const bool slips = x.value(stick_slip_border) == -1;
  const auto points = [&](const Eigen::ArrayXd& ahead) {
    return slips ? PlotPoints{{}, at} : PlotPoints{ahead.reverse(), at};
  };
  const Profile own = profile_at(a, points(at)), finer = profile_at(b, points(other));
  EXPECT_LT((own.s - finer.s).abs().maxCoeff(), moved);
  const auto most = [&](Eigen::ArrayXd Profile::*curve) {
    return (own.*curve - finer.*curve).abs().maxCoeff();
  };
  return {most(&Profile::pressure), most(&Profile::traction), most(&Profile::slip),
          most(&Profile::heat_flux), 0};
}

// Against a finer solution, at the same places of both zones. Those of two grids are the same to
// rounding next to the border. With a bulk difference the pressure is off by more than ten
// tolerances.
TEST(Solution, ProfilesAreWithinTheirErrors) {
  double worst = 0;
  for (const Scene& scene : scenes_with_profiles())
    for (const bool slips : {false, true}) {
      const Solution y = solved(scene, slips, 1e-7);
      const ProfileErrors left = *profile(y, 2).error;
      for (const double tolerance : {1e-2, 1e-3, 1e-5}) {
        const Solution x = solved(scene, slips, tolerance);
        const Profile at = profile(x, 33);
        const ProfileErrors off = apart(x, y);
        for (const auto of : {&ProfileErrors::pressure, &ProfileErrors::traction,
                              &ProfileErrors::slip, &ProfileErrors::heat_flux})
          EXPECT_LE(off.*of, at.error.value().*of + left.*of)
              << scene.peclet << ' ' << scene.bulk_difference << ' ' << slips << ' ' << tolerance;
        worst = std::max(worst, off.pressure / tolerance);
        const Curve curve = temperature_curve(y, {at.s.begin(), at.s.end()}, 0);
        for (Eigen::Index i = 0; i < 33; ++i)
          EXPECT_NEAR(at.temperature(i), curve.points[static_cast<std::size_t>(i)].temperature,
                      at.error->temperature + left.temperature);
      }
    }
  EXPECT_GT(worst, 10);
}

// With a given traction the border is off, and with it both zones: the pressure by seven times
// twice the change of the grid.
TEST(Solution, ProfilesCountTheErrorOfTheHeat) {
  const Scene scene{0.3, 20, 0.3};
  const Prescribed given{traction, 0.15};
  const Solution x = solve(scene, given, {.tolerance = 1e-2}),
                 y = solve(scene, given, {.tolerance = 1e-8});
  const double moved = 2 * (*x.error)(stick_slip_border);
  EXPECT_LE(apart(x, y, moved).pressure, profile(x).error->pressure);
  EXPECT_LE(apart(x, y, moved).traction, profile(x).error->traction);
}

// Asked for by name it does not count the heat, and its curves are formulas.
TEST(Solution, ProfilesOfTheClosedFormHaveErrorsOfRounding) {
  const Profile y = profile(solve({0.6, 4360, 0.0175}, {traction, 0.4}, closed_form), 99);
  EXPECT_LT(y.error->pressure, 2e-15);
  EXPECT_GT(y.error->pressure, 1e-16);
  EXPECT_LT(y.error->temperature, 1e-8 * y.temperature.maxCoeff());
}

// The local coefficient is that of the tractions: |q| = f(T) p where it slips, and less elsewhere.
// T is off by two errors of the hottest point at most, f(T) by f / T0* times that, and p is below
// one. The traction is a factor of the series, whose tail is below the tolerance.
TEST(Solution, FrictionOfAProfileIsThatOfItsTractions) {
  for (const double given : {0.1, -0.1, 0.7}) {
    Scene hot{0.6, 100, 0.5};
    hot.law = linear_friction({0.05});
    const Solution x = solve(hot, {creep, given}, {.tolerance = 1e-7});
    const double off = 0.6 / 0.05 * 2 * (*x.error)(max_temperature) + 1e-7;
    for (const Profile& y : {profile(x), profile(x, 101)}) {
      ASSERT_EQ(y.friction.size(), y.s.size());
      for (Eigen::Index i = 0; i < y.s.size(); ++i) {
        EXPECT_NEAR(y.friction(i), 0.6 * (1 - y.temperature(i) / 0.05), 1e-15);
        const double limit = y.friction(i) * y.pressure(i), q = std::abs(y.traction(i));
        EXPECT_LE(q, limit + off) << given << ' ' << y.s(i);
        if (y.slip(i) == 0) continue;
        EXPECT_NEAR(q, limit, off) << given << ' ' << y.s(i);
      }
    }
  }
  EXPECT_EQ(profile(solve({0.6, 100, 0.5}, {creep, 0.1})).friction.size(), 0);
}

// Nodes at a kink of a law leave rounding in the distances from the edges, and roots of these. A
// zero has no sign, also where the bodies brake.
TEST(Solution, ProfilesEndAtZero) {
  for (const double reference : {0.0005, 0.001, 0.002})
    for (const double creep : {0.1, -0.3, 0.5}) {
      Scene scene{0.3, 100, 0.01};
      scene.law = linear_friction({0.02, 0, reference});
      const Solution x = solve(scene, {Quantity::creep, creep});
      for (const int points : {2, 101}) {
        const Profile y = profile(x, points);
        for (const auto curve : {&Profile::pressure, &Profile::traction, &Profile::heat_flux})
          EXPECT_EQ((y.*curve)(points - 1), 0) << reference << ' ' << creep;
        EXPECT_TRUE(y.slip.allFinite());
        for (const auto curve : {&Profile::traction, &Profile::slip})
          for (const double value : y.*curve) EXPECT_FALSE(value == 0 && std::signbit(value));
      }
    }
}

// Any number of points ascends from edge to edge. Twice as many intervals have every other point in
// common, though the series are summed in blocks of a thousand.
TEST(Solution, ProfileHasAnyNumberOfPoints) {
  std::vector<Solution> all = profiled();
  all.push_back(solve({0.6, 100, 0}, {traction, 0.5}, closed_form));
  all.push_back(solve({0.6, 100, 0}, {traction, 0}));
  for (const Solution& x : all) {
    const double end = x.scene.bulk_difference == 0 ? 1 : 0;
    for (const int points : {2, 3, 4, 5, 50}) {
      const Profile y = profile(x, points);
      ASSERT_EQ(y.s.size(), points);
      for (Eigen::Index i = 1; i < points; ++i) EXPECT_LT(y.s(i - 1), y.s(i));
      EXPECT_LE(std::abs(y.s(0)), 1);
      EXPECT_EQ(y.s(0) == -1 && y.s(points - 1) == 1, end == 1);
      for (const auto curve : {&Profile::pressure, &Profile::traction, &Profile::slip,
                               &Profile::heat_flux, &Profile::temperature})
        EXPECT_TRUE((y.*curve).allFinite());
      EXPECT_TRUE(y.heat_flux_1.allFinite() && y.heat_flux_2.allFinite());
    }
  }
  for (const std::size_t i : {std::size_t{0}, std::size_t{3}, all.size() - 2}) {
    const Profile few = profile(all[i], 2501), many = profile(all[i], 5001);
    for (const auto curve :
         {&Profile::s, &Profile::pressure, &Profile::traction, &Profile::slip, &Profile::heat_flux})
      for (Eigen::Index k = 0; k < 2501; ++k)
        EXPECT_NEAR((few.*curve)(k), (many.*curve)(2 * k), 1e-13);
  }
  EXPECT_THROW(profile(all[0], 1), std::invalid_argument);
  EXPECT_THROW(profile(all[0], 100001), std::invalid_argument);
  EXPECT_THROW(profile(solve({0.6, 0.5, 100, 0}, scheme), 100), std::invalid_argument);
}

// Without heat every method that states errors has the closed form's peaks to within its error,
// however short a zone is. The closed form's errors are of rounding, and the tolerance of the
// others is relative.
TEST(Solution, PeaksKeepTheirDigitsAtBothEnds) {
  for (const double share : ends)
    for (const Method method : {Method::closed_form, Method::automatic, Method::coupled}) {
      const Driven scene{0.6, 0.6 * share, 4360, 0};
      const Peaks exact = exact_peaks(scene);
      const FoundPeaks x = peaks(solve(scene, {.method = method}));
      const double most = method == Method::closed_form ? 2e-15 : 1e-6;
      for (const auto peak : all_peaks) {
        EXPECT_NEAR(x.value.*peak, exact.*peak, *x.error.*peak) << share;
        EXPECT_LE(*x.error.*peak, most * exact.*peak) << share;
      }
    }
}

// Where `auto` takes the closed form, its peaks are the closed form's, whatever is left out: that
// is in their errors. Its profile has the closed form's tractions, to rounding, as above.
TEST(Solution, PeaksOfTheClosedFormThatWasChosen) {
  const Driven scene{0.6, 0.3, 100, 1e-4};
  const Approach loose{Formulation::printed, 1e-2};
  const Solution x = solve(scene, loose);
  ASSERT_EQ(x.model, Model::closed_form);
  const FoundPeaks chosen = peaks(x), fine = peaks(solve(scene, {.formulation = loose.formulation,
                                                                 .method = Method::coupled}));
  const Peaks exact = peaks(solve(scene, closed_form)).value;
  for (const auto peak : all_peaks) {
    EXPECT_DOUBLE_EQ(chosen.value.*peak, exact.*peak);
    EXPECT_NEAR(chosen.value.*peak, fine.value.*peak, *chosen.error.*peak);
  }
  const Profile y = profile(x);
  const Carter c = carter(0.6, 0.3);
  for (Eigen::Index i = 0; i < y.s.size(); ++i) {
    EXPECT_NEAR(y.pressure(i), hertz_pressure(y.s(i)), 1e-12);
    EXPECT_NEAR(y.traction(i), carter_traction(c, y.s(i)), 1e-12);
  }
}

// In full slip the flux grows with the creep, and its peak is that of the creep that was given.
TEST(Solution, PeaksOfTheClosedFormInFullSlip) {
  const Scene scene{0.6, 100, 1e-4};
  const Prescribed given{creep, 4 * 0.6 / thermoroll::pi};
  const Solution x = solve(scene, given, {.tolerance = 1e-2});
  ASSERT_EQ(x.model, Model::closed_form);
  const FoundPeaks chosen = peaks(x);
  const FoundPeaks fine = peaks(solve(scene, given, {.method = Method::coupled}));
  for (const auto peak : all_peaks) {
    EXPECT_NEAR(chosen.value.*peak, fine.value.*peak, *chosen.error.*peak);
    EXPECT_LE(*chosen.error.*peak, 2e-2 * chosen.value.*peak);
  }
}

// Tractions made of constants, whose peaks can be told. With p-hat = 2/pi everywhere, the largest
// pressure is 2/pi, in the middle. Where nothing corrects it, the traction of the stick zone is f
// times the pressure, so that its peak is in the middle of the contact, too, and not at the border.
// Where more pressure is on one zone than on the other, its peak is on that, or at the border.
TEST(Solution, PeaksMayBeAnywhere) {
  const auto constant = [](double x) { return Eigen::VectorXd::Constant(1, x); };
  const double unit = 2 / pi;
  for (const double slip : {1e-9, 0.1, 0.5, 0.9}) {
    const double root = std::sqrt(slip * (2 - slip));  // of (1 - s^2) at the border
    const auto made = [&](double on_slip, double on_stick, double bracket) {
      return largest(
          {slip, 2 - slip, constant(0.1), constant(on_slip), constant(on_stick), constant(bracket)},
          0.6);
    };
    EXPECT_NEAR(made(unit, unit, 0).pressure, unit, 1e-15);
    EXPECT_NEAR(made(unit, unit, 0).traction, 0.6 * unit, 1e-15);
    EXPECT_NEAR(made(unit, unit, 0.6 * unit).traction / (0.6 * unit * root), 1, 1e-14);
    EXPECT_NEAR(made(9, unit / 1e9, 0.6).pressure / (9 * root), 1, 1e-14);
    EXPECT_NEAR(made(unit, unit, 0).heat_flux / (slip / 2 * 0.1), 1, 1e-14);
  }
}

// Fast scenes in which the error of the heat is too small for a peak, against a tighter solution.
// The error counts the change between two grids, and so it is no less than that.
TEST(Solution, PeakErrorsCountTheChangeOfTheGrid) {
  for (const Driven& scene :
       {Driven{1.01, 0.4226, 7.84e5, 3.298e-5}, Driven{0.696, 0.2467, 6.107e7, 1.168e-3},
        Driven{1.33, 0.4569, 8.209e5, 4.077e-4}, Driven{1.38, 0.5873, 3.135e7, 1.509e-6}}) {
    const Solution x = solve(scene, {.method = Method::coupled});
    const auto& found = std::get<CoupledSolution>(x.found);
    const auto on = [&](int n) { return largest(smooth_tractions(found, n), scene.friction); };
    const Peaks own = on(found.unknowns), finer = on(3 * found.unknowns / 2);
    const FoundPeaks peak = peaks(x);
    const FoundPeaks fine = peaks(solve(scene, {Formulation::corrected, 1e-9, Method::coupled}));
    for (const auto which : all_peaks) {
      EXPECT_GE(*peak.error.*which, std::abs(finer.*which - own.*which)) << scene.peclet;
      EXPECT_NEAR(peak.value.*which, fine.value.*which, *peak.error.*which + *fine.error.*which);
    }
  }
}

// At high speed 60 and 90 nodes agree on the traction at the border, and both are off by 4e-7, six
// times as much as their difference and the error of the heat told.
TEST(Solution, PeaksOfTwoGridsThatAgreeByChance) {
  Scene scene{0.469864127, 6598142.46, 0.0645045227};
  scene.roller = {1, scene.heating};
  scene.direction = Direction::braking;
  const Prescribed given{Quantity::traction, 0.345968941392373};
  const auto to = [&](double tolerance) {
    return peaks(thermoroll::solve(scene, given, {Formulation::corrected, tolerance}));
  };
  const FoundPeaks x = to(1e-6), fine = to(1e-9);
  for (const auto peak : all_peaks)
    EXPECT_NEAR(x.value.*peak, fine.value.*peak, *x.error.*peak + *fine.error.*peak);
}

// On a grid other than its own a solution does not hand down its h, but that of the equations: a
// loose solution and a tight one at the same border have the same. Newton's method stops at 1e-10.
TEST(Solution, AnotherGridHasItsOwnFlux) {
  for (const Formulation formulation : {Formulation::printed, Formulation::corrected}) {
    const Driven scene{0.6, 0.3, 300, 1};
    const auto on_other = [&](double tolerance) {
      const Solution x =
          solve(scene, {stick_slip_border, 0.2}, {formulation, tolerance, Method::coupled});
      return smooth_tractions(std::get<CoupledSolution>(x.found), 50);
    };
    const SmoothTractions loose = on_other(1e-2), tight = on_other(1e-8);
    EXPECT_LT((loose.h - tight.h).norm(), 1e-9 * tight.h.norm());
    EXPECT_LT((loose.pressure - tight.pressure).norm(), 1e-9 * tight.pressure.norm());
    EXPECT_LT((loose.bracket - tight.bracket).norm(), 1e-9 * tight.bracket.norm());
  }
}

// Of many tops the highest is found, in series whose coefficients decrease as a solution's do.
// Samples that are 1e-4 apart miss it by 1e-8/2 times the curvature, which for a Legendre series
// of degree 24 is below its degree to the fourth power.
TEST(Solution, PeaksAreTheHighestOfManyTops) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int k = 0; k < 40; ++k) {
    Eigen::VectorXd pressure(25);
    for (Eigen::Index l = 0; l < 25; ++l) pressure(l) = uniform(generator) * std::pow(0.85, l);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(25);
    const Eigen::ArrayXd y = Eigen::ArrayXd::LinSpaced(20001, -1, 1);
    const Eigen::ArrayXd series = legendre(y, 25) * pressure;
    double highest = 0;
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const double right = 0.8 * (1 - SlipPoint(1 + y(i), 1 - y(i)).t());
      highest = std::max(highest, std::sqrt(right * (2 - right)) * series(i));
    }
    const double found = largest({0.8, 1.2, zero, pressure, zero, zero}, 0.6).pressure;
    EXPECT_GE(found, highest * (1 - 1e-14));
    EXPECT_NEAR(found, highest, 0.5e-8 * std::pow(24, 4));
  }
}

// Of the grids that are looked at the finest counts, which is 480 at the most; but a lesser model
// keeps its own peaks.
TEST(Solution, PeaksAreOfTheModelOnTheFinestGrid) {
  int finest = 0;
  for (const Method method : {Method::coupled, Method::first_order})
    for (const double tolerance : {1e-2, 1e-4, 1e-11}) {
      const Driven scene{0.6, 0.3, 1000, method == Method::coupled ? 4 : 0.1};
      const Solution x = solve(scene, {Formulation::printed, tolerance, method});
      const auto& found = std::get<CoupledSolution>(x.found);
      int n = found.unknowns;
      finest = std::max(finest, n);
      if (method == Method::coupled && n <= 320) n = 3 * n / 2;
      const Peaks y = largest(smooth_tractions(found, n), 0.6);
      for (const auto peak : all_peaks) EXPECT_EQ(peaks(x).value.*peak, y.*peak) << n;
    }
  EXPECT_GT(finest, 320);
}

// No node of the profile is above the peak by more than its error, and the highest is hardly
// below: the nodes are at most pi/n apart in the variable of their zone, half of that from the
// top, and there a curve that changes over a tenth of the zone falls by 100/2 (pi/2n)^2 of itself.
TEST(Solution, PeaksLieOnTheProfile) {
  for (const Formulation formulation : {Formulation::printed, Formulation::corrected})
    for (const double traction : {0.05, 0.3, 0.5, 0.59})
      for (const double heating : {0.1, 3.0}) {
        const Solution x =
            solve({0.6, traction, 300, heating}, {formulation, 1e-7, Method::coupled});
        const double n = 0.75 * std::get<CoupledSolution>(x.found).unknowns;
        const double missed = 50 * std::pow(pi / (2 * n), 2);
        const Profile y = profile(x);
        const FoundPeaks peak = peaks(x);
        const auto expect_top = [&](const Eigen::ArrayXd& curve, double Peaks::*which) {
          const double highest = curve.maxCoeff();
          EXPECT_LE(highest, peak.value.*which + *peak.error.*which) << traction << ' ' << heating;
          EXPECT_GE(highest, peak.value.*which * (1 - missed)) << traction << ' ' << heating;
        };
        expect_top(y.pressure, &Peaks::pressure);
        expect_top(y.traction, &Peaks::traction);
        expect_top(y.heat_flux, &Peaks::heat_flux);
      }
}

/// Scenes whose friction falls, rises and ends at a floor, partly and wholly slipping.
std::vector<std::pair<Scene, Prescribed>> hot_scenes() {
  std::vector<std::pair<Scene, Prescribed>> scenes;
  const FrictionTemperature smooth{0.02, 0.2}, rises{-0.02};
  for (const FrictionLaw& law : {linear_friction(rises), exponential_friction(smooth),
                                 rational_friction(smooth), piecewise_linear_friction(smooth)})
    for (const Prescribed given :
         {Prescribed{creep, 0.1}, {creep, 0.5}, {stick_slip_border, 0.4}}) {
      Scene scene{0.6, 100, 0.5};
      scene.law = law;
      scenes.emplace_back(scene, given);
    }
  return scenes;
}

// At low speed the stick zone is warm beside the border as well, and the traction there is f phi p
// less the bracket, with a peak at the border, beside which the outermost node lies.
TEST(Solution, PeaksOfTheTractionKnowTheLawOnTheStickZone) {
  Scene scene{0.6, 0.5, 0.5};
  scene.law = exponential_friction({0.05, 0});
  const Solution x = solve(scene, {stick_slip_border, 0.5});
  const Profile y = profile(x);
  EXPECT_NEAR(peaks(x).value.traction, y.traction.maxCoeff(), 0.01 * y.traction.maxCoeff());
  EXPECT_LT(y.traction.maxCoeff(), 0.8 * scene.friction * 2 / pi);
}

// With a law of friction, too, no node is above the peak, and the highest is hardly below (as
// above), for the traction is f phi p on the slip zone. The profile carries its loads: the sums of
// p and q by the trapezoidal rule in arccos s of each zone, whose error is of the second order in
// the widest step of the nodes.
TEST(Solution, PeaksAndLoadsWithALawOfFriction) {
  for (const auto& [scene, given] : hot_scenes()) {
    const Solution x = solve(scene, given);
    const double n = 0.75 * std::get<CoupledSolution>(x.found).unknowns;
    const double missed = 50 * std::pow(pi / (2 * n), 2);
    const Profile y = profile(x);
    const FoundPeaks peak = peaks(x);
    const auto expect_top = [&, value = given.value](const Eigen::ArrayXd& curve,
                                                     double Peaks::*which) {
      EXPECT_LE(curve.maxCoeff(), peak.value.*which + *peak.error.*which) << value;
      EXPECT_GE(curve.maxCoeff(), peak.value.*which * (1 - missed)) << value;
    };
    expect_top(y.pressure, &Peaks::pressure);
    expect_top(y.traction, &Peaks::traction);
    expect_top(y.heat_flux, &Peaks::heat_flux);
    double load = 0, traction_sum = 0, widest = 0, s = -1, p = 0, q = 0;
    for (Eigen::Index i = 0; i <= y.s.size(); ++i) {
      const bool inside = i < y.s.size();
      const double next = inside ? y.s(i) : 1, next_p = inside ? y.pressure(i) : 0;
      const double next_q = inside ? y.traction(i) : 0;
      load += (next - s) * (p + next_p) / 2;
      traction_sum += (next - s) * (q + next_q) / 2;
      widest = std::max(widest, next - s);
      s = next;
      p = next_p;
      q = next_q;
    }
    EXPECT_NEAR(load, 1, widest * widest);
    EXPECT_NEAR(traction_sum, x.value(Quantity::traction), widest * widest);
  }
}

// The least friction is f phi(T*) of the hottest point or, where friction rises, of the end of the
// slip zone that is coldest; the nodes of the profile are between. It is the ratio of traction and
// pressure there.
TEST(Solution, LeastFrictionIsThatOfTheProfile) {
  for (const auto& [scene, given] : hot_scenes()) {
    const Solution x = solve(scene, given);
    const Estimate least = least_friction(x).value();
    const Profile y = profile(x);
    double lowest = 1e300;
    for (Eigen::Index i = 0; i < y.s.size(); ++i)
      if (y.s(i) > x.value(stick_slip_border))
        lowest = std::min(lowest, y.traction(i) / y.pressure(i));
    EXPECT_LE(least.value, lowest + least.error);
    EXPECT_GE(least.value, lowest * 0.97);
    EXPECT_GT(least.error, 0);
    EXPECT_LT(least.error, 1e-4);
  }
  EXPECT_FALSE(least_friction(solve({0.6, 100, 0.5}, {creep, 0.1})));
}

// Where nothing slips all is exact, by every method but the scheme, which cannot tell.
TEST(Solution, NothingSlipsWithoutTraction) {
  for (const Quantity what : {traction, creep})
    for (const Method method :
         {Method::closed_form, Method::coupled, Method::automatic, Method::first_order}) {
      const Solution x = solve({0.6, 100, 1}, {what, 0}, {.method = method});
      EXPECT_EQ((*x.error).abs().maxCoeff(), 0);
      EXPECT_EQ(x.value(stick_slip_border), 1);
      EXPECT_EQ(x.value(load_ratio), 1);
      EXPECT_EQ(x.value(heat_integral), 0);
      const FoundPeaks peak = peaks(x);
      EXPECT_EQ(peak.value.pressure, 2 / pi);
      EXPECT_EQ(peak.value.traction, 0);
      EXPECT_EQ(peak.value.heat_flux, 0);
      const Profile y = profile(x);
      for (Eigen::Index i = 0; i < y.s.size(); ++i)
        EXPECT_EQ(y.pressure(i), hertz_pressure(y.s(i)));
      for (const Eigen::ArrayXd& none : {y.traction, y.slip, y.heat_flux, y.temperature})
        EXPECT_EQ(none.abs().maxCoeff(), 0);
      for (const double depth : {0.0, 0.5})
        for (const CurvePoint& point : temperature_curve(x, {-1, 0, 1, 2}, depth).points)
          EXPECT_EQ(point.temperature, 0);
    }
  for (const Quantity what : {traction, creep})
    EXPECT_THROW(solve({0.6, 100, 0}, {what, 0}, scheme), std::invalid_argument);
}

// With heat and both signs, from one end to the other: steel, where heat matters a little, and a
// scene where it matters much. The errors are of the order of the tolerance.
TEST(Solution, PeakErrorsCoverATighterSolution) {
  for (const Formulation formulation : {Formulation::printed, Formulation::corrected})
    for (const double share : ends)
      for (const auto& [peclet, heating] : {std::pair{4360.0, 0.0175}, std::pair{100.0, 1.0}}) {
        const Driven scene{0.6, 0.6 * share, peclet, heating};
        const FoundPeaks fine = fine_peaks(scene, formulation);
        for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
          const FoundPeaks x = peaks(solve(scene, {formulation, tolerance}));
          for (const auto peak : all_peaks) {
            EXPECT_NEAR(x.value.*peak, fine.value.*peak, *x.error.*peak + *fine.error.*peak)
                << share << ' ' << peclet << ' ' << tolerance;
            EXPECT_LT(*x.error.*peak, 10 * tolerance * x.value.*peak);
          }
        }
      }
}

// Random scenes in SI units, with heat from none to strong, against a tolerance of 1e-9. The error
// is an estimate: of the numbers that have one, one in a hundred may exceed it and none by ten
// times.
TEST(Solution, SiErrorsCoverATighterSolution) {
  std::mt19937 generator(9);
  const auto log_uniform = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(generator));
  };
  int compared = 0, exceeded = 0;
  for (int i = 0; i < 200; ++i) {
    const double friction = log_uniform(0.05, 1), near_end = log_uniform(1e-9, 0.5);
    const double share = i % 2 == 0 ? near_end : 1 - near_end;
    const double tolerance = std::pow(10, -2 - i % 5);
    const Formulation sign = i % 4 < 2 ? Formulation::printed : Formulation::corrected;
    const Driven drawn{friction, share * friction, log_uniform(0.1, 1e4), log_uniform(1e-6, 2)};
    const PhysicalScene c = physical_scene(drawn);
    const Scene groups = scene_of(c, friction);
    const Driven scene{friction, share * friction, groups.peclet, groups.heating};
    const FoundInSi x = in_si_units(solve(scene, {sign, tolerance}), c);
    const FoundInSi fine = in_si_units(solve(scene, {sign, 1e-9, Method::coupled}), c);
    for (const auto field : all_in_si) {
      const double most = *x.error.*field + *fine.error.*field + 1e-14 * fine.value.*field;
      const double off = std::abs(x.value.*field - fine.value.*field);
      EXPECT_LE(off, 10 * most) << i;
      ++compared;
      exceeded += off > most;
    }
    EXPECT_EQ(x.error->half_width, 0);
    EXPECT_EQ(x.error->hertz_pressure, 0);
  }
  EXPECT_LE(100 * exceeded, compared);
}

// The scene of a radius, solved loosely, is the scene of the half-width from which that radius
// came: all that is reported of the latter, tightly, lies within the errors of the former. All of
// it goes with a power of the half-width of one at least, and so has its relative error on top, but
// for rounding in the difference of two errors. The results keep five times the tolerance; it asks
// nothing of the peaks along the contact.
TEST(Solution, ErrorsOfARadiusCoverTheHalfWidth) {
  for (const double load : {1.2e7, 1e8})
    for (const Formulation formulation : {Formulation::printed, Formulation::corrected}) {
      PhysicalScene c = wheel_on_rail();
      c.load = load;
      c.expansion *= 10;
      const Prescribed given{traction, 0.5};
      const Approach tight{formulation, 1e-9, Method::coupled};
      const FoundInSi exact = in_si_units(solve(scene_of(c, 0.6), {traction, 0.5}, tight), c);
      for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
        const Approach loose{formulation, tolerance};
        c.half_width = half_width_of_radius(c, exact.value.radius, 0.6, given, loose);
        const FoundInSi x = in_si_units(solve(scene_of(c, 0.6), {traction, 0.5}, loose), c, true);
        const Solution same = solve(scene_of(c, 0.6), {traction, 0.5}, loose);
        const FoundInSi given_size = in_si_units(same, c);
        const double of_size = x.error->half_width / x.value.half_width;
        for (const auto field : all_in_si) {
          EXPECT_NEAR(x.value.*field, exact.value.*field, *x.error.*field + *exact.error.*field);
          EXPECT_GE(*x.error.*field - *given_size.error.*field, 0.99 * of_size * x.value.*field);
          EXPECT_GT(*x.error.*field, 0);
          const bool is_peak = field == &PhysicalResults::max_pressure ||
                               field == &PhysicalResults::max_traction ||
                               field == &PhysicalResults::max_heat_flux;
          EXPECT_LT(*x.error.*field, (is_peak ? 10 : 5) * tolerance * x.value.*field);
        }
        c.half_width = exact.value.half_width;
      }
    }
}

// Of a wheel with a radius, all results and not only those in SI units: a creep by its ratio is
// another one at each half-width, and the groups are.
TEST(Solution, ErrorsOfARadiusAreInAllResults) {
  for (const auto& [quantity, value, unit] :
       {std::tuple{creep, 0.002, CreepUnit::ratio}, {traction, 0.2, CreepUnit::scaled}})
    for (const double hotter : {1.0, 10.0})
      for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-6}) {
        PhysicalScene c = wheel_on_rail();
        c.expansion *= hotter;
        const auto solved = [&](double to) {
          return solve_scene({{0.3, 1, 0}, {quantity, value}, {.tolerance = to}, c, 0.46, unit});
        };
        const Solution x = solved(tolerance).solution, exact = solved(1e-9).solution;
        const thermoroll::Results off = (x.value - exact.value).abs();
        for (int i = 0; i < thermoroll::compared; ++i)
          EXPECT_LE(off[i], (*x.error)[i] + (*exact.error)[i]) << i << " to " << tolerance;
        EXPECT_EQ((*x.error)(quantity) > 0, unit == CreepUnit::ratio);
      }
}

// With two bulk temperatures the state without slip moves with the half-width that a radius gives:
// in this scene by ten thousand times its own error.
TEST(Solution, ErrorsOfARadiusAreInTheStateWithoutSlip) {
  PhysicalScene c{5.443e6, 1.147, 0, 8.1e10, 0.33, 5.571e-6, 8.686e-5, 50.94};
  c.expansion_2 = c.expansion;
  c.conductivity_2 = c.conductivity;
  c.bulk_temperature = 12.54;
  c.bulk_temperature_2 = 262.5;
  const auto solved = [&](double to) {
    return solve_scene(
        {{0.299, 1, 0}, {creep, -0.001618}, {.tolerance = to}, c, 0.04094, CreepUnit::ratio});
  };
  const SolvedScene x = solved(1e-2), exact = solved(1e-6);
  const NoSlip still = no_slip(x.solution), fine = no_slip(exact.solution);
  EXPECT_NEAR(still.traction, fine.traction, still.traction_error + fine.traction_error);
  EXPECT_NEAR(still.creep, fine.creep, still.creep_error + fine.creep_error);
  EXPECT_GT(std::abs(still.traction - fine.traction), 1e-7);
  const Estimate load = *x.physical->no_slip_load, ratio = *x.physical->no_slip_creep_ratio;
  EXPECT_NEAR(load.value, exact.physical->no_slip_load->value, load.error);
  EXPECT_NEAR(ratio.value, exact.physical->no_slip_creep_ratio->value, ratio.error);
}

// The scaled creep is typed again here. Whatever is not a creep ratio stays as it is.
TEST(Solution, CreepRatioIsTheCreepOfItsHalfWidth) {
  const PhysicalScene c = wheel_on_rail();
  const double scale = c.shear_modulus * c.half_width / (2 * (1 - c.poisson) * c.load);
  const Prescribed x = dimensionless(c, {creep, -0.004}, CreepUnit::ratio);
  EXPECT_NEAR(x.value, -0.004 * scale, 1e-15);
  EXPECT_EQ(x.quantity, creep);
  EXPECT_EQ(dimensionless(c, {creep, 0.1}, CreepUnit::scaled).value, 0.1);
  EXPECT_EQ(dimensionless(c, {traction, 0.1}, CreepUnit::ratio).value, 0.1);
}

// As above, with the creep ratio given: the scaled creep is another at each half-width. What is
// given has no error, and the load has one.
TEST(Solution, ErrorsOfACreepRatioCoverTheHalfWidth) {
  for (const double ratio : {5e-4, 0.006, 0.02}) {
    PhysicalScene c = wheel_on_rail();
    c.expansion *= 10;
    const auto at = [&](const Approach& approach, bool from_radius) {
      const Prescribed given = dimensionless(c, {creep, ratio}, CreepUnit::ratio);
      const Solution x = solve(scene_of(c, 0.6), given, approach);
      return in_si_units(x, c, from_radius, CreepUnit::ratio);
    };
    const FoundInSi exact = at({.tolerance = 1e-9, .method = Method::coupled}, false);
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      const Approach loose{.tolerance = tolerance};
      c.half_width =
          half_width_of_radius(c, exact.value.radius, 0.6, {creep, ratio}, loose, CreepUnit::ratio);
      const FoundInSi x = at(loose, true);
      std::vector<double PhysicalResults::*> fields(std::begin(all_in_si), std::end(all_in_si));
      fields.push_back(&PhysicalResults::tangential_load);
      fields.push_back(&PhysicalResults::max_temperature_at_m);
      for (const auto field : fields)
        EXPECT_NEAR(x.value.*field, exact.value.*field,
                    *x.error.*field + *exact.error.*field + 1e-15 * exact.value.*field);
      EXPECT_EQ(x.error->creep_ratio, 0);
      EXPECT_NEAR(x.value.creep_ratio, ratio, 1e-15 * ratio);
      const double more =
          x.error->max_temperature_at_m - at(loose, false).error->max_temperature_at_m;
      EXPECT_NEAR(more, 2 * x.error->half_width, 4e-16 * x.error->max_temperature_at_m);
      c.half_width = exact.value.half_width;
    }
  }
}

// Without heat, f times the integral of v p is xi Q: the work of the creep against the force is all
// that friction takes. Both sides have their stated errors and some ten roundings. With heat on one
// body it is not so, and the heat of this scene is felt.
TEST(Solution, DissipationIsTheWorkOfTheCreepWithoutHeat) {
  for (const Driven& drawn : random_scenes(100)) {
    PhysicalScene c = physical_scene(drawn);
    const auto off = [&](Method method) {
      const Prescribed given{traction, drawn.traction};
      const Solution x = solve(scene_of(c, drawn.friction), given, {.method = method});
      const FoundInSi y = in_si_units(x, c);
      const double work = y.value.creep_ratio * c.speed * drawn.traction * c.load;
      const double error = y.error->creep_ratio / y.value.creep_ratio +
                           y.error->dissipation / y.value.dissipation + 20 * 1.2e-16;
      return std::abs(y.value.dissipation / work - 1) / error;
    };
    EXPECT_LE(off(Method::closed_form), 1);
    c.expansion = 0;
    EXPECT_LE(off(Method::coupled), 1);
  }
  const PhysicalScene c = wheel_on_rail();
  const FoundInSi hot = in_si_units(solve(scene_of(c, 0.6), {traction, 0.5}), c);
  EXPECT_GT(std::abs(hot.value.dissipation / (hot.value.creep_ratio * 22.2 * 0.5 * 1.2e7) - 1),
            1e-5);
}

// A result is noted by its name exactly where it is beyond its limit, typed again here; the cases
// are drawn about the limits, so that each is met from both sides often. Half of them brake, and
// half have a bulk temperature, with which a rise above 1500 degrees may be no melting, and less
// may be.
TEST(Solution, NotesBeginAtTheLimits) {
  std::mt19937 generator(11);
  const auto log_uniform = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(generator));
  };
  std::map<std::string, int> noted;
  for (int i = 0; i < 400; ++i) {
    PhysicalScene c = wheel_on_rail();
    c.poisson = 0.4;
    c.expansion /= 2;  // Grueneisen's number would be above 3
    c.half_width *= log_uniform(0.05, 1);
    c.speed *= log_uniform(0.01, 1);
    const bool brakes = i % 2 == 1, has_bulk = i % 4 > 1;
    if (has_bulk) c.bulk_temperature = log_uniform(1, 1000) - 270;
    const double sign = brakes ? -1 : 1, bulk = c.bulk_temperature.value_or(0);
    const double friction = log_uniform(1, 4);
    const FoundInSi y = in_si_units(
        solve(scene_of(c, friction), {traction, sign * 0.8 * friction}, closed_form), c);
    const std::pair<const char*, bool> beyond[] = {
        {"half_width_over_radius", y.value.half_width_over_radius > 0.1},
        {"creep_ratio", std::abs(y.value.creep_ratio) > 0.1},
        {"hertz_pressure", y.value.hertz_pressure > c.shear_modulus / 10},
        {"friction", friction > 2},
        {has_bulk ? "contact_temperature_celsius" : "max_temperature_celsius",
         bulk + y.value.max_temperature_celsius > 1500}};
    std::size_t count = 0;
    for (const auto& [name, is_beyond] : beyond) {
      const bool below = brakes && std::string(name) == "creep_ratio";
      const auto tells = [&, start = std::string(name) + " = "](const std::string& note) {
        return note.rfind(start + (below ? "-0." : ""), 0) == 0 &&
               note.find(below ? " is below -0.1 (" : " is above ") != std::string::npos;
      };
      EXPECT_EQ(std::count_if(y.notes.begin(), y.notes.end(), tells), is_beyond ? 1 : 0) << name;
      count += is_beyond;
      noted[name] += is_beyond;
    }
    const bool in_kelvin = has_bulk && 273 <= bulk && bulk <= 313;
    EXPECT_EQ(y.notes.size(), count + (in_kelvin ? 1 : 0));
  }
  for (const auto& [name, times] : noted) EXPECT_TRUE(20 < times && times < 380) << name << times;
}

/// The failure, of exactly its type, after it was thrown with more words.
template <class Failure>
std::optional<Failure> thrown_with(const std::string& more, const Failure& failure) {
  try {
    try {
      throw failure;
    } catch (const std::exception&) {
      throw_again_with(more);
    }
  } catch (const Failure& told) {
    return typeid(told) == typeid(Failure) ? std::optional(told) : std::nullopt;
  }
}

// A failure with more words has its type and its grids. With a diffusivity in mm^2/s no contact is
// found, and the message says so before the notes on the data; with a half-width or a radius, whose
// scene is almost the same, and without any note where the data are groups.
TEST(Solution, FailuresKeepTheirTypeWithNotes) {
  const auto last_words = [](const auto& told) { return std::string(told.value().what()); };
  const auto resolved = thrown_with("; b", NotResolved("a", {GridStep{}, GridStep{}}));
  EXPECT_EQ(last_words(resolved), "a; b");
  EXPECT_EQ(resolved->trace.size(), 2U);
  EXPECT_EQ(last_words(thrown_with("; b", NotConverged("a"))), "a; b");
  EXPECT_EQ(last_words(thrown_with("; b", std::runtime_error("a"))), "a; b");
  EXPECT_EQ(last_words(thrown_with("; b", std::invalid_argument("a"))), "a; b");
  EXPECT_EQ(last_words(thrown_with("; b", std::domain_error("a"))), "a");

  const auto failure = [](const GivenScene& c) {
    try {
      solve_scene(c);
    } catch (const std::runtime_error& told) {
      return std::string(told.what());
    }
    return std::string();
  };
  PhysicalScene c = wheel_on_rail();
  c.diffusivity = 14;
  c.expansion_2 = c.expansion;
  c.conductivity_2 = c.conductivity;
  const Prescribed given{creep, 0.9};
  for (const std::optional<double> radius : {std::optional<double>(), std::optional(0.46)}) {
    const std::string told = failure({{0.6, 1, 0}, given, {}, c, radius, CreepUnit::ratio});
    EXPECT_EQ(told.rfind("coupled: ", 0), 0U) << told;
    EXPECT_NE(told.find("; note: creep_ratio = 0.9 is above 0.1 ("), std::string::npos) << told;
    EXPECT_NE(told.find("; note: grueneisen = 1.62e+06 is above"), std::string::npos) << told;
    EXPECT_EQ(told.find("hertz_pressure"), std::string::npos) << told;
  }
  const Prescribed scaled = dimensionless(c, given, CreepUnit::ratio);
  const std::string told = failure({scene_of(c, 0.6), scaled, {}, {}, {}});
  EXPECT_EQ(told.rfind("coupled: ", 0), 0U) << told;
  EXPECT_EQ(told.find("note"), std::string::npos) << told;
}

// Data of the cylinder in other units, a speed in mm/s and a scale of friction in units of T* are
// noted by their names; the same data in SI units are not.
TEST(Solution, NotesOnEachBodySpeedAndScale) {
  PhysicalScene aluminium = wheel_on_rail();
  aluminium.conductivity_2 = 235;
  aluminium.expansion_2 = 2.3e-5;
  aluminium.diffusivity_2 = 9.7e-5;
  aluminium.law = LawOfFriction{LawKind::linear, {-1.01}};
  EXPECT_EQ(notes_on(aluminium, 0.6, 0, 0).size(), 0U);
  const auto noted = [&](auto change) {
    PhysicalScene c = aluminium;
    change(c);
    const std::vector<std::string> notes = notes_on(c, 0.6, 0, 0);
    return notes.size() == 1 ? notes[0].substr(0, notes[0].find(' ')) : "none or many";
  };
  EXPECT_EQ(noted([](PhysicalScene& c) { c.diffusivity_2 = 97; }), "grueneisen_2");
  EXPECT_EQ(noted([](PhysicalScene& c) { c.conductivity_2 = 0.235; }), "grueneisen_2");
  EXPECT_EQ(noted([](PhysicalScene& c) { c.expansion_2 = 23; }), "grueneisen_2");
  EXPECT_EQ(noted([](PhysicalScene& c) { c.diffusivity_2 = 0; }), "heat_capacity_2");
  EXPECT_EQ(noted([](PhysicalScene& c) { c.conductivity = 500; }), "heat_capacity");
  const auto of_bulk = [&](double first, double second) {
    PhysicalScene c = aluminium;
    c.bulk_temperature = first;
    c.bulk_temperature_2 = second;
    return notes_on(c, 0.6, 0, 0).size();
  };
  EXPECT_EQ(of_bulk(20, 272.9), 0U);
  EXPECT_EQ(of_bulk(20, 293.15), 1U);
  EXPECT_EQ(of_bulk(313, 313.1), 1U);
  EXPECT_EQ(noted([](PhysicalScene& c) { c.speed = 301; }), "speed");
  EXPECT_EQ(noted([](PhysicalScene& c) { c.law->of.scale = -0.99; }), "friction_temperature");
  EXPECT_EQ(noted([](PhysicalScene& c) { c.law->of.scale = 0.02; }), "friction_temperature");
}

// A load in N where N/m is meant makes a pressure below a five-hundredth of the shear modulus. It
// alone is noted, unless the half-width is in mm, which has the same effect and its own note.
TEST(Solution, NoteOnALoadThatIsNotOfAMetre) {
  for (const double part : {0.1, 0.99, 1.01, 10.}) {
    PhysicalScene c = wheel_on_rail();
    c.load = part * (pi / 2) * c.half_width * c.shear_modulus / 500;
    const FoundInSi y = in_si_units(solve(scene_of(c, 0.6), {traction, 0.5}, closed_form), c);
    ASSERT_EQ(y.notes.size(), part < 1 ? 1U : 0U) << part;
    if (part > 1) continue;
    EXPECT_EQ(y.notes[0].rfind("hertz_pressure = ", 0), 0U);
    EXPECT_NE(y.notes[0].find(" is below 1.62e+08 ("), std::string::npos) << y.notes[0];
  }
  PhysicalScene in_mm = wheel_on_rail();
  in_mm.half_width *= 1000;
  EXPECT_LT(2 / pi * in_mm.load / in_mm.half_width, in_mm.shear_modulus / 500);
  const std::vector<std::string> notes = notes_on(in_mm, 0.6, 0, 0);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].rfind("half_width = ", 0), 0U) << notes[0];
}

// Without heat p* is its root times a constant, and the heat flux has ten Legendre coefficients in
// its angle: any grid holds them. The tops are found to the square of the root of rounding error.
TEST(Solution, PeaksOfTheCoupledSolutionAgreeWithoutHeat) {
  for (const double q : {0.1, 0.3, 0.5, 0.59}) {
    const Driven scene{0.6, q, 100, 0};
    const Peaks exact = peaks(solve(scene, closed_form)).value;
    const Peaks x = peaks(solve(scene, {.method = Method::coupled})).value;
    EXPECT_NEAR(x.pressure / exact.pressure, 1, 1e-12) << q;
    EXPECT_NEAR(x.traction / exact.traction, 1, 1e-12) << q;
    EXPECT_NEAR(x.heat_flux / exact.heat_flux, 1, 1e-12) << q;
  }
}

// The scheme's largest traction is one of the tractions at its nodes, not f times the largest
// pressure. Where the border is beyond the middle, the traction is largest at the border, and the
// last node before it or the first behind it is within pi/(n+1) of it, over which f p* changes by
// its slope, at most f (2/pi) s / sqrt(1 - s^2).
TEST(Solution, TractionOfTheSchemeIsLargestAtTheBorder) {
  const Driven scene{0.6, 0.1, 100, 0};
  const Peaks exact = exact_peaks(scene), x = peaks(solve(scene, scheme)).value;
  const double c0 = carter(0.6, 0.1).c0, far = c0 + pi / 201;
  EXPECT_NEAR(x.traction, exact.traction, 0.6 * 2 / pi * far / std::sqrt(1 - far * far) * pi / 201);
  EXPECT_LT(x.traction, 0.7 * 0.6 * x.pressure);
}

// The eccentricity pi gamma0 / (2 kappa) of all pairs within the errors of gamma0 and kappa is
// within its error, which is that of the worst pair to first order.
TEST(Solution, ErrorOfTheEccentricityIsThatOfItsParts) {
  const Solution x = solve({0.6, 0.5, 10, 5}, {Formulation::corrected, 1e-2, Method::coupled});
  double furthest = 0;
  for (const double gamma0 : {-(*x.error)(gamma0), (*x.error)(gamma0)})
    for (const double kappa : {-(*x.error)(load_ratio), (*x.error)(load_ratio)}) {
      const double other =
          pi * (x.value(Quantity::gamma0) + gamma0) / (2 * (x.value(load_ratio) + kappa));
      furthest = std::max(furthest, std::abs(other - x.value(eccentricity)));
    }
  const double second_order = 2 * (*x.error)(load_ratio) / x.value(load_ratio);
  EXPECT_NEAR((*x.error)(eccentricity) / furthest, 1, second_order);
  EXPECT_GT(std::abs(x.value(gamma0)) / x.value(load_ratio), 10 * second_order);
}

// At a depth as on the surface, the error of a temperature is the flux's error and that of the
// integral, 1e-8 of the largest temperature at most, or less where the tolerance is less.
TEST(Solution, ErrorOfATemperatureIncludesThatOfTheFlux) {
  const std::vector<double> at{-0.5, 0, 0.3, 0.7, 0.9, 1, 1.2};
  for (const double peclet : {100.0, 1e6}) {
    const Driven scene{0.6, 0.5, peclet, 0.01};
    for (const double tolerance : {1e-4, 1e-8, 1e-11})
      for (const Method method : {Method::closed_form, Method::automatic}) {
        const Solution x = solve(scene, {Formulation::corrected, tolerance, method});
        const CurvePoint hottest = temperature_curve(x, {x.value(max_temperature_at)}, 0).points[0];
        const double missed = std::abs(hottest.temperature - x.value(max_temperature));
        const double of_flux =
            method == Method::closed_form ? 0 : (*x.error)(max_temperature) + 2 * missed;
        for (const double depth : {0.0, 0.01})
          for (const CurvePoint& point : temperature_curve(x, at, depth).points) {
            const double integral = *point.error - of_flux, top = x.value(max_temperature);
            EXPECT_GE(*point.error, of_flux);
            EXPECT_LE(integral, (depth == 0 ? std::min(tolerance, 1e-8) : 1e-9) * top);
          }
      }
  }
}

// The curve is that of the flux on the last grid, whose largest temperature is then corrected for
// what is left of the prescribed quantity. In one of the scenes the correction is larger than the
// error of the result; in the last two the nodes are moved to the ends. Elsewhere the curve is held
// against that of a tenth of the tolerance.
TEST(Solution, ErrorOfATemperatureIncludesTheLastCorrection) {
  struct Given {
    Scene scene;
    double creep, tolerance;
  };
  int beyond = 0;
  for (const auto& [scene, xi, tolerance] :
       {Given{{0.07326935, 128433.9, 0.1451372}, 1.425133e-4, 2.97e-9},
        Given{{0.2700362, 8.287458, 1.041757}, 0.1182283, 2.3e-7},
        Given{{0.8537543, 320416.1, 1.002753}, 0.2083559, 3.92e-9},
        Given{{0.7163644, 319997.8, 7.503096}, 0.08136242, 2e-6}}) {
    const Solution x =
        solve(scene, {creep, xi}, {Formulation::corrected, tolerance, Method::coupled});
    const CurvePoint top = temperature_curve(x, {x.value(max_temperature_at)}, 0).points[0];
    const double off = std::abs(top.temperature - x.value(max_temperature));
    if (off > (*x.error)(max_temperature)) ++beyond;
    EXPECT_LE(off, *top.error) << scene.peclet;
    const std::vector<double> at{-0.2, 0.3, 0.7, 0.95, 1.5};
    const Solution y =
        solve(scene, {creep, xi}, {Formulation::corrected, tolerance / 10, Method::coupled});
    const Curve coarse = temperature_curve(x, at, 0), fine = temperature_curve(y, at, 0);
    for (std::size_t i = 0; i < at.size(); ++i)
      EXPECT_LE(std::abs(coarse.points[i].temperature - fine.points[i].temperature),
                *coarse.points[i].error)
          << scene.peclet << " at " << at[i];
  }
  EXPECT_EQ(beyond, 1);
}

// The closed form has the largest temperature to a few thousandths here, as heat moves the hottest
// point's neighbours in opposite ways; the error of the largest was up to 4.8 times too small for
// the others.
TEST(Solution, CurvesOfTheClosedFormInFullSlipHaveTheirError) {
  struct Given {
    Scene scene;
    double creep, tolerance;
  };
  const Given all[] = {{{0.0638, 2.63e5, 0.0508}, 0.04305, 1e-3},
                       {{0.0612, 1.333e5, 0.0744}, -0.052287, 1e-3},
                       {{0.0602, 4.18e4, 0.00557}, 0.06094, 1e-4}};
  const std::vector<double> at{-1.2, -0.95, -0.7, -0.45, -0.2, 0.05, 0.3, 0.55, 0.8, 1.05, 1.3};
  for (const auto& [scene, given, tolerance] : all) {
    const Solution least = solve(scene, {creep, given}, {.tolerance = tolerance});
    const Solution best =
        solve(scene, {creep, given}, {.tolerance = 1e-8, .method = Method::coupled});
    ASSERT_EQ(least.model, Model::closed_form);
    for (const double depth : {0.0, 0.01}) {
      const Curve x = temperature_curve(least, at, depth), y = temperature_curve(best, at, depth);
      for (std::size_t i = 0; i < at.size(); ++i)
        EXPECT_NEAR(x.points[i].temperature, y.points[i].temperature,
                    *x.points[i].error + *y.points[i].error)
            << given << ' ' << at[i];
    }
  }
}

// One body, two unlike ones, and a bulk difference; contact without slip, and the published scheme.
TEST(Solution, CurvesOfNothingAreEmptyAndOfNoNumberRefused) {
  const thermoroll::Scene one{0.6, 100, 0.0175};
  thermoroll::Scene unlike = one, warm = one;
  unlike.roller = {2, 0.01, 30};
  warm.roller = {1, 0.0175};
  warm.bulk_difference = 0.01;
  const auto refuses = [](const Solution& x) {
    for (const double depth : {0.0, 0.1}) {
      if (depth > 0 && x.approach.method == Method::gauss_chebyshev) continue;
      EXPECT_TRUE(temperature_curve(x, {}, depth).points.empty());
      EXPECT_THROW(temperature_curve(x, {0, std::nan("")}, depth), std::invalid_argument);
      EXPECT_THROW(temperature_curve(x, {INFINITY}, depth), std::invalid_argument);
    }
  };
  for (const auto& scene : {one, unlike, warm}) {
    refuses(thermoroll::solve(scene, {Quantity::traction, 0.3}, {}));
    refuses(thermoroll::solve(scene, {Quantity::creep, 0.1}, {}));
  }
  refuses(thermoroll::solve(one, {Quantity::traction, 0}, {}));
  refuses(thermoroll::solve(one, {Quantity::traction, 0.3}, {.method = Method::gauss_chebyshev}));
}

// Where one correction would change all, its error has no bound, and there is no solution to
// report.
TEST(Solution, NoSolutionWithoutABoundOnItsError) {
  for (const double heating : {10.0, 1000.0}) try {
      solve({0.6, 0.5, 100, heating}, {.method = Method::first_order});
      ADD_FAILURE() << "accepted: " << heating;
    } catch (const std::runtime_error& refusal) {
      EXPECT_STREQ(refusal.what(), "first-order: heat is too strong for one linear correction");
    }
}

// The law of a scene beside SI data was ignored, and 220 degree C of one body, where that of the
// other was left out, was taken for 220 above zero.
TEST(Solution, DataAreGivenInOnePlace) {
  const auto refused = [](const GivenScene& c) {
    try {
      solve_scene(c);
    } catch (const std::invalid_argument& refusal) {
      return std::string(refusal.what());
    }
    return std::string();
  };
  PhysicalScene steel = thermoroll::wheel_on_rail();
  const GivenScene good{{0.6, 0, 0}, {traction, 0.3}, {}, steel, {}};
  EXPECT_EQ(refused(good), "");
  for (const auto change :
       {+[](Scene& x) {
          x.law = thermoroll::LawOfFriction{thermoroll::LawKind::linear, {1, 0, 0}};
        },
        +[](Scene& x) {
          x.roller = {1, 0.01};
        },
        +[](Scene& x) { x.bulk_difference = 1; },
        +[](Scene& x) { x.direction = Direction::braking; }}) {
    GivenScene twice = good;
    change(twice.scene);
    EXPECT_NE(refused(twice).find("has its law, roller, direction"), std::string::npos);
  }
  steel.conductivity_2 = steel.conductivity;
  steel.bulk_temperature_2 = 220;
  EXPECT_EQ(refused({{0.6, 0, 0}, {traction, 0.3}, {}, steel, {}}),
            "bulk-temperature-2 needs bulk-temperature");
  steel.bulk_temperature = 20;
  EXPECT_EQ(refused({{0.6, 0, 0}, {traction, 0.3}, {}, steel, {}}), "");
}

// The largest traction is with the refusal of a larger one, which a program may catch.
TEST(Solution, ALimitIsKnownInSIUnitsToo) {
  PhysicalScene steel = thermoroll::wheel_on_rail();
  steel.law = thermoroll::LawOfFriction{thermoroll::LawKind::linear, {1600, 0, 0}};
  const auto asked = [&](double of) {
    return GivenScene{{0.6, 0, 0}, {traction, of}, {}, steel, {}};
  };
  const Solution below = solve_scene(asked(0.3)).solution;
  const auto& limit = std::get<CoupledSolution>(below.found).limit;
  ASSERT_TRUE(limit);
  try {
    solve_scene(asked(0.59));
    ADD_FAILURE() << "solved";
  } catch (const BeyondLimit& refusal) {
    EXPECT_NEAR(refusal.limit.traction, limit->traction,
                refusal.limit.traction_error + limit->traction_error);
    EXPECT_NE(std::string(refusal.what()).find("N/m"), std::string::npos);
  }
}

TEST(Solution, RefusesWhatIsOutOfRange) {
  const Driven scene{0.6, 0.5, 100, 0};
  for (const int nodes : {-1, 0, 2, 5001}) {
    Approach approach = scheme;
    approach.nodes = nodes;
    EXPECT_THROW(solve(scene, approach), std::invalid_argument) << nodes;
  }
  for (const double tolerance : {0.0, 9e-12, 1.1e-2}) {
    Approach approach;
    approach.tolerance = tolerance;
    EXPECT_THROW(solve(scene, approach), std::invalid_argument) << tolerance;
  }
  EXPECT_THROW(solve(scene, {creep, 0.1}, scheme), std::invalid_argument);
  for (const double value : {0.0, 0.1})
    EXPECT_THROW(solve(scene, {gamma0, value}), std::invalid_argument) << "cannot be prescribed";
  EXPECT_THROW(profile(solve(scene, scheme)), std::invalid_argument);
  EXPECT_THROW(solve({0.6, 0.6, 100, 0}, closed_form), std::invalid_argument);
  EXPECT_THROW(temperature_curve(solve(scene, scheme), {0}, 0.1), std::invalid_argument);
  EXPECT_THROW(temperature_curve(solve(scene, closed_form), {0}, -0.1), std::invalid_argument);
  EXPECT_THROW(half_width_of_radius(wheel_on_rail(), 0, 0.6, {traction, 0.5}, {}),
               std::invalid_argument);
}
