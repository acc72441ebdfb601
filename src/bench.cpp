// Tangled from paper/E-benchmarks.md; edit there.
#include <string>

#include <benchmark/benchmark.h>

#include "carter.hpp"
#include "printed_scheme.hpp"
#include "temperature.hpp"

using namespace thermoroll;

namespace {

constexpr double friction = 0.6, traction = 0.5, heating = 0.0175;

void closed_form(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(carter(friction, traction));
}

void published_scheme(benchmark::State& state, int nodes, double peclet) {
  PrintedOptions options;
  options.nodes = nodes;
  const Scene scene{friction, traction, peclet, heating};
  for (auto _ : state)
    benchmark::DoNotOptimize(solve_printed(scene, Formulation::printed, options));
}

void temperature_curve(benchmark::State& state, int points) {
  const HeatFlux flux = carter_flux(carter(friction, traction));
  for (auto _ : state)
    for (int i = 0; i < points; ++i)
      benchmark::DoNotOptimize(temperature(flux, 4360, -1 + 4.0 * i / (points - 1)));
}

}  // namespace

int main(int argc, char** argv) {
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
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
