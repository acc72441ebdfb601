// Tangled from paper/17-least-model.md; edit there.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>

#include "solver/least_model.hpp"
#include "studies/comparison.hpp"
#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "studies/sampling.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

/// The largest H, from 1e-9 to 1e3, at which the error of a level meets the tolerance.
template <class Level>
double most_heating(const Level& level, double peclet, double tolerance) {
  double low = 1e-9, high = 1e3;
  while (high > 1.01 * low) {
    const double middle = std::sqrt(low * high);
    const Scene scene{paper::friction, peclet, middle};
    const auto x = level(scene, {Formulation::corrected, tolerance}, {Quantity::traction, 0.5});
    (largest_error(x) <= tolerance ? low : high) = middle;
  }
  return low;
}

void levels_by_peclet(std::ostream& out) {
  row(out, "peclet", "closed_2", "first_2", "closed_3", "first_3", "closed_6", "first_6");
  for (const double speed : grid(-2, 6, 48)) {
    out << shortest(std::pow(10, speed));
    for (const double tolerance : {1e-2, 1e-3, 1e-6})
      for (const auto level : {closed_form, first_order})
        out << ',' << shortest(most_heating(level, std::pow(10, speed), tolerance));
    out << '\n';
  }
}

const FigureData rungs_data{"rungs", levels_by_peclet};

/// The outcome of an answer to a tolerance: its level, 3 for a refusal, and its true error in units
/// of the tolerance, by a coupled solution ten times better.
struct Trial {
  int level = 3;
  double error = 0;
};

Trial run_trial(const Sample& x, double tolerance) {
  const Prescribed given{Quantity::traction, x.traction};
  try {
    const Choice choice = least_model(x.scene, {x.formulation, tolerance}, given);
    const CoupledSolution better = solve_coupled(x.scene, {x.formulation, tolerance / 10}, given);
    const double off = largest_difference(choice.solution.value, better.value);
    return {static_cast<int>(choice.model), off / tolerance};
  } catch (const std::runtime_error&) {
    return {};
  }
}

constexpr int random_count = 10002;  // a third for each tolerance
constexpr double random_tolerances[] = {1e-2, 1e-3, 1e-6};

std::vector<Trial> all_trials() {
  const std::vector<Sample> scenes = random_scenes(random_count);
  std::vector<Trial> trials(scenes.size());
  on_all_processors(scenes.size(), [&](std::size_t i) {
    trials[i] = run_trial(scenes[i], random_tolerances[i % 3]);
  });
  return trials;
}

void levels_of_random_scenes(std::ostream& out) {
  row(out, "tolerance", "closed form", "first order", "coupled", "refused", "error below coupled",
      "error of coupled");
  const std::vector<Trial> trials = all_trials();
  for (std::size_t k = 0; k < 3; ++k) {
    int count[4] = {};
    double below = 0, coupled = 0;
    for (std::size_t i = k; i < trials.size(); i += 3) {
      ++count[trials[i].level];
      double& worst = trials[i].level < 2 ? below : coupled;
      worst = std::max(worst, trials[i].error);
    }
    row(out, scientific(random_tolerances[k], 1), count[0], count[1], count[2], count[3],
        fixed(below, 2), fixed(coupled, 2));
  }
}

const FigureData random_scenes_data{"random-scenes", levels_of_random_scenes};

constexpr int small_count = 300;

struct SmallContact {
  Scene scene;
  Prescribed given;
  Formulation formulation;
};

std::vector<SmallContact> small_contacts() {
  Random random{std::mt19937_64(20020102)};
  std::vector<SmallContact> contacts;
  for (int i = 0; i < small_count; ++i) {
    const double f = random.log_uniform(0.03, 1.5), part = random.log_uniform(1e-4, 0.5);
    const Scene scene{f, random.log_uniform(1e-3, 1e8), random.log_uniform(2e-5, 0.1)};
    const Quantity all[] = {Quantity::traction, Quantity::creep, Quantity::stick_slip_border};
    const Quantity what = all[random.bits() % 3];
    const Results cold = carter_values(carter(f, f * (random.bits() % 2 ? part : 1 - part)));
    contacts.push_back({scene,
                        {what, cold(what)},
                        random.bits() % 2 ? Formulation::printed : Formulation::corrected});
  }
  return contacts;
}

/// By quantity: stated errors divided by true ones, as far as those can be resolved.
using Ratios = std::array<std::vector<double>, compared>;

void compare(const CoupledSolution& x, const CoupledSolution& exact, Ratios& ratios) {
  for (int i = 0; i < compared; ++i) {
    const double off = std::abs(x.value[i] - exact.value[i]);
    if (off > 10 * exact.error[i]) ratios[static_cast<std::size_t>(i)].push_back(x.error[i] / off);
  }
}

void stated_errors(std::ostream& out) {
  Ratios ratios[2];
  for (const SmallContact& x : small_contacts()) try {
      const auto exact = solve_coupled(x.scene, {x.formulation, 1e-9}, x.given);
      compare(closed_form(x.scene, {x.formulation, 1e-9}, x.given), exact, ratios[0]);
      compare(first_order(x.scene, {x.formulation, 1e-9}, x.given), exact, ratios[1]);
    } catch (const std::exception&) {  // refused by name
    }
  row(out, "result", "closed form: told", "median", "beyond", "first order: told", "its median",
      "its beyond");
  for (const Reported& q : reported) {
    const auto i = static_cast<std::size_t>(q.quantity);
    if (i >= compared) continue;
    out << q.key;
    for (const Ratios& level : ratios)
      out << ',' << level[i].size() << ',' << fixed(median(level[i]), 1) << ','
          << std::count_if(level[i].begin(), level[i].end(), [](double r) { return r < 1; });
    out << '\n';
  }
}

const FigureData stated_errors_data{"stated-errors", stated_errors};

}  // namespace

void values_on_least_model(nlohmann::ordered_json& v) {
  const Scene scene{paper::friction, paper::peclet, paper::heating};
  const Prescribed given{Quantity::traction, 0.5};
  const auto model = [&](double tolerance) {
    const char* const names[] = {"closed form", "one linear correction", "coupled"};
    const Choice x = least_model(scene, {Formulation::corrected, tolerance}, given);
    return names[static_cast<int>(x.model)];
  };
  const double lambda = 2 * paper::closed_form(0.5).slip_half_width * paper::peclet;
  const CoupledSolution best = solve_coupled(scene, {Formulation::corrected, 1e-8}, given);
  const CoupledSolution cold = closed_form(scene, {Formulation::corrected, 1e-8}, given);
  const double most = largest_difference(cold.value, best.value);
  v["least_scenes"] = std::to_string(random_count);
  v["least_small"] = std::to_string(small_count);
  v["least_lambda"] = fixed(lambda, 0);
  v["least_limit_error"] = scientific(1.3 / (lambda * lambda), 1);
  v["least_paper_2"] = model(1e-2);
  v["least_paper_4"] = model(1e-4);
  v["least_paper_6"] = model(1e-6);
  v["least_paper_change"] = scientific(most, 1);
  v["least_paper_square"] = scientific(most * most, 1);
  const CoupledSolution once = first_order(scene, {Formulation::corrected, 1e-8}, given);
  v["least_paper_left"] = scientific(largest_difference(once.value, best.value), 1);
  v["least_paper_stated"] = scientific(largest_error(once), 1);
}

}  // namespace thermoroll
