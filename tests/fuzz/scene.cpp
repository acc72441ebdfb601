// The coupled solver: a byte for the formulation and for what is given, then the bytes of the
// friction, the value given, the Peclet number, the heating and the tolerance.
#include <array>
#include <cstring>
#include <stdexcept>

#include "fuzz.hpp"
#include "thermoroll/coupled.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace thermoroll;
  std::array<double, 5> x{};
  if (size != 1 + sizeof x) return 0;
  std::memcpy(x.data(), data + 1, sizeof x);
  const Quantity kinds[] = {Quantity::traction, Quantity::creep, Quantity::stick_slip_border};
  const Formulation formulation = data[0] % 2 == 0 ? Formulation::corrected : Formulation::printed;
  const Prescribed given{kinds[data[0] / 2 % 3], x[1]};
  fuzz::done_or_refused<std::invalid_argument, std::runtime_error, NotResolved>([&] {
    const CoupledSolution found = solve_coupled({x[0], x[2], x[3]}, formulation, x[4], given);
    if (!found.value.allFinite() || !found.error.allFinite()) fuzz::fail("not finite");
    if (found.unknowns < 1 || found.newton_steps < 1) fuzz::fail("nothing was solved");
  });
  return 0;
}
