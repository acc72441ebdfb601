// Tangled from paper/F-data-files.md; edit there.
#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "studies/claims.hpp"
#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {
namespace {

void values_of_steel(nlohmann::ordered_json& v) {
  const PhysicalScene steel = wheel_on_rail();
  v["steel_load"] = scientific(steel.load, 2);
  v["steel_speed"] = shortest(steel.speed);
  v["steel_half_width"] = scientific(steel.half_width, 2);
  v["steel_shear_modulus"] = scientific(steel.shear_modulus, 2);
  v["steel_poisson"] = shortest(steel.poisson);
  v["steel_expansion"] = scientific(steel.expansion, 2);
  v["steel_diffusivity"] = scientific(steel.diffusivity, 2);
  v["steel_conductivity"] = shortest(steel.conductivity);
  v["steel_friction"] = shortest(paper::friction);
  const Scene groups = scene_of(steel, paper::friction);
  const double compliance = 4 * (1 - steel.poisson) * steel.load / (pi * steel.shear_modulus);
  v["hertz_p0"] = fixed(2 / pi * units_of(steel, paper::friction).traction / 1e9, 2);
  v["steel_peclet"] = fixed(groups.peclet, 0);
  v["steel_heating"] = fixed(groups.heating, 4);
  v["steel_radius"] = fixed(steel.half_width * steel.half_width / compliance, 3);
}

CoupledSolution corrected(double q) {
  return paper::coupled(q, paper::peclet, Formulation::corrected);
}

void values_with_heat(nlohmann::ordered_json& v) {
  const Carter cold = paper::closed_form(0.5);
  const CoupledSolution printed = paper::coupled(0.5, paper::peclet), other = corrected(0.5);
  v["steel_creep"] = fixed(printed.value(Quantity::creep), 4);
  v["steel_creep_difference"] =
      fixed(paper::friction * std::abs(printed.value(Quantity::gamma0)), 4);
  v["steel_eccentricity"] = fixed(std::abs(printed.value(Quantity::eccentricity)), 4);
  v["corrected_kappa"] = fixed(1 - other.value(Quantity::load_ratio), 5);
  for (const auto& [name, x] : {std::pair{"steel", printed}, {"corrected", other}}) {
    const auto change = [&, &x = x](Quantity what) {
      return fixed(100 * std::abs(x.value(what) / cold.creep - 1), 2);
    };
    v[std::string(name) + "_border"] = fixed(x.value(Quantity::stick_slip_border), 4);
    v[std::string(name) + "_constant_change"] = change(Quantity::creep_constant);
    v[std::string(name) + "_creep_change"] = change(Quantity::creep);
  }
}

void values_of_the_largest_temperature(nlohmann::ordered_json& v) {
  const Peak top = hottest_point(carter_flux(paper::closed_form(0.5)), 5000);
  const double printed = paper::scheme_max(0.5, 5000);
  const double coupled = paper::coupled(0.5, 5000).value(Quantity::max_temperature);
  v["tmax_5000"] = fixed(top.temperature.value, 7);
  v["tmax_5000_at"] = fixed(top.at, 4);
  v["tmax_5000_coupled"] = fixed(coupled, 5);
  v["tmax_5000_printed"] = fixed(printed, 6);
  v["tmax_5000_error"] = fixed(100 * (1 - printed / coupled), 1);
  v["sliding_ratio_02"] = fixed(rolling_to_sliding(0.2), 1);
  v["sliding_ratio_059"] = fixed(rolling_to_sliding(0.59), 1);
}

void values_in_degrees(nlohmann::ordered_json& v) {
  for (const int pe : {5000, 10000, 15000}) {
    const double hot = paper::coupled(0.5, pe).value(Quantity::max_temperature);
    v["celsius_" + std::to_string(pe)] = fixed(hot * celsius_per_unit_at(pe), 0);
    v["celsius_" + std::to_string(pe) + "_rounded"] = fixed(hot * celsius_per_unit(pe / 200.0), 0);
  }
  v["celsius_of_the_paper"] = fixed(0.002 * celsius_per_unit(25), 0);
  v["celsius_ratio"] = fixed(490.0 / 420, 3);
  v["celsius_root"] = fixed(std::sqrt(1.5), 3);
  v["speed_difference"] = fixed(100 * (speed_at(5000) / 25 - 1), 1);
}

void values_of_the_nodes(nlohmann::ordered_json& v) {
  const double exact = paper::coupled(0.5, paper::peclet).value(Quantity::max_temperature);
  const auto rule_error = [&](int nodes) {
    return fixed(100 * (1 - paper::scheme_max(0.5, paper::peclet, {nodes}) / exact), 1);
  };
  v["rule_error_50"] = rule_error(50);
  v["rule_error_200"] = rule_error(200);
  v["node_distance"] = fixed(pi / 200, 3);
  v["layer"] = fixed(1 / paper::peclet, 5);
  v["layers_per_node"] = fixed(pi / 200 * paper::peclet, 0);
  v["layer_thinner"] = fixed(std::sqrt(paper::peclet / 100), 1);
}

void values_of_the_load_ratio(nlohmann::ordered_json& v) {
  const auto loss = [](int nodes) {
    return 1 - paper::scheme(0.5, paper::peclet, {nodes}).load_ratio;
  };
  const double kappa_coupled = 1 - paper::coupled(0.5, paper::peclet).value(Quantity::load_ratio);
  double largest = 0, largest_corrected = 0;
  for (const double q : paper::tractions) {
    largest = std::max(largest, 1 - paper::coupled(q, paper::peclet).value(Quantity::load_ratio));
    largest_corrected = std::max(largest_corrected, corrected(q).value(Quantity::load_ratio) - 1);
  }
  v["kappa_printed"] = fixed(loss(200), 5);
  v["kappa_coupled"] = fixed(kappa_coupled, 5);
  v["kappa_coupled_largest"] = fixed(largest, 4);
  v["kappa_corrected_largest"] = fixed(largest_corrected, 4);
  v["kappa_ratio"] = fixed(kappa_coupled / loss(200), 0);
  v["kappa_growth_50"] = fixed(loss(100) / loss(50), 2);
  v["kappa_growth_200"] = fixed(loss(400) / loss(200), 2);
  v["kappa_seen_400"] = fixed(100 * loss(400) / kappa_coupled, 0);
}

void values_to_first_order(nlohmann::ordered_json& v) {
  const CoupledSolution x = paper::coupled(0.5, paper::peclet);
  const double kappa = 1 - x.value(Quantity::load_ratio),
               kappa_first = first_order_load_change(0.5);
  const double gamma = x.value(Quantity::gamma0), gamma_first = first_order_gamma0(0.5);
  v["gamma_coupled"] = fixed(gamma, 5);
  v["gamma_first_order"] = fixed(gamma_first, 5);
  v["gamma_first_order_error"] = fixed(100 * (gamma_first / gamma - 1), 0);
  v["kappa_first_order"] = fixed(kappa_first, 5);
  v["kappa_first_order_error"] = fixed(100 * (kappa_first / kappa - 1), 0);
}

void values_of_the_claims(nlohmann::ordered_json& v) {
  const std::vector<Claim> all = claims();
  v["claims_all"] = std::to_string(all.size());
  const int restricted = count_of(all, Judgement::restricted);
  v["claims_hold"] = std::to_string(count_of(all, Judgement::holds) + restricted);
  v["claims_restricted"] = std::to_string(restricted);
  v["claims_near"] = std::to_string(count_of(all, Judgement::near));
  v["claims_not_reproduced"] = std::to_string(count_of(all, Judgement::not_reproduced));
  v["claims_fail"] = std::to_string(count_of(all, Judgement::fails));
  v["claims_extended"] = std::to_string(count_of(all, Judgement::extended));
  v["claims_untestable"] = std::to_string(count_of(all, Judgement::untestable));
  const PhysicalScene steel = wheel_on_rail();
  const double peclet_at_75 = 75 * steel.half_width / (2 * steel.diffusivity);
  const double hottest = paper::coupled(0.59, peclet_at_75).value(Quantity::max_temperature);
  v["celsius_largest"] = fixed(hottest * celsius_per_unit(75), 0);
  const Profile hot = profile(corrected(0.5));
  const Carter cold = paper::closed_form(0.5);
  const auto without = hot.s.unaryExpr([&](double s) { return carter_traction(cold, s); });
  const double largest = (hot.traction - without).abs().maxCoeff();
  v["largest_traction_change"] = fixed(100 * largest / (2 * paper::friction / pi), 1);
  v["transit_time"] = fixed(1000 * steel.half_width / steel.speed, 2);
  v["contraction_35"] = fixed(std::pow(1e-3, 1 / 35.0), 2);
}

void values_of_what_is_open(nlohmann::ordered_json& v) {
  PublishedOptions other;
  other.heaviside_at_zero = 1;
  const double change = paper::scheme_max(0.5, 5000, other) / paper::scheme_max(0.5, 5000) - 1;
  const Record record = scheme_record();
  const double load = wheel_on_rail().load;
  const auto semi_axis = [&](double force) { return 3 * force / (4 * load); };
  v["coincident_change"] = fixed(100 * change, 0);
  v["most_inner"] = std::to_string(record.inner);
  v["most_outer"] = std::to_string(record.outer);
  v["largest_error_200"] = fixed(record.fine_error, 1);
  v["ellipse_as_printed"] = fixed(semi_axis(1.47e7), 2);
  v["ellipse_mended"] = fixed(1000 * semi_axis(1.47e5), 0);
}

void values(std::ostream& out) {
  nlohmann::ordered_json v;
  for (const auto add :
       {values_of_steel, values_with_heat, values_of_the_largest_temperature, values_in_degrees,
        values_of_the_nodes, values_of_the_load_ratio, values_to_first_order,
        values_of_what_is_open, values_on_resolution, values_on_digits, values_on_failures,
        values_on_least_model, values_on_what_heat_can_do, values_on_two_bodies,
        values_on_full_slip, values_on_hot_friction, values_on_strips, values_of_the_claims,
        values_in_brief})
    add(v);
  out << v.dump(2) << '\n';
}

const FigureData values_data{"values", values};

}  // namespace
}  // namespace thermoroll
