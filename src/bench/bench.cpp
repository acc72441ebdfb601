// Tangled from paper/G-benchmarks.md; edit there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "solver/contact_grid.hpp"
#include "solver/least_model.hpp"
#include "solver/surface.hpp"
#include "studies/comparison.hpp"
#include "studies/paper_scene.hpp"
#include "studies/sampling.hpp"
#include "studies/timings.hpp"
#include "support/freed_memory.hpp"
#include "support/number_text.hpp"
#include "thermoroll/creep_law.hpp"
#include "thermoroll/friction_law.hpp"

using namespace thermoroll;

namespace {

void time_run(benchmark::State& state, const Run& run) {
  Found found{};
  for (auto _ : state) benchmark::DoNotOptimize(found = run.find());
  if (std::isnan(found.creep) && std::isnan(found.hottest)) state.SkipWithError("does not settle");
}

void name_runs() {
  std::set<std::string> known;  // the closed form's is the same in all regimes
  const auto name = [&](const std::vector<Run>& some) {
    for (const Run& run : some) {
      if (!known.insert(run.name).second) continue;
      auto* timed = benchmark::RegisterBenchmark(run.name.c_str(), time_run, run);
      timed->Unit(benchmark::kMicrosecond);
      if (run.setting > 200) timed->Repetitions(1);  // most of a second each
    }
  };
  for (const Regime& regime : regimes) name(runs(regime));
  for (const auto& [scene, run] : cost_runs()) name({run});
}

const Scene steel{paper::friction, paper::peclet, paper::heating};
constexpr Formulation sign = Formulation::corrected;

/// Both sides of the equations on the last grid, for an h of so many terms.
struct LastGrid {
  CoupledSolution x = solve_coupled(steel, {sign, 1e-8}, {Quantity::traction, 0.5});
  SmoothFlux flux = smooth_flux(x);
  ContactGrid grid = contact_grid(steel, sign, flux.zones(), 60);
  ThermalTerms thermal(Eigen::Index terms) const {
    return thermal_terms(steel, sign, grid.nodes, terms, grid.rules.graded);
  }
};

void part_rays(benchmark::State& state) {
  const LastGrid at;
  for (auto _ : state) benchmark::DoNotOptimize(at.thermal(1));
}

void part_sides(benchmark::State& state) {
  const LastGrid at;
  for (auto _ : state) benchmark::DoNotOptimize(at.thermal(60));
}

void part_inverses(benchmark::State& state) {
  const LastGrid at;
  const ContactGrid& grid = at.grid;
  for (auto _ : state)
    benchmark::DoNotOptimize(traction_operators(grid.nodes, grid.thermal, steel.friction));
}

void part_hottest(benchmark::State& state) {
  const LastGrid at;
  const HottestPoint top =
      find_hottest(at.flux.zones(), steel.peclet, at.flux.h, {}, at.grid.rules.fine);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        find_hottest(at.flux.zones(), steel.peclet, at.flux.h, top, at.grid.rules.fine));
}

void temperature_curve(benchmark::State& state, const SmoothFlux& flux) {
  const Eigen::ArrayXd s = Eigen::ArrayXd::LinSpaced(400, -1, 3);
  for (auto _ : state) benchmark::DoNotOptimize(surface_curve(flux, paper::peclet, s, 5e-9));
}

void name_curves() {
  const SmoothFlux closed = smooth_flux(paper::closed_form(0.5)), coupled = LastGrid().flux;
  for (const auto& [name, flux] : {std::pair{"temperature_curve/points:400", closed},
                                   {"temperature_curve_coupled/points:400", coupled}})
    benchmark::RegisterBenchmark(name, temperature_curve, flux)->Unit(benchmark::kMicrosecond);
}

void random_scenes_by(benchmark::State& state, bool ladder, double tolerance) {
  const std::vector<Sample> scenes = random_scenes(200);
  for (auto _ : state)
    for (const auto& [scene, pull, formulation] : scenes) try {
        const Prescribed given{Quantity::traction, pull};
        if (ladder) {
          benchmark::DoNotOptimize(least_model(scene, {formulation, tolerance}, given));
        } else {
          benchmark::DoNotOptimize(solve_coupled(scene, {formulation, tolerance}, given));
        }
      } catch (const std::runtime_error&) {  // refused by both
      }
}

void name_random_scenes() {
  for (const bool ladder : {true, false})
    for (const double tolerance : {1e-2, 1e-3, 1e-6}) {
      const std::string name = (ladder ? "auto/tol:" : "coupled/tol:") + shortest(tolerance);
      benchmark::RegisterBenchmark((name + "/random:200").c_str(), random_scenes_by, ladder,
                                   tolerance)
          ->Unit(benchmark::kMicrosecond);
    }
}

void carters_problem(benchmark::State& state) {
  const double given = carter(0.3, 0.192).creep;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        solve_coupled({0.3, 1, 0}, {Formulation::corrected, 1e-6}, {Quantity::creep, given}));
}

struct Ratio {
  std::string name;
  double bar;
  bool at_least;  // the bar is a least ratio, not a largest
  std::vector<double> medians{};
  benchmark::IterationCount iterations = 0;
};
std::vector<Ratio> ratios_in_turns;

using Solve = std::function<void()>;

double seconds(const Solve& solve, int times) {
  const std::clock_t start = std::clock();
  for (int k = 0; k < times; ++k) solve();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / times;
}

void in_turns(benchmark::State& state, const Solve& alone, const Solve& extended,
              std::size_t index) {
  std::vector<double> ratios;
  int times = 1;
  for (auto _ : state) {
    state.PauseTiming();
    const double unit = seconds(alone, times);
    state.ResumeTiming();
    ratios.push_back(seconds(extended, 1) / unit);
    times = static_cast<int>(std::clamp(ratios.back(), 1.0, 1000.0));
  }
  Ratio& all = ratios_in_turns[index];
  if (state.iterations() > all.iterations) all.medians.clear();  // those were trials
  all.iterations = std::max(all.iterations, state.iterations());
  if (state.iterations() == all.iterations) all.medians.push_back(median(ratios));
  state.SetLabel(fixed(median(ratios), 2) + " times the other");
}

void name_ratio(const Ratio& of, const Solve& alone, const Solve& extended) {
  benchmark::RegisterBenchmark(of.name.c_str(), in_turns, alone, extended, ratios_in_turns.size())
      ->Unit(benchmark::kMicrosecond);
  ratios_in_turns.push_back(of);
}

using Three = std::array<Prescribed, 3>;

Three three(Quantity quantity, double low, double middle, double high) {
  return {{{quantity, low}, {quantity, middle}, {quantity, high}}};
}

Solve solve_of(Scene scene, const Three& all) {
  return [scene, all]() mutable {
    for (const Prescribed& given : all) {
      scene.roller.heating *= 1 + 1e-14;
      benchmark::DoNotOptimize(solve_coupled(scene, {sign, 1e-6}, given));
    }
  };
}

void name_extension(const std::string& name, double bar, const Scene& scene, const Solve& extended,
                    const Three& given) {
  const Scene alone{scene.friction, scene.peclet, scene.heating};
  const std::string groups = "/Pe:" + shortest(scene.peclet) + "/H:" + shortest(scene.heating);
  name_ratio({name + groups, bar, false}, solve_of(alone, given), extended);
}

void name_two_bodies(const Scene& alone) {
  const Three borders = three(Quantity::stick_slip_border, -0.6, -0.1, 0.4);
  const auto name = [&](const char* what, double bar, const Scene& scene) {
    name_extension(what, bar, scene, solve_of(scene, borders), borders);
  };
  Scene scene = alone;
  scene.roller = {1, alone.heating};
  name("identical/tau:0", 1.1, scene);
  scene = alone;
  scene.direction = Direction::braking;
  name("identical/tau:-1", 1.1, scene);
  scene = alone;
  scene.roller = {2, 0.7 * alone.heating, alone.peclet / 5};
  name("unlike/share", 6, scene);
  scene.bulk_difference = 0.1 / std::sqrt(alone.peclet);
  name("unlike/bulk_difference", 6, scene);
}

void name_friction_law(const Scene& alone) {
  Scene scene = alone;
  scene.law = linear_friction({scene.friction / std::sqrt(scene.peclet)});
  const Three pulls = three(Quantity::traction, 0.1, 0.2, 0.3);
  for (const auto& [what, bar, given] :
       {std::tuple{"friction_law/border", 2, three(Quantity::stick_slip_border, -0.6, -0.1, 0.4)},
        {"friction_law/creep", 2, three(Quantity::creep, 0.05, 0.1, 0.2)},
        {"friction_law/traction", 5, pulls}})
    name_extension(what, bar, scene, solve_of(scene, given), given);
  const auto curve = [scene](double from) -> Solve {
    return [=] {
      for (int times = 0; times < 3; ++times) {
        const CreepLaw law = creep_law(scene, sign, 1e-4, {from, 1});
        for (int i = 1; i <= 100; ++i)
          benchmark::DoNotOptimize(evaluate(law, from + (1 - from) * 0.01 * i));
      }
    };
  };
  name_extension("friction_law/curve:100", 60, scene, curve(0), pulls);
  name_extension("friction_law/curve_both:100", 60, scene, curve(-1), pulls);
}

void law_evaluate(benchmark::State& state) {
  const CreepLaw law = creep_law(steel, sign, 1e-4);
  int i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(law, 0.02 * (++i % 101) - 1));
}

Solve run_named(const std::string& name) {
  for (const Regime& regime : regimes)
    for (const Run& run : runs(regime))
      if (run.name == name) return [=] { benchmark::DoNotOptimize(run.find()); };
  throw std::logic_error("no run " + name);
}

void name_published() {
  const auto solved_to = [](double tolerance) -> Solve {
    return [=] {
      benchmark::DoNotOptimize(solve_coupled(steel, {sign, tolerance}, {Quantity::traction, 0.5}));
    };
  };
  for (const auto& [tolerance, bar, thrifty] :
       {std::tuple{1e-6, 350, 140}, {1e-8, 75, 30}, {1e-10, 12, 5}})
    for (const auto& [scheme, least] :
         {std::pair{"gauss_chebyshev", bar}, {"gauss_chebyshev_thrifty", thrifty}})
      name_ratio({scheme + ("/tol:" + shortest(tolerance)), 1.0 * least, true},
                 solved_to(tolerance), run_named(scheme + std::string("/n:200/Pe:4360/H:0.0175")));
}

void judge_ratios() {
  for (const Ratio& x : ratios_in_turns) {
    if (x.medians.size() < 5) continue;
    const auto [least, most] = std::minmax_element(x.medians.begin(), x.medians.end());
    const double middle = median(x.medians), spread = (*most - *least) / middle;
    std::fprintf(stderr, "%-42s %8.2f  bar %s %-5g spread %4.1f %%  %s\n", x.name.c_str(), middle,
                 x.at_least ? ">=" : "<=", x.bar, 100 * spread,
                 judgement(middle, spread, x.bar, x.at_least).c_str());
  }
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "an unknown processor";
}

void add_context() {
  const unsigned count = std::thread::hardware_concurrency();
  benchmark::AddCustomContext("processor", std::to_string(count) + " × " + processor());
  benchmark::AddCustomContext("compiler", THERMOROLL_COMPILER);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  name_runs();
  name_curves();
  name_random_scenes();
  for (const Scene& alone : {Scene{paper::friction, 100, 1}, steel}) {
    name_two_bodies(alone);
    name_friction_law(alone);
  }
  name_published();
  for (const auto& [name, part] : {std::pair{"part/rays", &part_rays},
                                   {"part/sides", &part_sides},
                                   {"part/inverses", &part_inverses},
                                   {"part/hottest", &part_hottest}})
    benchmark::RegisterBenchmark(name, part)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("carter", carters_problem)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("law/evaluate", law_evaluate);
  add_context();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  judge_ratios();
  benchmark::Shutdown();
  return 0;
}
