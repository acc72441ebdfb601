// Tangled from paper/20-full-slip.md; edit there.
#pragma once

#include "solver/contact_grid.hpp"
#include "solver/grid_solution.hpp"
#include "thermoroll/coupled.hpp"

namespace thermoroll {

/// The grid of n unknowns in full slip, @eq:full-slip, for any creep; and at a creep xi*.
ContactGrid full_slip_grid(const Scene& scene, Formulation formulation, int n,
                           const SlipVariable& by = {});
ContactGrid at_creep(ContactGrid grid, double creep);

/// Solve in full slip for a creep; arguments and errors as for solve_coupled. A solution that has a
/// load but is no contact has its violations. A creep beyond the loss of contact is refused by
/// std::invalid_argument, one for which nothing is found by std::runtime_error.
CoupledSolution solve_full_slip(const Scene& scene, const Approach& approach, double creep);

/// Drop a backward slip over less than this length at the leading edge, and other violations there
/// if they are meant as well.
void forget_the_edge(GridSolution& x, double length, bool also_others = false);

/// Whether, with a bulk difference, a backward slip at the leading edge is longer than 0.002.
bool should_stick_at_edge(const Scene& scene, const GridSolution& x);

/// Refuse, by std::invalid_argument, the traction of constant friction itself, f or -f by the
/// direction, with the least creep that it belongs to.
[[noreturn]] void refuse_undetermined_creep(const Scene& scene, Formulation formulation);

}  // namespace thermoroll
