// Tangled from paper/16-where-methods-fail.md; edit there.
#pragma once

#include "thermoroll/carter.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// The limits of @eq:fast-and-slow for the largest T*: times sqrt(Pe) as Pe grows, and as Pe falls.
double hottest_when_fast(const HeatFlux& flux);
double hottest_when_slow(const HeatFlux& flux, double peclet);

/// xi* by @eq:little-traction, for a traction much below the friction.
double creep_of_little_traction(const Scene& scene, double traction);

}  // namespace thermoroll
