// Tangled from paper/22-creep-curve.md; edit there.
#pragma once

#include <functional>
#include <optional>
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

/// The scene at a speed.
using SceneBySpeed = std::function<Scene(double)>;

/// The law of scenes that differ in their speed alone, for 0 < from <= speed <= to. Its stated
/// errors are below the tolerance, from 3e-7 to 1e-2, but for the exceptions of a CreepLaw; the
/// error of T* is relative to its largest at unit_creep. Throws as creep_law does, and NotResolved
/// where the laws of two speeds close to each other cannot be joined.
CreepLawBySpeed creep_law_by_speed(const SceneBySpeed& scene_at, Formulation formulation,
                                   double from, double to, double tolerance = 1e-4,
                                   const CreepRange& creeps = {});

/// The law at a creep and a speed; nothing beyond the end of one of the five laws about that speed,
/// or beyond the range of speeds. Allocates nothing.
std::optional<LawValue> evaluate(const CreepLawBySpeed& law, double creep, double speed);

}  // namespace thermoroll
