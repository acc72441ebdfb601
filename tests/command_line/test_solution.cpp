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

constexpr Approach closed_form{Method::closed_form, Formulation::printed, 200};

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
    const Solution x = solve(scene, closed_form);
    const Carter c = carter(scene.friction, scene.traction);
    double traction = carter_traction(c, c.c0), flux = 0;
    for (int i = 0; i <= 20000; ++i) {
      const double u = i / 20000.0, width = 2 * c.slip_half_width;
      traction = std::max(traction, carter_traction(c, 2 * u - 1));
      flux = std::max(flux, carter_flux(c).density(width * u, width * (1 - u)));
    }
    EXPECT_NEAR(x.peak.traction / traction, 1, 1e-7);
    EXPECT_GE(x.peak.traction, traction * (1 - 1e-15));
    EXPECT_NEAR(x.peak.heat_flux / flux, 1, 1e-7);
    EXPECT_GE(x.peak.heat_flux, flux * (1 - 1e-15));
    EXPECT_DOUBLE_EQ(x.peak.pressure, hertz_pressure(0));
  }
}

// Without heat the scheme's tractions are the closed form's to rounding error at its nodes, which
// are cosines of angles pi/(n+1) apart. The angle theta between the top of the pressure and its
// nearest node is at most half of that, and the pressure there is cos(theta) >= 1 - theta^2/2 of
// the top; the border is left of the middle, so the same holds for the traction. The flux is
// narrower, with the half-width h = 0.59 of the slip zone, and twice as curved.
TEST(Solution, PeaksOfTheSchemeAreThoseAtItsNodes) {
  const Scene scene{0.6, 0.5, 100, 0};
  const Solution exact = solve(scene, closed_form), x = solve(scene, {});
  const double theta = pi / 402, missed = theta * theta / 2;
  EXPECT_NEAR(x.peak.pressure / exact.peak.pressure, 1, missed);
  EXPECT_NEAR(x.peak.traction / exact.peak.traction, 1, missed);
  EXPECT_NEAR(x.peak.heat_flux / exact.peak.heat_flux, 1, 2 * missed / (0.59 * 0.59));
}

// The half-width found must meet its definition with the load ratio of its own solution. The last
// step left kappa unchanged to 1e-9, and a goes with its root.
TEST(Solution, HalfWidthOfRadiusMeetsItsEquation) {
  PhysicalCase c = wheel_on_rail();
  for (const double load : {1e5, 1.2e7, 1e8}) {
    c.load = load;
    c.half_width = half_width_of_radius(c, 0.46, 0.6, 0.5, {});
    const double kappa = solve(scene_of(c, 0.6, 0.5), {}).value.load_ratio;
    const double hertz = hertz_half_width(kappa * load, 0.46, c.shear_modulus, c.poisson);
    EXPECT_NEAR(c.half_width / hertz, 1, 1e-9);
    EXPECT_NE(kappa, 1);
  }
}

TEST(Solution, RefusesWhatIsOutOfRange) {
  const Scene scene{0.6, 0.5, 100, 0};
  Approach approach;
  for (const int nodes : {-1, 0, 2, 5001}) {
    approach.nodes = nodes;
    EXPECT_THROW(solve(scene, approach), std::invalid_argument) << nodes;
  }
  EXPECT_THROW(solve({0.6, 0.6, 100, 0}, closed_form), std::invalid_argument);
  EXPECT_THROW(temperature_curve(scene, {}, {0}, 0.1), std::invalid_argument);
  EXPECT_THROW(temperature_curve(scene, closed_form, {0}, -0.1), std::invalid_argument);
  EXPECT_THROW(half_width_of_radius(wheel_on_rail(), 0, 0.6, 0.5, {}), std::invalid_argument);
}
