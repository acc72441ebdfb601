// Tangled from paper/06-published-scheme.md; edit there.
#pragma once

#include <algorithm>
#include <cmath>

#include "thermoroll/carter.hpp"
#include "thermoroll/published_scheme.hpp"

/// The iterations of the published scheme, for any Problem that has a scene and a traction, and
/// that has the functions solve_normal(problem, x), solve_stick(problem, x) and
/// slip_velocity(problem, x).
namespace thermoroll {

inline void check_paper_pair(const Scene& scene) {
  check(scene);
  const Roller& roller = scene.roller;
  if (roller.conductivity_ratio > 0 || roller.heating > 0 || scene.direction == Direction::braking)
    throw std::invalid_argument(
        "gauss-chebyshev is for an insulated cylinder that drives, as in the paper");
  if (scene.law) throw std::invalid_argument("gauss-chebyshev is for constant friction");
}

inline void check(const PublishedOptions& options) {
  require(options.nodes >= 3, "nodes", options.nodes, "at least 3");
  require(options.tolerance > 0, "tolerance", options.tolerance, "positive");
  require(true, "heaviside_at_zero", options.heaviside_at_zero, "finite");
  require(options.max_outer >= 1, "max_outer", options.max_outer, "at least 1");
  require(options.max_inner >= 1, "max_inner", options.max_inner, "at least 1");
  require(options.max_failures >= 1, "max_failures", options.max_failures, "at least 1");
}

/// Move c0 until @eq:discrete-traction holds; true if it does. Counts its steps in the solution.
template <class Problem>
bool find_border(Problem& problem, PublishedSolution& solution, const PublishedOptions& options) {
  const double wanted = problem.scene.friction - problem.traction;
  for (int step = 1; step <= options.max_inner; ++step) {
    solution.inner_iterations = std::max(solution.inner_iterations, step);
    solve_normal(problem, solution);
    solve_stick(problem, solution);
    const double b = (1 + solution.c0) / 2, found = -b * solution.grid.w.dot(solution.phi0);
    solution.steps.push_back({solution.c0, problem.scene.friction - found});
    if (std::abs(found - wanted) <= options.tolerance * problem.traction) return true;
    if (!(found > 0)) return false;
    solution.c0 = 2 * std::min(b * std::sqrt(wanted / found), 1.0) - 1;
  }
  return false;
}

template <class Problem>
void iterate(Problem& problem, PublishedSolution& solution, const PublishedOptions& options) {
  int failures = 0;
  while (!solution.converged && failures < options.max_failures &&
         solution.outer_iterations < options.max_outer) {
    ++solution.outer_iterations;
    const bool found = find_border(problem, solution, options);
    if (!found) ++failures;
    const Eigen::VectorXd v = slip_velocity(problem, solution);
    const double change = (v - solution.slip).lpNorm<Eigen::Infinity>();
    solution.slip = v;
    solution.converged = found && change <= options.tolerance * v.lpNorm<Eigen::Infinity>();
  }
  solution.creep = solution.creep_constant - problem.scene.friction * solution.gamma0;
}

/// No slip, and Carter's border. Throws std::invalid_argument.
inline PublishedSolution before_iterating(const Scene& scene, double traction,
                                          const PublishedOptions& options) {
  check_paper_pair(scene);
  check(options);
  PublishedSolution solution;
  solution.grid = gauss_chebyshev(options.nodes);
  solution.c0 = carter(scene.friction, traction).c0;
  solution.slip = Eigen::VectorXd::Zero(options.nodes);
  return solution;
}

}  // namespace thermoroll
