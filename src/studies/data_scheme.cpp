// Tangled from paper/F-data-files.md; edit there.
#include "studies/cached_scheme.hpp"
#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

void share_found(std::ostream& out) {
  row(out, "peclet", "n", "load", "temperature");
  for (const double pe : {100.0, paper::peclet}) {
    const CoupledSolution exact = paper::coupled(0.5, pe);
    for (const int n : {25, 35, 50, 70, 100, 140, 200, 280, 400, 560, 800}) {
      const Scene scene = paper::scene(pe);
      const auto x = solve_cached(scene, 0.5, paper::formulation, NodeKernel::sample, {n});
      const double top = cached_max_temperature(x, pe, NodeKernel::sample).temperature;
      row(out, pe, n, (1 - x.load_ratio) / (1 - exact.value(Quantity::load_ratio)),
          top / exact.value(Quantity::max_temperature));
    }
  }
}

const FigureData nodes_data{"nodes", share_found};

void resolution(std::ostream& out) {
  row(out, "$n$", "$c_0$", "$1-\\kappa$", "$\\gamma_0$", "$T^*_{\\max}$", "outer", "inner");
  for (const int nodes : {50, 100, 200, 400}) {
    const PublishedSolution x = paper::scheme(0.5, paper::peclet, {nodes});
    const double top = published_max_temperature(x, paper::peclet).temperature;
    row(out, nodes, fixed(x.c0, 6), scientific(1 - x.load_ratio, 2), scientific(x.gamma0, 2),
        fixed(top, 6), x.outer_iterations, x.inner_iterations);
  }
  const CoupledSolution x = paper::coupled(0.5, paper::peclet);
  row(out, "**coupled**", fixed(x.value(Quantity::stick_slip_border), 6),
      scientific(1 - x.value(Quantity::load_ratio), 2), scientific(x.value(Quantity::gamma0), 2),
      fixed(x.value(Quantity::max_temperature), 6), "–", "–");
}

const FigureData resolution_data{"resolution", resolution};

void coincident(std::ostream& out) {
  row(out, "$\\Theta(0)$", "$T^*_{\\max}$", "outer steps");
  for (const double value : {0.0, 0.5, 1.0}) {
    PublishedOptions options;
    options.heaviside_at_zero = value;
    const PublishedSolution x = paper::scheme(0.5, 5000, options);
    row(out, value, fixed(published_max_temperature(x, 5000).temperature, 6), x.outer_iterations);
  }
}

const FigureData coincident_data{"coincident", coincident};

}  // namespace
}  // namespace thermoroll
