// Tangled from paper/22-creep-curve.md; edit there.
#include "thermoroll/creep_law_by_speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "support/number_text.hpp"
#include "thermoroll/coupled.hpp"

namespace thermoroll {
namespace {

constexpr int laws_of_piece = 5;
using SpeedWeights = std::array<double, laws_of_piece>;

SpeedWeights weights_at(double y) {
  SpeedWeights weight;
  for (int i = 0; i < laws_of_piece; ++i) {
    double& w = weight[static_cast<std::size_t>(i)] = 1;
    for (int j = 0; j < laws_of_piece; ++j)
      if (j != i) w *= (y - j) / (i - j);
  }
  return weight;
}

/// The first of the five laws about a speed.
std::size_t first_about(const std::vector<double>& speeds, double speed) {
  std::size_t first = 0;
  while (first + laws_of_piece < speeds.size() && speed > speeds[first + 4]) first += 4;
  return first;
}

struct SpeedsInTheMaking {
  const SceneBySpeed& scene_at;
  Formulation formulation;
  double from, to, tolerance;
  CreepRange creeps;
  std::map<double, CreepLaw> made{};  // by share
};

double speed_at(const SpeedsInTheMaking& x, double share) {
  return share == 1 ? x.to : x.from * std::pow(x.to / x.from, share);
}

const CreepLaw& law_at(SpeedsInTheMaking& x, double share) {
  const auto known = x.made.find(share);
  if (known != x.made.end()) return known->second;
  const double speed = speed_at(x, share), tolerance = std::max(x.tolerance / 3, 1e-7);
  try {
    return x.made[share] = creep_law(x.scene_at(speed), x.formulation, tolerance, x.creeps);
  } catch (const NotResolved& error) {
    throw NotResolved("at the speed " + shortest(speed) + ": " + error.what(), {});
  }
}

void raise_errors(CreepLawBySpeed& law, double traction, double border, double temperature) {
  law.traction_error = std::max(law.traction_error, traction);
  law.border_error = std::max(law.border_error, border);
  law.temperature_error = std::max(law.temperature_error, temperature);
}

CreepLawBySpeed laws_between(SpeedsInTheMaking& x, double a, double b) {
  CreepLawBySpeed piece{{}, {}, 0, 0, 0};
  for (int i = 0; i < laws_of_piece; ++i) {
    const double share = a + (b - a) * i / 4, speed = speed_at(x, share);
    const CreepLaw& law = law_at(x, share);
    piece.speeds.push_back(speed);
    piece.laws.push_back(law);
    raise_errors(piece, law.traction_error, law.border_error,
                 law.temperature_error * speed / x.from);
  }
  return piece;
}

/// The largest differences at a speed of the piece: of Q*, T* and c0, that of T* beyond unit_creep
/// over the creep's size; and the largest T* at unit_creep.
struct Apart {
  double traction = 0, temperature = 0, border = 0, scale = 0;
};

Apart apart(const CreepLawBySpeed& piece, const CreepLaw& law, double speed) {
  Apart most;
  for (int k = -39; k < 40; ++k) {
    const double z = std::abs(k) / 20.0, size = z < 1 ? z * z : 1 / (2 - z);
    const double unit = (k < 0 ? law.braking : law.driving).unit_creep;
    const double creep = law.no_slip_creep + (k < 0 ? -unit : unit) * size;
    const auto exact = evaluate(law, creep), joined = evaluate(piece, creep, speed);
    if (!exact || !joined) continue;
    const double warmer = std::abs(joined->temperature - exact->temperature);
    most.traction = std::max(most.traction, std::abs(joined->traction - exact->traction));
    most.temperature = std::max(most.temperature, warmer / std::max(1.0, size));
    most.border = std::max(most.border, std::abs(joined->border - exact->border));
    if (z <= 1) most.scale = std::max(most.scale, std::abs(exact->temperature));
  }
  return most;
}

/// Whether it does; if so, its errors in most become those at that speed, if they are larger.
bool holds(SpeedsInTheMaking& x, const CreepLawBySpeed& piece, double share, Apart& most) {
  const double speed = speed_at(x, share), faster = speed / x.from;
  const Apart here = apart(piece, law_at(x, share), speed);
  const double traction = std::max(x.tolerance / 3, piece.traction_error / 2);
  const double temperature =
      std::max(x.tolerance / 3 * here.scale, piece.temperature_error / faster / 2);
  most.traction = std::max(most.traction, here.traction);
  most.temperature = std::max(most.temperature, here.temperature * faster);
  most.border = std::max(most.border, here.border);
  return here.traction <= traction && here.temperature <= temperature;
}

void add_piece(CreepLawBySpeed& law, const CreepLawBySpeed& piece, const Apart& most) {
  const std::ptrdiff_t shared = law.laws.empty() ? 0 : 1;
  law.speeds.insert(law.speeds.end(), piece.speeds.begin() + shared, piece.speeds.end());
  law.laws.insert(law.laws.end(), piece.laws.begin() + shared, piece.laws.end());
  raise_errors(law, piece.traction_error + 2 * most.traction, piece.border_error + 2 * most.border,
               piece.temperature_error + 2 * most.temperature);
}

void add_speeds(SpeedsInTheMaking& x, CreepLawBySpeed& law, double a, double b) {
  const CreepLawBySpeed piece = laws_between(x, a, b);
  const double eighth = (b - a) / 8;
  Apart most;
  if (holds(x, piece, a + eighth, most) && holds(x, piece, b - eighth, most))
    return add_piece(law, piece, most);
  if (b - a < 0.02)
    throw NotResolved("law: not resolved between the speeds " + shortest(piece.speeds.front()) +
                          " and " + shortest(piece.speeds.back()),
                      {});
  add_speeds(x, law, a, (a + b) / 2);
  add_speeds(x, law, (a + b) / 2, b);
}

}  // namespace

std::optional<LawValue> evaluate(const CreepLawBySpeed& law, double creep, double speed) {
  const auto& [speeds, laws, q_error, c_error, t_error] = law;
  if (!(speeds.front() <= speed && speed <= speeds.back())) return std::nullopt;
  if (laws.size() == 1) return evaluate(laws.front(), creep);
  const std::size_t first = first_about(speeds, speed);
  const double ratio = speed / speeds[first], all = speeds[first + 4] / speeds[first];
  const SpeedWeights weight = weights_at(4 * std::log(ratio) / std::log(all));
  LawValue sum{};
  for (std::size_t i = 0; i < laws_of_piece; ++i) {
    const auto at = evaluate(laws[first + i], creep);
    if (!at) return std::nullopt;
    sum.traction += weight[i] * at->traction;
    sum.slope += weight[i] * at->slope;
    sum.temperature += weight[i] * at->temperature;
    sum.border += weight[i] * at->border;
  }
  return sum;
}

CreepLawBySpeed creep_law_by_speed(const SceneBySpeed& scene_at, Formulation formulation,
                                   double from, double to, double tolerance,
                                   const CreepRange& creeps) {
  require(from > 0, "speed", from, "positive");
  require(from < to, "to-speed", to, "above speed = " + shortest(from));
  require(3e-7 <= tolerance && tolerance <= 1e-2, "tolerance", tolerance, "from 3e-7 to 1e-2");
  CreepLawBySpeed law{{}, {}, 0, 0, 0};
  SpeedsInTheMaking x{scene_at, formulation, from, to, tolerance, creeps};
  add_speeds(x, law, 0, 1);
  return law;
}

}  // namespace thermoroll
