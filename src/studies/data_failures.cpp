// Tangled from paper/16-where-methods-fail.md; edit there.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "studies/asymptotics.hpp"
#include "studies/claims.hpp"
#include "studies/comparison.hpp"
#include "studies/data.hpp"
#include "studies/figure_data.hpp"
#include "studies/iterations.hpp"
#include "studies/naive_kernels.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/admissibility.hpp"
#include "thermoroll/kernels.hpp"

namespace thermoroll {
namespace {

/// The most digits that a formula loses in a quarter of a decade about zeta.
double most_lost(double (*formula)(double), double (*exact)(double), double zeta) {
  double lost = 0;
  for (const double place : grid(-0.125, 0.125, 12)) {
    const double at = zeta * std::pow(10, place);
    lost = std::max(lost, digits_lost(formula(at), exact(at)));
  }
  return lost;
}

void arithmetic(std::ostream& out) {
  row(out, "zeta", "N1", "N1_scaled", "N2", "N2_scaled", "M", "M_scaled");
  const auto M = [](double zeta) { return kernel::M(zeta); };
  for (const double decade : grid(-12, 12, 96)) {
    const double x = std::pow(10, decade);
    row(out, x, most_lost(naive::N1, kernel::N1, x), most_lost(naive_scaled::N1, kernel::N1, x),
        most_lost(naive::N2, kernel::N2, -x), most_lost(naive_scaled::N2, kernel::N2, -x),
        most_lost(naive::M, M, -x), most_lost(naive_scaled::M, M, -x));
  }
}

const FigureData arithmetic_data{"arithmetic", arithmetic};

/// Converged and admissible; not converged, with an admissible or an inadmissible last iterate;
/// converged and inadmissible.
enum class SchemeEnd { settled = 1, unsettled, lost, wrong };

constexpr PublishedOptions few_nodes{20, 1e-6, 0, 40};  // at most 40 outer steps

SchemeEnd end_of_scheme(const Scene& scene, double traction, Formulation formulation) {
  const PublishedSolution solution = solve_published(scene, traction, formulation, few_nodes);
  if (violations(factors(solution, scene.friction)).empty())
    return solution.converged ? SchemeEnd::settled : SchemeEnd::unsettled;
  return solution.converged ? SchemeEnd::wrong : SchemeEnd::lost;
}

void values_on_contacts(nlohmann::ordered_json& v) {
  constexpr int count = 300;
  int refused = 0, wrong = 0, unsettled = 0, scheme_wrong = 0;
  double most = 0;
  for (Sample x : random_scenes(count)) {
    x.scene.heating *= 10;
    most = std::max(most, x.scene.friction * x.scene.heating);
    const Prescribed given{Quantity::traction, x.traction};
    const Outcome found = outcome([&] {
      return solve_coupled(x.scene, {x.formulation, 1e-3}, given);
    });
    refused += found == Outcome::refused ? 1 : 0;
    wrong += found == Outcome::no_contact ? 1 : 0;
    const SchemeEnd end = end_of_scheme(x.scene, x.traction, x.formulation);
    unsettled += end == SchemeEnd::unsettled || end == SchemeEnd::lost ? 1 : 0;
    scheme_wrong += end == SchemeEnd::lost || end == SchemeEnd::wrong ? 1 : 0;
  }
  v["contact_scenes"] = std::to_string(count);
  v["contact_heat"] = std::to_string(std::lround(most));
  v["contact_refused"] = std::to_string(refused);
  v["contact_wrong"] = std::to_string(wrong);
  v["contact_nodes"] = std::to_string(few_nodes.nodes);
  v["contact_unsettled"] = std::to_string(unsettled);
  v["contact_scheme_wrong"] = std::to_string(scheme_wrong);
}

/// How many scenes of the corners have an admissible solution, an inadmissible one, a refusal.
std::array<int, 3> survivors(Formulation formulation, double heating) {
  std::array<int, 3> count{};
  for (int decade = -3; decade <= 8; ++decade)
    for (const double share : {1e-12, 0.5, 1 - 1e-12}) {
      const double f = paper::friction;
      const Scene scene{f, std::pow(10, decade), heating};
      const Prescribed given{Quantity::traction, f * share};
      const Outcome found = outcome([&] {
        return solve_coupled(scene, {formulation, 1e-3}, given);
      });
      ++count[static_cast<std::size_t>(found)];
    }
  return count;
}

void survival(std::ostream& out) {
  row(out, "$H$", "corrected: solved", "corrected: no contact", "corrected: refused",
      "printed: solved", "printed: no contact", "printed: refused");
  for (const double heating : {0.01, 1.0, 10.0, 100.0, 1000.0}) {
    const auto [a, b, c] = survivors(Formulation::corrected, heating);
    const auto [d, e, g] = survivors(Formulation::printed, heating);
    row(out, shortest(heating), a, b, c, d, e, g);
  }
}

const FigureData survival_data{"survival", survival};

void ends(std::ostream& out) {
  row(out, "peclet", "fast", "slow");
  const HeatFlux flux = carter_flux(paper::closed_form(0.5));
  const double fast = hottest_when_fast(flux);
  for (const double speed : grid(-3, 8, 33)) {
    const double peclet = std::pow(10, speed);
    const Scene scene{paper::friction, peclet, 0};
    const double top =
        solve_coupled(scene, {Formulation::corrected, 1e-9}, {Quantity::traction, 0.5})
            .value(Quantity::max_temperature);
    row(out, peclet, std::abs(fast / std::sqrt(peclet) / top - 1),
        std::abs(hottest_when_slow(flux, peclet) / top - 1));
  }
}

const FigureData ends_data{"ends", ends};

/// 1 Picard, 2 relaxed by half, 3 Anderson, 4 Newton, 5 Newton with continuation to the solution h.
int first_to_converge(const FluxMap& map, const Eigen::VectorXd& h) {
  const auto finds = [&](auto iterate) {
    Eigen::VectorXd found = carter_start(map);
    return iterate(found) > 0 && (found - h).norm() < 1e-4 * h.norm();
  };
  if (finds([&](Eigen::VectorXd& x) { return picard(map, x); })) return 1;
  if (finds([&](Eigen::VectorXd& x) { return picard(map, x, 0.5); })) return 2;
  if (finds([&](Eigen::VectorXd& x) { return anderson(map, x); })) return 3;
  return finds([&](Eigen::VectorXd& x) { return newton(map, x); }) ? 4 : 5;
}

void iteration_steps(std::ostream& out) {
  row(out, "$\\mathrm{Pe}$", "$fH$", "$\\rho_1$", "Picard", "half steps", "Anderson", "Newton",
      "led");
  const auto cell = [](int steps) { return steps > 0 ? std::to_string(steps) : "–"; };
  for (const double peclet : {1.0, 100.0, paper::peclet})
    for (const double f_h : {0.01, 0.3, 1.0, 3.0, 10.0}) {
      const double heating = f_h / paper::friction, c0 = paper::closed_form(0.5).c0;
      const Scene scene{paper::friction, peclet, 1};
      const FluxMap unit = flux_map(scene, Formulation::corrected, 128, c0);
      const FluxMap map = heated(unit, heating);
      Eigen::VectorXd h = carter_start(map), x = h;
      const int led = follow(unit, 1e-3 / peclet, heating, h);
      const auto steps = [&](auto iterate) {
        x = carter_start(map);
        return cell(iterate());
      };
      row(out, peclet, f_h, fixed(contraction(map, h), 2), steps([&] { return picard(map, x); }),
          steps([&] { return picard(map, x, 0.5); }), steps([&] { return anderson(map, x); }),
          steps([&] { return newton(map, x); }), cell(led));
    }
}

const FigureData steps_data{"iteration-steps", iteration_steps};

/// The solution at one speed, continued in H for as long as it is admissible.
struct Continuation {
  FluxMap unit;
  double heating;
  Eigen::VectorXd h = carter_start(unit);
  bool holds = true;

  bool reaches(double next) {
    holds = holds && follow(unit, heating, next, h) > 0;
    holds = holds && pressure_factor(heated(unit, next), h).minCoeff() > 0;
    heating = next;
    return holds;
  }
};

Continuation continuation_at(double peclet, Formulation formulation, int unknowns) {
  const double c0 = paper::closed_form(0.5).c0;
  return {flux_map({paper::friction, peclet, 1}, formulation, unknowns, c0), 1e-3 / peclet};
}

void iteration(std::ostream& out, Formulation formulation) {
  row(out, "peclet", "strength", "method", "picard", "half", "scheme");
  for (const double speed : grid(-1, 5, 30)) {
    const double peclet = std::pow(10, speed), most = 30 * std::max(1.0, 4 / peclet);
    Continuation path = continuation_at(peclet, formulation, 64);
    for (const double size : grid(0, 6, 30)) {
      const double strength = std::pow(10, size), heating = strength / (paper::friction * peclet);
      int method = 0, scheme = 0;  // not tried
      double full = 0, half = 0;
      if (paper::friction * heating <= most) {
        method = 6;  // not reached
        const Scene scene{paper::friction, peclet, heating};
        scheme = static_cast<int>(end_of_scheme(scene, 0.5, formulation));
        if (path.reaches(heating)) {
          const FluxMap map = heated(path.unit, heating);
          method = first_to_converge(map, path.h);
          full = contraction(map, path.h);
          half = contraction(map, path.h, 0.5);
        }
      }
      row(out, peclet, strength, method, fixed(full, 4), fixed(half, 4), scheme);
    }
  }
}

FigureData iteration_data(const std::string& panel, Formulation formulation) {
  return {"iteration-" + panel, [=](std::ostream& out) { iteration(out, formulation); }};
}

const FigureData iteration_panels[] = {iteration_data("a", Formulation::printed),
                                       iteration_data("b", Formulation::corrected)};

/// The cells of @fig:iteration-a that so many unknowns do not reach; all of them are at Pe > 1000.
int missed(int unknowns) {
  int count = 0;
  for (const double speed : grid(3, 5, 10)) {
    Continuation path = continuation_at(std::pow(10, speed), Formulation::printed, unknowns);
    for (const double size : grid(0, 6, 30)) {
      const double f_h = std::pow(10, size - speed);
      if (f_h <= 30 && !path.reaches(f_h / paper::friction)) ++count;
    }
  }
  return count;
}

void values_on_ways(nlohmann::ordered_json& v) {
  for (const int unknowns : {64, 128, 256})
    v["missed_" + std::to_string(unknowns)] = std::to_string(missed(unknowns));
}

}  // namespace

Outcome outcome(const std::function<CoupledSolution()>& solve) try {
  return solve().violations.empty() ? Outcome::contact : Outcome::no_contact;
} catch (const std::runtime_error&) {
  return Outcome::refused;
}

void values_on_failures(nlohmann::ordered_json& v) {
  values_on_ways(v);
  values_on_contacts(v);
}

}  // namespace thermoroll
