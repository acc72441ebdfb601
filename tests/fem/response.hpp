// What the kernels of src/kernels.hpp say about a surface that is heated on a patch; dimensionless,
// in the units of half_space.hpp.
#pragma once

#include <functional>
#include <vector>

#include "thermoroll/kernels.hpp"
#include "thermoroll/quadrature.hpp"
#include "thermoroll/scene.hpp"

namespace response {

// A flux on (from, to), zero elsewhere.
struct Patch {
  double from, to;
  std::function<double(double)> density;
  double operator()(double x) const { return x > from && x < to ? density(x) : 0; }
};

// The kernel's integral over the patch, seen from x. A kernel that changes its sign could leave an
// integral near zero, which integrate() would refuse for its relative error; all three kernels
// exceed -1, so one is added to them and its integral subtracted.
template <class Kernel>
double convolved(const Kernel& kernel, double peclet, const Patch& flux, double x) {
  std::vector<double> points{flux.from};
  if (x > flux.from && x < flux.to) points.push_back(x);
  points.push_back(flux.to);
  const auto shifted = [&](double t) { return (1 + kernel(peclet * (t - x))) * flux(t); };
  return thermoroll::integrate(shifted, points).value - thermoroll::integrate(flux, points).value;
}

inline double temperature(double peclet, const Patch& flux, double x) {
  const auto M = [](double zeta) { return thermoroll::kernel::M(zeta); };
  return convolved(M, peclet, flux, x) / thermoroll::pi;
}
inline double outward_slope(double peclet, const Patch& flux, double x) {
  return convolved(thermoroll::kernel::N1, peclet, flux, x);
}
inline double strain(double peclet, const Patch& flux, double x) {
  return convolved(thermoroll::kernel::N2, peclet, flux, x) / thermoroll::pi;
}

}  // namespace response
