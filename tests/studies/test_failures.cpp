// Where methods fail: each failure, and its cure.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "driven.hpp"
#include "first_order.hpp"
#include "reference.hpp"
#include "studies/asymptotics.hpp"
#include "studies/iterations.hpp"
#include "studies/naive_kernels.hpp"
#include "studies/resolution.hpp"
#include "support/number_text.hpp"
#include "thermoroll/admissibility.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/published_scheme.hpp"
#include "thermoroll/temperature.hpp"

namespace {

using Eigen::VectorXd;
using reference::close;
using reference::epsilon;
using reference::Real;
using thermoroll::Carter;
using thermoroll::CoupledSolution;
using thermoroll::Factors;
using thermoroll::FluxMap;
using thermoroll::Formulation;
using thermoroll::PublishedSolution;
using thermoroll::Quantity;
using thermoroll::Violation;
namespace kernel = thermoroll::kernel;
namespace naive_scaled = thermoroll::naive_scaled;
namespace naive = thermoroll::naive;

using Kernel = double (*)(double);
using Exact = Real (*)(Real);

Real M(Real zeta) { return reference::M(zeta); }

// The largest relative error at fifty arguments in a tenth of a decade from zeta.
Real worst(Kernel formula, Exact exact, double zeta) {
  Real worst = 0;
  for (int i = 0; i < 50; ++i) {
    const double at = zeta * std::pow(10, i / 500.0);
    const Real off = std::abs(formula(at) / exact(at) - 1);
    if (!(off <= worst)) worst = off;  // a NaN stays
  }
  return worst;
}

// A formula's worst error follows the law: each of its two functions is good to a few eps (GSL
// promises no more), and fifty roundings have an unfavourable one among them.
::testing::AssertionResult follows(Real error, Real law) {
  if (law / 4 < error && error < 8 * law) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << static_cast<double>(error) << " where the law has " << static_cast<double>(law);
}

}  // namespace

// I_0(x) = e^x / sqrt(2 pi x) and more passes the largest double at 713.99, e^x at 709.78.
// Beyond, nothing is left of what is finite; the scaled functions and ours go on.
TEST(Arithmetic, PrintedFormulasOverflow) {
  for (const double x : {714.5, 1e3, 8720.0, 1e6, 1e12}) {
    for (const double value : {naive::N1(x), naive::N2(-x), naive::M(-x)})
      EXPECT_FALSE(std::isfinite(value) && value != 0) << x;
    EXPECT_EQ(thermoroll::digits_lost(naive::N1(x), kernel::N1(x)), -std::log10(epsilon));
    EXPECT_LT(std::abs(naive_scaled::M(-x) / reference::M(-x) - 1), 8 * epsilon);
    for (const Real error :
         {kernel::N1(x) / reference::N1(x) - 1, kernel::N2(-x) / reference::N2(-x) - 1,
          kernel::M(-x) / reference::M(-x) - 1})
      EXPECT_LT(std::abs(error), 1e-13L) << x;
  }
  for (const double x : {10.0, 300.0, 700.0}) {
    EXPECT_LT(worst(naive::N1, reference::N1, x / 1.26), 1e-11L) << x;
    EXPECT_LT(worst(naive::N2, reference::N2, -x / 1.26), 1e-13L) << x;
    EXPECT_LT(worst(naive::M, M, -x / 1.26), 1e-13L) << x;
  }
}

// A value that is right to the last bit has lost none of its digits, one that is twice as large
// all.
TEST(Arithmetic, DigitsAreLostFromNoneToAll) {
  EXPECT_EQ(thermoroll::digits_lost(0.1, 0.1), 0);
  EXPECT_EQ(thermoroll::digits_lost(std::nextafter(0.1, 0), 0.1), 0);
  EXPECT_EQ(thermoroll::digits_lost(0.2, 0.1), -std::log10(epsilon));
  EXPECT_NEAR(thermoroll::digits_lost(0.1 * (1 + 1e-6), 0.1), -6 - std::log10(epsilon), 1e-6);
}

// @eq:digits-lost: 2 zeta eps, eps / (|zeta| ln(2/|zeta|)) and sqrt(pi |zeta| / 2) eps; ours keep
// 1e-13 at the same arguments.
TEST(Arithmetic, PrintedFormulasLoseDigitsByTheirLaws) {
  for (const double x : {1e2, 1e4, 1e7, 1e11}) {
    EXPECT_TRUE(follows(worst(naive_scaled::N1, reference::N1, x), 2 * x * epsilon)) << x;
    EXPECT_TRUE(follows(worst(naive_scaled::N2, reference::N2, -x),
                        std::sqrt(reference::pi * x / 2) * epsilon))
        << x;
    EXPECT_LT(worst(kernel::N1, reference::N1, x), 1e-13L) << x;
    EXPECT_LT(worst(kernel::N2, reference::N2, -x), 1e-13L) << x;
    if (x > 500) continue;
    EXPECT_TRUE(follows(worst(naive::N1, reference::N1, x), 2 * x * epsilon)) << x;
  }
  for (const double x : {1e-3, 1e-6, 1e-9, 1e-12})
    for (const double zeta : {x, -x}) {
      const Real law = epsilon / (x * std::log(2 / x));
      EXPECT_TRUE(follows(worst(naive::N2, reference::N2, zeta), law)) << zeta;
      EXPECT_TRUE(follows(worst(naive_scaled::N2, reference::N2, zeta), law)) << zeta;
      EXPECT_LT(worst(kernel::N2, reference::N2, zeta), 1e-13L) << zeta;
    }
}

// @eq:sampled-weight-limits. The next term of the first is of order x^4, that of the second, from
// N1's next term at infinity, smaller by 1/x.
TEST(Resolution, SampledWeightHasItsLimits) {
  for (const double x : {1e-3, 1e-2, 0.1, 0.3})
    EXPECT_TRUE(close(thermoroll::sampled_weight(x), 1 - x * x / 16, 0.02 * x * x * x * x + 1e-13))
        << x;
  const Real zeta_at_3_2 = 2.61237534868548834L;
  for (const double x : {30.0, 1e3, 1e6}) {
    const Real limit = (std::sqrt(8.0L) - 1) * zeta_at_3_2 / std::sqrt(8 * reference::pi * x);
    EXPECT_TRUE(close(thermoroll::sampled_weight(x) / limit, 1, 1 / x)) << x;
  }
  // In between, ten thousand terms and the tail that is left, 1/sqrt(2 pi zeta) to 1/(8 zeta).
  for (const double x : {1.0, 5.0}) {
    Real sum = 0;
    for (int j = 0; j < 10000; ++j) sum += x * reference::N1((j + 0.5L) * x);
    const Real rest = 1 / std::sqrt(2 * reference::pi * 10000 * x);
    EXPECT_TRUE(close(thermoroll::sampled_weight(x), sum + rest, rest / (40000 * x))) << x;
  }
}

// The exact effect is that of the first order (@eq:first-order at high speed, by an integral that
// shares nothing). What the scheme misses of it is what the law says, up to the variation of the
// heat from one node to the next; the larger n at the same Pe/n, the better.
TEST(Resolution, SchemeSeesWhatTheLawSays) {
  const Carter c = thermoroll::carter(0.6, 0.5);
  for (const double peclet : {100.0, 1e4}) {
    const Real exact = reference::first_order(0.5, peclet).load_loss;
    EXPECT_TRUE(close(thermoroll::exact_load_change(c, peclet) / exact, 1, 1e-6L)) << peclet;
  }
  for (const double ratio : {0.2, 1.0, 5.0, 40.0}) {
    double before = 1;
    for (const int nodes : {100, 400, 1600}) {
      const double peclet = ratio * nodes, exact = thermoroll::exact_load_change(c, peclet);
      const double missed = exact - thermoroll::scheme_load_change(c, peclet, nodes);
      const double law = thermoroll::missed_load_change(c, peclet, nodes);
      EXPECT_LT(std::abs(missed / law - 1), 0.6 * before) << ratio << ", " << nodes;
      before = std::max(std::abs(missed / law - 1), 0.01);
    }
    EXPECT_LE(before, 0.05) << ratio;
  }
}

// The first order stands for the scheme: its share seen at the paper's heating, where the next
// order is fH = 1e-2 of it, and where both are resolved it is the coupled solution's.
TEST(Resolution, FirstOrderIsWhatTheSchemeDoes) {
  const Carter c = thermoroll::carter(0.6, 0.5);
  for (const double peclet : {20.0, 100.0, 1000.0})
    for (const int nodes : {50, 100, 200}) {
      const Driven scene{0.6, 0.5, peclet, 0.0175};
      const PublishedSolution x = solve_published(scene, Formulation::printed, {nodes});
      const CoupledSolution y =
          thermoroll::solve_coupled(scene, {Formulation::printed, 1e-8}, {Quantity::traction, 0.5});
      const double seen = (1 - x.load_ratio) / (1 - y.value(Quantity::load_ratio));
      const double first = thermoroll::scheme_load_change(c, peclet, nodes) /
                           thermoroll::exact_load_change(c, peclet);
      EXPECT_TRUE(close(seen / first, 1, 0.01)) << peclet << ", " << nodes;
    }
}

namespace {

PublishedSolution cycling(int nodes, Formulation formulation) {
  return solve_published({0.6, 0.5, 100, 0.5}, formulation, {nodes});
}

}  // namespace

// With 90 nodes the inner iteration goes round a node for ever: the last three steps come again,
// on either side of it, and miss the traction on either side. Its neighbours settle.
TEST(Resolution, ANodeAtTheBorderCyclesForEver) {
  for (const int nodes : {89, 91})
    EXPECT_TRUE(cycling(nodes, Formulation::corrected).converged) << nodes;
  const PublishedSolution x = cycling(90, Formulation::corrected);
  EXPECT_FALSE(x.converged);
  const auto last = x.steps.rbegin();
  bool hot = false, cold = false;
  for (auto step = last; step != last + 3; ++step) {
    EXPECT_TRUE(close(step->c0, (step + 3)->c0, 1e-6)) << "it repeats";
    EXPECT_GT(std::abs(step->traction - 0.5), 1e-5) << "and never gets there";
    const auto beyond = [&](double t) { return step->c0 < t && t < step->c0 + 2e-3; };
    (std::any_of(x.grid.t.begin(), x.grid.t.end(), beyond) ? hot : cold) = true;
  }
  EXPECT_TRUE(hot && cold) << "a node lies in between";
  EXPECT_TRUE(cycling(90, Formulation::printed).converged) << "the jump has the other direction";
}

// Where the scheme cycles, the coupled solver's traction is a smooth function of the border: its
// second difference is of the second order, 1e-6, where the scheme's jump is 3e-4.
TEST(Resolution, MovingNodesKnowNoJumps) {
  const auto traction = [](double c0) {
    return thermoroll::solve_coupled({0.6, 100, 0.5}, {Formulation::corrected, 1e-9},
                                     {Quantity::stick_slip_border, c0})
        .value(Quantity::traction);
  };
  for (int i = 0; i < 20; ++i) {
    const double c0 = -0.2235 + 1e-4 * i;
    EXPECT_LT(std::abs(traction(c0 - 1e-3) - 2 * traction(c0) + traction(c0 + 1e-3)), 1e-6) << c0;
  }
}

namespace {

constexpr Formulation both[] = {Formulation::printed, Formulation::corrected};

// The problem of the maps of Iteration at H = 1: f = 0.6, Carter's border at Q* = 0.5.
FluxMap unit_map(double peclet, Formulation formulation, int n = 64) {
  const double c0 = thermoroll::carter(0.6, 0.5).c0;
  return thermoroll::flux_map({0.6, peclet, 1}, formulation, n, c0);
}

// The solution at f Pe H = strength, led there; fails the test if it is not reached.
VectorXd solution(const FluxMap& unit, double peclet, double strength) {
  VectorXd h = thermoroll::carter_start(unit);
  EXPECT_TRUE(thermoroll::follow(unit, 1e-3 / peclet, strength / (0.6 * peclet), h))
      << "Pe = " << peclet << ", f Pe H = " << strength;
  return h;
}

FluxMap map_at(const FluxMap& unit, double peclet, double strength) {
  return thermoroll::heated(unit, strength / (0.6 * peclet));
}

// The solution, a thousandth off in every mode.
VectorXd nearby(const VectorXd& h) {
  VectorXd x = h;
  for (int i = 0; i < x.size(); ++i) x(i) *= 1 + 1e-3;
  return x;
}

const double speeds[] = {0.2, 3, 50, 1000};
const double strengths[] = {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048};

// Visit the scenes of the list with their solutions: f(map, h), while fH is below ten at high and
// f Pe H below forty at low speed.
template <class F>
void over_scenes(F f) {
  for (const Formulation formulation : both)
    for (const double peclet : speeds) {
      const FluxMap unit = unit_map(peclet, formulation, 48);
      for (const double strength : strengths)
        if (strength < 10 * std::max(4.0, peclet)) {
          SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", f Pe H = " << strength);
          f(map_at(unit, peclet, strength), solution(unit, peclet, strength));
        }
    }
}

}  // namespace

// Near a solution the error is multiplied by rho a step, so that 1e-3 takes ln(1e-5)/ln(rho) steps
// to 1e-8; the first few steps and modes that are not eigenvectors cost some more. Beyond rho = 1
// the iteration leaves even the solution's neighbourhood. From Carter's flux it is the same.
TEST(Iteration, PicardContractsAsTheLinearisedMapSays) {
  int contracting = 0, expanding = 0;
  over_scenes([&](const FluxMap& map, const VectorXd& h) {
    const double rho = thermoroll::contraction(map, h);
    VectorXd near = nearby(h), far = thermoroll::carter_start(map);
    const int steps = thermoroll::picard(map, near);
    if (rho < 0.95) {
      ++contracting;
      const double expected = std::log(1e-5) / std::log(rho);
      EXPECT_GE(steps, 0.5 * expected - 1) << "rho = " << rho;
      EXPECT_LE(steps, 1.3 * expected + 6) << "rho = " << rho;
      EXPECT_LT((near - h).norm(), 1e-6 * h.norm());
      if (rho < 0.8) {
        EXPECT_GT(thermoroll::picard(map, far), 0);
        EXPECT_LT((far - h).norm(), 1e-6 * h.norm());
      }
    } else if (rho > 1.05) {
      ++expanding;
      EXPECT_TRUE(steps == 0 || (near - h).norm() > 0.1 * h.norm()) << "rho = " << rho;
    }
  });
  EXPECT_GT(contracting, 10);
  EXPECT_GT(expanding, 10);
}

TEST(Iteration, RelaxationIsPredictedToo) {
  int gained = 0;
  over_scenes([&](const FluxMap& map, const VectorXd& h) {
    const double rho = thermoroll::contraction(map, h, 0.5);
    VectorXd near = nearby(h);
    const int steps = thermoroll::picard(map, near, 0.5);
    if (rho < 0.95) {
      EXPECT_GT(steps, 0) << "rho = " << rho;
      EXPECT_LT((near - h).norm(), 1e-6 * h.norm());
      if (thermoroll::contraction(map, h) > 1.05) ++gained;
    } else if (rho > 1.05) {
      EXPECT_TRUE(steps == 0 || (near - h).norm() > 0.1 * h.norm()) << "rho = " << rho;
    }
  });
  EXPECT_GT(gained, 4) << "where the full step fails";
}

// Where Picard's iteration fails, Anderson's goes on for a while, and Newton's for longer. All find
// the same.
TEST(Iteration, AndersonAndNewtonGoFurther) {
  for (const auto& [peclet, strength] : {std::pair{1.0, 4.0}, {30.0, 80.0}, {1000.0, 2000.0}}) {
    const FluxMap unit = unit_map(peclet, Formulation::corrected);
    const FluxMap map = map_at(unit, peclet, strength);
    const VectorXd h = solution(unit, peclet, strength);
    VectorXd by_picard = thermoroll::carter_start(map), by_anderson = by_picard,
             by_newton = by_picard;
    EXPECT_EQ(thermoroll::picard(map, by_picard), 0) << peclet;
    EXPECT_GT(thermoroll::anderson(map, by_anderson), 0) << peclet;
    EXPECT_GT(thermoroll::newton(map, by_newton), 0) << peclet;
    EXPECT_LT((by_anderson - h).norm(), 1e-5 * h.norm());
    EXPECT_LT((by_newton - h).norm(), 1e-7 * h.norm());
  }
  // Newton's method from Carter's flux fails too, by going where there is no contact.
  const FluxMap unit = unit_map(100, Formulation::corrected);
  const FluxMap map = map_at(unit, 100, 2500);
  VectorXd h = thermoroll::carter_start(map);
  EXPECT_TRUE(thermoroll::newton(map, h) == 0 || thermoroll::slip_factor(map, h).minCoeff() < 0);
}

// Led from no heating, Newton's method arrives at a contact, p and v positive, and at the same one
// on a finer grid.
TEST(Iteration, LedNewtonReachesEverything) {
  for (const Formulation formulation : both)
    for (const double peclet : {0.1, 1.0, 10.0, 100.0, 500.0}) {
      const double strength = 30 * std::max(peclet, 4.0);
      double load_ratio[2];
      for (const int n : {96, 144}) {
        const FluxMap unit = unit_map(peclet, formulation, n);
        const FluxMap map = map_at(unit, peclet, strength);
        const VectorXd h = solution(unit, peclet, strength);
        EXPECT_GT(thermoroll::pressure_factor(map, h).minCoeff(), 0) << peclet << ", " << n;
        EXPECT_GT(thermoroll::slip_factor(map, h).minCoeff(), 0) << peclet << ", " << n;
        load_ratio[n == 144] = 1 + map.kappa.dot(h);
      }
      EXPECT_GT(load_ratio[1], 0);
      EXPECT_LT(std::abs(load_ratio[0] / load_ratio[1] - 1), 1e-3) << peclet;
    }
}

// Ten times the heating, a tenth of the slip: v-hat H tends to a limit, and so does kappa.
TEST(Iteration, HeatLimitsItself) {
  for (const double peclet : {1.0, 30.0}) {
    const FluxMap unit = unit_map(peclet, Formulation::corrected, 128);
    double slip[3], load_ratio[3];
    for (int i = 0; i < 3; ++i) {
      const double strength = 300 * peclet * std::pow(10, i);
      const FluxMap map = map_at(unit, peclet, strength);
      const VectorXd h = solution(unit, peclet, strength);
      slip[i] = strength * thermoroll::slip_factor(map, h).minCoeff();
      load_ratio[i] = map.kappa.dot(h);
    }
    EXPECT_LT(std::abs(slip[2] / slip[1] - 1), 0.05) << peclet;
    EXPECT_LT(std::abs(slip[2] / slip[1] - 1), 0.5 * std::abs(slip[1] / slip[0] - 1)) << peclet;
    EXPECT_LT(std::abs(load_ratio[2] - load_ratio[1]),
              0.6 * std::abs(load_ratio[1] - load_ratio[0]))
        << peclet;
  }
}

// @eq:edge-power: between the layer, 30/Pe, and the contact, p-hat is a power of 1 - s. The fitted
// power is off by the layer and by the variation of v over the fit, a few per cent of it.
TEST(Iteration, TrailingEdgeHasItsPower) {
  const double peclet = 1e6, c0 = thermoroll::carter(0.6, 0.5).c0;
  for (const Formulation formulation : both)
    for (const double strength : {0.3e6, 0.8e6}) {
      const FluxMap unit = unit_map(peclet, formulation, 192);
      const FluxMap map = map_at(unit, peclet, strength);
      const VectorXd h = solution(unit, peclet, strength);
      const Eigen::ArrayXd p = thermoroll::pressure_factor(map, h);
      const double v = thermoroll::slip_factor(map, h).tail(1)(0) * std::sqrt(2 * (1 - c0));
      double x = 0, y = 0, xx = 0, xy = 0, count = 0;  // a straight line through the logarithms
      for (Eigen::Index i = 0; i < p.size(); ++i) {
        const double at = std::log(1 - map.s(i)), value = std::log(p(i));
        if (at < std::log(30 / peclet) || at > std::log(3e-3)) continue;
        x += at;
        y += value;
        xx += at * at;
        xy += at * value;
        count += 1;
      }
      ASSERT_GT(count, 8);
      const double power = (count * xy - x * y) / (count * xx - x * x);
      const double law = (formulation == Formulation::printed ? 1 : -1) / thermoroll::pi *
                         std::atan(strength / peclet * v);
      EXPECT_TRUE(close(power / law, 1, 0.05)) << strength;
    }
}

// As printed, p-hat falls towards the trailing edge. On 16 unknowns it becomes negative on the way,
// and the way ends; on ten times as many it does not.
TEST(Iteration, AFinerGridClosesTheContact) {
  const double peclet = 4360, heating = 15000 / (0.6 * peclet);
  for (const int n : {16, 160}) {
    const FluxMap unit = unit_map(peclet, Formulation::printed, n);
    VectorXd h = thermoroll::carter_start(unit);
    const int steps = thermoroll::follow(unit, 1e-3 / peclet, heating, h);
    if (n == 16) {
      EXPECT_EQ(steps, 0);
    } else {
      EXPECT_GT(steps, 0);
      EXPECT_GT(thermoroll::pressure_factor(thermoroll::heated(unit, heating), h).minCoeff(), 0);
    }
  }
}

namespace {

// Hertz and Carter: p-hat = 2/pi and v-hat = 2f/pi everywhere.
Factors carter_factors(double friction, double border) {
  const Eigen::ArrayXd s = Eigen::ArrayXd::LinSpaced(199, -0.99, 0.99);
  const Eigen::ArrayXd constant = Eigen::ArrayXd::Constant(199, 2 / thermoroll::pi);
  return {friction, border, 1, s, constant, friction * constant};
}

}  // namespace

TEST(Admissibility, ClosedFormIsAContact) {
  for (const double friction : {0.01, 0.6, 2.0})
    for (const double border : {-0.995, -0.5, 0.0, 0.7, 0.995})
      EXPECT_TRUE(thermoroll::violations(carter_factors(friction, border)).empty()) << border;
}

// Violations are shared if half of their intervals is; elsewhere, or of another condition, they are
// not. One that only one grid has is left out, and one that is left alone is a disagreement.
TEST(Admissibility, GridsAgreeOnSharedViolations) {
  using List = std::vector<Violation>;
  const Violation separation{"separation", -1, 0}, elsewhere{"separation", 0, 1},
      twice{"separation", -1, 1}, narrow{"separation", -1, -0.51}, backward{"backward slip", -1, 0};
  const auto names = [](const List& a, const List& b) -> std::string {
    const auto agreed = thermoroll::agreed_violations(a, b);
    if (!agreed) return "disagreement";
    std::string all;
    for (const Violation& x : *agreed) all += x.what + thermoroll::shortest(x.to) + " ";
    return all;
  };
  EXPECT_EQ(names({}, {}), "");
  EXPECT_EQ(names({separation, backward}, {twice, backward}), "separation1 backward slip0 ");
  EXPECT_EQ(names({twice}, {separation}), "separation0 ");
  EXPECT_EQ(names({separation}, {separation, backward}), "separation0 ");
  EXPECT_EQ(names({separation, backward}, {backward}), "backward slip0 ");
  for (const List& other : {List{}, {elsewhere}, {narrow}, {backward}}) {
    EXPECT_EQ(names({separation}, other), "disagreement");
    EXPECT_EQ(names(other, {separation}), "disagreement");
  }
}

// Each condition, made to fail on an interval by a straight line through zero at its ends, is named
// with that interval; so is more than one at a time, and a NaN.
TEST(Admissibility, NamesEveryViolationAndItsPlace) {
  const double border = 0.105;
  const auto only = [](const Factors& x, const std::string& what, double from, double to) {
    const std::vector<Violation> found = thermoroll::violations(x);
    if (found.size() == 1 && found[0].what == what && std::abs(found[0].from - from) < 1e-12 &&
        std::abs(found[0].to - to) < 1e-12)
      return ::testing::AssertionSuccess();
    ::testing::AssertionResult no = ::testing::AssertionFailure() << found.size() << " violations";
    for (const Violation& v : found) no << "; " << v.what << " from " << v.from << " to " << v.to;
    return no;
  };
  const auto dip = [](const Eigen::ArrayXd& s, double from, double to) {
    return ((s - (from + to) / 2).abs() - (to - from) / 2).eval();
  };
  Factors x = carter_factors(0.6, border);
  x.pressure = dip(x.s, 0.305, 0.605);
  EXPECT_TRUE(only(x, "separation", 0.305, 0.605));
  x.pressure = 0.9001 - x.s;
  EXPECT_TRUE(only(x, "separation", 0.9001, 1));
  x = carter_factors(0.6, border);
  x.slip = 0.6 * dip(x.s, 0.305, 0.605);
  EXPECT_TRUE(only(x, "backward slip", 0.305, 0.605));
  x = carter_factors(0.6, border);
  x.slip = 0.6 * dip(x.s, -0.505, -0.305);
  EXPECT_TRUE(only(x, "traction above friction", -0.505, -0.305));
  x = carter_factors(0.6, border);
  x.slip = (x.s < -0.9).select(20 + 0 * x.s, x.slip);
  EXPECT_EQ(thermoroll::violations(x).at(0).what, "traction below -friction");
  EXPECT_EQ(thermoroll::violations(x).at(0).from, -1);
  x = carter_factors(0.6, border);
  x.load_ratio = 0;
  EXPECT_TRUE(only(x, "no load", -1, 1));
  x.pressure(150) = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Violation> found = thermoroll::violations(x);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_LE(found[0].from, x.s(150));
  EXPECT_GE(found[0].to, x.s(150));
  x = carter_factors(0.6, border);
  x.slip = 0.6 * dip(x.s, 0.305, 0.605).min(dip(x.s, -0.505, -0.305));
  EXPECT_EQ(thermoroll::violations(x).size(), 2u);
}

// Without heat the scheme's factors are Hertz's and Carter's constants on both zones, to its own
// tolerance of 1e-6 for the border; with any, they have the signs of its tractions and velocities.
TEST(Admissibility, OfTheScheme) {
  const double f = 0.6;
  const Factors plain = factors(solve_published({f, 0.5, 100, 0}, Formulation::printed), f);
  EXPECT_LT((plain.pressure - 2 / thermoroll::pi).abs().maxCoeff(), 1e-9);
  EXPECT_LT((plain.slip - 2 * f / thermoroll::pi).abs().maxCoeff(), 1e-4);
  EXPECT_TRUE(thermoroll::violations(plain).empty());
  const auto x = solve_published({f, 0.5, 100, 1}, Formulation::corrected, {50});
  const Factors hot = factors(x, f);
  for (Eigen::Index i = 0; i < hot.s.size(); ++i) {
    const double s = hot.s(i), p = thermoroll::published_pressure(x, s);
    EXPECT_NEAR(hot.pressure(i) * std::sqrt((1 - s) * (1 + s)), p, 1e-12);
    const double root = std::sqrt((1 + s) * std::max(0.0, x.c0 - s));
    const double shortfall = f * p - thermoroll::published_traction(x, f, s);
    EXPECT_NEAR(root > 0 ? hot.slip(i) * root : 0, shortfall, 1e-9);
  }
  EXPECT_TRUE((hot.s.tail(hot.s.size() - 1) > hot.s.head(hot.s.size() - 1)).all());
}

// What the coupled solver gives is a contact, also at strong heating.
TEST(Admissibility, FollowsFromTheWayToTheSolution) {
  for (const double peclet : {0.1, 10.0, 1e4})
    for (const double heating : {0.1, 1.0, 10.0})
      for (const Formulation formulation : {Formulation::printed, Formulation::corrected})
        EXPECT_TRUE(thermoroll::solve_coupled({0.6, peclet, heating}, {formulation, 1e-3},
                                              {Quantity::traction, 0.5})
                        .violations.empty())
            << peclet << ' ' << heating;
}

// @eq:fast-and-slow against the adaptive quadrature and the coupled solver. The fast limit's next
// term is of relative order 1/Pe along the surface, and at the maximum of order 1/Pe^2 (found);
// the slow limit's, Pe z ln(Pe z).
TEST(Ends, FastAndSlowTemperature) {
  const thermoroll::HeatFlux flux = thermoroll::carter_flux(thermoroll::carter(0.6, 0.5));
  const double fast = thermoroll::hottest_when_fast(flux);
  const auto solver = [](double peclet) {
    return thermoroll::solve_coupled({0.6, peclet, 0}, {Formulation::corrected, 1e-9},
                                     {Quantity::traction, 0.5})
        .value(Quantity::max_temperature);
  };
  for (const double peclet : {1e3, 1e4, 1e6, 1e8}) {
    const double law = fast / std::sqrt(peclet), allowed = 1 / (peclet * peclet) + 2e-9;
    EXPECT_TRUE(close(solver(peclet) / law, 1, allowed)) << peclet;
    EXPECT_TRUE(close(thermoroll::hottest_point(flux, peclet).temperature.value / law, 1, allowed))
        << peclet;
  }
  for (const double peclet : {1e-1, 1e-2, 1e-3}) {
    const double law = thermoroll::hottest_when_slow(flux, peclet);
    EXPECT_TRUE(close(solver(peclet) / law, 1, 0.1 * peclet)) << peclet;
  }
}

// @eq:little-traction, at any speed and for either sign. The law's change of the creep is the first
// term in the length of the slip zone, 1 - c0 = Q*/f; the next is smaller by that length times a
// number of order one, as long as the zone is no longer than the kernels are wide.
TEST(Ends, LittleTraction) {
  for (const Formulation formulation : both)
    for (const double peclet : {0.01, 1.0, 100.0})
      for (const double heating : {0.1, 1.0})
        for (const double share : {1e-2, 1e-3, 1e-4}) {
          SCOPED_TRACE(::testing::Message() << "Pe = " << peclet << ", H = " << heating);
          const double q = 0.6 * share;
          const Driven scene{0.6, q, peclet, heating};
          const CoupledSolution x =
              thermoroll::solve_coupled(scene, {formulation, 1e-9}, {Quantity::traction, q});
          const double law = thermoroll::creep_of_little_traction(scene, q);
          const double change = std::abs(law / thermoroll::carter(0.6, q).creep - 1);
          const double next = 3 * share * change + 2e-9;
          EXPECT_TRUE(close(x.value(Quantity::creep) / law, 1, next)) << share;
          if (peclet >= 1) {
            EXPECT_GT(change, 10 * next) << "or it proves nothing";
          }
        }
}

// @eq:nearly-full with the slope of the reported slip velocity. What is left falls like b, down to
// the accuracy of the profile.
TEST(Ends, NearlyFullTraction) {
  for (const Formulation formulation : both)
    for (const double peclet : {1.0, 100.0})
      for (const double left : {1e-2, 1e-4, 1e-6}) {
        const Driven scene{0.6, 0.6 * (1 - left), peclet, 0.3};
        const CoupledSolution x = thermoroll::solve_coupled(scene, {formulation, 1e-8},
                                                            {Quantity::traction, scene.traction});
        const thermoroll::Profile profile = thermoroll::profile(x);
        const double c0 = x.value(Quantity::stick_slip_border), b = (1 + c0) / 2;
        Eigen::Index i = 0;
        while (profile.slip(i) == 0) ++i;
        const double s = profile.s(i), slope = profile.slip(i) / std::sqrt((1 + s) * (s - c0));
        const double law = std::sqrt(left * 2 * 0.6 / (thermoroll::pi * slope));
        EXPECT_TRUE(close(b / law, 1, 0.6 * b + 1e-6)) << "Pe = " << peclet << ", " << left;
      }
}

// Corners of all ranges, also of friction: a finite contact, or a refusal in one line. With little
// heat nothing is refused, and what comes out is Carter's creep up to what the heat can change. At
// f = 0.6 nothing is refused up to H = 1.
TEST(Ends, EveryCornerIsSolvedOrRefused) {
  for (const Formulation formulation : both)
    for (const double f : {1e-3, 0.6, 2.0})
      for (const double peclet : {1e-3, 1.0, 1e8})
        for (const double heating : {0.0, 1e-3, 1.0, 1e3})
          for (const double share : {1e-12, 0.5, 1 - 1e-12}) {
            SCOPED_TRACE(::testing::Message() << "f = " << f << ", Pe = " << peclet
                                              << ", H = " << heating << ", Q*/f = " << share);
            const double q = f * share, cold = thermoroll::carter(f, q).creep;
            try {
              const CoupledSolution x = thermoroll::solve_coupled(
                  {f, peclet, heating}, {formulation, 1e-3}, {Quantity::traction, q});
              EXPECT_TRUE(x.value.allFinite() && x.error.allFinite());
              EXPECT_TRUE(x.violations.empty());
              if (f * heating > 2e-3) continue;
              EXPECT_TRUE(close(x.value(Quantity::creep) / cold, 1, 1e-3 + f * heating));
            } catch (const std::runtime_error& refusal) {
              EXPECT_TRUE(f == 0.6 ? heating > 1 : f * heating > 2e-3) << refusal.what();
              EXPECT_EQ(std::string(refusal.what()).find('\n'), std::string::npos);
            }
          }
}
