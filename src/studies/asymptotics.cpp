// Tangled from paper/16-where-methods-fail.md; edit there.
#include "studies/asymptotics.hpp"

#include <algorithm>
#include <cmath>

#include "thermoroll/carter.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/quadrature.hpp"

namespace thermoroll {
namespace {

constexpr double euler_gamma = 0.57721566490153286;

}  // namespace

double hottest_when_fast(const HeatFlux& flux) {
  const double length = flux.to - flux.from;
  const auto cold = [&](double left) {  // minus the integral up to s = from + left
    const auto upstream = [&](double u) {
      return flux.density(left - u, length - left + u) / std::sqrt(u);
    };
    return left > 0 ? -integrate(upstream, {0, left}).value : 0;
  };
  return -cold(minimum(cold, 0, 0.8 * length, length)) / std::sqrt(2 * pi);
}

double hottest_when_slow(const HeatFlux& flux, double peclet) {
  const double length = flux.to - flux.from;
  const auto cold = [&](double left) {
    const auto both_sides = [&](double t) {
      const double kernel = std::log(2 / (peclet * std::abs(t - left))) - euler_gamma;
      return flux.density(t, length - t) * kernel;
    };
    return -integrate(both_sides, {0, left, length}).value;
  };
  return -cold(minimum(cold, 0.01 * length, 0.6 * length, 0.99 * length)) / pi;
}

double creep_of_little_traction(const Scene& scene, double traction) {
  const auto strain = [&](double u) {  // u = 1 - r
    return std::sqrt(u / (2 - u)) * kernel::N2(scene.peclet * u);
  };
  const double layer = std::min(1.0, 1 / scene.peclet);
  const double sum = integrate(strain, {0, layer, 2}).value;
  const double change = scene.peclet * scene.heating * traction / (pi * pi) * sum;
  return carter(scene.friction, traction).creep * (1 + change);
}

}  // namespace thermoroll
