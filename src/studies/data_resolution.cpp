// Tangled from paper/11-what-the-grid-sees.md; edit there.
#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "studies/claims.hpp"
#include "studies/data.hpp"
#include "studies/figure_data.hpp"
#include "studies/paper_scene.hpp"
#include "studies/resolution.hpp"
#include "support/number_text.hpp"
#include "thermoroll/published_scheme.hpp"

namespace thermoroll {
namespace {

void seen(std::ostream& out) {
  row(out, "peclet", "nodes", "seen", "law");
  const Carter c = paper::closed_form(0.5);
  for (const double speed : grid(1, 5, 32))
    for (const double size : grid(1, 3.3, 23)) {
      const double peclet = std::pow(10, speed), exact = exact_load_change(c, peclet);
      const int nodes = static_cast<int>(std::lround(std::pow(10, size)));
      row(out, peclet, nodes, scheme_load_change(c, peclet, nodes) / exact,
          1 - missed_load_change(c, peclet, nodes) / exact);
    }
}

const FigureData seen_data{"seen", seen};

void values_on_sampling(nlohmann::ordered_json& v) {
  const Carter half = paper::closed_form(0.5);
  const double all = first_order_load_change(0.5) / (paper::friction * paper::heating);
  const double spacing = pi / 100;
  const double mean_sine = 16 * missed_load_change(half, 1, 99) / (spacing * spacing * all);
  v["fails_c0"] = fixed(half.c0, 4);
  v["fails_mean_sine"] = fixed(mean_sine, 2);
  for (const auto& [name, missed] : {std::pair{"1", 0.01}, {"01", 0.001}}) {
    const double per_speed = pi * std::sqrt(mean_sine / (16 * missed));
    const double nodes = per_speed * paper::peclet;
    v[std::string("fails_nodes_") + name] = fixed(per_speed, 1);
    v[std::string("fails_steel_") + name] = fixed(1000 * std::round(nodes / 1000), 0);
    v[std::string("fails_memory_") + name] = fixed(8e-9 * nodes * nodes, 0);
  }
}

PublishedSolution cycling(int nodes) {
  return solve_published({paper::friction, 100, 0.5}, 0.5, Formulation::corrected, {nodes});
}

void cycle(std::ostream& out) {
  row(out, "nodes", "step", "c0", "traction");
  for (const int nodes : {89, 90, 91}) {
    const PublishedSolution solution = cycling(nodes);
    for (std::size_t i = 0; i < std::min<std::size_t>(solution.steps.size(), 140); ++i)
      row(out, nodes, i + 1, solution.steps[i].c0, solution.steps[i].traction);
  }
}

const FigureData cycle_data{"cycle", cycle};

void values_on_cycle(nlohmann::ordered_json& v) {
  const PublishedSolution undecided = cycling(90);
  Eigen::Index nearest = 0;
  (undecided.grid.t.array() - undecided.c0).abs().minCoeff(&nearest);
  const double node = undecided.grid.t(nearest);
  double hot = 1, cold = 0;  // of the last three steps, the tractions nearest to the gap
  for (auto step = undecided.steps.rbegin(); step != undecided.steps.rbegin() + 3; ++step)
    if (step->c0 < node)
      hot = std::min(hot, step->traction);
    else
      cold = std::max(cold, step->traction);
  int struck = 0;
  for (int nodes = 20; nodes < 120; ++nodes) struck += cycling(nodes).converged ? 0 : 1;
  v["cycle_node"] = fixed(node, 4);
  v["cycle_hot"] = fixed(hot, 4);
  v["cycle_cold"] = fixed(cold, 4);
  v["cycle_struck"] = std::to_string(struck);
}

}  // namespace

void values_on_resolution(nlohmann::ordered_json& v) {
  values_on_sampling(v);
  values_on_cycle(v);
}

}  // namespace thermoroll
