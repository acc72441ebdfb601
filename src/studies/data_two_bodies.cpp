// Tangled from paper/19-braking-and-alike-bodies.md; edit there.
#include <cmath>

#include <nlohmann/json.hpp>

#include "studies/data.hpp"
#include "studies/paper_case.hpp"
#include "support/number_text.hpp"
#include "thermoroll/solution.hpp"

namespace thermoroll {
namespace {

void braking_curves(std::ostream& out) {
  row(out, "creep", "carter", "driving", "identical", "braking");
  row(out, 0, 0, 0, 0, 0);
  const Scene paper{paper::friction, 100, 1}, identical{paper::friction, 100, 1, {1, 1}};
  const Approach exact{Method::coupled, Formulation::corrected, 0, 1e-8};
  const auto traction = [&](const Scene& scene, double creep) {
    return std::abs(solve(scene, {Quantity::creep, creep}, exact).value(Quantity::traction));
  };
  for (const double creep : grid(0.01, 0.45, 44))
    row(out, creep, carter_creep_curve(paper::friction, creep), traction(paper, creep),
        traction(identical, creep), traction(paper, -creep));
}

const FigureData braking_data{"braking", braking_curves};

}  // namespace

void values_on_two_bodies(nlohmann::ordered_json& v) {
  const auto found = [](const Scene& scene, double traction, Quantity what) {
    return solve(scene, {Quantity::traction, traction}).value(what);
  };
  const Scene strong{paper::friction, 100, 1}, alike{paper::friction, 100, 1, {1, 1}};
  v["two_driving"] = fixed(found(strong, 0.45, Quantity::creep), 4);
  v["two_identical"] = fixed(found(alike, 0.45, Quantity::creep), 4);
  v["two_braking"] = fixed(-found(strong, -0.45, Quantity::creep), 4);
  const PhysicalScene steel = wheel_on_rail();
  const Scene one = scene_of(steel, paper::friction);
  Scene both = one;
  both.roller = {1, one.heating};
  const double creep = found(one, 0.5, Quantity::creep);
  const double unit = units_of(steel, paper::friction).temperature;
  v["two_steel_creep"] = fixed(100 * (-found(one, -0.5, Quantity::creep) / creep - 1), 1);
  v["two_steel_insulated"] = fixed(unit * found(one, 0.5, Quantity::max_temperature), 0);
  v["two_steel_identical"] = fixed(unit * found(both, 0.5, Quantity::max_temperature), 0);
}

}  // namespace thermoroll
