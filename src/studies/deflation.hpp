// Tangled from paper/18-what-heat-can-do.md; edit there.
#pragma once

#include <vector>

#include "solver/contact_grid.hpp"
#include "studies/sampling.hpp"

namespace thermoroll {

/// The solutions h of a grid that Newton's method finds from so many starts, each of which is led
/// away from those before; contacts or not.
std::vector<Eigen::VectorXd> distinct_solutions(const ContactGrid& grid, int starts, Random random);

}  // namespace thermoroll
