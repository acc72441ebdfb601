// Tangled from paper/E-benchmarks.md; edit there.
#include <string>

#include <benchmark/benchmark.h>

#include "paper_case.hpp"
#include "temperature.hpp"

using namespace thermoroll;

namespace {

void closed_form(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(paper::closed_form(0.5));
}

void published_scheme(benchmark::State& state, int nodes, double peclet) {
  for (auto _ : state) benchmark::DoNotOptimize(paper::scheme(0.5, peclet, {nodes}));
}

void temperature_curve(benchmark::State& state, int points) {
  const HeatFlux flux = carter_flux(paper::closed_form(0.5));
  for (auto _ : state)
    for (int i = 0; i < points; ++i)
      benchmark::DoNotOptimize(temperature(flux, paper::peclet, -1 + 4.0 * i / (points - 1)));
}

void name_benchmarks() {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("closed_form", closed_form);
  for (const int peclet : {100, 4360})
    for (const int nodes : {25, 50, 100, 200, 400}) {
      const std::string name = "gauss_chebyshev/n:" + std::to_string(nodes) +
                               "/Pe:" + std::to_string(peclet) + "/H:0.0175";
      RegisterBenchmark(name.c_str(), published_scheme, nodes, peclet)
          ->Unit(benchmark::kMillisecond);
    }
  RegisterBenchmark("temperature_curve/points:400", temperature_curve, 400)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  name_benchmarks();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
