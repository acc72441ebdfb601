// Tangled from paper/22-creep-curve.md; edit there.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "thermoroll/creep_law.hpp"

namespace thermoroll {

/// Laws at rising speeds: five in equal ratios to a piece of the range, of which neighbours share
/// one; or a single law, for one speed.
struct CreepLawBySpeed {
  std::vector<double> speeds;
  std::vector<CreepLaw> laws;
  double traction_error, border_error;  ///< estimated, absolute, as those of a CreepLaw
  double temperature_error;             ///< of T* times the speed over the first one
};

struct LawEnd {
  double creep;        ///< xi*, infinite if there is no end
  std::string reason;  ///< empty if there is none
};

/// The scene at a speed.
using SceneBySpeed = std::function<Scene(double)>;

/// The law for all creeps of scenes that differ in their speed alone, for 0 < from <= speed <= to.
/// Its stated errors are below the tolerance, from 3e-7 to 1e-2, but for the exceptions of a
/// CreepLaw; the error of T* is relative to its largest at unit_creep. Throws as creep_law does,
/// where the laws of two speeds close to each other cannot be joined. Calls scene_at from several
/// threads at once.
CreepLawBySpeed creep_law_by_speed(const SceneBySpeed& scene_at, Formulation formulation,
                                   double from, double to, double tolerance = 1e-4);

/// The law at a creep and a speed; nothing beyond the end of one of the five laws about that speed,
/// or beyond the range of speeds. Allocates nothing.
std::optional<LawValue> evaluate(const CreepLawBySpeed& law, double creep, double speed);

/// The creep xi* of which @eq:aligned-creep takes shares, for law i of the piece from the first law
/// on: that at which all slips, or 1 if one of the five does not go on from there.
double scale_of(const CreepLawBySpeed& law, std::size_t first, std::size_t i, bool brakes);

/// The first end of driving or braking, counted from no slip, at any speed of the laws.
LawEnd earliest_end(const CreepLawBySpeed& law, bool brakes);

}  // namespace thermoroll
