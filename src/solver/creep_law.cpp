// Tangled from paper/22-creep-curve.md; edit there.
#include "thermoroll/creep_law.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <tuple>

#include <Eigen/Core>
#include <Eigen/LU>

#include "solver/conduction.hpp"
#include "solver/full_slip.hpp"
#include "solver/gauss_legendre.hpp"
#include "solver/grid_solution.hpp"
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

/// A scene in its direction, and the creep at which its stick zone vanishes.
struct HalfCurve {
  Scene scene;
  Formulation formulation;
  double all_slips;
};

/// The solution's largest T*. With strong heat there may be two maxima, the hotter one at the
/// trailing edge.
double hottest(const HalfCurve& curve, const GridSolution& x) {
  if (x.crossing) return x.value(Quantity::max_temperature);  // which has searched there too
  const HottestPoint trailing =
      find_hottest(x.at.slip, Conduction(curve.scene), x.h, {0.98, 0, -3}, gauss_legendre(40));
  return std::max(x.value(Quantity::max_temperature), heat_share(curve.scene) * trailing.value);
}

/// The solution at w of @eq:law-sampling on a grid of n unknowns, from one near by or from none.
GridSolution solution_at(const HalfCurve& curve, int n, double w, GridSolution near) {
  const double full_slip_creep = curve.all_slips / std::max(2 - w, 1e-8);
  const auto from = [&](const GridSolution& start) {
    const ZoneLengths at{2 * w * w, 2 - 2 * w * w};
    return w < 1 ? solve_on_grid(curve.scene, curve.formulation, n, at, start)
                 : solve_slipping_grid(curve.scene, curve.formulation, n, full_slip_creep, start);
  };
  if (near.h.size() > n) near.h.conservativeResize(n);
  GridSolution x = from(near);
  if (x.newton_steps == 0) x = from({});
  forget_the_edge(x, 0.005);
  if (x.newton_steps > 0) x.value(Quantity::max_temperature) = hottest(curve, x);
  return x;
}

/// A number of unknowns, and that of the grid it is compared with.
struct LawGrid {
  int n, finer;
};

using LawGrids = std::vector<LawGrid>;

const LawGrids& law_grids(const Scene& scene) {
  static const LawGrids cold{{20, 40}, {40, 80}, {64, 128}}, hot{{20, 33}, {40, 66}, {64, 106}};
  return scene.law ? hot : cold;
}

bool agree(const GridSolution& x, const GridSolution& y, double tolerance) {
  if (x.newton_steps == 0 || y.newton_steps == 0) return false;
  const Results change = (x.value - y.value).abs() / scale_of(y.value);
  return std::max({change(Quantity::traction), change(Quantity::creep),
                   change(Quantity::max_temperature)}) < tolerance;
}

double leeway(int n, double w) { return n == 64 && w < 1.5 ? 10 : 1; }

constexpr const char* not_resolved = "the solution is not resolved";
constexpr const char* not_asked = "no more was asked for";

/// Why the curve does not go on to w; empty if it does. In that case near becomes the solution.
std::string why_not(const HalfCurve& curve, double tolerance, double w, GridSolution& near) {
  for (const auto& [n, finer] : law_grids(curve.scene)) {
    if (w == 2 && n > 20) break;  // at infinite creep finer grids do not help
    const GridSolution x = solution_at(curve, n, w, near), y = solution_at(curve, finer, w, x);
    if (!agree(x, y, leeway(n, w) * tolerance)) continue;
    if (!y.violations.empty()) return "contact is lost: " + y.violations.front().what;
    if (x.value(Quantity::creep) <= near.value(Quantity::creep)) return "the creep turns back";
    near = x;
    return "";
  }
  return not_resolved;
}

/// The last w that has a contact, and the reason for the end; 2 and nothing if all have one.
struct CurveEnd {
  double w;
  std::string reason;
};

CurveEnd end_of(const HalfCurve& curve, double tolerance, double reach) {
  const double farthest = reach > curve.all_slips ? 2 - curve.all_slips / reach : 1;
  GridSolution near;
  double last = 0;
  for (const double next : {0.1, 0.4, 0.7, 0.9, 1.0, 1.3, 1.7, 1.9, 1.97, 1.99, 1.999, 2.0}) {
    double w = std::min(next, farthest);
    std::string reason = why_not(curve, tolerance, w, near);
    if (w == 2 && reason == not_resolved) return {last, reason};
    for (int k = 0; !reason.empty() && k < (reason == not_resolved ? 3 : 14); ++k) {
      const double middle = (last + w) / 2;
      const std::string there = why_not(curve, tolerance, middle, near);
      (there.empty() ? last : w) = middle;
      if (!there.empty()) reason = there;
    }
    if (!reason.empty()) return {last, reason};
    last = w;
    if (w == farthest) break;
  }
  return {last, last < 2 ? not_asked : ""};
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
  const double unit = x.half.unit_creep, creep = at.value(Quantity::creep);
  if (w == 0) {
    const Scene& scene = x.curve.scene;
    const double cold = scene.friction * (scene.law ? scene.law(0).value : 1);
    return {0, 0, {pi, 0, pi * unit / cold}};
  }
  const double q = at.value(Quantity::traction), t = at.value(Quantity::max_temperature);
  if (!sticks) return {creep, w, {q, t * unit / creep, 2}};
  const double slip_length = at.value(Quantity::slip_length);
  return {creep, std::sqrt(creep / unit), {q / creep, t, slip_length * unit / creep}};
}

constexpr int law_terms = static_cast<int>(std::tuple_size_v<LawSeries>);

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
  const Eigen::Matrix<double, law_terms, 3> c = terms.partialPivLu().solve(values);
  std::copy_n(c.col(0).data(), law_terms, piece.traction.begin());
  std::copy_n(c.col(1).data(), law_terms, piece.temperature.begin());
  std::copy_n(c.col(2).data(), law_terms, piece.slip_length.begin());
  return piece;
}

LawErrors errors_of(const LawErrors& difference, bool sticks, const Stored& at) {
  return 3 * difference.abs() * LawErrors(sticks ? at.creep : 1, 1, at.z * at.z);
}

LawErrors missed(const LawPiece& piece, const Stored& at) {
  const double x = 2 * (at.z - piece.from) / (piece.to - piece.from) - 1;
  const LawErrors value(clenshaw(piece.traction, x).value, clenshaw(piece.temperature, x).value,
                        clenshaw(piece.slip_length, x).value);
  return errors_of(value - at.value, slips_partially(piece), at);
}

/// The node k of a piece, or a point between two nodes; the ends are met to the last bit.
double law_node(double from, double to, double k) {
  if (k == law_terms - 1) return to;
  return from + (to - from) * (1 - std::cos(pi * k / (law_terms - 1))) / 2;
}

struct Trial {
  LawPiece piece;
  LawErrors error, of_grid;
};

Trial try_piece(const HalfInTheMaking& x, const LawGrid& grid, double from, double to,
                GridSolution near) {
  const auto [n, finer] = grid;
  bool solved = true;
  const auto at = [&](int unknowns, double k) {
    const double w = law_node(from, to, k);
    if (w > 0) {
      const GridSolution there = solution_at(x.curve, unknowns, w, near);
      if (there.newton_steps > 0) near = there;
      solved = solved && there.newton_steps > 0;
    }
    return stored(x, to <= 1, w, near);
  };
  std::array<Stored, law_terms> y;
  for (std::size_t k = 0; k < y.size(); ++k) y[k] = at(n, static_cast<double>(k));
  Trial trial{fitted(y), 0.2 * x.tolerance, LawErrors::Zero()};
  for (const double k : {7.5, 5.5, 2.5, 0.5}) {
    const Stored fine = at(finer, k);
    trial.error = trial.error.max(missed(trial.piece, fine));
    if ((trial.error <= x.tolerance).all()) continue;
    const LawErrors moved = errors_of(at(n, k).value - fine.value, to <= 1, fine);
    trial.of_grid = trial.of_grid.max(moved);
  }
  if (!solved) trial.error = trial.of_grid = LawErrors::Constant(1);
  return trial;
}

bool is_too_coarse(const Trial& trial, const LawErrors& tolerance) {
  const Eigen::Array<bool, 3, 1> misses = trial.error > tolerance;
  const Eigen::Array<bool, 3, 1> by_grid = trial.of_grid > 0.3 * trial.error;
  return misses.any() && (!misses || by_grid).all();
}

/// Add the pieces from w = from to w = to, on this grid or finer ones; false where they end early.
bool add_pieces(HalfInTheMaking& x, const LawGrid* grid, double from, double to,
                const GridSolution& near) {
  Trial trial = try_piece(x, *grid, from, to, near);
  while (is_too_coarse(trial, x.tolerance) && grid != &law_grids(x.curve.scene).back())
    trial = try_piece(x, *++grid, from, to, near);
  const bool coarse = is_too_coarse(trial, x.tolerance);
  if ((trial.error <= (coarse ? leeway(grid->n, from) : 1) * x.tolerance).all()) {
    x.half.pieces.push_back(trial.piece);
    x.error = x.error.max(trial.error);
    return true;
  }
  const double least = coarse ? 0.03 : 3e-4;
  if (to - from < least * (2 - from)) return false;
  const double middle = (from + to) / 2;
  return add_pieces(x, grid, from, middle, near) && add_pieces(x, grid, middle, to, near);
}

HalfInTheMaking half_law(const Scene& scene, Formulation formulation, double tolerance,
                         double reach) {
  const GridSolution corner = next_to_full_slip(scene, formulation, 32);
  HalfInTheMaking x{{scene, formulation, corner.value(Quantity::creep)},
                    LawErrors::Constant(tolerance)};
  const CurveEnd end = end_of(x.curve, tolerance / 3, reach);
  const double full = std::min(end.w, 1.0);
  const GridSolution unit = solution_at(x.curve, 32, full, {});
  x.half.unit_creep = unit.value(Quantity::creep);
  x.tolerance(1) *= unit.value(Quantity::max_temperature);
  x.half.reason = end.reason;
  const LawGrid* grid = law_grids(scene).data();
  const bool whole =
      add_pieces(x, grid, 0, full, {}) && (end.w <= 1 || add_pieces(x, grid, 1, end.w, unit));
  if (!whole) x.half.reason = not_resolved;
  if (x.half.pieces.empty())
    throw NotResolved("law: not resolved to " + shortest(tolerance) + " anywhere", {});
  const double z = x.half.pieces.back().to;
  const double share = slips_partially(x.half.pieces.back()) ? std::min(z * z, 1.0) : 1 / (2 - z);
  x.half.last_creep = z < 2 ? x.half.unit_creep * share : std::numeric_limits<double>::infinity();
  if (x.half.reason == not_asked) x.half.last_creep = std::max(x.half.last_creep, reach);
  return x;
}

}  // namespace

CreepLaw creep_law(const Scene& scene, Formulation formulation, double tolerance, double reach) {
  check(scene);
  if (!(reach > 0)) require(false, "reach", reach, "positive");
  if (scene.bulk_difference != 0)
    throw std::invalid_argument("a law is not made for bodies of different bulk temperatures");
  require(1e-7 <= tolerance && tolerance <= 1e-2, "tolerance", tolerance, "from 1e-7 to 1e-2");
  Scene one = scene;
  one.direction = Direction::driving;
  const HalfInTheMaking driving = half_law(one, formulation, tolerance, reach);
  one.direction = Direction::braking;
  const bool mirrors = strain_share(one) == 0 && !is_unlike(one);
  const HalfInTheMaking braking = mirrors ? driving : half_law(one, formulation, tolerance, reach);
  const LawErrors error = driving.error.max(braking.error);
  return {driving.half, braking.half, error(0), error(2), error(1)};
}

std::optional<LawValue> evaluate(const CreepLaw& law, double creep) {
  const LawHalf& half = creep < 0 ? law.braking : law.driving;
  const double size = std::abs(creep), sign = creep < 0 ? -1 : 1, unit = half.unit_creep;
  if (!(size <= half.last_creep)) return std::nullopt;
  const double z = size <= unit ? std::sqrt(size / unit) : 2 - unit / size;
  std::size_t k = 0;
  while (k + 1 < half.pieces.size() && z > half.pieces[k].to) ++k;
  const LawPiece& piece = half.pieces[k];
  const double per_z = 2 / (piece.to - piece.from);
  const double x = std::clamp(per_z * (z - piece.from) - 1, -1.0, 1.0);
  const SeriesValue q = clenshaw(piece.traction, x);
  const double rise = std::max(0.0, clenshaw(piece.temperature, x).value);
  if (slips_partially(piece)) {
    const double slip_length = z * z * clenshaw(piece.slip_length, x).value;
    return LawValue{sign * size * q.value, q.value + z * per_z * q.slope / 2, rise,
                    1 - slip_length};
  }
  return LawValue{sign * q.value, unit / (size * size) * per_z * q.slope, rise * size / unit, -1};
}

LawUnits law_units(const PhysicalScene& si, double friction) {
  const Units unit = units_of(si, friction);
  return {unit.slip / si.speed, si.load, unit.temperature, si.speed, si.bulk_temperature};
}

}  // namespace thermoroll
