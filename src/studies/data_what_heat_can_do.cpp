// Tangled from paper/18-what-heat-can-do.md, paper/F-data-files.md; edit there.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "solver/least_model.hpp"
#include "studies/comparison.hpp"
#include "studies/data.hpp"
#include "studies/deflation.hpp"
#include "studies/iterations.hpp"
#include "studies/materials.hpp"
#include "studies/paper_scene.hpp"
#include "studies/sampling.hpp"
#include "support/number_text.hpp"
#include "thermoroll/admissibility.hpp"

namespace thermoroll {
namespace {

void materials_and_heatings(std::ostream& out) {
  row(out, "solid", "$\\mu$ (GPa)", "$\\nu$", "$\\alpha$ ($10^{-6}$/°C)", "$\\rho c$ (MJ/m³ °C)",
      "$\\Gamma$", "$H$ at $a/R=0.01$", "$H$ at $a/R=0.1$");
  for (const Material& m : materials())
    row(out, m.name, fixed(shear_modulus(m) / 1e9, 1), fixed(m.poisson, 3),
        fixed(1e6 * m.expansion, 1), fixed(m.density * m.heat_capacity / 1e6, 2),
        fixed(grueneisen(m), 2), fixed(heating_of_size(m, 0.01), 4),
        fixed(heating_of_size(m, 0.1), 3));
}

const FigureData materials_data{"materials", materials_and_heatings};

void small_heat(std::ostream& out) {
  row(out, "peclet", "closed_2", "first_2", "closed_1", "first_1");
  const Prescribed given{Quantity::traction, 0.5};
  for (const double speed : grid(-2, 6, 32)) {
    const double peclet = std::pow(10, speed);
    out << shortest(peclet);
    for (const double heating : {0.01, 0.1}) {
      const Scene scene{paper::friction, peclet, heating};
      const CoupledSolution best = solve_coupled(scene, {Formulation::corrected, 1e-10}, given);
      for (const auto level : {closed_form, first_order}) {
        const CoupledSolution x = level(scene, {Formulation::corrected, 1e-9}, given);
        out << ',' << largest_difference(x.value, best.value);
      }
    }
    out << '\n';
  }
}

const FigureData small_heat_data{"small-heat", small_heat};

std::vector<Sample> hottest_scenes(int count) {
  std::vector<Sample> scenes = random_scenes(count);
  for (Sample& x : scenes) x.scene.heating = 0.1;
  return scenes;
}

constexpr int admissible_count = 1000, heat_unknowns = 32, heat_nodes = 60;

/// The iteration's problem at Carter's border.
FluxMap map_of(const Sample& x) {
  const double c0 = carter(x.scene.friction, x.traction).c0;
  return flux_map(x.scene, x.formulation, heat_unknowns, c0);
}

struct Worst {
  double error = 0, contraction = 0;
  int unsettled = 0;
};

Worst methods_at_their_worst() {
  Worst worst;
  for (const auto& [scene, q, formulation] : hottest_scenes(admissible_count)) {
    const Prescribed given{Quantity::traction, q};
    const CoupledSolution best = solve_coupled(scene, {formulation, 1e-8}, given);
    const CoupledSolution once = first_order(scene, {formulation, 1e-8}, given);
    const FluxMap map = map_of({scene, q, formulation});
    Eigen::VectorXd h = carter_start(map);
    newton(map, h);
    const PublishedSolution scheme = solve_published(scene, q, formulation, {heat_nodes});
    const bool settled = scheme.converged && violations(factors(scheme, scene.friction)).empty();
    worst.error = std::max(worst.error, largest_difference(once.value, best.value));
    worst.contraction = std::max(worst.contraction, contraction(map, h));
    worst.unsettled += settled ? 0 : 1;
  }
  return worst;
}

constexpr int unique_count = 100, starts = 20, deflated_starts = 6, deflated_unknowns = 24;

/// How many starts end at the known solution, and at another admissible one.
struct Ends {
  int known = 0, other = 0;
};

Ends ends_of_random_starts() {
  Random random{std::mt19937_64(20020102)};
  Ends ends;
  for (const Sample& x : hottest_scenes(unique_count)) {
    const FluxMap map = map_of(x);
    Eigen::VectorXd solution = carter_start(map);
    newton(map, solution);
    for (int k = 0; k < starts; ++k) {
      Eigen::VectorXd h = solution;
      for (double& at_node : h) at_node *= 10 * random.uniform();
      const bool arrived = newton(map, h) > 0;
      const bool contact = pressure_factor(map, h).minCoeff() > 0 && h.minCoeff() > 0;
      const bool known = (h - solution).norm() < 1e-6 * solution.norm();
      ends.known += arrived && known ? 1 : 0;
      ends.other += arrived && !known && contact ? 1 : 0;
    }
  }
  return ends;
}

std::vector<double> contacts_at(double c0, const Scene& scene, Formulation formulation,
                                std::uint64_t seed) {
  const ContactGrid grid = contact_grid(scene, formulation, {1 - c0, 1 + c0}, deflated_unknowns);
  std::vector<double> tractions;
  for (const auto& h : distinct_solutions(grid, deflated_starts, {std::mt19937_64(seed)}))
    if (violations(factors(grid, h)).empty()) tractions.push_back(resultants(grid, h).traction);
  return tractions;
}

std::vector<Sample> scenes_with_friction(double sign) {
  std::vector<Sample> scenes = hottest_scenes(unique_count);
  Random random{std::mt19937_64(20150708)};
  for (auto& [x, q, formulation] : scenes) {
    const double scale = x.friction / (random.log_uniform(0.3, 6) * std::sqrt(x.peclet));
    if (sign != 0) x.law = linear_friction({sign * scale});
  }
  return scenes;
}

void count_contacts(std::ostream& out, const char* friction, double sign) {
  const std::vector<Sample> scenes = scenes_with_friction(sign);
  std::vector<std::size_t> found(scenes.size());
  on_all_processors(scenes.size(), [&](std::size_t i) {
    const auto& [x, q, formulation] = scenes[i];
    found[i] = contacts_at(carter(x.friction, q).c0, x, formulation, i).size();
  });
  const auto with = [&](std::size_t n) { return std::count(found.begin(), found.end(), n); };
  row(out, friction, unique_count, with(0), with(1), unique_count - with(0) - with(1));
}

void contacts_at_one_border(std::ostream& out) {
  row(out, "friction", "scenes", "none found", "one", "two or more");
  count_contacts(out, "constant", 0);
  count_contacts(out, "falls", 1);
  count_contacts(out, "rises", -1);
}

const FigureData deflation_data{"deflation", contacts_at_one_border};

}  // namespace

void values_on_what_heat_can_do(nlohmann::ordered_json& v) {
  const PhysicalScene steel = wheel_on_rail();
  const double nu = steel.poisson, heating = scene_of(steel, paper::friction).heating;
  const double hertz = hertz_half_width(steel.load, 1, steel.shear_modulus, nu);
  const double size = hertz * hertz / steel.half_width;
  const double unit = units_of(steel, paper::friction).temperature;
  const Worst worst = methods_at_their_worst();
  const Ends ends = ends_of_random_starts();
  Scene rises{0.4, 0.1, 0};
  rises.law = linear_friction({-0.45});
  const std::vector<double> pair = contacts_at(0, rises, Formulation::corrected, 0);
  v["heat_steel_size"] = fixed(size, 3);
  v["heat_steel_grueneisen"] = fixed(heating / size * 4 / pi * (1 - nu) / (1 - 2 * nu), 2);
  v["heat_softening"] = fixed(paper::friction * unit / 1600 / std::sqrt(paper::peclet), 2);
  v["heat_scenes"] = std::to_string(admissible_count);
  v["heat_first_order_worst"] = scientific(worst.error, 1);
  v["heat_contraction_worst"] = fixed(worst.contraction, 2);
  v["heat_steps"] = fixed(std::ceil(-6 / std::log10(worst.contraction)), 0);
  v["heat_nodes"] = std::to_string(heat_nodes);
  v["heat_scheme_failed"] = std::to_string(worst.unsettled);
  v["heat_unique_scenes"] = std::to_string(unique_count);
  v["heat_starts"] = std::to_string(starts);
  v["heat_unknowns"] = std::to_string(heat_unknowns);
  v["heat_tries"] = std::to_string(unique_count * starts);
  v["heat_arrived"] = std::to_string(ends.known);
  v["heat_deflated_starts"] = std::to_string(deflated_starts);
  v["heat_deflated_unknowns"] = std::to_string(deflated_unknowns);
  v["heat_pair"] = fixed(pair.at(0), 4) + " and " + fixed(pair.at(1), 4);
  v["heat_other"] = ends.other == 0 ? "none" : std::to_string(ends.other);
}

}  // namespace thermoroll
