// Tangled from paper/11-what-the-grid-sees.md; edit there.
#pragma once

#include "thermoroll/carter.hpp"

namespace thermoroll {

/// S(x) of @eq:sampled-weight, x > 0: the share of N1's weight that samples at a spacing of x, in
/// units of the kernel's width, add up to.
double sampled_weight(double x);

/// The change of the load ratio, kappa - 1 as corrected and 1 - kappa as printed, to first order in
/// H, divided by f H: as it is, as the published scheme finds it with so many nodes, and what by
/// @eq:missed the scheme misses.
double exact_load_change(const Carter& c, double peclet);
double scheme_load_change(const Carter& c, double peclet, int nodes);
double missed_load_change(const Carter& c, double peclet, int nodes);

}  // namespace thermoroll
