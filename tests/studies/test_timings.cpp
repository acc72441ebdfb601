#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "driven.hpp"
#include "solver/least_model.hpp"
#include "studies/comparison.hpp"
#include "studies/graded_panels.hpp"
#include "studies/timings.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/published_scheme.hpp"
#include "thermoroll/scene.hpp"
#include "thermoroll/temperature.hpp"

namespace {

using thermoroll::Found;
using thermoroll::Quantity;
using thermoroll::Regime;
using thermoroll::Times;

/// A file with this text, removed at the end.
class File {
 public:
  explicit File(const std::string& text)
      : path_(testing::TempDir() + "thermoroll-times-" + std::to_string(getpid())) {
    std::ofstream(path_) << text;
  }
  ~File() { std::remove(path_.c_str()); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string repetition(const std::string& name, double time, const std::string& unit) {
  std::ostringstream out;
  out << R"({"name": ")" << name << R"(", "run_name": ")" << name
      << R"(", "run_type": "iteration", "real_time": 77, "cpu_time": )" << time
      << R"(, "time_unit": ")" << unit << "\"}";
  return out.str();
}

std::string written(const std::string& name, const Times& times) {
  std::ostringstream out;
  thermoroll::write_timed_data(name, {times}, out);
  return out.str();
}

/// Every run takes as many milliseconds as given.
Times every_run(double coupled, double scheme) {
  Times times{{"temperature_curve/points:400", 1e-3 * coupled},
              {"temperature_curve_coupled/points:400", 1e-3 * coupled}};
  for (const char* part : {"rays", "sides", "inverses", "hottest"})
    times[std::string("part/") + part] = 1e-4 * coupled;
  for (const Regime& regime : thermoroll::regimes)
    for (const auto& run : thermoroll::runs(regime))
      times[run.name] = 1e-3 * (run.method == "coupled" ? coupled : scheme);
  for (const auto& [scene, run] : thermoroll::cost_runs()) times[run.name] = 1e-3 * coupled;
  return times;
}

}  // namespace

TEST(Timings, MediansOfTheBenchmarksOutput) {
  const File file(R"({"context": {}, "benchmarks": [)" + repetition("a/n:2", 3, "us") + "," +
                  repetition("a/n:2", 1, "us") + "," + repetition("a/n:2", 9, "us") + "," +
                  repetition("b", 2.5, "ms") + "," + repetition("c", 4, "ns") + R"(,
    {"run_name": "a/n:2", "run_type": "aggregate", "aggregate_name": "mean", "cpu_time": 5,
     "time_unit": "us"},
    {"run_name": "d", "run_type": "iteration", "error_occurred": true, "cpu_time": 0,
     "time_unit": "us"}]})");
  const Times times = thermoroll::read_benchmarks(file.path()).times;
  ASSERT_EQ(times.size(), 3u);
  EXPECT_DOUBLE_EQ(times.at("a/n:2"), 3e-6);
  EXPECT_DOUBLE_EQ(times.at("b"), 2.5e-3);
  EXPECT_DOUBLE_EQ(times.at("c"), 4e-9);
}

// Of the repetitions as many are longer than the median as are shorter, in whatever order they ran.
TEST(Timings, MedianHasAsManyAboveAsBelow) {
  for (const int repetitions : {1, 3, 5, 7, 9}) {
    std::string runs;
    for (int k = 0; k < repetitions; ++k)  // 2 has no common divisor with the odd number: all, once
      runs += (k > 0 ? "," : "") + repetition("a", 1 + 2 * k % repetitions, "s");
    const File file(R"({"benchmarks": [)" + runs + "]}");
    EXPECT_EQ(thermoroll::read_benchmarks(file.path()).times.at("a"), (1 + repetitions) / 2)
        << repetitions;
  }
}

TEST(Timings, RefusesWhatIsNoOutput) {
  for (const std::string text :
       {"", "text", "[]", "{}", R"({"benchmarks": [{}]})", R"({"benchmarks": [{"run_name": 1}]})",
        R"({"benchmarks": [{"run_type": "iteration", "time_unit": "year", "cpu_time": 1,
            "run_name": "a"}]})"}) {
    const File file(text);
    try {
      thermoroll::read_benchmarks(file.path());
      ADD_FAILURE() << "accepted: " << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(file.path() + " is not the output of"),
                std::string::npos)
          << error.what();
    }
  }
  EXPECT_THROW(thermoroll::read_benchmarks("no such file"), std::invalid_argument);
}

// The repetitions of some of ten benchmarks lie 1 apart at a least time of 4. Nine of ten is all
// but one. Ten more that are timed once have no spread.
TEST(Timings, TellsTheirCircumstances) {
  const auto output = [](int apart) {
    std::string runs;
    for (int k = 0; k < 10; ++k)
      for (const double time : {4.0, k < apart ? 5.0 : 4.0})
        runs += (runs.empty() ? "" : ",") + repetition("a" + std::to_string(k), time, "s");
    for (int k = 0; k < 10; ++k)
      runs += "," + repetition("b" + std::to_string(k) + "/repeats:1", 3, "s");
    return R"({"context": {"processor": "2 × X", "compiler": "C 1"}, "benchmarks": [)" + runs +
           "]}";
  };
  for (const auto& [apart, spread] : {std::pair{0, 0.0}, {1, 0.0}, {2, 0.25}}) {
    const File file(output(apart));
    const thermoroll::Benchmarks run = thermoroll::read_benchmarks(file.path());
    EXPECT_EQ(run.processor, "2 × X");
    EXPECT_EQ(run.compiler, "C 1");
    EXPECT_EQ(run.repetitions, 2);
    EXPECT_EQ(run.spread, spread) << apart;
    EXPECT_EQ(run.times.at("b0"), 3);
  }
  const File file(R"({"benchmarks": []})");
  EXPECT_EQ(thermoroll::read_benchmarks(file.path()).processor, "an unknown processor");
}

namespace {

/// What the prose, written before, says by that key.
std::string said(const std::string& text, const std::string& key) {
  const std::string before = '"' + key + "\": \"";
  const std::size_t at = text.find(before);
  if (at == std::string::npos) return "nothing";
  return text.substr(at + before.size(), text.find('"', at + before.size()) - at - before.size());
}

/// With the times of two hundred random scenes, all of them a second.
Times with_random_scenes(Times times) {
  for (const char* method : {"coupled", "auto"})
    for (const char* tolerance : {"0.01", "0.001", "1e-06"})
      times[std::string(method) + "/tol:" + tolerance + "/random:200"] = 1;
  return times;
}

}  // namespace

// All runs of the scheme take 150 ms and all of the coupled solver as long as given.
TEST(Timings, RatiosAreOfTheirTimes) {
  Times times = with_random_scenes(every_run(1.1, 150));
  times.at("gauss_chebyshev_thrifty/n:200/Pe:4360/H:0.0175") = 8e-3;
  times.at("coupled/tol:1e-08/Pe:4360/H:0.0175") *= 3;
  times.at("coupled/tol:1e-10/Pe:4360/H:0.0175") *= 21;
  const std::string text = written("speed", times);
  EXPECT_EQ(said(text, "speed_60_by_30"), "3.0");
  EXPECT_EQ(said(text, "speed_88_by_60"), "7.0");
  EXPECT_EQ(said(text, "speed_ratio_6"), "140");  // 136.4, of which two digits are told
  EXPECT_EQ(said(text, "speed_ratio_cached_6"), "7.3");
  EXPECT_EQ(said(text, "speed_ratio_load"), "140");
  EXPECT_EQ(said(text, "speed_time_once"), "150 ms");  // it is not the coupled solver's time
}

// A time is written in microseconds below a millisecond, and to two digits at least from 1 µs on.
TEST(Timings, TimesAreInTheirUnit) {
  using Expected = std::array<std::pair<double, const char*>, 4>;
  const std::array<std::pair<const char*, const char*>, 4> runs = {
      {{"coupled/tol:1e-06/Pe:4360/H:0.0175", "speed_time_6"},
       {"gauss_chebyshev/n:200/Pe:4360/H:0.0175", "speed_scheme"},
       {"temperature_curve/points:400", "speed_time_curve"},
       {"temperature_curve_coupled/points:400", "speed_time_curve_coupled"}}};
  for (const Expected& expected :
       {Expected{{{2e-6, "2.0 µs"}, {9.94e-6, "9.9 µs"}, {2e-5, "20 µs"}, {9e-4, "900 µs"}}},
        Expected{{{1e-3, "1.0 ms"}, {9.94e-3, "9.9 ms"}, {0.012, "12 ms"}, {2, "2000 ms"}}}}) {
    Times times = with_random_scenes(every_run(1, 150));
    for (std::size_t i = 0; i < 4; ++i) times.at(runs[i].first) = expected[i].first;
    const std::string text = written("speed", times);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(said(text, runs[i].second), expected[i].second);
  }
}

// What the least model saves is how much longer the coupled one takes for the same random scenes;
// what the thrifty scheme saves is the share of its time that the other repeats.
TEST(Timings, SavedTimeIsTheRatioOfBothWays) {
  Times times = every_run(1, 150);
  for (const auto& [tolerance, automatic] :
       {std::pair{"0.01", 0.5}, {"0.001", 0.8}, {"1e-06", 2.5}}) {
    times[std::string("coupled/tol:") + tolerance + "/random:200"] = 4;
    times[std::string("auto/tol:") + tolerance + "/random:200"] = automatic;
  }
  times.at("gauss_chebyshev_thrifty/n:200/Pe:4360/H:0.0175") /= 4;  // three quarters are repetition
  const std::string text = written("speed", times);
  for (const char* saved : {R"("least_saved_2": "8.0")", R"("least_saved_3": "5.0")",
                            R"("least_saved_6": "1.6")", R"("speed_repeated": "75")"})
    EXPECT_NE(text.find(saved), std::string::npos) << text;
}

// Of each method the fastest run that has the digits counts: another that is slower, or that is
// faster and has them not, does not.
TEST(Timings, PanelsAreComparedAtEqualError) {
  Times times = every_run(1, 150);
  for (const char* way : {"coupled", "auto"})
    for (const char* tolerance : {"0.01", "0.001", "1e-06"})
      times[std::string(way) + "/tol:" + tolerance + "/random:200"] = 1;
  times.at("graded_panels/n:200/Pe:100/H:1") = 3e-3;
  times.at("graded_panels/n:25/Pe:4360/H:0.0175") = 3e-3;
  const std::string text = written("speed", times);
  for (const char* ratio : {R"("speed_panels_6_steel": "150")", R"("speed_panels_8_steel": "150")",
                            R"("speed_panels_6_hot": "3.0")", R"("speed_panels_8_hot": "3.0")"})
    EXPECT_NE(text.find(ratio), std::string::npos) << text;
}

// The rest is what makes the parts up to the whole.
TEST(Timings, SharesAddUpToTheWhole) {
  std::istringstream table(written("shares", every_run(150, 1)));
  std::string line, last;
  double sum = 0;
  for (std::getline(table, line); std::getline(table, line); last = line)
    sum += std::stod(line.substr(line.rfind(',') + 1));
  EXPECT_EQ(last, "\"**all**\",150 ms,100 %");
  EXPECT_NEAR(sum, 200, 3);  // rounded to a per cent each
}

TEST(Timings, AreWrittenByName) {
  EXPECT_EQ(written("times", {{"a/n:2", 1.5}, {"b", 1e-6}}), "name,seconds\na/n:2,1.5\nb,1e-06\n");
}

TEST(Timings, RefuseUnknownNamesAndMissingTimes) {
  EXPECT_THROW(written("traction", {}), std::invalid_argument);
  EXPECT_THROW(written("speed", {{"closed_form", 1}}), std::runtime_error);
}

// A run finds what its name says; the cheap ones are enough to see the names read.
TEST(Comparison, RunsAreWhatTheirNamesSay) {
  const auto find = [](const Regime& regime, const std::string& name) {
    for (const auto& run : thermoroll::runs(regime))
      if (run.name == name) return run.find();
    ADD_FAILURE() << "no " << name;
    return Found{};
  };
  const Regime& steel = thermoroll::regimes[0];
  const Driven scene{0.6, 0.5, 4360, 0.0175};
  const auto sign = thermoroll::Formulation::corrected;
  const auto coupled = thermoroll::solve_coupled(scene, {sign, 1e-4}, {Quantity::traction, 0.5});
  const Found found = find(steel, "coupled/tol:1e-04/Pe:4360/H:0.0175");
  EXPECT_EQ(found.load_ratio, coupled.value(Quantity::load_ratio));
  EXPECT_EQ(found.hottest, coupled.value(Quantity::max_temperature));
  EXPECT_EQ(found.creep, coupled.value(Quantity::creep));

  const auto scheme = solve_published(scene, sign, {25});
  const Found described = find(steel, "gauss_chebyshev/n:25/Pe:4360/H:0.0175");
  EXPECT_EQ(described.load_ratio, scheme.load_ratio);
  EXPECT_EQ(described.creep, scheme.creep);
  EXPECT_EQ(described.hottest, thermoroll::published_max_temperature(scheme, 4360).temperature);
  const Found thrifty = find(steel, "gauss_chebyshev_thrifty/n:25/Pe:4360/H:0.0175");
  EXPECT_NEAR(thrifty.hottest, described.hottest, 1e-12);
  const Found means = find(steel, "gauss_chebyshev_moments/n:25/Pe:4360/H:0.0175");
  EXPECT_GT(means.load_ratio - 1, 10 * (described.load_ratio - 1));
  const auto panels = thermoroll::solve_on_panels({0.6, 4360, 0.0175}, 0.5, sign, 25);
  const Found on_panels = find(steel, "graded_panels/n:25/Pe:4360/H:0.0175");
  EXPECT_EQ(on_panels.load_ratio, panels.load_ratio);
  EXPECT_EQ(on_panels.hottest, panels.hottest);
  EXPECT_EQ(on_panels.creep, panels.creep);

  const auto corrected = thermoroll::first_order(scene, {sign, 1e-6}, scene);
  const Found once = find(steel, "first_order/Pe:4360/H:0.0175");
  EXPECT_EQ(once.load_ratio, corrected.value(Quantity::load_ratio));
  EXPECT_EQ(once.hottest, corrected.value(Quantity::max_temperature));
  EXPECT_EQ(once.creep, corrected.value(Quantity::creep));

  EXPECT_EQ(find(steel, "closed_form").load_ratio, 1);
  EXPECT_TRUE(std::isnan(find(steel, "closed_form").hottest));
  // Heat acts back on the temperature by a share of about f H.
  EXPECT_NEAR(find(steel, "closed_form/Pe:4360/H:0.0175").hottest, found.hottest,
              0.6 * 0.0175 * found.hottest);
}

// On grids that are refined four times the error falls to the reference's own; the finest grids are
// those on which the reference itself was found.
TEST(Comparison, OneGridConverges) {
  for (const Regime& regime : thermoroll::regimes) {
    const Found exact = thermoroll::reference(regime);
    double last = 1;
    for (const int n : {6, 24, 96}) {
      const Found found = thermoroll::on_one_grid(regime, n);
      EXPECT_EQ(found.unknowns, n);
      const double error = std::max(std::abs(found.hottest / exact.hottest - 1),
                                    std::abs(found.creep / exact.creep - 1));
      EXPECT_LT(error, 0.1 * last) << regime.name << n;
      last = error;
    }
    EXPECT_LT(last, 1e-9) << regime.name;
  }
}

TEST(Comparison, WhatDoesNotSettleFindsNothing) {
  int runs = 0;
  for (const auto& run : thermoroll::runs(thermoroll::regimes[2]))
    if (run.name == "gauss_chebyshev_thrifty/n:100/Pe:100/H:1") {
      EXPECT_TRUE(std::isnan(run.find().load_ratio));
      EXPECT_TRUE(std::isnan(run.find().hottest));
      ++runs;
    }
  EXPECT_EQ(runs, 1);
}

// Hertz and Carter are constants in the solver's variables: only rounding is left, of at most some
// hundred sums.
TEST(Comparison, CarterIsFoundToRounding) {
  const thermoroll::CarterErrors errors = thermoroll::carter_errors();
  EXPECT_LT(errors.force, 1e-13);
  EXPECT_LT(errors.creep, 1e-13);
  EXPECT_LT(errors.traction, 1e-13);
  EXPECT_GE(errors.unknowns, 1);
}

// Ten digits of the uniform unit band's maxima and their places, computed apart from this program;
// near its maximum the curve is flat, so that the digits of the places do not matter. Blok's
// factor is 1.111548, which he rounds to 1.11; at finite speed it is off by O(1/sqrt Pe).
TEST(Comparison, BandsAreJaegersAndBloks) {
  const double known[][3] = {{0.1, 0.2435, 2.2003300884},
                             {1, 0.6664, 0.9918504218},
                             {10, 0.9244, 0.3484997487},
                             {100, 0.9877, 0.1124363739},
                             {5000, 0.9996, 0.0159558555}};
  const thermoroll::HeatFlux uniform{-1, 1, [](double, double) { return 1.0; }};
  for (const auto& [peclet, at, top] : known) {
    EXPECT_NEAR(thermoroll::jaeger_band(peclet, at), top, 1e-6 * top) << peclet;
    const thermoroll::Peak peak = thermoroll::hottest_point(uniform, peclet);
    EXPECT_NEAR(peak.temperature.value, top, 1e-9) << peclet;
    EXPECT_NEAR(thermoroll::jaeger_band(peclet, peak.at), peak.temperature.value, 1e-9 * top);
  }
  EXPECT_NEAR(thermoroll::blok_factor(1e8), 1.111548, 1e-4);
}

// At the bar a ratio meets it; one whose repetitions spread by more than 5 % is not judged, nor is
// one without a number.
TEST(Timings, RatiosAreJudgedByTheirBars) {
  for (const bool at_least : {false, true}) {
    EXPECT_EQ(thermoroll::judgement(1.1, 0.05, 1.1, at_least), "met");
    EXPECT_EQ(thermoroll::judgement(1.2, 0.01, 1.1, at_least), at_least ? "met" : "missed");
    EXPECT_EQ(thermoroll::judgement(1.0, 0.01, 1.1, at_least), at_least ? "missed" : "met");
    EXPECT_EQ(thermoroll::judgement(1.1, 0.051, 1.1, at_least), "not judged");
    EXPECT_EQ(thermoroll::judgement(1.1, std::nan(""), 1.1, at_least), "not judged");
  }
}
