#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "reference.hpp"
#include "studies/comparison.hpp"
#include "studies/graded_panels.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/temperature.hpp"

namespace {

using reference::epsilon;
using thermoroll::CoupledSolution;
using thermoroll::Formulation;
using thermoroll::PanelSolution;
using thermoroll::Quantity;
using thermoroll::Regime;
using thermoroll::Scene;

constexpr double friction = 0.6, traction = 0.5;

/// Relative errors of the thermal change of the load, the largest temperature and the creep, by the
/// coupled solver: the largest of some numbers of nodes, as errors change their signs.
Eigen::Array3d largest_errors(const Scene& scene, Formulation formulation, double tolerance,
                              std::initializer_list<int> nodes) {
  const CoupledSolution exact =
      thermoroll::solve_coupled(scene, {formulation, tolerance}, {Quantity::traction, traction});
  Eigen::Array3d largest = Eigen::Array3d::Zero();
  for (const int n : nodes) {
    const PanelSolution x = thermoroll::solve_on_panels(scene, traction, formulation, n);
    const Eigen::Array3d errors{(x.load_ratio - 1) / (exact.value(Quantity::load_ratio) - 1) - 1,
                                x.hottest / exact.value(Quantity::max_temperature) - 1,
                                x.creep / exact.value(Quantity::creep) - 1};
    EXPECT_TRUE(errors.isFinite().all()) << n;  // which a maximum does not show
    largest = largest.max(errors.abs());
  }
  return largest;
}

}  // namespace

// Both solvers share the equations and the table of the kernels, but no nodes, no quadrature and no
// matrices. Polynomials of degree four on panels err by the fifth power of the panels' lengths;
// five panels, of which two or three are in a layer, are taken to know four digits.
TEST(GradedPanels, AgreeWithTheCoupledSolver) {
  for (const Regime& regime : thermoroll::regimes)
    for (const Formulation formulation : {Formulation::printed, Formulation::corrected})
      for (const int n : {25, 50, 100, 200}) {
        SCOPED_TRACE(::testing::Message() << regime.name << ", n = " << n);
        const Scene scene{friction, regime.peclet, regime.heating};
        const Eigen::Array3d errors = largest_errors(scene, formulation, 1e-10, {n});
        EXPECT_LE(errors.maxCoeff(), 1e-4 * std::pow(25.0 / n, 5));
      }
}

// Without layers every doubling takes away five orders of two, down to what the rule for near
// panels leaves.
TEST(GradedPanels, ErrorFallsFasterThanTheirOrder) {
  for (const double peclet : {0.1, 1.0, 10.0})
    for (const double heating : {0.1, 1.0}) {
      SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", H = " << heating);
      const Scene scene{friction, peclet, heating};
      const auto errors = [&](std::initializer_list<int> nodes) {
        return largest_errors(scene, Formulation::corrected, 1e-11, nodes);
      };
      const Eigen::Array3d coarse = errors({20, 25, 30}), fine = errors({120, 130, 140});
      for (Eigen::Index i = 0; i < 3; ++i)
        EXPECT_LE(fine(i), std::max(coarse(i) * std::pow(30.0 / 120, 5), 2e-11)) << i;
    }
}

// The panels follow the layers, which are Pe^(-1/2) wide in the angles, so that the speed hardly
// matters. The promise is that of the chapter, five digits with fifty nodes, and the fifth order
// from there.
TEST(GradedPanels, LayersAreResolvedAtAnySpeed) {
  for (const double peclet : {1e2, 1e4, 1e6})
    for (const double heating : {0.0175, 0.1}) {
      SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", H = " << heating);
      const Scene scene{friction, peclet, heating};
      EXPECT_LE(largest_errors(scene, Formulation::corrected, 1e-8, {50}).maxCoeff(), 1e-5);
      EXPECT_LE(largest_errors(scene, Formulation::corrected, 1e-8, {100}).maxCoeff(),
                1e-5 * std::pow(0.5, 5));
    }
}

// At H = 0 the border, the load and the creep are Carter's whatever the nodes, to rounding, which
// the small traction magnifies. The temperature is that of his heat, by a quadrature that promises
// 1e-9.
TEST(GradedPanels, CarterWithoutHeat) {
  for (const double share : {0.001, 0.02, 0.5, 0.9, 0.999}) {
    const thermoroll::Carter c = thermoroll::carter(friction, share * friction);
    const double top = thermoroll::hottest_point(thermoroll::carter_flux(c), 100).temperature.value;
    for (const int n : {10, 25, 100}) {
      SCOPED_TRACE(::testing::Message() << "Q/f = " << share << ", n = " << n);
      const PanelSolution x = thermoroll::solve_on_panels({friction, 100, 0}, share * friction,
                                                          Formulation::corrected, n);
      EXPECT_NEAR(x.border, c.c0, 100 * epsilon);
      EXPECT_NEAR(x.load_ratio, 1, 100 * epsilon);
      EXPECT_NEAR(x.creep / c.creep, 1, 100 * epsilon / share);
      EXPECT_NEAR(x.hottest / top, 1, std::max(1e-4 * std::pow(10.0 / n, 5), 2e-9));
    }
  }
}

// The heat of f H = 60 is too much for Newton's method from Carter's heat.
TEST(GradedPanels, WhatDoesNotSettleIsNotANumber) {
  const PanelSolution x =
      thermoroll::solve_on_panels({friction, 100, 100}, traction, Formulation::corrected, 25);
  for (const double value : {x.border, x.load_ratio, x.hottest, x.creep})
    EXPECT_TRUE(std::isnan(value));
}

TEST(GradedPanels, RefuseWhatMakesNoSense) {
  const auto solve = [](const Scene& scene, double pull, int nodes) {
    return thermoroll::solve_on_panels(scene, pull, Formulation::corrected, nodes);
  };
  const Scene scene{friction, 100, 0.0175};
  for (const int nodes : {-5, 0, 5, 12, 24})
    EXPECT_THROW(solve(scene, 0.5, nodes), std::invalid_argument);
  for (const double pull : {0.0, 0.6, 0.7})
    EXPECT_THROW(solve(scene, pull, 25), std::invalid_argument);
  EXPECT_THROW(solve({friction, -1, 0}, 0.5, 25), std::invalid_argument);
}
