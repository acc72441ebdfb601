#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "reference.hpp"
#include "thermoroll/carter.hpp"

namespace {

using reference::close;
using reference::epsilon;
using reference::Real;
using thermoroll::Carter;
using thermoroll::carter;

struct Case {
  double friction, traction;
};

// The paper's four, one of another friction, and both ends of the creep curve.
const std::vector<Case> cases = {{0.6, 0.2},  {0.6, 0.4},   {0.6, 0.5},     {0.6, 0.59},
                                 {0.3, 0.01}, {0.25, 1e-5}, {0.6, 0.599999}};

double narrow(Real x) { return static_cast<double>(x); }

// Points of (from, to), none close to its ends.
std::vector<double> inner_points(double from, double to) {
  std::vector<double> points;
  for (const double part : {0.01, 0.13, 0.37, 0.5, 0.71, 0.88, 0.99})
    points.push_back(from + part * (to - from));
  return points;
}

// (1/pi) PV int q*(t)/(t - s) dt over the contact: the strain that a traction gives.
template <class Traction>
Real strain(Traction traction, double border, double s) {
  const auto q = [&](Real t) { return static_cast<Real>(traction(narrow(t))); };
  return reference::principal_value(q, {-1, border, 1}, s) / reference::pi;
}

// Rounding of that integral at a distance from the nearest kink. Values of the traction are good to
// 4 eps f, and to eps of the argument times the slope, which a square root bounds by
// f/sqrt(2 distance). In the folded part they are divided by u >= 1e-16, an integral of 2 x 37;
// outside it by t - s, where the logarithm is no larger: (1/pi) x 4 eps f x 150 in all.
double strain_rounding(double friction, double distance) {
  return 200 * epsilon * friction * (1 + 1 / std::sqrt(2 * distance));
}

}  // namespace

TEST(Carter, PressureCarriesTheLoad) {
  // t near -1 is rounded to eps, which changes the square root there by less than sqrt(eps) over a
  // length of eps: nothing. The rest is good to 4 eps of the integral, which is 1.
  const Real load = reference::integral(
      [](Real left, Real) { return thermoroll::hertz_pressure(narrow(left - 1)); }, 2);
  EXPECT_TRUE(close(load, 1, 4 * epsilon));
  EXPECT_TRUE(close(thermoroll::hertz_pressure(0), 2 / reference::pi, epsilon));
  for (const double s : {-1.0, 1.0, 1.5, -3.0, std::nextafter(1, 2)})
    EXPECT_EQ(thermoroll::hertz_pressure(s), 0) << s;
  // To full relative accuracy at the very edge: there sqrt(2 x distance).
  const double edge = 1 - std::ldexp(1, -50);
  EXPECT_TRUE(close(thermoroll::hertz_pressure(edge) / std::ldexp(1, -25),
                    2 / reference::pi * std::sqrt(2 - std::ldexp(1.0L, -50)), 4 * epsilon));
}

// @eq:normal without heat, kappa = 1: (1/pi) PV int p*/(t - s) dt = -(2/pi) s.
TEST(Carter, PressureSolvesTheNormalEquation) {
  for (const double s : inner_points(-1, 1)) {
    if (s == 0) continue;  // the kink that principal_value is told of
    const Real left = strain(thermoroll::hertz_pressure, 0, s);
    EXPECT_TRUE(close(left, -2 / reference::pi * s, strain_rounding(1, 1 - std::abs(s))))
        << "s = " << s;
  }
}

// The total of q* is Q*; of either zone to 4 eps of f int p* = f, the larger term.
TEST(Carter, TractionCarriesTheForce) {
  for (const Case& k : cases) {
    const Carter c = carter(k.friction, k.traction);
    const auto q = [&](Real t) { return thermoroll::carter_traction(c, narrow(t)); };
    const Real border = c.c0;
    const Real force =
        reference::integral([&](Real left, Real) { return q(left - 1); }, 1 + border) +
        reference::integral([&](Real, Real right) { return q(1 - right); }, 1 - border);
    EXPECT_TRUE(close(force, k.traction, 8 * epsilon * k.friction)) << "Q* = " << k.traction;
    EXPECT_EQ(q(-1), 0);
    EXPECT_EQ(q(1), 0);
    EXPECT_EQ(q(1.5), 0);
    EXPECT_EQ(q(-1.5), 0);
    EXPECT_EQ(c.friction, k.friction);
    // @eq:carter once more, from the numbers as they are stored.
    const Real slip = static_cast<Real>(k.traction) / k.friction;  // 1 - b^2 = (1 - b)(1 + b)
    const Real b = std::sqrt((k.friction - static_cast<Real>(k.traction)) / k.friction);
    const Real creep = 2 * k.friction / reference::pi * slip / (1 + b);
    EXPECT_TRUE(close(c.b, b, 4 * epsilon * b));
    EXPECT_TRUE(close(c.c0, 2 * b - 1, 4 * epsilon));
    EXPECT_TRUE(close(c.creep, creep, 8 * epsilon * creep));
  }
}

// Coulomb's law: |q*| < f p* where it sticks, q* = f p* where it slips.
TEST(Carter, TractionStaysBelowFriction) {
  for (const Case& k : cases) {
    const Carter c = carter(k.friction, k.traction);
    for (const double s : inner_points(-1, c.c0)) {
      EXPECT_LT(std::abs(thermoroll::carter_traction(c, s)),
                k.friction * thermoroll::hertz_pressure(s));
      EXPECT_GT(thermoroll::carter_traction(c, s), 0) << "a driven wheel pulls everywhere";
    }
    for (const double s : inner_points(c.c0, 1))
      EXPECT_EQ(thermoroll::carter_traction(c, s), k.friction * thermoroll::hertz_pressure(s));
  }
}

// v* = xi* - (1/pi) PV int q*/(t - s) dt over the whole contact: zero where it sticks, Carter's
// slip where it slips. Nothing of the corrective traction is used.
TEST(Carter, SlipFollowsFromTheTraction) {
  for (const Case& k : cases) {
    const Carter c = carter(k.friction, k.traction);
    const auto q = [&](double t) { return thermoroll::carter_traction(c, t); };
    const auto rounding = [&](double s) {
      const double kink = std::min({1 + s, std::abs(s - c.c0), 1 - s});
      return strain_rounding(k.friction, kink);
    };
    for (const double s : inner_points(-1, c.c0)) {
      EXPECT_TRUE(close(c.creep - strain(q, c.c0, s), 0, rounding(s)))
          << "sticks: Q* = " << k.traction << ", s = " << s;
      EXPECT_EQ(thermoroll::carter_slip(c, s), 0);
    }
    for (const double s : inner_points(c.c0, 1)) {
      EXPECT_TRUE(close(c.creep - strain(q, c.c0, s), thermoroll::carter_slip(c, s), rounding(s)))
          << "slips: Q* = " << k.traction << ", s = " << s;
      EXPECT_GT(thermoroll::carter_slip(c, s), 0);
    }
  }
}

// The flux, given by distances, is the product of slip and pressure, given by s. Where s - c0
// and 1 - s have lost digits the product has too: 2 eps/(s - c0) and the same at the other end.
TEST(Carter, HeatIsSlipTimesPressure) {
  for (const Case& k : cases) {
    const Carter c = carter(k.friction, k.traction);
    const thermoroll::HeatFlux flux = thermoroll::carter_flux(c);
    EXPECT_EQ(flux.from, c.c0);
    EXPECT_EQ(flux.to, 1);
    for (const double s : inner_points(c.c0, 1)) {
      const double product = thermoroll::carter_slip(c, s) * thermoroll::hertz_pressure(s);
      const double lost = 8 * epsilon + 2 * epsilon * (1 / (s - c.c0) + 1 / (1 - s));
      EXPECT_TRUE(close(flux.density(s - c.c0, 1 - s), product, lost * product))
          << "Q* = " << k.traction << ", s = " << s;
    }
    // At distances no subtraction can resolve it is the square root that it should be.
    const double tiny = 1e-40, length = 1 - c.c0;
    const Real scale = 4 * k.friction / (reference::pi * reference::pi);
    const Real start = scale * 2 * c.b * std::sqrt(static_cast<Real>(tiny) * length);
    const Real end = scale * (2 * c.b + length) * std::sqrt(static_cast<Real>(tiny) * length);
    EXPECT_TRUE(close(flux.density(tiny, length), start, 8 * epsilon * start));
    EXPECT_TRUE(close(flux.density(length, tiny), end, 8 * epsilon * end));
  }
}

// f int v* p* ds = xi* Q*. The zone's length enters the integral squared and has the rounding of
// c0, so each side is good to 2 eps/length; the sum itself to a few eps.
TEST(Carter, EnergyBalances) {
  for (const Case& k : cases) {
    const Carter c = carter(k.friction, k.traction);
    const thermoroll::HeatFlux flux = thermoroll::carter_flux(c);
    const Real heat = reference::integral(
        [&](Real left, Real right) { return flux.density(narrow(left), narrow(right)); },
        static_cast<Real>(flux.to) - flux.from);
    const Real power = c.creep * static_cast<Real>(k.traction);
    const double rounding = 16 * epsilon + 2 * epsilon / (1 - c.c0);
    EXPECT_TRUE(close(k.friction * heat, power, rounding * power)) << "Q* = " << k.traction;
    // The closed form of the total knows the zone's length to the last digit.
    EXPECT_TRUE(close(k.friction * thermoroll::carter_heat(c), power, 8 * epsilon * power));
  }
}

TEST(Carter, SmallTractionKeepsItsDigits) {
  const double friction = 0.6;
  for (const double part : {1e-3, 1e-8, 1e-14, 1e-20, 1e-100}) {
    const double traction = part * friction;
    const Carter c = carter(friction, traction);
    // With e = Q*/f as stored, 1 - b = e/2 + e^2/8 + e^3/16 + 5 e^4/128 + O(e^5), all in long
    // double; e^5/37 is below 1e-16 relative to e/2 for e up to 1e-3 (1e-12/18).
    const Real e = static_cast<Real>(traction) / friction;
    const Real width =
        e / 2 * (1 + e / 4 + e * e / 8 + 5 * e * e * e / 64 + 7 * e * e * e * e / 128);
    const Real creep = 2 * friction / reference::pi * width;
    const Real heat = width * width * 2 * friction / reference::pi * (2 - width);
    // Six roundings in c.creep, ten in the heat.
    EXPECT_TRUE(close(c.slip_half_width, width, 6 * epsilon * width)) << part;
    EXPECT_TRUE(close(c.creep, creep, 6 * epsilon * creep)) << part;
    EXPECT_TRUE(close(thermoroll::carter_heat(c), heat, 20 * epsilon * heat)) << part;
    EXPECT_TRUE(
        close(thermoroll::carter_creep_curve(friction, c.creep), traction, 10 * epsilon * traction))
        << part;
  }
}

// As the last sticking point goes, b = sqrt(1 - Q*/f) keeps its digits too: f - Q* is exact.
TEST(Carter, NearFullSlipKeepsItsDigits) {
  const double friction = 0.6;
  for (const double gap : {1e-3, 1e-8, 1e-14}) {
    const double traction = friction * (1 - gap);
    const Carter c = carter(friction, traction);
    const Real b = std::sqrt((static_cast<Real>(friction) - traction) / friction);
    EXPECT_TRUE(close(c.b, b, 2 * epsilon * b)) << gap;
    EXPECT_TRUE(close(1 + static_cast<Real>(c.c0), 2 * b, 2 * epsilon)) << gap;
    EXPECT_TRUE(close(c.slip_half_width, 1 - b, 4 * epsilon)) << gap;
    EXPECT_GT(c.c0, -1);
  }
  EXPECT_THROW(carter(friction, friction), std::invalid_argument);
  EXPECT_THROW(carter(friction, 0), std::invalid_argument);
  EXPECT_THROW(carter(0, 0.5), std::invalid_argument);
}

// The force for the creep of a force is that force. Near full slip the curve is flat, so relative
// to Q* the error is a few eps everywhere.
TEST(Carter, CreepCurveInvertsTheTraction) {
  for (const Case& k : cases) {
    const Carter c = carter(k.friction, k.traction);
    EXPECT_TRUE(close(thermoroll::carter_creep_curve(k.friction, c.creep), k.traction,
                      10 * epsilon * k.traction));
  }
  for (const double friction : {0.1, 0.6, 2.0}) {
    const double last = narrow(2 * friction / reference::pi);
    EXPECT_EQ(thermoroll::carter_creep_curve(friction, 0), 0);
    EXPECT_EQ(thermoroll::carter_creep_curve(friction, 1.01 * last), friction);
    EXPECT_EQ(thermoroll::carter_creep_curve(friction, 1e300), friction);
    EXPECT_TRUE(
        close(thermoroll::carter_creep_curve(friction, last), friction, 2 * epsilon * friction));
    // @eq:creep-curve at half of it: 3/4 of the friction.
    EXPECT_TRUE(close(thermoroll::carter_creep_curve(friction, last / 2), 0.75L * friction,
                      4 * epsilon * friction));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(thermoroll::carter_creep_curve(0.6, -1e-9), std::invalid_argument);
  EXPECT_THROW(thermoroll::carter_creep_curve(0.6, nan), std::invalid_argument);
  EXPECT_THROW(thermoroll::carter_creep_curve(0, 0.1), std::invalid_argument);
  EXPECT_THROW(thermoroll::carter_creep_curve(nan, 0.1), std::invalid_argument);
}
