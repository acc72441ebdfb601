// Tangled from paper/21-hot-friction.md; edit there.
#include "solver/branch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "solver/exchange.hpp"
#include "solver/full_slip.hpp"
#include "solver/grid_solution.hpp"
#include "solver/linear_system.hpp"
#include "support/number_text.hpp"

namespace thermoroll {

using Eigen::Index;
using Eigen::MatrixXd;
using enum Quantity;

namespace {

/// The traction-creep curve on grids of n unknowns, by the parameter of @eq:curve-parameter.
struct CreepCurve {
  Scene scene;
  Formulation formulation;
  int n;
  double all_slips = 0;  // xi1*, 0 as long as it is not known
  SlippingGrids slipping{scene, formulation};
};

GridSolution solution_on(CreepCurve& curve, double rho, const GridSolution& from) {
  const auto& [scene, formulation, n, known, unused] = curve;
  const SlipVariable by = about_kinks(from, n);
  if (rho < 1)
    return solve_on_grid(scene, formulation, n, {2 * rho * rho, 2 - 2 * rho * rho, by}, from);
  if (known == 0) {
    GridSolution end = next_to_full_slip(scene, formulation, n);
    curve.all_slips = end.value(Quantity::creep);
    if (rho == 1) return end;
  }
  const bool slips = from.at.slip == 2;
  const GridSolution start = slips ? from : GridSolution{};
  return solve_slipping_grid(curve.slipping, n, known / (2 - rho), start, by);
}

struct OnCurve {
  double rho;
  GridSolution solution;
  double traction() const { return solution.value(Quantity::traction); }
};

using Points = std::vector<OnCurve>;

/// By more than rounding.
bool is_lower(const OnCurve& a, const OnCurve& b) {
  return a.traction() < b.traction() - 1e-9 * std::abs(b.traction());
}

struct CurveSamples {
  CreepCurve curve;
  Points points{};    // by rho
  bool whole = true;  // all points were admissible
};

/// Put the solution at rho before the point of this index.
bool add(CurveSamples& x, std::size_t index, double rho, const GridSolution& from) {
  const OnCurve now{rho, solution_on(x.curve, rho, from)};
  const bool turned = should_stick_at_edge(x.curve.scene, now.solution);
  const bool solved = now.solution.newton_steps > 0 && !turned;
  x.whole = x.whole && solved && now.solution.violations.empty();
  if (solved) x.points.insert(x.points.begin() + static_cast<std::ptrdiff_t>(index), now);
  return solved;
}

GridSolution continued(const Points& points, double rho) {
  if (points.empty()) return {};
  GridSolution start = points.back().solution;
  if (points.size() == 1 || rho >= 1) return start;
  const OnCurve &a = points[points.size() - 2], &b = points.back();
  start.h += (rho - b.rho) / (b.rho - a.rho) * (b.solution.h - a.solution.h);
  return start;
}

/// Put samples behind the last one before a place without a solution.
void approach_end(CurveSamples& x, double asked, double place) {
  const auto before = [&](const OnCurve& a) { return a.rho < place; };
  auto size = static_cast<std::size_t>(std::count_if(x.points.begin(), x.points.end(), before));
  if (size == 0) return;
  double step = (place - x.points[size - 1].rho) / 2;
  for (int k = 0; k < 16 && x.points[size - 1].traction() <= 1.001 * asked; ++k) {
    const double rho = x.points[size - 1].rho + step;
    if (rho >= (size < x.points.size() ? x.points[size].rho : place < 1 ? 1 : 2)) break;
    const bool solved = add(x, size, rho, x.points[size - 1].solution);
    if (solved) ++size;
    if (!solved) step /= 2;
  }
}

/// Solve on finer grids until two agree; last is the sample before it. The curve then has the
/// coarser of both. False if no two agree, or if it is no contact.
bool resolve(CreepCurve& curve, OnCurve& at, const OnCurve& last) {
  const int before = curve.n;
  std::optional<double> coarse;
  for (int n = before; n <= most_unknowns; n *= 2) {
    curve.n = n;
    at.solution = solution_on(curve, at.rho, last.solution);
    const double fall = last.traction() - at.traction();
    const double by_creep = fall / std::log((2 - last.rho) / (2 - at.rho));
    const bool solved = at.solution.newton_steps > 0;
    if (solved && coarse && std::abs(at.traction() - *coarse) < 0.01 * by_creep) {
      curve.n = n / 2;
      forget_the_edge(at.solution, 0.005, curve.scene.bulk_difference != 0);
      return at.solution.violations.empty();
    }
    coarse = solved ? std::optional(at.traction()) : std::nullopt;
  }
  curve.n = before;
  return false;
}

/// Leave out the last samples in full slip that are not resolved, and put others before them.
void approach_last_contact(CurveSamples& x, double asked) {
  Points& all = x.points;
  const OnCurve highest = *std::max_element(all.begin(), all.end(), is_lower);
  if (!is_lower(all.back(), highest)) return;
  for (bool ends = false; !ends && all.back().rho > 1 && is_lower(all.back(), highest);) {
    OnCurve last = all.back();
    all.pop_back();
    ends = resolve(x.curve, last, all.back());
    if (ends) all.push_back(last);
  }
  double part = 0.5;
  while (part < 0.97 && 2 - all.back().rho > 1.5e-3 && !(all.back().traction() < asked)) {
    const double left = part * (2 - all.back().rho);
    OnCurve next{2 - left, {}};
    const bool resolved = resolve(x.curve, next, all.back());
    if (resolved) all.push_back(next);
    if (!resolved) part = std::sqrt(part);
  }
}

/// Put samples between the last one, which has a stick zone, and full slip.
void approach_turn(CurveSamples& x) {
  if (x.points.empty()) return;
  const double left = 1 - x.points.back().rho;
  for (const double share : {0.5, 0.25, 0.12, 0.05, 0.02})
    add(x, x.points.size(), 1 - share * left, continued(x.points, 1 - share * left));
}

CurveSamples sample_curve(const CreepCurve& curve, double asked, Branch branch) {
  CurveSamples x{curve};
  const double more = beyond_no_slip(curve.scene, {traction, asked}).value;
  const double share = std::clamp(more / curve.scene.friction, 1e-6, 0.8);
  const double first = std::sqrt(share / (1 + std::sqrt(1 - share)));  // slip is 2 first^2
  const auto falls = [&](std::size_t i) { return is_lower(x.points[i], x.points[i - 1]); };
  double unsolved = 2;
  for (const double place :
       {0.0, 0.25, 0.5, 0.7, 0.85, 0.95, 1.0, 1.1, 1.3, 1.5, 1.7, 1.85, 1.95, 1.99, 1.999}) {
    const std::size_t size = x.points.size();
    const double rho = place < 1 ? first + (1 - first) * place : place;
    const bool solved = add(x, size, rho, continued(x.points, rho));
    if (!solved) unsolved = std::min(unsolved, rho);
    if (!solved && rho == 1 && curve.scene.bulk_difference != 0) approach_turn(x);
    if (!solved || size == 0) continue;
    if (falls(size) && (branch == Branch::rising || x.points.back().traction() < asked)) break;
  }
  double least = x.points.empty() ? first : x.points[0].rho;
  for (int k = 0; k < 12; ++k) {
    const bool begun = x.points.size() > 1;
    if (begun && x.points[0].traction() < asked && !falls(1)) break;
    least = 0.6 * std::min(least, 1.0);
    if (!add(x, 0, least, {}) && begun) break;
  }
  if (branch == Branch::rising && unsolved < 2) approach_end(x, asked, unsolved);
  return x;
}

bool just_misses(const CurveSamples& x, double asked) {
  double most = 0;
  for (const OnCurve& a : x.points) most = std::max(most, a.traction());
  return most <= 1.001 * asked && asked < 1.5 * most;
}

CurveSamples coarse_curve(const Scene& scene, Formulation formulation, double asked,
                          Branch branch) {
  CurveSamples x = sample_curve({scene, formulation, 12}, asked, branch);
  while (!x.whole && (x.curve.n < 48 || (x.curve.n == 48 && just_misses(x, asked))))
    x = sample_curve({scene, formulation, 2 * x.curve.n}, asked, branch);
  if (x.points.size() < 2)
    throw std::runtime_error("coupled: no traction-creep curve found" + without_friction(scene));
  return x;
}

/// Powers of (rho - middle) / reach, a row each, for all results.
struct LocalCurve {
  double middle, reach;
  MatrixXd powers;
};

/// The value, or a derivative by rho.
Results derivative(const LocalCurve& local, int order, double rho) {
  Results sum = Results::Zero();
  for (Index k = local.powers.rows() - 1; k >= order; --k) {
    double factor = 1;
    for (Index i = 0; i < order; ++i) factor *= static_cast<double>(k - i) / local.reach;
    sum = sum * ((rho - local.middle) / local.reach) +
          factor * local.powers.row(k).transpose().array();
  }
  return sum;
}

LocalCurve local_curve(Points points, double middle, bool sticks) {
  std::erase_if(points, [&](const OnCurve& x) { return sticks ? x.rho > 1 : x.rho < 1; });
  std::sort(points.begin(), points.end(), [&](const OnCurve& a, const OnCurve& b) {
    return std::abs(a.rho - middle) < std::abs(b.rho - middle);
  });
  const auto size = static_cast<Index>(std::min<std::size_t>(points.size(), 7));
  const double reach = std::abs(points[static_cast<std::size_t>(size - 1)].rho - middle);
  MatrixXd places = MatrixXd::Ones(size, size), values(size, Results().size());
  for (Index i = 0; i < size; ++i) {
    const OnCurve& at = points[static_cast<std::size_t>(i)];
    for (Index k = 1; k < size; ++k) places(i, k) = places(i, k - 1) * (at.rho - middle) / reach;
    values.row(i) = at.solution.value.matrix();
  }
  return {middle, reach, solve(places, values)};
}

/// The point from low to high where the traction, or its derivative by rho, passes the value.
double place_of(const LocalCurve& local, int order, double value, double low, double high) {
  const bool above = derivative(local, order, low)(traction) > value;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = (low + high) / 2;
    ((derivative(local, order, middle)(traction) > value) == above ? low : high) = middle;
  }
  return low;
}

/// The lower end if the traction falls there, the upper one if it rises there, else a maximum.
double top_of(const LocalCurve& local, double low, double high) {
  if (derivative(local, 1, low)(traction) <= 0) return low;
  if (derivative(local, 1, high)(traction) >= 0) return high;
  return place_of(local, 1, 0, low, high);
}

/// The curve about its maximum, the position of that, and whether a stick zone is left there.
struct Highest {
  LocalCurve local;
  double rho;
  bool sticks;
};

Results results_at(const Highest& x) { return derivative(x.local, 0, x.rho); }

/// None if the maximum is at an end, or at two samples.
std::optional<Highest> highest_of(CurveSamples& x) {
  for (int k = 0;; ++k) {
    const auto best = std::max_element(x.points.begin(), x.points.end(), is_lower);
    if (best == x.points.begin() || best + 1 == x.points.end()) return std::nullopt;
    if (k == 0 && !is_lower(*(best + 1), *best)) return std::nullopt;
    const double here = best->rho, low = (best - 1)->rho, high = (best + 1)->rho;
    Highest top{local_curve(x.points, here, here <= 1), here, here <= 1};
    if (here == 1 && derivative(top.local, 1, 1)(traction) > 1e-4)
      top = {local_curve(x.points, here, false), here, false};
    top.rho = top.sticks ? top_of(top.local, low, std::min(high, 1.0))
                         : top_of(top.local, std::max(low, 1.0), high);
    if (top.rho == low || top.rho == high) top.rho = here;  // they are lower
    const auto index = static_cast<std::size_t>(best - x.points.begin()) + (top.rho > here ? 1 : 0);
    const bool of_corner = k == 0 && here == 1 && std::abs(top.rho - 1) > 1e-4;
    if (k == 8 || (std::abs(top.rho - here) < 0.01 && !of_corner)) return top;
    if (!add(x, index, top.rho, best->solution)) return top;
  }
}

/// The coarse curve with the height and the slope of the finer one, by two points.
LocalCurve corrected(LocalCurve local, const OnCurve& left, const OnCurve& right) {
  const auto off = [&](const OnCurve& x) -> Results {
    return x.solution.value - derivative(local, 0, x.rho);
  };
  const Results less = off(left), slope = (off(right) - less) / (right.rho - left.rho);
  local.powers.row(0) += (less + slope * (local.middle - left.rho)).matrix();
  local.powers.row(1) += (slope * local.reach).matrix();
  return local;
}

/// Points of the curve about its maximum, two or seven; fewer if one has no solution. Next to full
/// slip they span the least distance from it.
Points around(CreepCurve& curve, const Highest& top, bool alone, double least, GridSolution near) {
  const double rho_1 = std::abs(top.rho - 1), ends = std::min(top.rho, 2 - top.rho);
  const double from_1 = std::max(rho_1, least), close = std::min(1.5e-4, from_1 / 50);
  const double reach = alone ? std::min({0.03, from_1 / 2, ends / 4}) : close;
  const double room = 1.125 * reach;
  const double middle = top.sticks ? std::min(top.rho, 1 - room) : std::max(top.rho, 1 + room);
  const int places = alone ? 7 : 2;
  Points points;
  for (int i = 0; i < places; ++i) {
    const double rho = middle + reach * (2.0 * i / (places - 1) - 1);
    near = solution_on(curve, rho, near);
    if (near.newton_steps == 0) break;
    points.push_back({rho, near});
  }
  return points;
}

double third_order(const Highest& top, const Points& two) {
  const double half = (two[1].rho - two[0].rho) / 2;
  const double curvature = derivative(top.local, 2, top.rho)(traction);
  if (!(curvature < 0)) return half;
  return half * half / 6 * std::abs(derivative(top.local, 3, top.rho)(traction) / curvature);
}

/// Of a maximum that has moved so far since the grid before; zero for seven points.
Results error_of_place(const Highest& top, const Points& points, double moved) {
  if (points.size() > 2) return Results::Zero();
  const double bend = 1e-2 * std::abs(moved) + third_order(top, points);
  return bend * derivative(top.local, 1, top.rho).abs();
}

const OnCurve& highest_point(const Points& points) {
  const auto lower = [](const OnCurve& a, const OnCurve& b) { return a.traction() < b.traction(); };
  return *std::max_element(points.begin(), points.end(), lower);
}

double spacing(const Points& points) {
  return (points.back().rho - points.front().rho) / static_cast<double>(points.size() - 1);
}

bool has_kinks(const OnCurve& x) { return !x.solution.kinks.empty(); }

/// Of all results at the maximum.
Results error_of_law(const Highest& top, const Points& points, const Results& scale) {
  Results of_kinks = error_of_kinks(points.back().solution) * scale;
  if (points.size() < 7 || std::none_of(points.begin(), points.end(), has_kinks)) return of_kinks;
  const Points five(points.begin() + 1, points.end() - 1);
  const LocalCurve local = local_curve(five, points[3].rho, top.sticks);
  const double room = spacing(points), low = std::max(top.rho - room, top.sticks ? 0 : 1.0),
               high = std::min(top.rho + room, top.sticks ? 1 : 2.0);
  const double rho = top_of(local, low, high);
  return of_kinks + (derivative(local, 0, rho) - results_at(top)).abs();
}

/// None finer if it is the same.
int finer_than(int n) {
  const int next = n < 40 ? unknowns_after(n, false) : 2 * n;
  if (next <= most_unknowns) return next;
  return 4 * n <= 3 * most_unknowns ? most_unknowns : n;
}

bool is_next_to_full_slip(const Highest& x) { return std::abs(x.rho - 1) < 1e-3; }

bool needs_more_points(const Highest& x) { return !x.sticks || is_next_to_full_slip(x); }

/// Move the maximum to that of these points; whether it is found there.
bool move_to(const Points& points, const LocalCurve& coarse, Highest& top) {
  const double before = top.rho;
  const bool alone = points.size() > 2;
  top.local =
      alone ? local_curve(points, before, top.sticks) : corrected(coarse, points[0], points[1]);
  const double place = alone ? highest_point(points).rho : before;
  const double room = alone ? spacing(points) : std::min(before, 2 - before) / 20;
  top.rho = top_of(top.local, std::max(place - room, top.sticks ? 0 : 1.0),
                   std::min(place + room, top.sticks ? 1 : 2.0));
  return std::abs(top.rho - place) < 0.999 * room && (alone || !is_next_to_full_slip(top));
}

bool is_flat(const Points& points) {
  const double height = highest_point(points).traction();
  return std::all_of(points.begin(), points.end(),
                     [&](const OnCurve& x) { return x.traction() > height * (1 - 1e-14); });
}

bool is_constant(const Scene& scene, double hottest) {
  const double coldest = std::min(0.0, scene.bulk_difference), range = hottest - coldest;
  for (int i = 0; i < 8; ++i)
    if (scene.law(coldest + range * i / 8).value != scene.law(hottest).value) return false;
  return true;
}

/// Whether the largest traction is that of a range.
bool is_range(CreepCurve& curve, const Highest& top, const Points& points) {
  if (!needs_more_points(top)) return false;
  const double rho = std::max(top.rho, 1.0);
  const Points two = around(curve, {top.local, rho, false}, false, 1e-3, points[0].solution);
  if (two.size() < 2) return false;
  const double hottest = two[1].solution.value(max_temperature);
  const bool flat = is_constant(curve.scene, hottest) || is_flat(two);
  return flat && two[0].traction() > results_at(top)(traction) * (1 - 1e-6);
}

bool has_turned_back(const CreepCurve& curve, const Points& points) {
  return std::any_of(points.begin(), points.end(), [&](const OnCurve& x) {
    return should_stick_at_edge(curve.scene, x.solution);
  });
}

void begin_full_slip(const CreepCurve& curve, Highest& top) {
  const GridSolution first = next_to_full_slip(curve.scene, curve.formulation, curve.n);
  if (first.newton_steps == 0) return;
  top.local.powers.row(0) += (first.value - results_at(top)).matrix();
}

/// The error by the other side of full slip: none if that is not higher, else the difference of the
/// results. If it is higher by more than rounding, the maximum and its points are moved there.
Results error_of_side(CreepCurve& curve, Highest& top, Points& points) {
  if (!is_next_to_full_slip(top)) return Results::Zero();
  if (top.rho == 1 && !top.sticks) begin_full_slip(curve, top);
  Highest other{top.local, 1, !top.sticks};
  const Points beside = around(curve, other, true, 0.02, points[0].solution);
  if (beside.size() < 7) return Results::Zero();
  move_to(beside, other.local, other);
  const GridSolution there = solution_on(curve, other.rho, highest_point(beside).solution);
  if (there.newton_steps == 0 || should_stick_at_edge(curve.scene, there)) return Results::Zero();
  const Results higher = there.value - results_at(top);
  const double share = higher(traction) / std::abs(results_at(top)(traction));
  if (share < (other.rho == 1 ? 1e-9 : 0)) return Results::Zero();
  if (share < 1e-12) return higher.abs();
  top = other;
  points = beside;
  return higher.abs() + (results_at(top) - there.value).abs();
}

Results error_of_corner(CreepCurve& curve, const Highest& top, const Points& points) {
  if (!is_next_to_full_slip(top)) return Results::Zero();
  const GridSolution near = highest_point(points).solution, all = solution_on(curve, 1, near);
  const GridSolution some = top.sticks ? near : solution_on(curve, 1 - 1.25e-3, near);
  const bool solved = all.newton_steps > 0 && some.newton_steps > 0;
  if (!solved || all.kinks.empty() == some.kinks.empty()) return Results::Zero();
  return (all.value - some.value).abs();
}

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr TractionLimit unknown{0, 0, infinite, infinite};

TractionLimit stated(const Results& at, const Results& error, const Results& least) {
  return {at(traction), at(creep), std::max(error(traction), least(traction)),
          std::max(error(creep), least(creep))};
}

double error_of_creep(const Results& now, const Results& error, const Results& scale) {
  const double of_height = scale(creep) * error(traction) / std::abs(now(traction));
  return std::max(error(creep), of_height);
}

double worst_of(const Results& error, const Results& scale, int n, bool kinked) {
  const bool flat = (kinked && n >= 90) || n == finer_than(n);
  return std::max(error(traction), flat ? 0 : error(creep) / scale(creep));
}

/// Move the maximum to that of these points, or of others about that, or back to the coarse one if
/// two points miss it; whether it is between them.
bool follow(CreepCurve& curve, const Highest& coarse, Highest& top, Points& points) {
  bool inside = move_to(points, coarse.local, top);
  for (int k = 0; k < 4 && !inside && points.size() == 7 && curve.n < 100; ++k) {
    const Points next = around(curve, top, true, 1e-3, highest_point(points).solution);
    if (next.size() < 7) break;
    points = next;
    inside = move_to(points, coarse.local, top);
  }
  if (!inside && points.size() == 2) top = coarse;
  return inside;
}

/// The part that holds with a law, for all results but that creep.
Results parts(const Highest& top, const Results& change_before, double part) {
  Results all = Results::Constant(part);
  if (needs_more_points(top) && (change_before == 0).all()) all(creep) = std::max(part, 2.0);
  return all;
}

/// None if a range of creeps has the largest traction, or the curve rises to where it turns back.
/// Errors may be above the tolerance on the finest grid, that of the creep thrice so at high speed,
/// and next to a corner of the curve; an unknown error is infinite.
std::optional<TractionLimit> traction_limit(CreepCurve& curve, double tolerance, Highest& top,
                                            GridSolution level) {
  Results last = results_at(top), change = Results::Zero();
  const Highest coarse = top;
  const bool exact = tolerance < 1e-7;
  bool alone = exact, inside = true;
  TractionLimit limit = unknown;
  for (int n = std::max(alone ? 24 : 18, finer_than(curve.n)); n > curve.n; n = finer_than(n)) {
    curve.n = n;
    alone = alone || n > 48 || !level.kinks.empty() || !inside || needs_more_points(top);
    Points points = around(curve, top, alone, 1e-3, level);
    if (points.size() < (alone ? 7 : 2)) continue;
    const double before = top.rho;
    inside = follow(curve, coarse, top, points);
    const bool range = is_range(curve, top, points);
    if ((range || has_turned_back(curve, points)) && n > 40) return std::nullopt;
    const Results of_side = error_of_side(curve, top, points);
    const Results now = results_at(top), change_before = change;
    change = (now - last).abs();
    const GridSolution& near = points[0].solution;
    const bool kinked = std::any_of(points.begin(), points.end(), has_kinks);
    const Results part = parts(top, change_before, kinked ? 2 : part_with_law(level.h, near.h));
    if (kinked || exact) change = change.max(change_before / 8);
    const Results of_place = error_of_place(top, points, top.rho - before);
    const Results scale = scale_in(curve.scene, now);
    Results error = part * change + of_place + of_side + error_of_law(top, points, scale);
    error(creep) = (exact || tail(near.h) > 1e-3 ? 2 : 1) * error_of_creep(now, error, scale);
    const bool resolved = n > 48 || (kinked ? alone : !decays_slowly(level.h, near.h));
    const bool known = resolved && inside && !range && error.isFinite().all();
    const double worst = worst_of(error, scale, n, kinked);
    if (!alone && curve.scene.peclet * near.at.slip > 4e3) error(creep) *= 3;
    error += error_of_corner(curve, top, points);
    limit = known ? stated(now, error, tolerance / 10 * scale) : unknown;
    if (known && worst < tolerance) break;
    last = now;
    alone = points.size() > 2;
    level = std::move(points[0].solution);
  }
  return limit;
}

/// The index of the second of two points about the traction on a branch; 0 if there are none.
std::size_t enclosing(const Points& points, Branch branch, double asked) {
  const auto top = std::max_element(points.begin(), points.end(), is_lower);
  const auto highest = static_cast<std::size_t>(top - points.begin());
  const bool rising = branch == Branch::rising;
  for (std::size_t i = rising ? 1 : highest + 1; i < (rising ? highest + 1 : points.size()); ++i)
    if ((points[i - 1].traction() < asked) != (points[i].traction() < asked)) return i;
  return 0;
}

/// A solution at about this traction, and the derivative of all results by the traction there.
struct Enclosed {
  GridSolution solution{};
  Results slope = Results::Constant(std::nan(""));
};

Enclosed about_the_traction(CurveSamples& x, Branch branch, double asked) {
  Enclosed found;
  double before = 0;
  for (int k = 0; k < 8; ++k) {
    const std::size_t i = enclosing(x.points, branch, asked);
    if (i == 0) break;
    const double low = x.points[i - 1].rho, high = x.points[i].rho;
    const LocalCurve local = local_curve(x.points, (low + high) / 2, high <= 1);
    const double rho = place_of(local, 0, asked, low, high);
    if (k > 0 && std::abs(rho - before) < 5e-3 * std::min(1.0, 2 - rho)) break;
    const std::size_t nearest = rho - low < high - rho ? i - 1 : i;
    const bool is_there = std::abs(x.points[nearest].rho - rho) < 1e-6;
    if (!is_there && !add(x, i, rho, x.points[nearest].solution)) break;
    const Results by_rho = derivative(local_curve(x.points, rho, high <= 1), 1, rho);
    found = {x.points[is_there ? nearest : i].solution, by_rho / by_rho(traction)};
    before = rho;
  }
  return found;
}

/// Slope is the derivative by the traction.
bool is_close(const GridSolution& level, const GridSolution& last, const Prescribed& given,
              const Results& slope, const std::optional<TractionLimit>& limit) {
  if (!limit) return true;
  const double gap = std::abs(limit->traction - given.value);
  const double moved = std::abs(level.value(creep) - last.value(creep));
  return std::abs(residual(level, given)) < 0.1 * gap &&
         moved < 0.03 * 2 * std::abs(slope(creep)) * gap;
}

/// Solve with n unknowns at the point that the derivative gives, until less than share of each
/// result is left to correct; slope, the derivative by the traction, is improved.
GridSolution settle(CreepCurve curve, const Prescribed& given, const GridSolution& from,
                    Results& slope, double share, const std::optional<TractionLimit>& limit) {
  auto& [scene, formulation, n, unused, slipping] = curve;
  GridSolution level = from;
  for (int k = 0; k < 8; ++k) {
    const GridSolution last = level;
    const Results step = slope * residual(last, given);
    const double most = last.at.stick == 0 ? 0 : 0.99 * last.at.slip;
    const double to_border = std::clamp(step(stick_slip_border), -0.99 * last.at.stick, most);
    ZoneLengths at = moved_by(last.at, to_border);
    at.variable = variable_after(last, n);
    const double next = last.value(creep) + step(creep);
    level = last.at.stick == 0 ? solve_slipping_grid(slipping, n, next, last, at.variable)
                               : solve_on_grid(scene, formulation, n, at, last);
    if (level.newton_steps == 0) break;
    const double moved = level.value(traction) - last.value(traction);
    if (k > 0 && std::abs(moved) > 1e-12) slope = (level.value - last.value) / moved;
    const Results carried = slope * residual(level, given) / scale_in(scene, level.value);
    const double off = last.at.slip < 0.1 ? 1 : 0.02;
    const bool coarse = k == 0 && last.at.stick == 0;
    const bool close = is_close(level, last, given, slope, limit);
    if (close && !coarse && off * carried.head(compared).abs().maxCoeff() < share) break;
  }
  return level;
}

/// None unless the traction is within a ten-thousandth of the maximum, and that is no corner.
Enclosed next_to_maximum(CreepCurve curve, const Highest& top, Branch branch, double asked,
                         const GridSolution& near) {
  constexpr double reach = 0.05;
  const bool inside = std::abs(top.rho - 1) > reach && std::min(top.rho, 2 - top.rho) > reach;
  if (!inside || asked < (1 - 1e-4) * results_at(top)(traction)) return {};
  const double end = top.rho + (branch == Branch::rising ? -reach : reach);
  const double rho = place_of(top.local, 0, asked, end, top.rho);
  const Results by_rho = derivative(top.local, 1, rho);
  curve.n = std::min(curve.n, 2 * most_unknowns / 3);  // the next one has half as many more
  return {solution_on(curve, rho, near), by_rho / by_rho(traction)};
}

/// Whether a solution has less creep than full slip, and the maximum has a stick zone.
bool is_short_of_full_slip(const Highest& top, const CoupledSolution& x) {
  return top.sticks && top.rho < 1 && x.value(stick_slip_border) == -1 && !x.violations.empty();
}

Enclosed before_full_slip(CreepCurve& curve, const Highest& top) {
  const double rho = (top.rho + 1) / 2;
  const Results by_rho = derivative(top.local, 1, rho);
  return {solution_on(curve, rho, {}), by_rho / by_rho(traction)};
}

bool is_told_from(const TractionLimit& limit, const CoupledSolution& x, Branch branch,
                  double tolerance) {
  const double side = branch == Branch::rising ? -1 : 1, by = x.value(creep) - limit.creep;
  const double of_limit = std::min(limit.creep_error, tolerance * std::abs(limit.creep));
  const double apart = std::abs(x.value(traction) - limit.traction);
  const bool rounded = apart < 5e-13 * std::abs(limit.traction);
  return !rounded && side * by > 10 * x.error(creep) + of_limit;
}

CoupledSolution solve_closer(const Scene& scene, const Approach& approach, double asked,
                             Branch branch) {
  const std::string near = "coupled: too near to the largest traction to be resolved to ";
  const auto too_near = [&] { return NotResolved(near + shortest(approach.tolerance), {}); };
  if (approach.tolerance < 1e-10) throw too_near();
  const Approach closer{approach.formulation, std::max(1e-11, approach.tolerance / 100)};
  try {
    return solve_on_branch(scene, closer, asked, branch);
  } catch (const NotResolved&) {
    throw too_near();
  }
}

bool is_unknown_far_above(const TractionLimit& limit, const OnCurve& highest, double asked) {
  return !(limit.traction_error < 0.1 * highest.traction()) && asked < 0.9 * highest.traction();
}

void refuse_near(const TractionLimit& limit, double asked, double tolerance) {
  const double error = limit.traction_error, apart = std::abs(asked - limit.traction);
  if (error <= tolerance || apart > 2 * error) return;
  const std::string to = shortest(tolerance) + at_best(error);
  throw NotResolved("coupled: the largest traction is not resolved to " + to, {});
}

/// Both ends are rounded inward.
std::string range_text(double a, double b) {
  return "between " + rounded_up(std::min(a, b), 6) + " and " + rounded_down(std::max(a, b), 6);
}

[[noreturn]] void refuse_above(const TractionLimit& limit, double asked, double sign) {
  const TractionLimit largest{sign * limit.traction, sign * limit.creep, limit.traction_error,
                              limit.creep_error};
  const double most = below(largest);
  const std::string bound =
      sign > 0 ? "at most " + rounded_down(most, 6) : "at least " + rounded_up(most, 6);
  throw BeyondLimit("traction = " + shortest(sign * asked) + " is not allowed: it must be " +
                        bound + ", the largest" +
                        (largest.has_creep() ? ", at the creep " + fixed(largest.creep, 6) : ""),
                    largest);
}

void refuse_beyond(const CurveSamples& x, const std::optional<TractionLimit>& limit, Branch branch,
                   double asked) {
  const double sign = sign_of(x.curve.scene.direction);
  const auto highest = std::max_element(x.points.begin(), x.points.end(), is_lower);
  const OnCurve& last = x.points.back();
  const double top = highest->traction(), end = last.traction();
  const double margin = std::min(1e-3 * std::abs(top), 0.25 * (top - end));
  const double under = branch == Branch::falling ? top - margin : 0.999 * top;
  const double most = sign * (limit ? below(*limit) : under);
  const auto range = [&] { return range_text(no_slip(x.curve.scene).traction, most); };
  if (branch == Branch::falling && !is_lower(last, *highest))
    throw std::invalid_argument(
        "branch = falling does not exist: the traction has no maximum; it is " + range());
  if (limit && asked > limit->traction) refuse_above(*limit, asked, sign);
  const auto is_highest = [&](const OnCurve& at) { return !is_lower(at, *highest); };
  const bool flat = std::count_if(x.points.begin(), x.points.end(), is_highest) > 1;
  const char* why = flat ? "; all slips at the largest, and the creep is not determined" : "";
  if (!limit && !(asked < top)) require(false, "traction", sign * asked, range() + why);
  if (branch == Branch::rising || asked > end) return;
  if (!(end + margin < sign * most))
    throw NotResolved("coupled: the falling branch is within the error of the largest traction",
                      {});
  const std::string followed = " on the falling branch, as far as it is followed";
  require(false, "traction", sign * asked, range_text(sign * (end + margin), most) + followed);
}

}  // namespace

CoupledSolution solve_on_branch(const Scene& scene, const Approach& approach, double asked,
                                Branch branch) {
  const Formulation formulation = approach.formulation;
  CurveSamples x = coarse_curve(scene, formulation, asked, branch);
  std::optional<Highest> top = highest_of(x);
  const OnCurve highest = *std::max_element(x.points.begin(), x.points.end(), is_lower);
  std::optional<TractionLimit> limit;
  CreepCurve fine = x.curve;
  if (top) limit = traction_limit(fine, approach.tolerance, *top, highest.solution);
  if (limit && is_unknown_far_above(*limit, highest, asked)) limit.reset();
  if (limit) refuse_near(*limit, asked, approach.tolerance);
  if (branch == Branch::falling) approach_last_contact(x, asked);
  refuse_beyond(x, limit, branch, asked);
  Enclosed start;
  if (limit) start = next_to_maximum(fine, *top, branch, asked, highest.solution);
  const bool near = start.solution.newton_steps > 0;
  const double most = highest.traction();
  if (!near) start = about_the_traction(x, branch, asked < most ? asked : most * (1 - 1e-6));
  const Prescribed given{traction, asked};
  const auto refined = [&] {
    return refine(scene, approach, given, start.solution, start.slope,
                  [&](int n, const GridSolution& last) {
                    const double left = approach.tolerance / (near ? 1e4 : 10);
                    return settle({scene, formulation, n}, given, last, start.slope, left, limit);
                  });
  };
  CoupledSolution found = refined();
  if (top && is_short_of_full_slip(*top, found)) {
    start = before_full_slip(fine, *top);
    found = refined();
  }
  if (limit && !is_told_from(*limit, found, branch, approach.tolerance))
    return solve_closer(scene, approach, asked, branch);
  found.limit = limit;
  found.branch = branch;
  return found;
}

double below(const TractionLimit& limit) {
  const double size = std::abs(limit.traction);
  const double less = size - std::min(size, std::max(2 * limit.traction_error, 1e-7 * size));
  return std::copysign(less, limit.traction);
}

}  // namespace thermoroll
