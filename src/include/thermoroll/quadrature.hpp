// Tangled from paper/07-temperature.md; edit there.
#pragma once

#include <functional>
#include <vector>

namespace thermoroll {

/// A computed value and an estimate of its absolute error.
struct Estimate {
  double value;
  double error;
};

/// Integrate f from points.front() to points.back(); f may be singular (integrably) or sharp only
/// at the points, which ascend strictly. Error below 1e-9 of the integral, or of the scale of a sum
/// in which it is a term; or std::runtime_error.
Estimate integrate(const std::function<double(double)>& f, const std::vector<double>& points,
                   double scale = 0);

/// The place of the minimum of f between low and high, with f(middle) below f at both;
/// std::runtime_error if it is not. To about the square root of rounding error (Brent's method).
double minimum(const std::function<double(double)>& f, double low, double middle, double high);

}  // namespace thermoroll
