// What the figures of unlike bodies and of a hot wheel must show.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "curves.hpp"

using namespace thermoroll_test;

namespace {

const double by_effusivity = 1 / (1 + 2 * std::sqrt(0.2)), by_conductivity = 1 / 3.0;
constexpr double stick_end = -0.2;

/// A column over s.
Curve over_s(const std::string& name, const std::string& column) {
  return curve(data(name), {}, "s", column);
}

/// That part of a curve.
Curve part(const Curve& c, double from, double to) {
  Curve some;
  for (std::size_t i = 0; i < c.x.size(); ++i)
    if (from < c.x[i] && c.x[i] < to) {
      some.x.push_back(c.x[i]);
      some.y.push_back(c.y[i]);
    }
  EXPECT_GT(some.x.size(), 4u);
  return some;
}

template <class Function>
void expect_near(const Curve& c, const Function& expected, double tolerance) {
  for (std::size_t i = 0; i < c.x.size(); ++i)
    EXPECT_NEAR(c.y[i], expected(c.x[i]), tolerance) << c.x[i];
}

double constant_half(double) { return 0.5; }

}  // namespace

// At high speed the effusivities are right but for (1/4) w (1 - w) (1/Pe1 - 1/Pe2) g'/g: a tenth of
// the zone from its ends, where g'/g is ten, that is 2.5e-3.
TEST(UnlikeBodiesFigures, EffusivitiesShareAtHighSpeedAndConductivitiesAtTheEnd) {
  const Curve fast = over_s("share-a", "1000"), slower = over_s("share-a", "100");
  expect_near(
      part(fast, -0.1, 0.9), [](double) { return by_effusivity; }, 2.5e-3);
  const Curve begins = part(fast, -0.2, 0);
  for (std::size_t i = 0; i < begins.x.size(); ++i)
    EXPECT_GT(at(slower, begins.x[i]), begins.y[i]) << begins.x[i];
  EXPECT_NEAR(slower.y.back(), by_conductivity, 0.01);
  EXPECT_LT(fast.y.back(), 0.45);
}

// Ahead of the border the flux is the larger the slower, and it falls off like exp(-2 Pe2 z): at a
// distance of 0.1 that is exp(-4) for Pe1 = 100, and exp(-40) for 1000, where the grid has 1e-6.
TEST(UnlikeBodiesFigures, SlowerHeatReachesFartherAhead) {
  double larger = INFINITY;
  for (const char* speed : {"1", "10", "100", "1000"}) {
    const double flux = at(over_s("share-b", speed), stick_end - 0.1);
    EXPECT_LT(flux, larger) << speed;
    larger = flux;
  }
  EXPECT_LT(std::abs(larger), 1e-6);
  EXPECT_LT(at(over_s("share-b", "100"), stick_end - 0.1), std::exp(-4));
}

// Half the difference of both fluxes is what crosses: the closed form, but for the trailing edge,
// which is felt over some 1/Pe. Where the bodies stick the fluxes are opposite.
TEST(UnlikeBodiesFigures, AHotWheelLosesWhatTheClosedFormSays) {
  const Curve rail = over_s("hot-wheel-a", "rail"), wheel = over_s("hot-wheel-a", "wheel");
  Curve crossing = rail, friction_heat = rail;
  for (std::size_t i = 0; i < rail.x.size(); ++i) {
    const double root = std::sqrt(1 + rail.x[i]);
    crossing.y[i] = (rail.y[i] - wheel.y[i]) / 2 * root;
    friction_heat.y[i] = (rail.y[i] + wheel.y[i]) * root;
  }
  expect_near(
      part(crossing, -1, 0.9), [](double) { return 1; }, 1e-6);
  expect_near(
      part(friction_heat, -1, stick_end), [](double) { return 0; }, 1e-9);
  for (const double heat : part(friction_heat, stick_end, 1).y) EXPECT_GT(heat, 0);
}

// The rail is half as warm as far as nothing slips, and without friction to its end; little heat
// of friction runs ahead, exp(-12) at a distance of 0.06. Behind it the arc sine is what is left at
// high speed, but for lengths of 1/Pe.
TEST(UnlikeBodiesFigures, ARailStepsToTheMeanAndCools) {
  const Curve warm = over_s("hot-wheel-b", "friction"), alone = over_s("hot-wheel-b", "alone");
  expect_near(part(warm, -0.99, stick_end - 0.06), constant_half, 1e-5);
  expect_near(part(alone, -0.99, 0.9), constant_half, 1e-6);
  expect_near(
      part(alone, 1.1, 4), [](double s) { return std::asin(std::sqrt(2 / (1 + s))) / pi; }, 0.01);
  for (std::size_t i = 0; i < warm.x.size(); ++i) EXPECT_GE(warm.y[i], alone.y[i] - 1e-6);
  EXPECT_NEAR(warm.y.front(), 0, 1e-6);
  EXPECT_GT(largest(warm), 1);
}

// At the leading edge the contact steps to the mean temperature, from which it differs by a layer
// of 1/Pe at the trailing edge only, that is by a hundredth of the contact and of the friction.
// Before that counts the traction without slip, which is what the curves begin with.
TEST(UnlikeBodiesFigures, AHotWheelGripsAsAtTheMean) {
  const auto over_creep = [](const std::string& column) {
    return curve(data("hot-wheel-grip"), {}, "creep", column);
  };
  double higher = largest(over_creep("equal"));
  for (const std::string wheel : {"third", "whole"}) {
    const Curve hot = over_creep(wheel), mean = over_creep("mean_" + wheel);
    const double loss = hot.y.front(), share = wheel == "third" ? 5.0 / 6 : 0.5;
    EXPECT_LT(loss, 0);
    EXPECT_GT(loss, -0.014 * 0.6);
    EXPECT_EQ(mean.y.front(), 0);
    for (std::size_t i = 0; i < hot.x.size(); ++i)
      EXPECT_NEAR(hot.y[i], mean.y[i], std::abs(loss) + 0.01 * largest(mean)) << hot.x[i];
    EXPECT_NEAR(largest(hot), largest(mean), 0.01 * largest(mean));
    EXPECT_LT(largest(hot), higher);
    EXPECT_GT(largest(hot), share * largest(over_creep("equal")));  // a lower friction heats less
    higher = largest(hot);
  }
}
