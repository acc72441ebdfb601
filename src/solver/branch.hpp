// Tangled from paper/21-hot-friction.md; edit there.
#pragma once

#include "thermoroll/coupled.hpp"

namespace thermoroll {

/// Solve for a traction > 0 where friction depends on temperature, on a branch of the
/// traction-creep curve, with its maximum. Errors as for solve_coupled; refuses a traction that the
/// branch does not have by std::invalid_argument.
CoupledSolution solve_on_branch(const Scene& scene, const Approach& approach, double asked,
                                Branch branch);

}  // namespace thermoroll
