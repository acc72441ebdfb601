// Tangled from paper/16-where-methods-fail.md; edit there.
#include "studies/iterations.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_multifit.h>

#include "solver/linear_system.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Infinity;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// A and B: the change of h through p-hat and through v-hat, linearised at h.
MatrixXd through_p(const FluxMap& map, const VectorXd& h) {
  return (map.sigma.array() * slip_factor(map, h)).matrix().asDiagonal() * map.p;
}

MatrixXd through_v(const FluxMap& map, const VectorXd& h) {
  return (map.sigma.array() * pressure_factor(map, h)).matrix().asDiagonal() * map.v;
}

VectorXd heat_again(const FluxMap& map, const VectorXd& h) {
  const VectorXd held = map.sigma.array() * slip_factor(map, h);
  MatrixXd system = -through_p(map, h);
  system.diagonal().array() += 1;
  return solve(system, 2 / pi * held);
}

/// The largest change of h relative to the largest h.
double relative(const VectorXd& change, const VectorXd& h) {
  return change.lpNorm<Infinity>() / h.lpNorm<Infinity>();
}

constexpr double settled = 1e-8;

/// Tells when an iteration makes no progress.
struct Patience {
  double best = std::numeric_limits<double>::infinity();
  int since = 0;
  bool ends(double change) {
    if (change < best / 2) {
      best = change;
      since = 0;
    }
    return !(change < 1e6) || ++since > 40;
  }
};

/// The x for which the sum of squares of a x - b is least.
VectorXd least_squares(const MatrixXd& a, VectorXd b) {
  const auto n = static_cast<std::size_t>(a.rows()), m = static_cast<std::size_t>(a.cols());
  MatrixXd rows = a.transpose(), covariance(a.cols(), a.cols());
  VectorXd x = VectorXd::Constant(a.cols(), std::numeric_limits<double>::quiet_NaN());
  const auto matrix = gsl_matrix_view_array(rows.data(), n, m);
  const auto right = gsl_vector_view_array(b.data(), n);
  auto found = gsl_vector_view_array(x.data(), m);
  auto spread = gsl_matrix_view_array(covariance.data(), m, m);
  double left = 0;
  gsl_multifit_linear_workspace* work = gsl_multifit_linear_alloc(n, m);
  gsl_multifit_linear(&matrix.matrix, &right.vector, &found.vector, &spread.matrix, &left, work);
  gsl_multifit_linear_free(work);
  return x;
}

/// Of a square matrix; throws std::runtime_error if they are not found.
Eigen::ArrayXcd eigenvalues(MatrixXd a) {
  const auto n = static_cast<std::size_t>(a.rows());
  std::vector<double> parts(2 * n);
  auto matrix = gsl_matrix_view_array(a.data(), n, n);
  auto found = gsl_vector_complex_view_array(parts.data(), n);
  gsl_eigen_nonsymm_workspace* work = gsl_eigen_nonsymm_alloc(n);
  const int failed = gsl_eigen_nonsymm(&matrix.matrix, &found.vector, work);
  gsl_eigen_nonsymm_free(work);
  if (failed) throw std::runtime_error("no eigenvalues found");
  Eigen::ArrayXcd all(a.rows());
  for (std::size_t i = 0; i < n; ++i)
    all(static_cast<Eigen::Index>(i)) = {parts[2 * i], parts[2 * i + 1]};
  return all;
}

}  // namespace

ArrayXd pressure_factor(const FluxMap& map, const VectorXd& h) {
  return (map.p * h).array() + 2 / pi;
}

ArrayXd slip_factor(const FluxMap& map, const VectorXd& h) {
  return (map.v * h).array() + 2 * map.friction / pi;
}

FluxMap heated(FluxMap unit, double heating) {
  unit.p *= heating;
  unit.v *= heating;
  unit.kappa *= heating;
  return unit;
}

VectorXd carter_start(const FluxMap& map) { return 4 * map.friction / (pi * pi) * map.sigma; }

int picard(const FluxMap& map, VectorXd& h, double relaxation) {
  Patience patience;
  for (int step = 1;; ++step) {
    const VectorXd change = heat_again(map, h) - h;
    h += relaxation * change;
    if (relative(change, h) < settled) return step;
    if (patience.ends(relative(change, h))) return 0;
  }
}

int anderson(const FluxMap& map, VectorXd& h, Eigen::Index depth) {
  Patience patience;
  MatrixXd moves(h.size(), depth), gains(h.size(), depth);
  VectorXd last_h = h, last;
  for (int step = 1;; ++step) {
    const VectorXd change = heat_again(map, h) - h;
    if (relative(change, h) < settled) return step;
    if (patience.ends(relative(change, h))) return 0;
    VectorXd next = h + change;
    if (step > 1) {
      const Eigen::Index used = std::min<Eigen::Index>(step - 1, depth);
      moves.col((step - 2) % depth) = h - last_h;
      gains.col((step - 2) % depth) = change - last;
      const MatrixXd g = gains.leftCols(used), both = moves.leftCols(used) + g;
      next -= both * least_squares(g, change);
    }
    last_h = h;
    last = change;
    h = next;
  }
}

int newton(const FluxMap& map, VectorXd& h) {
  for (int step = 1; step <= 25; ++step) {
    const VectorXd off =
        h.array() - map.sigma.array() * pressure_factor(map, h) * slip_factor(map, h);
    MatrixXd jacobian = -through_p(map, h) - through_v(map, h);
    jacobian.diagonal().array() += 1;
    const VectorXd change = solve(jacobian, off);
    h -= change;
    if (!h.allFinite()) return 0;
    if (relative(change, h) < settled) return step;
  }
  return 0;
}

int follow(const FluxMap& unit, double from, double to, VectorXd& h) {
  int taken = 0;
  for (double factor = 2; from < to && factor > 1.001;) {
    const double next = std::min(to, from * factor);
    VectorXd there = h;
    const FluxMap map = heated(unit, next);
    const int steps = newton(map, there);
    const bool near = steps > 0 && relative(there - h, h) < 0.5 &&
                      pressure_factor(map, there).minCoeff() > 0 &&
                      slip_factor(map, there).minCoeff() > 0;
    if (near) {
      h = there;
      from = next;
      taken += steps;
    }
    factor = near ? factor * std::sqrt(factor) : std::sqrt(factor);
  }
  return from < to ? 0 : taken;
}

double contraction(const FluxMap& map, const VectorXd& h, double relaxation) {
  MatrixXd rest = -through_p(map, h);
  rest.diagonal().array() += 1;
  const MatrixXd step = solve(rest, through_v(map, h));
  return (1 - relaxation + relaxation * eigenvalues(step)).abs().maxCoeff();
}

}  // namespace thermoroll
