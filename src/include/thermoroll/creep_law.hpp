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
  std::vector<double> traction, temperature, slip_length;
};

/// Half of a law: its pieces from z = 0 on, and its end.
struct LawHalf {
  double all_slips;  ///< xi* at which the stick zone vanishes
  std::vector<LawPiece> pieces;
  double last_creep;  ///< where it ends; infinite if it does not
  std::string reason;  ///< why it ends; empty if it does not
};

/// A law at a creep; dimensionless, the traction with the creep's sign.
struct LawValue {
  double traction, slope;  ///< Q*, dQ*/dxi*
  double temperature;      ///< the largest T*
  double border;           ///< c0, -1 in full slip
};

/// Q* and T*max of a scene for any creep xi*, with errors that hold everywhere.
struct CreepLaw {
  LawHalf driving, braking;
  double traction_error;  ///< absolute
  /// Over the T* at which the stick zone vanishes; in full slip times xi* / xi1* of @eq:law-variable.
  double temperature_error;
};

/// The law of a scene, for both directions, whose errors are about the tolerance, from 1e-8 to
/// 1e-2: of Q* absolutely, of T* as the law says. Throws as solve_coupled does.
CreepLaw creep_law(const Scene& scene, Formulation formulation, double tolerance = 1e-4);

/// The law at a creep of either sign. Throws std::invalid_argument beyond the end of the law.
LawValue evaluate(const CreepLaw& law, double creep);

}  // namespace thermoroll
