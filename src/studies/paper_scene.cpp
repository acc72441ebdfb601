// Tangled from paper/F-data-files.md; edit there.
#include "studies/paper_scene.hpp"

#include "thermoroll/friction_law.hpp"

namespace thermoroll::paper {

Scene scene(double pe) { return {friction, pe, heating}; }

Carter closed_form(double q) { return carter(friction, q); }

PublishedSolution scheme(double q, double pe, const PublishedOptions& options) {
  return solve_published(scene(pe), q, formulation, options);
}

double scheme_max(double q, double pe, const PublishedOptions& options) {
  return published_max_temperature(scheme(q, pe, options), pe).temperature;
}

CoupledSolution coupled(double q, double pe, Formulation with) {
  return solve_coupled(scene(pe), {with, 1e-8}, {Quantity::traction, q});
}

Scene wheel(bool two_bodies, bool falls) {
  PhysicalScene steel = wheel_on_rail();
  if (two_bodies) {
    steel.conductivity_2 = steel.conductivity;
    steel.expansion_2 = steel.expansion;
  }
  Scene scene = scene_of(steel, friction);
  if (falls) scene.law = linear_friction({1600 / units_of(steel, friction).temperature});
  return scene;
}

TractionLimit largest_traction(const Scene& scene) {
  const Prescribed small{Quantity::traction, 0.1 * scene.friction};
  return *solve_coupled(scene, {Formulation::corrected, 1e-6}, small).limit;
}

}  // namespace thermoroll::paper
