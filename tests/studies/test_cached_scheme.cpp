#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "driven.hpp"
#include "reference.hpp"
#include "studies/cached_scheme.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"

namespace {

using reference::close;
using reference::epsilon;
using thermoroll::CoupledSolution;
using thermoroll::Formulation;
using thermoroll::NodeKernel;
using thermoroll::PublishedOptions;
using thermoroll::PublishedSolution;
using thermoroll::Quantity;

constexpr double friction = 0.6;

PublishedSolution with_means(const Driven& scene, int nodes,
                             Formulation formulation = Formulation::corrected) {
  PublishedOptions options;
  options.nodes = nodes;
  return thermoroll::solve_cached(scene, scene.traction, formulation, NodeKernel::mean, options);
}

}  // namespace

// The same equations, steps and stopping rule. Only the kernels come from tables, to 1e-13 of their
// size; that is 1e-13 of the thermal terms, which are below one here, and the systems make up to n
// times as much of it. The step counts must be the same.
TEST(CachedScheme, FindsWhatThePublishedSchemeFinds) {
  for (const Driven& scene : {Driven{friction, 0.5, 1, 0.3}, Driven{friction, 0.2, 100, 0.0175},
                              Driven{friction, 0.5, 100, 1}, Driven{0.3, 0.25, 4360, 0.0175},
                              Driven{friction, 0.59, 20000, 0.1}, Driven{friction, 0.5, 100, 0}})
    for (const Formulation formulation : {Formulation::printed, Formulation::corrected})
      for (const int n : {3, 25, 60}) {
        SCOPED_TRACE(::testing::Message() << "Pe = " << scene.peclet << ", n = " << n);
        PublishedOptions options;
        options.nodes = n;
        const PublishedSolution x = solve_published(scene, formulation, options);
        const PublishedSolution y = thermoroll::solve_cached(scene, scene.traction, formulation,
                                                             NodeKernel::sample, options);
        ASSERT_TRUE(x.converged);
        EXPECT_TRUE(y.converged);
        EXPECT_EQ(y.outer_iterations, x.outer_iterations);
        EXPECT_EQ(y.inner_iterations, x.inner_iterations);
        const double rounding = 1e-13 * n;
        EXPECT_TRUE(close(y.c0, x.c0, rounding));
        EXPECT_TRUE(close(y.load_ratio, x.load_ratio, rounding));
        EXPECT_TRUE(close(y.gamma0, x.gamma0, rounding));
        EXPECT_TRUE(close(y.creep, x.creep, rounding));
        EXPECT_TRUE(close(y.creep_constant, x.creep_constant, rounding));
        EXPECT_TRUE(close(
            thermoroll::cached_max_temperature(y, scene.peclet, NodeKernel::sample).temperature,
            thermoroll::published_max_temperature(x, scene.peclet).temperature, rounding));
        for (Eigen::Index k = 0; k < n; ++k) {
          // At the ends the weights vanish like sin^2, so the factors know less there.
          const double sine = std::sqrt(1 - x.grid.t(k) * x.grid.t(k));
          EXPECT_TRUE(close(y.slip(k), x.slip(k), rounding)) << k;
          EXPECT_TRUE(close(y.phi(k), x.phi(k), rounding / sine)) << k;
          EXPECT_TRUE(close(y.phi0(k), x.phi0(k), rounding / sine)) << k;
        }
      }
}

// Heat that is piecewise linear between nodes pi/n apart errs by their square, but for its
// square-root start at the border: the order is at least 3/2, at any speed. The factor before it
// depends on where between two nodes the border lies, so the largest error of a few n is taken.
TEST(CachedScheme, MeansConvergeAtAnySpeed) {
  for (const double peclet : {10.0, 100.0, 4360.0, 1e5})
    for (const Formulation formulation : {Formulation::printed, Formulation::corrected}) {
      SCOPED_TRACE(::testing::Message() << "Pe = " << peclet);
      const Driven scene{friction, 0.5, peclet, 0.1};
      const CoupledSolution exact =
          thermoroll::solve_coupled(scene, {formulation, 1e-9}, {Quantity::traction, 0.5});
      const auto largest = [&](std::initializer_list<int> nodes) {
        Eigen::Array3d errors = Eigen::Array3d::Zero();
        for (const int n : nodes) {
          const PublishedSolution x = with_means(scene, n, formulation);
          EXPECT_TRUE(x.converged);
          const double top =
              thermoroll::cached_max_temperature(x, peclet, NodeKernel::mean).temperature;
          const Eigen::Array3d of_n{
              (x.load_ratio - 1) / (exact.value(Quantity::load_ratio) - 1) - 1,
              top / exact.value(Quantity::max_temperature) - 1,
              x.creep / exact.value(Quantity::creep) - 1};
          EXPECT_TRUE(of_n.isFinite().all()) << n;  // which a maximum does not show
          errors = errors.max(of_n.abs());
        }
        return errors;
      };
      const Eigen::Array3d coarse = largest({17, 18, 19, 20, 21, 22}), fine = largest({320, 331});
      for (Eigen::Index i = 0; i < 3; ++i) {
        // What 3/2 orders leave of the coarse error, or the stopping rule's 1e-6, which the small
        // thermal change of the load magnifies tenfold.
        EXPECT_LE(fine(i), std::max(coarse(i) * std::pow(22.0 / 320, 1.5), 1e-5)) << i;
        EXPECT_LE(fine(i), 3e-4) << i;
      }
    }
}

// Where the kernel is wide and the heat smooth across a hat, mean and sample agree to the square of
// the hat's width, Pe h << 1.
TEST(CachedScheme, MeansAreSamplesWhereTheKernelIsWide) {
  const Driven scene{friction, 0.5, 0.1, 0.5};
  PublishedOptions options;
  options.nodes = 100;
  const PublishedSolution x = with_means(scene, 100);
  const PublishedSolution y = thermoroll::solve_cached(
      scene, scene.traction, Formulation::corrected, NodeKernel::sample, options);
  // The step of N1 at zero leaves half a node's share of a thermal term of size f Pe H.
  const double step = friction * scene.peclet * scene.heating * thermoroll::pi / 100;
  EXPECT_TRUE(close(x.load_ratio, y.load_ratio, step));
  EXPECT_TRUE(close(x.gamma0, y.gamma0, step));
  EXPECT_GT(std::abs(y.gamma0), 2 * step) << "so that this says something";
}

// At H = 0 nothing is left of the kernels.
TEST(CachedScheme, WithoutHeatMeansChangeNothing) {
  for (const int n : {3, 40}) {
    const thermoroll::Carter c = thermoroll::carter(friction, 0.5);
    const PublishedSolution x = with_means({friction, 0.5, 1000, 0}, n);
    EXPECT_TRUE(close(x.load_ratio, 1, 10 * n * epsilon));
    EXPECT_TRUE(close(x.c0, c.c0, 10 * n * epsilon));
    EXPECT_TRUE(close(x.creep, c.creep, 10 * n * epsilon));
  }
}

TEST(CachedScheme, RefusesWhatMakesNoSense) {
  const Driven scene{friction, 0.5, 100, 0.0175};
  PublishedOptions options;
  options.nodes = 2;
  EXPECT_THROW(thermoroll::solve_cached(scene, scene.traction, Formulation::corrected,
                                        NodeKernel::mean, options),
               std::invalid_argument);
  options = {};
  options.heaviside_at_zero = 0.5;
  EXPECT_THROW(thermoroll::solve_cached(scene, scene.traction, Formulation::corrected,
                                        NodeKernel::sample, options),
               std::invalid_argument);
  EXPECT_THROW(with_means({friction, 0.7, 100, 0.0175}, 50), std::invalid_argument);
}
