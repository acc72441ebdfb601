// Tangled from paper/21-hot-friction.md; edit there.
#include "thermoroll/friction_law.hpp"

#include <cmath>

#include "thermoroll/scene.hpp"

namespace thermoroll {

namespace {

/// phi at x = theta / T0* > 0 (for the linear law, of either sign), and its derivative by x.
RelativeFriction above_reference(LawKind kind, double floor, double x) {
  const double falls = (1 - floor) / (1 + x), decays = (1 - floor) * std::exp(-x);
  switch (kind) {
    case LawKind::linear:
      return 1 - x > floor ? RelativeFriction{1 - x, -1} : RelativeFriction{floor, 0};
    case LawKind::exponential:
      return {floor + decays, -decays};
    case LawKind::rational:
      return {floor + falls, -falls / (1 + x)};
    case LawKind::piecewise_linear:
      break;
  }
  return x < 1 ? RelativeFriction{1 + (floor - 1) * x, floor - 1} : RelativeFriction{floor, 0};
}

}  // namespace

RelativeFriction LawOfFriction::operator()(double temperature) const {
  const double theta = temperature - of.reference;
  if (theta <= 0) return {1, 0};
  const RelativeFriction at = above_reference(kind, of.floor, theta / of.scale);
  return {at.value, at.slope / of.scale};
}

FrictionLaw linear_friction(const FrictionTemperature& of) {
  return LawOfFriction{LawKind::linear, of};
}

FrictionLaw exponential_friction(const FrictionTemperature& of) {
  return LawOfFriction{LawKind::exponential, of};
}

FrictionLaw rational_friction(const FrictionTemperature& of) {
  return LawOfFriction{LawKind::rational, of};
}

FrictionLaw piecewise_linear_friction(const FrictionTemperature& of) {
  return LawOfFriction{LawKind::piecewise_linear, of};
}

void check(const LawOfFriction& law) {
  const auto& [scale, floor, reference] = law.of;
  if (law.kind == LawKind::linear)
    require(scale != 0, "friction-temperature", scale, "above 0, or below it where friction rises");
  else
    require(scale > 0, "friction-temperature", scale, "positive, as the law is not linear");
  if (law.kind == LawKind::piecewise_linear)
    require(floor >= 0, "friction-floor", floor, "zero or positive");
  else
    require(0 <= floor && floor <= 1, "friction-floor", floor, "from 0 to 1");
  require(true, "friction-reference-temperature", reference, "finite");
}

}  // namespace thermoroll
