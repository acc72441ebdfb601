#include <cmath>

#include <gtest/gtest.h>

#include "claims.hpp"
#include "first_order.hpp"
#include "printed_scheme.hpp"
#include "reference.hpp"

namespace {

using reference::close;
using reference::Real;

constexpr double friction = 0.6, heating = 0.0175;  // what claims.hpp uses

}  // namespace

// The limit of the scheme has two steps. At a given Pe, n -> infinity leads to the integral
// equation's first order; that tends to the limit of high speed like 1/sqrt(Pe), which is what N1
// has in its tail.
TEST(Claims, FirstOrderEffectIsTheLimitOfTheScheme) {
  const double scale = friction * heating;
  for (const double traction : {0.2, 0.5}) {
    const Real load = thermoroll::first_order_load_change(traction) / scale;
    const Real gamma0 = thermoroll::first_order_gamma0(traction) / scale;
    EXPECT_GT(load, 0);
    EXPECT_LT(gamma0, 0);
    // Extrapolating the root away, from 1e6 and 1e8, leaves the next order, 1/Pe.
    const reference::FirstOrder fast = reference::first_order(traction, 1e6L);
    const reference::FirstOrder faster = reference::first_order(traction, 1e8L);
    EXPECT_LT(fast.load_loss, faster.load_loss);
    EXPECT_TRUE(close((10 * faster.load_loss - fast.load_loss) / 9 / load, 1, 1e-6L)) << traction;
    EXPECT_TRUE(close((10 * faster.gamma0 - fast.gamma0) / 9 / gamma0, 1, 1e-6L)) << traction;
    // At Pe = 100 and n = 400 the kernel is resolved to (h Pe)^2/24 = 0.03 and f H = 0.01 is the
    // next order in H.
    const reference::FirstOrder finite = reference::first_order(traction, 100);
    thermoroll::PrintedOptions options;
    options.nodes = 400;
    const thermoroll::PrintedSolution x = thermoroll::solve_printed(
        {friction, traction, 100, heating}, thermoroll::Formulation::printed, options);
    EXPECT_TRUE(close((1 - x.load_ratio) / scale / finite.load_loss, 1, 0.04)) << traction;
    EXPECT_TRUE(close(x.gamma0 / scale / finite.gamma0, 1, 0.04)) << traction;
  }
  // And by hand for Q* = 0.5: (4f/pi^2) int s sqrt((1+s)(s-c0)) ds, good to rounding and 1e-9.
  const Real b = std::sqrt(1 / 6.0L);
  const auto moment = [&](bool odd) {
    return 4 * friction / (reference::pi * reference::pi) *
           reference::integral(
               [&](Real left, Real right) {
                 return (odd ? 1 - right : 1) * std::sqrt((2 * b + left) * left);
               },
               2 - 2 * b);
  };
  EXPECT_TRUE(close(thermoroll::first_order_load_change(0.5) / (scale * moment(true)), 1, 1e-9));
  EXPECT_TRUE(close(thermoroll::first_order_gamma0(0.5) * reference::pi / (-scale * moment(false)),
                    1, 1e-9));
}

// Rolling concentrates the same heat behind the border. Its maxima at Pe = 1000 are those of the
// table of Temperature.TableOfMaxima; sliding's is the high-speed limit J/sqrt(2 pi Pe) of a
// semi-ellipse with J = 2.1883066738, of which 1/Pe times a factor of about 2 is left.
TEST(Claims, RollingIsHotterThanSliding) {
  const double tractions[] = {0.2, 0.4, 0.5, 0.59};
  const double maxima[] = {0.00097207, 0.00302698, 0.00458990, 0.00697107};
  double previous = INFINITY;
  for (int i = 0; i < 4; ++i) {
    const Real b = std::sqrt(1 - static_cast<Real>(tractions[i]) / friction);
    const Real heat = 2 * friction / reference::pi * (1 - b) * tractions[i] / friction;
    const Real sliding =
        heat * 2 / reference::pi * 2.1883066738L / std::sqrt(2 * reference::pi * 1000);
    const double ratio = thermoroll::rolling_to_sliding(tractions[i]);
    EXPECT_TRUE(close(ratio, maxima[i] / sliding, 3e-3L * ratio)) << "Q* = " << tractions[i];
    EXPECT_GT(ratio, 1) << "hotter";
    EXPECT_LT(ratio, previous) << "and the more so, the smaller the traction";
    previous = ratio;
  }
}

// The wheel on its rail at V = 2 k Pe/a: the converged maxima of Q* = 0.5 in degrees C, to the
// digit.
TEST(Claims, CelsiusFollowTheSpeed) {
  EXPECT_TRUE(close(thermoroll::celsius_at(5000) * 0.00205267, 283.7, 0.05));
  EXPECT_TRUE(close(thermoroll::celsius_at(10000) * 0.00145145, 401.3, 0.05));
  EXPECT_TRUE(close(thermoroll::celsius_at(15000) * 0.00118511, 491.4, 0.05));
}
