// Tangled from paper/17-least-model.md; edit there.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <nlohmann/json.hpp>

#include "solver/least_model.hpp"
#include "studies/comparison.hpp"
#include "studies/data.hpp"
#include "studies/paper_case.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

/// The largest heating, from 1e-9 to 1e3, at which the error of a rung meets the tolerance.
template <class Rung>
double most_heating(const Rung& rung, double peclet, double tolerance) {
  double low = 1e-9, high = 1e3;
  while (high > 1.01 * low) {
    const double middle = std::sqrt(low * high);
    const Scene scene{paper::friction, peclet, middle};
    const auto x =
        rung(scene, Formulation::corrected, tolerance, Prescribed{Quantity::traction, 0.5});
    (x.error(Quantity::load_ratio) <= tolerance ? low : high) = middle;
  }
  return low;
}

void rungs_by_peclet(std::ostream& out) {
  row(out, "peclet", "closed_2", "first_2", "closed_3", "first_3", "closed_6", "first_6");
  for (const double speed : grid(-2, 6, 48)) {
    out << shortest(std::pow(10, speed));
    for (const double tolerance : {1e-2, 1e-3, 1e-6})
      for (const auto rung : {closed_form, first_order})
        out << ',' << shortest(most_heating(rung, std::pow(10, speed), tolerance));
    out << '\n';
  }
}

const FigureData rungs_data{"rungs", rungs_by_peclet};

/// How an answer to a tolerance did: the rung, 3 where it was refused, and its true error in units
/// of the tolerance, by a coupled solution ten times better.
struct Trial {
  int rung = 3;
  double error = 0;
};

Trial try_ladder(const Sample& x, double tolerance) {
  const Prescribed given{Quantity::traction, x.traction};
  try {
    const Choice choice = least_model(x.scene, x.formulation, tolerance, given);
    const CoupledSolution better = solve_coupled(x.scene, x.formulation, tolerance / 10, given);
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
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < scenes.size(); i = next++)
      trials[i] = try_ladder(scenes[i], random_tolerances[i % 3]);
  };
  std::thread other(work);
  work();
  other.join();
  return trials;
}

void rungs_of_random_scenes(std::ostream& out) {
  row(out, "tolerance", "closed form", "first order", "coupled", "refused", "error below coupled",
      "error of coupled");
  const std::vector<Trial> trials = all_trials();
  for (std::size_t k = 0; k < 3; ++k) {
    int count[4] = {};
    double below = 0, coupled = 0;
    for (std::size_t i = k; i < trials.size(); i += 3) {
      ++count[trials[i].rung];
      double& worst = trials[i].rung < 2 ? below : coupled;
      worst = std::max(worst, trials[i].error);
    }
    row(out, scientific(random_tolerances[k], 1), count[0], count[1], count[2], count[3],
        fixed(below, 2), fixed(coupled, 2));
  }
}

const FigureData random_scenes_data{"random-scenes", rungs_of_random_scenes};

}  // namespace

void values_on_least_model(nlohmann::ordered_json& v) {
  const Scene scene{paper::friction, paper::peclet, paper::heating};
  const Prescribed given{Quantity::traction, 0.5};
  const auto model = [&](double tolerance) {
    const char* const names[] = {"closed form", "first order in the heat", "coupled"};
    const Choice x = least_model(scene, Formulation::corrected, tolerance, given);
    return names[static_cast<int>(x.model)];
  };
  const double lambda = 2 * paper::closed_form(0.5).slip_half_width * paper::peclet;
  const CoupledSolution best = solve_coupled(scene, Formulation::corrected, 1e-8, given);
  const CoupledSolution cold = closed_form(scene, Formulation::corrected, 1e-8, given);
  const double most = largest_difference(cold.value, best.value);
  v["least_scenes"] = std::to_string(random_count);
  v["least_lambda"] = fixed(lambda, 0);
  v["least_limit_error"] = scientific(1.3 / (lambda * lambda), 1);
  v["least_paper_2"] = model(1e-2);
  v["least_paper_3"] = model(1e-3);
  v["least_paper_6"] = model(1e-6);
  v["least_paper_change"] = scientific(most, 1);
  v["least_paper_square"] = scientific(most * most, 1);
}

}  // namespace thermoroll
