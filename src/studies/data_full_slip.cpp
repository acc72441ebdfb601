// Tangled from paper/20-full-slip.md; edit there.
#include <cmath>

#include <nlohmann/json.hpp>

#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/solution.hpp"

namespace thermoroll {
namespace {

Solution at_creep(double heating, double creep, double peclet = 100) {
  const Approach coupled{Formulation::corrected, 1e-5, Method::coupled};
  return solve({paper::friction, peclet, heating}, {Quantity::creep, creep}, coupled);
}

double load_ratio_at(double heating, double creep, double peclet = 100) {
  return at_creep(heating, creep, peclet).value(Quantity::load_ratio);
}

void tractions_in_full_slip(std::ostream& out) {
  row(out, "creep", "without", "half", "one");
  for (const double creep : grid(-0.7, 0.7, 70)) {
    const auto traction = [&](double heating) {
      return creep == 0 ? 0 : at_creep(heating, creep).value(Quantity::traction);
    };
    row(out, creep, traction(0), traction(0.5), traction(1));
  }
}

const FigureData full_slip_a_data{"full-slip-a", tractions_in_full_slip};

double fast_gross_sliding(double heating, double slip) {
  const double theta = std::atan(paper::friction * heating * std::abs(slip)) / pi;
  return 1 / (1 - 4 * theta * theta);
}

void load_ratio_in_full_slip(std::ostream& out) {
  row(out, "creep", "half", "one", "limit_half", "limit_one");
  for (const double x : grid(-2, 2, 40)) {
    const double creep = x * std::abs(x);  // closer where there is a stick zone
    const auto ratio = [&](double heating) {
      return creep == 0 ? 1 : load_ratio_at(heating, creep);
    };
    row(out, creep, ratio(0.5), ratio(1), fast_gross_sliding(0.5, creep),
        fast_gross_sliding(1, creep));
  }
}

const FigureData full_slip_b_data{"full-slip-b", load_ratio_in_full_slip};

double end_of_stick(Direction direction) {
  const Scene scene{paper::friction, 100, 1, {}, direction};
  const Approach coupled{Formulation::corrected, 1e-5, Method::coupled};
  const Solution x = solve(scene, {Quantity::stick_slip_border, -1 + 1e-6}, coupled);
  return std::abs(x.value(Quantity::creep));
}

}  // namespace

void values_on_full_slip(nlohmann::ordered_json& v) {
  const auto off = [](double creep, double peclet) {
    return fixed(100 * (1 - load_ratio_at(1, creep, peclet) / fast_gross_sliding(1, creep)), 0);
  };
  v["full_slip_cold"] = fixed(2 * paper::friction / pi, 3);
  v["full_slip_driving"] = fixed(end_of_stick(Direction::driving), 3);
  v["full_slip_braking"] = fixed(end_of_stick(Direction::braking), 3);
  v["full_slip_above"] = off(4, 100);
  v["full_slip_braked_above"] = off(-4, 100);
  v["full_slip_faster"] = off(4, 1e4);
}

}  // namespace thermoroll
