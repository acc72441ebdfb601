// Tangled from paper/K-from-other-languages.md; edit there.
#ifndef THERMOROLL_H
#define THERMOROLL_H

// thermoroll for C. Link with -lthermoroll_c. No function throws or ends the program. GSL's error
// handler, which would abort, is turned off in a program that loads the library. Traps of
// floating-point exceptions (-ffpe-trap, feenableexcept) must be off during a call, as some
// quotients are infinite by design.

#include <stddef.h>
#include <stdint.h>

#define THERMOROLL_EXPORT __attribute__((visibility("default")))

#ifdef __cplusplus
extern "C" {
#endif

enum thermoroll_quantity {
  THERMOROLL_TRACTION,
  THERMOROLL_CREEP,
  THERMOROLL_STICK_SLIP_BORDER,
  THERMOROLL_CREEP_RATIO,  ///< as the next, of a scene in SI units
  THERMOROLL_TANGENTIAL_LOAD
};
enum thermoroll_roller { THERMOROLL_INSULATED, THERMOROLL_IDENTICAL, THERMOROLL_CONDUCTING };
enum thermoroll_direction { THERMOROLL_DRIVING, THERMOROLL_BRAKING };
enum thermoroll_friction_law {
  THERMOROLL_CONSTANT,
  THERMOROLL_LINEAR,
  THERMOROLL_EXPONENTIAL,
  THERMOROLL_RATIONAL,
  THERMOROLL_PIECEWISE_LINEAR
};
enum thermoroll_branch { THERMOROLL_RISING, THERMOROLL_FALLING };
enum thermoroll_formulation { THERMOROLL_PRINTED, THERMOROLL_CORRECTED };
enum thermoroll_places { THERMOROLL_ALONG_CONTACT, THERMOROLL_AS_GIVEN };

enum thermoroll_method {
  THERMOROLL_AUTO,
  THERMOROLL_CLOSED_FORM,
  THERMOROLL_FIRST_ORDER,
  THERMOROLL_COUPLED,
  THERMOROLL_GAUSS_CHEBYSHEV
};
enum thermoroll_model {
  THERMOROLL_NO_MODEL = -1,
  THERMOROLL_MODEL_CLOSED_FORM,
  THERMOROLL_MODEL_FIRST_ORDER,
  THERMOROLL_MODEL_COUPLED
};

enum thermoroll_status {
  THERMOROLL_DONE = 0,
  THERMOROLL_FAILED = 1,         ///< no solution or not to the tolerance; memory ran out
  THERMOROLL_REFUSED = 2,        ///< data out of range
  THERMOROLL_NOT_CONVERGED = 3,  ///< the published scheme does not converge
  THERMOROLL_ROWS_FAILED = 4,    ///< of a call: some of its rows have another status than 0
  THERMOROLL_NO_CONTACT = 5      ///< the solution is no contact
};

/// A scene and how to solve it; dimensionless, or in SI units if its load is not 0.
/// thermoroll_scene_init() sets all members, of which friction, given and either peclet or the data
/// in SI units must then be chosen.
struct thermoroll_scene {
  uint32_t size;      ///< sizeof(struct thermoroll_scene)
  int32_t quantity;   ///< the prescribed one, enum thermoroll_quantity; the traction
  double given;       ///< its value: Q*, xi*, xi or Q in N/m, negative for braking, or c0
  double friction;    ///< f > 0, at most 1e100
  double peclet;      ///< Pe = V a / 2k, 1e-280 to 1e306
  double heating;     ///< H = 2 alpha (1+nu) k P / (a K) >= 0; 0
  int32_t roller;     ///< enum thermoroll_roller; insulated: all heat into the half-space
  int32_t direction;  ///< enum thermoroll_direction; driving. Of a border; others have a sign
  double conductivity_ratio;    ///< K2 / K1 > 0 of a conducting roller; else 0
  double heating_2;             ///< H2 >= 0 of a conducting roller; else 0
  double peclet_2;              ///< Pe2 > 0 of a conducting roller; 0 for that of the half-space
  double bulk_difference;       ///< Theta, by how much a roller that conducts is warmer; 0
  int32_t friction_law;         ///< enum thermoroll_friction_law; constant
  int32_t branch;               ///< enum thermoroll_branch, of a traction with a law; rising
  double friction_temperature;  ///< T0* of a law, in SI units T0 in K; not 0; else 0
  double friction_floor;        ///< of a law, from 0 to 1 (piecewise linear: its end value); 0
  /// Of a law, up to where friction is f, over the bulk temperature: T*, in SI units in K; 0.
  double friction_reference_temperature;
  int32_t method;                 ///< enum thermoroll_method; auto
  int32_t formulation;            ///< enum thermoroll_formulation; corrected
  double tolerance;               ///< 1e-11 to 1e-2; 1e-6
  int32_t nodes;                  ///< of the published scheme, 3 to 5000; 200
  int32_t places;                 ///< enum thermoroll_places, of a profile; else along contact
  double load, speed;             ///< P, N/m; V, m/s; 0 for a dimensionless scene, as the next
  double half_width, radius;      ///< one of them: a of the contact, or R of the cylinder; m
  double shear_modulus, poisson;  ///< of both bodies: mu > 0, Pa; nu from 0 to below 1/2
  double expansion, diffusivity, conductivity;        ///< alpha >= 0, 1/K; k, m^2/s; K, W/(m K)
  double expansion_2, conductivity_2, diffusivity_2;  ///< of a conducting roller; k2 may be 0 for k
  double bulk_temperature;                            ///< far away, degree C; NaN if it is unknown
  double bulk_temperature_2;                          ///< of the roller, if it is another; else NaN
};

/// The results of a scene, or their estimated absolute errors; dimensionless.
struct thermoroll_values {
  double stick_slip_border, slip_length;       ///< c0, -1 in full slip; 1 - c0 to its own digits
  double traction;                             ///< Q*, negative when braking
  double creep_constant, creep;                ///< C; xi*, negative when braking
  double load_ratio, gamma0;                   ///< kappa; gamma0
  double heat_integral;                        ///< the integral of v* p*
  double max_temperature, max_temperature_at;  ///< the largest T* in the contact; s there
  double eccentricity;                         ///< of the contact's centre from the axis
  double heat_1, heat_2;  ///< the heat that flows into the half-space; into the roller
  double traction_limit, creep_at_traction_limit;  ///< of a prescribed traction with a law, or NaN
};

/// Results of a scene in SI units, or their estimated absolute errors. Temperatures but the last
/// are rises over the bulk temperature. The largest traction in N/m is load times traction_limit.
struct thermoroll_physical {
  double half_width, radius;            ///< a; R; m
  double creep_ratio;                   ///< xi, the creep as a fraction of the speed
  double hertz_pressure, max_pressure;  ///< 2 P / (pi a); largest p; Pa
  double max_traction;                  ///< largest q by size, with its sign, Pa
  double max_heat_flux;                 ///< W/m^2
  double max_temperature_celsius;       ///< the largest rise of the surface, degree C
  double half_width_over_radius;        ///< a / R
  double dissipation;                   ///< power lost to friction per unit length, W/m
  double tangential_load;               ///< Q, N/m, negative when braking
  double max_temperature_at_m;          ///< x of the hottest point, m
  double heat_1, heat_2;                ///< the heat into the half-space; into the roller; W/m
  double contact_temperature_celsius;   ///< bulk temperature and largest rise, or NaN; degree C
};

/// The SI values of one dimensionless unit each.
struct thermoroll_units {
  double length;       ///< a, of s, m
  double traction;     ///< P / a, of p* and q*, Pa
  double slip;         ///< of v*, m/s
  double heat_flux;    ///< of v* p*, W/m^2
  double temperature;  ///< of T*, degree C
};

/// The answer to a scene. The values of a scene that failed are NaN; so are the errors of the
/// published scheme, which has none, and what is in SI units of a dimensionless scene.
struct thermoroll_result {
  uint32_t size;     ///< sizeof(struct thermoroll_result), set by the caller in the first
  int32_t status;    ///< enum thermoroll_status
  int32_t model;     ///< enum thermoroll_model
  int32_t unknowns;  ///< of the coupled solver's last grid; else 0
  struct thermoroll_values value, error;
  char message[256];  ///< why it failed, or why this model was enough; cut if too long
  struct thermoroll_units unit;
  struct thermoroll_physical physical, physical_error;
  char notes[256];  ///< data beyond the model, as a modulus in GPa, that fit; empty if unsolved
};

/// A point along the contact, which the surfaces enter at s = -1 and leave at s = 1; or where the
/// caller sets s and the depth, of which the temperature and its error are told and the rest is
/// NaN.
struct thermoroll_point {
  uint32_t size;                    ///< sizeof(struct thermoroll_point), set in the first
  int32_t status;                   ///< that of the scene
  double s;                         ///< x / a, from -1 to 1; any as given
  double pressure, traction;        ///< p*; q*, negative when braking
  double slip, heat_flux;           ///< v*, negative when braking; v* p*
  double temperature;               ///< T*, over the bulk temperature
  double heat_flux_1, heat_flux_2;  ///< into the half-space; into the roller
  double depth;                     ///< y / a in the half-space: 0 along the contact; any >= 0
  double temperature_error;         ///< estimated, absolute; along the contact the largest
  double friction;                  ///< the coefficient at T*: f, or that of a law
  /// Likewise, at the same distances from the edges and the border, which has its own error.
  double pressure_error, traction_error, slip_error, heat_flux_error;
};

/// The law of all creeps of a scene.
struct thermoroll_law;

/// How good a law is and where it ends. Creeps are xi*, or in SI units fractions of the speed.
struct thermoroll_law_info {
  uint32_t size;   ///< sizeof(struct thermoroll_law_info), set by the caller
  int32_t status;  ///< enum thermoroll_status
  /// Sizes of the creeps where it ends, infinite without an end. With a bulk difference both may
  /// be on one side of 0; then one of them is negative.
  double driving_end, braking_end;
  char message[256];  ///< why there is no law, or why it ends; or empty
};

/// A law at a creep; dimensionless, or of a scene in SI units with what follows "or". Beyond its
/// end the numbers are NaN and the status is 2.
struct thermoroll_law_value {
  uint32_t size;           ///< sizeof(struct thermoroll_law_value), set by the caller in the first
  int32_t status;          ///< 0 or 2
  double traction;         ///< Q*, or Q in N/m; with one bulk temperature it has the creep's sign
  double slope;            ///< dQ*/dxi*, or dQ/dxi in N/m, without an error
  double max_temperature;  ///< the largest T*, or rise in degree C
  double stick_slip_border;                                               ///< c0, -1 in full slip
  double traction_error, max_temperature_error, stick_slip_border_error;  ///< estimated, absolute
};

/// The version of the library, as "0.2.0".
THERMOROLL_EXPORT const char* thermoroll_version(void);

/// The meaning of a status, in a few words; never null.
THERMOROLL_EXPORT const char* thermoroll_message(int status);

/// Set the first `size` bytes of a scene, which is sizeof *scene, to what stands in its comments.
THERMOROLL_EXPORT void thermoroll_scene_init(struct thermoroll_scene* scene, size_t size);

/// Solve `count` scenes on so many threads, 0 for one on each processor; the answers are the same
/// for any number. Returns 0 if all are solved, 4 if some are not, each of which tells why. Returns
/// 2, and writes nothing, if an array is null, the first scene or result has another size, or
/// threads < 0. Several threads may call it at once.
THERMOROLL_EXPORT int thermoroll_solve(const struct thermoroll_scene* scenes,
                                       struct thermoroll_result* results, size_t count,
                                       int threads);

/// Solve a scene and evaluate its curves at `count` points from s = -1 to 1, 2 to 100000, which are
/// dense at the edges and at the border; with a bulk difference they leave the edges out. Where the
/// scene has THERMOROLL_AS_GIVEN, the caller has set s and depth of 1 to 100000 points, and the
/// temperatures there are told; the published scheme has them at depth 0 only, without errors.
/// Returns the status of the scene, which its result has too; what is told of a scene that failed
/// is NaN. Returns 2, and writes nothing, if an array is null or has another size, or count is 0.
/// The published scheme has no curves along the contact, which the result tells with its status 2.
THERMOROLL_EXPORT int thermoroll_profile(const struct thermoroll_scene* scene,
                                         struct thermoroll_result* result,
                                         struct thermoroll_point* points, size_t count);

/// The law of a scene for both directions, to the tolerance of the scene, from 1e-7 to 1e-2; its
/// prescribed quantity, direction (which agrees with it), branch and method must be valid and make
/// no difference. Full slip is computed up to creeps of the size reach > 0, which may be infinite.
/// A scene in SI units needs the half-width. Null if there is none, and info tells why.
THERMOROLL_EXPORT struct thermoroll_law* thermoroll_law_new(const struct thermoroll_scene* scene,
                                                            double reach,
                                                            struct thermoroll_law_info* info);

/// Evaluate a law at `count` creeps xi*, or of a scene in SI units xi. Returns 0, 4 if some are
/// beyond its end, or 2 as thermoroll_solve() does. Several threads may evaluate a law at once.
THERMOROLL_EXPORT int thermoroll_law_evaluate(const struct thermoroll_law* law,
                                              const double* creeps,
                                              struct thermoroll_law_value* values, size_t count);

/// Free a law, or do nothing for null.
THERMOROLL_EXPORT void thermoroll_law_free(struct thermoroll_law* law);

#ifdef __cplusplus
}
#endif

#endif
