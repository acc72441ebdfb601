// Tangled from paper/F-data-files.md; edit there.
#include "studies/data.hpp"
#include "studies/paper_scene.hpp"

namespace thermoroll {
namespace {

void tractions_of_load(std::ostream& out) {
  row(out, "method", "traction", "s", "q");
  for (const double load : paper::tractions) {
    const Carter c = paper::closed_form(load);
    for (const double s : grid(-1, 1, 400)) row(out, "converged", load, s, carter_traction(c, s));
  }
  for (const double load : paper::tractions) {
    const PublishedSolution x = paper::scheme(load, paper::peclet);
    for (const double s : x.grid.t)
      row(out, "printed", load, s, published_traction(x, paper::friction, s));
  }
}

const FigureData traction_data{"traction", tractions_of_load};

void slip_of_load(std::ostream& out) {
  row(out, "method", "traction", "s", "v");
  for (const double load : paper::tractions) {
    const Carter c = paper::closed_form(load);
    row(out, "converged", load, -1, 0);
    for (const double u : grid(0, 1, 200)) {  // v starts like a square root: crowd the points there
      const double s = c.c0 + (1 - c.c0) * u * u;
      row(out, "converged", load, s, carter_slip(c, s));
    }
  }
  for (const double load : paper::tractions) {
    const PublishedSolution x = paper::scheme(load, paper::peclet);
    for (int k = 0; k < x.slip.size(); ++k) row(out, "printed", load, x.grid.t(k), x.slip(k));
  }
}

const FigureData slip_data{"slip", slip_of_load};

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
