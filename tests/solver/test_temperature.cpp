#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "reference.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/temperature.hpp"

namespace {

using reference::close;
using reference::epsilon;
using reference::Real;
using thermoroll::carter;
using thermoroll::Estimate;
using thermoroll::HeatFlux;
using thermoroll::temperature;

constexpr double friction = 0.6;  // of every figure of the paper
constexpr double promised = 1e-9;

HeatFlux rolling(double traction) { return thermoroll::carter_flux(carter(friction, traction)); }

// A uniform heat of one over the contact.
HeatFlux uniform() {
  return {-1, 1, [](double, double) { return 1.0; }};
}

// T* by tanh-sinh panels in long double, in the distance u from the point of the heated zone
// nearest to s, graded towards it by factors of ten from the smallest of 1/Pe, the depth and the
// distance of s from the zone. No distance that vanishes is had by subtraction.
Real reference_temperature(const HeatFlux& flux, Real peclet, Real s, Real depth = 0) {
  const Real length = static_cast<Real>(flux.to) - flux.from;
  const Real below = s <= flux.from ? 0
                     : s >= flux.to ? length
                                    : s - flux.from;  // of nearest point
  const Real above = s <= flux.from ? length : s >= flux.to ? 0 : flux.to - s;
  const Real nearest = s <= flux.from ? flux.from - s : s >= flux.to ? flux.to - s : 0;  // its z
  Real least = 1 / peclet;
  if (depth > 0) least = std::min(least, depth);
  if (nearest != 0) least = std::min(least, std::abs(nearest));
  const auto heating = [&](Real u, Real left, Real right) -> Real {
    const Real heat = flux.density(static_cast<double>(left), static_cast<double>(right));
    return heat == 0 ? 0 : reference::M(peclet * (nearest + u), peclet * depth) * heat;
  };
  Real sum = 0;
  for (const int side : {-1, 1}) {
    const Real reach = side < 0 ? below : above;
    for (Real from = 0, to = least / 10; from < reach; from = to, to *= 10) {
      if (to > reach / 2) to = reach;
      sum += reference::integral(
          [&](Real near, Real far) {
            const Real u = from + near, rest = to == reach ? far : reach - u;
            return side < 0 ? heating(-u, rest, above + u) : heating(u, below + u, rest);
          },
          to - from, 1 / 12.0L);
    }
  }
  return sum / reference::pi;
}

// The unit band in closed form: with the antiderivatives x e^x (K0 + K1) - 1 of e^x K0, downstream,
// and x e^-x (K0 - K1) + 1 of e^-x K0, upstream.
Real band(Real peclet, Real s) {
  const auto behind = [](Real x) {
    return x <= 0 ? 0 : x * (reference::K0_scaled(x) + reference::K1_scaled(x)) - 1;
  };
  const auto ahead = [](Real x) {
    return x <= 0 ? 0 : 1 - x * std::exp(-2 * x) * reference::K1_less_K0_scaled(x);
  };
  const Real sum = behind(peclet * (s + 1)) - behind(peclet * (s - 1)) + ahead(peclet * (1 - s)) -
                   ahead(peclet * (-1 - s));
  return sum / (reference::pi * peclet);
}

// The value is within its error estimate of the truth, and the estimate within the promise.
void expect_estimate(const Estimate& found, Real exact) {
  EXPECT_TRUE(close(found.value, exact, found.error));
  EXPECT_LE(found.error, promised * std::abs(found.value));
}

// As a last digit printed: half a unit of it.
::testing::AssertionResult printed(double value, double digits, double unit) {
  return close(value, digits, unit / 2 * (1 + 1e-6));
}

}  // namespace

// The largest T* of the paper's four loads at six speeds, f = 0.6, by quadrature with another
// program (tanh-sinh; two of them by a third), to all eight digits after the point.
TEST(Temperature, TableOfMaxima) {
  const double speeds[] = {100, 500, 1000, 5000, 10000, 15000};
  struct Row {
    double traction, maximum[6], last, first, plateau;
  };
  const Row rows[] = {
      {0.20,
       {0.00307304, 0.00137470, 0.00097207, 0.00043472, 0.00030740, 0.00025099},
       0.9400,
       0.9425,
       0.03073954},
      {0.40,
       {0.00957152, 0.00428079, 0.00302698, 0.00135371, 0.00095722, 0.00078156},
       0.8832,
       0.8858,
       0.09572170},
      {0.50,
       {0.01451395, 0.00649109, 0.00458990, 0.00205267, 0.00145145, 0.00118511},
       0.8540,
       0.8566,
       0.14514547},
      {0.59,
       {0.02204389, 0.00985858, 0.00697107, 0.00311756, 0.00220445, 0.00179992},
       0.8219,
       0.8244,
       0.22044468},
  };
  for (const Row& row : rows) {
    const HeatFlux flux = rolling(row.traction);
    for (int i = 0; i < 6; ++i) {
      SCOPED_TRACE(::testing::Message() << "Q* = " << row.traction << ", Pe = " << speeds[i]);
      const thermoroll::Peak peak = thermoroll::hottest_point(flux, speeds[i]);
      EXPECT_TRUE(printed(peak.temperature.value, row.maximum[i], 1e-8));
      EXPECT_GE(peak.at, row.last - 1e-4);  // a unit of its last digit
      EXPECT_LE(peak.at, row.first + 1e-4);
    }
    // T sqrt(Pe) has a plateau; the next term is of relative order 1/Pe.
    const thermoroll::Peak fast = thermoroll::hottest_point(flux, 1e8);
    EXPECT_TRUE(printed(fast.temperature.value * 1e4, row.plateau, 1e-8))
        << "Q* = " << row.traction;
  }
  // The whole contact slips: 0.24962975 at 0.815006. At Q* = f (1 - 1e-12) the stick zone is 2e-6
  // wide.
  const thermoroll::Peak full = thermoroll::hottest_point(rolling(friction * (1 - 1e-12)), 1e8);
  EXPECT_TRUE(close(full.temperature.value * 1e4, 0.24962975, 0.5e-8 + 1e-6));
  EXPECT_TRUE(close(full.at, 0.815006, 0.5e-6 + 2e-6));
  // Behind the contact, Pe = 5000.
  const double tractions[] = {0.2, 0.4, 0.5, 0.59};
  const double at_two[] = {0.00012168, 0.00051865, 0.00087102, 0.00144427};
  const double at_three[] = {0.00008936, 0.00039355, 0.00067144, 0.00113176};
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(printed(temperature(rolling(tractions[i]), 5000, 2).value, at_two[i], 1e-8));
    EXPECT_TRUE(printed(temperature(rolling(tractions[i]), 5000, 3).value, at_three[i], 1e-8));
  }
}

TEST(Temperature, UniformBand) {
  struct Row {
    double peclet, maximum, at, centre, end, behind;
  };
  const Row rows[] = {
      {0.1, 2.2003300884, 0.2435, 2.1812134612, 1.8933984692, 1.3881005224},
      {1, 0.9918504218, 0.6664, 0.8639164287, 0.8753808745, 0.5514268906},
      {10, 0.3484997487, 0.9244, 0.2554113768, 0.3272037022, 0.1834177576},
      {100, 0.1124363739, 0.9877, 0.0798880058, 0.1097252756, 0.0583672004},
      {5000, 0.0159558555, 0.9996, 0.0112840738, 0.0158942287, 0.0082601896},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(::testing::Message() << "Pe = " << row.peclet);
    const thermoroll::Peak peak = thermoroll::hottest_point(uniform(), row.peclet);
    // Printed to ten digits, and a value to the promise.
    EXPECT_TRUE(close(peak.temperature.value, row.maximum, 0.5e-10 + promised * row.maximum));
    EXPECT_TRUE(printed(peak.at, row.at, 1e-4));
    EXPECT_TRUE(close(temperature(uniform(), row.peclet, 0).value, row.centre,
                      0.5e-10 + promised * row.centre));
    EXPECT_TRUE(
        close(temperature(uniform(), row.peclet, 1).value, row.end, 0.5e-10 + promised * row.end));
    EXPECT_TRUE(close(temperature(uniform(), row.peclet, 2).value, row.behind,
                      0.5e-10 + promised * row.behind));
  }
  // Against the closed form everywhere, and with the error estimate as the tolerance. The closed
  // form cancels against 1: 1e-18/(Pe T) relative, 1e-12 at the slowest.
  for (const double peclet : {1e-3, 0.02, 0.7, 30.0, 1000.0, 1e5, 1e8})
    for (const double s : {-1.0, -0.5, 0.0, 0.3, 0.99, 1 - 1e-6, 1.0, 1 + 1e-9, 1.5, 20.0}) {
      SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", s = " << s);
      const Estimate found = temperature(uniform(), peclet, s);
      const Real exact = band(peclet, s);
      EXPECT_TRUE(close(found.value, exact, found.error + 1e-17L / peclet));
      EXPECT_LE(found.error, promised * found.value);
    }
}

// The limit of high speed for a semi-ellipse: T* sqrt(Pe) -> J(s)/sqrt(2 pi), with J the integral
// of sqrt(1-t^2)/sqrt(s-t) over -1 < t < s, whose largest value is 2.1883066738 at s = 0.652230.
// The next term is of relative order 1/Pe.
TEST(Temperature, SemiEllipticBandAtHighSpeed) {
  const double peclet = 1e8, heat = 1.7;
  const HeatFlux flux = thermoroll::sliding_flux(heat);
  const Real scale = std::sqrt(2 * reference::pi * peclet) / (heat * 2 / reference::pi);
  const Real rate = 4 / static_cast<Real>(peclet);
  const thermoroll::Peak peak = thermoroll::hottest_point(flux, peclet);
  EXPECT_TRUE(close(scale * peak.temperature.value, 2.1883066738L, 0.5e-10L + rate));
  EXPECT_TRUE(close(peak.at, 0.652230, 0.5e-6));
  const Estimate end = temperature(flux, peclet, 1);
  EXPECT_TRUE(close(scale * end.value, 4 * std::sqrt(2.0L) / 3, rate)) << "J(1) = 4 sqrt(2)/3";
  for (const double s : {-0.9, -0.2, 0.4, 0.95}) {
    const Real abel = reference::integral(
        [&](Real left, Real right) { return std::sqrt(left * (1 - s + right)) / std::sqrt(right); },
        1 + static_cast<Real>(s));
    EXPECT_TRUE(close(scale * temperature(flux, peclet, s).value, abel, rate)) << "s = " << s;
  }
}

// Random fluxes, speeds, places and depths against long-double quadrature; the tolerance is the
// error estimate itself.
TEST(Temperature, ErrorEstimateIsHonest) {
  constexpr unsigned seed = 20240229;
  std::mt19937_64 random(seed);
  const auto uniformly = [&](double from, double to) {
    return from + (to - from) * std::uniform_real_distribution<double>()(random);
  };
  for (int i = 0; i < 400; ++i) {
    const double traction =
        friction * (i % 5 == 0 ? std::pow(10, uniformly(-4, -1)) : uniformly(0.02, 0.9999));
    const HeatFlux flux = i % 7 == 0   ? thermoroll::sliding_flux(0.3)
                          : i % 7 == 1 ? uniform()
                                       : rolling(traction);
    const double peclet = std::pow(10, uniformly(-3, 8));
    const double edge = i % 2 == 0 ? flux.from : flux.to;
    double s = uniformly(flux.from, flux.to);
    switch (i % 8) {
      case 0:
        s = edge;
        break;
      case 1:
        s = edge + uniformly(-3, 3) / peclet;
        break;
      case 2:
        s = edge + uniformly(-1, 1) * 1e-9;
        break;
      case 3:
        s = flux.to + uniformly(0, 30);
        break;
      case 4:
        s = flux.from - uniformly(0, 1) * std::min(10.0, 100 / peclet);
        break;
      default:
        break;
    }
    // On the surface, or as deep as heat reaches at all.
    double depth = 0;
    if (i % 3 == 0) depth = std::pow(10, uniformly(-9, 0.5)) / std::sqrt(std::max(peclet, 1.0));
    SCOPED_TRACE(::testing::Message()
                 << "seed " << seed << ", case " << i << ": from " << flux.from
                 << ", Pe = " << peclet << ", s = " << s << ", depth " << depth);
    Estimate found{};
    ASSERT_NO_THROW(found = temperature(flux, peclet, s, depth));
    const Real exact = reference_temperature(flux, peclet, s, depth);
    if (exact < 1e-280L) {  // upstream, below what a relative error can mean
      EXPECT_GE(found.value, 0);
      EXPECT_LE(found.value, 1e-279);
      continue;
    }
    expect_estimate(found, exact);
  }
}

// Below the surface 2 Pe dT/ds = T_ss + T_yy. Fourth-order differences; where their steps h and h/2
// disagree by d, the truncation left at h/2 is d/15. A value's noise is its error estimate at
// worst, times 6/h^2 in the second differences.
TEST(Temperature, SolvesTheHeatEquation) {
  const HeatFlux flux = rolling(0.5);
  struct Point {
    double peclet, s, y;
  };
  for (const Point& p :
       {Point{1, 0.3, 0.5}, Point{10, 0.8, 0.2}, Point{10, -0.4, 0.15}, Point{100, 0.9, 0.05},
        Point{100, 1.6, 0.12}, Point{1000, 0.7, 0.02}, Point{0.01, 2.0, 1.0}}) {
    SCOPED_TRACE(::testing::Message() << "Pe = " << p.peclet << ", s = " << p.s << ", y = " << p.y);
    Real noise = 0;
    const auto t = [&](Real ds, Real dy) {
      const Estimate found =
          temperature(flux, p.peclet, static_cast<double>(p.s + ds), static_cast<double>(p.y + dy));
      noise = std::max<Real>(noise, found.error);
      return static_cast<Real>(found.value);
    };
    Real carried = 0;
    const auto residual = [&](Real h) {
      const Real t0 = t(0, 0);
      const Real e1 = t(h, 0), e2 = t(2 * h, 0), w1 = t(-h, 0), w2 = t(-2 * h, 0);
      const Real d1 = t(0, h), d2 = t(0, 2 * h), u1 = t(0, -h), u2 = t(0, -2 * h);
      carried = 2 * p.peclet * (8 * (e1 - w1) - (e2 - w2)) / (12 * h);
      const Real conducted =
          (16 * (e1 + w1 + d1 + u1) - (e2 + w2 + d2 + u2) - 60 * t0) / (12 * h * h);
      return conducted - carried;
    };
    const Real h = 0.1L * p.y, coarse = residual(h), fine = residual(h / 2);
    const Real truncation =
        std::abs(coarse - fine) / 15 * 2;  // and as much again for the next order
    const Real rounding = 12 * noise / (h * h / 4);
    EXPECT_TRUE(close(fine, 0, truncation + rounding));
    EXPECT_LT(truncation + rounding, 1e-2L * std::abs(carried)) << "the test sees something";
  }
}

// At the surface the flux enters: -dT/dy = v* p* in the heated zone and 0 elsewhere. One-sided
// second-order differences at h and h/2, extrapolated; what is left is below their disagreement.
TEST(Temperature, TakesUpTheFluxAtTheSurface) {
  const HeatFlux flux = rolling(0.5);
  for (const double peclet : {0.1, 10.0, 300.0})
    for (const double s : {-0.6, 0.1, 0.5, 0.8, 1.3}) {
      SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", s = " << s);
      const bool heated = s > flux.from;
      const double given = heated && s < 1 ? flux.density(s - flux.from, 1 - s) : 0;
      Real noise = 0;
      const auto slope = [&](double h) {
        const Estimate t0 = temperature(flux, peclet, s), t1 = temperature(flux, peclet, s, h),
                       t2 = temperature(flux, peclet, s, 2 * h);
        noise = (3 * t0.error + 4 * t1.error + t2.error) / (2 * h);
        return (static_cast<Real>(3) * t0.value - static_cast<Real>(4) * t1.value + t2.value) /
               (2 * h);
      };
      const double h = 0.02 / (1 + std::sqrt(peclet));
      const Real coarse = slope(h), fine = slope(h / 2), extrapolated = fine + (fine - coarse) / 3;
      EXPECT_TRUE(close(extrapolated, given, std::abs(coarse - fine) + 2 * noise));
      EXPECT_LT(std::abs(coarse - fine) + 2 * noise, 2e-3L) << "the test sees something";
    }
}

// From far upstream, where a slow roller still warms the rail, to far behind, where s itself has
// lost the digits that tell the ends of the zone apart.
TEST(Temperature, FarAway) {
  for (const HeatFlux& flux : {rolling(0.5), rolling(1e-3), uniform()})
    for (const double peclet : {1e-3, 1.0, 1e4, 1e8})
      for (const double s : {1e2, 1e4, 1e6, 1e8}) {
        SCOPED_TRACE(::testing::Message()
                     << "from " << flux.from << ", Pe = " << peclet << ", s = " << s);
        expect_estimate(temperature(flux, peclet, s), reference_temperature(flux, peclet, s));
        if (peclet * s <= 100)
          expect_estimate(temperature(flux, peclet, -s), reference_temperature(flux, peclet, -s));
      }
}

// All heat is carried off: as int_0^inf K0(sqrt(x^2 + y^2)) dy = (pi/2) e^-|x|, the heat stored
// below a point s is int T dy = (1/2Pe) [heat upstream of s + int_{t>s} g e^(-2 Pe (t-s)) dt].
// Behind the contact that is all of it.
TEST(Temperature, ConservesHeat) {
  const double traction = 0.5;
  const thermoroll::Carter c = carter(friction, traction);
  const HeatFlux flux = rolling(traction);
  const auto g = [&](Real left, Real right) {
    return static_cast<Real>(flux.density(static_cast<double>(left), static_cast<double>(right)));
  };
  const Real length = static_cast<Real>(flux.to) - flux.from;
  for (const double peclet : {0.5, 20.0, 1000.0})
    for (const double s : {-0.4, 0.3, 0.85, 1.0, 1.5, 4.0}) {
      SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", s = " << s);
      // In panels up to the depth where the slowest part, e^(-Pe (r - x)) over a length x, is
      // e^-50.
      const Real reach = s - flux.from, deep = 50 / static_cast<Real>(peclet);
      const Real bottom = std::max(deep, std::sqrt(deep * (deep + 2 * std::abs(reach))));
      Real stored = 0, from = 0;
      for (const Real part : {0.002L, 0.02L, 0.1L, 0.3L, 1.0L}) {
        const Real to = part * bottom;
        stored += reference::integral(
            [&](Real y, Real) {
              return temperature(flux, peclet, s, static_cast<double>(from + y)).value;
            },
            to - from, 1 / 6.0L);
        from = to;
      }
      Real expected = 0;
      const Real cut = std::clamp<Real>(reach, 0, length);  // of the zone, upstream of s
      if (cut > 0)
        expected += reference::integral(
            [&](Real left, Real right) { return g(left, length - cut + right); }, cut);
      if (cut < length)
        expected += reference::integral(
            [&](Real left, Real right) {
              const Real ahead = reach < 0 ? left - reach : left;  // t - s
              return g(cut + left, right) * std::exp(-2 * peclet * ahead);
            },
            length - cut);
      // The temperature is good to 1e-9, and the rule with so few points to as much.
      EXPECT_TRUE(close(2 * peclet * stored / expected, 1, 2 * promised));
      if (s >= 1) {
        EXPECT_TRUE(close(2 * peclet * stored, thermoroll::carter_heat(c), 2 * promised));
      }
    }
}

// f int v* p* = xi* Q*. As a difference of doubles the zone's length has the rounding of c0, and
// the heat its square.
TEST(Temperature, TotalHeatIsTheEnergyIdentity) {
  for (const double traction : {1e-3, 0.2, 0.4, 0.5, 0.59, 0.599999}) {
    const thermoroll::Carter c = carter(friction, traction);
    const Estimate heat = thermoroll::total_heat(thermoroll::carter_flux(c));
    const Real power = static_cast<Real>(c.creep) * traction / friction;
    EXPECT_TRUE(close(heat.value, power, heat.error + 2 * epsilon / (1 - c.c0) * power))
        << traction;
    EXPECT_LE(heat.error, promised * heat.value);
  }
  expect_estimate(thermoroll::total_heat(uniform()), 2);
}

TEST(Temperature, SlidingCarriesTheHeatAsked) {
  for (const double heat : {1e-6, 0.188, 3.0}) {
    const HeatFlux flux = thermoroll::sliding_flux(heat);
    EXPECT_EQ(flux.from, -1);
    EXPECT_EQ(flux.to, 1);
    expect_estimate(thermoroll::total_heat(flux), heat);
    // One slip velocity, so the heat per pressure is the same everywhere.
    for (const double s : {-0.9, -0.3, 0.0, 0.6, 0.99})
      EXPECT_TRUE(close(flux.density(1 + s, 1 - s), heat * thermoroll::hertz_pressure(s),
                        8 * epsilon * heat));
  }
  EXPECT_EQ(temperature(thermoroll::sliding_flux(0), 10, 0).value, 0);
}

// The peak is at least as hot as any other place. At twice the error of its place to either side it
// is colder: the true top is no further off than one, where a parabola has fallen by twice the
// error of the value.
TEST(Temperature, MaximumIsTheMaximum) {
  for (const double peclet : {1e-3, 0.3, 50.0, 4360.0, 1e8})
    for (const HeatFlux& flux :
         {rolling(0.01), rolling(0.5), rolling(0.5999), uniform(), thermoroll::sliding_flux(1)}) {
      SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", from " << flux.from);
      const thermoroll::Peak peak = thermoroll::hottest_point(flux, peclet);
      const double length = flux.to - flux.from;
      EXPECT_GT(peak.at, flux.from);
      EXPECT_LE(peak.at, flux.to);
      expect_estimate(peak.temperature, reference_temperature(flux, peclet, peak.at));
      for (int i = -20; i <= 140; ++i) {
        const Estimate other = temperature(flux, peclet, flux.from + length * (i + 0.5) / 120);
        EXPECT_LE(other.value, peak.temperature.value + peak.temperature.error + other.error) << i;
      }
      EXPECT_GT(peak.at_error, 0);
      for (const double aside : {-2 * peak.at_error, 2 * peak.at_error})
        EXPECT_LT(temperature(flux, peclet, peak.at + aside).value, peak.temperature.value);
      EXPECT_LT(peak.at_error, 1e-2 * length);
    }
  // Positions known independently: the semi-ellipse at high speed, and the bands'.
  const thermoroll::Peak fast = thermoroll::hottest_point(thermoroll::sliding_flux(1), 1e8);
  EXPECT_TRUE(close(fast.at, 0.652230L, fast.at_error + 0.5e-6L + 1e-8L));
}

// However short the zone is, its top is found: at a hundredth of the zone to both sides it is
// colder by the same, but for a tenth.
TEST(Temperature, MaximumOfAShortZoneIsTheMaximum) {
  for (const double peclet : {1e3, 1e6, 1e9})
    for (const double traction : {6e-4, 6e-6, 6e-8}) {
      SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", Q* = " << traction);
      const HeatFlux flux = rolling(traction);
      const thermoroll::Peak peak = thermoroll::hottest_point(flux, peclet);
      const double length = flux.to - flux.from, far = length / 100;
      const double left = peak.temperature.value - temperature(flux, peclet, peak.at - far).value;
      const double right = peak.temperature.value - temperature(flux, peclet, peak.at + far).value;
      EXPECT_GT(left, 0);
      EXPECT_GT(right, 0);
      // A parabola through the three has its top within a tenth of that distance of the middle.
      EXPECT_LT(std::abs(left - right) / (2 * (left + right)), 0.1);
      EXPECT_LT(peak.at_error, 1e-2 * length);
    }
}

// The error delta of the maximum hides a distance e of the place over which the parabola falls by
// 2 delta. At a hundred times that distance it has fallen by 2e4 delta, which the errors of the two
// values, delta each, change by 1e-4. The curvature by which e was found is a mean over a hundredth
// of the zone to both sides; it differs from that at the top by a few per cent.
TEST(Temperature, ErrorOfThePlaceIsThatOfAParabola) {
  for (const double peclet : {0.3, 50.0, 4360.0})
    for (const HeatFlux& flux : {rolling(0.1), rolling(0.5), thermoroll::sliding_flux(1)}) {
      const thermoroll::Peak peak = thermoroll::hottest_point(flux, peclet);
      const double far = 100 * peak.at_error, top = peak.temperature.value;
      const double left = temperature(flux, peclet, peak.at - far).value;
      const double right = temperature(flux, peclet, peak.at + far).value;
      const double fallen = top - (left + right) / 2;
      EXPECT_NEAR(fallen / (2e4 * peak.temperature.error), 1, 0.05) << peclet << ' ' << flux.from;
    }
}

TEST(Temperature, RefusesWhatMakesNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const HeatFlux flux = rolling(0.5);
  for (const double peclet : {0.0, -1.0, nan, infinity})
    EXPECT_THROW(temperature(flux, peclet, 0), std::invalid_argument) << peclet;
  for (const double s : {nan, infinity, -infinity})
    EXPECT_THROW(temperature(flux, 1, s), std::invalid_argument) << s;
  for (const double depth : {-1e-9, nan, infinity})
    EXPECT_THROW(temperature(flux, 1, 0, depth), std::invalid_argument) << depth;
  EXPECT_THROW(thermoroll::hottest_point(flux, -1), std::invalid_argument);
}
