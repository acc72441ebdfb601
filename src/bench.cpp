// Tangled from paper/E-benchmarks.md; edit there.
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "comparison.hpp"
#include "paper_case.hpp"
#include "surface.hpp"

using namespace thermoroll;

namespace {

void time_run(benchmark::State& state, const Run& run) {
  Found found{};
  for (auto _ : state) benchmark::DoNotOptimize(found = run.find());
  if (std::isnan(found.creep) && std::isnan(found.hottest)) state.SkipWithError("does not settle");
}

void name_runs() {
  std::set<std::string> known;  // the closed form's is the same in all regimes
  for (const Regime& regime : regimes)
    for (const Run& run : runs(regime))
      if (known.insert(run.name).second)
        benchmark::RegisterBenchmark(run.name.c_str(), time_run, run)
            ->Unit(benchmark::kMicrosecond);
}

void temperature_curve(benchmark::State& state, const SmoothFlux& flux) {
  const Eigen::ArrayXd s = Eigen::ArrayXd::LinSpaced(400, -1, 3);
  for (auto _ : state) benchmark::DoNotOptimize(surface_curve(flux, paper::peclet, s, 5e-9));
}

void name_curves() {
  const Scene steel{paper::friction, 0.5, paper::peclet, paper::heating};
  const SmoothFlux closed = smooth_flux(paper::closed_form(0.5));
  const SmoothFlux coupled =
      smooth_flux(solve_coupled(steel, Formulation::corrected, 1e-8, {traction, 0.5}));
  for (const auto& [name, flux] : {std::pair{"temperature_curve/points:400", closed},
                                   {"temperature_curve_coupled/points:400", coupled}})
    benchmark::RegisterBenchmark(name, temperature_curve, flux)->Unit(benchmark::kMicrosecond);
}

void carters_problem(benchmark::State& state) {
  const double given = carter(0.3, 0.192).creep;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        solve_coupled({0.3, 0.192, 1, 0}, Formulation::corrected, 1e-6, {creep, given}));
}

}  // namespace

int main(int argc, char** argv) {
  name_runs();
  name_curves();
  benchmark::RegisterBenchmark("carter", carters_problem)->Unit(benchmark::kMicrosecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
