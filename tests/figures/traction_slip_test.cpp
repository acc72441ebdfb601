// What Figures "traction", "slip" and "creep" must show, whatever computed them.
#include "curves.hpp"

#include <gtest/gtest.h>

using namespace thermoroll_test;

namespace {

// The published scheme computes with heat. Its surfaces are tilted by at most
// f Pe H int N1* v* p* -> f H max(v* p*), because Pe N1* has unit area; v* p* < 0.29 here.
const double heat_tilt = friction * heating * 0.29;

// It strains them by f Pe H int N* v* p*. Far from its source Pe N2* is -1/z, so that this is at
// most f H (max |int v* p*/(t - s) dt|/pi + f max(v* p*)), where the integral is below 1.05 (at s =
// 1, for Q* = 0.59). The stick zone answers with as much again: twice.
const double heat_strain = 2 * friction * heating * (1.05 / pi + friction * 0.29);

// A function that ends like C sqrt(distance) costs the trapezium rule 0.2079 C h^1.5 at each such
// end (0.2079 = -zeta(-1/2)). Here C = (2f/pi) sqrt(2) at s = 1 and shares of that, which add up
// to it, at s = -1 and at the border.
double trapezium_error(double h) {
  return 2 * 0.2079 * 2 * friction / pi * std::sqrt(2.0) * std::pow(h, 1.5);
}

Curve traction_curve(const std::string& method, const std::string& traction) {
  return curve(data("traction"), {{"method", method}, {"traction", traction}}, "s", "q");
}

Curve slip_curve(const std::string& method, const std::string& traction) {
  return curve(data("slip"), {{"method", method}, {"traction", traction}}, "s", "v");
}

Curve creep_curve(const std::string& method) {
  return curve(data("creep"), {{"method", method}}, "creep", "traction");
}

}  // namespace

TEST(TractionFigure, LiesBetweenZeroAndTheFrictionLimit) {
  for (const std::string& traction : tractions)
    for (const std::string method : {"cold", "corrected", "scheme"}) {
      // With heat the pressure is not quite Hertz's: by the tilt, at most.
      const double slack = method == "cold" ? last_digit : heat_tilt;
      const Curve q = traction_curve(method, traction);
      for (std::size_t i = 0; i < q.x.size(); ++i) {
        EXPECT_GE(q.y[i], -slack) << method << " " << traction << " at " << q.x[i];
        EXPECT_LE(q.y[i], friction * pressure(q.x[i]) + slack)
            << method << " " << traction << " at " << q.x[i];
      }
      EXPECT_LT(largest(q), 0.4) << "the paper's axis";
    }
}

TEST(TractionFigure, ReachesTheFrictionLimitInTheSlipZoneOnly) {
  for (const std::string& traction : tractions) {
    const Curve q = traction_curve("cold", traction);
    for (std::size_t i = 1; i + 1 < q.x.size(); ++i) {
      const double reserve = friction * pressure(q.x[i]) - q.y[i];
      if (q.x[i] > border(std::stod(traction))) {
        EXPECT_NEAR(reserve, 0, last_digit) << traction << " at " << q.x[i];
      } else {
        EXPECT_GT(reserve, last_digit) << traction << " at " << q.x[i];
      }
    }
  }
}

TEST(TractionFigure, AddsUpToTheTangentialForce) {
  for (const std::string& traction : tractions) {
    EXPECT_NEAR(integral(traction_curve("cold", traction)), std::stod(traction),
                trapezium_error(2.0 / 400));
    EXPECT_NEAR(integral(traction_curve("scheme", traction)), std::stod(traction),
                trapezium_error(pi / (nodes + 1)));
  }
}

TEST(TractionFigure, PublishedSchemeIsNearTheClosedForm) {
  for (const std::string& traction : tractions) {
    const Curve q = traction_curve("scheme", traction);
    const double b = half_width_of_stick(std::stod(traction));
    for (std::size_t i = 0; i < q.x.size(); ++i) {
      const double u = std::min((q.x[i] + 1 - b) / b, 1.0);  // 1 in the slip zone
      const double reserve = 2 * friction / pi * b * std::sqrt(1 - u * u);
      EXPECT_NEAR(q.y[i], friction * pressure(q.x[i]) - reserve, heat_strain)
          << traction << " at " << q.x[i];
    }
  }
}

// With either sign heat changes the traction by what it strains, but for a strip between both
// borders, and the drawn change is that against the closed form.
TEST(TractionFigure, HeatChangesLittleAndTheGridSeesLittleOfThat) {
  const Table table = data("traction");
  double seen = 0, changed = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const std::string& method = table.text(row, "method");
    const double s = table.number(row, "s"), change = table.number(row, "change");
    const double load = table.number(row, "traction"), c0 = border(load);
    EXPECT_TRUE(method != "cold" || change == 0) << s;
    if (method == "corrected" || method == "printed") {
      const double cold = table.number(row, "q") - change;
      // The tenth digit of s tells at the edges, where the pressure is steep.
      const double slack = last_digit / std::sqrt(std::max(1 - s * s, last_digit));
      EXPECT_LE(cold, friction * pressure(s) + last_digit + slack);
      EXPECT_GE(cold, -last_digit);
      EXPECT_TRUE(std::abs(s - c0) < 0.02 || std::abs(change) < heat_strain) << s;
    }
    if (load != 0.5 || s < c0 + 0.05) continue;
    if (method == "scheme") seen = std::max(seen, std::abs(change));
    if (method == "printed") changed = std::max(changed, std::abs(change));
  }
  // The nodes are many widths 1/Pe of the kernel apart, and the sum over them has a small part of
  // its integral (a seventh of the load ratio's change, by the table of claims). Were it resolved,
  // the scheme would have all of the change with the same sign; a third is far from either.
  EXPECT_GT(seen, 0);
  EXPECT_LT(seen, changed / 3);
}

TEST(TractionFigure, RisesWithTheTangentialForce) {
  for (std::size_t k = 1; k < tractions.size(); ++k) {
    const Curve lower = traction_curve("cold", tractions[k - 1]);
    const Curve upper = traction_curve("cold", tractions[k]);
    ASSERT_EQ(lower.x, upper.x);
    for (std::size_t i = 0; i < lower.x.size(); ++i)
      EXPECT_LE(lower.y[i], upper.y[i] + last_digit) << tractions[k] << " at " << lower.x[i];
  }
}

TEST(SlipFigure, IsZeroInTheStickZoneAndPositiveInTheSlipZone) {
  for (const std::string& traction : tractions) {
    const Curve v = slip_curve("cold", traction);
    for (std::size_t i = 0; i < v.x.size(); ++i)
      if (v.x[i] > border(std::stod(traction)) + last_digit) {
        EXPECT_GT(v.y[i], 0) << traction << " at " << v.x[i];
      } else {
        EXPECT_EQ(v.y[i], 0) << traction << " at " << v.x[i];
      }
  }
}

TEST(SlipFigure, PublishedSchemeSlipsBehindOneBorder) {
  for (const std::string& traction : tractions) {
    const Curve v = slip_curve("scheme", traction);
    std::size_t first = 0;
    while (first < v.x.size() && v.y[first] == 0) ++first;
    ASSERT_TRUE(0 < first && first < v.x.size());
    for (std::size_t i = first; i < v.x.size(); ++i) EXPECT_GT(v.y[i], 0) << v.x[i];
    // The border is met to within the spacing of the nodes, for heat moves it less than that.
    EXPECT_GT(v.x[first], border(std::stod(traction)) - pi / (nodes + 1));
    EXPECT_LT(v.x[first - 1], border(std::stod(traction)) + pi / (nodes + 1));
  }
}

TEST(SlipFigure, PublishedSchemeIsNearTheClosedForm) {
  for (const std::string& traction : tractions) {
    const Curve v = slip_curve("scheme", traction);
    for (std::size_t i = 0; i < v.x.size(); ++i)
      EXPECT_NEAR(v.y[i], slip(std::stod(traction), v.x[i]), heat_strain)
          << traction << " at " << v.x[i];
  }
}

TEST(SlipFigure, RisesAlongTheContactAndWithTheTangentialForce) {
  for (std::size_t k = 0; k < tractions.size(); ++k) {
    const Curve v = slip_curve("cold", tractions[k]);
    for (std::size_t i = 1; i < v.x.size(); ++i) EXPECT_GE(v.y[i], v.y[i - 1]) << v.x[i];
    EXPECT_LT(largest(v), 0.8) << "the paper's axis";
    if (k == 0) continue;
    // The curves are concave where they rise, so chords lie below: compare at the lower one's
    // points with the upper one's chords, which a step of 1/200 keeps within its square of the
    // curve.
    const Curve lower = slip_curve("cold", tractions[k - 1]);
    for (std::size_t i = 0; i < lower.x.size(); ++i)
      EXPECT_LE(lower.y[i], at(v, lower.x[i]) + 1 / (200.0 * 200.0)) << lower.x[i];
  }
}

// The energy identity: friction does f int v* p* ds = xi* Q*.
TEST(SlipFigure, CarriesTheHeatOfTheEnergyIdentity) {
  for (const std::string& traction : tractions) {
    Curve v = slip_curve("cold", traction);
    double step = 0;  // the widest in the slip zone
    for (std::size_t i = 0; i < v.x.size(); ++i) {
      if (i > 0 && v.y[i] > 0) step = std::max(step, v.x[i] - v.x[i - 1]);
      v.y[i] *= pressure(v.x[i]);
    }
    // The product, too, ends like square roots, with smaller factors than those of q*.
    EXPECT_NEAR(integral(v), heat(std::stod(traction)), trapezium_error(step)) << traction;
  }
}

TEST(CreepFigure, RisesFromZeroEverFlatterToFullSliding) {
  const Curve c = creep_curve("converged");
  ASSERT_GE(c.x.size(), 20u);
  EXPECT_EQ(c.x.front(), 0);
  EXPECT_EQ(c.y.front(), 0);
  double last_slope = pi;  // of the slope dQ*/dxi* = pi b at no creep, b = 1
  for (std::size_t i = 1; i < c.x.size(); ++i) {
    const double slope = (c.y[i] - c.y[i - 1]) / (c.x[i] - c.x[i - 1]);
    // Ten digits of Q* < 1 divided by the step.
    const double rounding = 2 * last_digit / (c.x[i] - c.x[i - 1]);
    EXPECT_GE(slope, -rounding) << c.x[i];
    EXPECT_LE(slope, last_slope + rounding) << c.x[i];
    EXPECT_LE(c.y[i], friction + last_digit) << c.x[i];
    last_slope = slope;
  }
}

TEST(CreepFigure, StartsWithTheSlopePiAndEndsFlat) {
  const Curve c = creep_curve("converged");
  // Between two points the slope is the mean of pi b at both, and b falls by pi/(2f) a unit of
  // creep.
  const double fall = pi * pi / (2 * friction);
  EXPECT_NEAR(c.y[1] / c.x[1], pi - fall * c.x[1] / 2, 1e-6);
  EXPECT_NEAR(c.y.back(), friction, fall * 1e-9);
  EXPECT_GE(c.x.back(), 2 * friction / pi - 1e-9) << "where all of the contact slides";
}

TEST(CreepFigure, PublishedSchemeIsNearTheCurve) {
  const Curve exact = creep_curve("converged"), printed = creep_curve("printed");
  // The strain adds to the creep; the slope of the curve, at most pi, makes a traction of that.
  for (std::size_t i = 0; i < printed.x.size(); ++i)
    EXPECT_NEAR(printed.y[i], at(exact, printed.x[i]), pi * heat_strain) << printed.x[i];
}
