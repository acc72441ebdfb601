// Bodies of unlike diffusivities: their kernels against the transforms that they are made from, and
// whole solutions against references, limits and each other.
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "solver/conduction.hpp"
#include "thermoroll/quadrature.hpp"
#include "thermoroll/solution.hpp"

using namespace thermoroll;
using enum thermoroll::Quantity;

namespace {

Approach coupled_to(double tolerance) {
  return {Formulation::corrected, tolerance, Method::coupled};
}

/// Pairs whose speeds differ by a thousandth to a thousandfold, either way.
std::vector<Scene> pairs() {
  return {{0.6, 100, 1, {2, 0.7, 20}},  {0.6, 20, 0.7, {0.5, 1, 100}},
          {0.6, 2, 1, {2, 0.7, 0.5}},   {0.3, 1000, 0.1, {0.3, 2, 1}},
          {0.3, 5, 0.1, {7, 0.4, 5e3}}, {0.3, 100, 1, {1, 1, 100.1}},
          {0.6, 100, 1, {1e-4, 1, 1e6}}};
}

/// The same two bodies with the names exchanged.
Scene exchanged(const Scene& x) {
  const Roller other{1 / x.roller.conductivity_ratio, x.heating, x.peclet};
  return {x.friction, x.roller.peclet, x.roller.heating, other, x.direction};
}

/// delta(p) of the partition at a real p below both 2 Pe.
double delta(const Scene& x, double p) {
  const double a = std::sqrt(2 * x.peclet - p), b = std::sqrt(2 * x.roller.peclet - p);
  return x.roller.conductivity_ratio * (a - b) / (a + x.roller.conductivity_ratio * b);
}

Remainders from_table(const PairTable& table, double z) {
  thermoroll::Kernels k{};
  Remainders r;
  thermoroll::remainders(table, 1, &z, &k);
  thermoroll::temperatures_upstream(table, 1, &z, &r(4));
  r.head<4>() << k.n1, k.n2_up, k.n2_down, k.m_down;
  return r;
}

/// The integral of a remainder times exp(p z) over 0 < z < reach, from its table.
double transform(const PairTable& table, int remainder, double p, double reach) {
  std::vector<double> points;
  for (double z = reach * 0x1p-50; z < reach; z *= 4) points.push_back(z);
  points.push_back(reach);
  return integrate([&](double z) { return from_table(table, z)(remainder) * std::exp(p * z); },
                   points)
      .value;
}

// Bodies that are unlike by a part in 1e9 are as hot ahead of the heat as alike ones, where the
// temperature has fallen by up to 26 decades: its logarithm changes by at most 2 Pe_2 times the
// distance, 3e-8 of it, and both solutions have nine digits.
TEST(UnlikeBodies, AlikeBodiesAreTheirLimitAheadOfTheHeat) {
  const std::vector<double> at{-30, -8, -5, -3, -2, -1.5};
  const auto ahead = [&](const Roller& roller) {
    return temperature_curve(solve({0.6, 1, 0.02, roller}, {traction, 0.5}, coupled_to(1e-9)), at,
                             0);
  };
  const Curve alike = ahead({1, 0.02, 1}), unlike = ahead({1, 0.02, 1 + 1e-9});
  for (std::size_t i = 0; i < at.size(); ++i)
    EXPECT_NEAR(unlike.points[i].temperature / alike.points[i].temperature, 1, 1e-7) << at[i];
}

// From 2^-20 / (2 Pe) of the faster body on the table is as good as its exponentials, which are
// squared up to seven times: 2^7 epsilon each, and ten times that in their sum, are 3e-13 of the
// largest values; ten times that is allowed.
TEST(UnlikeBodies, TheTableIsItsExponentials) {
  std::mt19937 generator(3);
  for (const Scene& x : pairs()) {
    const PairTable table(x);
    const double first = 0x1p-21 / std::max(x.peclet, x.roller.peclet);
    const double rounding = 1e-14 * (x.heating + x.roller.heating + 1);
    Remainders scale = Remainders::Zero();
    for (double z = first; z < 4; z *= 2)
      scale = scale.cwiseMax(all_exponentials(table, z).cwiseAbs());
    std::uniform_real_distribution<double> exponent(std::log(first), std::log(4));
    for (int i = 0; i < 200; ++i) {
      const double z = std::exp(exponent(generator));
      const Remainders apart = from_table(table, z) - all_exponentials(table, z);
      for (int k = 0; k < 5; ++k) EXPECT_LE(std::abs(apart(k)), 3e-12 * scale(k) + rounding) << z;
    }
  }
}

// Transforms at p = -1, where that of the slope is analytic: delta times H (1 - sqrt(p / (p - 2
// Pe))) of each body. For the temperature, whose two sides are summed at a p between 0 and 2 Pe, it
// is pi delta over sqrt(p (2 Pe - p)). Beyond the reach exp(-36) of them is left, the quadrature is
// good to 1e-9, and the remainders are regular at z = 0.
TEST(UnlikeBodies, RemaindersAreTheirIntegrals) {
  for (const Scene& x : pairs()) {
    const PairTable table(x);
    const auto slope = [&](double h, double pe, double p) {
      return h * (1 - std::sqrt(p / (p - 2 * pe)));
    };
    const double p = -1, h1 = x.heating, h2 = x.roller.heating;
    const double exact = delta(x, p) * (slope(h1, x.peclet, p) - slope(h2, x.roller.peclet, p));
    EXPECT_NEAR(transform(table, 0, p, 36), exact, 1e-8 * (h1 + h2));
    const double q = 0.2 * std::min(x.peclet, x.roller.peclet);
    const double both = transform(table, 4, q, 4 / q) + transform(table, 3, -q, 36 / q);
    const double root = std::sqrt(q * (2 * x.peclet - q));
    EXPECT_NEAR(both, pi * delta(x, q) / root, 1e-8 / root);
  }
}

// Which body is the first does not matter to the temperature, with K1 T / omega in common; slopes
// add, and strains subtract. Errors of the tables are those of the test above.
TEST(UnlikeBodies, BothBodiesAreEquallyHot) {
  for (const Scene& x : pairs()) {
    const Conduction one(x), other(exchanged(x));
    const thermoroll::GradedArray zeta = Eigen::pow(10.0, Eigen::ArrayXd::LinSpaced(40, -6, 1.5));
    const auto a = at_distances(one, zeta), b = at_distances(other, zeta);
    thermoroll::GradedArray behind(zeta.size());
    for (Eigen::Index i = 0; i < a.size(); ++i) behind[i] = a[i].m_down;
    const Eigen::ArrayXd up = temperatures_ahead(one, zeta, behind) / behind;
    const Eigen::ArrayXd same = temperatures_ahead(other, zeta, behind) / behind;
    EXPECT_LT((up - same).abs().maxCoeff(), 1e-11);
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(a[i].m_down, b[i].m_down, 1e-11 * a[i].m_down);
      EXPECT_NEAR(a[i].n1, b[i].n1, 1e-11);
      EXPECT_NEAR(a[i].n2_up, -b[i].n2_up, 1e-11 * (1 + std::abs(a[i].n2_up)));
      EXPECT_NEAR(a[i].n2_down, -b[i].n2_down, 1e-11 * (1 + std::abs(a[i].n2_down)));
    }
  }
}

// The independent collocation of test_two_bodies.cpp, with the partition as an unknown. Both are
// converged to 1e-10 of numbers of order one.
TEST(UnlikeBodies, AgreeWithAnIndependentReference) {
  const Scene scene{0.6, 100, 1, {2, 0.7, 20}};
  const Solution x = solve(scene, {stick_slip_border, -0.1845}, coupled_to(1e-10));
  EXPECT_NEAR(x.value(traction), 0.4931146464525543, 2e-10);
  EXPECT_NEAR(x.value(creep), 0.21122536022617175, 2e-10);
  EXPECT_NEAR(x.value(load_ratio), 1.0566696021456268, 2e-10);
  EXPECT_NEAR(x.value(gamma0), 0.03680916862513919, 2e-10);
  EXPECT_NEAR(x.value(heat_integral), 0.1790172859971811, 2e-10);
  EXPECT_NEAR(x.value(max_temperature), 0.007427996001771632, 1e-10);
  EXPECT_NEAR(effusivity_share(scene) * x.value(heat_integral), 0.09449678871143838, 2e-10);
}

/// Contacts in which next to nothing crosses ahead of the leading edge.
std::vector<Scene> random_contacts(int count) {
  std::mt19937 generator(12);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(generator);
  };
  std::vector<Scene> all;
  for (int i = 0; i < count; ++i) {
    const double f = uniform(0.1, 0.8), peclet = std::pow(10, uniform(1.7, 5));
    const Roller roller{std::pow(10, uniform(-1, 1)), uniform(0, 1 / f),
                        std::pow(10, uniform(1.7, 5))};
    all.push_back({f, peclet, uniform(0, 1 / f), roller});
  }
  return all;
}

// Driving with bodies 1 and 2 is braking with 2 and 1, and the temperature is in units of the other
// conductivity.
TEST(UnlikeBodies, DrivingIsBrakingOfExchangedBodies) {
  for (const Scene& scene : random_contacts(8)) {
    const double pull = 0.6 * scene.friction;
    const Solution drives = solve(scene, {traction, pull}, coupled_to(1e-10));
    const Solution brakes = solve(exchanged(scene), {traction, -pull}, coupled_to(1e-10));
    const auto near = [&](Quantity q, double factor) {
      const double allowed = std::abs(factor) * 2 * (*drives.error)(q);
      EXPECT_NEAR(brakes.value(q), factor * drives.value(q), allowed);
    };
    near(creep, -1);
    for (const Quantity q : {stick_slip_border, load_ratio, gamma0, heat_integral}) near(q, 1);
    near(max_temperature, scene.roller.conductivity_ratio);
  }
}

// At one diffusivity the pair is a pair of alike bodies, and next to it the results differ by about
// as much as the diffusivities do.
TEST(UnlikeBodies, NextToOneDiffusivityNothingChanges) {
  const Scene alike{0.6, 100, 1, {0.5, 0.4}}, near{0.6, 100, 1, {0.5, 0.4, 100 * (1 + 1e-9)}};
  const Solution x = solve(alike, {traction, 0.4}, coupled_to(1e-8));
  const Solution y = solve(near, {traction, 0.4}, coupled_to(1e-8));
  for (const Quantity q : {stick_slip_border, creep, load_ratio, gamma0, max_temperature})
    EXPECT_NEAR(x.value(q), y.value(q), 2 * (*x.error)(q) + 1e-8);
}

// The largest temperature of two scenes of full slip was further from a finer one than its error: a
// coarse grid of a strongly heated contact misses a layer, and with a bulk difference the
// coefficients hardly fall from one grid to the next.
TEST(UnlikeBodies, LayersCountInTheLargestTemperature) {
  Scene strong{0.136538, 11438, 6.92437, {1.59622, 2.7342, 252643}};
  Scene bulk{0.335001, 8100.81, 0.0484899, {0.512861, 0.065343, 74146.6}};
  bulk.bulk_difference = 7.65392e-5;
  for (const auto& [scene, creep, tolerance] :
       {std::tuple{strong, 0.089464, 3.87e-6}, {bulk, 0.2106635412, 1e-5}}) {
    const auto hottest = [scene = scene, creep = creep](double to) {
      Scene braking = scene;
      braking.direction = thermoroll::Direction::braking;
      const auto x = solve_coupled(braking, {Formulation::corrected, to}, {Quantity::creep, creep});
      return std::pair{x.value(Quantity::max_temperature), x.error(Quantity::max_temperature)};
    };
    const auto [rough, error] = hottest(tolerance);
    EXPECT_NEAR(rough, hottest(tolerance / 100).first, error);
  }
}

// The insulated cylinder is the limit of one of vanishing effusivity at fixed heat capacity: what
// is left of the difference is of the order of e2 / e1, ten times smaller for a tenth of it.
TEST(UnlikeBodies, TheInsulatorIsTheLimitAtFixedHeatCapacity) {
  const double exact =
      solve({0.6, 100, 1}, {stick_slip_border, -0.1845}, coupled_to(1e-9)).value(traction);
  const auto left = [&](double e) {  // K2 / K1 = e^2, Pe2 = Pe1 / e^2
    const Scene scene{0.6, 100, 1, {e * e, 1, 100 / (e * e)}};
    const Solution x = solve(scene, {stick_slip_border, -0.1845}, coupled_to(1e-9));
    return x.value(traction) - exact;
  };
  const double first = left(0.1), second = left(0.01), third = left(0.001);
  EXPECT_NEAR(first / second, 10, 1.5);
  EXPECT_NEAR(second / third, 10, 0.2);
}

// They know nothing of a pair.
TEST(UnlikeBodies, LesserMethodsAreRefused) {
  const Scene scene{0.6, 100, 1, {2, 0.7, 20}};
  for (const Method method : {Method::closed_form, Method::first_order, Method::gauss_chebyshev})
    EXPECT_THROW(solve(scene, {traction, 0.4}, {Formulation::corrected, 1e-6, method}),
                 std::invalid_argument);
}

}  // namespace

// The table of a pair and the exchange of a bulk difference are kept until another pair comes. What
// is solved after a pair that differs in one number is, bit by bit, what another thread finds,
// which has kept nothing.
TEST(UnlikeBodies, AnotherPairHasAnotherTable) {
  const auto kappa = [](const Scene& scene) {
    return solve(scene, {stick_slip_border, 0}, coupled_to(1e-3)).value(load_ratio);
  };
  for (const double difference : {0.0, 0.001}) {
    Scene first{0.6, 20, 0.7, {0.5, 1, 100}};
    first.bulk_difference = difference;
    std::vector<Scene> others(5, first);
    others[0].peclet = 21;
    others[1].heating = 0.8;
    others[2].roller.conductivity_ratio = 0.6;
    others[3].roller.heating = 1.1;
    others[4].roller.peclet = 110;
    const double before = kappa(first);
    for (const Scene& other : others) {
      kappa(first);
      const double here = kappa(other);
      double there = 0;
      std::thread([&] { there = kappa(other); }).join();
      EXPECT_EQ(here, there);
      EXPECT_NE(here, before);
    }
  }
}
