// Strips of an elliptic contact that slips, against published numbers and a closed limit.
#include <cmath>

#include <gtest/gtest.h>

#include "studies/strips.hpp"

using thermoroll::Cells;
using thermoroll::EllipticContact;
using thermoroll::FrictionLaw;
using thermoroll::on_ellipse;
using thermoroll::OnEllipse;

namespace {

const EllipticContact wheel{5.88e-3, 10.54e-3, 770.41e6, 30, 0.0296, 0.0370, 0.3};

FrictionLaw law(double end) { return thermoroll::piecewise_linear_friction({400, end}); }

}  // namespace

// CONTACT prints four digits; its cells lie elsewhere on the ellipse by up to half a cell, of which
// there are 59, and its temperature is of the order of the root of that: 0.3 % between the strips.
TEST(Strips, AgreeWithThePublishedCases) {
  const Cells its{24, 58.8, 2};
  const OnEllipse falling = on_ellipse(wheel, law(0.4), its),
                  rising = on_ellipse(wheel, law(1.6), its);
  EXPECT_NEAR(falling.force, 0.8660, 3e-3 * 0.8660);
  EXPECT_NEAR(falling.temperature, 137.5, 3e-3 * 137.5);
  EXPECT_NEAR(rising.force, 1.178, 3e-3 * 1.178);
  EXPECT_NEAR(rising.temperature, 208.9, 3e-3 * 208.9);
}

// Hertz's pressure and uniform slip heat the middle to 1.23461983096 f p0 v sqrt(a) / (2 e sqrt V)
// [Ertz and Knothe]. One flux a cell leaves an error of second order in the middle of the contact
// and of order 3/2 at its start, which is cold: four times less for twice the cells.
TEST(Strips, ConvergeToErtzAndKnothe) {
  EllipticContact x = wheel;
  x.slip_ahead = x.slip_behind = 1.0 / 30;
  const double heat = x.friction * x.pressure * x.speed / 30;
  const double exact =
      1.23461983096 * heat * std::sqrt(x.half_length) / (2 * x.effusivity * std::sqrt(x.speed));
  const auto error = [&](double cells) {
    // the middle of the first of very many strips is the middle of the ellipse
    return on_ellipse(x, law(1), {1000, cells, 1}).temperature / exact - 1;
  };
  EXPECT_LT(std::abs(error(50)), 5e-3);
  EXPECT_LT(std::abs(error(200)), 5e-4);
}
