#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "driven.hpp"
#include "first_order.hpp"
#include "reference.hpp"
#include "studies/claims.hpp"
#include "studies/figure_data.hpp"
#include "studies/paper_scene.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/published_scheme.hpp"
#include "thermoroll/temperature.hpp"

namespace {

using reference::close;
using reference::Real;
using thermoroll::Claim;
using thermoroll::verdict;
using thermoroll::verdict_on;

constexpr double friction = 0.6, heating = 0.0175;  // what claims.hpp uses

/// Computed once: two seconds of work.
const std::vector<Claim>& claims() {
  static const std::vector<Claim> table = thermoroll::claims();
  return table;
}

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
    // At Pe = 100 and n = 400 the kernel is resolved to 0.44 (h Pe)^2/16 = 0.017 and f H = 0.01 is
    // the next order in H.
    const reference::FirstOrder finite = reference::first_order(traction, 100);
    thermoroll::PublishedOptions options;
    options.nodes = 400;
    const thermoroll::PublishedSolution x = solve_published(
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

// What the claims are set against is good to eight digits, each quantity to what its tolerance is
// relative to.
TEST(Claims, ConvergedMeansEightDigits) {
  for (const double traction : thermoroll::paper::tractions)
    for (const double peclet : thermoroll::paper::peclets) {
      const thermoroll::CoupledSolution x = thermoroll::paper::coupled(traction, peclet);
      const thermoroll::Results relative = x.error / thermoroll::scale_of(x.value);
      EXPECT_LE(relative.head(thermoroll::compared).maxCoeff(), 1e-8) << traction << ", " << peclet;
    }
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
  EXPECT_TRUE(close(thermoroll::speed_at(5000), 1.4e-5L * 2 * 5000 / 5.5e-3L, 1e-12L));
  EXPECT_TRUE(close(thermoroll::celsius_per_unit_at(5000) * 0.00205267, 283.7, 0.05));
  EXPECT_TRUE(close(thermoroll::celsius_per_unit_at(10000) * 0.00145145, 401.3, 0.05));
  EXPECT_TRUE(close(thermoroll::celsius_per_unit_at(15000) * 0.00118511, 491.4, 0.05));
}

// A row of the table by words of its claim.
const Claim& claim_on(const std::string& words) {
  const auto found = std::find_if(claims().begin(), claims().end(), [&](const Claim& c) {
    return c.claim.find(words) != std::string::npos;
  });
  if (found == claims().end()) throw std::invalid_argument(words);
  return *found;
}

// 278 degrees C over a rail of 27 stay below 727, and so does the scheme's value.
TEST(Claims, PhaseTransformationIsJudgedAtThePapersTemperature) {
  EXPECT_TRUE(close(thermoroll::celsius_per_unit(75) * 0.00118511, 491.44 * 75 / 76.3636, 0.05));
  const Claim& phases = claim_on("phase transformation");
  const double rise = std::stod(claim_on("25 m/s, °C").converged);
  EXPECT_NEAR(rise, 283.7 * 25 / 25.4545, 0.5);
  EXPECT_EQ(phases.converged, rise + 27 < 727 ? "yes" : "no");
  EXPECT_EQ(phases.verdict.words, "holds");
}

// Equal largest pressures: 3 N/(2 pi a b) = 2 P/(pi a). The wheel's radius is 0.229 m.
TEST(Claims, LoadOfTheEllipseIsAMisprint) {
  const Claim& load = claim_on("load of the ellipse");
  const double across = std::stod(load.converged.substr(load.converged.find("of ") + 3));
  EXPECT_NEAR(3 * std::stod(load.paper) / (2 * across), 2 * 1.2e7, 0.005 / across * 2.4e7);
  EXPECT_GT(across, 0.229);
  EXPECT_EQ(load.verdict.outcome, thermoroll::Judgement::fails);
  EXPECT_LT(across / 100, 0.229);
  EXPECT_EQ(load.verdict.words, "does not hold: a hundredth of it gives 9.2 mm");
}

// The traction's peak is at most the pressure's, f 2/pi, up to what heat does to that; the slip is
// Carter's at s = 1, (4 f/pi) sqrt(1 - b) with b^2 = 1 - Q*/f, up to fH; the temperature is that of
// the table of Temperature.TableOfMaxima, up to the same.
TEST(Claims, FiguresEndWithinTheirAxes) {
  const double b = std::sqrt(1 - 0.59 / friction), much = 3 * friction * heating;
  for (const bool printed : {true, false}) {
    const auto of = [&](const std::string& words) {
      return std::stod(printed ? claim_on(words).converged : claim_on(words).corrected);
    };
    EXPECT_TRUE(close(of("largest traction q*") / (friction * 2 / reference::pi), 1, much));
    EXPECT_TRUE(close(
        of("largest slip velocity") / (4 * friction / reference::pi * std::sqrt(1 - b)), 1, much));
    EXPECT_TRUE(close(of("largest T* drawn, Pe") / 0.00697107, 1, much));
  }
  for (const char* words : {"largest traction q*", "largest slip velocity",
                            "largest T* drawn, four", "largest T* drawn, Pe"})
    EXPECT_EQ(claim_on(words).verdict.words, "holds, as far as its axis tells") << words;
}

// The largest number in a cell such as "p* by 0.26 %, q* by 2.8 %, c0 by 0.0008", behind a symbol.
double behind(const std::string& cell, const std::string& symbol) {
  return std::stod(cell.substr(cell.find(symbol + " by ") + symbol.size() + 4));
}

// To first order heat moves the pressure by f H v* p* sqrt(1 - s^2) and less, and the border by
// less than f H. A shift d of the border changes q*, which rises there from f p* like b sqrt(2 (c0
// - s)/b) f 2/pi, by sqrt(2 d b) of its peak at most; 1 for what a shift leaves out.
TEST(Claims, HeatChangesTheTractionsLittle) {
  const Claim& claim = claim_on("on normal and tangential traction");
  for (const std::string& cell : {claim.converged, claim.corrected}) {
    const double border = behind(cell, "c0");
    EXPECT_GT(border, 0);
    EXPECT_LT(border, friction * heating);
    EXPECT_LT(behind(cell, "p*"), 100 * friction * heating);
    EXPECT_LT(behind(cell, "q*"), 100 * std::sqrt(2 * (border + 5e-5)) + 1);
    EXPECT_GT(behind(cell, "q*"), 1) << "next to the border";
  }
  EXPECT_EQ(claim.verdict.words, "holds, but for q* next to the border");
}

// Half of the heat flows into either of two identical bodies. What heat does to the slip changes
// with the strain, by fH = 0.01 of it at most.
TEST(Claims, TwoBodiesAreHalfAsHot) {
  const Claim& pair = claim_on("both bodies may conduct");
  EXPECT_EQ(pair.paper, "future work");
  EXPECT_NEAR(std::stod(pair.corrected), 0.5, 0.005);
  EXPECT_EQ(pair.verdict.words, "computed: half as hot");
}

// The friction there is 0.6, and Carter's contact slips everywhere at the creep 2 f / pi = 0.382.
// The hottest point has lost less than half of its friction, so that the contact has more than half
// left.
TEST(Claims, HotFrictionHasALargestTraction) {
  const Claim& hot = claim_on("friction may depend on temperature");
  EXPECT_EQ(hot.paper, "possible");
  const double largest = std::stod(hot.corrected);
  EXPECT_GT(largest, 0.3);
  EXPECT_LT(largest, 0.6);
  const std::size_t creep = hot.corrected.rfind(' ');
  EXPECT_LT(std::stod(hot.corrected.substr(creep)), 0.382);
  EXPECT_EQ(hot.verdict.words.substr(0, 8), "computed");
}

// The limits of the rule: half a per cent, and half a unit of the paper's last digit.
TEST(Claims, NumbersHoldToHalfAPerCentOrRounded) {
  EXPECT_EQ(verdict_on("200", 200).words, "holds");
  for (const double sign : {-1.0, 1.0}) {
    const double inside = 1.5 / (1 + sign * 0.00499), outside = 1.5 / (1 + sign * 0.00501);
    EXPECT_EQ(verdict_on("1.500", inside).words, "holds") << sign;
    EXPECT_EQ(verdict_on("1.500", outside).words,
              sign > 0 ? "paper 0.5 % high" : "paper 0.5 % low");
  }
  // 0.002 is what 0.0015 ... 0.0025 rounds to, and 25 what 24.5 ... 25.5 does.
  EXPECT_EQ(verdict_on("0.002", 0.0015001).words, "holds, rounded");
  EXPECT_EQ(verdict_on("0.002", 0.0024999).words, "holds, rounded");
  EXPECT_EQ(verdict_on("0.002", 0.0014999).words, "not reproduced: 33.3 % high");
  EXPECT_EQ(verdict_on("0.002", 0.0025001).words, "not reproduced: 20.0 % low");
  // Five per cent part what is near from what is not reproduced.
  EXPECT_EQ(verdict_on("100.0", 100 / 1.0499).words, "paper 5.0 % high");
  EXPECT_EQ(verdict_on("100.0", 100 / 1.0501).words, "not reproduced: 5.0 % high");
  EXPECT_EQ(verdict_on("25", 25.49).words, "holds, rounded");
  EXPECT_EQ(verdict_on("25", 25.51).words, "paper 2.0 % low");
  EXPECT_EQ(verdict_on("25", 24.49).words, "paper 2.1 % high");
  // More digits promise more: the same value, given as 2.0, is not rounded from 2.06.
  EXPECT_EQ(verdict_on("2", 2.06).words, "holds, rounded");
  EXPECT_EQ(verdict_on("2.0", 2.06).words, "paper 2.9 % low");
}

TEST(Claims, OnlyWhatHoldsSaysHow) {
  EXPECT_EQ(verdict(true).words, "holds");
  EXPECT_EQ(verdict(false).words, "does not hold");
  EXPECT_EQ(verdict(true, "by construction").words, "holds, by construction");
  EXPECT_EQ(verdict(false, "by construction").words, "does not hold");
}

// What is reproduced takes as many steps as the paper says, or half of them; an iteration that has
// not converged has no number of steps.
TEST(Claims, StepsAreReproducedWithinAFactorOfTwo) {
  using thermoroll::claim_on_steps;
  for (const int most : {2, 20}) {
    EXPECT_EQ(claim_on_steps("c0", most, most, true).verdict.words, "holds");
    EXPECT_EQ(claim_on_steps("c0", most, most / 2, true).verdict.words, "holds");
    const thermoroll::Verdict fewer = claim_on_steps("c0", most, most / 2 - 1, true).verdict;
    EXPECT_EQ(fewer.words, "not reproduced: " + std::to_string(most / 2 - 1) + " suffice");
    EXPECT_EQ(fewer.outcome, thermoroll::Judgement::not_reproduced);
    EXPECT_EQ(claim_on_steps("c0", most, most + 1, true).verdict.words, "does not hold");
    for (const int found : {most, 1})
      EXPECT_EQ(claim_on_steps("c0", most, found, false).verdict.words, "does not hold");
    const Claim claim = claim_on_steps("v*", most, 0, true);
    EXPECT_EQ(claim.paper, std::to_string(most));
    EXPECT_EQ(claim.claim, "iterations on v* to 0.1 %, at most");
  }
}

// A reader can redo the verdicts from the other cells: where both the paper's cell and ours are a
// number, the rule applied to what is printed; where ours is no, it does not hold. The words begin
// with the outcome, and every row is counted under one.
TEST(Claims, VerdictsFollowFromTheTable) {
  using thermoroll::Judgement;
  const std::pair<Judgement, std::string> beginnings[] = {
      {Judgement::holds, "holds"},
      {Judgement::restricted, "holds, "},
      {Judgement::near, "paper "},
      {Judgement::not_reproduced, "not reproduced: "},
      {Judgement::fails, "does not hold"},
      {Judgement::extended, "computed: "},
      {Judgement::untestable, "not testable: "}};
  int numbers = 0, statements = 0, counted = 0;
  for (const auto& [outcome, words] : beginnings) {
    const int count = thermoroll::count_of(claims(), outcome);
    EXPECT_GT(count, 0) << words;
    counted += count;
    for (const Claim& c : claims())
      EXPECT_TRUE(c.verdict.outcome != outcome || c.verdict.words.rfind(words, 0) == 0) << c.claim;
  }
  EXPECT_EQ(counted, static_cast<int>(claims().size()));
  for (const Claim& c : claims()) {
    SCOPED_TRACE(c.claim);
    for (const std::string& cell :
         {c.claim, c.source, c.paper, c.published, c.converged, c.corrected, c.verdict.words,
          c.evidence.section, c.evidence.chunk})
      EXPECT_FALSE(cell.empty());
    EXPECT_FALSE(c.evidence.tests.empty());
    const auto is_number = [](const std::string& cell) {
      return cell.find_first_not_of("0123456789.") == std::string::npos &&
             cell.find_first_of("123456789") != std::string::npos;
    };
    if (is_number(c.paper) && is_number(c.converged)) {
      EXPECT_EQ(c.verdict.words, verdict_on(c.paper, std::stod(c.converged)).words);
      ++numbers;
    } else if (c.paper == "yes" && (c.converged == "yes" || c.converged == "no")) {
      EXPECT_EQ(c.verdict.words.substr(0, 5), c.converged == "yes" ? "holds" : "does ");
      ++statements;
    }
  }
  EXPECT_EQ(numbers, 7) << "H, Pe, V, T*max and three in degrees";
  EXPECT_EQ(statements, 5) << "phases, variation, and three on slip and stick";
}

// The paper's counts are bounds for the record, and its errors those of T*max: the largest of the
// sixteen is no smaller than that of any scene, here the last two against the quadrature of the
// closed form, from which heat moves T*max by about f H/(2 pi) = 0.2 % of it.
TEST(Claims, RecordIsThatOfTheRuns) {
  const thermoroll::Record record = thermoroll::scheme_record();
  EXPECT_TRUE(record.converged);
  EXPECT_GT(record.coarse_error, record.fine_error);
  thermoroll::PublishedOptions options;
  options.tolerance = 1e-3;
  for (const double traction : {0.2, 0.59}) {
    const double exact = thermoroll::hottest_point(
                             thermoroll::carter_flux(thermoroll::carter(friction, traction)), 5000)
                             .temperature.value;
    for (const int nodes : {50, 200}) {
      options.nodes = nodes;
      const thermoroll::PublishedSolution x = solve_published(
          {friction, traction, 5000, heating}, thermoroll::Formulation::printed, options);
      EXPECT_LE(x.inner_iterations, record.inner);
      EXPECT_LE(x.outer_iterations, record.outer);
      const double found = thermoroll::published_max_temperature(x, 5000).temperature;
      const double largest = nodes == 50 ? record.coarse_error : record.fine_error;
      EXPECT_LE(100 * std::abs(found / exact - 1), largest + 0.5) << nodes;
    }
  }
}

// In the report's table a symbol is mathematics: outside of it no asterisk, which Markdown would
// take for emphasis, and no symbol in plain text is left.
TEST(Claims, TableIsInTeX) {
  std::ostringstream table;
  thermoroll::write_figure_data("claims", table);
  const std::string text = table.str();
  std::string outside, part;
  bool in_formula = false;
  for (std::istringstream parts(text); std::getline(parts, part, '$'); in_formula = !in_formula)
    if (!in_formula) outside += part;
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), static_cast<long>(claims().size()) + 1);
  EXPECT_EQ(std::count(text.begin(), text.end(), '$') % 2, 0);
  for (const std::string symbol : {"*", "κ", "γ", "c0", "Pe ", " n ", " H ", "|", "$"})
    EXPECT_EQ(outside.find(symbol), std::string::npos) << symbol;
  EXPECT_NE(text.find("$T^*_{\\max}$ at $Q^*$ = 0.5"), std::string::npos) << text;
}
