// Tangled from paper/21-hot-friction.md; edit there.
#pragma once

#include <functional>

namespace thermoroll {

/// The friction coefficient at a temperature, as a fraction of f, zero or positive, and its exact
/// derivative with respect to T*, on which results depend.
struct RelativeFriction {
  double value, slope;
};

/// phi(T*) of f phi(T*), T* being the rise over the bulk temperature of the half-space; empty for
/// constant friction. Continuous; may be called from several threads at once.
using FrictionLaw = std::function<RelativeFriction(double temperature)>;

enum class LawKind { linear, exponential, rational, piecewise_linear };

/// The numbers of @eq:laws, on the scale of T*: T0* > 0 (for linear, not 0; below 0 friction
/// rises), the floor from 0 to 1 (for piecewise-linear, the end value, zero or positive), and the
/// reference temperature.
struct FrictionTemperature {
  double scale, floor = 0, reference = 0;
};

/// A law of @eq:laws; if a FrictionLaw holds one, its target<LawOfFriction>() is that law.
struct LawOfFriction {
  LawKind kind;
  FrictionTemperature of;
  RelativeFriction operator()(double temperature) const;
};
FrictionLaw linear_friction(const FrictionTemperature& of);
FrictionLaw exponential_friction(const FrictionTemperature& of);
FrictionLaw rational_friction(const FrictionTemperature& of);
FrictionLaw piecewise_linear_friction(const FrictionTemperature& of);

/// Throw std::invalid_argument unless its numbers are in their ranges.
void check(const LawOfFriction& law);

}  // namespace thermoroll
