// Tangled from paper/14-temperatures-and-profiles.md; edit there.
#pragma once

#include <Eigen/Core>

#include "solver/conduction.hpp"
#include "solver/nodes.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {

/// The heat flux (1 - c0) sqrt(t (1 - t)) h of @eq:h: the lengths of both zones, the Legendre
/// coefficients of h, and their variable.
struct SmoothFlux {
  double slip, stick;
  Eigen::VectorXd h;
  SlipVariable variable{};
  ZoneLengths zones() const { return {slip, stick, variable}; }
};

/// T* and dT*/ds.
struct TemperatureAndSlope {
  double value, slope;
};

/// T* and dT*/ds at the distances 1 + y = left and 1 - y = right from the ends of the slip zone,
/// or, with left = 0, across a gap (in lengths of the slip zone); a rule of a multiple of eight
/// nodes.
TemperatureAndSlope temperature_and_slope(const ZoneLengths& zones, const Conduction& conduction,
                                          const Eigen::VectorXd& h, double left, double right,
                                          double gap, const GaussLegendre& rule);

/// T* on the surface at every s of a list, for a flux with Legendre coefficients h; a rule of a
/// multiple of eight nodes.
Eigen::ArrayXd surface_temperature(const ZoneLengths& at, const Conduction& conduction,
                                   const Eigen::VectorXd& h, const Eigen::ArrayXd& s,
                                   const GaussLegendre& rule);

/// The hottest point of the slip zone and T* there.
struct HottestPoint {
  double y = 0, value = 0, curvature = -3;  // curvature: the second derivative of ln T by y
};

/// A start for the search if there is no coarser grid, without a value.
HottestPoint expected_hottest(const ZoneLengths& zones, double peclet);

/// Find it from a nearby start, to about 5e-7 in y; a rule of a multiple of eight nodes. A Legendre
/// series in y may be added to T*.
HottestPoint find_hottest(const ZoneLengths& zones, const Conduction& conduction,
                          const Eigen::VectorXd& h, const HottestPoint& near,
                          const GaussLegendre& rule, const Eigen::VectorXd& more = {});

/// A place near another maximum than the one found, and its value; that is 0 if there is none.
HottestPoint hottest_elsewhere(const ZoneLengths& zones, const Conduction& conduction,
                               const Eigen::VectorXd& h, const HottestPoint& found,
                               const GaussLegendre& rule, const Eigen::VectorXd& more);

/// The largest value of a Legendre series that is positive somewhere, to 1.5e-5 in y.
HottestPoint largest_of_series(const Eigen::VectorXd& series);

SmoothFlux smooth_flux(const Carter& c);
SmoothFlux smooth_flux(const CoupledSolution& x);

/// The Legendre coefficients of h for temperatures; with a bulk difference they are filtered.
Eigen::VectorXd without_ripples(const Scene& scene, const Eigen::VectorXd& h);

/// T* at given points, and an estimate of the absolute error of each.
struct SurfaceCurve {
  Eigen::ArrayXd temperature;
  double error;
};

/// T* on the surface at every s. The error estimate, to which that of the flux is to be added, is
/// below tolerance >= 1e-12 times the largest T*, or the error of graded rules of 480 nodes.
SurfaceCurve surface_curve(const SmoothFlux& x, const Conduction& conduction,
                           const Eigen::ArrayXd& s, double tolerance);

/// The largest T* on the surface, and where it is; tolerance as above.
Peak hottest_point(const SmoothFlux& x, const Conduction& conduction, double tolerance);

}  // namespace thermoroll
