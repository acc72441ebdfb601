// Tangled from paper/18-what-heat-can-do.md; edit there.
#include "studies/deflation.hpp"

#include <algorithm>

#include <Eigen/LU>

namespace thermoroll {

using Eigen::VectorXd;
using Solutions = std::vector<VectorXd>;

namespace {

double deflated_part(const Solutions& known, double unit, const VectorXd& h, const VectorXd& step) {
  double by_step = 0;  // eta' d / eta
  for (const VectorXd& at : known) {
    const double apart = (h - at).squaredNorm() / (unit * unit);
    by_step -= 2 * (h - at).dot(step) / ((h - at).squaredNorm() * (1 + apart));
  }
  return 1 / (1 - by_step);
}

VectorXd residual(const ContactGrid& grid, const VectorXd& h) {
  const Factors at = factors(grid, h);
  const Eigen::Index n = h.size();
  Eigen::ArrayXd made = grid.nodes.sigma * at.pressure.tail(n) * at.slip.tail(n);
  if (at.phi.size() > 0) made *= at.phi.tail(n);
  return grid.rules.slip.p * h - made.matrix();
}

VectorXd newton_step(const ContactGrid& grid, const VectorXd& h) {
  const VectorXd missing = residual(grid, h);
  const double by = 1e-7 * h.norm();
  Eigen::MatrixXd jacobian(h.size(), h.size());
  for (Eigen::Index j = 0; j < h.size(); ++j)
    jacobian.col(j) = (residual(grid, h + by * VectorXd::Unit(h.size(), j)) - missing) / by;
  return jacobian.partialPivLu().solve(-missing);
}

bool is_known(const Solutions& known, double unit, const VectorXd& h) {
  const auto is_near = [&](const VectorXd& at) { return (h - at).norm() < 1e-6 * unit; };
  return std::any_of(known.begin(), known.end(), is_near);
}

bool reaches_another(const ContactGrid& grid, const Solutions& known, double unit, VectorXd& h) {
  for (int step = 0; step < 60 && h.allFinite(); ++step) {
    const VectorXd move = newton_step(grid, h);
    h += deflated_part(known, unit, h, move) * move;
    if (move.norm() < 1e-9 * h.norm()) return !is_known(known, unit, h);
  }
  return false;
}

VectorXd random_start(const ContactGrid& grid, const VectorXd& carter, Random& random) {
  VectorXd flux = grid.rules.slip.p * carter;
  for (double& at_node : flux) at_node *= 10 * random.uniform();
  return to_legendre(grid.rules.slip, flux);
}

}  // namespace

Solutions distinct_solutions(const ContactGrid& grid, int starts, Random random) {
  const VectorXd carter = carter_h(grid);
  Solutions known;
  for (int k = 0; k < starts; ++k) {
    const VectorXd start = k == 0 ? carter : random_start(grid, carter, random);
    for (VectorXd h = start; reaches_another(grid, known, carter.norm(), h); h = start)
      known.push_back(h);
  }
  return known;
}

}  // namespace thermoroll
