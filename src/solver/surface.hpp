// Tangled from paper/10-coupled-solver.md; edit there.
#pragma once

#include <Eigen/Core>

#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {

/// The heat flux (1 - c0) sqrt(t (1 - t)) h of @eq:h: the lengths of both zones, and the Legendre
/// coefficients of h.
struct SmoothFlux {
  double slip, stick;
  Eigen::VectorXd h;
};

SmoothFlux smooth_flux(const Carter& c);
SmoothFlux smooth_flux(const CoupledSolution& x);

/// T* at given points, and an estimate of the absolute error of each.
struct SurfaceCurve {
  Eigen::ArrayXd temperature;
  double error;
};

/// T* on the surface at every s. The error estimate, to which that of the flux is to be added, is
/// below tolerance >= 1e-12 times the largest T*, or what rays of 480 nodes leave.
SurfaceCurve surface_curve(const SmoothFlux& x, double peclet, const Eigen::ArrayXd& s,
                           double tolerance);

/// The largest T* on the surface, and where it is; tolerance as above.
Peak hottest_point(const SmoothFlux& x, double peclet, double tolerance);

}  // namespace thermoroll
