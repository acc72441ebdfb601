// The coupled solver: a byte for the formulation, for what is given, the direction, the law and the
// branch, then the bytes of the friction, the value given, the Peclet number, the heating and the
// tolerance and, if there are more, of the cylinder's conductivity and heating and, if there are
// still more, its Peclet number, the bulk difference, and the temperature, floor and reference of a
// law of friction.
#include <array>
#include <cstring>
#include <stdexcept>

#include "fuzz.hpp"
#include "thermoroll/coupled.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace thermoroll;
  std::array<double, 12> x{};
  const std::size_t numbers = (size - 1) / sizeof(double);
  if (size != 1 + numbers * sizeof(double)) return 0;
  if (numbers != 5 && numbers != 7 && numbers != x.size()) return 0;
  std::memcpy(x.data(), data + 1, size - 1);
  const Quantity kinds[] = {Quantity::traction, Quantity::creep, Quantity::stick_slip_border};
  const Formulation formulation = data[0] % 2 == 0 ? Formulation::corrected : Formulation::printed;
  const Branch branch = data[0] / 48 % 2 == 0 ? Branch::rising : Branch::falling;
  const Prescribed given{kinds[data[0] / 2 % 3], x[1], branch};
  const Direction direction = data[0] / 6 % 2 == 0 ? Direction::driving : Direction::braking;
  Scene scene{x[0], x[2], x[3], {x[5], x[6], x[7]}, direction};
  scene.bulk_difference = x[8];
  const LawOfFriction law{static_cast<LawKind>(data[0] / 12 % 4), {x[9], x[10], x[11]}};
  fuzz::done_or_refused<std::invalid_argument, std::runtime_error, NotResolved, BeyondLimit>([&] {
    if (x[9] != 0) {
      check(law);
      scene.law = law;
    }
    const CoupledSolution found = solve_coupled(scene, {formulation, x[4]}, given);
    if (!found.value.allFinite() || !found.error.allFinite()) fuzz::fail("not finite");
    if (found.unknowns < 1 || found.newton_steps < 1) fuzz::fail("nothing was solved");
  });
  return 0;
}
