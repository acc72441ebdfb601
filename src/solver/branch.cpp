// Tangled from paper/21-hot-friction.md; edit there.
#include "solver/branch.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <vector>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>

#include "solver/graded_rule.hpp"
#include "solver/grid_solution.hpp"
#include "support/number_text.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::VectorXd;
using enum Quantity;

namespace {

/// The traction-creep curve on grids of n unknowns, by the parameter of @eq:curve-parameter.
class CreepCurve {
 public:
  CreepCurve(const Scene& scene, Formulation formulation, int n)
      : scene_(scene), formulation_(formulation), n_(n) {
    all_slips_ = next_to_full_slip(scene, formulation, n).value(Quantity::creep);
  }
  GridSolution at(double rho, const GridSolution& from) const {
    if (rho < 1) return solve_on_grid(scene_, formulation_, n_, {2 * rho, 2 - 2 * rho}, from);
    return solve_slipping_grid(scene_, formulation_, n_, all_slips_ / (2 - rho), from);
  }

 private:
  Scene scene_;
  Formulation formulation_;
  int n_;
  double all_slips_;
};

struct OnCurve {
  double rho;
  GridSolution solution;
  double traction() const { return solution.value(Quantity::traction); }
};

std::vector<OnCurve> walk(const CreepCurve& curve, double friction, double asked) {
  std::vector<OnCurve> points;
  const double little = std::min(0.003, 0.1 * asked / friction);  // a fifth of Carter's
  for (double rho : {little, 0.03, 0.1, 0.2, 0.3, 0.4, 0.5,  0.6,  0.7,  0.8,  0.9,
                     0.97,   1.0,  1.1, 1.3, 1.5, 1.7, 1.85, 1.95, 1.99, 1.999}) {
    const bool starts = points.empty() || rho == 1;
    const OnCurve now{rho, curve.at(rho, starts ? GridSolution{} : points.back().solution)};
    if (now.solution.newton_steps == 0) continue;
    const bool falls = !points.empty() && now.traction() < points.back().traction();
    points.push_back(now);
    if (falls && rho > 1 && now.traction() < asked) break;
  }
  return points;
}

struct Search {
  const CreepCurve& curve;
  GridSolution last;
};

double less_traction(double rho, void* search) {
  auto& s = *static_cast<Search*>(search);
  s.last = s.curve.at(rho, s.last);
  return -s.last.value(Quantity::traction);
}

/// Put the highest point between its neighbours; its index.
std::size_t add_highest(const CreepCurve& curve, std::vector<OnCurve>& points) {
  const auto higher = [](const OnCurve& a, const OnCurve& b) {
    return a.traction() < b.traction();
  };
  const auto best = std::max_element(points.begin(), points.end(), higher);
  const auto index = static_cast<std::size_t>(best - points.begin());
  if (best == points.begin() || best + 1 == points.end()) return index;
  Search search{curve, best->solution};
  gsl_function f{less_traction, &search};
  double rho = best->rho;
  gsl_min_fminimizer* brent = gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent);
  if (brent == nullptr) throw std::bad_alloc();
  gsl_min_fminimizer_set_with_values(brent, &f, rho, -best->traction(), (best - 1)->rho,
                                     -(best - 1)->traction(), (best + 1)->rho,
                                     -(best + 1)->traction());
  for (int k = 0; k < 30; ++k) {
    if (gsl_min_fminimizer_iterate(brent) != GSL_SUCCESS) break;
    rho = gsl_min_fminimizer_x_minimum(brent);
    if (gsl_min_fminimizer_x_upper(brent) - gsl_min_fminimizer_x_lower(brent) < 1e-3) break;
  }
  gsl_min_fminimizer_free(brent);
  const OnCurve highest{rho, curve.at(rho, best->solution)};
  if (highest.traction() <= best->traction()) return index;
  const bool before = rho < best->rho;
  points.insert(before ? best : best + 1, highest);
  return before ? index : index + 1;
}

struct Extremum {
  double traction, creep;
};

Extremum extremum(const CreepCurve& curve, double rho, GridSolution near) {
  const double room = std::min({rho, std::abs(1 - rho), 2 - rho}), reach = std::min(0.05, room / 2);
  if (room < 1e-3) {  // where the stick zone vanishes
    const GridSolution corner = curve.at(1, {});
    return {corner.value(Quantity::traction), corner.value(Quantity::creep)};
  }
  const GaussLegendre& rule = gauss_legendre(5);
  VectorXd traction(5), creep(5);
  for (Index i = 0; i < 5; ++i) {
    near = curve.at(rho + reach * rule.x(i), near);
    traction(i) = near.value(Quantity::traction);
    creep(i) = near.value(Quantity::creep);
  }
  const VectorXd q = to_legendre(rule) * traction, xi = to_legendre(rule) * creep;
  const VectorXd slope = derivative(q), bend = derivative(slope);
  const auto value = [](const VectorXd& c, double x) {
    return (legendre(ArrayXd::Constant(1, x), c.size()) * c)(0);
  };
  double x = 0;
  for (int k = 0; k < 20; ++k) x = std::clamp(x - value(slope, x) / value(bend, x), -1.0, 1.0);
  return {value(q, x), value(xi, x)};
}

TractionLimit traction_limit(const Scene& scene, Formulation formulation, double tolerance,
                             const OnCurve& near) {
  Extremum last{0, 0};
  for (int n = 20; n <= most_unknowns; n *= 2) {
    GridSolution start;
    if (near.solution.h.size() <= n) start = near.solution;
    const Extremum now = extremum(CreepCurve(scene, formulation, n), near.rho, start);
    const double moved = std::abs(now.traction - last.traction),
                 creep_moved = std::abs(now.creep - last.creep);
    if (0.2 * std::max(moved, creep_moved / now.creep) < tolerance)
      return {now.traction, now.creep, 0.2 * moved, 0.2 * creep_moved};
    last = now;
  }
  throw NotResolved("coupled: the largest traction is not resolved to " + shortest(tolerance), {});
}

/// Two points about the traction on this side of the highest one; the same twice if there are none.
std::pair<OnCurve, OnCurve> enclose(const CreepCurve& curve, const std::vector<OnCurve>& points,
                                    std::size_t highest, Branch branch, double asked) {
  const bool rising = branch == Branch::rising;
  for (std::size_t i = rising ? 0 : highest; i + 1 < points.size(); ++i) {
    if (rising && i >= highest) break;
    OnCurve a = points[i], b = points[i + 1];
    if ((a.traction() < asked) == (b.traction() < asked)) continue;
    for (int halving = 0; halving < 10; ++halving) {
      const double middle = (a.rho + b.rho) / 2;
      const OnCurve c{middle, curve.at(middle, a.solution)};
      ((c.traction() < asked) == (a.traction() < asked) ? a : b) = c;
    }
    return {a, b};
  }
  return {points.front(), points.front()};
}

/// Solve with n unknowns where the derivative says, moving on until less than share of each result
/// is left to be carried over; slope, the derivative by the traction, is improved.
GridSolution settle(const Scene& scene, Formulation formulation, int n, const Prescribed& given,
                    const GridSolution& from, Results& slope, double share) {
  GridSolution level = from;
  for (int k = 0; k < 8; ++k) {
    const GridSolution last = level;
    const double missing = residual(last, given);
    level = last.at.stick == 0
                ? solve_slipping_grid(scene, formulation, n,
                                      last.value(creep) + slope(creep) * missing, last)
                : solve_on_grid(scene, formulation, n,
                                moved_by(last.at, slope(stick_slip_border) * missing), last);
    if (level.newton_steps == 0) break;
    const double moved = level.value(traction) - last.value(traction);
    if (k > 0 && std::abs(moved) > 1e-12) slope = (level.value - last.value) / moved;
    const Results carried = slope * residual(level, given) / scale_of(level.value);
    if (carried.head(compared).abs().maxCoeff() < share) break;
  }
  return level;
}

void refuse_beyond(const std::vector<OnCurve>& points, std::size_t highest,
                   const std::optional<TractionLimit>& limit, Branch branch, double asked,
                   double sign) {
  const auto must_be = [&](bool allowed, const std::string& range) {
    require(allowed, "traction", sign * asked, range);
  };
  const std::string below = sign > 0 ? "below " : "above ", above = sign > 0 ? "above " : "below ";
  const std::string at_most = sign > 0 ? "at most " : "at least ";
  if (!limit && branch == Branch::falling)
    throw std::invalid_argument("branch = falling does not exist: the traction has no maximum");
  if (limit)
    must_be(asked <= limit->traction, at_most + fixed(sign * limit->traction, 6) +
                                          ", the largest, at the creep " +
                                          fixed(sign * limit->creep, 6));
  const double most = points[highest].traction(), least = points.back().traction();
  if (!limit) must_be(asked < most, below + fixed(sign * most, 4));
  if (branch == Branch::falling)
    must_be(asked > least, above + fixed(sign * least, 4) + " on the falling branch");
}

}  // namespace

CoupledSolution solve_on_branch(const Scene& scene, Formulation formulation, double tolerance,
                                double asked, Branch branch) {
  const CreepCurve coarse(scene, formulation, 16), finer(scene, formulation, 40);
  std::vector<OnCurve> points = walk(coarse, scene.friction, asked);
  const bool found = points.size() > 10 && points.back().rho > 1;
  const CreepCurve& curve = found ? coarse : finer;
  if (!found) points = walk(finer, scene.friction, asked);
  if (points.size() < 2) throw std::runtime_error("coupled: no traction-creep curve found");
  const std::size_t highest = add_highest(curve, points);
  std::optional<TractionLimit> limit;
  if (highest + 1 < points.size())
    limit = traction_limit(scene, formulation, tolerance, points[highest]);
  refuse_beyond(points, highest, limit, branch, asked, sign_of(scene.direction));
  const auto [a, b] = enclose(curve, points, highest, branch, asked);
  const Prescribed given{traction, asked};
  Results slope = (b.solution.value - a.solution.value) / (b.traction() - a.traction());
  CoupledSolution x =
      refine(scene, formulation, tolerance, given, a.solution, slope,
             [&](int n, const GridSolution& last) {
               return settle(scene, formulation, n, given, last, slope, tolerance / 10);
             });
  x.limit = limit;
  x.branch = branch;
  return x;
}

}  // namespace thermoroll
