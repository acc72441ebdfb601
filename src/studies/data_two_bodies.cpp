// Tangled from paper/19-braking-and-alike-bodies.md; edit there.
#include <cmath>

#include <nlohmann/json.hpp>

#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/solution.hpp"

namespace thermoroll {
namespace {

double traction_on_curve(const Scene& scene, double creep) {
  const Approach exact{Formulation::corrected, 1e-8, Method::coupled};
  return std::abs(solve(scene, {Quantity::creep, creep}, exact).value(Quantity::traction));
}

void braking_curves(std::ostream& out) {
  row(out, "creep", "carter", "driving", "identical", "braking");
  row(out, 0, 0, 0, 0, 0);
  const Scene paper{paper::friction, 100, 1}, identical{paper::friction, 100, 1, {1, 1}};
  for (const double creep : grid(0.01, 0.45, 44))
    row(out, creep, carter_creep_curve(paper::friction, creep), traction_on_curve(paper, creep),
        traction_on_curve(identical, creep), traction_on_curve(paper, -creep));
}

const FigureData braking_data{"braking", braking_curves};

double found(const Scene& scene, double traction, Quantity what) {
  return solve(scene, {Quantity::traction, traction}).value(what);
}

void values_of_strong_heat(nlohmann::ordered_json& v) {
  const Scene paper{paper::friction, 100, 1}, identical{paper::friction, 100, 1, {1, 1}};
  v["two_driving"] = fixed(found(paper, 0.45, Quantity::creep), 4);
  v["two_identical"] = fixed(found(identical, 0.45, Quantity::creep), 4);
  v["two_braking"] = fixed(-found(paper, -0.45, Quantity::creep), 4);
}

}  // namespace

void values_on_two_bodies(nlohmann::ordered_json& v) {
  values_of_strong_heat(v);
  PhysicalScene steel = wheel_on_rail();
  const double unit = units_of(steel, paper::friction).temperature;
  const Scene one = scene_of(steel, paper::friction);
  steel.conductivity_2 = steel.conductivity;
  steel.expansion_2 = steel.expansion;
  const Scene both = scene_of(steel, paper::friction);
  const double drives = found(one, 0.5, Quantity::creep);
  const double brakes = found(one, -0.5, Quantity::creep);
  v["two_steel_creep"] = fixed(100 * (-brakes / drives - 1), 1);
  v["two_steel_insulated"] = fixed(unit * found(one, 0.5, Quantity::max_temperature), 0);
  v["two_steel_identical"] = fixed(unit * found(both, 0.5, Quantity::max_temperature), 0);
}

}  // namespace thermoroll
