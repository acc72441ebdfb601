#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "model/kernel_table.hpp"
#include "reference.hpp"
#include "thermoroll/kernels.hpp"

namespace {

using reference::close;
using reference::Real;
using reference::size_of_N2;
using thermoroll::fast_slope_and_strain;
using thermoroll::fast_temperature;
namespace kernel = thermoroll::kernel;

// The promise of kernel_table.hpp.
constexpr Real promised = 1e-13L;

// All decades, both sides of every border of a cell of the tables, and the places between where a
// polynomial errs most.
std::vector<double> arguments() {
  std::vector<double> x = reference::decades();
  for (int octave = -39; octave < 40; ++octave)
    for (int cell = 8; cell < 16; ++cell) {
      const double low = std::ldexp(cell, octave - 3), width = std::ldexp(1, octave - 3);
      for (const double place : {0.0, 0.03, 0.25, 0.5, 0.97}) x.push_back(low + place * width);
      x.push_back(std::nextafter(low, 0));
    }
  return x;
}

}  // namespace

TEST(FastKernels, EqualTheKernels) {
  for (const double x : arguments()) {
    const Real slope = reference::N1(x);
    EXPECT_TRUE(close(fast_slope_and_strain(x).n1, slope, promised * slope)) << "N1, zeta = " << x;
    EXPECT_EQ(fast_slope_and_strain(-x).n1, 0) << "no slope downstream, zeta = " << -x;
    for (const double zeta : {x, -x}) {
      const Real strain = reference::N2(zeta);
      EXPECT_TRUE(
          close(fast_slope_and_strain(zeta).n2, strain, promised * size_of_N2(zeta, strain)))
          << "N2, zeta = " << zeta;
      // A polynomial cannot follow exp(-2 zeta) far upstream, where M is nothing: there it is
      // relative to the Bessel function, which is M at the same distance downstream.
      const Real size = reference::K0_scaled_fast(x);
      EXPECT_TRUE(close(fast_temperature(zeta), zeta < 0 ? size : size * std::exp(-2 * Real(x)),
                        promised * size))
          << "M, zeta = " << zeta;
    }
  }
}

// Beyond the tables the kernels themselves answer, to the last bit.
TEST(FastKernels, AreTheKernelsBeyondTheTables) {
  for (const double x : {1e-300, 1e-100, 1e-20, 0x1p-45, 0x1p+40, 1e13, 1e20, 1e100, 1e300})
    for (const double zeta : {x, -x}) {
      EXPECT_EQ(fast_slope_and_strain(zeta).n1, kernel::N1(zeta)) << zeta;
      EXPECT_EQ(fast_slope_and_strain(zeta).n2, kernel::N2(zeta)) << zeta;
      EXPECT_EQ(fast_temperature(zeta), kernel::M(zeta)) << zeta;
    }
}
