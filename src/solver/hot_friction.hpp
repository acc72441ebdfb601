// Tangled from paper/21-hot-friction.md; edit there.
#pragma once

#include <Eigen/Core>

#include "solver/nodes.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// Matrices for a law of friction on the n slip nodes.
struct HotFriction {
  Eigen::MatrixXd s;  // S of @eq:lost-friction on the values of B, n x n, but for B' at the node
  Eigen::MatrixXd at_node;  // the weight of B' at the node itself, on the values of B, n x n
  Eigen::ArrayXd weight;    // of the integral in S
  Eigen::ArrayXd moment;    // of that for the traction, @eq:lost-sums
  Eigen::ArrayXd bulk{};    // the part of T* by a bulk difference at all nodes, empty without one
};

/// These matrices on the nodes of a grid and the rule of its slip zone.
HotFriction hot_friction(const Nodes& z, const GaussLegendre& rule);

/// The graded rule of the thermal terms of a grid with a law.
const GaussLegendre& rule_for_temperatures(const Scene& scene, const ZoneLengths& zones,
                                           const GridRules& rules);

}  // namespace thermoroll
