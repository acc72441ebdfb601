// Tangled from paper/15-speed-and-accuracy.md; edit there.
#pragma once

#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// c0, kappa, the largest T* and xi*; all NaN where Newton's method or the border does not settle.
struct PanelSolution {
  double border, load_ratio, hottest, creep;
};

/// Solve by product integration on graded panels of five nodes each, for 0 < traction < friction
/// and one insulated body. The nodes are those of the slip zone, a multiple of 5 from 10 on.
/// Throws std::invalid_argument.
PanelSolution solve_on_panels(const Scene& scene, double traction, Formulation formulation,
                              int nodes);

}  // namespace thermoroll
