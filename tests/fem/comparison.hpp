// Surfaces by finite elements, compared with expected values and with the kernels; units of
// half_space.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "half_space.hpp"
#include "response.hpp"

namespace comparison {

using response::Patch;

// phi = peak (1 - r^2)^2, where r runs from -1 to 1 on the patch.
inline Patch smooth_flux(double from, double to, double peak) {
  return {from, to, [=](double x) {
            const double r = (2 * x - from - to) / (to - from);
            return peak * (1 - r * r) * (1 - r * r);
          }};
}

// The largest difference between found(p) and expected(p.x), and between found and -expected, both
// over the largest expected value.
struct Mismatch {
  double same_sign, opposite_sign;
};
inline Mismatch mismatch(const std::vector<fem::Surface>& points, double fem::Surface::*found,
                         const fem::Function& expected) {
  double same = 0, opposite = 0, largest = 0;
  for (const fem::Surface& p : points) {
    const double value = expected(p.x);
    same = std::max(same, std::abs(p.*found - value));
    opposite = std::max(opposite, std::abs(p.*found + value));
    largest = std::max(largest, std::abs(value));
  }
  return {same / largest, opposite / largest};
}

// The three mismatches of a heated surface with the kernels.
struct Comparison {
  Mismatch temperature, slope, strain;
};
inline Comparison against_kernels(const std::vector<fem::Surface>& points, double peclet,
                                  const Patch& flux) {
  using namespace std::placeholders;
  return {mismatch(points, &fem::Surface::temperature,
                   std::bind(response::temperature, peclet, flux, _1)),
          mismatch(points, &fem::Surface::outward_slope,
                   std::bind(response::outward_slope, peclet, flux, _1)),
          mismatch(points, &fem::Surface::strain, std::bind(response::strain, peclet, flux, _1))};
}

}  // namespace comparison
