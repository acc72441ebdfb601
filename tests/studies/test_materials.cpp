// Solids: the heating of a contact is its size.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "reference.hpp"
#include "studies/materials.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/scene.hpp"
#include "thermoroll/solution.hpp"

namespace {

using reference::epsilon;
using std::numbers::pi;
using thermoroll::Material;
using thermoroll::PhysicalScene;
using thermoroll::Quantity;
using thermoroll::Scene;

}  // namespace

// H from the data of a scene, and from Grüneisen's number and a/R, with the radius that Hertz's
// formula has for that load. Both together are some forty operations, each with half an epsilon;
// 1 - 2 nu is one of them, as twice nu has no rounding.
TEST(Materials, HeatingIsTheSizeOfTheContact) {
  std::mt19937 generator(18);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  const auto log_uniform = [&](double low, double high) {
    return low * std::exp(uniform(0, std::log(high / low)));
  };
  for (int i = 0; i < 1000; ++i) {
    const Material m{"",
                     log_uniform(1e8, 1e12),
                     uniform(0, 0.48),
                     log_uniform(1e-7, 1e-3),
                     log_uniform(100, 2e4),
                     log_uniform(100, 2000)};
    const double conductivity = log_uniform(0.1, 1000), half_width = log_uniform(1e-6, 1);
    const double mu = thermoroll::shear_modulus(m), load = log_uniform(1, 1e8);
    const PhysicalScene c{load,
                          1,
                          half_width,
                          mu,
                          m.poisson,
                          m.expansion,
                          conductivity / (m.density * m.heat_capacity),
                          conductivity};
    const double hertz = thermoroll::hertz_half_width(load, 1, mu, m.poisson);
    const double from_size = thermoroll::heating_of_size(m, hertz * hertz / half_width);
    EXPECT_NEAR(from_size / thermoroll::scene_of(c, 0.6).heating, 1, 20 * epsilon);
  }
}

// Grüneisen's number lies between a half and 2.2 for every solid of the table, to its two digits,
// and no heating is above the size of its contact.
TEST(Materials, EverySolidHeatsLessThanItsSize) {
  EXPECT_EQ(thermoroll::materials().size(), 10U);
  for (const Material& m : thermoroll::materials()) {
    EXPECT_GT(thermoroll::grueneisen(m), 0.485) << m.name;
    EXPECT_LT(thermoroll::grueneisen(m), 2.205) << m.name;
    EXPECT_LT(thermoroll::heating_of_size(m, 1), 1) << m.name;
  }
}

// f H |xi*| of a contact that slips everywhere, from its data and from Grüneisen's number, in some
// thirty operations, and the effect of heat that the solver finds there, which has no stick zone to
// keep it small. The number is the same at any size.
TEST(Materials, TheCreepBoundsTheDistortionInFullSlip) {
  const double friction = 0.6, creep = 0.1;
  for (const Material& m : thermoroll::materials())
    for (const double half_width : {1e-4, 1e-2}) {
      const double mu = thermoroll::shear_modulus(m), nu = m.poisson, load = 1e-3 * mu * half_width;
      const PhysicalScene c{
          load, 1,           half_width,        mu,
          nu,   m.expansion, 1e-2 * half_width, 1e-2 * half_width * m.density * m.heat_capacity};
      const Scene scene = thermoroll::scene_of(c, friction);
      const thermoroll::Prescribed given =
          thermoroll::dimensionless(c, {Quantity::creep, creep}, thermoroll::CreepUnit::ratio);
      const double expected =
          friction * (1 - 2 * nu) / (2 * (1 - nu)) * thermoroll::grueneisen(m) * creep;
      EXPECT_NEAR(friction * scene.heating * given.value / expected, 1, 20 * epsilon) << m.name;
      EXPECT_LT(expected, 2 / pi * friction * creep) << m.name;
      const auto x =
          thermoroll::solve_coupled(scene, {thermoroll::Formulation::corrected, 1e-6}, given);
      EXPECT_EQ(x.value(Quantity::stick_slip_border), -1) << m.name;
      EXPECT_LT(std::abs(x.value(Quantity::load_ratio) - 1), expected) << m.name;
      EXPECT_LT(std::abs(x.value(Quantity::gamma0)), expected) << m.name;
    }
}
