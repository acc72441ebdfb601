#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "reference.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/scene.hpp"

namespace {

using reference::close;
using reference::epsilon;
using thermoroll::PhysicalScene;
using thermoroll::Scene;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

// check(data) must throw std::invalid_argument that names the field, its value and the range.
template <class Data>
void expect_refusal(const Data& data, const std::string& name, double value,
                    const std::string& range) {
  try {
    thermoroll::check(data);
    ADD_FAILURE() << name << " = " << value << " was accepted";
  } catch (const std::invalid_argument& refusal) {
    const std::string message = refusal.what();
    const std::string start = name + " = ", finite = std::isfinite(value) ? "" : "finite and ";
    ASSERT_EQ(message.rfind(start, 0), 0u) << message;
    const double shown = std::stod(message.substr(start.size()));
    EXPECT_TRUE(shown == value || (std::isnan(shown) && std::isnan(value))) << message;
    EXPECT_NE(message.find("must be " + finite + range), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
  }
}

}  // namespace

// The numbers of the table, typed again from the paper; then its Pe = 4360 and H = 0.0175 (0.02).
TEST(Scene, PaperDataGiveThePapersGroups) {
  const PhysicalScene c = thermoroll::wheel_on_rail();
  EXPECT_EQ(c.load, 12e6);
  EXPECT_EQ(c.speed, 22.2);
  EXPECT_EQ(c.half_width, 0.0055);
  EXPECT_EQ(c.shear_modulus, 81e9);
  EXPECT_EQ(c.poisson, 0.3);
  EXPECT_EQ(c.expansion, 11e-6);
  EXPECT_EQ(c.diffusivity, 14e-6);
  EXPECT_EQ(c.conductivity, 50);
  const Scene scene = thermoroll::scene_of(c, 0.6);
  EXPECT_EQ(scene.friction, 0.6);
  // 22.2 * 5.5e-3 / 28e-6 = 122.1e3/28, and 2 * 1.1e-5 * 1.3 * 1.4e-5 * 1.2e7 / (5.5e-3 * 50) =
  // 4.8048/275, to one rounding an operation.
  EXPECT_TRUE(close(scene.peclet, 122100.0L / 28, 4 * epsilon * 4361));
  EXPECT_TRUE(close(scene.heating, 4.8048L / 275, 8 * epsilon * 0.0175));
  EXPECT_EQ(std::round(scene.peclet / 10) * 10, 4360) << "the paper's Pe, to its digits";
  EXPECT_EQ(std::round(scene.heating * 1e4), 175);
  EXPECT_EQ(std::round(scene.heating * 1e2), 2) << "the paper's H = 0.02";
}

// Either body has the heating that it would have alone; one that does not conduct has none.
TEST(Scene, EachBodyHasItsHeating) {
  PhysicalScene c = thermoroll::wheel_on_rail(), other = c;
  const Scene alone = thermoroll::scene_of(c, 0.6);
  EXPECT_EQ(alone.roller.conductivity_ratio, 0);
  EXPECT_EQ(alone.roller.heating, 0);
  c.conductivity_2 = other.conductivity = 20;
  c.expansion_2 = other.expansion = 3e-5;
  c.direction = thermoroll::Direction::braking;
  const Scene pair = thermoroll::scene_of(c, 0.6);
  EXPECT_EQ(pair.heating, alone.heating);
  EXPECT_EQ(pair.roller.heating, thermoroll::scene_of(other, 0.6).heating);
  EXPECT_EQ(pair.roller.conductivity_ratio, 0.4);
  EXPECT_EQ(pair.direction, thermoroll::Direction::braking);
  EXPECT_EQ(alone.direction, thermoroll::Direction::driving);
}

// A traction of one, a slip of one, and their heat and temperature, from the definitions; then the
// arithmetic of the paper: T* = 0.002 is 272 degrees C at 25 m/s.
TEST(Scene, TemperatureUnitIsThePapers) {
  PhysicalScene c = thermoroll::wheel_on_rail();
  c.speed = 25;
  const thermoroll::Units units = thermoroll::units_of(c, 0.6);
  const long double p = 1.2e7L / 5.5e-3L, v = 2 * 0.7L * 1.2e7L * 25 / (8.1e10L * 5.5e-3L);
  const long double q = 0.6L * 25 * 2 * 0.7L * 1.2e7L * 1.2e7L / (8.1e10L * 5.5e-3L * 5.5e-3L);
  const long double t = 2 * 0.7L * 0.6L * 25 * 1.2e7L * 1.2e7L / (8.1e10L * 5.5e-3L * 50);
  const double few = 10 * epsilon;  // each is a product of fewer than ten factors
  EXPECT_TRUE(close(units.traction, p, few * p));
  EXPECT_TRUE(close(units.slip, v, few * v));
  EXPECT_TRUE(close(units.heat_flux, q, few * q));
  EXPECT_TRUE(close(units.temperature, t, few * t));
  EXPECT_EQ(std::round(0.002 * units.temperature), 272) << "the paper's, to a degree";
}

TEST(Scene, HertzHalfWidthInvertsTheRadius) {
  // The radius that presses the paper's wheel to its half-width, solved from @eq:kappa by hand.
  const long double radius = reference::pi * 8.1e10L * 5.5e-3L * 5.5e-3L / (4 * 0.7L * 1.2e7L);
  const double a = thermoroll::hertz_half_width(1.2e7, static_cast<double>(radius), 8.1e10, 0.3);
  EXPECT_TRUE(close(a, 5.5e-3L, 4 * epsilon * 5.5e-3));  // the root halves what goes in
  // Half-width and load by Hertz's other formula, p_0 = mu a / (2 (1 - nu) R) = 2 P/(pi a).
  const long double slope = 8.1e10L * a / (2 * 0.7L * radius),
                    mean = 2 * 1.2e7L / (reference::pi * a);
  EXPECT_TRUE(close(slope, mean, 10 * epsilon * mean));
  EXPECT_TRUE(close(thermoroll::hertz_half_width(4e6, 1, 8e10, 0.25) * 2,
                    thermoroll::hertz_half_width(16e6, 1, 8e10, 0.25), 4 * epsilon));
}

TEST(Scene, RefusesWhatMakesNoSense) {
  const Scene good{0.6, 4360, 0.0175};
  PhysicalScene rail = thermoroll::wheel_on_rail();
  rail.expansion_2 = 1e-5;
  rail.conductivity_2 = 30;
  EXPECT_NO_THROW(thermoroll::check(good));
  EXPECT_NO_THROW(thermoroll::check(Scene{0.6, 4360, 0})) << "no heat is allowed";
  EXPECT_NO_THROW(thermoroll::check(rail));

  const auto friction = [&](double x) { return Scene{x, good.peclet, good.heating}; };
  for (const double x : {0.0, -0.6, not_a_number, infinity, -infinity})
    expect_refusal(friction(x), "friction", x, "positive");
  for (const double x : {0.0, -4360.0, not_a_number, infinity, -infinity})
    expect_refusal(Scene{good.friction, x, good.heating}, "peclet", x, "positive");
  const double tiny = std::nextafter(1e-280, 0);  // kernels are not told apart below this speed
  expect_refusal(Scene{good.friction, tiny, good.heating}, "peclet", tiny, "at least 1e-280");
  EXPECT_NO_THROW(thermoroll::check(Scene{good.friction, 1e-280, good.heating}));
  const double huge = std::nextafter(1e306, infinity);  // beyond it 2 Pe and the like overflow
  expect_refusal(Scene{good.friction, huge, good.heating}, "peclet", huge, "at most 1e306");
  EXPECT_NO_THROW(thermoroll::check(Scene{good.friction, 1e306, good.heating}));
  expect_refusal(Scene{1e101, good.peclet, good.heating}, "friction", 1e101, "at most 1e100");
  for (const double x : {-1e-9, not_a_number, infinity, -infinity})
    expect_refusal(Scene{good.friction, good.peclet, x}, "heating", x, "zero or positive");

  struct Field {
    const char* name;
    double PhysicalScene::*value;
    const char* range;
    bool zero_allowed;
  };
  const Field fields[] = {
      {"load", &PhysicalScene::load, "positive", false},
      {"speed", &PhysicalScene::speed, "positive", false},
      {"half-width", &PhysicalScene::half_width, "positive", false},
      {"shear-modulus", &PhysicalScene::shear_modulus, "positive", false},
      {"poisson", &PhysicalScene::poisson, "at least 0 and below 0.5", true},
      {"expansion", &PhysicalScene::expansion, "zero or positive", true},
      {"diffusivity", &PhysicalScene::diffusivity, "positive", false},
      {"conductivity", &PhysicalScene::conductivity, "positive", false},
      {"expansion-2", &PhysicalScene::expansion_2, "zero or positive", true},
      {"conductivity-2", &PhysicalScene::conductivity_2, "zero or positive", true},
  };
  for (const Field& field : fields) {
    PhysicalScene bad = rail;
    for (const double x : {-(rail.*field.value), not_a_number, infinity, -infinity}) {
      bad.*field.value = x;
      expect_refusal(bad, field.name, x, field.range);
    }
    bad.*field.value = 0;
    if (field.zero_allowed)
      EXPECT_NO_THROW(thermoroll::check(bad)) << field.name;
    else
      expect_refusal(bad, field.name, 0, field.range);
  }
  PhysicalScene rubber = rail;
  rubber.poisson = 0.5;
  expect_refusal(rubber, "poisson", 0.5, "at least 0 and below 0.5");
  rubber.poisson = std::nextafter(0.5, 0);
  EXPECT_NO_THROW(thermoroll::check(rubber));
}

// Data of absurd size, each in its range: a unit overflows or vanishes, and the results would.
TEST(Scene, UnitsThatOverflowAreRefused) {
  PhysicalScene si = thermoroll::wheel_on_rail();
  EXPECT_NO_THROW(thermoroll::check(si));
  si.load = 1e160;
  expect_refusal(si, "unit of heat flux 2 (1-nu) P^2 V / (mu a^2)", infinity, "positive");
  si = thermoroll::wheel_on_rail();
  si.conductivity = 1e-305;
  expect_refusal(si, "unit of temperature 2 (1-nu) P^2 V / (mu a K)", infinity, "positive");
  si = thermoroll::wheel_on_rail();
  si.load = 1e-323;
  expect_refusal(si, "unit of slip 2 (1-nu) P V / (mu a)", 0, "positive");
  si.load = 1e300;
  si.half_width = 1e-20;
  expect_refusal(si, "unit of traction P/a", infinity, "positive");
}

// A value just outside its range is refused with enough digits to see why.
TEST(Scene, RefusalShowsWhyTheValueIsOut) {
  const double traction = std::nextafter(0.6, 1);
  try {
    thermoroll::carter(0.6, traction);
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& refusal) {
    const std::string message = refusal.what();
    const std::string start = "traction = ", middle = "friction, ";
    const double shown = std::stod(message.substr(start.size()));
    const double limit = std::stod(message.substr(message.find(middle) + middle.size()));
    EXPECT_GT(shown, limit) << message;
  }
}
