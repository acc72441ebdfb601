// Tangled from paper/12-coupled-problem.md, paper/13-border-and-error.md, paper/14-temperatures-and-profiles.md, paper/A-one-answer.md; edit there.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "thermoroll/admissibility.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"
#include "thermoroll/slip_variable.hpp"

namespace thermoroll {

/// The least model that meets the tolerance; Carter's closed form without thermal deformation, its
/// first order in H, the coupled solver; the published Gauss-Chebyshev scheme.
enum class Method { automatic, closed_form, first_order, coupled, gauss_chebyshev };

/// How a scene is to be solved.
struct Approach {
  Formulation formulation = Formulation::corrected;  ///< makes no difference to the closed form
  double tolerance = 1e-6;                           ///< of all but the scheme, 1e-11 to 1e-2
  Method method = Method::automatic;                 ///< for solve(); others are one method
  int nodes = 200;                                   ///< of the scheme, 3 to 5000
};

/// The results of a solved scene; dimensionless.
enum class Quantity {
  stick_slip_border,   ///< c0
  slip_length,         ///< 1 - c0, to its own digits
  traction,            ///< Q*
  creep_constant,      ///< C of @eq:stick-conditions, xi* + f gamma0
  creep,               ///< xi* = C - f gamma0
  load_ratio,          ///< kappa = P_H / P, @eq:kappa
  gamma0,              ///< gamma0 of @eq:pressure-conditions
  heat_integral,       ///< the integral of v* p*
  max_temperature,     ///< the largest T* in the contact
  max_temperature_at,  ///< s there
  eccentricity         ///< pi gamma0 / (2 kappa), of the contact's centre from the axis
};

/// The results of a scene, or their errors, by Quantity. In operator[] they are in its order.
class Results : public Eigen::Array<double, 11, 1> {
 public:
  using Array::Array;
  double operator()(Quantity q) const { return coeff(static_cast<Eigen::Index>(q)); }
  double& operator()(Quantity q) { return coeffRef(static_cast<Eigen::Index>(q)); }
};

/// The number of them, from the first on, that have a tolerance.
inline constexpr int compared = static_cast<int>(Quantity::max_temperature_at);

/// A quantity that is reported, its key in JSON and CSV, and its symbol.
struct Reported {
  Quantity quantity;
  const char *key, *symbol;
};

inline constexpr Reported reported[] = {{Quantity::traction, "traction", "Q*"},
                                        {Quantity::stick_slip_border, "stick_slip_border", "c0"},
                                        {Quantity::creep_constant, "creep_constant", "C"},
                                        {Quantity::creep, "creep", "xi*"},
                                        {Quantity::load_ratio, "load_ratio", "kappa"},
                                        {Quantity::gamma0, "gamma0", "gamma0"},
                                        {Quantity::eccentricity, "eccentricity", ""},
                                        {Quantity::heat_integral, "heat_integral", "int v*p*"},
                                        {Quantity::max_temperature, "max_temperature", "T*max"},
                                        {Quantity::max_temperature_at, "max_temperature_at", "s"}};

/// The two parts of a traction-creep curve with a maximum: before and beyond it.
enum class Branch { rising, falling };

/// The quantity prescribed beside f, Pe and H: traction, creep or border, and its value; if
/// friction depends on temperature, a traction has a branch. A border is between -1 and 1. The
/// signs of traction and creep are told at solve() and solve_coupled().
struct Prescribed {
  Quantity quantity;
  double value;
  Branch branch = Branch::rising;
};

/// The results of a grid of n unknowns; change and estimate are relative, and absent for the grid
/// on which the border was found. If Newton's method failed, all three are absent.
struct GridStep {
  int unknowns;
  double border;     ///< c0
  int newton_steps;  ///< 0 if Newton's method failed
  /// tail: the last quarter of the coefficients of h, relative to the largest.
  std::optional<double> tail, change, estimate;
};

/// The tolerance is not met on the finest grid, or the estimate does not decrease.
struct NotResolved : std::runtime_error {
  NotResolved(const std::string& message, std::vector<GridStep> steps)
      : std::runtime_error(message), trace(std::move(steps)) {}
  std::vector<GridStep> trace;
};

/// The maximum of a traction-creep curve, where it is, and estimated errors of both, which may be
/// above the tolerance (@sec:traction-limit).
struct TractionLimit {
  double traction, creep, traction_error, creep_error;
  bool has_creep() const { return creep_error < std::abs(creep); }  ///< else unknown
};

/// The traction next to it that is surely below it, in size, and is told from it.
double below(const TractionLimit& limit);

/// A prescribed traction is beyond the largest one, which has the signs of the scene.
struct BeyondLimit : std::invalid_argument {
  BeyondLimit(const std::string& message, const TractionLimit& largest)
      : std::invalid_argument(message), limit(largest) {}
  TractionLimit limit;
};

/// The heat that crosses into the half-space besides its uniform share K1 / (K1 + K2), and the
/// amplitude C of that flux, C / sqrt(1 + s), at the leading edge.
struct CrossingHeat {
  double heat, edge, heat_error = 0, edge_error = 0;  ///< estimated, absolute
};

/// A solution of the coupled problem; dimensionless.
struct CoupledSolution {
  Scene scene;                        ///< its H acts on the tractions
  Formulation formulation;            ///< the sign of the thermal slope
  Results value;                      ///< by Quantity
  Results error;                      ///< estimated absolute errors
  int unknowns = 0;                   ///< n, values of h on the last grid
  int newton_steps = 0;               ///< on the last grid; Picard's where heat is weak
  Eigen::VectorXd h;                  ///< n Legendre coefficients in y of h, @eq:h
  std::vector<Violation> violations;  ///< why it is inadmissible; else empty
  std::vector<GridStep> trace;        ///< its grids, the last at the end; empty for simpler models
  SlipVariable variable{};            ///< y of @eq:angles
  /// If friction depends on temperature and the traction is given: the largest traction, if there
  /// is one, and the branch.
  std::optional<TractionLimit> limit{};
  std::optional<Branch> branch{};
  std::optional<CrossingHeat> crossing{};  ///< if it is solved for
};

/// Traction and creep without slip, with their signs: only those of a bulk difference.
/// Their errors are estimated, and at most the tolerance times the creep if the flux of 170
/// unknowns, or of up to 260 at high speed, resolves them.
struct NoSlip {
  double traction = 0, creep = 0, traction_error = 0, creep_error = 0;
};
NoSlip no_slip(const Scene& scene, double tolerance = 1e-10);

/// Add the eccentricity and its error, which follow from gamma0 and kappa and their errors.
void add_eccentricity(Results& value, Results& error);

/// The scales of the tolerance: creep, heat and temperature themselves, one for the others.
Results scale_of(const Results& v);

/// The same in this scene: a bulk difference adds what it alone makes of creep and temperature.
Results scale_in(const Scene& scene, const Results& value);

/// The quantities without heat, except for the temperature.
Results carter_values(const Carter& c);

/// Their derivatives with respect to one of traction, creep and border, to about half a thousandth.
Results carter_slope(const Carter& c, Quantity by);

/// The largest change of the other quantities by rounding of the given one, each relative to its
/// scale; slope holds their derivatives with respect to it.
double rounding(const Prescribed& given, const Results& slope, const Results& scale);

/// Refuse, by std::invalid_argument, data out of range and a prescribed quantity that is not
/// traction, creep or border, or not in its range; the scene is checked first, if there is one.
void check(Quantity given);
void check(double friction, const Prescribed& given);
void check(const Scene& scene, const Prescribed& given);

/// Carter's closed form for the given quantity; std::invalid_argument if check() refuses it, or the
/// whole contact slips at the given creep.
Carter carter_given(double friction, const Prescribed& given,
                    Direction direction = Direction::driving);

/// Solve the coupled problem for the given quantity, by the formulation and tolerance of the
/// approach, whatever its method, until the estimated error of every quantity is below
/// tolerance >= 1e-11: absolute for border, slip_length, traction, load_ratio, gamma0,
/// relative to scale_in() for creep_constant, creep, heat_integral and max_temperature; that of
/// max_temperature_at is the length of the slip zone times the root of it, or the length of the
/// stick zone if the hottest point is there. A creep at which the whole contact slips has the
/// border -1. Traction and creep are positive in the scene's direction, also if it
/// brakes. Throws std::invalid_argument for data out of range, std::runtime_error if no solution is
/// found, NotResolved if the tolerance is not met.
CoupledSolution solve_coupled(const Scene& scene, const Approach& approach,
                              const Prescribed& given);

/// The discrete problem h = sigma p-hat v-hat, p-hat = 2/pi + p h, v-hat = 2f/pi + v h, for the
/// values h at the slip nodes s; sigma = 1 + s. Dimensionless; p, v, kappa are proportional to H.
struct FluxMap {
  double friction;
  Eigen::VectorXd s, sigma;
  Eigen::MatrixXd p, v;
  Eigen::RowVectorXd kappa;  ///< the load ratio is 1 + kappa h
};

/// The problem that solve_coupled solves on a grid of n unknowns, 2 to 480, at the border c0 if
/// y = psi. Throws std::invalid_argument for data out of range.
FluxMap flux_map(const Scene& scene, Formulation formulation, int n, double c0);

/// The heat flux v* p* of a solution.
HeatFlux coupled_flux(const CoupledSolution& x);

/// Estimated absolute errors of a profile, of each curve the largest at the same distances from the
/// edges and from the border, which has an error of its own; dimensionless.
struct ProfileErrors {
  double pressure, traction, slip, heat_flux, temperature;
};

/// Functions of the position along the contact, at ascending s in [-1, 1]; dimensionless.
struct Profile {
  Eigen::ArrayXd s, pressure, traction, slip, heat_flux, temperature;
  /// The fluxes into the half-space and into the cylinder, which add up to heat_flux; in profile()
  /// of a Solution, empty if the cylinder is an insulator.
  Eigen::ArrayXd heat_flux_1{}, heat_flux_2{};
  /// The local coefficient f phi(T*); in profile() of a Solution, empty if friction is constant.
  Eigen::ArrayXd friction{};
  std::optional<ProfileErrors> error{};  ///< in profile() of a Solution
};

/// The profiles of a solution, at the nodes of its last grid.
Profile profile(const CoupledSolution& x);

/// The factors of the tractions and of the heat, as Legendre coefficients: h and p-hat in y on the
/// slip zone; p-hat and the bracket of @eq:corrective-inverse on the stick zone, in the x of its
/// nodes; and phi p-hat, which bounds the traction, on both zones, empty for constant friction.
/// Dimensionless.
struct SmoothTractions {
  double slip, stick;  ///< lengths of both zones
  Eigen::VectorXd h, pressure, stick_pressure, bracket;
  Eigen::VectorXd bound{}, stick_bound{};
  double layer = 2;         ///< length beside the border that the nodes of the stick zone resolve
  SlipVariable variable{};  ///< y of @eq:angles
};

/// The profiles of a solution on a grid of n unknowns at its border; on a grid other than its own,
/// h is solved for on that grid.
SmoothTractions smooth_tractions(const CoupledSolution& x, int n);

}  // namespace thermoroll
