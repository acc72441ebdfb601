// Tangled from paper/05-closed-form.md; edit there.
#pragma once

#include <functional>

namespace thermoroll {

/// A dimensionless heat flux v* p* on (from, to), zero elsewhere.
struct HeatFlux {
  double from;  ///< start of the heated zone, c0 in rolling, -1 in sliding
  double to;    ///< its end, 1 in a contact
  /// The flux at the distances left = s - from >= 0 and right = to - s >= 0 from the ends.
  std::function<double(double left, double right)> density;
};

}  // namespace thermoroll
