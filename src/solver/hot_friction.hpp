// Tangled from paper/21-hot-friction.md; edit there.
#pragma once

#include <Eigen/Core>

#include "solver/nodes.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// Matrices for a law of friction on the n slip nodes and m stick nodes.
struct HotFriction {
  Eigen::MatrixXd temperature;  // T* at the n, then the m nodes; a column for each term of h
  Eigen::MatrixXd s;            // S of @eq:lost-friction on the values of B, n x n, but for
  Eigen::MatrixXd at_node;      // what the derivative of B at the node itself adds, n x n
  Eigen::ArrayXd weight;        // of the integral in S
  Eigen::ArrayXd moment;        // of that for the traction, @eq:lost-sums
  Eigen::ArrayXd bulk{};        // what a bulk difference adds to T*, empty without one
};

/// These matrices on the nodes of a grid, for an h of so many terms.
HotFriction hot_friction(const Scene& scene, const Nodes& z, const GridRules& rules,
                         Eigen::Index terms);

}  // namespace thermoroll
