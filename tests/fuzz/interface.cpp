// The C functions for scenes: the bytes of one scene or more, after a byte for the number of
// threads. Those that ask for a known method are solved by the closed form, for the sake of speed;
// the coupled solver has a target of its own.
#include <algorithm>
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

bool are_finite(const double* numbers, std::size_t count) {
  return std::all_of(numbers, numbers + count, [](double x) { return std::isfinite(x); });
}

// What is in SI units is all there, but for the absolute temperature, or nothing is.
void examine_si(const thermoroll_result& x, bool in_si) {
  constexpr std::size_t count = sizeof x.physical / sizeof(double) - 1;
  if (std::memchr(x.notes, 0, sizeof x.notes) == nullptr) fuzz::fail("notes without an end");
  for (const thermoroll_physical* of : {&x.physical, &x.physical_error})
    if (are_finite(&of->half_width, count) != in_si) fuzz::fail("not finite, or not NaN, in SI");
  if (are_finite(&x.unit.length, sizeof x.unit / sizeof(double)) != in_si) fuzz::fail("units");
}

void examine(const thermoroll_scene& scene, const thermoroll_result& x) {
  if (x.status < THERMOROLL_DONE || x.status > THERMOROLL_NO_CONTACT) fuzz::fail("unknown status");
  if (std::memchr(x.message, 0, sizeof x.message) == nullptr)
    fuzz::fail("a message without an end");
  const bool done = x.status == THERMOROLL_DONE;
  if (!done && x.message[0] == '\0') fuzz::fail("an error without a word");
  if (done != (all_finite(x.value) && all_finite(x.error))) fuzz::fail("not finite, or not NaN");
  examine_si(x, done && scene.load != 0);
}

// The profile of a scene is there if its answer is, and the answer is the same.
void examine_profile(const thermoroll_scene& scene, const thermoroll_result& told) {
  thermoroll_result result{};
  thermoroll_point points[5]{};
  result.size = sizeof result;
  points[0].size = sizeof points[0];
  const int status = thermoroll_profile(&scene, &result, points, 5);
  if (status != told.status) fuzz::fail("another status of the profile");
  for (const thermoroll_point& point : points)
    if (are_finite(&point.s, 9) != (status == THERMOROLL_DONE)) fuzz::fail("a point");
}

// Temperatures at places are all there or not at all; below the surface they may be unresolved.
void examine_places(thermoroll_scene scene, const thermoroll_result& told) {
  thermoroll_result result{};
  thermoroll_point points[4]{};
  result.size = sizeof result;
  points[0].size = sizeof points[0];
  scene.places = THERMOROLL_AS_GIVEN;
  for (int k = 0; k < 4; ++k) points[k].s = 0.7 * k;
  points[1].depth = points[2].depth = 0.01;
  const bool done = thermoroll_profile(&scene, &result, points, 4) == THERMOROLL_DONE;
  if (done && told.status != THERMOROLL_DONE) fuzz::fail("places of nothing");
  for (const thermoroll_point& point : points)
    if (std::isfinite(point.temperature) != done) fuzz::fail("a place");
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
  for (std::size_t k = 0; k < results.size(); ++k) {
    examine(scenes[k], results[k]);
    all = all && results[k].status == THERMOROLL_DONE;
  }
  if (scenes[0].places == THERMOROLL_ALONG_CONTACT) {
    examine_profile(scenes[0], results[0]);
    examine_places(scenes[0], results[0]);
  }
  if (status != (all ? THERMOROLL_DONE : THERMOROLL_ROWS_FAILED)) fuzz::fail("another sum of all");
  return 0;
}
