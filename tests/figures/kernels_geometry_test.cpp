// What Figures "kernels" and "geometry" must show, whatever computed them.
#include "curves.hpp"

#include <gtest/gtest.h>

using namespace thermoroll_test;

// M(zeta) = K0(|zeta|) exp(-zeta), so both sides of the source have the same K0.
TEST(KernelsFigure, TemperatureDecaysBySymmetryTimesAnExponential) {
  const Curve m = curve(data("kernels"), {}, "zeta", "M");
  for (std::size_t i = 0, j = m.x.size() - 1; i < j; ++i, --j) {
    ASSERT_NEAR(m.x[i], -m.x[j], last_digit * m.x[j]);
    const double k0 = m.y[i] * std::exp(m.x[i]);
    EXPECT_NEAR(m.y[j] * std::exp(m.x[j]), k0, 4 * last_digit * k0) << m.x[j];
  }
}

// exp(zeta) (N2 + 1/zeta) = K0 + K1 upstream and K0 - K1 downstream: together twice K0.
TEST(KernelsFigure, StrainOfBothSidesAddsUpToTheTemperature) {
  const Table table = data("kernels");
  const Curve n2 = curve(table, {}, "zeta", "N2"), m = curve(table, {}, "zeta", "M");
  for (std::size_t i = 0, j = n2.x.size() - 1; i < j; ++i, --j) {
    const double x = n2.x[j];
    const double up = std::exp(x) * (n2.y[j] + 1 / x), down = std::exp(-x) * (n2.y[i] - 1 / x);
    const double twice_k0 = 2 * std::exp(x) * m.y[j];
    // Last digits of the largest terms.
    EXPECT_NEAR(up + down, twice_k0,
                4 * last_digit * (std::exp(x) * (std::abs(n2.y[j]) + 1 / x) + twice_k0))
        << x;
  }
}

TEST(KernelsFigure, SlopeActsUpstreamOnlyAndFallsFromOne) {
  const Curve n1 = curve(data("kernels"), {}, "zeta", "N1");
  double last = 1;
  for (std::size_t i = 0; i < n1.x.size(); ++i)
    if (n1.x[i] < 0) {
      EXPECT_EQ(n1.y[i], 0) << n1.x[i];
    } else {
      EXPECT_GT(n1.y[i], 0) << n1.x[i];
      EXPECT_LT(n1.y[i], last) << n1.x[i];
      last = n1.y[i];
    }
}

TEST(KernelsFigure, StrainChangesItsSignOnce) {
  const Curve n2 = curve(data("kernels"), {}, "zeta", "N2");
  int changes = 0;
  for (std::size_t i = 1; i < n2.x.size(); ++i) changes += (n2.y[i] > 0) != (n2.y[i - 1] > 0);
  EXPECT_EQ(changes, 1);
  EXPECT_GT(n2.y.front(), 0);
}

TEST(GeometryFigure, CylinderIsACircleThatEndsWhereTheContactDoes) {
  const Table table = data("geometry");
  double top = 0;
  std::vector<std::pair<double, double>> outline;
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (table.text(row, "part") == "cylinder") {
      outline.emplace_back(table.number(row, "x"), table.number(row, "y"));
      top = std::max(top, outline.back().second);
    }
  ASSERT_GT(outline.size(), 60u) << "round to the eye";
  EXPECT_NEAR(outline.front().first, 1, last_digit);
  EXPECT_NEAR(outline.back().first, -1, last_digit);
  const double radius = (top * top + 1) / (2 * top);
  for (const auto& [x, y] : outline)
    EXPECT_NEAR(std::hypot(x, y - (top - radius)), radius, 4 * last_digit * radius);
}

TEST(GeometryFigure, ZonesAreThoseOfTheTractionOneHalf) {
  const Table table = data("geometry");
  const Curve stick = curve(table, {{"part", "stick"}}, "x", "y");
  const Curve slip_zone = curve(table, {{"part", "slip"}}, "x", "y");
  EXPECT_EQ(stick.x.front(), -1);
  EXPECT_EQ(stick.x.back(), slip_zone.x.front());
  EXPECT_EQ(slip_zone.x.back(), 1);
  EXPECT_NEAR(stick.x.back(), border(0.5), last_digit);
}
