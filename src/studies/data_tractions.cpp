// Tangled from paper/F-data-files.md; edit there.
#include <string>

#include "studies/data.hpp"
#include "studies/paper_scene.hpp"

namespace thermoroll {
namespace {

void with_heat(std::ostream& out, const std::string& method, double load, Formulation with,
               bool slip) {
  const Carter cold = paper::closed_form(load);
  const Profile p = profile(paper::coupled(load, paper::peclet, with));
  for (Eigen::Index i = 0; i < p.s.size(); ++i) {
    const double s = p.s(i), value = slip ? p.slip(i) : p.traction(i);
    const double without = slip ? carter_slip(cold, s) : carter_traction(cold, s);
    row(out, method, load, s, value, value - without);
  }
}

void by_the_scheme(std::ostream& out, double load, bool slip) {
  const PublishedSolution x = paper::scheme(load, paper::peclet);
  const PublishedSolution cold =
      solve_published({paper::friction, paper::peclet, 0}, load, paper::formulation, {});
  for (int k = 0; k < x.slip.size(); ++k) {
    const double s = x.grid.t(k);
    const double value = slip ? x.slip(k) : published_traction(x, paper::friction, s);
    const double without = slip ? cold.slip(k) : published_traction(cold, paper::friction, s);
    row(out, "scheme", load, s, value, value - without);
  }
}

void without_heat(std::ostream& out, double load, bool slip) {
  const Carter c = paper::closed_form(load);
  if (slip) row(out, "cold", load, -1, 0, 0);
  for (const double u : slip ? grid(0, 1, 200) : grid(-1, 1, 400)) {
    const double s = slip ? c.c0 + (1 - c.c0) * u * u : u;
    row(out, "cold", load, s, slip ? carter_slip(c, s) : carter_traction(c, s), 0);
  }
}

void of_load(std::ostream& out, bool slip) {
  row(out, "method", "traction", "s", slip ? "v" : "q", "change");
  for (const double load : paper::tractions) {
    without_heat(out, load, slip);
    with_heat(out, "corrected", load, Formulation::corrected, slip);
    by_the_scheme(out, load, slip);
  }
  with_heat(out, "printed", 0.5, Formulation::printed, slip);
}

const FigureData traction_data{"traction", [](std::ostream& out) { of_load(out, false); }};
const FigureData slip_data{"slip", [](std::ostream& out) { of_load(out, true); }};

void creep_curve(std::ostream& out) {
  row(out, "method", "creep", "traction");
  for (const double xi : grid(0, 2 * paper::friction / pi, 100))
    row(out, "converged", xi, carter_creep_curve(paper::friction, xi));
  for (const double load : grid(0.05, 0.59, 9))
    row(out, "printed", paper::scheme(load, paper::peclet).creep, load);
}

const FigureData creep_data{"creep", creep_curve};

}  // namespace
}  // namespace thermoroll
