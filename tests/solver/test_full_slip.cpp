// Full slip against references that share nothing with the solver: an independent collocation, the
// border next to it, and limits in closed form.
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "reference.hpp"
#include "solver/gauss_legendre.hpp"
#include "thermoroll/coupled.hpp"

namespace {

using reference::close;
using thermoroll::CoupledSolution;
using thermoroll::Direction;
using thermoroll::Formulation;
using thermoroll::Quantity;
using thermoroll::Scene;

CoupledSolution solve(const Scene& scene, Quantity given, double value, double tolerance = 1e-9) {
  return thermoroll::solve_coupled(scene, {Formulation::corrected, tolerance}, {given, value});
}

CoupledSolution slipping(const Scene& scene, double creep, double tolerance = 1e-9) {
  CoupledSolution x = solve(scene, Quantity::creep, creep, tolerance);
  EXPECT_EQ(x.value(Quantity::stick_slip_border), -1) << creep;
  EXPECT_EQ(x.value(Quantity::slip_length), 2) << creep;
  return x;
}

// v* at the leading edge of a contact that slips, with constant friction.
double leading_slip(const CoupledSolution& x) {
  const thermoroll::SmoothTractions y = thermoroll::smooth_tractions(x, x.unknowns);
  const Eigen::MatrixXd at = thermoroll::legendre(Eigen::ArrayXd::Constant(1, -1), y.h.size());
  return (at * y.h)(0) / (at * y.pressure)(0);
}

// Uniform slip w, the rigid sliding of a cylinder: far beyond full slip, xi* = w, with so little
// heating that f H w is what it is to be.
Scene sliding(double strength, double peclet, double w) {
  return {0.6, peclet, strength / (0.6 * w)};
}
constexpr double far_beyond = 1e6;

// The creep that the refusal of a larger one names.
double creep_limit(const Scene& scene, double creep) {
  try {
    solve(scene, Quantity::creep, creep);
  } catch (const std::invalid_argument& refusal) {
    const std::string message = refusal.what(), before = "creep_limit of about ";
    const std::size_t at = message.find(before);
    const bool below = scene.direction == Direction::driving;
    const std::string asked = below ? "creep = " : "creep = -";
    const std::string must_be = below ? "must be below" : "must be above";
    if (message.find(asked) == 0 && message.find(must_be) != std::string::npos &&
        at != std::string::npos)
      return std::stod(message.substr(at + before.size()));
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

// An independent collocation with panels, in Python, with constant friction, f = 0.6. Both are
// converged to 1e-10.
TEST(FullSlip, AgreesWithIndependentReferences) {
  const CoupledSolution x = slipping({0.6, 100, 1}, 0.5, 1e-10);
  EXPECT_TRUE(x.violations.empty());
  EXPECT_EQ(x.value(Quantity::traction), 0.6);
  EXPECT_EQ(x.value(Quantity::creep), 0.5);
  EXPECT_TRUE(close(x.value(Quantity::creep_constant), 0.5719435069244716L, 2e-10L));
  EXPECT_TRUE(close(x.value(Quantity::load_ratio), 1.0541541017603624L, 2e-10L));
  EXPECT_TRUE(close(x.value(Quantity::gamma0), 0.11990584487411934L, 2e-10L));
  EXPECT_TRUE(close(x.value(Quantity::heat_integral), 0.5085439613100176L, 2e-10L));
  EXPECT_TRUE(close(x.value(Quantity::max_temperature), 0.030869161446950177L, 2e-10L));
  EXPECT_TRUE(close(x.value(Quantity::max_temperature_at), 0.8338390558553344L, 1e-6L));
  EXPECT_TRUE(close(leading_slip(x), 0.28936604380149883L, 2e-10L));
}

// Without heat Hertz's pressure and the slip xi* + (2f/pi) s, whose heat is xi*.
TEST(FullSlip, WithoutHeatItIsInClosedForm) {
  const CoupledSolution x = slipping({0.6, 100, 0}, 0.7, 1e-10);
  EXPECT_TRUE(close(x.value(Quantity::heat_integral), 0.7L, 1e-13L));
  EXPECT_TRUE(close(x.value(Quantity::load_ratio), 1, 1e-14L));
  const thermoroll::Profile y = thermoroll::profile(x);
  for (Eigen::Index i = 0; i < y.s.size(); ++i) {
    const double s = y.s(i), p = 2 / thermoroll::pi * std::sqrt((1 - s) * (1 + s));
    EXPECT_TRUE(close(y.pressure(i), p, 1e-13L)) << s;
    EXPECT_TRUE(close(y.traction(i), 0.6 * p, 1e-13L)) << s;
    EXPECT_TRUE(close(y.pressure(i) * y.slip(i), p * (0.7 + 1.2 / thermoroll::pi * s), 1e-13L))
        << s;  // the slip is a quotient of what vanishes at both ends
  }
}

// As the stick zone of length e vanishes, creep and load ratio go to those at which the leading
// edge just slips, as e does, and the traction to friction as its square: without heat they miss
// them by f e / pi, 0 and f e^2 / 4. A quarter of e leaves a quarter, or a sixteenth, but for a
// tenth.
TEST(FullSlip, JoinsPartialSlip) {
  for (const double heating : {0.1, 1.0})
    for (const Direction direction : {Direction::driving, Direction::braking}) {
      Scene scene{0.6, 100, heating};
      scene.direction = direction;
      const double near =
          1.02 * solve(scene, Quantity::stick_slip_border, -0.999).value(Quantity::creep);
      // Without slip at the leading edge: by Neville's scheme, through three creeps.
      std::vector<double> creep, ratio, edge;
      for (const double more : {1.0, 1.01, 1.02}) {
        const CoupledSolution x = slipping(scene, more * near);
        creep.push_back(more * near);
        ratio.push_back(x.value(Quantity::load_ratio));
        edge.push_back(leading_slip(x));
      }
      const auto at_edge = [&](std::vector<double> v) {
        for (std::size_t k = 1; k < v.size(); ++k)
          for (std::size_t i = v.size() - 1; i >= k; --i)
            v[i] = (edge[i - k] * v[i] - edge[i] * v[i - 1]) / (edge[i - k] - edge[i]);
        return v.back();
      };
      const double creep_1 = at_edge(creep), ratio_1 = at_edge(ratio);
      double missed = 0, missed_ratio = 0, missed_force = 0;
      for (const double stick : {2.5e-3, 6.25e-4}) {
        const CoupledSolution x = solve(scene, Quantity::stick_slip_border, stick - 1);
        const double now = creep_1 - x.value(Quantity::creep),
                     now_ratio = ratio_1 - x.value(Quantity::load_ratio),
                     now_force = scene.friction - x.value(Quantity::traction);
        EXPECT_GT(now, 0) << heating;
        EXPECT_GT(now_force, 0) << heating;
        if (missed > 0) {
          EXPECT_NEAR(missed / now, 4, 0.4) << heating;
          EXPECT_NEAR(missed_ratio / now_ratio, 4, 0.4) << heating;
          EXPECT_NEAR(missed_force / now_force, 16, 1.6) << heating;
        }
        missed = now;
        missed_ratio = now_ratio;
        missed_force = now_force;
      }
    }
}

// Two bodies alike: the strains cancel, so that the power of the pull is the heat, f heat = xi* Q*,
// though heat bends the profile.
TEST(FullSlip, HeatIsThePowerOfThePull) {
  for (const double creep : {0.5, 1.0})
    for (const Direction direction : {Direction::driving, Direction::braking}) {
      const CoupledSolution x = slipping({0.6, 100, 1, {1, 1}, direction}, creep);
      EXPECT_GT(std::abs(x.value(Quantity::load_ratio) - 1), 0.01);
      EXPECT_TRUE(close(x.value(Quantity::heat_integral), creep,
                        static_cast<reference::Real>(x.error(Quantity::heat_integral))));
    }
}

// Braking is driving with the bodies exchanged: the same numbers but for the temperature, which is
// of the same half of the heat.
TEST(FullSlip, BrakingIsDrivingWithTheBodiesExchanged) {
  const CoupledSolution x = slipping({0.6, 100, 1, {1, 0.2}}, 0.6),
                        y = slipping({0.6, 100, 0.2, {1, 1}, Direction::braking}, 0.6),
                        z = slipping({0.6, 100, 1, {1, 0.2}, Direction::braking}, 0.6);
  for (int i = 0; i < thermoroll::compared; ++i) EXPECT_TRUE(close(x.value[i], y.value[i], 1e-13L));
  EXPECT_GT(std::abs(z.value(Quantity::load_ratio) - x.value(Quantity::load_ratio)), 1e-3);
}

// The largest T* sqrt(Pe) that is left of the flux g at Pe -> infinity, of heat that only goes
// downstream: the integral of g / sqrt(s - t) over sqrt(2 pi). Without heat v* is linear in s. At
// the maximum the slope is zero, so that a golden section leaves the square of its interval.
double fast_limit(double f, double creep) {
  const auto at = [&](double s) {
    return static_cast<double>(
        reference::integral(
            [&](reference::Real left, reference::Real right) {
              const reference::Real t = left - 1, p = std::sqrt(left * (2 - left));
              return 2 / reference::pi * p * (creep + 2 * f / reference::pi * t) / std::sqrt(right);
            },
            1 + s) /
        std::sqrt(2 * reference::pi));
  };
  double low = 0, high = 1;
  while (high - low > 1e-7) {
    const double a = high - 0.618034 * (high - low), b = low + 0.618034 * (high - low);
    (at(a) < at(b) ? low : high) = at(a) < at(b) ? a : b;
  }
  return at(low);
}

// The distance from the limit falls with Pe^2, as its first term, of 1 / Pe, is the slope of the
// limit along s, and that is zero at the maximum. The next term is of Pe^3. It changes the observed
// order by about its share, and what two successive extrapolations differ by is seven times that of
// the finer one.
TEST(FullSlip, LargestTemperatureTendsToTheFastLimitWithThePecletNumberSquared) {
  for (const double creep : {0.5, 1.0, 10.0}) {
    const auto at = [&](double peclet) {
      return std::sqrt(peclet) *
             slipping({0.6, peclet, 0}, creep, 1e-11).value(Quantity::max_temperature);
    };
    const double a = at(50), b = at(100), c = at(200);
    EXPECT_NEAR(std::log2((b - a) / (c - b)), 2, 0.04) << creep;
    const double before = b + (b - a) / 3, extrapolated = c + (c - b) / 3;
    EXPECT_NEAR(extrapolated, fast_limit(0.6, creep), std::abs(extrapolated - before)) << creep;
  }
}

// Fast sliding: P_H / P = 1 / (1 - 4 theta^2) with tan(pi theta) = f H w, as in Johnson's sliding
// of dissimilar cylinders. The end layers, as wide as 1 / Pe, leave an error of order Pe^-1/2.
TEST(FullSlip, FastSlidingHasTheLoadOfDissimilarCylinders) {
  const double theta = std::atan(0.3) / thermoroll::pi, exact = 1 / (1 - 4 * theta * theta);
  double last = 0, before = 0, found = 0;
  for (const double peclet : {1e4, 1e5, 1e6}) {
    before = last;
    last = found;
    found =
        slipping(sliding(0.3, peclet, far_beyond), far_beyond, 1e-8).value(Quantity::load_ratio);
  }
  const double root = std::sqrt(10.0);
  EXPECT_NEAR((last - before) / (found - last), root, 0.01 * root);
  // What is left once it is extrapolated is of order 1 / Pe, times what stands before Pe^-1/2.
  EXPECT_NEAR(found + (found - last) / (root - 1), exact, 1e-6);
}

// The limit that the refusal names is below the creep and has seven digits, of which six are
// decimals here, whatever creep is asked for.
TEST(FullSlip, LimitOfTheCreepIsBelowTheCreep) {
  const Scene scene{0.01, 0.01, 1e4};
  const double limit = creep_limit(scene, 3);
  for (const double creep : {3.0, 3.2, 4.0}) {
    const double named = creep_limit(scene, creep);
    EXPECT_LT(named, creep);
    EXPECT_EQ(named, limit);
    EXPECT_NE(named, std::round(1e4 * named) / 1e4);
  }
}

// Strong heat, in which the equations have solutions with a load at any creep, but with tension
// somewhere. The contacts are a curve on which the load falls. It ends at the limit, whatever creep
// is asked for. The limit is rounded down to seven digits, so that 2e-7 more is refused. The
// secants leave 1e-10 of the load, and the load falls by 1.5 per creep, as the last rows show.
TEST(FullSlip, LimitOfTheCreepIsWhereTheContactsEnd) {
  const Scene scene{0.6, 1, 30};
  const double limit = creep_limit(scene, 1);
  for (const double creep : {limit + 2e-7, 0.79, 0.8, 0.85, 1.5, 1e3})
    EXPECT_EQ(creep_limit(scene, creep), limit) << creep;
  double last = 1;
  for (const double creep : {0.17, 0.2, 0.25, 0.3, 0.35, 0.4, 0.6, 0.7, 0.75, limit - 1e-4}) {
    const CoupledSolution x = slipping(scene, creep, 1e-6);
    EXPECT_TRUE(x.violations.empty()) << creep;
    EXPECT_LT(x.value(Quantity::load_ratio), last) << creep;
    last = x.value(Quantity::load_ratio);
  }
  EXPECT_NEAR(last, 1.5e-4, 0.1e-4);
}

// A body that drives another is braked by it, so that a limit stands on either side. Where the
// cylinder braked is refused, its creep is negative, and so is the limit.
TEST(FullSlip, LimitOfTheCreepHasItsSign) {
  const Scene driven{0.01, 0.01, 1e4, {1, 0}}, braked{0.01, 0.01, 0, {1, 1e4}, Direction::braking};
  const double limit = creep_limit(driven, 10);
  EXPECT_EQ(creep_limit(braked, 10), -limit);
}

// What the refusal of a creep says after some words, and the type of it.
template <class Refusal>
double named_after(const std::string& words, const Scene& scene, double creep) {
  try {
    solve(scene, Quantity::creep, creep);
  } catch (const Refusal& refusal) {
    const std::string message = refusal.what();
    const std::size_t at = message.find(words);
    if (at != std::string::npos) return std::stod(message.substr(at + words.size()));
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// Slow sliding in which both surfaces separate at an edge long before the load is lost: the creep
// that is named has a contact, and two hundredths more has none. The contacts are followed to a
// ten-thousandth, and 1.01 times the last is seen to have none by two grids.
TEST(FullSlip, SeparationIsALimitOfTheCreep) {
  const Scene driven{0.6, 1, 1}, braked{0.6, 1, 1, {}, Direction::braking};
  for (const Scene& scene : {driven, braked}) {
    const bool drives = scene.direction == Direction::driving;
    const std::string words =
        drives ? "below the creep_limit of at least " : "above the creep_limit of at most -";
    const double named = named_after<std::invalid_argument>(words, scene, 50);
    ASSERT_GT(named, 5) << words;
    EXPECT_TRUE(solve(scene, Quantity::creep, named, 1e-5).violations.empty());
    const CoupledSolution beyond = solve(scene, Quantity::creep, 1.02 * named, 1e-5);
    ASSERT_FALSE(beyond.violations.empty());
    EXPECT_EQ(beyond.violations.front().what, "separation");
  }
}

// Where it is not known whether contact is lost, the creep that is named has one. Full slip begins
// in the first scene; in the other one nothing is found next to it.
TEST(FullSlip, WhatIsNotResolvedNamesACreepWithAContact) {
  const Scene driven{0.6, 1, 100}, braked{0.6, 1, 30, {}, Direction::braking};
  const double slips = named_after<std::runtime_error>(
      "no contact found in full slip at the creep 5; the creep_limit is at least ", driven, 5);
  const double sticks =
      named_after<std::runtime_error>("; the creep_limit is at most -", braked, 5);
  for (const auto& [scene, creep] : {std::pair{driven, slips}, std::pair{braked, sticks}}) {
    ASSERT_GT(creep, 0.01);
    EXPECT_TRUE(solve(scene, Quantity::creep, creep, 1e-5).violations.empty());
  }
}

// Slow sliding with f H Pe w = 1: the load ratio 0.138858263385, of (-d^2/dx^2)^(1/2) p = p + 2/pi;
// and contact is lost at the first eigenvalue of that operator, 1.1577738837 (Kulczycki, Kwasnicki,
// Malecki, Stos, arXiv:0906.3113). Both are off by Pe times a factor that has its logarithm.
TEST(FullSlip, ContactIsLostAtTheFirstEigenvalue) {
  constexpr double eigenvalue = 1.1577738837, ratio = 0.138858263385;
  double off_limit = 0, off_ratio = 0;
  for (const double peclet : {1e-2, 1e-3, 1e-4}) {
    const Scene scene = sliding(1 / peclet, peclet, far_beyond);
    const double now_limit = creep_limit(scene, 1.3 * far_beyond) / far_beyond - eigenvalue;
    const double now_ratio = slipping(scene, far_beyond).value(Quantity::load_ratio) - ratio;
    EXPECT_LT(std::abs(now_limit), 2 * peclet);
    EXPECT_LT(std::abs(now_ratio), 2 * peclet);
    if (off_limit > 0) {
      EXPECT_NEAR(off_limit / now_limit, 10, 0.5) << peclet;
      EXPECT_NEAR(off_ratio / now_ratio, 10, 0.5) << peclet;
      // Extrapolated, a twentieth of the ninth is left, and a millionth of the bisection.
      EXPECT_NEAR(eigenvalue + now_limit + (now_limit - off_limit) / 9, eigenvalue,
                  now_limit / 18 + 3e-6);
      EXPECT_NEAR(ratio + now_ratio + (now_ratio - off_ratio) / 9, ratio, now_ratio / 18);
    }
    off_limit = now_limit;
    off_ratio = now_ratio;
  }
}

// Fast, with Hertz's pressure and uniform slip: 1.23461983096109546 of the temperature of a uniform
// heat source (Ertz and Knothe's problem), here of (2/pi) w / sqrt(2 Pe). At 1e6 half a slip
// difference of 2f/pi from end to end, over w = 1e6, is left of it.
TEST(FullSlip, FastFlashTemperatureIsErtzAndKnothes) {
  const double w = far_beyond, peclet = 1e6;
  const CoupledSolution x = slipping({0.6, peclet, 0}, w);
  const double unit = 2 / thermoroll::pi * w / std::sqrt(2 * peclet);
  EXPECT_NEAR(x.value(Quantity::max_temperature) / unit, 1.23461983096109546, 2e-7);
}

// In full slip the flux grows with the creep, and with it the layers of strong heat: f H is 0.23
// and 0.73 here, where fH > 1 was taken to be strong, but the creep is 27 and 6 times that of the
// onset.
TEST(FullSlip, StrongHeatHasTheErrorOfItsFlux) {
  struct Given {
    Scene scene;
    double creep, tolerance;
  };
  for (const Given& x : {Given{{0.480773, 19075.3, 0.481348}, 8.32668, 1e-5},
                         Given{{1.11135, 5381.76, 0.65365}, 4.40223, 1e-5}}) {
    const CoupledSolution coarse = slipping(x.scene, x.creep, x.tolerance);
    const CoupledSolution fine = slipping(x.scene, x.creep, 1e-3 * x.tolerance);
    for (int k = 0; k < thermoroll::compared; ++k)
      EXPECT_LE(std::abs(coarse.value[k] - fine.value[k]), coarse.error[k] + fine.error[k])
          << x.scene.peclet << ": " << k;
  }
}

// At high speed, next to the creep at which full slip begins, the tail falls slowly, and the
// largest temperature is off by 1.1 to 1.2 times as much of it as counts in partial slip.
TEST(FullSlip, ErrorsOfFastScenesAreTwiceThoseByTheTail) {
  Scene braking{0.11955205, 346138.12263296376, 0.012156167};
  braking.direction = Direction::braking;
  const Scene driving{0.066708945, 346525.39572814351, 0.30018057};
  for (const auto& [scene, creep, tolerance] :
       {std::tuple{braking, 0.0762416639, 1e-8}, {driving, 0.0429407109, 3.1e-8}}) {
    const CoupledSolution coarse = slipping(scene, creep, tolerance);
    const CoupledSolution fine = slipping(scene, creep, 1e-10);
    for (int k = 0; k < thermoroll::compared; ++k)
      EXPECT_LE(std::abs(coarse.value[k] - fine.value[k]), coarse.error[k] + fine.error[k])
          << scene.peclet << ": " << k;
  }
}
