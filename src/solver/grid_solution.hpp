// Tangled from paper/13-border-and-error.md; edit there.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "solver/contact_grid.hpp"
#include "solver/exchange.hpp"
#include "solver/surface.hpp"
#include "thermoroll/coupled.hpp"

namespace thermoroll {

struct GridSolution {
  ZoneLengths at{};  // without a stick zone in full slip
  Results value = Results::Zero();
  Eigen::VectorXd h{};                     // Legendre coefficients; none before the first grid
  HottestPoint peak{};                     // the hottest point of the surface
  int newton_steps = 0;                    // or Picard's; 0 if Newton's method failed
  std::vector<Violation> violations{};     // if it is not admissible
  std::optional<CrossingHeat> crossing{};  // heat between both bodies, if solved for
  std::vector<Kink> kinks{};               // of a law of friction
};

/// Solve with n unknowns at a border, starting from a coarser grid's solution, or Carter's.
GridSolution solve_on_grid(const Scene& scene, Formulation formulation, int n,
                           const ZoneLengths& at, const GridSolution& from);

/// The grids of a scene in full slip, by their unknowns; each holds for every creep.
struct SlippingGrids {
  Scene scene;
  Formulation formulation;
  std::map<int, ContactGrid> by_unknowns{};
};

/// Solve with n unknowns in full slip for a creep, starting from a coarser grid's solution there.
GridSolution solve_slipping_grid(SlippingGrids& grids, int n, double creep,
                                 const GridSolution& from, const SlipVariable& by = {});

/// The variable with nodes at the kinks of a solution, for a grid of n unknowns; and that of a grid
/// that starts from a solution. Whether a solution has its largest kink where its nodes are not.
SlipVariable about_kinks(const GridSolution& from, int n);
SlipVariable variable_after(const GridSolution& from, int n);
bool misses_kink(const GridSolution& x);

/// The residual of a solution for the given quantity; a border is measured from the nearer end.
double residual(const GridSolution& x, const Prescribed& given);

/// The border moved towards s = 1; the shorter zone keeps its digits.
ZoneLengths moved_by(const ZoneLengths& zones, double step);

/// The solution of n unknowns with a nearly vanishing stick zone; no newton_steps if none is found.
GridSolution next_to_full_slip(const Scene& scene, Formulation formulation, int n);

/// Its creep, infinite if none is found.
double creep_next_to_full_slip(const Scene& scene, Formulation formulation, int n);

/// A creep with a stick zone and a contact, the largest but one of a few borders; 0 if none has.
double creep_of_some_stick(const Scene& scene, Formulation formulation);

/// Solve with n unknowns for the given quantity, from the border of a coarser grid or Carter's;
/// slope, the derivative of all quantities with respect to it, is improved; only that of the
/// temperature is if heat changes the others by less than `weak`. No newton_steps if no solution is
/// found.
GridSolution find_border(const Scene& scene, Formulation formulation, int n,
                         const Prescribed& given, GridSolution level, Results& slope,
                         double weak = 0);

/// The error estimated from the tail of h on a grid of n unknowns: so many times it over n^2, or in
/// a layer so many times its square. Slow if convergence is slow.
double unresolved(double tail, int n, bool slow, double of_integrals, double in_layer);

/// With a law of friction, the part of a change since the previous grid that is counted as an
/// error, by the coefficients of h on both grids; whether they decay slowly; ten times the error of
/// the kinks; and the unknowns of the next grid.
double part_with_law(const Eigen::VectorXd& before, const Eigen::VectorXd& now);
bool decays_slowly(const Eigen::VectorXd& before, const Eigen::VectorXd& now);
double error_of_kinks(const GridSolution& x);
int unknowns_after(int n, bool bulk);

/// E of any two bodies that conduct, on this many nodes or more, for the h of friction.
std::vector<ExchangedFlux> exchanged_fluxes(const Scene& scene, Formulation formulation,
                                            const SmoothFlux& by, int nodes);

/// E by its zones, and the error of the temperature by it.
struct CrossingFlux {
  std::vector<HeatFlux> zones;
  double error = 0;
};
CrossingFlux flux_for_depths(const Scene& scene, Formulation formulation, const SmoothFlux& by);

/// The flux that crosses between both bodies in a solution, if it is solved for.
std::vector<ExchangedFlux> crossing_flux(const CoupledSolution& x);

/// That flux at every s in -1 < s < 1, in units of v* p*, of any two bodies that conduct.
Eigen::ArrayXd exchanged_heat_flux(const CoupledSolution& x, const Eigen::ArrayXd& s);

/// The solution on a grid of n unknowns, from that of a coarser one.
using NextGrid = std::function<GridSolution(int n, const GridSolution& last)>;

/// The end of a refusal's message for the least error that was reached; nothing from 1 on.
std::string at_best(double error);

/// Refine a coarse solution, grid by grid, until the estimated error is below the tolerance; slope
/// is the derivative of all quantities with respect to the given one. Throws NotResolved.
CoupledSolution refine(const Scene& scene, const Approach& approach, const Prescribed& given,
                       GridSolution level, Results& slope, const NextGrid& next);

}  // namespace thermoroll
