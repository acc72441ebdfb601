// Full slip and friction that falls with temperature.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "curves.hpp"

using namespace thermoroll_test;

namespace {

const std::vector<std::string> softenings{"0.5", "1", "3", "6"};

Curve of(const std::string& kind, const std::string& softening) {
  return curve(data("hot-friction"), {{"kind", kind}, {"softening", softening}}, "creep",
               "traction");
}

/// The marks of a kind, which are too few for a curve.
Curve marks(const std::string& kind, const std::string& softening) {
  const Table table = data("hot-friction");
  Curve found;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.text(row, "kind") != kind || table.text(row, "softening") != softening) continue;
    found.x.push_back(table.number(row, "creep"));
    found.y.push_back(table.number(row, "traction"));
  }
  return found;
}

}  // namespace

// Heat is solved for to 1e-5, and friction is 0.6 for all larger creeps.
TEST(FullSlipFigure, TractionComesToFrictionAndStays) {
  const Table table = data("full-slip-a");
  for (const char* heating : {"without", "half", "one"}) {
    const Curve c = curve(table, {}, "creep", heating);
    EXPECT_TRUE(std::is_sorted(c.y.begin(), c.y.end(), [](double a, double b) {
      return a < b - 2e-5;
    })) << heating;
    for (const double creep : {0.5, 0.7}) {
      EXPECT_NEAR(at(c, creep), friction, 2e-5) << heating;
      EXPECT_NEAR(at(c, -creep), -friction, 2e-5) << heating;
    }
  }
}

// No point of the contact is hotter than the hottest, so that one friction for all is too small.
TEST(HotFrictionFigure, OneFrictionHasLessTraction) {
  for (const std::string& softening : softenings) {
    const Curve local = of("local", softening), shortcut = of("shortcut", softening);
    for (std::size_t i = 0; i < shortcut.x.size(); ++i) {
      if (shortcut.x[i] < 0.1) continue;  // before that they differ by less than chords from curves
      EXPECT_LT(shortcut.y[i], at(local, shortcut.x[i])) << softening;
    }
  }
}

// Carter's curve bends by pi^2 / 2f = 8, and what friction loses bends it about as much again.
// Points are 0.02 apart, where a bend of 20 is 0.02^2 * 20 / 8 above its chord.
constexpr double chord = 1e-3;

TEST(HotFrictionFigure, MaximumIsTheHighestPoint) {
  double last = friction;
  for (const std::string& softening : softenings) {
    const double top = marks("maximum", softening).y.at(0),
                 highest = largest(of("local", softening));
    EXPECT_GE(top, highest - 2e-5) << softening;
    EXPECT_LT(top, highest + chord) << softening;
    EXPECT_LT(top, last) << "the more friction is lost, the lower";
    last = top;
  }
}

TEST(HotFrictionFigure, PairLiesOnEitherSideOfTheMaximum) {
  const Curve pair = marks("pair", "3"), local = of("local", "3");
  ASSERT_EQ(pair.x.size(), 2u);
  const double top = marks("maximum", "3").x.at(0);
  EXPECT_LT(pair.x[0], top);
  EXPECT_GT(pair.x[1], top);
  for (const double creep : pair.x) EXPECT_NEAR(at(local, creep), 0.35, chord);
}

// Of the Peclet number 100 a share of 1/Pe or so is left, below 0.001; chords of the line add
// 0.0015.
TEST(HotFrictionFigure, CollapsesAtHighSpeed) {
  const Table table = data("hot-collapse");
  for (const std::string softening : {"1", "3", "6"}) {
    const auto at_speed = [&](const std::string& peclet) {
      return curve(table, {{"peclet", peclet}, {"softening", softening}}, "creep", "traction");
    };
    const Curve fast = at_speed("50000");
    for (const std::string peclet : {"100", "1000", "5000"}) {
      const Curve c = at_speed(peclet);
      for (std::size_t i = 0; i < c.x.size(); ++i)
        EXPECT_NEAR(c.y[i], at(fast, c.x[i]), 0.003) << softening << ' ' << peclet;
    }
  }
}

// The limit is that of each state; in the slip zone it is reached.
TEST(HotFrictionFigure, TractionReachesItsLimitBehindTheBorder) {
  const Table table = data("hot-profile-a");
  for (const char* state : {"before", "at", "past"}) {
    const Curve q = curve(table, {{"state", state}}, "s", "q");
    const Curve limit = curve(table, {{"state", state}}, "s", "limit");
    for (std::size_t i = 0; i < q.x.size(); ++i) {
      EXPECT_LT(q.y[i], limit.y[i] + 1e-7) << state << " at " << q.x[i];
      if (q.x[i] < 0.2) continue;
      EXPECT_NEAR(q.y[i], limit.y[i], 1e-7) << state << " at " << q.x[i];
    }
  }
}
