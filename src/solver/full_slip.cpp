// Tangled from paper/20-full-slip.md; edit there.
#include "solver/full_slip.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "support/number_text.hpp"

namespace thermoroll {

using Eigen::VectorXd;
using enum Quantity;

namespace {

bool is_contact(GridSolution x, bool without_load = false) {
  forget_the_edge(x, 1e-3);
  const bool no_load = x.violations.size() == 1 && x.violations[0].what == "no load";
  return x.newton_steps > 0 && (without_load ? no_load : x.violations.empty());
}

struct Followed {
  GridSolution contact;  // the last; no newton_steps if full slip begins with none
  double creep;          // of the last
  GridSolution beyond;   // without a load; no newton_steps if it is not lost
};

constexpr int followed_unknowns = 80;

Followed follow_contacts(SlippingGrids& grids, double creep) {
  const GridSolution first = next_to_full_slip(grids.scene, grids.formulation, followed_unknowns);
  Followed x{first, first.value(Quantity::creep), {}};
  if (!is_contact(first) || !(x.creep > 0)) return {};
  for (double growth = 1.1; x.creep < creep && growth > 1.0001;) {
    const double next = std::min(growth * x.creep, creep);
    const GridSolution at = solve_slipping_grid(grids, followed_unknowns, next, x.contact);
    if (is_contact(at, true)) return {x.contact, x.creep, at};
    const bool contact = is_contact(at);
    growth = contact ? std::min(2.0, growth * growth) : std::sqrt(growth);
    if (contact) x = {at, next, {}};
  }
  return x;
}

/// 0 if the secants do not arrive.
double creep_without_load(SlippingGrids& grids, const Followed& from) {
  GridSolution last = from.contact, now = from.beyond;
  for (int step = 0; step < 20; ++step) {
    if (std::abs(now.value(load_ratio)) < 1e-10) return now.value(Quantity::creep);
    const double per_load = (now.value(Quantity::creep) - last.value(Quantity::creep)) /
                            (now.value(load_ratio) - last.value(load_ratio));
    const double next = now.value(Quantity::creep) - per_load * now.value(load_ratio);
    last = now;
    now = solve_slipping_grid(grids, followed_unknowns, next, last);
    if (!is_contact(now) && !is_contact(now, true)) break;
  }
  return 0;
}

constexpr int finer_unknowns = 212;

/// 0 if there is none.
double known_contact(const SlippingGrids& grids, const Followed& found) {
  SlippingGrids finer{grids.scene, grids.formulation};
  for (const double share : {1 - 1e-6, 0.999, 0.99, 0.9}) {
    const double there = share * found.creep;
    if (!(there > 0)) break;
    if (is_contact(solve_slipping_grid(finer, finer_unknowns, there, found.contact))) return there;
  }
  return creep_of_some_stick(grids.scene, grids.formulation);
}

bool is_lost_beyond(SlippingGrids& grids, const Followed& found) {
  if (!(found.creep > 0)) return false;
  SlippingGrids finer{grids.scene, grids.formulation};
  const double there = 1.01 * found.creep;
  GridSolution x = solve_slipping_grid(grids, followed_unknowns, there, found.contact);
  GridSolution y = solve_slipping_grid(finer, finer_unknowns, there, found.contact);
  for (GridSolution* each : {&x, &y}) forget_the_edge(*each, 1e-3);
  return x.newton_steps > 0 && y.newton_steps > 0 && !y.violations.empty() &&
         agreed_violations(x.violations, y.violations);
}

bool drives(const SlippingGrids& grids) { return grids.scene.direction == Direction::driving; }

/// The size is negative on the other side of no creep, where a bulk difference moves no slip.
std::string signed_text(const SlippingGrids& grids, const std::string& size) {
  if (drives(grids)) return size;
  return size[0] == '-' ? size.substr(1) : "-" + size;
}

std::string at_least(const SlippingGrids& grids, double size) {
  return (drives(grids) ? "at least " : "at most ") + signed_text(grids, rounded_down(size, 7));
}

[[noreturn]] void refuse_beyond(const SlippingGrids& grids, double creep,
                                const std::string& limit) {
  const std::string asked = signed_text(grids, shortest(creep));
  throw std::invalid_argument("creep = " + asked + " is not allowed: it must be " +
                              (drives(grids) ? "below" : "above") + " the creep_limit of " + limit +
                              ", where contact is lost");
}

void refuse_if_lost(SlippingGrids& grids, double creep, const Followed& found) {
  double limit = 0;
  if (found.beyond.newton_steps > 0) limit = creep_without_load(grids, found);
  if (limit > 0) refuse_beyond(grids, creep, "about " + signed_text(grids, rounded_down(limit, 7)));
  if (!(1.01 * found.creep < creep) || !is_lost_beyond(grids, found)) return;
  const double known = known_contact(grids, found);
  if (known > 0) refuse_beyond(grids, creep, at_least(grids, known));
}

/// By std::invalid_argument where contact is lost before it, else by std::runtime_error.
[[noreturn]] void refuse_without_contact(SlippingGrids& grids, double creep,
                                         const Followed& found) {
  refuse_if_lost(grids, creep, found);
  const double known = known_contact(grids, found);
  const std::string asked = signed_text(grids, shortest(creep));
  throw std::runtime_error("coupled: no contact found in full slip at the creep " + asked +
                           (known > 0 ? "; the creep_limit is " + at_least(grids, known) : ""));
}

/// The contact that is followed to the creep, else a solution with a load; refuses a creep that has
/// neither, or at which contact is lost.
GridSolution followed_full_slip(SlippingGrids& grids, double creep, const GridSolution& found) {
  const Followed x = follow_contacts(grids, creep);
  if (x.contact.newton_steps > 0 && x.creep == creep) return x.contact;
  const auto loaded = [](const GridSolution& y) {
    return y.newton_steps > 0 && y.value(load_ratio) > 0;
  };
  if (x.beyond.newton_steps > 0) refuse_without_contact(grids, creep, x);
  if (loaded(found)) return found;
  GridSolution last = solve_slipping_grid(grids, followed_unknowns, creep, x.contact);
  if (loaded(last)) return last;
  refuse_without_contact(grids, creep, x);
}

}  // namespace

ContactGrid full_slip_grid(const Scene& scene, Formulation formulation, int n,
                           const SlipVariable& by) {
  ContactGrid grid = contact_grid(scene, formulation, {2, 0, by}, n);
  const VectorXd rigid = 2 * scene.friction / pi * grid.nodes.s;
  TractionOperators& x = grid.tractions;
  x.v0 = rigid;
  const BulkTerms& bulk = grid.thermal.bulk;
  if (grid.bulk)
    x.v0 += (rigid * bulk.kappa - bulk.g.head(n)).array() + scene.friction * bulk.gamma0;
  x.v = rigid * x.kappa - grid.thermal.g.topRows(n);
  x.v.rowwise() += scene.friction * x.gamma0;
  return grid;
}

ContactGrid at_creep(ContactGrid grid, double creep) {
  grid.tractions.v0 += creep;
  grid.creep = creep;
  return grid;
}

/// The solution on the first grid that has an admissible one; else that of the finest grid, which
/// may violate conditions or have no newton_steps.
GridSolution coarse_full_slip(SlippingGrids& grids, double creep) {
  GridSolution level;
  for (int n = 10; n <= 80; n *= 2) {
    level = solve_slipping_grid(grids, n, creep, level);
    if (level.newton_steps > 0 && level.violations.empty()) return level;
  }
  return level;
}

void forget_the_edge(GridSolution& x, double length, bool also_others) {
  const auto at_the_edge = [&](const Violation& v) {
    return (also_others || v.what == "backward slip") && v.to < length - 1;
  };
  auto& all = x.violations;
  all.erase(std::remove_if(all.begin(), all.end(), at_the_edge), all.end());
}

bool should_stick_at_edge(const Scene& scene, const GridSolution& x) {
  if (scene.bulk_difference == 0) return false;
  const auto at_the_edge = [](const Violation& v) {
    return v.what == "backward slip" && v.from < -0.99 && v.to - v.from > 0.002;
  };
  return std::any_of(x.violations.begin(), x.violations.end(), at_the_edge);
}

CoupledSolution solve_full_slip(const Scene& scene, const Approach& approach, double creep) {
  const Formulation formulation = approach.formulation;
  SlippingGrids grids{scene, formulation};
  GridSolution level = coarse_full_slip(grids, creep);
  if (!is_contact(level)) level = followed_full_slip(grids, creep, level);
  const auto n = static_cast<int>(level.h.size());
  const double more = 1e-3 * scale_in(scene, level.value)(Quantity::creep);
  Results slope = (solve_slipping_grid(grids, n, creep + more, level).value - level.value) / more;
  const auto next = [&](int finer, const GridSolution& last) {
    SlippingGrids once{scene, formulation};
    const SlipVariable by = variable_after(last, finer);
    GridSolution x = solve_slipping_grid(once, finer, creep, last, by);
    forget_the_edge(x, 0.5 * std::sqrt(approach.tolerance));
    return x;
  };
  try {
    return refine(scene, approach, {Quantity::creep, creep}, level, slope, next);
  } catch (const NotResolved&) {
    refuse_if_lost(grids, creep, follow_contacts(grids, creep));
    throw;
  }
}

void refuse_undetermined_creep(const Scene& scene, Formulation formulation) {
  const GridSolution full = next_to_full_slip(scene, formulation, 40);
  const double sign = sign_of(scene.direction);
  std::string message =
      "traction = " + shortest(sign * scene.friction) +
      " is the friction: the whole contact slips, and the creep is not determined";
  if (full.newton_steps > 0)
    message += sign > 0 ? "; it is at least " + rounded_down(full.value(Quantity::creep), 4)
                        : "; it is at most " + rounded_up(-full.value(Quantity::creep), 4);
  throw std::invalid_argument(message);
}

}  // namespace thermoroll
