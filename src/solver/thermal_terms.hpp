// Tangled from paper/12-coupled-problem.md; edit there.
#pragma once

#include <Eigen/Core>

#include "solver/nodes.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// The contribution of a bulk difference to F, G, p-hat less 2 kappa / pi, and T* at the slip
/// nodes, then the stick nodes, and to kappa and gamma0; empty without one.
struct BulkTerms {
  Eigen::VectorXd f, g, pressure, temperature;
  double kappa = 0, gamma0 = 0;
};

/// F, dF/ds and G of @eq:thermal-sides at the slip nodes, then (but for dF/ds) the stick nodes, as
/// matrices on the Legendre coefficients of h; and the part that does not depend on h. With a law
/// of friction also T* at the slip nodes, then the stick nodes.
struct ThermalTerms {
  Eigen::MatrixXd f, df, g;
  BulkTerms bulk{};
  Eigen::MatrixXd temperature{};
};

/// These matrices on the nodes of a grid, for an h of so many terms, by graded rules of a multiple
/// of four nodes.
ThermalTerms thermal_terms(const Scene& scene, Formulation formulation, const Nodes& z,
                           Eigen::Index terms, const GaussLegendre& rule);

}  // namespace thermoroll
