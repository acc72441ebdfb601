// Tangled from paper/16-where-methods-fail.md; edit there.
#pragma once

namespace thermoroll {

// The kernels of @sec:kernels by the formulas as they stand, to show where those fail. Not for use;
// zeta != 0.

namespace naive {
double N1(double zeta);
double N2(double zeta);
double M(double zeta);
}  // namespace naive

namespace naive_scaled {
double N1(double zeta);
double N2(double zeta);
double M(double zeta);
}  // namespace naive_scaled

/// How many of the sixteen digits of exact are wrong in value; all of them for infinity or NaN.
double digits_lost(double value, double exact);

}  // namespace thermoroll
