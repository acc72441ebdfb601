// Tangled from paper/A-command-line.md; edit there.
#pragma once

#include <optional>
#include <stdexcept>
#include <vector>

#include "kernels.hpp"
#include "scene.hpp"

namespace thermoroll {

/// Carter's closed form without thermal deformation, or the published Gauss-Chebyshev scheme.
enum class Method { closed_form, gauss_chebyshev };

/// How a scene is to be solved.
struct Approach {
  Method method = Method::gauss_chebyshev;
  Formulation formulation = Formulation::printed;  ///< makes no difference to the closed form
  int nodes = 200;                                 ///< 3 to 5000; not used by the closed form
};

/// What is reported of a solved scene; dimensionless.
struct Results {
  double stick_slip_border;   ///< c0
  double creep_constant;      ///< the constant of @eq:stick as solved, xi* + f gamma0
  double creep;               ///< xi*, @eq:true-creep
  double load_ratio;          ///< kappa = P_H / P, @eq:kappa
  double gamma0;              ///< the constant of @eq:discrete-normal
  double heat_integral;       ///< the integral of v* p*
  double max_temperature;     ///< the largest T* on the surface
  double max_temperature_at;  ///< s there
};

/// Largest values over the contact; dimensionless.
struct Peaks {
  double pressure;   ///< of p*
  double traction;   ///< of q*
  double heat_flux;  ///< of v* p*
};

/// A scene, how it was solved, and what came out.
struct Solution {
  Scene scene;
  Approach approach;
  Results value;
  std::optional<Results> error;  ///< estimated absolute errors; the scheme has none
  Peaks peak;                    ///< of the scheme: over its nodes
  int outer_iterations = 0;
  int inner_iterations = 0;  ///< the largest count of any outer step
  bool converged = true;
};

/// Solve the scene. Throws std::invalid_argument for a scene or a node count out of range and
/// std::runtime_error for an integral that is not resolved; an iteration that does not converge
/// is told by `converged`.
Solution solve(const Scene& scene, const Approach& approach);

/// What is reported of a case in SI units, beside the dimensionless results.
struct PhysicalResults {
  double half_width;               ///< a, m
  double radius;                   ///< R of @eq:kappa, m
  double creep_ratio;              ///< xi, the creep as a fraction of the speed
  double hertz_pressure;           ///< 2 P / (pi a), Pa
  double max_pressure;             ///< of p, Pa
  double max_traction;             ///< of q, Pa
  double max_heat_flux;            ///< of phi, W/m^2
  double max_temperature_celsius;  ///< largest temperature rise, degree C
};

/// Results and peaks of a case in SI units; x solves scene_of(c, ...).
PhysicalResults in_si_units(const Solution& x, const PhysicalCase& c);

/// An iteration did not converge.
struct NotConverged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The half-width in m that meets @eq:kappa for a cylinder of this radius (m), with kappa from
/// solve(); c.half_width is not used. Throws std::invalid_argument, NotConverged.
double half_width_of_radius(PhysicalCase c, double radius, double friction, double traction,
                            const Approach& approach);

/// T* at one point, with its estimated absolute error where the method has one.
struct CurvePoint {
  double s;
  double temperature;
  std::optional<double> error;
};

struct Curve {
  std::vector<CurvePoint> points;
  bool converged = true;
};

/// T* at the points s, at a depth in units of a (0 for the scheme). Throws as solve() does.
Curve temperature_curve(const Scene& scene, const Approach& approach, const std::vector<double>& at,
                        double depth);

}  // namespace thermoroll
