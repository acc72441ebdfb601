// Tangled from paper/16-where-methods-fail.md; edit there.
#pragma once

#include "thermoroll/coupled.hpp"

namespace thermoroll {

/// The same map at another value of H; the given one is that of H = 1.
FluxMap heated(FluxMap unit, double heating);

/// The heat flux without heating, Carter's, at the nodes of the map: where iterations start.
Eigen::VectorXd carter_start(const FluxMap& map);

/// p-hat and v-hat at the nodes.
Eigen::ArrayXd pressure_factor(const FluxMap& map, const Eigen::VectorXd& h);
Eigen::ArrayXd slip_factor(const FluxMap& map, const Eigen::VectorXd& h);

/// Solve the map's equation from h, to 1e-8 of it; the number of steps, 0 if it fails. Picard's
/// iteration of @eq:picard goes the given part of each step, 0 < relaxation <= 1; Anderson's keeps
/// depth >= 1 steps.
int picard(const FluxMap& map, Eigen::VectorXd& h, double relaxation = 1);
int anderson(const FluxMap& map, Eigen::VectorXd& h, Eigen::Index depth = 5);
int newton(const FluxMap& map, Eigen::VectorXd& h);

/// Continuation by Newton's method: h goes from the solution at one H > 0 to that at another. The
/// number of Newton steps of accepted tries, 0 if H cannot be raised by a thousandth.
int follow(const FluxMap& unit, double from, double to, Eigen::VectorXd& h);

/// The spectral radius of @eq:linearised: by how much a step of Picard's iteration with this
/// relaxation multiplies the error near the solution h.
double contraction(const FluxMap& map, const Eigen::VectorXd& h, double relaxation = 1);

}  // namespace thermoroll
