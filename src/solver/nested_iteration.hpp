// Tangled from paper/07-printed-scheme.md; edit there.
#pragma once

#include <algorithm>
#include <cmath>

#include "thermoroll/carter.hpp"
#include "thermoroll/published_scheme.hpp"

/// The iterations of the published scheme, for any Problem that has a scene and a traction, and for
/// which solve_normal(problem, x), solve_stick(problem, x) and slip_velocity(problem, x) stand
/// beside it.
namespace thermoroll {

/// No slip, and Carter's border. Throws std::invalid_argument.
inline PrintedSolution before_iterating(const Scene& scene, double traction,
                                        const PrintedOptions& options) {
  check(scene);
  require(options.nodes >= 3, "nodes", options.nodes, "at least 3");
  PrintedSolution x;
  x.grid = gauss_chebyshev(options.nodes);
  x.c0 = carter(scene.friction, traction).c0;
  x.slip = Eigen::VectorXd::Zero(options.nodes);
  return x;
}

/// Move c0 until @eq:discrete-traction holds; true if it does. Counts its steps in x.
template <class Problem>
bool find_border(Problem& problem, PrintedSolution& x, const PrintedOptions& options) {
  const double wanted = problem.scene.friction - problem.traction;
  for (int step = 1; step <= options.max_inner; ++step) {
    x.inner_iterations = std::max(x.inner_iterations, step);
    solve_normal(problem, x);
    solve_stick(problem, x);
    const double b = (1 + x.c0) / 2, found = -b * x.grid.w.dot(x.phi0);
    x.steps.push_back({x.c0, problem.scene.friction - found});
    if (std::abs(found - wanted) <= options.tolerance * problem.traction) return true;
    if (!(found > 0)) return false;
    x.c0 = 2 * std::min(b * std::sqrt(wanted / found), 1.0) - 1;
  }
  return false;
}

template <class Problem>
void iterate(Problem& problem, PrintedSolution& x, const PrintedOptions& options) {
  int failures = 0;
  while (!x.converged && failures < options.max_failures &&
         x.outer_iterations < options.max_outer) {
    ++x.outer_iterations;
    const bool found = find_border(problem, x, options);
    if (!found) ++failures;
    const Eigen::VectorXd v = slip_velocity(problem, x);
    const double change = (v - x.slip).lpNorm<Eigen::Infinity>();
    x.slip = v;
    x.converged = found && change <= options.tolerance * v.lpNorm<Eigen::Infinity>();
  }
  x.creep = x.creep_constant - problem.scene.friction * x.gamma0;
}

}  // namespace thermoroll
