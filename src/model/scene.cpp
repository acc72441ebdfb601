// Tangled from paper/02-problem.md, paper/04-integral-equations.md, paper/18-what-heat-can-do.md, paper/19-braking-and-alike-bodies.md, paper/23-unlike-bodies.md; edit there.
#include "thermoroll/scene.hpp"

#include <cmath>
#include <stdexcept>

#include "support/number_text.hpp"

namespace thermoroll {

PhysicalScene wheel_on_rail() { return {1.2e7, 22.2, 5.5e-3, 8.1e10, 0.3, 1.1e-5, 1.4e-5, 50}; }

double diffusivity_2(const PhysicalScene& si) {
  return si.diffusivity_2 > 0 ? si.diffusivity_2 : si.diffusivity;
}

Scene scene_of(const PhysicalScene& si, double friction) {
  const double peclet = si.speed * si.half_width / (2 * si.diffusivity);
  const auto heating = [&](double expansion, double diffusivity, double conductivity) {
    return 2 * expansion * (1 + si.poisson) * diffusivity * si.load /
           (si.half_width * conductivity);
  };
  Scene scene{friction, peclet, heating(si.expansion, si.diffusivity, si.conductivity)};
  const double other = diffusivity_2(si);
  if (si.conductivity_2 > 0)
    scene.roller = {si.conductivity_2 / si.conductivity,
                    heating(si.expansion_2, other, si.conductivity_2),
                    other == si.diffusivity ? 0 : si.speed * si.half_width / (2 * other)};
  scene.direction = si.direction;
  const double unit = units_of(si, friction).temperature;
  if (si.bulk_temperature_2)
    scene.bulk_difference = (*si.bulk_temperature_2 - si.bulk_temperature.value_or(0)) / unit;
  if (si.law) {
    const auto& [scale, floor, reference] = si.law->of;
    scene.law = LawOfFriction{si.law->kind, {scale / unit, floor, reference / unit}};
  }
  return scene;
}

double hertz_half_width(double load, double radius, double shear_modulus, double poisson) {
  return std::sqrt(4 * (1 - poisson) * radius * load / (pi * shear_modulus));
}

Units units_of(const PhysicalScene& si, double friction) {
  const double traction = si.load / si.half_width;
  const double slip = 2 * (1 - si.poisson) * traction / si.shear_modulus * si.speed;
  const double heat_flux = friction * slip * traction;
  const double temperature = heat_flux * si.half_width / si.conductivity;
  return {traction, slip, heat_flux, temperature, si.half_width, si.bulk_temperature};
}

void require(bool allowed, const std::string& name, double value, const std::string& range) {
  if (allowed && std::isfinite(value)) return;
  const bool say = !std::isfinite(value) && range != "finite";
  throw std::invalid_argument(name + " = " + shortest(value) + " is not allowed: it must be " +
                              (say ? "finite and " : "") + range);
}

void check(const Scene& scene) {
  require(scene.friction > 0, "friction", scene.friction, "positive");
  require(scene.friction <= 1e100, "friction", scene.friction, "at most 1e100");
  require(scene.peclet > 0, "peclet", scene.peclet, "positive");
  require(scene.peclet >= 1e-280, "peclet", scene.peclet, "at least 1e-280");
  require(scene.peclet <= 1e306, "peclet", scene.peclet, "at most 1e306");
  require(scene.heating >= 0, "heating", scene.heating, "zero or positive");
  const Roller& roller = scene.roller;
  require(roller.conductivity_ratio >= 0, "conductivity-ratio", roller.conductivity_ratio,
          "zero or positive");
  require(roller.heating >= 0, "heating-2", roller.heating, "zero or positive");
  require(roller.peclet >= 0, "peclet-2", roller.peclet, "zero or positive");
  require(roller.peclet == 0 || roller.peclet >= 1e-280, "peclet-2", roller.peclet,
          "at least 1e-280");
  require(roller.peclet <= 1e306, "peclet-2", roller.peclet, "at most 1e306");
  require(scene.bulk_difference == 0 || roller.conductivity_ratio > 0, "bulk-difference",
          scene.bulk_difference,
          roller.conductivity_ratio > 0 ? "of any sign" : "0, as the roller is an insulator");
  if (const auto* law = scene.law.target<LawOfFriction>()) check(*law);
  if (scene.law) check_friction(scene.law, 0);
  if (scene.law && scene.bulk_difference == 0)
    require(scene.law(0).value > 0, "the share of friction at the bulk temperature", 0,
            "positive: a floor or a higher reference temperature leaves some");
}

void check_friction(const FrictionLaw& law, double temperature) {
  const double phi = law(temperature).value;
  require(phi >= 0, "the law of friction at T* = " + shortest(temperature), phi,
          "zero or positive");
}

void check_bulk_temperatures(const PhysicalScene& si) {
  if (si.bulk_temperature_2 && !si.bulk_temperature)
    throw std::invalid_argument("bulk-temperature-2 needs bulk-temperature");
  const double bulk = si.bulk_temperature.value_or(0);
  require(bulk >= -273.15, "bulk-temperature", bulk, "at least -273.15 degree C");
  const double bulk_2 = si.bulk_temperature_2.value_or(bulk);
  require(bulk_2 >= -273.15, "bulk-temperature-2", bulk_2, "at least -273.15 degree C");
  require(bulk_2 == bulk || si.conductivity_2 > 0, "bulk-temperature-2", bulk_2,
          shortest(bulk) + ", that of the half-space, unless the roller conducts");
}

void check_but_half_width(const PhysicalScene& si) {
  require(si.load > 0, "load", si.load, "positive");
  require(si.speed > 0, "speed", si.speed, "positive");
  require(si.shear_modulus > 0, "shear-modulus", si.shear_modulus, "positive");
  require(si.poisson >= 0 && si.poisson < 0.5, "poisson", si.poisson, "at least 0 and below 0.5");
  require(si.expansion >= 0, "expansion", si.expansion, "zero or positive");
  require(si.diffusivity > 0, "diffusivity", si.diffusivity, "positive");
  require(si.conductivity > 0, "conductivity", si.conductivity, "positive");
  require(si.expansion_2 >= 0, "expansion-2", si.expansion_2, "zero or positive");
  require(si.conductivity_2 >= 0, "conductivity-2", si.conductivity_2, "zero or positive");
  require(si.diffusivity_2 >= 0, "diffusivity-2", si.diffusivity_2, "zero or positive");
  check_bulk_temperatures(si);
  if (si.law) check(*si.law);
}

void check(const PhysicalScene& si) {
  check_but_half_width(si);
  require(si.half_width > 0, "half-width", si.half_width, "positive");
  const Units unit = units_of(si, 1);
  require(unit.traction > 0, "unit of traction P/a", unit.traction, "positive");
  require(unit.slip > 0, "unit of slip 2 (1-nu) P V / (mu a)", unit.slip, "positive");
  require(unit.heat_flux > 0, "unit of heat flux 2 (1-nu) P^2 V / (mu a^2)", unit.heat_flux,
          "positive");
  require(unit.temperature > 0, "unit of temperature 2 (1-nu) P^2 V / (mu a K)", unit.temperature,
          "positive");
}

double grueneisen(double capacity, double expansion, double shear_modulus, double poisson) {
  return 2 * expansion * shear_modulus * (1 + poisson) / ((1 - 2 * poisson) * capacity);
}

double heat_share(const Scene& scene) { return 1 / (1 + scene.roller.conductivity_ratio); }

double distortion_2(const Scene& scene) { return scene.roller.heating * peclet_ratio(scene); }

double distortions_apart(const Scene& scene) {
  return scene.peclet * (scene.heating - distortion_2(scene));
}

double heating_of_both(const Scene& scene) {
  const double other = scene.roller.conductivity_ratio * distortion_2(scene);
  return heat_share(scene) * (scene.heating + other);
}

bool same_bodies(const Scene& a, const Scene& b) {
  const auto& [ratio, heating, peclet] = a.roller;  // does not compile with a further member
  const Roller& other = b.roller;
  return a.peclet == b.peclet && a.heating == b.heating && ratio == other.conductivity_ratio &&
         heating == other.heating && peclet == other.peclet;
}

double strain_share(const Scene& scene) {
  const double own = scene.heating, other = scene.roller.conductivity_ratio * distortion_2(scene);
  return own + other > 0 ? sign_of(scene.direction) * (own - other) / (own + other) : 0;
}

double peclet_2(const Scene& scene) {
  return scene.roller.peclet > 0 ? scene.roller.peclet : scene.peclet;
}

double peclet_ratio(const Scene& scene) { return peclet_2(scene) / scene.peclet; }

bool is_unlike(const Scene& scene) {
  return scene.roller.conductivity_ratio > 0 && peclet_ratio(scene) != 1;
}

double effusivity_ratio(const Scene& scene) {
  return scene.roller.conductivity_ratio * std::sqrt(peclet_ratio(scene));
}

double effusivity_share(const Scene& scene) { return 1 / (1 + effusivity_ratio(scene)); }

}  // namespace thermoroll
