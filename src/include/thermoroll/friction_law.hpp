// Tangled from paper/21-hot-friction.md; edit there.
#pragma once

#include <functional>

namespace thermoroll {

/// The friction coefficient at a temperature, over f, and its derivative with respect to T*.
struct RelativeFriction {
  double value, slope;
};

/// phi(T*) of f phi(T*), T* being the rise over the bulk temperature of the half-space; empty for
/// constant friction.
using FrictionLaw = std::function<RelativeFriction(double temperature)>;

/// The laws of @eq:laws: scale T0* > 0 (for linear, not 0), the floor from 0 to 1 (for
/// piecewise-linear, the end value, zero or positive), and the reference temperature.
struct FrictionTemperature {
  double scale, floor = 0, reference = 0;
};
FrictionLaw linear_friction(const FrictionTemperature& of);
FrictionLaw exponential_friction(const FrictionTemperature& of);
FrictionLaw rational_friction(const FrictionTemperature& of);
FrictionLaw piecewise_linear_friction(const FrictionTemperature& of);

}  // namespace thermoroll
