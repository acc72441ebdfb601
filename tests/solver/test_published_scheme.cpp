#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "driven.hpp"
#include "first_order.hpp"
#include "reference.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/published_scheme.hpp"

namespace {

using Eigen::Index;
using reference::close;
using reference::epsilon;
using reference::first_order;
using reference::FirstOrder;
using reference::Real;
using thermoroll::Carter;
using thermoroll::Direction;
using thermoroll::Formulation;
using thermoroll::Grid;
using thermoroll::PublishedOptions;
using thermoroll::PublishedSolution;

constexpr double friction = 0.6;  // of every figure of the paper

double sign_of(Formulation formulation) { return formulation == Formulation::printed ? 1 : -1; }

PublishedSolution solve(double traction, double peclet, double heating, int nodes,
                        Formulation formulation = Formulation::printed, double tolerance = 1e-6) {
  PublishedOptions options;
  options.nodes = nodes;
  options.tolerance = tolerance;
  return solve_published({friction, traction, peclet, heating}, formulation, options);
}

}  // namespace

// @eq:nodes; cos loses at most eps, so do the products of the weights.
TEST(PublishedScheme, GridInterlacesNodesAndPoints) {
  for (const int n : {1, 2, 7, 50, 200}) {
    const Grid g = thermoroll::gauss_chebyshev(n);
    ASSERT_EQ(g.t.size(), n);
    ASSERT_EQ(g.w.size(), n);
    ASSERT_EQ(g.s.size(), n + 1);
    for (Index k = 0; k < n; ++k) {
      const Real angle = static_cast<Real>(k + 1) * reference::pi / (n + 1);
      EXPECT_TRUE(close(g.t(k), std::cos(angle), 4 * epsilon));
      EXPECT_TRUE(close(g.w(k), reference::pi / (n + 1) * std::sin(angle) * std::sin(angle),
                        8 * epsilon * reference::pi / (n + 1)));
      EXPECT_GT(g.s(k), g.t(k));
      EXPECT_LT(g.s(k + 1), g.t(k));
    }
    for (Index m = 0; m <= n; ++m) {
      const Real angle = (2 * static_cast<Real>(m) + 1) * reference::pi / (2 * (n + 1));
      EXPECT_TRUE(close(g.s(m), std::cos(angle), 4 * epsilon));
    }
    EXPECT_TRUE(close(g.w.sum(), reference::pi / 2, 8 * epsilon));  // int sqrt(1-t^2) dt
  }
}

// (1/pi) PV int sqrt(1-t^2) U_j(t)/(t-s) dt = -T_{j+1}(s). The rule divides [U_j(t)-U_j(s)]/(t-s),
// of degree j - 1, so it is exact up to j = 2n: beyond the n nodes' own polynomials.
TEST(PublishedScheme, CauchyMatrixIsExactForPolynomials) {
  for (const int n : {1, 4, 33, 120}) {
    const Grid g = thermoroll::gauss_chebyshev(n);
    const Eigen::MatrixXd cauchy = thermoroll::cauchy_matrix(g);
    ASSERT_EQ(cauchy.rows(), n + 1);
    ASSERT_EQ(cauchy.cols(), n);
    const auto error = [&](int j) {
      Eigen::VectorXd u(n);
      for (Index k = 0; k < n; ++k) {
        const Real angle = std::acos(static_cast<Real>(g.t(k)));
        u(k) = static_cast<double>(std::sin((j + 1) * angle) / std::sin(angle));
      }
      Real largest = 0;
      const Eigen::VectorXd found = cauchy * u;
      for (Index m = 0; m <= n; ++m) {
        const Real angle = std::acos(static_cast<Real>(g.s(m)));
        const Real off = std::abs(found(m) + std::cos((j + 1) * angle));
        if (!(off <= largest)) largest = off;  // a NaN stays
      }
      return largest;
    };
    // The nodes are rounded to eps. That changes w U_j/(t-s) by eps times its derivative, of which
    // both 1/(t-s) and U_j take up to a factor (j + n)/sin, summed over n terms of weight
    // sin^2 pi/(n+1) and 1/(t-s) summing to n in all.
    for (int j = 0; j <= 2 * n; ++j)
      EXPECT_TRUE(close(error(j), 0, 4 * epsilon * n * (j + n))) << "n = " << n << ", j = " << j;
    EXPECT_GT(error(2 * n + 1), 0.5) << "and no further, n = " << n;
  }
}

// At H = 0 the unknowns are constants: phi = 2/pi, phi0 = -(2f/pi) b. The systems' condition grows
// like n, so everything is good to a few n eps.
TEST(PublishedScheme, WithoutHeatItIsTheClosedForm) {
  for (const double traction : {0.01, 0.2, 0.5, 0.59})
    for (const int n : {3, 20, 101}) {
      SCOPED_TRACE(::testing::Message() << "Q* = " << traction << ", n = " << n);
      const Carter c = thermoroll::carter(friction, traction);
      const PublishedSolution x = solve(traction, 1000, 0, n);
      const double rounding = 10 * n * epsilon;
      EXPECT_TRUE(x.converged);
      // One step, and one to see that it was the last; a grid without a node in the slip zone has
      // nothing to change.
      EXPECT_EQ(x.outer_iterations, x.grid.t(0) > x.c0 ? 2 : 1);
      EXPECT_EQ(x.inner_iterations, 1) << "it starts at the closed form's border";
      EXPECT_TRUE(close(x.load_ratio, 1, rounding));
      EXPECT_TRUE(close(x.gamma0, 0, rounding));
      EXPECT_TRUE(close(x.c0, c.c0, rounding));
      EXPECT_TRUE(close(x.creep_constant, c.creep, rounding));
      EXPECT_TRUE(close(x.creep, c.creep, rounding));
      for (Index k = 0; k < n; ++k) {
        // At the ends the weights vanish like sin^2, so the factors know less there.
        const double sine = std::sqrt(1 - x.grid.t(k) * x.grid.t(k));
        EXPECT_TRUE(close(x.phi(k), 2 / reference::pi, rounding / sine)) << "k = " << k;
        EXPECT_TRUE(close(x.phi0(k), -2 * friction / reference::pi * c.b, rounding / sine));
      }
      // Pressure and traction anywhere; dividing by the sine is undone by the square root.
      for (const double s : {-0.999, -0.8, -0.31, 0.0, 0.123, 0.5, 0.77, 0.9995}) {
        EXPECT_TRUE(
            close(thermoroll::published_pressure(x, s), thermoroll::hertz_pressure(s), rounding))
            << s;
        EXPECT_TRUE(close(thermoroll::published_traction(x, friction, s),
                          thermoroll::carter_traction(c, s), 2 * rounding))
            << s;
      }
      for (Index k = 0; k < n; ++k)  // at its nodes, where the interpolation has poles
        EXPECT_TRUE(close(thermoroll::published_pressure(x, x.grid.t(k)),
                          thermoroll::hertz_pressure(x.grid.t(k)), rounding));
      for (const double s : {-1.0, 1.0, 1.5, -2.0}) {
        EXPECT_EQ(thermoroll::published_pressure(x, s), 0);
        EXPECT_EQ(thermoroll::published_traction(x, friction, s), 0);
      }
      // The slip at the nodes. Outside the stick zone, at tau = (rho + 1/rho)/2 > 1, the rule gives
      // (1/pi) sum w/(t-tau) = -1/rho + rho^-(n+1)/U_n(tau) exactly, the integral being -1/rho.
      for (Index k = 0; k < n; ++k) {
        const double s = x.grid.t(k);
        if (s <= x.c0) {
          EXPECT_EQ(x.slip(k), 0) << "it sticks at s = " << s;
          continue;
        }
        const Real tau = 1 + (static_cast<Real>(s) - x.c0) / c.b,
                   root = std::sqrt((tau - 1) * (tau + 1));
        const Real rho = tau + root;
        const Real unresolved = 2 * root / (std::pow(rho, 2 * n + 2) - 1);
        const Real stuck = 2 * friction / reference::pi * c.b;  // -phi0
        const Real slip =
            c.creep + 2 * friction / reference::pi * s - stuck / rho + stuck * unresolved;
        // As the error of phi0 has a factor w in the sum, its 1/sin is harmless; the border's own
        // rounding moves the slip by its vertical tangent there.
        const Real edge = rounding * (1 + 1 / std::sqrt(s - x.c0));
        EXPECT_TRUE(close(x.slip(k), slip, edge)) << "s = " << s;
        if (unresolved < 1e-16L) {
          EXPECT_TRUE(close(x.slip(k), thermoroll::carter_slip(c, s), edge)) << "s = " << s;
        }
      }
    }
}

// Its own equations, typed once more from the paper with kernels that share nothing with src/.
TEST(PublishedScheme, SatisfiesItsOwnEquations) {
  struct Case {
    double traction, peclet, heating, self;
    int nodes;
  };
  for (const Case& k :
       {Case{0.5, 4360, 0.0175, 0, 40}, Case{0.3, 100, 0.5, 0, 31}, Case{0.5, 20, 0.2, 0.5, 25}})
    for (const Formulation formulation : {Formulation::printed, Formulation::corrected}) {
      PublishedOptions options;
      options.nodes = k.nodes;
      options.tolerance = 1e-12;
      options.heaviside_at_zero = k.self;
      const PublishedSolution x =
          solve_published({friction, k.traction, k.peclet, k.heating}, formulation, options);
      ASSERT_TRUE(x.converged);
      SCOPED_TRACE(::testing::Message() << "Pe = " << k.peclet << ", H = " << k.heating);
      const Real eps_sign = sign_of(formulation), f = friction, thermal = f * k.peclet * k.heating;
      const Real a0 = (1 + static_cast<Real>(x.c0)) / 2, b0 = (1 - static_cast<Real>(x.c0)) / 2;
      const Index n = x.grid.t.size();
      std::vector<Real> g(static_cast<std::size_t>(n));
      Real load = 0, shear = 0;
      for (Index j = 0; j < n; ++j) {
        const Real w = x.grid.w(j);
        g[static_cast<std::size_t>(j)] = x.grid.t(j) > x.c0 ? w * x.slip(j) * x.phi(j) : 0;
        load += w * x.phi(j);
        shear += w * x.phi0(j);
        EXPECT_TRUE(close(thermoroll::node_heat(x)(j), g[static_cast<std::size_t>(j)],
                          4 * epsilon * static_cast<Real>(w)));
      }
      // What heat does at s, and the sum of its terms' sizes; H(0) and N2(0) as chosen.
      const auto heat = [&](Real s, bool stick, Real& size) {
        Real sum = 0;
        for (Index j = 0; j < n; ++j) {
          const Real z = k.peclet * (x.grid.t(j) - s), share = g[static_cast<std::size_t>(j)];
          if (share == 0) continue;
          const Real slope = z == 0 ? k.self : reference::N1(z);
          const Real strain = !stick || z == 0 ? 0 : reference::N2(z) / reference::pi;
          sum += share * (stick ? strain - eps_sign * f * slope : slope);
          size += thermal * std::abs(share) * (std::abs(strain) + slope);
        }
        return sum;
      };
      const auto cauchy = [&](const Eigen::VectorXd& factor, Real s, Real& size) {
        Real sum = 0;
        for (Index j = 0; j < n; ++j) {
          const Real term =
              x.grid.w(j) * static_cast<Real>(factor(j)) / (x.grid.t(j) - s) / reference::pi;
          sum += term;
          size += std::abs(term);
        }
        return sum;
      };
      // Elimination leaves a residual of n eps times the sizes of the terms; the iteration stops
      // with v* known to its tolerance, so that the thermal terms are off by as much.
      const auto rounding = [&](Real size) {
        return (static_cast<Real>(n) * epsilon + options.tolerance) * size;
      };
      EXPECT_TRUE(close(load, 1, rounding(1)));
      EXPECT_TRUE(close(a0 * shear, k.traction - f, 2 * options.tolerance));
      for (Index m = 0; m <= n; ++m) {
        const Real s = x.grid.s(m), mapped = a0 * s - b0;
        Real size = 1;
        const Real normal = x.gamma0 + cauchy(x.phi, s, size) +
                            eps_sign * thermal * heat(s, false, size) +
                            2 / reference::pi * x.load_ratio * s;
        EXPECT_TRUE(close(normal, 0, rounding(size))) << "(39) at s = " << x.grid.s(m);
        size = 1;
        const Real stick = -x.creep_constant + cauchy(x.phi0, s, size) +
                           thermal * heat(mapped, true, size) -
                           2 * f / reference::pi * x.load_ratio * mapped;
        EXPECT_TRUE(close(stick, 0, rounding(size))) << "(41) at s = " << x.grid.s(m);
      }
      for (Index j = 0; j < n && x.grid.t(j) > x.c0; ++j) {
        const Real s = x.grid.t(j);
        Real size = 1;
        const Real slip = x.creep_constant + 2 * f / reference::pi * x.load_ratio * s -
                          cauchy(x.phi0, (s + b0) / a0, size) - thermal * heat(s, true, size);
        EXPECT_TRUE(close(x.slip(j), slip, rounding(size))) << "(36) at s = " << x.grid.t(j);
      }
      EXPECT_TRUE(close(x.creep, x.creep_constant - f * x.gamma0, 4 * epsilon));
    }
}

// Two sums over the collocation points remove the pressure from (39): sum_m 1/(t_k - s_m) = 0 and
// sum_m s_m/(t_k - s_m) = -(n+1). So gamma0 and kappa follow from the heat without any elimination.
TEST(PublishedScheme, LoadRatioAndGammaBalanceTheHeat) {
  for (const Formulation formulation : {Formulation::printed, Formulation::corrected}) {
    const double peclet = 100, heating = 0.1, tolerance = 1e-12;
    const PublishedSolution x = solve(0.5, peclet, heating, 30, formulation, tolerance);
    const Eigen::VectorXd heat = thermoroll::node_heat(x);
    Real even = 0, odd = 0, size = 1;
    for (Index m = 0; m < x.grid.s.size(); ++m)
      for (Index k = 0; k < heat.size(); ++k) {
        const Real term = friction * peclet * heating * heat(k) *
                          reference::N1(peclet * (x.grid.t(k) - static_cast<Real>(x.grid.s(m)))) /
                          31;
        even += term;
        odd += term * x.grid.s(m);
        size += term;
      }
    const Real rounding = (30 * 10 * epsilon + tolerance) * size;
    EXPECT_TRUE(close(x.gamma0, -sign_of(formulation) * even, rounding));
    EXPECT_TRUE(close(x.load_ratio, 1 - sign_of(formulation) * reference::pi * odd, 4 * rounding));
  }
}

// What the paper quotes, T*max = 0.002 from n = 200 with "thermal deformation negligible"; the
// other digits are those that this scheme was first restored with, by another program.
TEST(PublishedScheme, ReproducesThePapersTemperature) {
  const double expected[] = {0.001998, 0.002215, 0.002505};  // H(0) = 0, 1/2, 1
  int steps = 0;
  for (int i = 0; i < 3; ++i) {
    PublishedOptions options;
    options.heaviside_at_zero = 0.5 * i;
    const PublishedSolution x =
        solve_published({friction, 0.5, 5000, 0.0175}, Formulation::printed, options);
    const thermoroll::PublishedPeak peak = thermoroll::published_max_temperature(x, 5000);
    EXPECT_TRUE(x.converged);
    EXPECT_TRUE(close(peak.temperature, expected[i], 0.5e-6))
        << "to the digits quoted, H(0) = " << 0.5 * i;
    EXPECT_LE(x.outer_iterations, 35) << "the paper's count";
    EXPECT_LE(x.inner_iterations, 20) << "the paper's count";
    EXPECT_GT(x.outer_iterations, steps) << "a larger H(0) converges more slowly";
    steps = x.outer_iterations;
    if (i > 0) continue;
    EXPECT_EQ(std::round(peak.temperature * 1e3), 2) << "the paper's 0.002";
    EXPECT_TRUE(close(x.load_ratio, 0.99981, 0.5e-5));
    // The peak is the largest of the values at the collocation points, and at one of them.
    Real largest = 0;
    bool there = false;
    for (Index m = 0; m < x.grid.s.size(); ++m) {
      Real sum = 0;
      const Eigen::VectorXd heat = thermoroll::node_heat(x);
      for (Index k = 0; k < heat.size(); ++k)
        if (heat(k) != 0)
          sum += heat(k) * reference::M(5000 * (x.grid.t(k) - static_cast<Real>(x.grid.s(m)))) /
                 reference::pi;
      // Sums of up to 200 positive terms of relative error 1e-13, plus what exp does upstream.
      EXPECT_TRUE(close(thermoroll::published_temperature(x, 5000, x.grid.s(m)), sum,
                        2e-13 * sum + 1e-300L));
      largest = std::max(largest, sum);
      there = there || x.grid.s(m) == peak.at;
    }
    EXPECT_TRUE(close(peak.temperature, largest, 2e-13 * largest));
    EXPECT_TRUE(there);
  }
}

// The rule looks at d^(-1/2) half a step from its singular end: its error is -zeta(1/2, 1/2)
// sqrt(h) times the flux there. Without heat, where the flux is Carter's, that is an order and a
// factor.
TEST(PublishedScheme, TemperatureConvergesSlowly) {
  const double traction = 0.5;
  const Real b = std::sqrt(1 / 6.0L),
             at = std::sqrt(0.5L);  // cos(pi/4), a point of every grid below
  const auto flux = [&](Real s) {
    return 4 * friction / (reference::pi * reference::pi) * (1 + s) *
           std::sqrt((s - 2 * b + 1) * (1 - s));
  };
  const double peclet = 1e6;
  // The integral up to t = at; the layer of width 1/Pe beyond it, and the difference of K0 from its
  // tail, cancel to leading order and leave O(1/Pe). sqrt(at - t) is removed by the substitution.
  const Real exact = reference::integral(
      [&](Real left, Real right) {
        const Real t = 2 * b - 1 + left;
        return 4 * friction / (reference::pi * reference::pi) * (1 + t) *
               std::sqrt(left * (1 - at + right)) *
               std::sqrt(reference::pi / (2 * peclet * right)) / reference::pi;
      },
      at - 2 * b + 1);
  Real previous = 0;
  for (const int n : {49, 149, 449}) {
    const PublishedSolution x = solve(traction, peclet, 0, n);
    Index m = 0;
    while (std::abs(x.grid.s(m) - at) > 1e-12L) ++m;
    const Real error = exact - thermoroll::published_temperature(x, peclet, x.grid.s(m));
    const Real h = reference::pi * std::sqrt(0.5L) / (n + 1);
    const Real predicted = 0.6048986434216303702L * std::sqrt(h) * flux(at) *
                           std::sqrt(reference::pi / (2 * peclet)) / reference::pi;
    // The next terms: h times the flux's slope (and the grid's) over the flux, about 1; 1/(Pe h)
    // for the kernel's layer, below 3e-4; and what the node at c0 does, h^(3/2)/sqrt(h).
    EXPECT_TRUE(close(error / predicted, 1, h)) << "n = " << n;
    if (previous != 0) {
      const Real order = std::log(previous / error) / std::log(3.0L);
      EXPECT_TRUE(close(order, 0.5, 0.05)) << "n = " << n;
    }
    previous = error;
  }
  // The same for the maximum at the paper's speed, where the grid's search for it is coarse too.
  previous = 0;
  for (const int n : {50, 100, 200, 400}) {
    const PublishedSolution x = solve(traction, 5000, 0, n);
    const Real error = 0.00205267L - thermoroll::published_max_temperature(x, 5000).temperature;
    if (previous != 0) {
      const Real order = std::log2(previous / error);
      EXPECT_GT(order, 0.3) << "n = " << n;
      EXPECT_LT(order, 0.8) << "n = " << n;
    }
    previous = error;
  }
}

// The sum of the heat cuts its square root at c0 anywhere between two nodes: an error of up to
// A h^(3/2), where the flux starts like A sqrt(s - c0), and as much again from the slip at the
// first nodes, which the stick zone's rule does not resolve.
TEST(PublishedScheme, HeatConvergesWithOrderThreeHalves) {
  const double traction = 0.5;
  const Carter c = thermoroll::carter(friction, traction);
  const Real exact = c.creep * static_cast<Real>(traction) / friction;
  const Real start =
      4 * friction / (reference::pi * reference::pi) * 2 * c.b * std::sqrt(2 - 2 * c.b);
  const auto mean_error = [&](int from, int to, int step) {
    Real sum = 0;
    int count = 0;
    for (int n = from; n <= to; n += step, ++count) {
      const Real h = reference::pi * std::sqrt(1 - static_cast<Real>(c.c0) * c.c0) / (n + 1);
      const Real error = thermoroll::node_heat(solve(traction, 1, 0, n)).sum() - exact;
      EXPECT_LT(std::abs(error), start * std::pow(h, 1.5L)) << "n = " << n;
      sum += std::abs(error);
    }
    return sum / count;
  };
  const Real order = std::log(mean_error(20, 40, 1) / mean_error(100, 200, 5)) / std::log(5.0L);
  EXPECT_TRUE(close(order, 1.5, 0.3));  // of means over 21 positions of the border in its cell
}

// gamma0 does not vanish with n: it tends to the limit that the integral equation gives it, and so
// does kappa. The N1 sum is a midpoint rule of a kernel 1/Pe wide, second-order once that is
// resolved.
TEST(PublishedScheme, GammaTendsToALimit) {
  const double traction = 0.5, heating = 1e-6, scale = friction * heating;
  // The limit of high speed, f = 0.6 and Q* = 0.5: N1 becomes a delta, and gamma0 / f H is
  // -(1/pi) int g/sqrt(1-t^2) dt. What N1 has beyond a distance of 1 is 0.4/sqrt(Pe) of its weight.
  const Real b = std::sqrt(1 / 6.0L);
  const Real delta =
      -4 * friction / (reference::pi * reference::pi * reference::pi) *
      reference::integral([&](Real left, Real) { return std::sqrt(left * (2 * b + left)); },
                          2 - 2 * b);
  EXPECT_TRUE(close(delta, -0.0816386L, 0.5e-7L));
  EXPECT_TRUE(close(first_order(traction, 1e9L).gamma0, delta, 1e-5L));

  const FirstOrder limit = first_order(traction, 100);
  EXPECT_TRUE(close(limit.gamma0, -0.0755L, 0.0005L)) << "less than at high speed";
  Real gamma_error = 0, load_error = 0;
  for (const int n : {50, 100, 200, 400}) {
    const PublishedSolution x = solve(traction, 100, heating, n, Formulation::printed, 1e-8);
    const Real gamma0 = 1 - x.gamma0 / scale / limit.gamma0;
    const Real load = 1 - (1 - x.load_ratio) / scale / limit.load_loss;
    EXPECT_GT(gamma0, 0) << "the kernel's peak is missed, n = " << n;
    EXPECT_GT(load, 0) << n;
    EXPECT_LT(x.gamma0, 0) << "negative, with the sign as printed";
    if (n > 50) {  // order 1 while the kernel is unresolved, 2 after that
      EXPECT_GT(gamma_error / gamma0, 1.8) << n;
      EXPECT_LT(gamma_error / gamma0, 4.2) << n;
      EXPECT_GT(load_error / load, 1.8) << n;
      EXPECT_LT(load_error / load, 4.2) << n;
    }
    gamma_error = gamma0;
    load_error = load;
  }
  EXPECT_LT(gamma_error, 0.03);  // x = h Pe sin(theta), at n = 400: x^2 / 16 = 0.017 on average
  EXPECT_LT(load_error, 0.03);
}

// At the paper's Pe the nodes are pi Pe / n widths of the kernel apart, so that most of the
// thermal slope is lost: 1 - kappa grows with n and is nowhere near its limit.
TEST(PublishedScheme, DoesNotResolveTheSlopeAtThePapersSpeed) {
  const double heating = 0.0175;
  const Real limit = friction * heating * first_order(0.5, 4360).load_loss;
  EXPECT_TRUE(close(limit, 1.455e-3L, friction * heating * limit));  // first order in f H
  const double quoted[] = {8.2e-5, 1.3e-4, 2.05e-4};
  for (int i = 0; i < 3; ++i) {
    const PublishedSolution x = solve(0.5, 4360, heating, 50 << i);
    EXPECT_TRUE(close(1 - x.load_ratio, quoted[i], i == 1 ? 0.5e-5 : 0.05e-5))
        << "n = " << (50 << i);
    EXPECT_LT(1 - x.load_ratio, limit / 6);
  }
}

// The two formulations differ in the sign of the slope: kappa - 1 and gamma0 flip to first order in
// H; what does not flip is of second order.
TEST(PublishedScheme, SignFlipsWhatHeatDoes) {
  const auto both = [](double heating) {
    const PublishedSolution p = solve(0.5, 100, heating, 60, Formulation::printed, 1e-11);
    const PublishedSolution c = solve(0.5, 100, heating, 60, Formulation::corrected, 1e-11);
    EXPECT_LT(p.load_ratio, 1) << "as printed, heat sinks";
    EXPECT_GT(c.load_ratio, 1) << "corrected, it bulges";
    EXPECT_LT(p.gamma0, 0);
    EXPECT_GT(c.gamma0, 0);
    return std::vector<double>{p.load_ratio - c.load_ratio, p.gamma0 - c.gamma0,
                               p.load_ratio + c.load_ratio - 2, p.gamma0 + c.gamma0};
  };
  const std::vector<double> small = both(1e-3), large = both(1e-2);
  for (const std::size_t i : {0u, 1u}) {
    // The next orders are f H relative to these: 0.6e-2.
    EXPECT_TRUE(close(large[i] / small[i], 10, 10 * 0.006));
    EXPECT_TRUE(close(large[i + 2] / small[i + 2], 100, 100 * 0.006)) << i;
  }
}

// Where the inner iteration keeps failing the outer one gives up, early enough for a user to wait.
TEST(PublishedScheme, GivesUpAfterTenFailures) {
  // One inner step a time never reaches this tolerance, so that every outer step fails but the
  // first, which has no heat yet.
  PublishedOptions options;
  options.nodes = 20;
  options.max_inner = 1;
  options.tolerance = 1e-12;
  const Driven scene{friction, 0.5, 100, 0.5};
  const PublishedSolution ten = solve_published(scene, Formulation::printed, options);
  EXPECT_FALSE(ten.converged);
  EXPECT_EQ(ten.outer_iterations, 1 + 10);
  options.max_failures = 3;
  EXPECT_EQ(solve_published(scene, Formulation::printed, options).outer_iterations, 1 + 3);

  // A cycle: without a bound on the failures it runs into the bound on the steps.
  PublishedOptions bounded;
  bounded.nodes = 40;
  const Driven hot{friction, 0.5, 100, 4};
  const PublishedSolution cycle = solve_published(hot, Formulation::printed, bounded);
  EXPECT_FALSE(cycle.converged);
  EXPECT_EQ(cycle.inner_iterations, bounded.max_inner);
  EXPECT_LT(cycle.outer_iterations, 60);
  bounded.max_failures = bounded.max_outer;
  const PublishedSolution endless = solve_published(hot, Formulation::printed, bounded);
  EXPECT_FALSE(endless.converged);
  EXPECT_EQ(endless.outer_iterations, bounded.max_outer);

  // A few failures on the way are no reason to give up.
  const PublishedSolution late = solve(0.3, 100, 2, 25);
  EXPECT_TRUE(late.converged);
  EXPECT_EQ(late.inner_iterations, PublishedOptions{}.max_inner) << "some of its steps failed";
}

// Where an iteration does not settle, the solution says so.
TEST(PublishedScheme, SaysWhenItDoesNotConverge) {
  PublishedOptions options;
  options.nodes = 100;
  options.max_outer = 35;  // more than the paper ever needed
  options.max_inner = 20;
  const PublishedSolution hot =
      solve_published({friction, 0.5, 100, 2}, Formulation::printed, options);
  EXPECT_FALSE(hot.converged);
  EXPECT_LE(hot.outer_iterations, 35);
  EXPECT_EQ(hot.phi.size(), 100) << "the last iterate is there";

  // A scene that does settle, stopped early by either bound.
  const Driven scene{friction, 0.5, 100, 0.0175};
  options.nodes = 20;
  const PublishedSolution good = solve_published(scene, Formulation::printed, options);
  EXPECT_TRUE(good.converged);
  EXPECT_GT(good.inner_iterations, 1);
  options.max_outer = good.outer_iterations - 1;
  const PublishedSolution early = solve_published(scene, Formulation::printed, options);
  EXPECT_FALSE(early.converged);
  EXPECT_EQ(early.outer_iterations, good.outer_iterations - 1);
  options.max_outer = good.outer_iterations;
  EXPECT_TRUE(solve_published(scene, Formulation::printed, options).converged);
  // The border alone bounded: one inner step a time still settles in the end, but not in three.
  options.max_inner = 1;
  EXPECT_FALSE(solve_published(scene, Formulation::printed, options).converged);
}

// The first step starts from no slip at all and finds some, where a node slips: its change is all
// of the slip, which is no small part of it, however small the slip is. So the first step is never
// the last.
TEST(PublishedScheme, FirstStepIsNeverTheLast) {
  for (const double traction : {0.01, 0.1, 0.5})
    for (const double tolerance : {0.1, 1e-3}) {
      PublishedOptions options;
      options.nodes = 20;
      options.tolerance = tolerance;
      const PublishedSolution x =
          solve_published({friction, traction, 100, 0.0175}, Formulation::printed, options);
      EXPECT_TRUE(x.converged);
      EXPECT_GT(x.slip.maxCoeff(), 0);
      EXPECT_GE(x.outer_iterations, 2) << "Q* = " << traction << ", tolerance " << tolerance;
    }
}

// Whenever it says that it converged, the traction is the one asked for, to the tolerance: with one
// step of the border at a time the slip may well settle first, and so it may where strong heat lets
// no border be found. That never leaves the contact without a border either: a step that leaves the
// stick zone no traction is followed by others.
TEST(PublishedScheme, ConvergesToTheTractionOrNotAtAll) {
  int settled = 0, without_traction = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6})
    for (const double traction : {0.005, 0.05, 0.3, 0.5})
      for (const Formulation formulation : {Formulation::printed, Formulation::corrected})
        for (const double heating : {1e-3, 0.2, 6.0, 30.0})
          for (const int steps : {1, 50}) {
            PublishedOptions options;
            options.nodes = 20;
            options.tolerance = tolerance;
            options.max_inner = steps;
            const PublishedSolution x =
                solve_published({friction, traction, 4000, heating}, formulation, options);
            SCOPED_TRACE(::testing::Message() << "Q* = " << traction << ", H = " << heating
                                              << ", tolerance " << tolerance << ", " << steps);
            EXPECT_TRUE(-1 < x.c0 && x.c0 <= 1) << x.c0;
            for (const thermoroll::InnerStep& step : x.steps) {
              EXPECT_TRUE(-1 < step.c0 && step.c0 <= 1) << step.c0;
              without_traction += step.traction >= friction ? 1 : 0;
            }
            if (!x.converged) continue;
            ++settled;
            const double shear = (1 + x.c0) / 2 * x.grid.w.dot(x.phi0);
            EXPECT_TRUE(close(shear, traction - friction, tolerance * traction * (1 + 1e-9)));
          }
  EXPECT_GT(settled, 0) << "else nothing was seen";
  EXPECT_GT(without_traction, 0) << "nor of this";
}

TEST(PublishedScheme, RefusesWhatMakesNoSense) {
  const Driven good{friction, 0.5, 100, 0.0175};
  PublishedOptions options;
  for (const int nodes : {2, 1, 0, -5}) {
    options.nodes = nodes;
    EXPECT_THROW(solve_published(good, Formulation::printed, options), std::invalid_argument);
  }
  options.nodes = 3;
  EXPECT_NO_THROW(solve_published(good, Formulation::printed, options));
  for (int PublishedOptions::*count : {&PublishedOptions::max_outer, &PublishedOptions::max_inner,
                                       &PublishedOptions::max_failures}) {
    PublishedOptions none;
    none.*count = 0;
    EXPECT_THROW(solve_published(good, Formulation::printed, none), std::invalid_argument);
  }
  for (const double no_tolerance : {0.0, -1.0, std::nan("")}) {
    PublishedOptions endless;
    endless.tolerance = no_tolerance;
    EXPECT_THROW(solve_published(good, Formulation::printed, endless), std::invalid_argument);
  }
  PublishedOptions undefined;
  undefined.heaviside_at_zero = std::nan("");
  EXPECT_THROW(solve_published(good, Formulation::printed, undefined), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Driven& bad : {Driven{friction, 0.6, 100, 0}, Driven{friction, 0.5, -1, 0},
                            Driven{friction, 0.5, 100, nan}})
    EXPECT_THROW(solve_published(bad, Formulation::printed), std::invalid_argument);
  for (const auto change :
       {+[](thermoroll::Scene& x) {
          x.roller = {1, 0.0175};
        },
        +[](thermoroll::Scene& x) { x.direction = Direction::braking; },
        +[](thermoroll::Scene& x) {
          x.law = thermoroll::LawOfFriction{thermoroll::LawKind::linear, {0.02, 0, 0}};
        }}) {
    thermoroll::Scene other{friction, 100, 0.0175};
    change(other);
    EXPECT_THROW(thermoroll::solve_published(other, 0.5, Formulation::printed),
                 std::invalid_argument);
  }
}
