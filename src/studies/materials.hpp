// Tangled from paper/18-what-heat-can-do.md; edit there.
#pragma once

#include <vector>

namespace thermoroll {

/// An engineering solid at room temperature, isotropic.
struct Material {
  const char* name;
  double youngs_modulus;  ///< E, Pa
  double poisson;         ///< nu
  double expansion;       ///< alpha, linear, 1/degree C
  double density;         ///< rho, kg/m^3
  double heat_capacity;   ///< c, of a unit of mass, J/(kg degree C)
};

/// Ten of them, from handbooks.
const std::vector<Material>& materials();

/// The shear modulus mu, Pa.
double shear_modulus(const Material& m);

/// Grüneisen's number, @eq:grueneisen; dimensionless. Poisson's ratio is below 1/2.
double grueneisen(const Material& m);

/// The ratio H of a contact of this a/R, @eq:what-heating-is with kappa = 1; dimensionless.
double heating_of_size(const Material& m, double half_width_over_radius);

}  // namespace thermoroll
