// Tangled from paper/22-creep-curve.md; edit there.
#include "thermoroll/creep_law_by_speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>
#include <map>
#include <utility>

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

struct CreepShare {
  bool brakes;
  double unit, share;  // of a unit
};

/// Among the laws from the first on.
CreepShare share_of(const CreepLawBySpeed& law, std::size_t first, const SpeedWeights& weight,
                    double creep) {
  double more = creep, unit[2] = {0, 0};
  for (std::size_t i = 0; i < laws_of_piece; ++i) {
    more -= weight[i] * law.laws[first + i].no_slip_creep;
    for (const bool brakes : {false, true})
      unit[brakes] += weight[i] * scale_of(law, first, i, brakes);
  }
  const bool brakes = more < 0;
  return {brakes, unit[brakes], std::abs(more) / unit[brakes]};
}

/// The first of the five laws about a speed.
std::size_t first_about(const std::vector<double>& speeds, double speed) {
  std::size_t first = 0;
  while (first + laws_of_piece < speeds.size() && speed > speeds[first + 4]) first += 4;
  return first;
}

/// Of the law i of a piece at the speed of its law k.
double end_at(const CreepLawBySpeed& law, std::size_t first, std::size_t i, std::size_t k,
              bool brakes) {
  const CreepLaw &one = law.laws[first + i], &other = law.laws[first + k];
  const double last = (brakes ? one.braking : one.driving).last_creep;
  const double share = last / scale_of(law, first, i, brakes);
  const double stretch = std::sqrt(law.speeds[first + k] / law.speeds[first + i]);
  const double along = share > 1 ? 1 + (share - 1) / stretch : share;
  const double size = scale_of(law, first, k, brakes) * along;
  return other.no_slip_creep + (brakes ? -size : size);
}

struct SpeedsInTheMaking {
  const SceneBySpeed& scene_at;
  Formulation formulation;
  double from, to, tolerance;
  std::map<double, CreepLaw> made{};  // by share
};

double speed_at(const SpeedsInTheMaking& x, double share) {
  return share == 1 ? x.to : x.from * std::pow(x.to / x.from, share);
}

CreepLaw make_law(const SpeedsInTheMaking& x, double share) {
  const double speed = speed_at(x, share), tolerance = std::max(x.tolerance / 3, 1e-7);
  try {
    return creep_law(x.scene_at(speed), x.formulation, tolerance);
  } catch (const NotResolved& error) {
    throw NotResolved("at the speed " + shortest(speed) + ": " + error.what(), {});
  }
}

/// Make those laws at the eighths from a to b that are not made.
void make_laws(SpeedsInTheMaking& x, double a, double b) {
  std::vector<std::pair<double, std::future<CreepLaw>>> coming;
  for (int k = 0; k <= 8; ++k) {
    const double share = a + (b - a) * k / 8;
    if (x.made.count(share) > 0) continue;
    const auto make = [&x, share] { return make_law(x, share); };
    coming.emplace_back(share, std::async(std::launch::async, make));
  }
  for (auto& [share, law] : coming) x.made[share] = law.get();
}

void raise_errors(CreepLawBySpeed& law, double traction, double border, double temperature) {
  law.traction_error = std::max(law.traction_error, traction);
  law.border_error = std::max(law.border_error, border);
  law.temperature_error = std::max(law.temperature_error, temperature);
}

CreepLawBySpeed laws_between(const SpeedsInTheMaking& x, double a, double b) {
  CreepLawBySpeed piece{{}, {}, 0, 0, 0};
  for (int i = 0; i < laws_of_piece; ++i) {
    const double share = a + (b - a) * i / 4, speed = speed_at(x, share);
    const CreepLaw& law = x.made.at(share);
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
  for (int k = -79; k < 80; ++k) {
    const double z = std::abs(k) / 40.0, size = z < 1 ? z * z : 1 / (2 - z);
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
bool holds(const SpeedsInTheMaking& x, const CreepLawBySpeed& piece, double share, Apart& most) {
  const double speed = speed_at(x, share), faster = speed / x.from;
  const Apart here = apart(piece, x.made.at(share), speed);
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
  make_laws(x, a, b);
  const CreepLawBySpeed piece = laws_between(x, a, b);
  Apart most;
  const auto here = [&](double eighths) {
    return holds(x, piece, a + (b - a) * eighths / 8, most);
  };
  if (here(1) && here(7) && here(3) && here(5)) return add_piece(law, piece, most);
  if (b - a < 0.02)
    throw NotResolved("law: not resolved between the speeds " + shortest(piece.speeds.front()) +
                          " and " + shortest(piece.speeds.back()),
                      {});
  add_speeds(x, law, a, (a + b) / 2);
  add_speeds(x, law, (a + b) / 2, b);
}

}  // namespace

double scale_of(const CreepLawBySpeed& law, std::size_t first, std::size_t i, bool brakes) {
  const auto half = brakes ? &CreepLaw::braking : &CreepLaw::driving;
  const std::size_t end = std::min(first + laws_of_piece, law.laws.size());
  for (std::size_t k = first; k < end; ++k)
    if (!((law.laws[k].*half).last_creep > (law.laws[k].*half).unit_creep)) return 1;
  return (law.laws[first + i].*half).unit_creep;
}

std::optional<LawValue> evaluate(const CreepLawBySpeed& law, double creep, double speed) {
  const auto& [speeds, laws, q_error, c_error, t_error] = law;
  if (!(speeds.front() <= speed && speed <= speeds.back())) return std::nullopt;
  if (laws.size() == 1) return evaluate(laws.front(), creep);
  if (!std::isfinite(creep)) return std::nullopt;
  const std::size_t first = first_about(speeds, speed);
  const double ratio = speed / speeds[first], all = speeds[first + 4] / speeds[first];
  const SpeedWeights weight = weights_at(4 * std::log(ratio) / std::log(all));
  const CreepShare at = share_of(law, first, weight, creep);
  LawValue sum{};
  bool all_slip = true;
  for (std::size_t i = 0; i < laws_of_piece; ++i) {
    const double own = scale_of(law, first, i, at.brakes), faster = speed / speeds[first + i];
    const double stretch = at.share > 1 ? std::sqrt(faster) : 1;
    const double size = own * (at.share + (stretch - 1) * (at.share - 1));
    const double rest = laws[first + i].no_slip_creep;
    const auto one = evaluate(laws[first + i], rest + (at.brakes ? -size : size));
    if (!one) return std::nullopt;
    sum.traction += weight[i] * one->traction;
    sum.slope += weight[i] * stretch * own / at.unit * one->slope;
    sum.temperature += weight[i] * one->temperature / faster;
    sum.border += weight[i] * one->border;
    all_slip = all_slip && one->border == -1;
  }
  sum.border = all_slip ? -1 : std::max(sum.border, -1.0);
  return sum;
}

LawEnd earliest_end(const CreepLawBySpeed& law, bool brakes) {
  const double never = std::numeric_limits<double>::infinity();
  LawEnd end{brakes ? -never : never, {}};
  const std::size_t all = law.laws.size(), count = std::min<std::size_t>(all, laws_of_piece);
  for (std::size_t first = 0; first + count <= all; first += laws_of_piece - 1)
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < count; ++k) {
        const double creep = end_at(law, first, i, k, brakes);
        if (brakes ? creep <= end.creep : creep >= end.creep) continue;
        const CreepLaw& one = law.laws[first + i];
        end = {creep, (brakes ? one.braking : one.driving).reason};
      }
  return end;
}

CreepLawBySpeed creep_law_by_speed(const SceneBySpeed& scene_at, Formulation formulation,
                                   double from, double to, double tolerance) {
  require(from > 0, "speed", from, "positive");
  require(from < to, "to-speed", to, "above speed = " + shortest(from));
  require(3e-7 <= tolerance && tolerance <= 1e-2, "tolerance", tolerance, "from 3e-7 to 1e-2");
  CreepLawBySpeed law{{}, {}, 0, 0, 0};
  SpeedsInTheMaking x{scene_at, formulation, from, to, tolerance};
  add_speeds(x, law, 0, 1);
  return law;
}

}  // namespace thermoroll
