// Tangled from paper/22-creep-curve.md; edit there.
#pragma once

#include <string>
#include <vector>

#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// Polynomials of a law on from < z < to, as Chebyshev coefficients.
struct LawPiece {
  double from, to;
  std::vector<double> traction, temperature;
};

/// Half of a law: its pieces from z = 0 on, and its end.
struct LawHalf {
  double all_slips;  ///< xi* at which the stick zone vanishes
  std::vector<LawPiece> pieces;
  double last_creep;  ///< where it ends; infinite if it does not
  std::string reason;  ///< why it ends; empty if it does not
};

/// Traction and largest temperature at a creep; dimensionless, signs as the creep's.
struct LawValue {
  double traction, slope, temperature;  ///< Q*, dQ*/dxi*, T*
};

/// Q* and T*max of a scene for any creep xi*, with errors that hold everywhere.
struct CreepLaw {
  LawHalf driving, braking;
  bool grows;  ///< whether the temperature grows with the creep, as friction is constant
  double traction_error;     ///< absolute
  double temperature_error;  ///< over the largest T* at which anything sticks, or over T* beyond
};

/// The law of a scene, for both directions, whose errors are about the tolerance, from 1e-8 to
/// 1e-2: of Q* absolutely, of T* as the law says. Throws as solve_coupled does.
CreepLaw creep_law(const Scene& scene, Formulation formulation, double tolerance = 1e-4);

/// The law at a creep of either sign. Throws std::invalid_argument beyond the end of the law.
LawValue evaluate(const CreepLaw& law, double creep);

}  // namespace thermoroll
