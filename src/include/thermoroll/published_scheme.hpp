// Tangled from paper/06-published-scheme.md; edit there.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "thermoroll/admissibility.hpp"
#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// Gauss-Chebyshev nodes and weights of the second kind, @eq:nodes; t and s descend from 1 to -1.
struct Grid {
  Eigen::VectorXd t, w;  ///< n nodes and their weights
  Eigen::VectorXd s;     ///< n + 1 collocation points
};

/// The quadrature of @eq:nodes with n >= 1 nodes.
Grid gauss_chebyshev(int n);

/// (1/pi) w_k / (t_k - s_m), row m, column k: applied to the factor of a traction it gives the
/// principal value (1/pi) PV int p*(t) / (t - s) dt at the collocation points.
Eigen::MatrixXd cauchy_matrix(const Grid& g);

struct PublishedOptions {
  int nodes = 200;               ///< n >= 3
  double tolerance = 1e-6;       ///< relative, of v* and of the traction
  double heaviside_at_zero = 0;  ///< the value of Heaviside's step at a coincident node
  int max_outer = 200;           ///< bound on the outer steps
  int max_inner = 50;            ///< bound on the inner steps of each
  int max_failures = 10;         ///< bound on the outer steps whose inner iteration failed
};

/// One step of the inner iteration: a border and the traction found there.
struct InnerStep {
  double c0, traction;
};

/// The result of the scheme; dimensionless. The scheme has no error estimate.
struct PublishedSolution {
  Grid grid;
  Eigen::VectorXd phi;        ///< factor of the pressure at t, @eq:factors
  Eigen::VectorXd phi0;       ///< factor of the corrective traction at tau = t
  Eigen::VectorXd slip;       ///< v* at t, zero in the stick zone
  double c0 = 0;              ///< stick-slip border
  double creep_constant = 0;  ///< C of @eq:discrete-stick
  double creep = 0;           ///< xi*, @eq:true-creep
  double load_ratio = 1;      ///< kappa = P_H / P
  double gamma0 = 0;          ///< the constant of @eq:discrete-normal
  int outer_iterations = 0;
  int inner_iterations = 0;      ///< the largest count of any outer step
  std::vector<InnerStep> steps;  ///< of all outer steps
  bool converged = false;        ///< whether both iterations converged
};

/// Run the scheme for a traction Q*, 0 < Q* < f. Throws std::invalid_argument for a scene, a
/// traction or options out of range, and for any but an insulated cylinder that drives with
/// constant friction.
PublishedSolution solve_published(const Scene& scene, double traction, Formulation formulation,
                                  const PublishedOptions& options = {});

/// w_k v*(t_k) at the nodes of the slip zone, t_k > c0, zero at the others.
Eigen::VectorXd hot_slip(const PublishedSolution& solution);

/// The heat g_k at each node, @eq:node-heat; their sum is the integral of v* p*.
Eigen::VectorXd node_heat(const PublishedSolution& solution);

/// T*(s) by the paper's rule, @eq:published-temperature; s must not be a node of the
/// slip zone.
double published_temperature(const PublishedSolution& solution, double peclet, double s);

/// The largest temperature at the collocation points, and where.
struct PublishedPeak {
  double at;           ///< s
  double temperature;  ///< T*
};
PublishedPeak published_max_temperature(const PublishedSolution& solution, double peclet);

/// p*(s) and q*(s); zero outside [-1, 1]. Dimensionless (per P/a).
double published_pressure(const PublishedSolution& solution, double s);
double published_traction(const PublishedSolution& solution, double friction, double s);

/// The factors of the tractions, for the conditions of @eq:admissible.
Factors factors(const PublishedSolution& solution, double friction);

}  // namespace thermoroll
