#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "response.hpp"

using response::Patch;
using thermoroll::pi;

namespace {

using Complex = std::complex<double>;

// A smooth flux, and the largest value of its derivative: 16 x (1 - x^2) / 4 at x = 1 / sqrt(3).
const Patch bump{-1, 1, [](double x) { return (1 - x * x) * (1 - x * x); }};
const double steepest = 8 / std::sqrt(27.0);

}  // namespace

// The transforms of the chapter, turned back by the integral over w and compared with the kernels,
// for a flux exp(-x^2/2) with the transform sqrt(2 pi) exp(-w^2/2). Both integrals are cut where
// their Gaussian is below 1e-17, and integrate() promises each to 1e-9 of its value; none of these
// values exceeds 2.
TEST(KernelsDerived, SymbolsInvertToTheKernels) {
  const double end = 9;
  const Patch gaussian{-end, end, [](double x) { return std::exp(-x * x / 2); }};
  for (const double peclet : {0.5, 2.0, 6.0})
    for (const double x : {-1.5, -0.5, 0.25, 1.0}) {
      const auto inverse = [&](auto symbol) {
        const auto integrand = [&](double w) {
          const Complex m = std::sqrt(Complex(w * w, 2 * w * peclet));
          const double flux = std::sqrt(2 * pi) * std::exp(-w * w / 2);
          return std::real(symbol(w, m) * flux * std::polar(1.0, w * x)) / pi;  // w > 0 twice
        };
        return thermoroll::integrate(integrand, {0, end}).value;
      };
      const auto heat = [](double, Complex m) { return 1.0 / m; };
      const auto slope = [&](double w, Complex m) { return (1.0 - w / m) / peclet; };
      const auto strain = [&](double w, Complex m) { return Complex(0, -1) * slope(w, m); };
      const double tolerance = 4e-9;
      EXPECT_NEAR(inverse(heat), response::temperature(peclet, gaussian, x), tolerance);
      EXPECT_NEAR(inverse(slope), response::outward_slope(peclet, gaussian, x), tolerance);
      EXPECT_NEAR(inverse(strain), response::strain(peclet, gaussian, x), tolerance);
    }
}

// V -> 0: the slope is the flux still ahead, downstream, so that its derivative is -phi; and the
// strain is the thermal one up to a constant, -1 in the kernel. N1 = 1 - 3/2 zeta + ... and
// N2 - M = -1 + O(zeta ln zeta) with |zeta| < 2 Pe; 100 Pe covers both.
TEST(KernelsDerived, LowSpeedIsDundursTheorem) {
  const double peclet = 1e-7, heat = 16.0 / 15;
  for (const double x : {-0.7, -0.2, 0.0, 0.4}) {
    const double ahead = thermoroll::integrate(bump, {x, 1}).value;
    EXPECT_NEAR(response::outward_slope(peclet, bump, x), ahead, 100 * peclet);
    const double difference =
        response::strain(peclet, bump, x) - response::temperature(peclet, bump, x);
    EXPECT_NEAR(difference, -heat / pi, 100 * peclet);
  }
}

// V -> infinity: Pe times the slope is the flux at the same place. Integrating by parts with the
// exact integral of N1, the difference is the integral of phi'(x + z) exp(-Pe z) I0(Pe z) over z >
// 0, and exp(-y) I0(y) < 1 / sqrt(y): at most steepest times 2 sqrt(2 / Pe) on a patch of length 2.
TEST(KernelsDerived, HighSpeedIsLocal) {
  const double peclet = 1e6;
  for (const double x : {-0.7, -0.2, 0.0, 0.4}) {
    const auto ahead = [&](double t) { return thermoroll::kernel::N1(peclet * (t - x)) * bump(t); };
    const double slope = thermoroll::integrate(ahead, {x, x + 10 / peclet, x + 1e-2, 1}).value;
    EXPECT_NEAR(peclet * slope, bump(x), steepest * 2 * std::sqrt(2 / peclet));
  }
}
