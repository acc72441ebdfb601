// Cylinders that conduct and that brake, against references and against what they must have in
// common.
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "thermoroll/solution.hpp"

using namespace thermoroll;
using enum thermoroll::Quantity;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Approach coupled_to(double tolerance) {
  return {Formulation::corrected, tolerance, Method::coupled};
}

Scene braking(Scene scene) {
  scene.direction = Direction::braking;
  return scene;
}

Scene identical(double friction, double peclet, double heating) {
  return {friction, peclet, heating, {1, heating}};
}

/// The same two bodies with the names exchanged.
Scene exchanged(const Scene& x) {
  return {x.friction, x.peclet, x.roller.heating, {1 / x.roller.conductivity_ratio, x.heating}};
}

/// A contact that conducts, and a share of the friction as traction.
struct Random {
  Scene scene;
  double traction;
};

/// f 0.1 to 0.8, Pe 0.1 to 1e5, K2/K1 0.1 to 10, either heating up to 1/f, Q/f 0.05 to 0.95.
std::vector<Random> random_contacts(int count) {
  std::mt19937 generator(11);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(generator);
  };
  std::vector<Random> all;
  for (int i = 0; i < count; ++i) {
    const double f = uniform(0.1, 0.8), peclet = std::pow(10, uniform(-1, 5));
    const double heating = uniform(0, 1 / f), other = uniform(0, 1 / f);
    const Roller roller{std::pow(10, uniform(-1, 1)), other};
    all.push_back({{f, peclet, heating, roller}, f * uniform(0.05, 0.95)});
  }
  return all;
}

// An independent collocation in numpy, converged to 1e-10: panels of Gauss-Legendre nodes, graded
// to the ends of both zones, kernels by quadrature. All of them with f = 0.6 at the border -0.1845.
struct Reference {
  const char* name;
  Scene scene;
  double traction, creep, load_ratio, gamma0, heat, max_temperature;
};
const Reference references[] = {
    {"one body, driving",
     {0.6, 100, 1},
     0.4812009861344862,
     0.18040203073217198,
     1.0613796314727493,
     0.03904969153544046,
     0.15995525264343835,
     0.012233611076786843},
    {"identical, Pe 100", identical(0.6, 100, 1), 0.49407249261030434, 0.21859941581269426,
     1.076810969558368, 0.045465827400003975, 0.18000659708875358, 0.0071693027881198045},
    {"identical, Pe 1", identical(0.6, 1, 2), 0.5126880258240492, 0.22592240699826377,
     0.9881736130516381, 0.05769819680068176, 0.19304618805559534, 0.0665082699864253},
    {"one body, braking", braking({0.6, 100, 1}), -0.5061697711055194, -0.2603207357553707,
     1.0926737740065842, 0.051040337169797084, 0.19370656069520154, 0.01621761043407184}};

// Both are converged to 1e-10 of numbers of order one.
TEST(AlikeBodies, AgreeWithIndependentReferences) {
  for (const Reference& x : references) {
    SCOPED_TRACE(x.name);
    const Solution found = solve(x.scene, {stick_slip_border, -0.1845}, coupled_to(1e-10));
    EXPECT_NEAR(found.value(traction), x.traction, 2e-10);
    EXPECT_NEAR(found.value(creep), x.creep, 2e-10);
    EXPECT_NEAR(found.value(load_ratio), x.load_ratio, 2e-10);
    EXPECT_NEAR(found.value(gamma0), x.gamma0, 2e-10);
    EXPECT_NEAR(found.value(heat_integral), x.heat, 2e-10);
    EXPECT_NEAR(found.value(max_temperature), x.max_temperature, 1e-10);
  }
}

// Driving with bodies 1 and 2 is braking with 2 and 1. The equations are the same but for rounding,
// and the temperature is in units of the other conductivity.
TEST(AlikeBodies, DrivingIsBrakingOfExchangedBodies) {
  for (const auto& [scene, pull] : random_contacts(40)) {
    SCOPED_TRACE(pull);
    const Solution drives = solve(scene, {traction, pull}, coupled_to(1e-8));
    const Solution brakes = solve(exchanged(scene), {traction, -pull}, coupled_to(1e-8));
    const auto near = [&](Quantity q, double factor) {
      const double allowed = std::abs(factor) * (2 * (*drives.error)(q)) + 1e-14;
      EXPECT_NEAR(brakes.value(q), factor * drives.value(q), allowed);
    };
    near(creep, -1);
    for (const Quantity q : {stick_slip_border, load_ratio, gamma0, heat_integral}) near(q, 1);
    near(max_temperature, scene.roller.conductivity_ratio);
  }
}

// Without strain the shear stress works on nothing but slip: f int v p = xi Q.
TEST(AlikeBodies, IdenticalBodiesTurnTheWorkOfCreepIntoHeat) {
  for (const auto& [scene, pull] : random_contacts(40)) {
    const Scene alike = identical(scene.friction, scene.peclet, scene.heating);
    const Solution x = solve(alike, {traction, pull}, coupled_to(1e-8));
    const double work = x.value(creep) * pull, heat = scene.friction * x.value(heat_integral);
    EXPECT_NEAR(heat, work, scene.friction * (*x.error)(heat_integral) + pull * (*x.error)(creep));
  }
}

// Identical bodies brake as they drive, to the last bit; the paper's pair does not.
TEST(AlikeBodies, IdenticalBodiesHaveAnOddCurve) {
  const Approach approach = coupled_to(1e-6);
  for (const double pull : {0.1, 0.4, 0.59}) {
    const Scene scene = identical(0.6, 100, 1);
    const Solution drives = solve(scene, {traction, pull}, approach);
    const Solution brakes = solve(scene, {traction, -pull}, approach);
    EXPECT_EQ(brakes.value(creep), -drives.value(creep));
    EXPECT_EQ(brakes.value(load_ratio), drives.value(load_ratio));
    EXPECT_EQ(brakes.value(max_temperature), drives.value(max_temperature));
    const Scene paper{0.6, 100, 1};
    EXPECT_LT(solve(paper, {traction, pull}, approach).value(creep), 0.99 * drives.value(creep));
    EXPECT_LT(solve(paper, {traction, -pull}, approach).value(creep), 1.01 * brakes.value(creep));
  }
}

TEST(AlikeBodies, SignsAreThoseOfTheDirection) {
  const Scene scene{0.6, 100, 1};
  for (const Method method : {Method::closed_form, Method::automatic}) {
    const Solution x = solve(scene, {creep, -0.2}, {.method = method});
    EXPECT_EQ(x.scene.direction, Direction::braking);
    EXPECT_EQ(x.value(creep), -0.2);
    EXPECT_LT(x.value(traction), 0);
    for (const Quantity q : {creep_constant, load_ratio, heat_integral, max_temperature})
      EXPECT_GT(x.value(q), 0) << static_cast<int>(q);
    const Profile y = profile(x);
    EXPECT_TRUE((y.traction <= 0).all() && (y.slip <= 0).all());
    EXPECT_TRUE((y.pressure >= 0).all() && (y.heat_flux >= 0).all());
    EXPECT_GT(y.temperature.maxCoeff(), 0);
    EXPECT_GT(y.heat_flux.maxCoeff(), 0);
    EXPECT_LT(peaks(x).value.traction, -0.2);
    EXPECT_GT(peaks(x).error->traction, 0);
    EXPECT_GT(peaks(x).value.heat_flux, 0);
  }
  const Solution by_border = solve(braking(scene), {stick_slip_border, 0.1});
  EXPECT_LT(by_border.value(traction), 0);
  EXPECT_LT(by_border.value(creep), 0);
  const Solution again = solve(scene, {traction, by_border.value(traction)});
  EXPECT_NEAR(again.value(stick_slip_border), 0.1, 2 * (*again.error)(stick_slip_border));
}

// A roller that conducts leaves 1 / (1 + K2 / K1) of the heat to the half-space, and where heat
// does not act on the tractions nothing else changes.
TEST(AlikeBodies, HeatSplitsByConductivity) {
  const Scene cold{0.6, 100, 0};
  for (const double ratio : {0.25, 1.0, 3.0}) {
    Scene pair = cold;
    pair.roller.conductivity_ratio = ratio;
    EXPECT_NEAR(heat_share(pair), 1 / (1 + ratio), epsilon);
    const Solution alone = solve(cold, {traction, 0.4}), both = solve(pair, {traction, 0.4});
    EXPECT_EQ(both.value(heat_integral), alone.value(heat_integral));
    const double share = heat_share(pair), few = 10 * epsilon;  // roundings of a product
    const auto is_share = [&](double shared, double whole) {
      EXPECT_NEAR(shared, share * whole, few * whole);
    };
    is_share(both.value(max_temperature), alone.value(max_temperature));
    const Eigen::ArrayXd some = profile(both).temperature, all = profile(alone).temperature;
    for (Eigen::Index i = 0; i < all.size(); ++i) is_share(some(i), all(i));
    for (const double depth : {0.0, 0.1}) {
      const Curve a = temperature_curve(both, {0.5, 2}, depth);
      const Curve b = temperature_curve(alone, {0.5, 2}, depth);
      for (std::size_t i = 0; i < 2; ++i)
        is_share(a.points[i].temperature, b.points[i].temperature);
    }
  }
}

// H2 = H1 K1 / K2 is that of a body of the same expansion: its strain is that of the half-space.
TEST(AlikeBodies, StrainsOfOneExpansionCancel) {
  for (const double ratio : {0.1, 0.7, 1.0, 5.0}) {
    const Scene scene{0.6, 100, 1.5, {ratio, 1.5 / ratio}};
    EXPECT_NEAR(strain_share(scene), 0, 2 * epsilon);
    EXPECT_NEAR(heating_of_both(scene), 3 / (1 + ratio), 4 * epsilon);
  }
  EXPECT_EQ(strain_share({0.6, 100, 1}), 1);
  EXPECT_EQ(strain_share(braking({0.6, 100, 1})), -1);
  EXPECT_EQ(strain_share({0.6, 100, 0, {1, 2}}), -1);
}

// With K2 -> 0 at a fixed diffusivity the cylinder takes no heat, but it bulges: two identical
// bodies of twice the heating, as warm as one body alone, and not the insulated cylinder.
TEST(AlikeBodies, APoorConductorIsNoInsulator) {
  const Prescribed given{stick_slip_border, -0.1845};
  const Approach approach = coupled_to(1e-9);
  const double ratio = 1e-10, heating = 0.5;
  const Solution poor = solve({0.6, 100, heating, {ratio, heating / ratio}}, given, approach);
  const Solution alike = solve(identical(0.6, 100, 2 * heating), given, approach);
  for (const Quantity q : {traction, creep, load_ratio, gamma0, heat_integral})
    EXPECT_NEAR(poor.value(q), alike.value(q), 2 * (*alike.error)(q) + ratio);
  EXPECT_NEAR(poor.value(max_temperature), 2 * alike.value(max_temperature),
              4 * (*alike.error)(max_temperature) + ratio);
  const Solution insulated = solve({0.6, 100, heating}, given, approach);
  EXPECT_GT(std::abs(poor.value(creep) - insulated.value(creep)), 0.01);
}

TEST(AlikeBodies, ThePublishedSchemeIsForThePapersPair) {
  const Approach scheme{.method = Method::gauss_chebyshev};
  EXPECT_NO_THROW(solve({0.6, 10, 0.1}, {traction, 0.3}, scheme));
  EXPECT_THROW(solve({0.6, 10, 0.1}, {traction, -0.3}, scheme), std::invalid_argument);
  EXPECT_THROW(solve(identical(0.6, 10, 0.1), {traction, 0.3}, scheme), std::invalid_argument);
  EXPECT_THROW(solve({0.6, 10, 0.1, {0.5, 0}}, {traction, 0.3}, scheme), std::invalid_argument);
  EXPECT_THROW(solve(identical(0.6, 10, 0.1), {traction, 0.7}), std::invalid_argument);
  EXPECT_THROW(solve({0.6, 10, 0.1, {-1, 0}}, {traction, 0.3}), std::invalid_argument);
  EXPECT_THROW(solve({0.6, 10, 0.1, {1, -1}}, {traction, 0.3}), std::invalid_argument);
}

// The lesser models are as near the coupled solution as they say, for either direction.
TEST(AlikeBodies, LesserModelsKeepTheirErrors) {
  int lesser = 0;
  for (const auto& [scene, pull] : random_contacts(60)) {
    Scene weak = scene;
    weak.heating *= 1e-4;
    weak.roller.heating *= 1e-4;
    for (const double given : {pull, -pull})
      for (const Method method : {Method::automatic, Method::first_order}) {
        const Solution x = solve(weak, {traction, given}, {Formulation::corrected, 1e-4, method});
        const Solution exact = solve(weak, {traction, given}, coupled_to(1e-9));
        lesser += x.model != Model::coupled;
        for (int i = 0; i < compared; ++i)
          EXPECT_LE(std::abs(x.value[i] - exact.value[i]), (*x.error)[i] + (*exact.error)[i])
              << i << " by " << x.reason << ", traction " << given;
      }
  }
  EXPECT_GT(lesser, 120);
}

}  // namespace
