// Tangled from paper/22-creep-curve.md; edit there.
#include "thermoroll/creep_law.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "solver/grid_solution.hpp"
#include "support/number_text.hpp"
#include "thermoroll/coupled.hpp"

namespace thermoroll {
namespace {

/// The creep curve of a scene in its direction, by the variable of @eq:law-variable.
struct HalfCurve {
  Scene scene;
  Formulation formulation;
  double tolerance, all_slips;
  double creep(double z) const { return z < 1 ? all_slips * z * z : all_slips / (2 - z); }
};

Results partial_slip(const HalfCurve& curve, double creep) {
  const Prescribed given{Quantity::creep, creep};
  return solve_coupled(curve.scene, curve.formulation, curve.tolerance, given).value;
}

/// The solution in full slip, on a grid that agrees with the one before; no newton_steps if none of
/// up to 160 unknowns does, or there is no contact.
GridSolution resolved(const HalfCurve& curve, double creep) {
  GridSolution last;
  for (int n = 20; n <= 160; n *= 2) {
    const GridSolution now = solve_slipping_grid(curve.scene, curve.formulation, n, creep, last);
    const bool contact =
        now.newton_steps > 0 && now.value(Quantity::load_ratio) > 0 && now.violations.empty();
    const Results change = (now.value - last.value).abs() / scale_of(now.value);
    if (contact && last.newton_steps > 0 && change.head(compared).maxCoeff() < curve.tolerance)
      return now;
    last = now;
  }
  last.newton_steps = 0;
  return last;
}

constexpr int law_nodes = 9;

struct LawSamples {
  double traction[law_nodes], temperature[law_nodes], slip_length[law_nodes];
};

double node(int k) { return std::cos(pi * (k + 0.5) / law_nodes); }

LawSamples sample(const HalfCurve& curve, double from, double to) {
  LawSamples y;
  for (int k = 0; k < law_nodes; ++k) {
    const double z = (from + to + (to - from) * node(k)) / 2, creep = curve.creep(z);
    const Results x = z < 1 ? partial_slip(curve, creep) : resolved(curve, creep).value;
    const bool sticks = z < 1;
    y.traction[k] = x(Quantity::traction) / (sticks ? creep : 1);
    y.temperature[k] = x(Quantity::max_temperature) / (sticks ? 1 : creep / curve.all_slips);
    y.slip_length[k] = sticks ? x(Quantity::slip_length) / (z * z) : 2;
  }
  return y;
}

std::vector<double> chebyshev(const double (&values)[law_nodes]) {
  std::vector<double> c(law_nodes);
  for (int j = 0; j < law_nodes; ++j) {
    for (int k = 0; k < law_nodes; ++k)
      c[static_cast<std::size_t>(j)] += values[k] * std::cos(pi * j * (k + 0.5) / law_nodes);
    c[static_cast<std::size_t>(j)] *= (j == 0 ? 1.0 : 2.0) / law_nodes;
  }
  return c;
}

/// What the polynomial leaves out, by its last two coefficients.
double left_out(const std::vector<double>& c) {
  return 2 * (std::abs(c[law_nodes - 1]) + std::abs(c[law_nodes - 2]));
}

struct Errors {
  double traction = 0, temperature = 0;
};

/// Add the pieces from z = from to z = to; scale is the temperature at z = 1.
void add_pieces(const HalfCurve& curve, double from, double to, double scale, LawHalf& half,
                Errors& errors) {
  const LawSamples y = sample(curve, from, to);
  const LawPiece piece{from, to, chebyshev(y.traction), chebyshev(y.temperature),
                       chebyshev(y.slip_length)};
  const double per = to <= 1 ? curve.creep(to) : 1;
  const double traction = left_out(piece.traction) * per;
  const double temperature = left_out(piece.temperature) / scale;
  const double border = left_out(piece.slip_length);
  if (std::max({traction, temperature, border}) > 5 * curve.tolerance && to - from > 0.02) {
    const double middle = (from + to) / 2;
    add_pieces(curve, from, middle, scale, half, errors);
    add_pieces(curve, middle, to, scale, half, errors);
    return;
  }
  half.pieces.push_back(piece);
  errors.traction = std::max(errors.traction, traction + curve.tolerance);
  errors.temperature = std::max(errors.temperature, temperature + curve.tolerance);
}

/// The end of the curve in z: 2, or where there is no solution any more, found by halving.
double end_of(const HalfCurve& curve) {
  const auto ends = [&](double z) { return resolved(curve, curve.creep(z)).newton_steps == 0; };
  if (!ends(1.999)) return 2;
  double low = 1, high = 1.999;
  for (int halving = 0; halving < 12; ++halving) {
    const double middle = (low + high) / 2;
    (ends(middle) ? high : low) = middle;
  }
  return low;
}

LawHalf half_law(const HalfCurve& curve, Errors& errors) {
  LawHalf half{curve.all_slips, {}, std::numeric_limits<double>::infinity(), ""};
  const GridSolution one = resolved(curve, curve.all_slips);
  const double scale = one.value(Quantity::max_temperature);
  add_pieces(curve, 0, 1, scale, half, errors);
  const double end = end_of(curve);
  if (end < 2) {
    half.last_creep = curve.creep(end);
    half.reason = "contact is lost, or not resolved";
  }
  const double middle = std::min(end, 1.9);
  if (end > 1) add_pieces(curve, 1, middle, scale, half, errors);
  if (end > middle) add_pieces(curve, middle, end, scale, half, errors);
  return half;
}

struct Series {
  double value, slope;
};

/// The series at -1 <= x <= 1, and its derivative by x.
Series clenshaw(const std::vector<double>& c, double x) {
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

}  // namespace

CreepLaw creep_law(const Scene& scene, Formulation formulation, double tolerance) {
  check(scene);
  require(1e-8 <= tolerance && tolerance <= 1e-2, "tolerance", tolerance, "from 1e-8 to 1e-2");
  CreepLaw law{{}, {}, 0, 0};
  Errors errors;
  for (const Direction direction : {Direction::driving, Direction::braking}) {
    HalfCurve curve{scene, formulation, tolerance / 10, 0};
    curve.scene.direction = direction;
    const GridSolution full = next_to_full_slip(curve.scene, formulation, 60);
    if (full.newton_steps == 0) throw std::runtime_error("law: no solution found at full slip");
    curve.all_slips = full.value(Quantity::creep);
    (direction == Direction::driving ? law.driving : law.braking) = half_law(curve, errors);
  }
  law.traction_error = errors.traction;
  law.temperature_error = errors.temperature;
  return law;
}

LawValue evaluate(const CreepLaw& law, double creep) {
  const LawHalf& half = creep < 0 ? law.braking : law.driving;
  const double size = std::abs(creep), sign = creep < 0 ? -1 : 1, one = half.all_slips;
  if (!(size <= half.last_creep))
    require(false, "creep", creep,
            "of a size up to " + shortest(half.last_creep) + ", where " + half.reason);
  const bool sticks = size < one;
  const double z = sticks ? std::sqrt(size / one) : 2 - one / size;
  std::size_t k = 0;
  while (k + 1 < half.pieces.size() && z > half.pieces[k].to) ++k;
  const LawPiece& piece = half.pieces[k];
  const double per_z = 2 / (piece.to - piece.from);
  const double x = std::clamp(per_z * (z - piece.from) - 1, -1.0, 1.0);
  const Series q = clenshaw(piece.traction, x), t = clenshaw(piece.temperature, x);
  if (sticks) {
    const double slip_length = z * z * clenshaw(piece.slip_length, x).value;
    return {sign * size * q.value, q.value + z * per_z * q.slope / 2, t.value, 1 - slip_length};
  }
  return {sign * q.value, one / (size * size) * per_z * q.slope, t.value * size / one, -1};
}

}  // namespace thermoroll
