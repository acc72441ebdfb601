// Tangled from paper/22-creep-curve.md; edit there.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// The Chebyshev coefficients of a piece.
constexpr int law_terms = 11;
using LawSeries = std::array<double, law_terms>;

/// Polynomials of a law on from < z < to: up to z = 1 of Q* / xi*, T* and the length of the slip
/// zone over z^2, and beyond of Q*, T* times 2 - z, and 2.
struct LawPiece {
  double from, to;
  LawSeries traction, temperature, slip_length;
};

/// Half of a law: its pieces from z = 0 on, and its end. The size of a creep is its difference from
/// that without slip.
struct LawHalf {
  double unit_creep = 1;  ///< the size at z = 1: where the stick zone vanishes, or the end before
  std::vector<LawPiece> pieces{};
  double last_creep = -1;  ///< the size where it ends; infinite if it does not, and
                           ///< negative for a half that was not asked for
  std::string reason{};    ///< why it ends; empty if it does not
};

/// Q*, T*max and c0 of a scene for any creep xi*, with errors that hold everywhere.
struct CreepLaw {
  LawHalf driving, braking;
  double traction_error, border_error;  ///< estimated, absolute
  double temperature_error;  ///< of T* in partial slip; in full slip times the size over unit_creep
  double no_slip_creep = 0, no_slip_traction = 0;  ///< @eq:no-slip; 0 for one bulk temperature
  double coldest = 0;                              ///< T* of the colder body far away
};

/// The half of a law to which a creep belongs, and its size there.
struct LawSide {
  const LawHalf& half;
  double sign, size;
};
LawSide side_of(const CreepLaw& law, double creep);

/// The creeps xi* that a law is made for.
struct CreepRange {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

/// A law evaluated at a creep; dimensionless. The traction has the creep's sign, and with a bulk
/// difference that of the state without slip is added.
struct LawValue {
  double traction, slope;  ///< Q*, dQ*/dxi*
  double temperature;      ///< the largest T*
  double border;           ///< c0, -1 in full slip
};

/// The law of a scene for a range of creeps in both directions, whatever its own is. The stated
/// errors are below the tolerance, from 1e-7 to 1e-2, or ten times that where a law of friction has
/// a kink or heat is strong: that of T* relative to T* at unit_creep. With a bulk difference that
/// of T* is relative to what the difference makes as well, and more next to no slip; that of c0 is
/// below 300 times the tolerance. Throws std::invalid_argument for data out of range, NotResolved
/// where the tolerance is met nowhere or the curve begins without a contact.
CreepLaw creep_law(const Scene& scene, Formulation formulation, double tolerance = 1e-4,
                   const CreepRange& range = {});

/// The law at a creep of either sign; nothing beyond the end of the law. Allocates nothing.
std::optional<LawValue> evaluate(const CreepLaw& law, double creep);

/// The error of its border: border_error; zero in full slip, but for creeps next to its onset.
double border_error_at(const CreepLaw& law, double creep);

/// The SI values of one xi*, Q* and T*: a fraction of the speed, N/m and degree C; V in m/s and the
/// bulk temperature in degree C.
struct LawUnits {
  double creep = 1, traction = 1, temperature = 1;
  double speed = 0;
  std::optional<double> bulk_temperature{};
};

LawUnits law_units(const PhysicalScene& si, double friction);

}  // namespace thermoroll
