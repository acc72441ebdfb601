// Tangled from paper/12-coupled-problem.md, paper/21-hot-friction.md; edit there.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "solver/exchange.hpp"
#include "solver/hot_friction.hpp"
#include "solver/nodes.hpp"
#include "solver/thermal_terms.hpp"
#include "thermoroll/admissibility.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// At the n slip nodes p-hat = p0 + p h and v-hat = v0 + v h; kappa h and gamma0 h are added to
/// their values without h. The matrices have n rows and a column for each term of h.
struct TractionOperators {
  Eigen::ArrayXd p0, v0;  // Hertz's 2 / pi and Carter's 2 f / pi, and the part of a bulk difference
  Eigen::MatrixXd p, v;
  Eigen::RowVectorXd kappa, gamma0;
};

/// These matrices on the nodes of a grid.
TractionOperators traction_operators(const Nodes& z, const ThermalTerms& thermal, double friction);

/// The problem of a scene on a grid at a border: the parts that do not depend on the heat flux.
struct ContactGrid {
  Scene scene;
  GridRules rules;
  Nodes nodes;
  ThermalTerms thermal;
  TractionOperators tractions;
  std::optional<Exchange> crossing{};          // of the heat of friction, if it is solved for
  std::shared_ptr<const BulkExchange> bulk{};  // of a bulk difference, if there is one
  double creep = 0;                            // given in full slip only
  std::optional<HotFriction> hot{};            // if friction depends on temperature
};

double crowding(const Scene& scene, Formulation formulation, const ZoneLengths& at);

/// More nodes of the graded rules where y is not psi; found by trial.
int more_graded(const SlipVariable& by);

/// chi of @eq:strain-of-zone, and the chi from which the ends of the zone have layers that the
/// cubics do not resolve.
double strain_of_zone(const Scene& scene, const ZoneLengths& at);
inline constexpr double strain_of_layers = 120;

/// With these rules, for an h of so many terms; or with n unknowns, and as many terms.
ContactGrid contact_grid(const Scene& scene, Formulation formulation, const ZoneLengths& zones,
                         const GridRules& rules, Eigen::Index terms);
ContactGrid contact_grid(const Scene& scene, Formulation formulation, const ZoneLengths& zones,
                         int n);

/// The results of @eq:pressure-conditions and @eq:stick-conditions for h: kappa, gamma0, C, Q*.
struct Resultants {
  double kappa, gamma0, constant, traction;
};
Resultants resultants(const ContactGrid& grid, const Eigen::VectorXd& h);

/// Solve @eq:h at the given share of H from the start h; the number of steps, 0 if it fails.
int newton(const ContactGrid& grid, double share, Eigen::VectorXd& h);

/// The same at the full H, with a constant coefficient of friction, by @eq:h itself; 0 where heat
/// is not weak. Then h is a better start, or as it was.
int picard(const ContactGrid& grid, Eigen::VectorXd& h);

/// The Legendre coefficients of Carter's h, as many as the grid has slip nodes.
Eigen::VectorXd carter_h(const ContactGrid& grid);

/// Solve by Picard's iteration or Newton's method from h or, if that root is inadmissible, by
/// continuation in H from Carter's h; steps at the full H, 0 if all fail. If only the continuation
/// does, h is that root.
int solve_flux(const ContactGrid& grid, Eigen::VectorXd& h);

/// The factors of the tractions (@sec:admissibility) for an h: p-hat at all nodes; v-hat at the
/// slip nodes, and on the stick zone the bracket of @eq:corrective-inverse. From s = -1 on: the
/// stick nodes reversed, then the slip nodes.
Factors factors(const ContactGrid& grid, const Eigen::VectorXd& h);

/// A kink of the lost friction along the slip zone: its place in the psi of @eq:angles, the jump of
/// its slope by that, and the error that it causes; the last two as a part of all friction.
struct Kink {
  double place, jump, error;
};

/// Those of a law of friction for an h with its hottest point at this y.
std::vector<Kink> kinks_on(const ContactGrid& grid, const Eigen::VectorXd& h, double hottest);

}  // namespace thermoroll
