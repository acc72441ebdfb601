// Tangled from paper/20-full-slip.md; edit there.
#include "solver/full_slip.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/number_text.hpp"

namespace thermoroll {

using Eigen::VectorXd;
using enum Quantity;

namespace {

/// Refuse, by std::invalid_argument, a creep without a contact, naming the creep where that ends.
[[noreturn]] void refuse_without_contact(const Scene& scene, Formulation formulation,
                                         double creep) {
  constexpr int n = 80;
  GridSolution last = next_to_full_slip(scene, formulation, n);
  if (last.newton_steps == 0)
    throw std::runtime_error("coupled: no solution found in full slip at the creep " +
                             shortest(creep));
  double low = last.value(Quantity::creep), high = creep;
  last = {};
  for (int halving = 0; halving < 20; ++halving) {
    const double middle = low + (high - low) / 2;
    const GridSolution at = solve_slipping_grid(scene, formulation, n, middle, last);
    const bool contact = at.newton_steps > 0 && at.value(load_ratio) > 0;
    (contact ? low : high) = middle;
    if (contact) last = at;
  }
  const int decimals = std::max(0, 6 - static_cast<int>(std::floor(std::log10(low))));
  const double unit = std::pow(10, -decimals), limit = std::floor(low / unit) * unit;
  throw std::invalid_argument("creep = " + shortest(creep) +
                              " is not allowed: it must be below the creep_limit of about " +
                              fixed(limit, decimals) + ", where contact is lost");
}

}  // namespace

ContactGrid full_slip_grid(const Scene& scene, Formulation formulation, int n, double creep) {
  ContactGrid grid = contact_grid(scene, formulation, {2, 0}, n);
  const VectorXd rigid = 2 * scene.friction / pi * grid.nodes.s;
  TractionOperators& x = grid.tractions;
  x.v0 = creep + rigid.array();
  const BulkTerms& bulk = grid.thermal.bulk;
  if (grid.bulk)
    x.v0 += (rigid * bulk.kappa - bulk.g.head(n)).array() + scene.friction * bulk.gamma0;
  x.v = rigid * x.kappa - grid.thermal.g.topRows(n);
  x.v.rowwise() += scene.friction * x.gamma0;
  grid.creep = creep;
  return grid;
}

/// The solution on the first grid that has an admissible one; no newton_steps if none has.
GridSolution coarse_full_slip(const Scene& scene, Formulation formulation, double creep) {
  GridSolution level;
  for (int n = 10; n <= 80; n *= 2) {
    level = solve_slipping_grid(scene, formulation, n, creep, level);
    if (level.newton_steps > 0 && level.violations.empty()) return level;
  }
  return level;
}

void forget_the_edge(GridSolution& x, double length) {
  const auto at_the_edge = [&](const Violation& v) {
    return v.what == "backward slip" && v.to < length - 1;
  };
  auto& all = x.violations;
  all.erase(std::remove_if(all.begin(), all.end(), at_the_edge), all.end());
}

CoupledSolution solve_full_slip(const Scene& scene, const Approach& approach, double creep) {
  const Formulation formulation = approach.formulation;
  const GridSolution level = coarse_full_slip(scene, formulation, creep);
  if (level.newton_steps == 0 || !(level.value(load_ratio) > 0))
    refuse_without_contact(scene, formulation, creep);
  const auto n = static_cast<int>(level.h.size());
  const double more = 1e-3 * creep;
  Results slope =
      (solve_slipping_grid(scene, formulation, n, creep + more, level).value - level.value) / more;
  return refine(scene, approach, {Quantity::creep, creep}, level, slope,
                [&](int finer, const GridSolution& last) {
                  GridSolution x = solve_slipping_grid(scene, formulation, finer, creep, last);
                  forget_the_edge(x, 0.5 * std::sqrt(approach.tolerance));
                  return x;
                });
}

void refuse_undetermined_creep(const Scene& scene, Formulation formulation) {
  const GridSolution full = next_to_full_slip(scene, formulation, 40);
  const double sign = sign_of(scene.direction);
  std::string message =
      "traction = " + shortest(sign * scene.friction) +
      " is the friction: the whole contact slips, and the creep is not determined";
  if (full.newton_steps > 0)
    message += std::string(sign > 0 ? "; it is at least " : "; it is at most ") +
               fixed(sign * full.value(Quantity::creep), 4);
  throw std::invalid_argument(message);
}

}  // namespace thermoroll
