// Tangled from paper/02-problem.md, paper/04-integral-equations.md, paper/19-braking-and-alike-bodies.md, paper/23-unlike-bodies.md; edit there.
#pragma once

#include <optional>
#include <string>

#include "thermoroll/friction_law.hpp"

namespace thermoroll {

inline constexpr double pi = 3.14159265358979323846;

/// The cylinder as a conductor.
struct Roller {
  double conductivity_ratio = 0;  ///< K2 / K1 >= 0; 0 for an insulator
  double heating = 0;             ///< H2 = 2 alpha2 (1+nu) k2 P / (a K2) >= 0
  double peclet = 0;              ///< Pe2 = V a / 2 k2 > 0; 0 for that of the half-space
};

/// Whether the friction on the half-space acts along +x, as a driven cylinder's does, or against.
enum class Direction { driving, braking };

/// A rolling contact, in three of the dimensionless groups of @eq:groups; the fourth, the traction,
/// is prescribed or found.
struct Scene {
  double friction;  ///< f > 0, at most 1e100
  double peclet;    ///< Pe = V a / 2k, 1e-280 to 1e306
  double heating;   ///< H = 2 alpha (1+nu) k P / (a K) >= 0
  Roller roller{};  ///< the cylinder, an insulator unless it is said to conduct
  Direction direction = Direction::driving;  ///< counts for a border; see solve() for the others
  FrictionLaw law{};  ///< friction by temperature (@sec:hot-friction); constant if empty
  /// Theta, by how much a cylinder that conducts is warmer far away, in units of T*
  /// (@sec:exchange).
  double bulk_difference = 0;
};

/// The share of the heat that flows into the half-space, K1 / (K1 + K2), @eq:heat-share.
double heat_share(const Scene& scene);

/// The ratio H of the slopes of both bodies together, @eq:heating-of-both.
double heating_of_both(const Scene& scene);

/// D2 / Pe1 = H2 Pe2 / Pe1, the distortion of the cylinder in units of Pe of the half-space.
double distortion_2(const Scene& scene);

/// D1 - D2, where D = Pe H of each body.
double distortions_apart(const Scene& scene);

/// Whether two scenes have the same two bodies at the same speed and load.
bool same_bodies(const Scene& a, const Scene& b);

/// The thermal strain relative to that of the paper's driven pair with the same H,
/// @eq:strain-share; from -1 to 1, and 0 if H = 0.
double strain_share(const Scene& scene);

/// 1 for driving, -1 for braking.
constexpr double sign_of(Direction direction) { return direction == Direction::driving ? 1 : -1; }

/// Pe2, and Pe2 / Pe1 = k1 / k2; 1 where both bodies have one diffusivity.
double peclet_2(const Scene& scene);
double peclet_ratio(const Scene& scene);

/// Whether the cylinder conducts, with a diffusivity of its own.
bool is_unlike(const Scene& scene);

/// e2 / e1 of the effusivities e = K / sqrt(k), and the share of the total heat that flows into the
/// half-space, e1 / (e1 + e2), @eq:total-share.
double effusivity_ratio(const Scene& scene);
double effusivity_share(const Scene& scene);

/// A rolling contact in SI units (@tbl:steel). All fields are positive, except that the expansions,
/// poisson, conductivity_2 and diffusivity_2 may be zero; poisson is below 1/2, and bulk
/// temperatures are from -273.15 on.
struct PhysicalScene {
  double load;                ///< P, load per unit length, N/m
  double speed;               ///< V, rolling speed, m/s
  double half_width;          ///< a, half-width of the contact, m
  double shear_modulus;       ///< mu, of both bodies, Pa
  double poisson;             ///< nu, of both bodies
  double expansion;           ///< alpha, thermal expansion of the half-space, 1/degree C
  double diffusivity;         ///< k, thermal diffusivity of the half-space, m^2/s
  double conductivity;        ///< K, thermal conductivity of the half-space, W/(m degree C)
  double expansion_2 = 0;     ///< of the cylinder, 1/degree C
  double conductivity_2 = 0;  ///< of the cylinder, W/(m degree C); 0 for an insulator
  double diffusivity_2 = 0;   ///< of the cylinder, m^2/s; 0 for that of the half-space
  Direction direction = Direction::driving;
  std::optional<double> bulk_temperature{};    ///< of the half-space far away, degree C
  std::optional<double> bulk_temperature_2{};  ///< of the cylinder, or that of the half-space
  std::optional<LawOfFriction> law{};  ///< friction by the rise over bulk_temperature, degree C
};

/// The SI value of one dimensionless unit (@eq:scaled-variables, @eq:temperature-scale).
struct Units {
  double traction;                           ///< P/a, of p* and q*, Pa
  double slip;                               ///< 2(1-nu) P V / (mu a), of v*, m/s
  double heat_flux;                          ///< f V 2(1-nu) P^2 / (mu a^2), of v* p*, W/m^2
  double temperature;                        ///< heat_flux a / K, of T*, degree C
  double length = 0;                         ///< a, of s and depths, m
  std::optional<double> bulk_temperature{};  ///< to which rises add, degree C, if it is known
};

/// The diffusivity of the cylinder, m^2/s: its own, or that of the half-space.
double diffusivity_2(const PhysicalScene& si);

/// The dimensionless groups of a scene, @eq:groups.
Scene scene_of(const PhysicalScene& si, double friction);

/// The SI values of the dimensionless units in this case.
Units units_of(const PhysicalScene& si, double friction);

/// Hertz's half-width a in m, @eq:kappa, from N/m, m, Pa; all positive.
double hertz_half_width(double load, double radius, double shear_modulus, double poisson);

/// Grüneisen's number, @eq:grueneisen, of a heat capacity in J/(m^3 K), an expansion in 1/K, Pa;
/// dimensionless. Poisson's ratio is below 1/2.
double grueneisen(double capacity, double expansion, double shear_modulus, double poisson);

/// The wheel on its rail that the paper computes, @tbl:steel.
PhysicalScene wheel_on_rail();

/// Throw std::invalid_argument naming the value and the allowed range, unless the data are valid.
void check(const Scene& scene);
void check(const PhysicalScene& si);
void check_but_half_width(const PhysicalScene& si);

/// The same for friction by temperature: not negative at this T*.
void check_friction(const FrictionLaw& law, double temperature);

/// Throw std::invalid_argument "name = value is not allowed: it must be range", unless allowed
/// and value is finite.
void require(bool allowed, const std::string& name, double value, const std::string& range);

}  // namespace thermoroll
