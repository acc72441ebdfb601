// Tangled from paper/11-what-the-grid-sees.md; edit there.
#include "studies/resolution.hpp"

#include <cmath>

#include <gsl/gsl_sf_bessel.h>

#include "model/kernel_table.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/published_scheme.hpp"

namespace thermoroll {

double sampled_weight(double x) {
  constexpr int near = 100;
  double sum = 0;
  for (int j = 0; j < near; ++j) sum += fast_slope_and_strain((j + 0.5) * x).n1;
  const double rest = near * x;
  const double slope = gsl_sf_bessel_I1_scaled(rest) / rest - 2 * kernel::N1(rest);
  return x * sum + gsl_sf_bessel_I0_scaled(rest) + x * x / 24 * slope;
}

double missed_load_change(const Carter& c, double peclet, int nodes) {
  const int steps = 100;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double theta = (i + 0.5) * pi / steps, s = std::cos(theta);
    const double heat = carter_slip(c, s) * hertz_pressure(s);
    const double spacing = pi / (nodes + 1) * std::sin(theta);
    if (heat > 0) sum += (1 - sampled_weight(peclet * spacing)) * s * heat;
  }
  return sum * pi / steps;
}

double scheme_load_change(const Carter& c, double peclet, int nodes) {
  const Grid g = gauss_chebyshev(nodes);
  double sum = 0;
  for (Eigen::Index k = 0; k < nodes && g.t(k) > c.c0; ++k) {
    const double heat = g.w(k) * carter_slip(c, g.t(k)) * (2 / pi);
    for (Eigen::Index m = k + 1; m <= nodes; ++m)
      sum += g.s(m) * heat * fast_slope_and_strain(peclet * (g.t(k) - g.s(m))).n1;
  }
  return peclet * sum * pi / (nodes + 1);
}

double exact_load_change(const Carter& c, double peclet) {
  const FluxMap map = flux_map({c.friction, peclet, 1}, Formulation::corrected, 64, c.c0);
  return map.kappa.dot(4 * c.friction / (pi * pi) * map.sigma) / c.friction;
}

}  // namespace thermoroll
