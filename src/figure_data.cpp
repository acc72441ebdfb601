// Tangled from paper/B-data-files.md; edit there.
#include "figure_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "claims.hpp"
#include "kernels.hpp"
#include "numbers.hpp"
#include "paper_case.hpp"
#include "temperature.hpp"

namespace thermoroll {
namespace {

/// Write the cells of one row, separated by commas.
template <class First, class... Rest>
void row(std::ostream& out, const First& first, const Rest&... rest) {
  out << first;
  ((out << ',' << rest), ...);
  out << '\n';
}

/// n + 1 equidistant points from low to high.
std::vector<double> grid(double low, double high, int n) {
  std::vector<double> points;
  for (int i = 0; i <= n; ++i) points.push_back(((n - i) * low + i * high) / n);
  return points;
}

void geometry(std::ostream& out) {
  row(out, "part", "x", "y");
  const double radius = 2, axle = std::sqrt(radius * radius - 1), edge = std::asin(1 / radius);
  for (const double angle : grid(edge, 2 * pi - edge, 180))
    row(out, "cylinder", radius * std::sin(angle), axle - radius * std::cos(angle));
  const double c0 = paper::closed_form(0.5).c0;
  for (const double x : {-4.4, 4.4}) row(out, "half_space", x, 0);
  for (const double x : {-1.0, c0}) row(out, "stick", x, 0);
  for (const double x : {c0, 1.0}) row(out, "slip", x, 0);
}

void kernels(std::ostream& out) {
  row(out, "zeta", "N1", "N2", "M");
  for (const double zeta : grid(-6, 6, 600))
    if (zeta != 0) row(out, zeta, kernel::N1(zeta), kernel::N2(zeta), kernel::M(zeta));
}

void tractions_of_load(std::ostream& out) {
  row(out, "method", "traction", "s", "q");
  for (const double load : paper::tractions) {
    const Carter c = paper::closed_form(load);
    for (const double s : grid(-1, 1, 400)) row(out, "converged", load, s, carter_traction(c, s));
  }
  for (const double load : paper::tractions) {
    const PrintedSolution x = paper::scheme(load, paper::peclet);
    for (const double s : x.grid.t)
      row(out, "printed", load, s, printed_traction(x, paper::friction, s));
  }
}

void slip_of_load(std::ostream& out) {
  row(out, "method", "traction", "s", "v");
  for (const double load : paper::tractions) {
    const Carter c = paper::closed_form(load);
    row(out, "converged", load, -1, 0);
    for (const double u : grid(0, 1, 200)) {  // v starts like a square root: crowd the points there
      const double s = c.c0 + (1 - c.c0) * u * u;
      row(out, "converged", load, s, carter_slip(c, s));
    }
  }
  for (const double load : paper::tractions) {
    const PrintedSolution x = paper::scheme(load, paper::peclet);
    for (int k = 0; k < x.slip.size(); ++k) row(out, "printed", load, x.grid.t(k), x.slip(k));
  }
}

void creep_curve(std::ostream& out) {
  row(out, "method", "creep", "traction");
  for (const double xi : grid(0, 2 * paper::friction / pi, 100))
    row(out, "converged", xi, carter_creep_curve(paper::friction, xi));
  for (const double load : grid(0.05, 0.59, 9))
    row(out, "printed", paper::scheme(load, paper::peclet).creep, load);
}

void temperature_curve(std::ostream& out, double key, double load, double pe) {
  const HeatFlux flux = carter_flux(paper::closed_form(load));
  for (const double s : grid(-1, 3, 400))
    row(out, "converged", key, s, temperature(flux, pe, s).value);
  const PrintedSolution x = paper::scheme(load, pe);
  std::vector<double> points(x.grid.s.begin(), x.grid.s.end());
  std::reverse(points.begin(), points.end());
  for (const double s : grid(1.1, 3, 19)) points.push_back(s);
  for (const double s : points) row(out, "printed", key, s, printed_temperature(x, pe, s));
}

void temperature_by_peclet(std::ostream& out, double load) {
  row(out, "method", "peclet", "s", "T");
  for (const double pe : paper::peclets) temperature_curve(out, pe, load, pe);
}

void temperature_by_load(std::ostream& out) {
  row(out, "method", "traction", "s", "T");
  for (const double load : paper::tractions) temperature_curve(out, load, load, 1000);
}

void subsurface(std::ostream& out) {
  row(out, "s", "y", "T");
  const HeatFlux flux = carter_flux(paper::closed_form(0.5));
  for (const double y : grid(0, 0.5, 40))
    for (const double s : grid(-1.5, 3, 180)) row(out, s, y, temperature(flux, 100, s, y).value);
}

void sliding(std::ostream& out) {
  row(out, "kind", "traction", "s", "T");
  for (const double load : {0.2, 0.5}) {
    const Carter c = paper::closed_form(load);
    for (const double s : grid(-1, 3, 400))
      row(out, "rolling", load, s, temperature(carter_flux(c), 1000, s).value);
    for (const double s : grid(-1, 3, 400))
      row(out, "sliding", load, s, temperature(sliding_flux(carter_heat(c)), 1000, s).value);
  }
}

void resolution(std::ostream& out) {
  row(out, "$n$", "$c_0$", "$1-\\kappa$", "$\\gamma_0$", "$T^*_{\\max}$", "outer", "inner");
  for (const int nodes : {50, 100, 200, 400}) {
    const PrintedSolution x = paper::scheme(0.5, paper::peclet, {nodes});
    const double top = printed_max_temperature(x, paper::peclet).temperature;
    row(out, nodes, fixed(x.c0, 6), scientific(1 - x.load_ratio, 2), scientific(x.gamma0, 2),
        fixed(top, 6), x.outer_iterations, x.inner_iterations);
  }
  const CoupledSolution x = paper::coupled(0.5, paper::peclet);
  row(out, "**coupled**", fixed(x.value(border), 6), scientific(1 - x.value(load_ratio), 2),
      scientific(x.value(gamma0), 2), fixed(x.value(hottest), 6), "–", "–");
}

void coincident(std::ostream& out) {
  row(out, "$\\Theta(0)$", "$T^*_{\\max}$", "outer steps");
  for (const double value : {0.0, 0.5, 1.0}) {
    PrintedOptions options;
    options.heaviside_at_zero = value;
    const PrintedSolution x = paper::scheme(0.5, 5000, options);
    row(out, value, fixed(printed_max_temperature(x, 5000).temperature, 6), x.outer_iterations);
  }
}

const std::pair<std::string, std::string> symbols[] = {
    {"T*max", "$T^*_{\\max}$"},
    {"|q| < f p", "$|q|<fp$"},
    {"1 − κ", "$1-\\kappa$"},
    {"γ0", "$\\gamma_0$"},
    {"Pe", "$\\mathrm{Pe}$"},
    {" n ", " $n$ "},
    {" H ", " $H$ "},
    {"Q*", "$Q^*$"},
    {"T*", "$T^*$"},
    {"v*", "$v^*$"},
    {"c0", "$c_0$"},
};

std::string in_tex(std::string text) {
  for (const auto& [plain, tex] : symbols)
    for (std::size_t at = 0; (at = text.find(plain, at)) != text.npos; at += tex.size())
      text.replace(at, plain.size(), tex);
  return text;
}

void claims_table(std::ostream& out) {
  row(out, "the paper says", "paper", "published scheme", "converged", "verdict");
  const auto cell = [](const std::string& text) { return '"' + in_tex(text) + '"'; };
  for (const Claim& c : claims())
    row(out, cell(c.claim), cell(c.paper), cell(c.printed), cell(c.converged), cell(c.verdict));
}

void values(std::ostream& out) {
  nlohmann::ordered_json v;
  const PhysicalCase steel = wheel_on_rail();
  const CoupledSolution contact = paper::coupled(0.5, paper::peclet);
  const Scene groups = scene_of(steel, paper::friction, 0.5);
  const double compliance = 4 * (1 - steel.poisson) * steel.load / (pi * steel.shear_modulus);
  v["hertz_p0"] = fixed(2 / pi * units_of(steel, paper::friction).traction / 1e9, 2);
  v["steel_peclet"] = fixed(groups.peclet, 0);
  v["steel_heating"] = fixed(groups.heating, 4);
  v["steel_radius"] = fixed(steel.half_width * steel.half_width / compliance, 3);
  const Carter cold = paper::closed_form(0.5);
  v["steel_creep"] = fixed(contact.value(creep), 4);
  v["steel_creep_difference"] = fixed(paper::friction * std::abs(contact.value(gamma0)), 4);
  v["steel_eccentricity"] = fixed(std::abs(contact.eccentricity), 4);
  v["steel_border_shift"] = fixed(std::abs(contact.value(border) - cold.c0), 4);
  v["steel_creep_change"] =
      fixed(100 * std::abs(contact.value(creep_constant) / cold.creep - 1), 1);
  const Peak top = max_temperature(carter_flux(cold), 5000);
  const double top_printed = paper::scheme_max(0.5, 5000);
  const double top_coupled = paper::coupled(0.5, 5000).value(hottest);
  v["tmax_5000"] = fixed(top.temperature.value, 7);
  v["tmax_5000_at"] = fixed(top.at, 4);
  v["tmax_5000_coupled"] = fixed(top_coupled, 5);
  v["tmax_5000_printed"] = fixed(top_printed, 6);
  v["tmax_5000_error"] = fixed(100 * (1 - top_printed / top_coupled), 1);
  v["sliding_ratio_02"] = fixed(rolling_to_sliding(0.2), 1);
  v["sliding_ratio_059"] = fixed(rolling_to_sliding(0.59), 1);
  for (const int pe : {5000, 10000, 15000}) {
    const double rise = paper::coupled(0.5, pe).value(hottest) * celsius_per_unit_at(pe);
    v["celsius_" + std::to_string(pe)] = fixed(rise, 0);
    v["celsius_" + std::to_string(pe) + "_rounded"] = fixed(rise * (pe / 200.0) / speed_at(pe), 0);
  }
  PhysicalCase rounded = steel;
  rounded.speed = 25;
  v["celsius_of_the_paper"] = fixed(0.002 * units_of(rounded, paper::friction).temperature, 0);
  v["celsius_ratio"] = fixed(420.0 / 272, 2);
  v["speed_difference"] = fixed(100 * (speed_at(5000) / 25 - 1), 1);
  const auto rule_error = [&](int nodes) {
    const double found = paper::scheme_max(0.5, paper::peclet, {nodes});
    return fixed(100 * (1 - found / contact.value(hottest)), 1);
  };
  v["rule_error_50"] = rule_error(50);
  v["rule_error_200"] = rule_error(200);
  v["node_distance"] = fixed(pi / 200, 3);
  v["layer"] = fixed(1 / paper::peclet, 5);
  v["layers_per_node"] = fixed(pi / 200 * paper::peclet, 0);
  v["layer_thinner"] = fixed(std::sqrt(paper::peclet / 100), 1);
  const auto loss = [](int nodes) {
    return 1 - paper::scheme(0.5, paper::peclet, {nodes}).load_ratio;
  };
  const double kappa_coupled = 1 - contact.value(load_ratio);
  double largest = 0;
  for (const double q : paper::tractions)
    largest = std::max(largest, 1 - paper::coupled(q, paper::peclet).value(load_ratio));
  v["kappa_printed"] = fixed(loss(200), 5);
  v["kappa_coupled"] = fixed(kappa_coupled, 5);
  v["kappa_coupled_largest"] = fixed(largest, 4);
  v["kappa_ratio"] = fixed(kappa_coupled / loss(200), 0);
  v["kappa_growth"] = fixed(std::cbrt(loss(400) / loss(50)), 1);
  v["kappa_seen_400"] = fixed(100 * loss(400) / kappa_coupled, 0);
  const double kappa_first = first_order_load_change(0.5), gamma_first = first_order_gamma0(0.5);
  v["gamma_coupled"] = fixed(contact.value(gamma0), 5);
  v["gamma_first_order"] = fixed(gamma_first, 5);
  v["gamma_first_order_error"] = fixed(100 * (gamma_first / contact.value(gamma0) - 1), 0);
  v["kappa_first_order"] = fixed(kappa_first, 5);
  v["kappa_first_order_error"] = fixed(100 * (kappa_first / kappa_coupled - 1), 0);
  PrintedOptions other;
  other.heaviside_at_zero = 1;
  v["coincident_change"] = fixed(100 * (paper::scheme_max(0.5, 5000, other) / top_printed - 1), 0);
  const Record record = scheme_record();
  v["most_inner"] = std::to_string(record.inner);
  v["most_outer"] = std::to_string(record.outer);
  v["largest_error_50"] = fixed(record.coarse_error, 1);
  v["largest_error_200"] = fixed(record.fine_error, 1);
  const auto semi_axis = [&](double force) { return 3 * force / (4 * steel.load); };
  v["ellipse_as_printed"] = fixed(semi_axis(1.47e7), 2);
  v["ellipse_mended"] = fixed(1000 * semi_axis(1.47e5), 0);
  out << v.dump(2) << '\n';
}

using Writer = std::function<void(std::ostream&)>;

const std::vector<std::pair<std::string, Writer>>& writers() {
  const auto of_load = [](double load) {
    return [=](std::ostream& out) { temperature_by_peclet(out, load); };
  };
  static const std::vector<std::pair<std::string, Writer>> table{
      {"geometry", geometry},
      {"kernels", kernels},
      {"traction", tractions_of_load},
      {"slip", slip_of_load},
      {"temperature-a", of_load(0.2)},
      {"temperature-b", of_load(0.4)},
      {"temperature-c", of_load(0.5)},
      {"temperature-d", of_load(0.59)},
      {"temperature-load", temperature_by_load},
      {"subsurface", subsurface},
      {"sliding", sliding},
      {"creep", creep_curve},
      {"resolution", resolution},
      {"coincident", coincident},
      {"claims", claims_table},
      {"values", values},
  };
  return table;
}

}  // namespace

std::vector<std::string> figure_data_names() {
  std::vector<std::string> names;
  for (const auto& [name, write] : writers()) names.push_back(name);
  return names;
}

void write_figure_data(const std::string& name, std::ostream& out) {
  for (const auto& [known, write] : writers())
    if (name == known) {
      out << std::setprecision(10);
      write(out);
      return;
    }
  throw std::invalid_argument("figure-data: unknown name " + name);
}

}  // namespace thermoroll
