// Tangled from paper/02-problem.md, paper/04-integral-equations.md; edit there.
#include "thermoroll/scene.hpp"

#include <cmath>
#include <stdexcept>

#include "support/number_text.hpp"

namespace thermoroll {

PhysicalCase wheel_on_rail() { return {1.2e7, 22.2, 5.5e-3, 8.1e10, 0.3, 1.1e-5, 1.4e-5, 50}; }

Scene scene_of(const PhysicalCase& c, double friction) {
  const double peclet = c.speed * c.half_width / (2 * c.diffusivity);
  const double heating =
      2 * c.expansion * (1 + c.poisson) * c.diffusivity * c.load / (c.half_width * c.conductivity);
  return {friction, peclet, heating};
}

double hertz_half_width(double load, double radius, double shear_modulus, double poisson) {
  return std::sqrt(4 * (1 - poisson) * radius * load / (pi * shear_modulus));
}

Units units_of(const PhysicalCase& c, double friction) {
  const double traction = c.load / c.half_width;
  const double slip = 2 * (1 - c.poisson) * traction / c.shear_modulus * c.speed;
  const double heat_flux = friction * slip * traction;
  return {traction, slip, heat_flux, heat_flux * c.half_width / c.conductivity};
}

void require(bool allowed, const std::string& name, double value, const std::string& range) {
  if (allowed && std::isfinite(value)) return;
  const bool say = !std::isfinite(value) && range != "finite";
  throw std::invalid_argument(name + " = " + shortest(value) + " is not allowed: it must be " +
                              (say ? "finite and " : "") + range);
}

void check(const Scene& scene) {
  require(scene.friction > 0, "friction", scene.friction, "positive");
  require(scene.peclet > 0, "peclet", scene.peclet, "positive");
  require(scene.heating >= 0, "heating", scene.heating, "zero or positive");
}

void check_but_half_width(const PhysicalCase& c) {
  require(c.load > 0, "load", c.load, "positive");
  require(c.speed > 0, "speed", c.speed, "positive");
  require(c.shear_modulus > 0, "shear-modulus", c.shear_modulus, "positive");
  require(c.poisson >= 0 && c.poisson < 0.5, "poisson", c.poisson, "at least 0 and below 0.5");
  require(c.expansion >= 0, "expansion", c.expansion, "zero or positive");
  require(c.diffusivity > 0, "diffusivity", c.diffusivity, "positive");
  require(c.conductivity > 0, "conductivity", c.conductivity, "positive");
}

void check(const PhysicalCase& c) {
  check_but_half_width(c);
  require(c.half_width > 0, "half-width", c.half_width, "positive");
}

}  // namespace thermoroll
