// Temperatures along the surface by graded rules, against the adaptive quadrature of
// @sec:temperature, which knows nothing of graded rules, of the places of their nodes or of
// Legendre coefficients.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "solver/contact_grid.hpp"
#include "solver/surface.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/temperature.hpp"

namespace {

using thermoroll::carter;
using thermoroll::Estimate;
using thermoroll::HeatFlux;
using thermoroll::Peak;
using thermoroll::Quantity;
using thermoroll::SmoothFlux;
using thermoroll::SurfaceCurve;

// Places before, in and behind the slip zone, at all distances from its ends.
Eigen::ArrayXd places(double c0) {
  std::vector<double> s{-3, -1, c0, 1, 1.5, 3, 30};
  for (const double share : {1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.3, 0.5}) {
    const double away = share * (1 - c0);
    s.insert(s.end(), {c0 - away, c0 + away, 1 - away, 1 + away});
  }
  return Eigen::Map<Eigen::ArrayXd>(s.data(), static_cast<Eigen::Index>(s.size()));
}

// The difference is at most what both ways estimate; the position of a point is known to the
// rounding of s, over which T* changes, at its steepest, by about a width of the kernel's layer.
void expect_same(const SurfaceCurve& curve, const HeatFlux& flux, double peclet,
                 const Eigen::ArrayXd& s) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() *
                          std::max(peclet, 1 / (flux.to - flux.from)) *
                          curve.temperature.maxCoeff();
  for (Eigen::Index i = 0; i < s.size(); ++i) {
    const Estimate exact = thermoroll::temperature(flux, peclet, s(i));
    EXPECT_NEAR(curve.temperature(i), exact.value, curve.error + exact.error + rounding)
        << "s = " << s(i) << ", Pe = " << peclet << ", c0 = " << flux.from;
  }
}

const double tractions[] = {6e-5, 0.006, 0.12, 0.3, 0.5, 0.59, 0.59999};

// The error is that of every point, whichever of them are looked at to find it.
TEST(Surface, ErrorCoversThePointsBetween) {
  const auto flux = smooth_flux(carter(0.6, 0.59));
  for (const double peclet : {100.0, 1e6}) {
    Eigen::ArrayXd s = Eigen::ArrayXd::Constant(120, -100);  // every seventh is looked at
    for (Eigen::Index i = 1; i < s.size(); i += 7) s(i) = 0.99;
    const SurfaceCurve x = surface_curve(flux, peclet, s, 1e-6);
    const SurfaceCurve better = surface_curve(flux, peclet, s, 1e-11);
    EXPECT_GT(x.error, 0);
    EXPECT_LE((x.temperature - better.temperature).abs().maxCoeff(), x.error + better.error);
  }
}

TEST(Surface, AgreesWithAdaptiveQuadrature) {
  for (const double traction : tractions)
    for (double peclet = 1e-3; peclet < 2e8; peclet *= 10) {
      const auto c = carter(0.6, traction);
      const Eigen::ArrayXd s = places(c.c0);
      for (const double tolerance : {1e-4, 1e-8, 1e-11}) {
        const SurfaceCurve x = surface_curve(smooth_flux(c), peclet, s, tolerance);
        const Peak top = hottest_point(smooth_flux(c), peclet, tolerance);
        EXPECT_LE(x.error, 1.01 * tolerance * top.temperature.value) << peclet;
        expect_same(x, carter_flux(c), peclet, s);
      }
    }
}

// Most points are not among those on which the number of nodes is tried.
TEST(Surface, ManyPointsHaveTheErrorOfFew) {
  const auto c = carter(0.6, 0.5);
  const Eigen::ArrayXd s = Eigen::ArrayXd::LinSpaced(400, -1, 3);
  for (const double peclet : {1.0, 4360.0, 1e6}) {
    const SurfaceCurve x = surface_curve(smooth_flux(c), peclet, s, 1e-8);
    expect_same(x, carter_flux(c), peclet, s);
  }
}

// Thousands of points are interpolated; each has the temperature that it has alone, to both errors.
// It is negative nowhere. One body of two has no such function before the border.
TEST(Surface, ManyPointsAgreeWithEachPoint) {
  const auto flux = smooth_flux(thermoroll::solve_coupled(
      {0.6, 50, 0.1}, {thermoroll::Formulation::corrected, 1e-8}, {Quantity::traction, 0.5}));
  const Eigen::ArrayXd s = Eigen::ArrayXd::LinSpaced(4000, -1.1, 3);
  thermoroll::Scene pair{0.6, 50, 0.1, {0.5, 0.1, 300}};
  for (const thermoroll::Conduction& by :
       {thermoroll::Conduction(0.3), thermoroll::Conduction(50), thermoroll::Conduction(4360),
        thermoroll::Conduction(1e6), thermoroll::Conduction(pair)})
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
      const SurfaceCurve x = surface_curve(flux, by, s, tolerance);
      EXPECT_GE(x.temperature.minCoeff(), by.pair ? -1e-16 : 0);  // of two bodies, a difference
      EXPECT_LE(x.error, 1.001 * tolerance * x.temperature.maxCoeff());
      for (Eigen::Index i = 0; i < s.size(); i += 13) {
        const SurfaceCurve alone = surface_curve(flux, by, s.segment(i, 1), 1e-11);
        EXPECT_NEAR(x.temperature(i), alone.temperature(0), x.error + alone.error)
            << s(i) << ", Pe " << by.peclet;
      }
    }
}

// The graded rules need not resolve what the solver has not: the error of the flux covers that.
TEST(Surface, CoupledFluxAgreesWithAdaptiveQuadrature) {
  for (const double peclet : {1.0, 100.0, 4360.0})
    for (const double heating : {0.0175, 0.5}) {
      const auto x = thermoroll::solve_coupled({0.6, peclet, heating},
                                               {thermoroll::Formulation::corrected, 1e-6},
                                               {Quantity::traction, 0.5});
      const Eigen::ArrayXd s = places(x.value(Quantity::stick_slip_border));
      SurfaceCurve curve = surface_curve(smooth_flux(x), peclet, s, 1e-8);
      curve.error += x.error(Quantity::max_temperature);
      expect_same(curve, coupled_flux(x), peclet, s);
    }
}

// At the place found the quadrature finds the same temperature. Its own search stops 1e-9 from the
// peak, so that in slip zones not shorter than a hundredth of the contact it finds the same peak.
TEST(Surface, PeakAgreesWithAdaptiveQuadrature) {
  for (const double traction : tractions)
    for (const double peclet : {1e-3, 0.1, 10.0, 1e3, 4360.0, 1e5, 1e8}) {
      const auto c = carter(0.6, traction);
      const HeatFlux flux = carter_flux(c);
      const Peak x = hottest_point(smooth_flux(c), peclet, 1e-9);
      const Estimate there = thermoroll::temperature(flux, peclet, x.at), &top = x.temperature;
      EXPECT_LE(top.error, 1e-9 * top.value);
      EXPECT_NEAR(top.value, there.value, top.error + there.error)
          << traction << ", Pe = " << peclet;
      if (traction < 0.006) continue;
      const Peak y = hottest_point(flux, peclet);
      EXPECT_NEAR(top.value, y.temperature.value, top.error + y.temperature.error)
          << traction << ", Pe = " << peclet;
      EXPECT_NEAR(x.at, y.at, x.at_error + y.at_error) << traction << ", Pe = " << peclet;
    }
}

// The start of the search has no value yet. It is within 0.04 of the hottest point of Carter's flux
// in y and, for lambda >= 1, its curvature within a third of that.
TEST(Surface, HottestPointIsExpectedNearby) {
  for (const double slip : {0.01, 0.3, 0.6, 1.0, 1.4, 1.9, 1.99})
    for (double lambda = 0x1p-10; lambda < 1e8; lambda *= 2) {
      const thermoroll::ZoneLengths zones{slip, 2 - slip};
      const auto start = thermoroll::expected_hottest(zones, lambda / slip);
      const auto top = find_hottest(zones, lambda / slip, carter_h(zones, 0.6), start,
                                    thermoroll::gauss_legendre(64));
      EXPECT_EQ(start.value, 0);
      EXPECT_NEAR(start.y, top.y, 0.04) << "slip zone " << slip << ", lambda = " << lambda;
      if (lambda < 1) continue;
      EXPECT_NEAR(start.curvature / top.curvature, 1, 1.0 / 3);
    }
}

// The place of the peak against that by the most nodes. Two rules may agree in it by accident,
// which must not be taken for an error of zero.
TEST(Surface, PlaceOfThePeakIsWithinItsError) {
  for (const double traction : {0.006, 0.1, 0.3, 0.5, 0.55, 0.59, 0.5999})
    for (double peclet = 1e-3; peclet < 2e8; peclet *= 3) {
      const SmoothFlux flux = smooth_flux(carter(0.6, traction));
      const Peak fine = hottest_point(flux, peclet, 1e-12);
      for (const double tolerance : {1e-6, 1e-8}) {
        const Peak x = hottest_point(flux, peclet, tolerance);
        EXPECT_NEAR(x.at, fine.at, x.at_error + fine.at_error) << traction << ", Pe = " << peclet;
        EXPECT_LT(x.at_error, std::sqrt(tolerance) * flux.slip);
      }
    }
}

// In lengths of the slip zone nothing depends on how short it is: T* per square of its length is
// the same for the same h, the same speed of the zone and the same share of it. Of a short zone the
// share is known from s, as 1 - s is exact, and s of a long one follows from the share to an
// epsilon. What that changes is at most a thousand times as much, by the layer and by the distance
// of the left end.
TEST(Surface, ShortSlipZonesAreAsLongOnes) {
  const Eigen::VectorXd h = thermoroll::carter_h({1, 1}, 0.6);
  const thermoroll::GaussLegendre& rule = thermoroll::gauss_legendre(80);
  const auto temperature_at = [&](double slip, double lambda, double s) {
    const Eigen::ArrayXd at = Eigen::ArrayXd::Constant(1, s);
    return thermoroll::surface_temperature({slip, 2 - slip}, lambda / slip, h, at, rule)(0) /
           (slip * slip);
  };
  for (const double lambda : {0.1, 10.0, 1000.0})
    for (const double share : {0.01, 0.3, 0.7, 0.99}) {
      const double s = 1 - share * 1e-9, exact_share = (1 - s) / 1e-9;
      EXPECT_NEAR(
          temperature_at(1e-9, lambda, s) / temperature_at(0.3, lambda, 1 - exact_share * 0.3), 1,
          1e-12)
          << "lambda = " << lambda << ", share " << share;
    }
}

// What is subtracted at one end of the slip zone is subtracted at the other, mirrored: the distance
// of two points has all its digits next to both.
TEST(Surface, DistancesHaveTheirDigitsAtBothEnds) {
  for (double near = 0.5; near > 1e-15; near /= 8) {
    const thermoroll::SlipPoint a(near, 2 - near), b(2 * near, 2 - 2 * near);
    const thermoroll::SlipPoint c(2 - near, near), d(2 - 2 * near, 2 * near);
    double left = 0, right = 0;
    t_beyond(a, near, b.u, b.v, left);
    t_beyond(d, near, c.u, c.v, right);
    EXPECT_NEAR(right / left, 1, 16 * std::numeric_limits<double>::epsilon()) << near;
  }
}

// Each weight over each distance, whatever the number of nodes leaves of fours. The difference of
// two positions has lost what the distance has not. Across a cluster a step takes two sines, each
// with a few roundings.
TEST(Surface, WeightsAreOverTheDistancesOfAllNodes) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  std::array<thermoroll::SlipVariable, 4> variables;
  variables[1].beta = 2;
  variables[2].clusters[0] = thermoroll::cluster_at(0.3, 0.05);
  variables[3].clusters = {thermoroll::cluster_at(-0.5, 0.1), thermoroll::cluster_at(0.6, 0.2)};
  for (const int n : {5, 6, 7, 8, 30})
    for (const thermoroll::SlipVariable& by : variables) {
      const thermoroll::GaussLegendre& rule = thermoroll::gauss_legendre(n);
      const thermoroll::Nodes z = place_nodes({0.7, 1.3, by}, rule, thermoroll::gauss_legendre(8));
      const Eigen::ArrayXd weight = 1 + rule.rho;
      const Eigen::MatrixXd over = over_distances(z, weight);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
          const double apart = z.s(i) - z.s(j);
          if (i == j) {
            EXPECT_EQ(over(i, j), 0);
          } else {
            const int rounded = by.clusters[0].rate > 0 ? 24 : 8;
            EXPECT_NEAR(over(i, j) * apart / weight(j), 1, rounded * epsilon / std::abs(apart));
          }
        }
    }
}

TEST(Surface, RefusesWhatMakesNoSense) {
  const SmoothFlux flux = smooth_flux(carter(0.6, 0.5));
  const double infinity = std::numeric_limits<double>::infinity();
  const Eigen::ArrayXd zero = Eigen::ArrayXd::Zero(1), far = zero + infinity, nan = far - far;
  EXPECT_THROW(surface_curve(flux, 0, zero, 1e-8), std::invalid_argument);
  EXPECT_THROW(surface_curve(flux, 1, zero, 9e-13), std::invalid_argument);
  EXPECT_THROW(surface_curve(flux, 1, far, 1e-8), std::invalid_argument);
  EXPECT_THROW(surface_curve(flux, 1, nan, 1e-8), std::invalid_argument);
  EXPECT_EQ(surface_curve(flux, 1, Eigen::ArrayXd(0), 1e-8).temperature.size(), 0);
}

}  // namespace
