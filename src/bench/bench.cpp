// Tangled from paper/G-benchmarks.md; edit there.
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "solver/contact_grid.hpp"
#include "solver/least_model.hpp"
#include "solver/surface.hpp"
#include "studies/comparison.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"

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
    for (const Run& run : some)
      if (known.insert(run.name).second)
        benchmark::RegisterBenchmark(run.name.c_str(), time_run, run)
            ->Unit(benchmark::kMicrosecond);
  };
  for (const Regime& regime : regimes) name(runs(regime));
  for (const auto& [scene, run] : cost_runs()) name({run});
}

const Scene steel{paper::friction, paper::peclet, paper::heating};
constexpr Formulation sign = Formulation::corrected;

/// Both sides of the equations on the last grid, for an h of so many terms.
struct LastGrid {
  CoupledSolution x = solve_coupled(steel, sign, 1e-8, {Quantity::traction, 0.5});
  SmoothFlux flux = smooth_flux(x);
  ContactGrid grid = contact_grid(steel, sign, {flux.slip, flux.stick}, 60);
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
      find_hottest(at.flux.slip, steel.peclet, at.flux.h, {}, at.grid.rules.fine);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        find_hottest(at.flux.slip, steel.peclet, at.flux.h, top, at.grid.rules.fine));
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
          benchmark::DoNotOptimize(least_model(scene, formulation, tolerance, given));
        } else {
          benchmark::DoNotOptimize(solve_coupled(scene, formulation, tolerance, given));
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
        solve_coupled({0.3, 1, 0}, Formulation::corrected, 1e-6, {Quantity::creep, given}));
}

}  // namespace

int main(int argc, char** argv) {
  name_runs();
  name_curves();
  name_random_scenes();
  for (const auto& [name, part] : {std::pair{"part/rays", &part_rays},
                                   {"part/sides", &part_sides},
                                   {"part/inverses", &part_inverses},
                                   {"part/hottest", &part_hottest}})
    benchmark::RegisterBenchmark(name, part)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("carter", carters_problem)->Unit(benchmark::kMicrosecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
