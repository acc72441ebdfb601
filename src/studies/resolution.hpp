// Tangled from paper/11-what-the-grid-sees.md; edit there.
#pragma once

#include "thermoroll/carter.hpp"

namespace thermoroll {

/// S(x) of @eq:sampled-weight, x > 0: the share of N1's integral that samples at a spacing of x, in
/// units of the kernel's width, add up to.
double sampled_weight(double x);

/// The change of the load ratio, kappa - 1 as corrected and 1 - kappa as printed, to first order in
/// H, divided by f H: the whole effect, the part that the published scheme finds with so many
/// nodes, and the part that it misses by @eq:missed.
double exact_load_change(const Carter& c, double peclet);
double scheme_load_change(const Carter& c, double peclet, int nodes);
double missed_load_change(const Carter& c, double peclet, int nodes);

}  // namespace thermoroll
