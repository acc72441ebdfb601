#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "driven.hpp"
#include "reference.hpp"
#include "solver/contact_grid.hpp"
#include "solver/least_model.hpp"
#include "solver/surface.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/solution.hpp"
#include "thermoroll/temperature.hpp"

namespace {

using reference::close;
using thermoroll::Choice;
using thermoroll::CoupledSolution;
using thermoroll::Formulation;
using thermoroll::Method;
using thermoroll::Model;
using thermoroll::Prescribed;
using thermoroll::Quantity;
using thermoroll::Results;

// The sanitizers need not see every scene.
#ifdef NDEBUG
constexpr int thorough = 10;
#else
constexpr int thorough = 1;
#endif

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Formulation both[] = {Formulation::printed, Formulation::corrected};

// The difference of two solutions in units of what the tolerance is relative to; the place of the
// hottest point has a tolerance of its own.
double apart(const CoupledSolution& x, const CoupledSolution& y) {
  const Results off = (x.value - y.value).abs() / thermoroll::scale_of(y.value);
  return off.head(thermoroll::compared).maxCoeff();
}

CoupledSolution better(const Driven& scene, Formulation formulation, double tolerance) {
  return thermoroll::solve_coupled(scene, {formulation, tolerance},
                                   {Quantity::traction, scene.traction});
}

// Scenes of the ranges of @tbl:random-scenes, by a seed.
class Scenes {
 public:
  explicit Scenes(unsigned seed) : random_(seed) {}
  Driven next() {
    const double f = log_uniform(0.05, 1), q = f * log_uniform(0.01, 0.999);
    return {f, q, log_uniform(1e-2, 1e6), log_uniform(1e-4, 3)};
  }

 private:
  double log_uniform(double low, double high) {
    return low * std::pow(high / low, static_cast<double>(random_() >> 11) * 0x1p-53);
  }
  std::mt19937_64 random_;
};

// A scene, what is given of it, and a tolerance.
struct SmallContact {
  thermoroll::Scene scene;
  Prescribed given;
  double tolerance;
};

// Contacts small beside the roller, by a seed: H to a tenth, f from 0.03 to 1.5, Pe from 1e-3 to
// 1e8, and Carter's Q*/f or what it is short of one from 1e-4 to a half; all that can be given.
class SmallContacts {
 public:
  explicit SmallContacts(unsigned seed) : random_(seed) {}
  SmallContact next() {
    const double f = log_uniform(0.03, 1.5), part = log_uniform(1e-4, 0.5);
    const double share = random_() % 2 ? part : 1 - part;
    const thermoroll::Scene scene{f, log_uniform(1e-3, 1e8), log_uniform(2e-5, 0.1)};
    const Quantity all[] = {Quantity::traction, Quantity::creep, Quantity::stick_slip_border};
    const Quantity what = all[random_() % 3];
    const Results carter = thermoroll::carter_values(thermoroll::carter(f, f * share));
    return {scene, {what, carter(what)}, log_uniform(1e-8, 1e-2)};
  }

 private:
  double log_uniform(double low, double high) {
    return low * std::pow(high / low, static_cast<double>(random_() >> 11) * 0x1p-53);
  }
  std::mt19937_64 random_;
};

// h at the nodes of a rule; the heat flux is sqrt(left right) times it.
Eigen::ArrayXd flux_at(const thermoroll::GaussLegendre& rule, const CoupledSolution& x) {
  return thermoroll::legendre(rule.x, x.h.size()) * x.h;
}

std::string text(const Driven& x) {
  std::ostringstream out;
  out.precision(17);
  out << "f = " << x.friction << ", Q* = " << x.traction << ", Pe = " << x.peclet
      << ", H = " << x.heating;
  return out.str();
}

}  // namespace

// By the interpolated limit or by graded rules, to the tenth of the tolerance that is promised; the
// adaptive quadrature is good to 1e-9. The place is where the curve is flat.
TEST(LeastModel, TemperatureOfTheClosedForm) {
  for (const double peclet : {0.01, 1.0, 30.0, 1e3, 1e4, 1e6})
    for (const double share : {0.02, 0.8, 0.99}) {
      const Driven scene{0.6, 0.6 * share, peclet, 0};
      const thermoroll::HeatFlux flux =
          thermoroll::carter_flux(thermoroll::carter(0.6, scene.traction));
      const thermoroll::Peak peak = thermoroll::hottest_point(flux, peclet);
      for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-11}) {
        SCOPED_TRACE(text(scene) + ", digits " + std::to_string(-std::log10(tolerance)));
        const CoupledSolution x = thermoroll::closed_form(
            scene, {Formulation::corrected, tolerance}, {Quantity::traction, scene.traction});
        EXPECT_TRUE(close(x.value(Quantity::max_temperature) / peak.temperature.value, 1,
                          0.1 * tolerance + peak.temperature.error / peak.temperature.value));
        EXPECT_TRUE(close(x.value(Quantity::max_temperature_at), peak.at,
                          x.error(Quantity::max_temperature_at) + peak.at_error));
      }
    }
}

// At such speeds the rule for the temperature would have more nodes than any rule may.
TEST(LeastModel, AnswersAtAnySpeed) {
  const auto is_finite = [](double peclet, double heating, double tolerance, Method method) {
    const auto x = thermoroll::solve({0.6, peclet, heating}, {Quantity::traction, 0.3},
                                     {Formulation::corrected, tolerance, method});
    return x.value.allFinite() && x.error && x.error->allFinite();
  };
  for (const double peclet : {1e100, 1e160, 1e305}) {
    EXPECT_TRUE(is_finite(peclet, 1e-3, 1e-6, Method::automatic)) << peclet;
    for (const double tolerance : {1e-2, 1e-6, 1e-11})
      for (const Method method : {Method::closed_form, Method::first_order})
        EXPECT_TRUE(is_finite(peclet, 1e-6, tolerance, method)) << peclet << ' ' << tolerance;
  }
}

// Whatever the climb starts from, it ends at the top, and not at an end of the slip zone, where the
// slope by y is zero as well. The graded rules' errors are the same for all starts; what is left is
// what the last step, below 1e-5, leaves out.
TEST(LeastModel, ClimbsFromAnywhere) {
  const thermoroll::GaussLegendre& rule = thermoroll::gauss_legendre(64);
  for (double lambda = 1e-9; lambda < 1e9; lambda *= 10) {
    const double slip = 0.5, peclet = lambda / slip;
    const thermoroll::ZoneLengths zones{slip, 2 - slip};
    const Eigen::VectorXd h = thermoroll::carter_h(zones, 0.6);
    const thermoroll::HottestPoint top = thermoroll::find_hottest(zones, peclet, h, {}, rule);
    for (double y = -0.9; y < 0.95; y += 0.01)
      for (const double bend : {-0.3, -2.7}) {
        const auto again = thermoroll::find_hottest(zones, peclet, h, {y, 1, bend}, rule);
        EXPECT_TRUE(close(again.value / top.value, 1, 1e-9)) << lambda << ' ' << y << ' ' << bend;
        EXPECT_TRUE(close(again.y, top.y, 2e-5)) << lambda << ' ' << y << ' ' << bend;
      }
  }
  // A secant from here would end 1e-5 from an end, and rest there.
  const double f = 0.054926506659698594, q = 4.062535721915226e-10;
  const Driven scene{f, q, 4302.672662329718, 0};
  const auto x =
      thermoroll::closed_form(scene, {Formulation::corrected, 1e-4}, {Quantity::traction, q});
  const auto peak =
      thermoroll::hottest_point(thermoroll::carter_flux(thermoroll::carter(f, q)), scene.peclet);
  EXPECT_TRUE(close(x.value(Quantity::max_temperature) / peak.temperature.value, 1, 1e-5));
}

// The corrected temperature has no limit to lean on: with hardly any heat it is Carter's, by graded
// rules of any number, at any speed.
TEST(LeastModel, TemperatureOfTheFirstOrder) {
  for (const double peclet : {1.0, 1e4, 1e6, 1e8})
    for (const double share : {1e-3, 0.8, 1 - 1e-9})
      for (const double tolerance : {1e-2, 1e-3, 1e-6}) {
        const Driven scene{0.6, 0.6 * share, peclet, 1e-12};
        const Prescribed given{Quantity::traction, scene.traction};
        const auto exact = thermoroll::closed_form(scene, {Formulation::corrected, 1e-11}, given);
        const auto x = thermoroll::first_order(scene, {Formulation::corrected, tolerance}, given);
        EXPECT_TRUE(
            close(x.value(Quantity::max_temperature) / exact.value(Quantity::max_temperature), 1,
                  0.1 * tolerance + 1e-9))
            << text(scene) << ", tolerance " << tolerance;
      }
}

// Short slip zones and extreme speeds take more unknowns; what is stated covers them.
TEST(LeastModel, FirstOrderAtTheEndsOfTheRange) {
  for (const Formulation formulation : both)
    for (const double peclet : {1e2, 1e5, 5e7})
      for (const double share : {1e-4, 1e-6, 1e-8, 1e-10, 1 - 1e-9}) {
        Driven scene{0.6, 0.6 * share, peclet, 1};
        const Prescribed given{Quantity::traction, scene.traction};
        scene.heating =
            3e-3 / thermoroll::expected_change(scene, thermoroll::carter_given(0.6, given));
        const auto x = thermoroll::first_order(scene, {formulation, 1e-6}, given);
        const CoupledSolution exact = better(scene, formulation, 1e-8);
        const Results off = (x.value - exact.value).abs() / (x.error + exact.error);
        EXPECT_LE(off.head(thermoroll::compared).maxCoeff(), 1) << text(scene);
      }
}

// Ten times less heat, a hundred times less error; the third order is at most the heating, and the
// coupled solution is good to 1e-10, next to errors of 1e-6 and more.
TEST(LeastModel, FirstOrderIsOfSecondOrder) {
  for (const Formulation formulation : both)
    for (const double peclet : {1.0, 100.0, 4360.0}) {
      double error[2];
      for (const bool less : {false, true}) {
        const Driven scene{0.6, 0.4, peclet, less ? 0.01 : 0.1};
        const CoupledSolution x = thermoroll::first_order(scene, {formulation, 1e-10},
                                                          {Quantity::traction, scene.traction});
        error[less] = apart(x, better(scene, formulation, 1e-10));
      }
      EXPECT_GT(error[0], 1e-5) << "or it proves nothing";
      EXPECT_TRUE(close(error[0] / error[1], 100, 30)) << peclet;
    }
}

// Without heat the two lower rungs are the same, and the coupled solution is Carter's.
TEST(LeastModel, WithoutHeatAllRungsAgree) {
  for (const double share : {0.01, 0.5, 0.99}) {
    const Driven scene{0.6, 0.6 * share, 100, 0};
    const Prescribed given{Quantity::traction, scene.traction};
    const CoupledSolution exact = better(scene, Formulation::corrected, 1e-9);
    EXPECT_LT(apart(thermoroll::closed_form(scene, {Formulation::corrected, 1e-9}, given), exact),
              1e-9);
    EXPECT_LT(apart(thermoroll::first_order(scene, {Formulation::corrected, 1e-9}, given), exact),
              1e-9);
    EXPECT_EQ(thermoroll::least_model(scene, {Formulation::corrected, 1e-9}, given).model,
              Model::closed_form);
  }
}

// Up to both ends of the range Carter's closed form is within the errors that every rung states,
// for whatever is given. Carter's own rounding is added: four roundings, and what rounding of the
// given value does.
TEST(LeastModel, WithoutHeatErrorsCoverTheClosedForm) {
  for (double less = 0.25; less > 1e-12; less /= 10)
    for (const double share : {less, 1 - less})
      for (const auto quantity :
           {Quantity::traction, Quantity::creep, Quantity::stick_slip_border}) {
        const double f = 0.6;
        const thermoroll::Carter c = thermoroll::carter(f, f * share);
        const Prescribed given{quantity, thermoroll::carter_values(c)(quantity)};
        if (quantity == Quantity::creep && given.value >= 2 * f / thermoroll::pi) continue;
        const thermoroll::Carter exact = thermoroll::carter_given(f, given);
        const Results closed = thermoroll::carter_values(exact);
        const Results scale = thermoroll::scale_of(closed);
        const double of_given =
            thermoroll::rounding(given, thermoroll::carter_slope(exact, quantity), scale);
        const Results own = scale * (of_given + 4 * std::numeric_limits<double>::epsilon());
        const Driven scene{f, f / 2, 3, 0};
        for (const double tolerance : {1e-3, 1e-6}) {
          const CoupledSolution solutions[] = {
              thermoroll::closed_form(scene, {Formulation::corrected, tolerance}, given),
              thermoroll::first_order(scene, {Formulation::corrected, tolerance}, given),
              thermoroll::solve_coupled(scene, {Formulation::corrected, tolerance}, given),
              thermoroll::least_model(scene, {Formulation::corrected, tolerance}, given).solution};
          for (int k = 0; k < 4; ++k)
            for (int i = 0; i + 1 < thermoroll::compared; ++i)
              EXPECT_TRUE(close(solutions[k].value[i], closed[i], solutions[k].error[i] + own[i]))
                  << "rung " << k << ", quantity " << i << ", given " << static_cast<int>(quantity)
                  << " = " << std::scientific << given.value << " at share " << share
                  << ", tolerance " << tolerance;
        }
      }
}

// What both lower rungs say of their own error covers it, in every scene in which they are of use.
TEST(LeastModel, FirstOrderErrorIsHonest) {
  Scenes scenes(2002);
  int used[2] = {0, 0};
  for (int i = 0; i < 60 * thorough; ++i) {
    const Driven scene = scenes.next();
    const Formulation formulation = both[i % 2];
    const Prescribed given{Quantity::traction, scene.traction};
    const CoupledSolution rungs[] = {thermoroll::closed_form(scene, {formulation, 1e-7}, given),
                                     thermoroll::first_order(scene, {formulation, 1e-7}, given)};
    if (thermoroll::largest_error(rungs[1]) > 0.1) continue;
    const CoupledSolution exact = better(scene, formulation, 1e-8);
    for (const int k : {0, 1}) {
      ++used[k];
      const double off = ((rungs[k].value - exact.value).abs() / (rungs[k].error + exact.error))
                             .head(thermoroll::compared)
                             .maxCoeff();
      EXPECT_LE(off, 1) << "rung " << k << ": " << text(scene);
    }
  }
  EXPECT_GT(used[0], 40 * thorough);
}

// What the closed form says of the error of its temperatures, which are those of its flux, covers
// the change of the flux in the mean over the heat, at the same share of the slip zone, though much
// of it cancels in every sum.
TEST(LeastModel, ClosedFormErrorCoversTheFluxInTheMean) {
  const thermoroll::GaussLegendre& rule = thermoroll::gauss_legendre(60);
  int beyond_sums = 0;
  for (const Formulation formulation : both)
    for (const double border : {-0.5, 0.5, 0.95})
      for (const double lambda : {1.0, 10.0, 1000.0}) {
        const thermoroll::Carter c =
            thermoroll::carter_given(0.6, {Quantity::stick_slip_border, border});
        const double q = thermoroll::carter_values(c)(Quantity::traction), slip = 1 - border;
        const Driven scene{0.6, q, lambda / slip, 0.1};
        const CoupledSolution cold =
            thermoroll::closed_form(scene, {formulation, 1e-7}, {Quantity::traction, q});
        const CoupledSolution hot = better(scene, formulation, 1e-8);
        const Eigen::ArrayXd weight = thermoroll::place_nodes({slip, 1 + border}, rule, rule).heat;
        const Eigen::ArrayXd before = flux_at(rule, cold), after = flux_at(rule, hot);
        const double moved = (weight * (after - before).abs()).sum() / (weight * before).sum();
        const Quantity top = Quantity::max_temperature;
        EXPECT_LE(moved, cold.error(top) / cold.value(top)) << text(scene);
        if (moved > 1.5 * apart(cold, hot)) ++beyond_sums;
      }
  EXPECT_GT(beyond_sums, 0) << "else the quantities would do";
}

// @eq:first-order-error: where the flux at a node changes by as much as there is, the changes need
// not shrink, though every sum changes by less, and no error is known.
TEST(LeastModel, FirstOrderKnowsNoErrorWhereTheFluxAtANodeIsAnother) {
  int beyond = 0, below = 0;
  for (const Formulation formulation : both)
    for (const double peclet : {10.0, 1e3, 1e5, 1e7})
      for (const double heating : {1e-2, 1e-1, 0.3, 1.0}) {
        const Driven scene{0.6, 0.3, peclet, heating};
        const Prescribed given{Quantity::stick_slip_border, 0};
        const CoupledSolution cold = thermoroll::closed_form(scene, {formulation, 1e-7}, given);
        const CoupledSolution hot = thermoroll::first_order(scene, {formulation, 1e-7}, given);
        const thermoroll::GaussLegendre& rule = thermoroll::gauss_legendre(hot.unknowns);
        const Eigen::ArrayXd before = flux_at(rule, cold), after = flux_at(rule, hot);
        const double r = (after - before).abs().maxCoeff() / before.maxCoeff();
        if (r < 1) ++below;
        if (r < 1 || apart(cold, hot) >= 1) continue;
        ++beyond;
        EXPECT_EQ(thermoroll::largest_error(hot), infinity) << text(scene);
      }
  EXPECT_GT(beyond, 0);
  EXPECT_GT(below, 0);
}

// In contacts that are small beside the roller, H is at most a tenth. There at most a thousandth of
// the true errors exceed what both lesser models state, and none exceeds it twice. In the middle of
// the scenes the largest stated error is at most ten times the largest true one.
TEST(LeastModel, ErrorsCoverWhatIsLeftOut) {
  SmallContacts contacts(11);
  int values[2] = {0, 0}, beyond[2] = {0, 0};
  std::vector<double> ratios[2];
  for (int i = 0; i < 60 * thorough; ++i) {
    const SmallContact x = contacts.next();
    CoupledSolution exact;
    try {
      exact = thermoroll::solve_coupled(x.scene, {both[i % 2], 1e-9}, x.given);
    } catch (const std::exception&) {  // refused by name
      continue;
    }
    const Results scale = thermoroll::scale_of(exact.value);
    const CoupledSolution rungs[] = {
        thermoroll::closed_form(x.scene, {both[i % 2], 1e-9}, x.given),
        thermoroll::first_order(x.scene, {both[i % 2], 1e-9}, x.given)};
    for (const int k : {0, 1}) {
      const CoupledSolution& rung = rungs[k];
      const Results off = (rung.value - exact.value).abs() - exact.error;
      for (int what = 0; what < thermoroll::compared; ++what) {
        ++values[k];
        if (off[what] > rung.error[what]) ++beyond[k];
        EXPECT_LE(off[what], 2 * rung.error[what])
            << "rung " << k << ", quantity " << what << ": scene " << i;
      }
      const double most = (off / scale).head(thermoroll::compared).maxCoeff();
      if (most > 10 * thermoroll::largest_error(exact))
        ratios[k].push_back(thermoroll::largest_error(rung) / most);
    }
  }
  for (const int k : {0, 1}) {
    EXPECT_LE(beyond[k], 1e-3 * values[k]) << "rung " << k;
    ASSERT_GT(ratios[k].size(), 15u * thorough) << "rung " << k;
    const auto middle = ratios[k].begin() + static_cast<std::ptrdiff_t>(ratios[k].size() / 2);
    std::nth_element(ratios[k].begin(), middle, ratios[k].end());
    EXPECT_LE(*middle, 10) << "rung " << k;
  }
}

// A rung is seldom tried in vain, and seldom left out: in one scene of twenty at most, of small
// contacts with tolerances between 1e-8 and 1e-2.
TEST(LeastModel, ForecastsSeldomFail) {
  SmallContacts contacts(12);
  const int scenes = 50 * thorough;
  int in_vain[2] = {0, 0}, left_out[2] = {0, 0};
  for (int i = 0; i < scenes; ++i) {
    const SmallContact x = contacts.next();
    const thermoroll::Carter c = thermoroll::carter_given(x.scene.friction, x.given);
    const auto closed = thermoroll::closed_form(x.scene, {both[i % 2], x.tolerance}, x.given);
    const auto first = thermoroll::first_order(x.scene, {both[i % 2], x.tolerance}, x.given);
    const double change = thermoroll::expected_change(x.scene, c);
    const double forecast[] = {change, thermoroll::expected_second_order(change)};
    const double error[] = {thermoroll::largest_error(closed), thermoroll::largest_error(first)};
    for (const int k : {0, 1}) {
      if (forecast[k] <= x.tolerance && error[k] > x.tolerance) ++in_vain[k];
      if (forecast[k] > x.tolerance && error[k] <= x.tolerance) ++left_out[k];
    }
  }
  for (const int k : {0, 1}) {
    EXPECT_LE(in_vain[k], scenes / 20) << "rung " << k;
    EXPECT_LE(left_out[k], scenes / 20) << "rung " << k;
  }
}

// Each result has an error of its own: in the paper's scene the second order moves the border ten
// times as far as gamma0, and the load ratio in between.
TEST(LeastModel, EveryQuantityHasItsOwnError) {
  const Prescribed given{Quantity::traction, 0.5};
  const auto x =
      thermoroll::first_order({0.6, 4360, 0.0175}, {Formulation::corrected, 1e-6}, given);
  EXPECT_LT(x.error(Quantity::gamma0), 0.1 * x.error(Quantity::stick_slip_border));
  EXPECT_LT(x.error(Quantity::load_ratio), 0.3 * x.error(Quantity::stick_slip_border));
}

// Sixteen unknowns, and more where it is fast or the slip zone short, resolve the correction to
// 1e-3, of which the error counts twice; r is what heat changes, of which the second order is left
// out. Both solutions are good to 1e-9.
TEST(LeastModel, FirstOrderIsResolvedEverywhere) {
  for (const Formulation formulation : both)
    for (const double peclet : {1.0, 1e4, 1e8, 1e10})
      for (const double share : {1e-12, 1e-9, 1e-7, 1e-3, 0.5, 0.999}) {
        Driven scene{0.6, 0.6 * share, peclet, 1};
        const Prescribed given{Quantity::traction, scene.traction};
        scene.heating =
            3e-5 / thermoroll::expected_change(scene, thermoroll::carter_given(0.6, given));
        const CoupledSolution x = thermoroll::first_order(scene, {formulation, 1e-9}, given);
        const CoupledSolution cold = thermoroll::closed_form(scene, {formulation, 1e-9}, given);
        const CoupledSolution exact = better(scene, formulation, 1e-9);
        const double r = apart(cold, exact);
        EXPECT_LE(apart(x, exact), 2e-3 * r + 2 * r * r + 2e-9) << text(scene);
      }
}

// Where the slip zone is the shortest part of the contact, the correction is small and its own
// error a larger part of it, at low speed above all: what is stated covers it.
TEST(LeastModel, FirstOrderErrorCoversTheShortestSlipZones) {
  for (const Formulation formulation : both)
    for (const double share : {1e-6, 1e-8, 1e-10, 1e-12})
      for (const double lambda : {1e-5, 1e-3, 0.1}) {
        const double f = 0.06;
        const thermoroll::Carter c = thermoroll::carter(f, f * share);
        Driven scene{f, f * share, lambda / (2 * c.slip_half_width), 1};
        scene.heating = 0.01 / thermoroll::expected_change(scene, c);
        const CoupledSolution x = thermoroll::first_order(scene, {formulation, 1e-8},
                                                          {Quantity::traction, scene.traction});
        const CoupledSolution exact = better(scene, formulation, 1e-9);
        const Results off = (x.value - exact.value).abs() / (x.error + exact.error);
        EXPECT_LE(off.head(thermoroll::compared).maxCoeff(), 1) << text(scene);
      }
}

// At creeps just below full slip the grid of the correction resolves border and moments less well.
TEST(LeastModel, FirstOrderErrorCoversTheShortestStickZones) {
  for (const auto& [f, peclet, heating, missing] :
       {std::array{1.232208834696, 0.01148803, 4.5276e-4, 1.1323e-6},
        std::array{0.725, 0.0119, 1.56e-4, 6.5e-7}, std::array{0.123, 3.04, 1.78e-5, 1.4e-6}}) {
    const Prescribed given{Quantity::creep, 2 * f / thermoroll::pi * (1 - missing)};
    const thermoroll::Scene scene{f, peclet, heating};
    const CoupledSolution x = thermoroll::first_order(scene, {Formulation::corrected, 1e-6}, given);
    const CoupledSolution y =
        thermoroll::solve_coupled(scene, {Formulation::corrected, 1e-10}, given);
    for (int i = 0; i < thermoroll::compared; ++i)
      EXPECT_LE(std::abs(x.value[i] - y.value[i]), x.error[i] + y.error[i]) << f << ' ' << i;
  }
}

// Near full slip the correction may leave a hair of the stick zone beside the border with a
// traction above friction. Asked for by name it says so; the ladder goes on to the coupled problem,
// whose solution is a contact.
TEST(LeastModel, NoContactIsNotLeftToTheFirstOrder) {
  for (const Formulation formulation : both) {
    const Driven scene{0.6, 0.59999999998889564, 31077666.175244953, 0.17847687135653784};
    const Prescribed given{Quantity::traction, scene.traction};
    const CoupledSolution x = thermoroll::first_order(scene, {formulation, 1e-7}, given);
    ASSERT_EQ(x.violations.size(), 1u);
    EXPECT_LE(std::abs(x.violations[0].from - x.value(Quantity::stick_slip_border)), 1e-4);
    const double tolerance = 1e-2;
    ASSERT_LE(thermoroll::largest_error(x), tolerance) << "or its error alone rules it out";
    const Choice choice = thermoroll::least_model(scene, {formulation, tolerance}, given);
    EXPECT_EQ(choice.model, Model::coupled);
    EXPECT_TRUE(choice.solution.violations.empty());
  }
}

// A creep at which the surfaces without heat just stick, and with it slip all over: the lesser
// models know no error to state, and the ladder ends at the coupled problem.
TEST(LeastModel, KnowsNoErrorWhereHeatTakesTheStickZone) {
  for (const Formulation formulation : both)
    for (const double peclet : {1.0, 100.0, 1e4}) {
      const Driven scene{0.6, 0.3, peclet, 1e-4};
      const Prescribed given{Quantity::creep, 1.2 / thermoroll::pi * (1 - 1e-9)};
      for (const auto rung : {thermoroll::closed_form, thermoroll::first_order})
        EXPECT_EQ(rung(scene, {formulation, 1e-3}, given).error(Quantity::load_ratio), infinity);
      const Choice choice = thermoroll::least_model(scene, {formulation, 1e-3}, given);
      EXPECT_EQ(choice.model, Model::coupled);
      EXPECT_EQ(choice.solution.value(Quantity::stick_slip_border), -1);
    }
}

// The axis lies off the middle by pi gamma0 / (2 kappa), on every rung.
TEST(LeastModel, EccentricityIsThatOfLoadAndGamma) {
  const Driven scene{0.6, 0.3, 100, 0.3};
  const Prescribed given{Quantity::traction, scene.traction};
  for (const auto solve :
       {thermoroll::closed_form, thermoroll::first_order, thermoroll::solve_coupled}) {
    const CoupledSolution x = solve(scene, {Formulation::corrected, 1e-4}, given);
    const double kappa = x.value(Quantity::load_ratio), gamma0 = x.value(Quantity::gamma0);
    EXPECT_DOUBLE_EQ(x.value(Quantity::eccentricity), thermoroll::pi * gamma0 / (2 * kappa));
  }
  EXPECT_NE(thermoroll::first_order(scene, {Formulation::corrected, 1e-4}, given)
                .value(Quantity::load_ratio),
            1)
      << "else kappa would not count";
}

// The true error meets the tolerance, by a coupled solution ten times better.
TEST(LeastModel, MeetsEveryTolerance) {
  Scenes scenes(1);
  int compared = 0;
  for (int i = 0; i < 90 * thorough; ++i) {
    const Driven scene = scenes.next();
    const Formulation formulation = both[i % 2];
    const double tolerance = i % 3 == 0 ? 1e-2 : i % 3 == 1 ? 1e-3 : 1e-6;
    try {
      const Choice x = thermoroll::least_model(scene, {formulation, tolerance},
                                               {Quantity::traction, scene.traction});
      EXPECT_LE(thermoroll::largest_error(x.solution), tolerance) << text(scene);
      EXPECT_LE(apart(x.solution, better(scene, formulation, tolerance / 10)), 1.1 * tolerance)
          << text(scene) << ": " << x.reason;
      ++compared;
    } catch (const std::runtime_error&) {  // refused by name
    }
  }
  EXPECT_GT(compared, 85 * thorough);
}

// What is told of errors counts every quantity, the temperature as well; only the place of the
// hottest point has a tolerance of its own.
TEST(LeastModel, EveryQuantityCountsInTheLargestDifference) {
  const Results exact = better({0.6, 0.5, 100, 1}, Formulation::corrected, 1e-4).value;
  EXPECT_EQ(thermoroll::largest_difference(exact, exact), 0);
  for (int what = 0; what < exact.size(); ++what) {
    Results x = exact;
    x[what] += 1e-3 * thermoroll::scale_of(exact)[what];
    const double counted = what < static_cast<int>(Quantity::max_temperature_at) ? 1e-3 : 0;
    EXPECT_NEAR(thermoroll::largest_difference(x, exact), counted, 1e-12) << what;
  }
}

// The paper's scene, and that more heat or a smaller tolerance never takes a lesser model.
TEST(LeastModel, TakesTheRungsInTurn) {
  const Prescribed given{Quantity::traction, 0.5};
  const auto model = [&](double heating, double tolerance) {
    return thermoroll::least_model({0.6, 4360, heating}, {Formulation::corrected, tolerance}, given)
        .model;
  };
  EXPECT_EQ(model(0.0175, 1e-2), Model::closed_form);
  EXPECT_EQ(model(0.0175, 1e-3), Model::first_order);
  EXPECT_EQ(model(0.0175, 1e-4), Model::first_order);
  EXPECT_EQ(model(0.0175, 1e-6), Model::coupled);
  for (const double tolerance : {1e-2, 1e-3, 1e-6}) {
    Model last = Model::closed_form;
    for (double heating = 1e-8; heating < 3; heating *= 1.5) {
      const Model now = model(heating, tolerance);
      EXPECT_GE(now, last) << heating << ", " << tolerance;
      EXPECT_LE(now, model(heating, tolerance / 10)) << heating << ", " << tolerance;
      last = now;
    }
    EXPECT_EQ(last, Model::coupled);
  }
}

// From 2 f / pi on the least model is the closed form of full slip. Each of its errors is compared
// with a coupled solution that is a hundred times better; where it is taken, it has the tolerance.
TEST(LeastModel, FullSlipHasAClosedForm) {
  std::mt19937_64 random(20261129);
  const auto log_uniform = [&](double low, double high) {
    return low * std::pow(high / low, static_cast<double>(random() >> 11) * 0x1p-53);
  };
  int taken = 0;
  for (int i = 0; i < 20 * thorough; ++i) {
    const double f = log_uniform(0.03, 1.5), beyond = log_uniform(1e-3, 10);
    thermoroll::Scene scene{f, log_uniform(1e-3, 1e8), log_uniform(2e-5, 0.1)};
    if (i % 3 == 0) scene.direction = thermoroll::Direction::braking;
    if (i % 2 == 0) scene.roller = {log_uniform(0.1, 10), scene.heating * log_uniform(0.1, 10)};
    const Prescribed given{Quantity::creep, 2 * f / thermoroll::pi * (1 + beyond)};
    const double tolerance = log_uniform(1e-6, 1e-2);
    const Choice x = thermoroll::least_model(scene, {Formulation::corrected, tolerance}, given);
    if (x.model != Model::closed_form) continue;
    ++taken;
    const CoupledSolution exact =
        thermoroll::solve_coupled(scene, {Formulation::corrected, tolerance / 100}, given);
    for (int k = 0; k < thermoroll::compared; ++k)
      EXPECT_LE(std::abs(x.solution.value[k] - exact.value[k]),
                x.solution.error[k] + exact.error[k])
          << i << ", quantity " << k;
    EXPECT_LE(apart(x.solution, exact), 1.01 * tolerance) << i;
  }
  EXPECT_GT(taken, 5 * thorough);
}

// Braked, a contact of H = 0.02 sticks a little at creeps at which all would slip without heat. The
// closed form counts the zone as an error of the border, and is not taken where that is too large.
TEST(LeastModel, FullSlipIsNotTakenForGrantedNextToItsBeginning) {
  thermoroll::Scene scene{0.6, 100, 0.02};
  scene.direction = thermoroll::Direction::braking;
  const Prescribed given{Quantity::creep, 2 * scene.friction / thermoroll::pi * (1 + 1e-4)};
  const CoupledSolution exact =
      thermoroll::solve_coupled(scene, {Formulation::corrected, 1e-6}, given);
  const double sticks = 1 + exact.value(Quantity::stick_slip_border);
  ASSERT_GT(sticks, 1e-3);
  const CoupledSolution x = thermoroll::closed_form(scene, {Formulation::corrected, 1e-2}, given);
  EXPECT_GE(x.error(Quantity::stick_slip_border), sticks);
  EXPECT_GE(x.error(Quantity::traction),
            scene.friction - exact.value(Quantity::traction) - exact.error(Quantity::traction));
  EXPECT_EQ(thermoroll::least_model(scene, {Formulation::corrected, 1e-3}, given).model,
            Model::coupled);
}

// In a slow contact heat spreads before it strains: the change goes with the Péclet number of the
// slip zone, so that the closed form does at a low speed, however large H is.
TEST(LeastModel, SlowContactsNeedNoHeat) {
  const Prescribed given{Quantity::traction, 0.3};
  for (const double peclet : {1e-4, 1e-6, 1e-8})
    for (const double heating : {0.1, 1.0}) {
      const thermoroll::Scene scene{0.6, peclet, heating};
      EXPECT_EQ(thermoroll::least_model(scene, {Formulation::corrected, 1e-2}, given).model,
                Model::closed_form)
          << peclet << ", " << heating;
    }
}

// A creep or a border in place of the traction is met exactly, and leads back to the traction.
TEST(LeastModel, TakesCreepOrBorder) {
  for (const double heating : {1e-4, 0.0175, 0.3})
    for (const double tolerance : {1e-2, 1e-3, 1e-6}) {
      const Driven scene{0.6, 0.5, 100, heating};
      const CoupledSolution exact = better(scene, Formulation::corrected, 1e-8);
      for (const auto quantity : {Quantity::creep, Quantity::stick_slip_border}) {
        const Prescribed given{quantity, exact.value(quantity)};
        const Choice x = thermoroll::least_model(scene, {Formulation::corrected, tolerance}, given);
        EXPECT_EQ(x.solution.value(quantity), given.value);
        EXPECT_LE(apart(x.solution, exact), 1.1 * tolerance)
            << heating << ", " << static_cast<int>(quantity);
      }
    }
}

TEST(LeastModel, RefusesWhatItCannotSolve) {
  const Driven scene{0.6, 0.5, 100, 0.1};
  const auto solve = [&](double tolerance, const Prescribed& given) {
    thermoroll::least_model(scene, {Formulation::corrected, tolerance}, given);
  };
  EXPECT_THROW(solve(1e-12, {Quantity::traction, 0.5}), std::invalid_argument);
  EXPECT_THROW(  // on the lowest rung as well
      thermoroll::least_model({0.6, 100, 0}, {Formulation::corrected, 9e-12},
                              {Quantity::traction, 0.5}),
      std::invalid_argument);
  EXPECT_THROW(solve(1e-3, {Quantity::traction, 0.6}), std::invalid_argument);
  EXPECT_THROW(solve(1e-3, {Quantity::creep, -0.1}), std::invalid_argument);
  EXPECT_THROW(solve(1e-3, {Quantity::heat_integral, 0.1}), std::invalid_argument);
  const auto rungs = {thermoroll::closed_form, thermoroll::first_order};
  for (const auto rung : rungs)
    for (const Prescribed& given :
         {Prescribed{Quantity::max_temperature, 0.1}, Prescribed{Quantity::load_ratio, 0.1},
          Prescribed{Quantity::stick_slip_border, 2}, Prescribed{Quantity::creep, -0.1},
          Prescribed{Quantity::traction, 0.6}, Prescribed{Quantity::traction, 0},
          Prescribed{Quantity::traction, -0.1}})
      EXPECT_THROW(rung(scene, {Formulation::corrected, 1e-3}, given), std::invalid_argument)
          << static_cast<int>(given.quantity) << ' ' << given.value;
  EXPECT_THROW(  // in full slip
      thermoroll::first_order(scene, {Formulation::corrected, 1e-3}, {Quantity::creep, 0.5}),
      std::invalid_argument);
}

// The rules of the correction have more nodes for faster slip zones, and no more than there can be.
TEST(LeastModel, NoSpeedHasTooManyNodes) {
  for (const double peclet : {1e100, 1e106, 1e200}) {
    const thermoroll::Scene scene{0.6, peclet, 1e-12};
    const CoupledSolution x =
        least_model(scene, {Formulation::corrected, 1e-6}, {Quantity::traction, 0.5}).solution;
    EXPECT_TRUE(x.value.allFinite() && x.error.allFinite()) << peclet;
  }
}

// A traction next to friction has lost digits of what it is less by, and the border is as sensitive
// to it: four steps of the last bit, of the five that the error allows for, move it by 7e-10.
TEST(LeastModel, ErrorsCoverTheLastBitsOfTheTraction) {
  const double f = 0.3, q = f * (1 - 1e-12);
  double less = q;
  for (int i = 0; i < 4; ++i) less = std::nextafter(less, 0);
  const auto expect_covered = [](const CoupledSolution& a, const CoupledSolution& b) {
    for (const auto i : {Quantity::stick_slip_border, Quantity::creep, Quantity::heat_integral}) {
      EXPECT_NE(a.value(i), b.value(i));
      EXPECT_LE(std::abs(a.value(i) - b.value(i)), a.error(i)) << static_cast<int>(i);
    }
  };
  for (const double heating : {1e-12, 1e-9}) {
    const Driven at{f, q, 100, heating}, near{f, less, 100, heating};
    expect_covered(
        thermoroll::solve_coupled(at, {Formulation::corrected, 1e-6}, {Quantity::traction, q}),
        thermoroll::solve_coupled(near, {Formulation::corrected, 1e-6},
                                  {Quantity::traction, less}));
    expect_covered(
        thermoroll::least_model(at, {Formulation::corrected, 3e-9}, {Quantity::traction, q})
            .solution,
        thermoroll::least_model(near, {Formulation::corrected, 3e-9}, {Quantity::traction, less})
            .solution);
  }
}
