// Tangled from paper/07-temperature.md; edit there.
#pragma once

#include "thermoroll/carter.hpp"
#include "thermoroll/quadrature.hpp"

namespace thermoroll {

/// T*(s) at a depth (in units of a, 0 on the surface), @eq:temperature; dimensionless, per
/// @eq:temperature-scale. peclet > 0, s finite, depth >= 0, else std::invalid_argument; relative
/// error below 1e-9 for 1e-3 <= peclet <= 1e8, or std::runtime_error. If it is one term of a
/// sum, scale is the size of that sum: the error is then below 1e-9 of the larger of both.
Estimate temperature(const HeatFlux& flux, double peclet, double s, double depth = 0,
                     double scale = 0);

/// The hottest point of the surface.
struct Peak {
  double at;        ///< where, s
  double at_error;  ///< estimated error of the position
  Estimate temperature;
};

/// The largest T* on the surface, of a flux that is not zero everywhere. Errors as for temperature.
Peak hottest_point(const HeatFlux& flux, double peclet);

/// The integral of the flux, in units of v* p* times a length a.
Estimate total_heat(const HeatFlux& flux);

/// Heat flux of a contact with Hertz's pressure and uniform slip, @eq:sliding; its total is
/// heat >= 0.
HeatFlux sliding_flux(double heat);

}  // namespace thermoroll
