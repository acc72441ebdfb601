// Tangled from paper/A-one-answer.md; edit there.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/published_scheme.hpp"
#include "thermoroll/quadrature.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// The models that are solved to a tolerance, from the least on.
enum class Model { closed_form, first_order, coupled };

/// A scene, the method, and the results.
struct Solution {
  Scene scene;
  Approach approach;
  Results value;
  std::optional<Results> error;  ///< estimated absolute errors; the scheme has none
  std::variant<Carter, PublishedSolution, CoupledSolution> found;
  bool converged = true;
  std::optional<Model> model{};         ///< the level of @sec:ladder; none for the scheme
  std::string reason{};                 ///< why that one; empty for the scheme
  std::vector<Violation> violations{};  ///< of @eq:admissible; empty for a contact
  std::vector<GridStep> trace{};        ///< the grids of the coupled solver; empty for the others
  NoSlip moved{};  ///< the errors of no_slip() by that of a half-width, which follows from a radius
};

/// Solve the scene for the prescribed quantity. A negative traction or creep brakes, whatever the
/// direction of the scene, or one below that without slip if the bulk temperatures differ; a border
/// has the scene's direction. The errors of the closed form are those of rounding: they leave out
/// the effect of heat on the tractions.
/// Throws std::invalid_argument for data out of range or a quantity that the method cannot start
/// from, and std::runtime_error where the coupled solver finds no solution or an integral is not
/// resolved; an iteration of the scheme that does not converge is told by `converged`.
Solution solve(const Scene& scene, const Prescribed& given, const Approach& approach = {});

/// Largest values over the contact; dimensionless.
struct Peaks {
  double pressure;   ///< of p*
  double traction;   ///< of q* by size, with its sign
  double heat_flux;  ///< of v* p*
};

/// The peaks and their estimated absolute errors, which the scheme does not have.
struct FoundPeaks {
  Peaks value;
  std::optional<Peaks> error;
};

/// The heat that flows into the half-space and into the cylinder, and that which crosses to the
/// half-space beyond its uniform share. Dimensionless, with estimated absolute errors; those of the
/// scheme are 0.
struct Heats {
  Estimate into_half_space, into_cylinder, exchanged;
};

Heats heats(const Solution& x);

/// Traction and creep without slip of the scene of a solution, with the errors of its half-width.
NoSlip no_slip(const Solution& x);

FoundPeaks peaks(const Solution& x);

/// The peaks of tractions that are known as series.
Peaks largest(const SmoothTractions& by, double friction);

/// All profiles along the contact, at the nodes of the solver or at so many points, 2 to 100000,
/// that suit a plot. Throws std::invalid_argument for the scheme.
Profile profile(const Solution& x);
Profile profile(const Solution& x, int points);

/// What is reported of a scene in SI units, beside the dimensionless results.
struct PhysicalResults {
  double half_width;               ///< a, m
  double radius;                   ///< R of @eq:kappa, m
  double creep_ratio;              ///< xi, the creep as a fraction of the speed
  double hertz_pressure;           ///< 2 P / (pi a), Pa
  double max_pressure;             ///< of p, Pa
  double max_traction;             ///< of q by size, with its sign, Pa
  double max_heat_flux;            ///< of phi, W/m^2
  double max_temperature_celsius;  ///< largest temperature rise, degree C
  double half_width_over_radius;   ///< a / R
  double dissipation;              ///< power lost to friction per unit length, W/m
  double tangential_load;          ///< Q, N/m; negative when braking
  double max_temperature_at_m;     ///< x of the hottest point of the surface, m
};

/// These results and their estimated absolute errors in the same units, which the scheme does not
/// have; and a note for each limit of @eq:limits that they exceed.
struct FoundInSi {
  PhysicalResults value;
  std::optional<PhysicalResults> error;
  std::vector<std::string> notes{};
  /// The largest temperature in the contact, degree C, if the bulk temperature is known. Its error
  /// is that of the rise.
  std::optional<double> contact_temperature_celsius{};
  /// The largest traction, N/m, and its creep as a fraction of the speed, if there is a maximum;
  /// of a contact of this half-width.
  std::optional<Estimate> tangential_load_limit{}, creep_ratio_at_limit{};
  Estimate heat_1{}, heat_2{};  ///< into the half-space; into the cylinder; W/m
  /// If the bulk temperatures differ: W/m, and the load in N/m and the creep as a fraction of the
  /// speed without slip.
  std::optional<Estimate> exchanged_heat{}, no_slip_load{}, no_slip_creep_ratio{};
  PhysicalScene data{};  ///< that these were computed from
};

/// Whether a prescribed creep is xi*, or the fraction xi of the speed.
enum class CreepUnit { scaled, ratio };

/// What is prescribed of a scene in SI units, dimensionless: a creep ratio as @eq:given-in-si says,
/// and anything else as it is.
Prescribed dimensionless(const PhysicalScene& si, const Prescribed& given, CreepUnit unit);

/// Results and peaks of a scene in SI units; x solves scene_of(si, ...).
/// The half-width of si is exact, or it is that of half_width_of_radius(); a creep ratio that is
/// given has no error.
FoundInSi in_si_units(const Solution& x, const PhysicalScene& si, bool from_radius = false,
                      CreepUnit given = CreepUnit::scaled);

/// A note for each limit of @eq:limits that these data exceed, with a creep ratio of this size and
/// a temperature rise in degree C.
std::vector<std::string> notes_on(const PhysicalScene& si, double friction, double creep_ratio,
                                  double rise);

/// A note that a law of @eq:laws leaves friction constant in this contact; empty if it does not.
std::string note_on_constant_friction(const Solution& x);

/// Notes as the end of a message: "; note: " before each.
std::string in_a_message(const std::vector<std::string>& notes);

/// Throw what is being handled again, with more behind its message, and of the same type if that is
/// NotResolved, NotConverged, std::runtime_error, BeyondLimit, or std::invalid_argument.
[[noreturn]] void throw_again_with(const std::string& more);

/// An iteration did not converge.
struct NotConverged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A solution violates @eq:admissible.
struct NoContact : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws NotConverged unless x has converged, then NoContact unless it is one.
void require_contact(const Solution& x);

/// The half-width in m that meets @eq:kappa for a cylinder of this radius (m), with kappa from
/// solve(); si.half_width is not used. Throws NotConverged, and as solve() does.
double half_width_of_radius(PhysicalScene si, double radius, double friction,
                            const Prescribed& given, const Approach& approach,
                            CreepUnit unit = CreepUnit::scaled);

/// The scene as given. In SI units, peclet and heating are not known yet, and half_width is not if
/// a radius is given. Its traction counts only if that is given.
struct GivenScene {
  Scene scene;
  Prescribed given;
  Approach approach;
  std::optional<PhysicalScene> physical;
  std::optional<double> radius;
  CreepUnit unit = CreepUnit::scaled;
  std::string as_given{};  ///< of a quantity that is given in SI units, "tangential-load = 6e+06"
};

/// A solution and, where the scene was given in SI units, these units and the results in them.
struct SolvedScene {
  Solution solution;
  std::optional<Units> units;
  std::optional<FoundInSi> physical;
};

/// Solve a scene as it is given; throws as solve() and half_width_of_radius() do.
SolvedScene solve_scene(const GivenScene& c);

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

/// T* at the points s, at a depth in body 1 in units of a (0 for the scheme). Throws
/// std::invalid_argument, and std::runtime_error where an integral is not resolved.
Curve temperature_curve(const Solution& x, const std::vector<double>& at, double depth);

/// The least f phi(T*) on the slip zone; nothing where friction is constant or nothing slips.
std::optional<Estimate> least_friction(const Solution& x);

}  // namespace thermoroll
