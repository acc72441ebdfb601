// The C functions: the bytes of one scene or more, after a byte for the number of threads. Those
// that ask for a known method are solved by the closed form, for the sake of speed; the coupled
// solver has a target of its own.
#include <cmath>
#include <cstring>
#include <vector>

#include "fuzz.hpp"
#include "thermoroll.h"

namespace {

bool all_finite(const thermoroll_values& x) {
  double numbers[sizeof x / sizeof(double) - 2];  // all but the limits, which only a law has
  std::memcpy(numbers, &x, sizeof numbers);
  for (const double number : numbers)
    if (!std::isfinite(number)) return false;
  return true;
}

void examine(const thermoroll_result& x) {
  if (x.status < THERMOROLL_DONE || x.status > THERMOROLL_NO_CONTACT) fuzz::fail("unknown status");
  if (std::memchr(x.message, 0, sizeof x.message) == nullptr)
    fuzz::fail("a message without an end");
  const bool done = x.status == THERMOROLL_DONE;
  if (!done && x.message[0] == '\0') fuzz::fail("an error without a word");
  if (done != (all_finite(x.value) && all_finite(x.error))) fuzz::fail("not finite, or not NaN");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<thermoroll_scene> scenes(size / sizeof(thermoroll_scene));
  if (scenes.empty() || scenes.size() > 4 || size % sizeof(thermoroll_scene) != 1) return 0;
  std::memcpy(scenes.data(), data + 1, size - 1);
  for (thermoroll_scene& scene : scenes)
    if (scene.method >= THERMOROLL_AUTO && scene.method <= THERMOROLL_GAUSS_CHEBYSHEV)
      scene.method = THERMOROLL_CLOSED_FORM;
  std::vector<thermoroll_result> results(scenes.size());
  results[0].size = sizeof(thermoroll_result);
  const int status = thermoroll_solve(scenes.data(), results.data(), scenes.size(), data[0] % 4);
  if (status == THERMOROLL_REFUSED) return 0;
  bool all = true;
  for (const thermoroll_result& x : results) {
    examine(x);
    all = all && x.status == THERMOROLL_DONE;
  }
  if (status != (all ? THERMOROLL_DONE : THERMOROLL_ROWS_FAILED)) fuzz::fail("another sum of all");
  return 0;
}
