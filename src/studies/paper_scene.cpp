// Tangled from paper/F-data-files.md; edit there.
#include "studies/paper_scene.hpp"

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
  return solve_coupled(scene(pe), with, 1e-8, {Quantity::traction, q});
}

}  // namespace thermoroll::paper
