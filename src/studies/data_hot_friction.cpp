// Tangled from paper/21-hot-friction.md, paper/F-data-files.md; edit there.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "solver/grid_solution.hpp"
#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/friction_law.hpp"

namespace thermoroll {
namespace {

constexpr double softenings[] = {0, 0.5, 1, 3, 6};

Scene softened(double lambda, double peclet, double heating) {
  Scene scene{paper::friction, peclet, heating};
  if (lambda > 0) scene.law = linear_friction({paper::friction / (lambda * std::sqrt(peclet))});
  return scene;
}

CoupledSolution found(const Scene& scene, const Prescribed& given, double tolerance = 1e-5) {
  return solve_coupled(scene, {Formulation::corrected, tolerance}, given);
}

double traction_at(const Scene& scene, double creep) {
  return found(scene, {Quantity::creep, creep}).value(Quantity::traction);
}

struct CreepPoint {
  double creep, traction;
};

CreepPoint with_one_friction(const CoupledSolution& unit, double lambda) {
  const double root_pe = std::sqrt(unit.scene.peclet);
  const double loss = lambda * root_pe * unit.value(Quantity::max_temperature);
  const double f = 2 * paper::friction / (1 + std::sqrt(1 + 4 * loss));
  return {f * unit.value(Quantity::creep), f * unit.value(Quantity::traction)};
}

std::vector<CoupledSolution> solutions_with_unit_friction() {
  std::vector<CoupledSolution> list;
  for (const double root : grid(0.1, 3.4, 66))
    list.push_back(found({1, 100, 0}, {Quantity::creep, root * root}));
  return list;
}

CoupledSolution one_of_two(Branch branch) {
  return found(softened(3, 100, paper::heating), {Quantity::traction, 0.35, branch}, 1e-10);
}

void softened_curves(std::ostream& out) {
  row(out, "kind", "softening", "creep", "traction");
  const auto units = solutions_with_unit_friction();
  for (const double lambda : softenings) {
    const Scene scene = softened(lambda, 100, paper::heating);
    row(out, "local", lambda, 0, 0);
    for (const double root : grid(0.1, 1, 45))
      row(out, "local", lambda, root * root, traction_at(scene, root * root));
    if (lambda == 0) continue;
    for (const CoupledSolution& unit : units)
      if (const auto [creep, traction] = with_one_friction(unit, lambda); creep <= 1)
        row(out, "shortcut", lambda, creep, traction);
    const TractionLimit top = paper::largest_traction(scene);
    row(out, "maximum", lambda, top.creep, top.traction);
  }
  for (const Branch branch : {Branch::rising, Branch::falling}) {
    const CoupledSolution x = one_of_two(branch);
    row(out, "pair", 3, x.value(Quantity::creep), x.value(Quantity::traction));
  }
}

const FigureData hot_friction_data{"hot-friction", softened_curves};

void collapse(std::ostream& out) {
  row(out, "peclet", "softening", "creep", "traction");
  const auto add = [&](double peclet, double lambda, double root) {
    const double creep = root * root, f = paper::friction;
    row(out, peclet, lambda, creep, traction_at(softened(lambda, peclet, 0), f * creep) / f);
  };
  for (const double lambda : {1.0, 3.0, 6.0}) {
    for (const double peclet : {5e4, 1.0})
      for (const double root : grid(0.1, 1.2, 33)) add(peclet, lambda, root);
    int k = 0;
    for (const double root : grid(0.25, 1.15, 17)) {
      constexpr double between[] = {5000, 1000, 100};
      add(between[k++ % 3], lambda, root);
    }
  }
}

const FigureData hot_collapse_data{"hot-collapse", collapse};

template <class AddRow>
void for_each_state(const AddRow& add_row) {
  const Scene scene = softened(3, 100, paper::heating);
  const CoupledSolution before = one_of_two(Branch::rising), past = one_of_two(Branch::falling);
  const CoupledSolution at = found(scene, {Quantity::creep, before.limit->creep}, 1e-10);
  for (const auto& [state, x] : {std::pair{"before", &before}, {"at", &at}, {"past", &past}}) {
    const Profile along = profile(*x);
    for (Eigen::Index i = 0; i < along.s.size(); ++i) add_row(state, scene, along, i);
  }
}

void tractions_about_the_maximum(std::ostream& out) {
  row(out, "state", "s", "q", "limit");
  for_each_state([&](const char* state, const Scene& scene, const Profile& x, Eigen::Index i) {
    const double limit = scene.friction * scene.law(x.temperature(i)).value * x.pressure(i);
    row(out, state, x.s(i), x.traction(i), limit);
  });
}

const FigureData hot_profile_a_data{"hot-profile-a", tractions_about_the_maximum};

void temperatures_about_the_maximum(std::ostream& out) {
  row(out, "state", "s", "T");
  for_each_state([&](const char* state, const Scene& scene, const Profile& x, Eigen::Index i) {
    const double scale = scene.friction / (3 * std::sqrt(scene.peclet));
    row(out, state, x.s(i), x.temperature(i) / scale);
  });
}

const FigureData hot_profile_b_data{"hot-profile-b", temperatures_about_the_maximum};

std::vector<GridSolution> on_finer_grids(const std::vector<int>& unknowns, bool moved) {
  Scene scene{paper::friction, 1e4, 0.0123, {1, 0.0123}};
  scene.law = linear_friction({0.01, 0, 5e-4});
  std::vector<GridSolution> all;
  GridSolution level;
  for (const int n : unknowns) {
    ZoneLengths at{1.2, 0.8};
    if (moved) at.variable = about_kinks(level, n);
    level = solve_on_grid(scene, Formulation::corrected, n, at, level);
    all.push_back(level);
  }
  return all;
}

void errors_at_a_kink(std::ostream& out) {
  row(out, "unknowns", "plain", "plain_estimate", "moved", "moved_estimate");
  const std::vector<int> unknowns{12, 16, 20, 24, 32, 44, 64, 88, 128, 176, 256, most_unknowns};
  const auto plain = on_finer_grids(unknowns, false), moved = on_finer_grids(unknowns, true);
  const auto error = [&](const GridSolution& x) {
    return std::abs(x.value(Quantity::traction) - moved.back().value(Quantity::traction));
  };
  for (std::size_t i = 1; i + 1 < unknowns.size(); ++i)
    row(out, unknowns[i], error(plain[i]), error_of_kinks(plain[i]), error(moved[i]),
        error_of_kinks(moved[i]));
}

const FigureData kinks_data{"kinks", errors_at_a_kink};

void steel_with_falling_friction(std::ostream& out) {
  row(out, "$V$ (m/s)", "$\\mathrm{Pe}$", "$\\omega\\Lambda$", "largest $Q^*/f_0$ (%)",
      "its creep (‰)", "rise there (°C)");
  for (const double speed : {5.0, 10.0, 20.0, 40.0, 80.0}) {
    PhysicalScene si = wheel_on_rail();
    si.speed = speed;
    Scene scene = scene_of(si, paper::friction);
    scene.roller = {1, scene.heating};
    const Units unit = units_of(si, scene.friction);
    scene.law = linear_friction({1600 / unit.temperature});
    const TractionLimit top = paper::largest_traction(scene);
    const double rise = found(scene, {Quantity::creep, top.creep}).value(Quantity::max_temperature);
    const double lambda = scene.friction * unit.temperature / (1600 * std::sqrt(scene.peclet));
    row(out, speed, fixed(scene.peclet, 0), fixed(heat_share(scene) * lambda, 2),
        fixed(100 * top.traction / scene.friction, 1),
        fixed(1000 * top.creep * unit.slip / si.speed, 2), fixed(rise * unit.temperature, 0));
  }
}

const FigureData hot_steel_data{"hot-steel", steel_with_falling_friction};

struct ShortcutErrors {
  double curve = 0, maximum = 0;
};

/// Of the traction relative to itself, for creeps up to one, and of the largest traction.
ShortcutErrors errors_of_the_shortcut(const std::vector<CoupledSolution>& units, double lambda) {
  const Scene scene = softened(lambda, 100, paper::heating);
  ShortcutErrors worst;
  double top = 0;
  for (const CoupledSolution& unit : units) {
    const auto [creep, traction] = with_one_friction(unit, lambda);
    if (creep > 1) break;
    top = std::max(top, traction);
    worst.curve = std::max(worst.curve, 1 - traction / traction_at(scene, creep));
  }
  worst.maximum = 1 - top / paper::largest_traction(scene).traction;
  return worst;
}

double end_of_stick(const Scene& scene) {
  return found(scene, {Quantity::stick_slip_border, -1 + 1e-6}).value(Quantity::creep);
}

}  // namespace

void values_on_hot_friction(nlohmann::ordered_json& v) {
  const auto units = solutions_with_unit_friction();
  const auto least = errors_of_the_shortcut(units, 0.5), most = errors_of_the_shortcut(units, 6);
  v["hot_shortcut_least"] = fixed(100 * least.curve, 1);
  v["hot_shortcut_most"] = fixed(100 * most.curve, 0);
  v["hot_shortcut_max_least"] = fixed(100 * least.maximum, 1);
  v["hot_shortcut_max_most"] = fixed(100 * most.maximum, 0);
  const Scene scene = softened(3, 100, paper::heating);
  const auto all_slips = found({1, 100, 0}, {Quantity::creep, 2 / pi});
  v["hot_shortcut_slips"] = fixed(with_one_friction(all_slips, 3).creep, 3);
  v["hot_slips"] = fixed(end_of_stick(scene), 3);
  v["hot_tail"] = fixed(20 * traction_at(scene, 20), 3);
  const double scale = scene.friction / (3 * std::sqrt(scene.peclet));
  const double far_out = scene.friction * scale * std::sqrt(16 * scene.peclet / pi);
  v["hot_tail_limit"] = fixed(far_out * (1 + 1 / (16 * scene.peclet)), 3);
  const PhysicalScene steel = wheel_on_rail();
  const Units unit = units_of(steel, paper::friction);
  v["hot_carter_slips"] = fixed(1000 * 2 / pi * paper::friction * unit.slip / steel.speed, 2);
  const TractionLimit top = paper::largest_traction(paper::wheel(false, true));
  v["hot_paper_max"] = fixed(100 * top.traction / paper::friction, 1);
  for (const bool two : {false, true}) {
    Scene ertz = paper::wheel(two, false);
    ertz.law = piecewise_linear_friction({400 / unit.temperature, 0.4});
    const TractionLimit highest = paper::largest_traction(ertz);
    v[two ? "hot_ertz_two" : "hot_ertz_one"] = fixed(100 * highest.traction / paper::friction, 1);
  }
}

}  // namespace thermoroll
