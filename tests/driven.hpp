// A scene and the traction that drives it, for the tests' lists of scenes.
#pragma once

#include "thermoroll/solution.hpp"

struct Driven {
  double friction, traction, peclet, heating;
  operator thermoroll::Scene() const { return {friction, peclet, heating}; }
  operator thermoroll::Prescribed() const { return {thermoroll::Quantity::traction, traction}; }
};

inline thermoroll::Solution solve(const Driven& x, const thermoroll::Approach& approach = {}) {
  return thermoroll::solve(x, x, approach);
}

inline thermoroll::PublishedSolution solve_published(
    const Driven& x, thermoroll::Formulation formulation,
    const thermoroll::PublishedOptions& options = {}) {
  return thermoroll::solve_published(x, x.traction, formulation, options);
}
