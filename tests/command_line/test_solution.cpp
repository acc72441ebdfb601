// The results that all methods report through, checked from outside.
#include "solution.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "carter.hpp"

using namespace thermoroll;

namespace {

const Approach closed_form{Method::closed_form};
const Approach scheme{Method::gauss_chebyshev, Formulation::printed};

/// Scenes with friction 0.05 to 2 and traction / friction down to 1e-6 from either end.
std::vector<Scene> random_scenes(int count) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Scene> scenes;
  for (int i = 0; i < count; ++i) {
    const double friction = 0.05 * std::pow(40, uniform(generator));
    const double near_end = std::pow(10, -6 * uniform(generator)) / 2;
    const double share = uniform(generator) < 0.5 ? near_end : 1 - near_end;
    scenes.push_back({friction, share * friction, 100, 0});
  }
  return scenes;
}

}  // namespace

// The formulas of the closed form in long double, whose rounding (2^-64) is 2^-11 of double's and
// so does not count: each error must be below what is claimed, and the claims below 8 epsilon.
TEST(Solution, RoundingStaysWithinItsBounds) {
  static_assert(std::numeric_limits<long double>::digits >= 64, "needs a wider long double");
  const long double long_pi = std::acos(-1.0L);
  for (const Scene& scene : random_scenes(200)) {
    const Solution x = solve(scene, closed_form);
    const long double f = scene.friction, q = scene.traction, b = std::sqrt((f - q) / f);
    const long double h = q / f / (1 + b), creep = 2 * f / long_pi * h;
    const auto error = [](double value, long double exact) {
      return static_cast<double>(std::abs(value - exact));
    };
    EXPECT_LE(error(x.value.stick_slip_border, 2 * b - 1), x.error->stick_slip_border);
    EXPECT_LE(error(x.value.creep, creep), x.error->creep);
    EXPECT_LE(error(x.value.creep_constant, creep), x.error->creep_constant);
    EXPECT_LE(error(x.value.heat_integral, creep * q / f), x.error->heat_integral);
    EXPECT_EQ(x.value.traction, scene.traction);
    EXPECT_EQ(x.value.load_ratio, 1);
    EXPECT_EQ(x.value.gamma0, 0);
    EXPECT_LE(x.error->heat_integral, 8 * 2.3e-16 * x.value.heat_integral);
  }
}

// The largest of 20000 samples is below the peak, and near a smooth maximum by at most half the
// curvature times the square of the distance: below 1e-7 of the peak in coordinates of the slip
// zone, where the flux is (b + h u) sqrt(u (1 - u)). The traction has a corner, near which its
// slope may be large, so the corner is one of the samples.
TEST(Solution, PeaksAreTheLargestValues) {
  for (const Scene& scene : random_scenes(20)) {
    const Peaks x = peaks(solve(scene, closed_form));
    const Carter c = carter(scene.friction, scene.traction);
    double traction = carter_traction(c, c.c0), flux = 0;
    for (int i = 0; i <= 20000; ++i) {
      const double u = i / 20000.0, width = 2 * c.slip_half_width;
      traction = std::max(traction, carter_traction(c, 2 * u - 1));
      flux = std::max(flux, carter_flux(c).density(width * u, width * (1 - u)));
    }
    EXPECT_NEAR(x.traction / traction, 1, 1e-7);
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
  const Scene scene{0.6, 0.5, 100, 0};
  const Peaks exact = peaks(solve(scene, closed_form)), x = peaks(solve(scene, scheme));
  const double theta = pi / 402, missed = theta * theta / 2;
  EXPECT_NEAR(x.pressure / exact.pressure, 1, missed);
  EXPECT_NEAR(x.traction / exact.traction, 1, missed);
  EXPECT_NEAR(x.heat_flux / exact.heat_flux, 1, 2 * missed / (0.59 * 0.59));
}

// The half-width found must meet its definition with the load ratio of its own solution. The last
// step left kappa unchanged to 1e-9 and its estimated error, and a goes with its root.
TEST(Solution, HalfWidthOfRadiusMeetsItsEquation) {
  PhysicalCase c = wheel_on_rail();
  for (const double load : {1e5, 1.2e7, 1e8}) {
    c.load = load;
    for (const Approach& approach : {scheme, Approach{}}) {
      c.half_width = half_width_of_radius(c, 0.46, 0.6, {traction, 0.5}, approach);
      const Solution x = solve(scene_of(c, 0.6, 0.5), approach);
      const double kappa = x.value.load_ratio, error = x.error ? x.error->load_ratio : 0;
      const double hertz = hertz_half_width(kappa * load, 0.46, c.shear_modulus, c.poisson);
      EXPECT_NEAR(c.half_width / hertz, 1, 1e-9 + error);
      EXPECT_NE(kappa, 1);
    }
  }
}

// The closed form for the border or the creep that belongs to a traction, against its formulas in
// long double: the errors are within what is claimed, and what is given is repeated as it is.
TEST(Solution, GivenCreepOrBorderIsTheSameCase) {
  for (const Scene& scene : random_scenes(40)) {
    const Solution x = solve(scene, closed_form);
    const long double long_pi = std::acos(-1.0L), f = scene.friction;
    const Solution by_border = solve(scene, closed_form, {border, x.value.stick_slip_border});
    const long double h = (1 - static_cast<long double>(x.value.stick_slip_border)) / 2;
    const auto error = [](double value, long double exact) {
      return static_cast<double>(std::abs(value - exact));
    };
    EXPECT_LE(error(by_border.value.traction, f * h * (2 - h)), by_border.error->traction);
    EXPECT_LE(error(by_border.value.creep, 2 * f / long_pi * h), by_border.error->creep);
    EXPECT_EQ(by_border.value.stick_slip_border, x.value.stick_slip_border);
    EXPECT_EQ(by_border.error->stick_slip_border, 0);
    const Solution by_creep = solve(scene, closed_form, {creep, x.value.creep});
    const long double k = long_pi * x.value.creep / (2 * f);
    EXPECT_LE(error(by_creep.value.traction, f * k * (2 - k)), by_creep.error->traction);
    EXPECT_LE(error(by_creep.value.stick_slip_border, 1 - 2 * k),
              by_creep.error->stick_slip_border);
    EXPECT_LE(error(by_creep.value.heat_integral, x.value.creep * k * (2 - k)),
              by_creep.error->heat_integral);
    EXPECT_EQ(by_creep.value.creep, x.value.creep);
    EXPECT_EQ(by_creep.scene.traction, by_creep.value.traction);
  }
}

// With heat, ten times the estimated error covers the change to a far finer solution.
TEST(Solution, CoupledErrorsCoverAFinerSolution) {
  const Scene scene{0.6, 0.5, 100, 1};
  for (const Given& given : {Given{traction, 0.5}, Given{creep, 0.2}, Given{border, -0.2}}) {
    Approach approach;
    approach.tolerance = 1e-4;
    const Solution x = solve(scene, approach, given);
    approach.tolerance = 1e-9;
    const Solution fine = solve(scene, approach, given);
    for (const auto field :
         {&Results::traction, &Results::stick_slip_border, &Results::creep, &Results::load_ratio,
          &Results::gamma0, &Results::eccentricity, &Results::heat_integral,
          &Results::max_temperature, &Results::max_temperature_at})
      EXPECT_LE(std::abs(x.value.*field - fine.value.*field), 10 * *x.error.*field);
    EXPECT_LT(x.error->eccentricity, pi * 1e-4);
    EXPECT_DOUBLE_EQ(x.value.eccentricity, pi * x.value.gamma0 / (2 * x.value.load_ratio));
  }
}

// Without heat the profiles of the coupled solver lie on the closed form's curves. They are roots
// of distances from the edges and the border, in which a rounding of s weighs as it weighs in the
// distance.
TEST(Solution, ProfilesOfBothMethodsAgreeWithoutHeat) {
  const Scene scene{0.6, 0.5, 100, 0};
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

// Without heat p* is its root times a constant, which five nodes reproduce, and the heat flux has
// few Legendre coefficients in its angle: with 24 of them the error is below 1e-9. The tops are
// found to the square of the root of rounding error.
TEST(Solution, PeaksOfTheCoupledSolutionAgreeWithoutHeat) {
  for (const double q : {0.1, 0.3, 0.5, 0.59}) {
    const Scene scene{0.6, q, 100, 0};
    const Peaks exact = peaks(solve(scene, closed_form)), x = peaks(solve(scene));
    EXPECT_NEAR(x.pressure / exact.pressure, 1, 1e-9) << q;
    EXPECT_NEAR(x.traction / exact.traction, 1, 1e-9) << q;
    EXPECT_NEAR(x.heat_flux / exact.heat_flux, 1, 1e-9) << q;
  }
}

TEST(Solution, RefusesWhatIsOutOfRange) {
  const Scene scene{0.6, 0.5, 100, 0};
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
  EXPECT_THROW(solve(scene, scheme, {creep, 0.1}), std::invalid_argument);
  EXPECT_THROW(profile(solve(scene, scheme)), std::invalid_argument);
  EXPECT_THROW(solve({0.6, 0.6, 100, 0}, closed_form), std::invalid_argument);
  EXPECT_THROW(temperature_curve(solve(scene, scheme), {0}, 0.1), std::invalid_argument);
  EXPECT_THROW(temperature_curve(solve(scene, closed_form), {0}, -0.1), std::invalid_argument);
  EXPECT_THROW(half_width_of_radius(wheel_on_rail(), 0, 0.6, {traction, 0.5}, {}),
               std::invalid_argument);
}
