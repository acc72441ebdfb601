// Laws for a range of speeds against the solver, and against the laws that they join.
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "thermoroll/coupled.hpp"
#include "thermoroll/creep_law_by_speed.hpp"

namespace {

using thermoroll::CoupledSolution;
using thermoroll::creep_law;
using thermoroll::creep_law_by_speed;
using thermoroll::CreepLaw;
using thermoroll::CreepLawBySpeed;
using thermoroll::Direction;
using thermoroll::evaluate;
using thermoroll::exponential_friction;
using thermoroll::Formulation;
using thermoroll::LawHalf;
using thermoroll::LawValue;
using thermoroll::Quantity;
using thermoroll::Scene;
using thermoroll::SceneBySpeed;

// Steel on steel, Pe 100 at speed 1; T* per kelvin falls with the speed.
Scene steel(double speed) { return {0.4, 100 * speed, 0.01, {1, 0.01}}; }

Scene hot(double speed) {
  Scene scene = steel(speed);
  scene.law = exponential_friction({0.15 / speed, 0.3});
  return scene;
}

// Friction falls above a temperature that fast contacts reach at small creeps, and slow ones at
// large.
Scene kinked(double speed) {
  Scene scene = steel(speed);
  scene.law = exponential_friction({0.15 / speed, 0.3, 0.06 / speed});
  return scene;
}

// A hot wheel on a cold rail, of another material and without a law of friction.
Scene hot_wheel(double speed) {
  Scene scene{0.4, 100 * speed, 0.02, {2, 0.01, 150 * speed}};
  scene.bulk_difference = 0.02 / speed;
  return scene;
}

// Much heat, so that the whole curve moves with the speed.
Scene soft(double speed) { return {0.6, 20 * speed, 0.5}; }

CreepLawBySpeed law_of(const SceneBySpeed& at, double to, double tolerance = 1e-4) {
  return creep_law_by_speed(at, Formulation::corrected, 1, to, tolerance);
}

// The largest error over the stated one, of traction, border and temperature, at random creeps and
// speeds, away from the state without slip.
double worst_error(const SceneBySpeed& scene_at, double to, double tolerance, int points) {
  const CreepLawBySpeed law = law_of(scene_at, to, tolerance);
  std::mt19937 random(17);
  std::uniform_real_distribution<> share(0, 1);
  double worst = 0;
  for (int i = 0; i < points; ++i) {
    const double speed = std::pow(to, share(random)), z = 0.1 + 1.8 * share(random);
    const bool brakes = i % 2 == 1;
    const LawHalf& half = brakes ? law.laws[0].braking : law.laws[0].driving;
    const double size = half.unit_creep * (z < 1 ? z * z : 1 / (2 - z));
    Scene scene = scene_at(speed);
    scene.direction = brakes ? Direction::braking : Direction::driving;
    const CoupledSolution x = thermoroll::solve_coupled(
        scene, {Formulation::corrected, tolerance / 100}, {Quantity::creep, size});
    const LawValue y = evaluate(law, brakes ? -size : size, speed).value();
    const auto error = [&](double value, Quantity q, double stated) {
      const double off = std::abs(value - x.value(q)) / (stated + x.error(q));
      if (!(off <= worst)) worst = off;  // a NaN stays
    };
    error(brakes ? -y.traction : y.traction, Quantity::traction, law.traction_error);
    error(y.border, Quantity::stick_slip_border, law.border_error);
    // Unit creeps at other speeds are up to a twentieth smaller or larger here.
    error(y.temperature, Quantity::max_temperature,
          law.temperature_error / speed * std::max(1.0, 0.95 * size / half.unit_creep));
  }
  return worst;
}

TEST(CreepLawBySpeed, HoldsItsErrors) {
  EXPECT_LT(worst_error(steel, 30, 1e-4, 30), 1);
  EXPECT_LT(worst_error(steel, 6, 1e-4, 30), 1);  // one piece, about as wide as may be
  EXPECT_LT(worst_error(hot, 10, 1e-4, 30), 1);
  EXPECT_LT(worst_error(hot, 3, 1e-6, 30), 1);
  EXPECT_LT(worst_error(hot_wheel, 3, 1e-3, 30), 1);
  EXPECT_LT(worst_error(soft, 3, 1e-4, 30), 1);
  EXPECT_LT(worst_error(kinked, 8, 1e-3, 20), 1);
}

// With laws in full slip at the same temperature, kinks do not need more pieces than smooth laws.
TEST(CreepLawBySpeed, WideRangesTakeFewPieces) {
  EXPECT_LE(law_of(steel, 60).laws.size(), 17);
  EXPECT_LE(law_of(hot, 60).laws.size(), 17);
  EXPECT_EQ(law_of(kinked, 4, 1e-3).laws.size(), 5);
}

TEST(CreepLawBySpeed, ErrorsIncludeThoseOfItsLaws) {
  const CreepLawBySpeed law = law_of(hot_wheel, 2);
  for (std::size_t i = 0; i < law.laws.size(); ++i) {
    EXPECT_GE(law.traction_error, law.laws[i].traction_error);
    EXPECT_GE(law.border_error, law.laws[i].border_error);
    EXPECT_GE(law.temperature_error, law.laws[i].temperature_error * law.speeds[i]);
  }
}

// With r the ratio of the outer speeds, the polynomial through five laws errs by 3.28 / 5! (ln r /
// 4)^5 times the fifth derivative by ln V halfway to the second. T* goes about as the speed to
// -1/2, so that this derivative is 1/32 of it.
TEST(CreepLawBySpeed, ErrorsIncludeThoseBetweenItsLaws) {
  const double ratio = 6;
  const CreepLawBySpeed law = law_of(steel, ratio);
  ASSERT_EQ(law.laws.size(), 5);
  const CreepLaw& fastest = law.laws.back();
  const double hottest = evaluate(fastest, fastest.driving.unit_creep).value().temperature;
  const double between = 3.28 / 120 * std::pow(std::log(ratio) / 4, 5) / 32 * hottest;
  EXPECT_GT(law.temperature_error, fastest.temperature_error * ratio + between);
}

// Here the weights are 0 and 1, but for the rounding of logarithms, some 1e-15 of each law.
TEST(CreepLawBySpeed, IsItsLawAtEachSpeed) {
  const CreepLawBySpeed law = law_of(hot, 100);
  ASSERT_EQ(law.speeds.size(), law.laws.size());
  EXPECT_GT(law.speeds.size(), 5);
  EXPECT_EQ(law.speeds.size() % 4, 1);
  EXPECT_EQ(law.speeds.front(), 1);
  EXPECT_EQ(law.speeds.back(), 100);
  for (std::size_t i = 0; i < law.speeds.size(); ++i)
    for (const double creep : {-3.0, -0.2, -0.01, 0.0, 0.05, 0.24, 0.27, 2.0}) {
      const LawValue one = evaluate(law.laws[i], creep).value();
      const LawValue sum = evaluate(law, creep, law.speeds[i]).value();
      EXPECT_NEAR(sum.traction, one.traction, 1e-13);
      EXPECT_NEAR(sum.slope, one.slope, 1e-13 * 4);
      EXPECT_NEAR(sum.temperature, one.temperature, 1e-13 * (1 + one.temperature));
      EXPECT_NEAR(sum.border, one.border, 1e-13);
    }
}

// The central difference over h has an error of h^2 / 6 times a third derivative, of some hundreds.
TEST(CreepLawBySpeed, SlopeIsTheDerivative) {
  const double h = 1e-5;
  for (const SceneBySpeed& scene : {SceneBySpeed(hot), SceneBySpeed(soft)}) {
    const CreepLawBySpeed law = law_of(scene, 20, 1e-2);
    for (const double speed : {1.3, 7.7})
      for (const double creep : {-0.6, -0.1, 0.02, 0.2, 0.4}) {
        const auto at = [&](double x) { return evaluate(law, x, speed).value(); };
        EXPECT_NEAR(at(creep).slope, (at(creep + h).traction - at(creep - h).traction) / (2 * h),
                    1e-7);
      }
  }
}

// Weights sum to 1 but for rounding; full slip is told by -1 itself.
TEST(CreepLawBySpeed, FullSlipHasNoBorder) {
  const CreepLawBySpeed law = law_of(hot, 10, 1e-3);
  for (double speed = 1; speed < 10; speed += 0.37)
    for (const double creep : {-2.0, -0.5, 0.4, 1.1})
      EXPECT_EQ(evaluate(law, creep, speed).value().border, -1);
}

// Contact lasts longer at the higher speeds, so that the laws of the lower ones end the sums there.
TEST(CreepLawBySpeed, SlowLawsEndAtHighSpeeds) {
  const CreepLawBySpeed law = law_of([](double speed) { return Scene{0.6, speed, 1}; }, 1.2, 1e-3);
  const double end = earliest_end(law, false).creep, fastest = law.speeds.back();
  EXPECT_LT(end, law.laws.front().driving.last_creep);
  EXPECT_TRUE(evaluate(law, end * (1 - 1e-9), fastest));
  EXPECT_FALSE(evaluate(law, end * (1 + 1e-9), fastest));
  EXPECT_EQ(earliest_end(law, false).reason, law.laws.front().driving.reason);
}

// With a bulk difference the creep without slip is not zero, and ends of braking have both signs.
TEST(CreepLawBySpeed, EarliestEndIsCountedFromNoSlip) {
  CreepLawBySpeed law;
  for (const double speed : {1.0, 1.1, 1.21, 1.331, 1.4641}) {
    CreepLaw one;
    one.no_slip_creep = 0.1;
    one.driving = {1, {}, 0.3, "driving ends"};
    one.braking = {1, {}, speed == 1.21 ? 0.05 : 0.14, "braking ends"};
    law.speeds.push_back(speed);
    law.laws.push_back(one);
  }
  EXPECT_DOUBLE_EQ(earliest_end(law, true).creep, 0.1 - 0.05);
  EXPECT_DOUBLE_EQ(earliest_end(law, false).creep, 0.1 + 0.3);
}

// Contact is lost at the creep 7.78 where Pe is 0.5, and before that where it is larger. Each law
// is taken at creeps beyond full slip that grow as the root of the speed over its own.
TEST(CreepLawBySpeed, EndsWithTheFirstOfItsLaws) {
  const CreepLawBySpeed law = law_of(
      [](double speed) {
        return Scene{0.6, 0.5 * speed, 1};
      },
      1.3, 1e-3);
  ASSERT_EQ(law.laws.size(), 5);
  const auto end_at = [&](std::size_t k) {
    double end = 20;
    for (std::size_t i = 0; i < 5; ++i) {
      const double share = law.laws[i].driving.last_creep / law.laws[i].driving.unit_creep;
      const double stretch = std::sqrt(law.speeds[k] / law.speeds[i]);
      end = std::min(end, law.laws[k].driving.unit_creep * (1 + (share - 1) / stretch));
    }
    return end;
  };
  for (const std::size_t k : {0, 2, 4}) {
    EXPECT_TRUE(evaluate(law, end_at(k) * (1 - 1e-9), law.speeds[k]));
    EXPECT_FALSE(evaluate(law, end_at(k) * (1 + 1e-9), law.speeds[k]));
  }
  EXPECT_NEAR(earliest_end(law, false).creep, end_at(4), 1e-9);
  EXPECT_EQ(earliest_end(law, false).reason, law.laws[4].driving.reason);
  EXPECT_LT(earliest_end(law, true).creep, -1);
  EXPECT_FALSE(evaluate(law, 0.1, 1 - 1e-9));
  EXPECT_FALSE(evaluate(law, 0.1, 1.3 + 1e-9));
  EXPECT_FALSE(evaluate(law, 0.1, std::nan("")));
  EXPECT_FALSE(evaluate(law_of(steel, 2), INFINITY, 1.1));
}

// Under strong heat braking loses contact before all slips: there is no share of full slip, and
// laws are taken at one creep.
TEST(CreepLawBySpeed, HoldsWhereNotAllSlips) {
  const auto strong = [](double speed) { return Scene{0.6, 10 * speed, 5}; };
  const CreepLawBySpeed law = law_of(strong, 1.2, 1e-3);
  EXPECT_EQ(scale_of(law, 0, 2, true), 1);
  EXPECT_EQ(scale_of(law, 0, 2, false), law.laws[2].driving.unit_creep);
  const CreepLaw exact = creep_law(strong(1.11), Formulation::corrected, 1e-4);
  const double end = earliest_end(law, true).creep;
  EXPECT_LT(end, -0.4);
  for (const double creep : {0.99 * end, -0.2, -0.05, 0.05, 0.15, 0.2, 1.0}) {
    const LawValue x = evaluate(law, creep, 1.11).value(), y = evaluate(exact, creep).value();
    EXPECT_NEAR(x.traction, y.traction, law.traction_error);
    EXPECT_NEAR(x.border, y.border, law.border_error);
    const double grown = std::max(1.0, creep / law.laws[0].driving.unit_creep);
    EXPECT_NEAR(x.temperature, y.temperature, law.temperature_error * grown);
  }
  EXPECT_FALSE(evaluate(law, 1.05 * end, 1.11));
}

// Laws that have nothing to do with each other.
TEST(CreepLawBySpeed, IsNotMadeOfLawsThatJump) {
  try {
    law_of([](double speed) { return Scene{speed < 1.5 ? 0.3 : 0.4, 100 * speed, 0}; }, 2);
    FAIL() << "a law across a jump";
  } catch (const thermoroll::NotResolved& error) {
    const std::string said = error.what();
    double a = 0, b = 0;
    ASSERT_EQ(std::sscanf(said.c_str(), "law: not resolved between the speeds %lf and %lf", &a, &b),
              2)
        << said;
    EXPECT_LE(a, 1.5);
    EXPECT_GE(b, 1.5);
    EXPECT_LT(b / a, 1.02);
  }
}

// From the speed 2 on the wheel is so hot that the contact next to no slip exceeds friction.
TEST(CreepLawBySpeed, RefusalsNameTheSpeed) {
  const auto melts = [](double speed) {
    Scene scene = steel(speed);
    if (speed >= 2) scene = {0.3, 100, 1, {1, 1}, Direction::driving, {}, 0.5};
    return scene;
  };
  try {
    law_of(melts, 2);
    FAIL() << "a law of no scene";
  } catch (const thermoroll::NotResolved& error) {
    EXPECT_EQ(std::string(error.what()).find("at the speed 2: "), 0) << error.what();
  }
}

TEST(CreepLawBySpeed, RefusesWhatMakesNoSense) {
  EXPECT_THROW(law_of(steel, 1), std::invalid_argument);
  EXPECT_THROW(law_of(steel, std::nan("")), std::invalid_argument);
  EXPECT_THROW(law_of(steel, 2, 2e-7), std::invalid_argument);
  EXPECT_THROW(law_of(steel, 2, 0.1), std::invalid_argument);
  EXPECT_THROW(creep_law_by_speed(steel, Formulation::corrected, 0, 1), std::invalid_argument);
}

}  // namespace
