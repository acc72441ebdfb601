// Tangled from paper/21-hot-friction.md; edit there.
#include "thermoroll/friction_law.hpp"

#include <cmath>

namespace thermoroll {

/// The law that above the reference temperature is phi(theta / T0*), given with its derivative.
template <class Phi>
FrictionLaw above_reference(const FrictionTemperature& of, Phi phi) {
  return [=](double temperature) {
    const double theta = temperature - of.reference;
    if (theta <= 0) return RelativeFriction{1, 0};
    const RelativeFriction at = phi(theta / of.scale);
    return RelativeFriction{at.value, at.slope / of.scale};
  };
}

FrictionLaw linear_friction(const FrictionTemperature& of) {
  return above_reference(of, [floor = of.floor](double x) {
    return 1 - x > floor ? RelativeFriction{1 - x, -1} : RelativeFriction{floor, 0};
  });
}

FrictionLaw exponential_friction(const FrictionTemperature& of) {
  return above_reference(of, [floor = of.floor](double x) {
    const double falls = (1 - floor) * std::exp(-x);
    return RelativeFriction{floor + falls, -falls};
  });
}

FrictionLaw rational_friction(const FrictionTemperature& of) {
  return above_reference(of, [floor = of.floor](double x) {
    const double falls = (1 - floor) / (1 + x);
    return RelativeFriction{floor + falls, -falls / (1 + x)};
  });
}

FrictionLaw piecewise_linear_friction(const FrictionTemperature& of) {
  return above_reference(of, [floor = of.floor](double x) {
    return x < 1 ? RelativeFriction{1 + (floor - 1) * x, floor - 1} : RelativeFriction{floor, 0};
  });
}

}  // namespace thermoroll
