// Tangled from paper/F-data-files.md; edit there.
#include <cmath>

#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "thermoroll/kernels.hpp"

namespace thermoroll {
namespace {

void kernels(std::ostream& out) {
  row(out, "zeta", "N1", "N2", "M");
  for (const double zeta : grid(-6, 6, 600))
    if (zeta != 0) row(out, zeta, kernel::N1(zeta), kernel::N2(zeta), kernel::M(zeta));
}

const FigureData kernels_data{"kernels", kernels};

void geometry(std::ostream& out) {
  row(out, "part", "x", "y");
  const double radius = 2, axle = std::sqrt(radius * radius - 1), edge = std::asin(1 / radius);
  for (const double angle : grid(edge, 2 * pi - edge, 180))
    row(out, "cylinder", radius * std::sin(angle), axle - radius * std::cos(angle));
  const double c0 = paper::closed_form(0.5).c0;
  for (const double x : {-4.4, 4.4}) row(out, "half_space", x, 0);
  for (const double x : {-1.0, c0}) row(out, "stick", x, 0);
  for (const double x : {c0, 1.0}) row(out, "slip", x, 0);
}

const FigureData geometry_data{"geometry", geometry};

}  // namespace
}  // namespace thermoroll
