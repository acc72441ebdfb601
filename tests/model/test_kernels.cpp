#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "reference.hpp"
#include "thermoroll/kernels.hpp"

namespace {

using reference::close;
using reference::epsilon;
using reference::Real;
using reference::size_of_N2;
using thermoroll::Formulation;
namespace kernel = thermoroll::kernel;

// The promise of kernels.hpp: relative to the value, or to the larger term where terms cancel.
constexpr Real promised = 1e-13L;

// All decades, and both sides of every border between two formulas.
std::vector<double> arguments() {
  std::vector<double> x = reference::decades();
  for (const double border : {1.0, 2.0, 30.0, 700.0, 710.0, 745.0})
    for (const double side : {0.0, border}) {
      x.push_back(std::nextafter(border, side));
      x.push_back(border * (1 + (side > 0 ? -1e-3 : 1e-3)));
      x.push_back(border);
    }
  return x;
}

}  // namespace

// The reference itself: its trapezoidal sums against values of the DLMF's functions known to 30
// digits, K_0(1), K_1(1) and I_0(1) - I_1(1) (series summed by hand), to 100 long-double eps.
TEST(Reference, KnowsItsBesselFunctions) {
  const Real tolerance = 100 * std::numeric_limits<Real>::epsilon();
  EXPECT_TRUE(
      close(reference::K0_scaled(1) * std::exp(-1.0L), 0.421024438240708333335627L, tolerance));
  EXPECT_TRUE(
      close(reference::K1_scaled(1) * std::exp(-1.0L), 0.601907230197234574737540L, tolerance));
  EXPECT_TRUE(close(reference::K1_less_pole(1), 0.601907230197234574737540L - 1, tolerance));
  Real i0 = 0, i1 = 0, term = 1;  // (1/4)^k/k!^2
  for (int k = 0; k < 20; term /= 4 * static_cast<Real>(k + 1) * static_cast<Real>(k + 1), ++k) {
    i0 += term;
    i1 += term / 2 / static_cast<Real>(k + 1);
  }
  EXPECT_TRUE(close(reference::N1(1), (i0 - i1) * std::exp(-1.0L), tolerance));
  for (const Real x : {1e-12L, 1e-3L, 0.5L, 1.9L})
    EXPECT_TRUE(close(reference::K0_scaled_fast(x) / reference::K0_scaled(x), 1, tolerance));
}

TEST(Kernels, N1OverTwentyFourDecades) {
  for (const double x : arguments()) {
    const Real expected = reference::N1(x);
    EXPECT_TRUE(close(kernel::N1(x), expected, promised * expected)) << "zeta = " << x;
    EXPECT_EQ(kernel::N1(-x), 0) << "no slope downstream, zeta = " << -x;
  }
  EXPECT_EQ(kernel::N1(0), 0) << "H(0) = 0";
}

TEST(Kernels, N2OverTwentyFourDecades) {
  for (const double x : arguments())
    for (const double zeta : {x, -x}) {
      const Real expected = reference::N2(zeta);
      EXPECT_TRUE(close(kernel::N2(zeta), expected, promised * size_of_N2(zeta, expected)))
          << "zeta = " << zeta;
    }
}

TEST(Kernels, MOverTwentyFourDecades) {
  for (const double x : arguments()) {
    EXPECT_TRUE(close(kernel::M(-x), reference::M(-x), promised * reference::M(-x))) << -x;
    // Upstream M underflows; there it is relative to the Bessel function, its larger factor.
    const Real expected = reference::M(x), larger = reference::K0_scaled_fast(x);
    const Real size = x < 350 ? expected : larger;
    EXPECT_TRUE(close(kernel::M(x), expected, promised * size)) << "zeta = " << x;
  }
  // Below the surface, the exponent r + zeta is good to two roundings, and exp multiplies that by
  // the exponent; where it exceeds 200 that passes the promise, and M is below 1e-86.
  for (int i = -12; i <= 12; ++i)
    for (int j = -12; j <= 12; ++j)
      for (const double sign : {1.0, -1.0}) {
        const double zeta = sign * std::pow(10, i) * 1.234, eta = std::pow(10, j) * 0.777;
        const Real r = std::hypot(static_cast<Real>(zeta), static_cast<Real>(eta));
        const Real decay = zeta < 0 ? static_cast<Real>(eta) * eta / (r - zeta) : r + zeta;
        const Real expected = reference::M(zeta, eta);
        const Real size = decay < 200 ? expected : reference::K0_scaled_fast(r);
        EXPECT_TRUE(close(kernel::M(zeta, eta), expected, promised * size))
            << "zeta = " << zeta << ", eta = " << eta;
      }
}

// K_0(r) e^-zeta as one integral, exp(-zeta - r cosh t) over t > 0, with no scaling at all: the
// exponent's cancellation costs 1e-19 |zeta|, below the promise up to |zeta| = 1e5.
TEST(Kernels, MAgainstQuadrature) {
  for (const double zeta : {-3000.0, -100.0, -3.0, -0.2, -1e-6, 1e-9, 0.03, 0.5, 4.0, 60.0, 200.0})
    for (const double eta : {0.0, 1e-7, 0.02, 0.7, 5.0, 40.0}) {
      const Real z = zeta, r = std::sqrt(z * z + static_cast<Real>(eta) * eta);
      const Real expected = reference::half_line(
          [=](Real t) { return std::exp(-z - r * std::cosh(t)); }, reference::bessel_step(r));
      EXPECT_TRUE(close(kernel::M(zeta, eta), expected, promised * expected))
          << "zeta = " << zeta << ", eta = " << eta;
    }
}

// (1/pi) int_0^2 exp(-u zeta) sqrt(u/(2-u)) du, @eq:laplace.
TEST(Kernels, N1AgainstItsLaplaceIntegral) {
  for (const double zeta :
       {1e-12, 1e-5, 0.01, 0.3, 1.0, 3.0, 10.0, 29.9, 30.0, 40.0, 1e3, 1e6, 1e12}) {
    // Cut at exp(-60) of the scale 1/zeta; only an uncut integral sees the singular end at 2.
    const Real end = std::min(2.0L, 60 / static_cast<Real>(zeta));
    const Real expected = reference::integral(
        [=](Real u, Real right) {
          return std::exp(-u * zeta) * std::sqrt(u / (2 - end + right)) / reference::pi;
        },
        end);
    EXPECT_TRUE(close(kernel::N1(zeta), expected, promised * expected)) << "zeta = " << zeta;
  }
}

// int_0^inf exp(-u x) [1 - sqrt(u/(u+2))] du at zeta = -x, @eq:laplace.
TEST(Kernels, N2AgainstItsLaplaceIntegral) {
  for (const double x :
       {1e-12, 1e-5, 0.01, 0.3, 0.999, 1.0, 3.0, 29.9, 30.0, 40.0, 1e3, 1e6, 1e12}) {
    const auto f = [=](Real u) { return std::exp(-u * x) * 2 / (u + 2 + std::sqrt(u * (u + 2))); };
    // Panels a factor of ten wide resolve both scales, u = 2 and u = 1/x; beyond 60/x is nothing.
    const Real end = 60 / static_cast<Real>(x);
    Real from = std::min(0.1L, end / 1e3L), expected = 0;
    expected += reference::integral([&](Real u, Real) { return f(u); }, from);
    for (; from < end; from *= 10)
      expected += reference::integral([&](Real u, Real) { return f(from + u); }, 9 * from);
    EXPECT_TRUE(close(kernel::N2(-x), expected, promised * expected)) << "zeta = " << -x;
  }
}

// @eq:N1-integral. The integrand is positive and good to 1e-13, so the integral is as well; its
// right side is 1 - e^-x I_0(x) by the mean of exp(x (cos t - 1)), free of any table.
TEST(Kernels, N1HasItsExactIntegral) {
  for (const double x : {1e-6, 0.1, 1.0, 7.0, 30.0, 90.0}) {
    Real sum = reference::integral([](Real z, Real) { return kernel::N1(static_cast<double>(z)); },
                                   std::min(x, 30.0));
    if (x > 30)
      sum += reference::integral(
          [](Real z, Real) { return kernel::N1(static_cast<double>(30 + z)); }, x - 30);
    Real expected = 0;  // the mean of 1 - exp(x (cos t - 1)) over [0, pi]
    for (int i = 0; i < 128; ++i) {
      const Real half_angle = reference::pi * (static_cast<Real>(i) + 0.5L) / 256;
      expected -= std::expm1(-2 * x * std::sin(half_angle) * std::sin(half_angle)) / 128;
    }
    EXPECT_TRUE(close(sum, expected, promised * expected)) << "x = " << x;
  }
}

// @eq:N2-derivative integrated: the integral of N2 over [from, to] on one side of the source is
// the fall of ln|zeta| + e^-zeta K_0(|zeta|), good to 1e-13 of the integral of |N2|.
TEST(Kernels, N2IsADerivative) {
  const auto potential = [](Real zeta) { return std::log(std::abs(zeta)) + reference::M(zeta); };
  const std::vector<double> borders = {1e-9, 1e-3, 0.1, 0.3, 1, 5, 30, 200, 1e4};
  for (std::size_t i = 1; i < borders.size(); ++i)
    for (const double sign : {1.0, -1.0}) {
      const double from = borders[i - 1], to = borders[i];
      Real size = 0;
      const Real sum = reference::integral(
          [&](Real left, Real) {
            const Real value = kernel::N2(sign * static_cast<double>(from + left));
            size = std::max(size, std::abs(value));
            return value;
          },
          to - from);
      const Real expected = sign * (potential(sign * from) - potential(sign * to));
      EXPECT_TRUE(close(sum, expected, promised * size * (to - from)))
          << sign * from << " to " << sign * to;
    }
}

// @eq:N against the numbers the two formulations differ in.
TEST(Kernels, NCarriesTheSignOfTheFormulation) {
  for (const double zeta : {-50.0, -0.4, 1e-3, 0.7, 45.0})
    for (const double friction : {0.1, 0.6}) {
      const Real strain = reference::N2(zeta) / reference::pi,
                 slope = friction * reference::N1(zeta);
      const Real size = promised * (std::abs(strain) + slope);
      EXPECT_TRUE(close(kernel::N(zeta, friction, Formulation::printed), strain - slope, size));
      EXPECT_TRUE(close(kernel::N(zeta, friction, Formulation::corrected), strain + slope, size));
    }
}

// At speed Pe N2 is -1/z and Pe N1 a delta function (@sec:greens): their leading corrections are
// known from @eq:tails, so these limits are checked with a rate.
TEST(Kernels, ApproachTheirLimits) {
  for (const double x : {1e3, 1e6, 1e12}) {
    EXPECT_TRUE(close(x * kernel::N2(x), -1, 4 * epsilon));
    // 1 - sqrt(pi/8x) (1 + O(1/x)), where the next coefficient is -3/8.
    EXPECT_TRUE(close(-x * kernel::N2(-x), -1 + std::sqrt(reference::pi / (8 * x)),
                      std::sqrt(1 / x) / x + 4 * epsilon));
  }
  EXPECT_TRUE(close(kernel::N1(1e-12), 1, 2e-12));  // 1 - 3 zeta/2
}

// Far outside the promised range, from the least normal numbers to near the largest, nothing
// overflows or becomes NaN.
TEST(Kernels, StayFiniteFarOutside) {
  for (const double x : {1e-307, 1e-300, 1e-100, 1e100, 1e300}) {
    EXPECT_GE(kernel::N1(x), 0);
    EXPECT_LE(kernel::N1(x), 1);
    EXPECT_TRUE(std::isfinite(kernel::N2(x)) && std::isfinite(kernel::N2(-x))) << x;
    for (const double zeta : {x, -x})
      for (const double eta : {0.0, 1e-300, 1.0, 1e150}) {
        EXPECT_GE(kernel::M(zeta, eta), 0) << zeta << ' ' << eta;
        EXPECT_LE(kernel::M(zeta, eta), 710) << zeta << ' ' << eta;  // -ln of the least double
      }
  }
}
