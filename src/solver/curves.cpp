// Tangled from paper/A-one-answer.md; edit there.
#include "solver/curves.hpp"

#include <algorithm>

#include "solver/nodes.hpp"

namespace thermoroll {

Curves curves_at(const Eigen::ArrayXd& x, const SmoothTractions& by, double friction) {
  const GaussLegendre places{x, 0 * x, (1 + x) / 2, {}, {}, {}};
  const Nodes z = place_nodes({by.slip, by.stick, by.variable}, places, places, by.layer);
  const Eigen::MatrixXd p = legendre(x, by.h.size()), q = legendre(x, by.bracket.size());
  const Eigen::ArrayXd t = (x < 1).select(z.t.max(0).min(1), 1.0), d = z.d.max(0);
  const Eigen::ArrayXd slip_right = by.slip * (1 - t);  // the distances from the edges
  const Eigen::ArrayXd right = by.slip + d, left = (by.stick - d).max(0);
  Curves y;
  y.slip_at = z.s;
  y.stick_at = z.r;
  const Eigen::ArrayXd slip_root = (slip_right * (2 - slip_right)).sqrt();
  const Eigen::ArrayXd stick_root = (left * right).sqrt();
  y.slip_pressure = slip_root * (p * by.pressure).array();
  y.stick_pressure = stick_root * (q * by.stick_pressure).array();
  Eigen::ArrayXd slip_bound = y.slip_pressure, bound = y.stick_pressure;
  if (by.bound.size() > 0) {
    slip_bound = slip_root * (p * by.bound).array();
    bound = stick_root * (q * by.stick_bound).array();
  }
  y.slip_traction = friction * slip_bound;
  y.stick_bound = friction * bound;
  y.stick_traction = y.stick_bound - (left * d).sqrt() * (q * by.bracket).array();
  y.heat_flux = by.slip * (t * (1 - t)).sqrt() * (p * by.h).array();
  const Eigen::ArrayXd left_root = by.slip * t / (by.stick + by.slip * t);
  const Eigen::VectorXd& slips = by.bound.size() > 0 ? by.bound : by.pressure;
  y.slip = (p * by.h).array() / (p * slips).array();
  if (by.stick > 0) y.slip *= left_root.sqrt();
  return y;
}

Profile profile_at(const CoupledSolution& x, const PlotPoints& at) {
  constexpr Eigen::Index block = 1000;
  const SmoothTractions by = smooth_tractions(x, x.unknowns);
  const Eigen::Index m = at.stick.size(), n = at.slip.size();
  const Eigen::ArrayXd none = Eigen::ArrayXd::Zero(m + n);
  Profile y{none, none, none, none, none, none};
  for (Eigen::Index from = 0; from < m; from += block) {
    const Eigen::Index count = std::min(block, m - from);
    const Curves part = curves_at(at.stick.segment(from, count), by, x.scene.friction);
    y.s.segment(from, count) = part.stick_at;
    y.pressure.segment(from, count) = part.stick_pressure;
    y.traction.segment(from, count) = part.stick_traction;
  }
  for (Eigen::Index from = 0; from < n; from += block) {
    const Eigen::Index count = std::min(block, n - from);
    const Curves part = curves_at(at.slip.segment(from, count), by, x.scene.friction);
    y.s.segment(m + from, count) = part.slip_at;
    y.pressure.segment(m + from, count) = part.slip_pressure;
    y.traction.segment(m + from, count) = part.slip_traction;
    y.slip.segment(m + from, count) = part.slip;
    y.heat_flux.segment(m + from, count) = part.heat_flux;
  }
  return y;
}

Eigen::ArrayXd stick_places(const Eigen::ArrayXd& x, const SmoothTractions& from,
                            const SmoothTractions& to) {
  if (from.layer == to.layer || from.stick == 0) return x;
  const auto theta = [&](const SmoothTractions& by) {
    return std::min(1.0, std::sqrt(std::min(by.slip, by.layer) / by.stick));
  };
  const double here = theta(from), there = theta(to);
  const Eigen::ArrayXd q = here * ((1 + x) / 2 * std::log1p(1 / here)).expm1();
  return 2 * (q / there).log1p() / std::log1p(1 / there) - 1;
}

}  // namespace thermoroll
