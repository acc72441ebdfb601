// Tangled from paper/F-data-files.md; edit there.
#pragma once

#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/published_scheme.hpp"
#include "thermoroll/scene.hpp"

/// The scene that the paper computes. Dimensionless: q is Q*, 0 < q < 0.6; pe is the Péclet number.
namespace thermoroll::paper {

inline constexpr double friction = 0.6;
inline constexpr double heating = 0.0175;                     ///< of the wheel on the rail
inline constexpr double peclet = 4360;                        ///< of the wheel on the rail
inline constexpr double tractions[] = {0.2, 0.4, 0.5, 0.59};  ///< of its figures
inline constexpr double peclets[] = {100, 500, 1000, 5000};   ///< of its figures
inline constexpr Formulation formulation = Formulation::printed;

/// Its friction and H at another speed.
Scene scene(double pe);

/// Without heat.
Carter closed_form(double q);

/// By the published scheme; and the largest T* at its collocation points.
PublishedSolution scheme(double q, double pe, const PublishedOptions& options = {});
double scheme_max(double q, double pe, const PublishedOptions& options = {});

/// By the coupled solver, to 1e-8.
CoupledSolution coupled(double q, double pe, Formulation with = formulation);

/// The wheel on the rail, as one body that conducts or two, with constant or falling friction.
Scene wheel(bool two_bodies, bool falls);

/// The largest traction of a scene whose friction falls, by the coupled solver to 1e-6, and its
/// creep.
TractionLimit largest_traction(const Scene& scene);

}  // namespace thermoroll::paper
