// Tangled from paper/22-creep-curve.md; edit there.
#include "thermoroll/creep_law.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <Eigen/Core>

#include "solver/conduction.hpp"
#include "solver/full_slip.hpp"
#include "solver/gauss_legendre.hpp"
#include "solver/grid_solution.hpp"
#include "solver/linear_system.hpp"
#include "solver/surface.hpp"
#include "support/number_text.hpp"
#include "thermoroll/coupled.hpp"

namespace thermoroll {
namespace {

/// Whether a piece is of partial slip.
bool slips_partially(const LawPiece& piece) { return piece.from < 1; }

struct SeriesValue {
  double value, slope;
};

/// The series at -1 <= x <= 1, and its derivative by x.
SeriesValue clenshaw(const LawSeries& c, double x) {
  double b = 0, before = 0, d = 0, d_before = 0;
  for (std::size_t j = c.size() - 1; j > 0; --j) {
    const double next = 2 * x * b - before + c[j], d_next = 2 * x * d - d_before + 2 * b;
    before = b;
    b = next;
    d_before = d;
    d = d_next;
  }
  return {x * b - before + c[0], b + x * d - d_before};
}

/// A scene in its direction, the state without slip there, the creep at which its stick zone
/// vanishes, and grids beyond it.
struct HalfCurve {
  Scene scene;
  Formulation formulation;
  NoSlip rest;
  double all_slips;
  SlippingGrids slipping{scene, formulation};
};

/// The solution's largest T*.
double hottest(const HalfCurve& curve, const GridSolution& x) {
  if (x.crossing) return x.value(Quantity::max_temperature);  // which has searched there too
  const auto n = static_cast<int>(x.h.size());
  const int nodes = temperature_nodes(n, curve.scene.peclet * x.at.slip);
  const HottestPoint trailing =
      find_hottest(x.at, Conduction(curve.scene), x.h, {0.98, 0, -3}, rounded_up(8, nodes));
  return std::max(x.value(Quantity::max_temperature), heat_share(curve.scene) * trailing.value);
}

/// On a grid of n unknowns at w = rho of @eq:curve-parameter, from a solution near by or from none.
GridSolution solution_at(HalfCurve& curve, int n, double w, GridSolution near) {
  const double without = curve.rest.creep;
  const double full_slip_creep = without + (curve.all_slips - without) / std::max(2 - w, 1e-8);
  const auto from = [&](const GridSolution& start) {
    const SlipVariable by = about_kinks(start, n);
    return w < 1 ? solve_on_grid(curve.scene, curve.formulation, n, {2 * w * w, 2 - 2 * w * w, by},
                                 start)
                 : solve_slipping_grid(curve.slipping, n, full_slip_creep, start, by);
  };
  if (near.h.size() > n) near.h.conservativeResize(n);
  GridSolution x = from(near);
  if (x.newton_steps == 0) x = from({});
  if (x.newton_steps == 0 && n > 40) x = from(solution_at(curve, n / 2, w, near));
  const GridSolution again = misses_kink(x) ? from(x) : x;
  if (again.newton_steps > 0) x = again;
  forget_the_edge(x, 0.005, curve.scene.bulk_difference != 0);
  if (x.newton_steps > 0) x.value(Quantity::max_temperature) = hottest(curve, x);
  return x;
}

/// A number of unknowns, and that of the grid it is compared with.
struct LawGrid {
  int n, finer;
};

constexpr std::array<LawGrid, 5> law_grids{{{20, 33}, {28, 46}, {40, 66}, {64, 106}, {106, 176}}};

bool agree(const Scene& scene, const GridSolution& x, const GridSolution& y, double tolerance) {
  if (x.newton_steps == 0 || y.newton_steps == 0) return false;
  const Results change = (x.value - y.value).abs() / scale_in(scene, y.value);
  return std::max({change(Quantity::traction), change(Quantity::creep),
                   change(Quantity::max_temperature)}) < tolerance;
}

double leeway(int n, double w, bool kinked) { return n >= 64 && (kinked || w < 1.5) ? 10 : 1; }

/// A point with a contact: w, its solution and the grid that resolves it.
struct LawPoint {
  double w = 0;
  GridSolution at{};
  const LawGrid* grid = law_grids.data();
};

/// That contact is lost, or not, by a finer grid than that of x; nothing if it does not tell.
std::optional<bool> is_lost(HalfCurve& curve, double w, const GridSolution& x) {
  if (x.violations.empty()) return false;
  const GridSolution fine = solution_at(curve, 212, w, x);
  if (fine.newton_steps == 0) return std::nullopt;
  if (fine.violations.empty()) return false;
  const bool same = fine.violations.front().what == x.violations.front().what;
  return same ? std::optional(true) : std::nullopt;
}

constexpr const char* not_resolved = "the solution is not resolved (a larger tolerance may go on)";
constexpr const char* not_endless = "creeps from there to infinity are not resolved together";
constexpr const char* not_asked = "no more was asked for";
constexpr const char* turns_back = "the creep turns back";
const std::string contact_is_lost = "contact is lost: ";

/// Go on to w on grids up to this one. The reason why the curve does not; empty if it does.
std::string go_on(HalfCurve& curve, double tolerance, double w, LawPoint& last,
                  const LawGrid& finest = law_grids.back()) {
  for (const LawGrid* grid = last.grid; grid <= &finest; ++grid) {
    const GridSolution x = solution_at(curve, grid->n, w, last.at);
    const GridSolution y = solution_at(curve, grid->finer, w, x);
    if (!agree(curve.scene, x, y, leeway(grid->n, w, !x.kinks.empty()) * tolerance)) continue;
    const std::optional<bool> lost = is_lost(curve, w, y);
    if (!lost) continue;
    if (*lost) return contact_is_lost + y.violations.front().what;
    if (x.value(Quantity::creep) <= last.at.value(Quantity::creep)) return turns_back;
    last = {w, x, grid};
    return "";
  }
  return not_resolved;
}

/// The reason for the end, of which last becomes the point; there is none at w, for a reason.
std::string find_end(HalfCurve& curve, double tolerance, double w, std::string reason,
                     LawPoint& last) {
  for (int k = 0; k < (reason == not_resolved ? 3 : 14); ++k) {
    const double middle = (last.w + w) / 2;
    const std::string there = go_on(curve, tolerance, middle, last);
    if (there.empty()) continue;
    w = middle;
    reason = there;
  }
  return reason;
}

/// Errors of the stored functions: of Q*, of T* as a CreepLaw has it, and of c0.
using LawErrors = Eigen::Array3d;

struct HalfInTheMaking {
  HalfCurve curve;
  LawErrors tolerance;
  LawHalf half{};
  LawErrors error = LawErrors::Zero();
};

struct Stored {
  double creep, z;
  Eigen::Array3d value;  // traction, temperature, slip length
};

/// The solution at w, for a piece that sticks or one in full slip.
Stored stored(const HalfInTheMaking& x, bool sticks, double w, const GridSolution& at) {
  const NoSlip& rest = x.curve.rest;
  const double unit = x.half.unit_creep, creep = at.value(Quantity::creep) - rest.creep;
  if (w == 0) {
    const Scene& scene = x.curve.scene;
    const double cold = scene.friction * (scene.law ? scene.law(0).value : 1);
    return {0, 0, {pi, 0, pi * unit / cold}};
  }
  const double q = at.value(Quantity::traction), t = at.value(Quantity::max_temperature);
  if (!sticks) return {creep, w, {q, t * unit / creep, 2}};
  const double slip_length = at.value(Quantity::slip_length);
  return {
      creep, std::sqrt(creep / unit), {(q - rest.traction) / creep, t, slip_length * unit / creep}};
}

LawPiece fitted(const std::array<Stored, law_terms>& y) {
  LawPiece piece{y.front().z, y.back().z, {}, {}, {}};
  Eigen::Matrix<double, law_terms, law_terms> terms;
  Eigen::Matrix<double, law_terms, 3> values;
  for (int k = 0; k < law_terms; ++k) {
    const Stored& at = y[static_cast<std::size_t>(k)];
    const double x = 2 * (at.z - piece.from) / (piece.to - piece.from) - 1;
    const double angle = std::acos(std::clamp(x, -1.0, 1.0));
    for (int j = 0; j < law_terms; ++j) terms(k, j) = std::cos(j * angle);
    values.row(k) = at.value;
  }
  const Eigen::MatrixXd c = solve(terms, values);
  std::copy_n(c.col(0).data(), law_terms, piece.traction.begin());
  std::copy_n(c.col(1).data(), law_terms, piece.temperature.begin());
  std::copy_n(c.col(2).data(), law_terms, piece.slip_length.begin());
  return piece;
}

LawErrors errors_of(const LawErrors& difference, bool sticks, const Stored& at) {
  return difference.abs() * LawErrors(sticks ? at.creep : 1, 1, at.z * at.z);
}

LawErrors missed(const LawPiece& piece, bool sticks, const Stored& at) {
  const double x = 2 * (at.z - piece.from) / (piece.to - piece.from) - 1;
  const LawErrors value(clenshaw(piece.traction, x).value, clenshaw(piece.temperature, x).value,
                        clenshaw(piece.slip_length, x).value);
  return errors_of(value - at.value, sticks, at);
}

/// The node k of a piece, or a point between two nodes; the ends are met to the last bit.
double law_node(double from, double to, double k) {
  if (k == law_terms - 1) return to;
  return from + (to - from) * (1 - std::cos(pi * k / (law_terms - 1))) / 2;
}

/// The w of both, 0 if there is no corner, and the solution before it.
struct Corner {
  double before = 0, after = 0;
  GridSolution near{};
};

struct Findings {
  bool solved = true, kinked = false;
  bool rises = true;      // the creep from node to node
  Corner corner{};        // the first one
  std::string lost{};     // why there is no contact at one of them; empty if there is
  double first_lost = 0;  // its w
  bool fails() const { return !solved || !lost.empty(); }
};

struct Trial {
  LawPiece piece;
  LawErrors error, of_grid;
  Findings found{};
};

Trial no_piece(const Findings& found) {
  return {{}, LawErrors::Constant(1), LawErrors::Constant(1), found};
}

/// Whether it misses the tolerance, by its grid alone.
bool is_too_coarse(const Trial& trial, const LawErrors& tolerance) {
  const Eigen::Array<bool, 3, 1> misses = trial.error > tolerance;
  const Eigen::Array<bool, 3, 1> by_grid = trial.of_grid > 0.3 * trial.error;
  return misses.any() && (!misses || by_grid).all();
}

bool rises(const std::array<Stored, law_terms>& y) {
  const auto falls = [](const Stored& x, const Stored& next) { return !(x.z < next.z); };
  return std::adjacent_find(y.begin(), y.end(), falls) == y.end();
}

/// The solution at w on a grid of n unknowns becomes the last one.
Stored stored_at(HalfInTheMaking& x, bool sticks, int n, double w, GridSolution& last,
                 Findings& found) {
  if (w > 0) {
    const GridSolution there = solution_at(x.curve, n, w, last);
    if (there.newton_steps > 0) last = there;
    found.solved = found.solved && there.newton_steps > 0;
    found.kinked = found.kinked || !there.kinks.empty();
    if (found.lost.empty() && is_lost(x.curve, w, there).value_or(false)) {
      found.lost = contact_is_lost + there.violations.front().what;
      found.first_lost = w;
    }
  }
  return stored(x, sticks, w, last);
}

Trial try_piece(HalfInTheMaking& x, const LawGrid& grid, double from, double to,
                GridSolution near) {
  Findings found;
  const auto at = [&](int n, double k, GridSolution& last) {
    return stored_at(x, to <= 1, n, law_node(from, to, k), last, found);
  };
  std::array<Stored, law_terms> y;
  for (int k = 0; k < law_terms; ++k) {
    const GridSolution last = near;
    y[static_cast<std::size_t>(k)] = at(grid.n, k, near);
    if (found.fails()) return no_piece(found);
    if (k > 0 && found.corner.after == 0 && near.kinks.size() != last.kinks.size())
      found.corner = {law_node(from, to, k - 1), law_node(from, to, k), last};
  }
  constexpr double times = 3;
  const int step = found.kinked || x.curve.scene.bulk_difference != 0 ? 1 : 3;
  Trial trial{fitted(y), times / 15 * x.tolerance, LawErrors::Zero()};
  GridSolution near_finer = near;
  for (int upper = 10; upper > 0; upper -= step) {
    const double k = upper - 0.5;
    const Stored fine = at(grid.finer, k, near_finer);
    if (found.fails()) break;
    trial.error = trial.error.max(times * missed(trial.piece, to <= 1, fine));
    if ((trial.error <= x.tolerance).all()) continue;
    const LawErrors moved = errors_of(at(grid.n, k, near).value - fine.value, to <= 1, fine);
    trial.of_grid = trial.of_grid.max(times * moved);
    if (!is_too_coarse(trial, x.tolerance) || (trial.error > 10 * x.tolerance).any()) break;
  }
  found.rises = rises(y);
  if (found.fails() || !found.rises) return no_piece(found);
  trial.found = found;
  return trial;
}

/// On a grid of n unknowns.
double place_to_divide(HalfCurve& curve, const Trial& trial, int n, double from, double to) {
  auto [before, after, near] = trial.found.corner;
  const double middle = (from + to) / 2;
  if (after == 0) return middle;
  for (int k = 0; k < 12; ++k) {
    const double w = (before + after) / 2;
    const bool same = solution_at(curve, n, w, near).kinks.size() == near.kinks.size();
    (same ? before : after) = w;
  }
  const bool inside = std::min(after - from, to - after) > 1e-3 * (to - from);
  return inside ? after : middle;
}

/// Add the pieces from w = from to w = to, on this grid or finer ones; the reason for an early end.
/// Of a part of a piece, whole is the error of that.
std::string add_pieces(HalfInTheMaking& x, const LawGrid* grid, double from, double to,
                       const GridSolution& near, const LawErrors& whole = LawErrors::Constant(1)) {
  const auto by_grid = [&](const Trial& at) {
    const LawErrors miss = (at.error > x.tolerance).select(at.error, 0);
    return is_too_coarse(at, x.tolerance) || (miss > 0.8 * whole).any();
  };
  Trial trial = try_piece(x, *grid, from, to, near);
  const std::string& lost = trial.found.lost;
  while (lost.empty() && by_grid(trial) && grid != &law_grids.back())
    trial = try_piece(x, *++grid, from, to, near);
  const bool coarse = lost.empty() && trial.found.rises && is_too_coarse(trial, x.tolerance);
  const double allowed = coarse ? leeway(grid->n, from, trial.found.kinked) : 1;
  if (lost.empty() && (trial.error <= allowed * x.tolerance).all()) {
    x.half.pieces.push_back(trial.piece);
    x.error = x.error.max(trial.error);
    return "";
  }
  const double end = lost.empty() ? to : trial.found.first_lost;
  const bool all_slips = from >= 1;
  const double of_grid = all_slips ? 0.1 : 0.03, of_loss = all_slips ? 5e-3 : 3e-4;
  const double least = coarse ? of_grid : lost.empty() ? 3e-4 : of_loss;
  const std::string early = trial.found.rises ? not_resolved : turns_back;
  if (end - from < least * (2 - from)) return lost.empty() ? early : lost;
  const double middle = place_to_divide(x.curve, trial, std::min(grid->n, 40), from, end);
  const LawGrid* coarser = std::max(grid - 1, law_grids.data());
  const std::string reason = add_pieces(x, coarser, from, middle, near, trial.error);
  return reason.empty() ? add_pieces(x, grid, middle, end, near, trial.error) : reason;
}

/// Without slip, or at the first contact found; the creep alone is that of a solution.
LawPoint beginning(HalfCurve& curve) {
  LawPoint first;
  double& creep = first.at.value(Quantity::creep);
  creep = curve.rest.creep;
  if (curve.scene.bulk_difference == 0) return first;
  first.w = 0.02;
  for (double w = 0.02; w < 0.5; w *= 2) {
    const GridSolution x = solution_at(curve, 33, w, {});
    if (x.newton_steps == 0 || is_lost(curve, w, x).value_or(true)) continue;
    first.w = w;
    creep = x.value(Quantity::creep);
    break;
  }
  return first;
}

/// The last point that has a contact up to w = 1, and the reason for an end before it.
std::string go_to_full_slip(HalfCurve& curve, double tolerance, LawPoint& last) {
  if (go_on(curve, tolerance, 1, last).empty()) return "";
  for (const double w : {0.1, 0.4, 0.7, 0.9, 1.0}) {
    if (w <= last.w) continue;
    const std::string reason = go_on(curve, tolerance, w, last);
    if (!reason.empty()) return find_end(curve, tolerance, w, reason, last);
  }
  return "";
}

/// Add them up to the creep reach, from the last point on; the reason for an end.
std::string add_slipping_pieces(HalfInTheMaking& x, double reach, double tolerance,
                                LawPoint& last) {
  const double unit = x.half.unit_creep, farthest = reach > unit ? 2 - unit / reach : 1;
  std::string at_farthest = farthest < 2 ? not_asked : "";
  const auto add = [&](double to, const LawPoint& since, const std::string& then) {
    const std::string early = add_pieces(x, last.grid, since.w, to, since.at);
    return early.empty() ? then : early;
  };
  LawPoint far = last;
  if (farthest == 1) return at_farthest;
  if (go_on(x.curve, tolerance, farthest, far, *last.grid).empty())
    return add(farthest, last, at_farthest);
  for (const double next : {1.5, 1.75, 1.9, 1.97, 1.99, 1.999, 2.0}) {
    const double w = std::min(next, farthest);
    const LawPoint before = last;
    const LawGrid& finest = w < 2 ? law_grids.back() : *last.grid;
    std::string reason = go_on(x.curve, tolerance, w, last, finest);
    if (!reason.empty() && w < 2) reason = find_end(x.curve, tolerance, w, reason, last);
    if (reason == not_resolved && w == 2) reason = not_endless;
    if (last.w > before.w) reason = add(last.w, before, reason);
    if (!reason.empty()) return reason;
    if (w == farthest) break;
  }
  return at_farthest;
}

void end_after_pieces(LawHalf& half, double reach) {
  if (half.pieces.empty()) throw NotResolved("law: it ends where it begins: " + half.reason, {});
  const double z = half.pieces.back().to;
  const double share = slips_partially(half.pieces.back()) ? std::min(z * z, 1.0) : 1 / (2 - z);
  half.last_creep = z < 2 ? half.unit_creep * share : std::numeric_limits<double>::infinity();
  if (half.reason == not_asked && z > 1) half.last_creep = reach;
}

double creep_without_stick(const Scene& scene, Formulation formulation, double tolerance) {
  GridSolution last;
  for (const auto& [n, finer] : law_grids) {
    const double coarse = next_to_full_slip(scene, formulation, n).value(Quantity::creep);
    last = next_to_full_slip(scene, formulation, finer);
    const double change = coarse - last.value(Quantity::creep);
    if (std::abs(change) < tolerance / 10 * last.value(Quantity::creep)) break;
  }
  const auto n = static_cast<int>(last.h.size());
  const GridSolution before = solve_on_grid(scene, formulation, n, {2 - 1e-3, 1e-3}, last);
  const Results slope = (last.value - before.value) / (1e-3 - last.at.stick);
  return last.value(Quantity::creep) + slope(Quantity::creep) * last.at.stick;
}

bool may_slip_on(const std::string& reason) {
  return reason == turns_back || reason == not_resolved;
}

/// Why partial slip ends where its pieces do, for a reason.
std::string end_of_partial_slip(LawHalf& half, const std::string& reason) {
  const double end = half.pieces.empty() ? 0 : half.pieces.back().to;
  if (end == 0 || (end <= 1 && !may_slip_on(reason))) return reason;
  half.unit_creep *= end * end;
  for (LawPiece& piece : half.pieces) {
    piece.from /= end;
    piece.to /= end;
    for (double& term : piece.slip_length) term *= end * end;
  }
  return end > 1 ? turns_back : reason;
}

/// The contact in full slip at the creep where partial slip ends; nothing if there is none.
std::optional<LawPoint> full_slip_at_the_end(HalfInTheMaking& x, double tolerance) {
  x.curve.all_slips = x.curve.rest.creep + x.half.unit_creep;
  LawPoint slips;
  slips.at.value(Quantity::creep) = x.curve.rest.creep;
  return go_on(x.curve, tolerance, 1, slips).empty() ? std::optional(slips) : std::nullopt;
}

/// Whether it goes on where the last piece turns back; if so, last is there.
bool slips_on(HalfInTheMaking& x, double tolerance, LawPoint& last) {
  if (x.half.pieces.empty() || !may_slip_on(x.half.reason)) return false;
  const auto slips = full_slip_at_the_end(x, tolerance);
  if (!slips) return false;
  const LawErrors jump = missed(x.half.pieces.back(), true, stored(x, true, 1, slips->at));
  LawErrors most = x.tolerance;
  if (x.curve.scene.bulk_difference != 0) most(2) = std::max(most(2), 0.005);
  if ((jump > most).any()) return false;
  x.error = x.error.max(jump);
  last = *slips;
  return true;
}

/// On a grid of n unknowns.
LawErrors change_before(HalfInTheMaking& x, int n, double first) {
  const GridSolution at = solution_at(x.curve, n, first, {}),
                     before = solution_at(x.curve, n, first / 10, at);
  if (at.newton_steps == 0) return LawErrors::Constant(1);
  Stored there = stored(x, true, first, at);
  const LawErrors all = errors_of(there.value, true, there);
  if (before.newton_steps == 0) return all;
  there.value -= stored(x, true, first / 10, before).value;
  return errors_of(there.value, true, there);
}

/// A point from which full slip is the same to the tolerance, where the border goes to -1 slowly.
std::optional<LawPoint> end_before_full_slip(HalfInTheMaking x, double tolerance) {
  const double stick = std::min(0.004, x.tolerance(2) / 3), w = std::sqrt(1 - stick / 2);
  const double unit = x.half.unit_creep, without = x.curve.rest.creep;
  LawPoint end;
  end.at.value(Quantity::creep) = without;
  if (!go_on(x.curve, tolerance, w, end).empty()) return std::nullopt;
  x.half.unit_creep = end.at.value(Quantity::creep) - without;
  const bool slowly = std::sqrt(x.half.unit_creep / unit) < 1 - 4 * (1 - w);
  const auto slips = slowly ? full_slip_at_the_end(x, tolerance) : std::nullopt;
  if (!slips) return std::nullopt;
  const Stored sticks = stored(x, true, 1, end.at);
  const LawErrors jump = sticks.value - stored(x, true, 1, slips->at).value;
  const bool same = (errors_of(jump, true, sticks) <= x.tolerance).all();
  return same ? std::optional(end) : std::nullopt;
}

HalfInTheMaking half_law(const Scene& scene, Formulation formulation, double tolerance,
                         double reach, NoSlip rest) {
  const double sign = sign_of(scene.direction);
  rest.creep *= sign;
  rest.traction *= sign;
  HalfInTheMaking x{{scene, formulation, rest, creep_without_stick(scene, formulation, tolerance)},
                    LawErrors::Constant(tolerance)};
  const LawPoint first = beginning(x.curve);
  LawPoint last = first;
  x.half.reason = go_to_full_slip(x.curve, tolerance / 3, last);
  x.half.unit_creep = last.at.value(Quantity::creep) - rest.creep;
  x.tolerance(1) *= scale_in(scene, last.at.value)(Quantity::max_temperature);
  if (scene.bulk_difference != 0) {
    x.tolerance(2) *= 300;
    const auto end = last.w == 1 ? end_before_full_slip(x, tolerance / 3) : std::nullopt;
    if (end) {
      last = *end;
      x.half.unit_creep = last.at.value(Quantity::creep) - rest.creep;
      x.half.reason = turns_back;
    }
  }
  const bool sticks = last.w > first.w;
  const std::string early = sticks ? add_pieces(x, last.grid, first.w, last.w, {}) : "";
  if (!early.empty()) x.half.reason = end_of_partial_slip(x.half, early);
  const bool to_its_end = early.empty() && last.w == 1;
  if (to_its_end || slips_on(x, tolerance / 3, last))
    x.half.reason = add_slipping_pieces(x, reach, tolerance / 3, last);
  end_after_pieces(x.half, reach);
  if (first.w > 0 && sticks) x.error += change_before(x, 106, first.w);
  return x;
}

struct BothHalves {
  HalfInTheMaking driving, braking;
};

BothHalves both_halves(Scene scene, Formulation formulation, double tolerance,
                       const CreepRange& range, const NoSlip& rest) {
  const auto half = [&](Direction direction, double reach) {
    scene.direction = direction;
    if (reach >= 0) return half_law(scene, formulation, tolerance, reach, rest);
    HalfInTheMaking none{{scene, formulation, {}, 0}, LawErrors::Zero()};
    none.half.reason = not_asked;
    return none;
  };
  const double driving = range.to - rest.creep;
  const double braking = range.from < rest.creep ? rest.creep - range.from : -1;
  if (strain_share(scene) == 0 && !is_unlike(scene) && scene.bulk_difference == 0) {
    const HalfInTheMaking one = half(Direction::driving, std::max(range.to, braking));
    return {one, one};
  }
  return {half(Direction::driving, driving), half(Direction::braking, braking)};
}

}  // namespace

CreepLaw creep_law(const Scene& scene, Formulation formulation, double tolerance,
                   const CreepRange& range) {
  check(scene);
  if (!(range.from < range.to))
    require(false, "from", range.from, "below to = " + shortest(range.to));
  require(1e-7 <= tolerance && tolerance <= 1e-2, "tolerance", tolerance, "from 1e-7 to 1e-2");
  const NoSlip rest = no_slip(scene, tolerance / 10);
  const auto [driving, braking] = both_halves(scene, formulation, tolerance, range, rest);
  const LawErrors error = driving.error.max(braking.error);
  const double coldest = std::min(0.0, scene.bulk_difference);
  const double traction_error = error(0) + rest.traction_error;
  if (!std::isfinite(traction_error + error.sum() + rest.traction + rest.creep))
    throw NotResolved("law: its numbers are not finite, at an extreme speed", {});
  return {driving.half, braking.half, traction_error, error(2),
          error(1),     rest.creep,   rest.traction,  coldest};
}

LawSide side_of(const CreepLaw& law, double creep) {
  const double more = creep - law.no_slip_creep;
  return {more < 0 ? law.braking : law.driving, more < 0 ? -1.0 : 1.0, std::abs(more)};
}

std::optional<LawValue> evaluate(const CreepLaw& law, double creep) {
  const auto& [half, sign, size] = side_of(law, creep);
  const double unit = half.unit_creep;
  if (!std::isfinite(creep) || !(size <= half.last_creep)) return std::nullopt;
  const double z = size <= unit ? std::sqrt(size / unit) : 2 - unit / size;
  std::size_t k = 0;
  while (k + 1 < half.pieces.size() && z > half.pieces[k].to) ++k;
  const LawPiece& piece = half.pieces[k];
  const double per_z = 2 / (piece.to - piece.from);
  const double x = std::clamp(per_z * (z - piece.from) - 1, -1.0, 1.0);
  const SeriesValue q = clenshaw(piece.traction, x);
  const double rise = std::max(law.coldest, clenshaw(piece.temperature, x).value);
  if (slips_partially(piece)) {
    const double slip_length = z * z * clenshaw(piece.slip_length, x).value;
    const double bend = z < piece.from ? 0 : z * per_z * q.slope / 2;
    return LawValue{law.no_slip_traction + sign * size * q.value, q.value + bend, rise,
                    std::max(1 - slip_length, -1.0)};
  }
  return LawValue{sign * q.value, unit / size / size * per_z * q.slope, rise * size / unit, -1};
}

double border_error_at(const CreepLaw& law, double creep) {
  const LawSide side = side_of(law, creep);
  const double slow = law.no_slip_creep != 0 ? 0.05 : 0;  // a bulk difference
  const bool slips = side.size > (1 + slow + law.border_error) * side.half.unit_creep;
  return slips ? 0 : law.border_error;
}

LawUnits law_units(const PhysicalScene& si, double friction) {
  const Units unit = units_of(si, friction);
  return {unit.slip / si.speed, si.load, unit.temperature, si.speed, si.bulk_temperature};
}

}  // namespace thermoroll
