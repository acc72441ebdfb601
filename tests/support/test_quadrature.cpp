#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reference.hpp"
#include "thermoroll/quadrature.hpp"

namespace {

using reference::close;
using reference::Real;
using thermoroll::Estimate;
using thermoroll::integrate;

constexpr double promised = 1e-9;  // quadrature.hpp, relative

// The value is within its own error estimate of the truth, and the estimate keeps the promise.
void expect_integral(const Estimate& found, Real exact, const char* what) {
  // The long-double exact value is good to far less than the estimate's least, 1e-14 relative.
  EXPECT_TRUE(close(found.value, exact, found.error)) << what;
  EXPECT_LE(found.error, promised * std::abs(found.value)) << what;
}

}  // namespace

TEST(Quadrature, KnowsTheDifficultPlaces) {
  const Real pi = reference::pi;
  expect_integral(integrate([](double x) { return std::log(x); }, {0, 1}), -1, "a logarithm");
  expect_integral(integrate([](double x) { return 1 / std::sqrt(x); }, {0, 4}), 4, "a root below");
  expect_integral(integrate([](double x) { return std::sqrt((1 - x) * (1 + x)); }, {-1, 1}), pi / 2,
                  "two roots");
  // -ln|x - 0.3| sqrt(x) over [0, 1], cut at its logarithm; by the antiderivative's own quadrature.
  const Real left = reference::integral(
      [](Real from, Real to) { return -std::log(to) * std::sqrt(from); }, static_cast<Real>(0.3));
  const Real right = reference::integral(
      [](Real from, Real) { return -std::log(from) * std::sqrt(static_cast<Real>(0.3) + from); },
      1 - static_cast<Real>(0.3));
  expect_integral(
      integrate([](double x) { return -std::log(std::abs(x - 0.3)) * std::sqrt(x); }, {0, 0.3, 1}),
      left + right, "a logarithm inside");
  // A layer 1e-8 wide whose edge is a point.
  expect_integral(integrate([](double x) { return std::exp(-x / 1e-8); }, {0, 1e-8, 1e-7, 1e-6, 1}),
                  1e-8L, "a layer");
  EXPECT_EQ(integrate([](double) { return 0.0; }, {0, 1}).value, 0);
}

TEST(Quadrature, RefusesWhatItCannotResolve) {
  const std::vector<double> whole{0, 1};
  EXPECT_THROW(integrate([](double x) { return 1 / x; }, whole), std::runtime_error) << "diverges";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(integrate([=](double) { return nan; }, whole), std::runtime_error);
  EXPECT_THROW(integrate([](double x) { return std::sin(1 / (x * x)) / x; }, {1e-4, 1}),
               std::runtime_error)
      << "1e8 oscillations";
  // What is left of the noise, 1e-7, is well above the promise of 1e-9 and well below the value.
  EXPECT_THROW(integrate([](double x) { return 1 + 1e-7 * std::sin(1e9 * x * x); }, whole),
               std::runtime_error);
  try {
    integrate([](double x) { return 1 / (x * x); }, {0, 0.25});
    ADD_FAILURE() << "accepted";
  } catch (const std::runtime_error& refusal) {
    const std::string message = refusal.what();
    EXPECT_NE(message.find("from 0 to 0.25"), std::string::npos) << message;
    EXPECT_NE(message.find("not resolved"), std::string::npos) << message;
  }
}

// Brent's method stops where the parabola's top is flat to rounding: sqrt(eps) = 1.5e-8 of the
// scale over which the function changes by itself, 1 here.
TEST(Quadrature, FindsAMinimum) {
  const double tolerance = 4e-8;
  const auto parabola = [](double x) { return 1 + (x - 0.3) * (x - 0.3); };
  EXPECT_NEAR(thermoroll::minimum(parabola, -1, 0, 1), 0.3, tolerance);
  const auto cosine = [](double x) { return std::cos(x); };
  EXPECT_NEAR(thermoroll::minimum(cosine, 2, 3, 4), static_cast<double>(reference::pi), tolerance);
  const auto kink = [](double x) { return std::abs(x - 0.125); };
  EXPECT_NEAR(thermoroll::minimum(kink, 0, 0.2, 1), 0.125, tolerance);
  EXPECT_THROW(thermoroll::minimum(parabola, 1, 2, 3), std::runtime_error) << "it is at an end";
}
