// Tangled from paper/17-least-model.md; edit there.
#pragma once

#include <string>

#include "thermoroll/carter.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/scene.hpp"
#include "thermoroll/solution.hpp"

namespace thermoroll {

/// How much heat is expected to change results, relatively, @eq:a-priori.
double expected_change(const Scene& scene, const Carter& c);

/// The error that one linear correction is expected to leave, relatively, where heat changes
/// results by so much, @eq:first-order-forecast.
double expected_second_order(double change);

/// The lower levels, as solutions of the coupled problem. Errors include what the model leaves out,
/// and are infinite where heat is too strong for one linear correction. The closed form's h has ten
/// terms, and no heat acts on its tractions. Arguments as for carter_given; first_order
/// refuses a creep in full slip.
CoupledSolution closed_form(const Scene& scene, const Approach& approach, const Prescribed& given);
CoupledSolution first_order(const Scene& scene, const Approach& approach, const Prescribed& given);

/// The largest difference of any quantity but the position of the hottest point, in units of what
/// its tolerance is relative to; dimensionless.
double largest_difference(const Results& x, const Results& exact);

/// The largest stated error of any quantity but that position, in the same units; dimensionless.
double largest_error(const CoupledSolution& x);

/// A solution, its model, and the reason for that model.
struct Choice {
  Model model;
  std::string reason;
  CoupledSolution solution;
};

/// Solve by the least model whose estimated error meets the tolerance. Arguments, errors and
/// refusals as for solve_coupled.
Choice least_model(const Scene& scene, const Approach& approach, const Prescribed& given);

/// Refuse, by std::invalid_argument, a method that leaves out a part of the scene.
void check_method(const Scene& scene, Method method);

/// Solve by the model that the approach's method names, or by the least one; not by the published
/// scheme. Arguments, errors and refusals as for that model.
Choice solve_by_method(const Scene& scene, const Approach& approach, const Prescribed& given);

}  // namespace thermoroll
