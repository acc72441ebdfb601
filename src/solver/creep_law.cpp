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

constexpr int law_nodes = 9;

struct LawSamples {
  double traction[law_nodes], temperature[law_nodes];
  double traction_error = 0, temperature_error = 0;  // the largest of the solutions
};

double node(int k) { return std::cos(pi * (k + 0.5) / law_nodes); }

LawSamples sample(const HalfCurve& curve, double from, double to) {
  LawSamples y;
  for (int k = 0; k < law_nodes; ++k) {
    const double z = (from + to + (to - from) * node(k)) / 2, creep = curve.creep(z);
    const CoupledSolution x = solve_coupled(curve.scene, curve.formulation, curve.tolerance,
                                            {Quantity::creep, creep});
    const bool sticks = z < 1, grows = !sticks && !curve.scene.law;
    const double per = sticks ? creep : 1, over = grows ? creep / curve.all_slips : 1;
    y.traction[k] = x.value(Quantity::traction) / per;
    y.temperature[k] = x.value(Quantity::max_temperature) / over;
    y.traction_error = std::max(y.traction_error, x.error(Quantity::traction));
    y.temperature_error =
        std::max(y.temperature_error, x.error(Quantity::max_temperature) / over);
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

void add_pieces(const HalfCurve& curve, double from, double to, double scale, LawHalf& half,
                Errors& errors) {
  const LawSamples y = sample(curve, from, to);
  const LawPiece piece{from, to, chebyshev(y.traction), chebyshev(y.temperature)};
  const double per = from < 1 ? curve.creep(std::min(to, 1.0)) : 1;
  const double traction = left_out(piece.traction) * per;
  const double warmest = *std::max_element(std::begin(y.temperature), std::end(y.temperature));
  const double against = from < 1 ? std::max(scale, warmest) : warmest;
  const double temperature = left_out(piece.temperature) / against;
  const double allowed = 0.5 * curve.tolerance * 10;
  if ((traction > allowed || temperature > allowed) && to - from > 1e-3) {
    const double middle = (from + to) / 2;
    add_pieces(curve, from, middle, scale, half, errors);
    add_pieces(curve, middle, to, scale, half, errors);
    return;
  }
  half.pieces.push_back(piece);
  errors.traction = std::max(errors.traction, traction + y.traction_error);
  errors.temperature = std::max(errors.temperature, temperature + y.temperature_error / against);
}

/// The end of the curve in z: 2, or where there is no contact any more, found by halving.
double end_of(const HalfCurve& curve) {
  const auto contact = [&](double z) {
    const GridSolution x =
        solve_slipping_grid(curve.scene, curve.formulation, 40, curve.creep(z), {});
    return x.newton_steps > 0 && x.value(Quantity::load_ratio) > 0 && x.violations.empty();
  };
  if (contact(1.999)) return 2;
  double low = 1, high = 1.999;
  for (int halving = 0; halving < 12; ++halving) {
    const double middle = (low + high) / 2;
    (contact(middle) ? low : high) = middle;
  }
  return low;
}

LawHalf half_law(const HalfCurve& curve, Errors& errors) {
  LawHalf half{curve.all_slips, {}, std::numeric_limits<double>::infinity(), ""};
  const CoupledSolution middle = solve_coupled(curve.scene, curve.formulation, curve.tolerance,
                                               {Quantity::creep, curve.all_slips});
  const double scale = middle.value(Quantity::max_temperature);
  add_pieces(curve, 0, 1, scale, half, errors);
  const double end = end_of(curve);
  if (end < 2) {
    half.last_creep = curve.creep(end);
    half.reason = "contact is lost";
  }
  if (end > 1) add_pieces(curve, 1, end, scale, half, errors);
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
  CreepLaw law{{}, {}, !scene.law, 0, 0};
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
  if (sticks) return {sign * size * q.value, q.value + z * per_z * q.slope / 2, t.value};
  const double grown = law.grows ? size / one : 1;
  return {sign * q.value, one / (size * size) * per_z * q.slope, t.value * grown};
}

}  // namespace thermoroll
