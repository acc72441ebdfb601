// The law of all creeps: a byte for the formulation, the law of friction and whether it is for a
// range of speeds, then the bytes of the friction, the Peclet number, the heating, the tolerance,
// the cylinder's conductivity, heating and Peclet number, the bulk difference, the temperature,
// floor and reference of a law of friction, and a creep. A law at a tolerance below 1e-2 takes too
// long for this.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>

#include "fuzz.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/creep_law.hpp"
#include "thermoroll/creep_law_by_speed.hpp"

using namespace thermoroll;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Whatever creep is asked for, the law has a value there, or ends before.
void examine(const CreepLaw& law, double friction, double creep) {
  const double errors = law.traction_error + law.border_error + law.temperature_error;
  if (!std::isfinite(errors) || errors < 0) fuzz::fail("an error that is none");
  for (const double factor : {1.0, 0.5, 1e-3, -1.0}) {
    const double at = law.no_slip_creep + factor * (creep - law.no_slip_creep);
    const std::optional<LawValue> x = evaluate(law, at);
    const LawSide side = side_of(law, at);
    if (x && !(side.size <= side.half.last_creep)) fuzz::fail("a value beyond the end");
    if (!x && side.size < side.half.last_creep) fuzz::fail("no value before the end");
    if (!x) continue;
    if (!std::isfinite(x->traction + x->slope + x->temperature)) fuzz::fail("not finite");
    if (!(-1 <= x->border && x->border <= 1)) fuzz::fail("a border outside of the contact");
    if (std::abs(x->traction) > 100 * friction) fuzz::fail("a traction beyond friction");
  }
}

/// A law for speeds from 1 to 1.5 has finite values and errors, and none at another speed.
void examine(const CreepLawBySpeed& law, double creep) {
  for (const CreepLaw& one : law.laws) examine(one, infinite, creep);
  const double errors = law.traction_error + law.border_error + law.temperature_error;
  if (!std::isfinite(errors) || errors < 0) fuzz::fail("an error that is none");
  for (const double speed : {1.0, 1.2, 1.5}) {
    const std::optional<LawValue> x = evaluate(law, creep, speed);
    if (x && !std::isfinite(x->traction + x->slope + x->temperature)) fuzz::fail("not finite");
  }
  if (evaluate(law, creep, 0.99) || evaluate(law, creep, 1.51)) fuzz::fail("beyond its speeds");
}

/// The same bodies and the same law in kelvin at another speed; friction may be a law's.
Scene at_speed(Scene scene, LawOfFriction friction, double speed) {
  scene.peclet *= speed;
  scene.roller.peclet *= speed;
  scene.bulk_difference /= speed;
  friction.of.scale /= speed;
  friction.of.reference /= speed;
  if (scene.law) scene.law = friction;
  return scene;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::array<double, 12> x{};
  if (size != 1 + sizeof x) return 0;
  std::memcpy(x.data(), data + 1, sizeof x);
  const Formulation formulation = data[0] % 2 == 0 ? Formulation::corrected : Formulation::printed;
  const LawOfFriction friction{static_cast<LawKind>(data[0] / 2 % 4), {x[8], x[9], x[10]}};
  Scene scene{x[0], x[1], x[2], {x[4], x[5], x[6]}};
  scene.bulk_difference = x[7];
  fuzz::done_or_refused<std::invalid_argument, std::runtime_error, NotResolved>([&] {
    if (x[8] != 0) {
      check(friction);
      scene.law = friction;
    }
    const double tolerance = std::max(x[3], 1e-2);
    if (!std::isfinite(x[11])) return;
    if (data[0] / 8 % 2 == 0)
      return examine(creep_law(scene, formulation, tolerance), scene.friction, x[11]);
    const auto at = [&](double speed) { return at_speed(scene, friction, speed); };
    examine(creep_law_by_speed(at, formulation, 1, 1.5, tolerance), x[11]);
  });
  return 0;
}
