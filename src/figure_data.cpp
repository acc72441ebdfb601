// Tangled from paper/B-data-files.md; edit there.
#include "figure_data.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <regex>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "carter.hpp"
#include "claims.hpp"
#include "coupled.hpp"
#include "kernels.hpp"
#include "numbers.hpp"
#include "printed_scheme.hpp"
#include "scene.hpp"
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

constexpr double friction = 0.6;
constexpr double tractions[] = {0.2, 0.4, 0.5, 0.59};
constexpr double peclets[] = {100, 500, 1000, 5000};
constexpr double heating = 0.0175;
constexpr double peclet = 4360;

PrintedSolution printed(double load, double pe, const PrintedOptions& options = {}) {
  return solve_printed({friction, load, pe, heating}, Formulation::printed, options);
}

/// The coupled solution with the sign as printed, to 1e-8.
CoupledSolution coupled(double load, double pe) {
  return solve_coupled({friction, load, pe, heating}, Formulation::printed, 1e-8, {traction, load});
}

void geometry(std::ostream& out) {
  row(out, "part", "x", "y");
  const double radius = 2, axle = std::sqrt(radius * radius - 1), edge = std::asin(1 / radius);
  for (const double angle : grid(edge, 2 * pi - edge, 180))
    row(out, "cylinder", radius * std::sin(angle), axle - radius * std::cos(angle));
  const double c0 = carter(friction, 0.5).c0;
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
  for (const double load : tractions) {
    const Carter c = carter(friction, load);
    for (const double s : grid(-1, 1, 400)) row(out, "converged", load, s, carter_traction(c, s));
  }
  for (const double load : tractions) {
    const PrintedSolution x = printed(load, peclet);
    for (const double s : x.grid.t) row(out, "printed", load, s, printed_traction(x, friction, s));
  }
}

void slip_of_load(std::ostream& out) {
  row(out, "method", "traction", "s", "v");
  for (const double load : tractions) {
    const Carter c = carter(friction, load);
    row(out, "converged", load, -1, 0);
    for (const double u : grid(0, 1, 200)) {  // v starts like a square root: crowd the points there
      const double s = c.c0 + (1 - c.c0) * u * u;
      row(out, "converged", load, s, carter_slip(c, s));
    }
  }
  for (const double load : tractions) {
    const PrintedSolution x = printed(load, peclet);
    for (int k = 0; k < x.slip.size(); ++k) row(out, "printed", load, x.grid.t(k), x.slip(k));
  }
}

void creep_curve(std::ostream& out) {
  row(out, "method", "creep", "traction");
  for (const double xi : grid(0, 2 * friction / pi, 100))
    row(out, "converged", xi, carter_creep_curve(friction, xi));
  for (const double load : grid(0.05, 0.59, 9))
    row(out, "printed", printed(load, peclet).creep, load);
}

void temperature_curve(std::ostream& out, double key, double load, double pe) {
  const HeatFlux flux = carter_flux(carter(friction, load));
  for (const double s : grid(-1, 3, 400))
    row(out, "converged", key, s, temperature(flux, pe, s).value);
  const PrintedSolution x = printed(load, pe);
  std::vector<double> points(x.grid.s.begin(), x.grid.s.end());
  std::reverse(points.begin(), points.end());
  for (const double s : grid(1.1, 3, 19)) points.push_back(s);
  for (const double s : points) row(out, "printed", key, s, printed_temperature(x, pe, s));
}

void temperature_by_peclet(std::ostream& out, double load) {
  row(out, "method", "peclet", "s", "T");
  for (const double pe : peclets) temperature_curve(out, pe, load, pe);
}

void temperature_by_load(std::ostream& out) {
  row(out, "method", "traction", "s", "T");
  for (const double load : tractions) temperature_curve(out, load, load, 1000);
}

void subsurface(std::ostream& out) {
  row(out, "s", "y", "T");
  const HeatFlux flux = carter_flux(carter(friction, 0.5));
  for (const double y : grid(0, 0.5, 40))
    for (const double s : grid(-1.5, 3, 180)) row(out, s, y, temperature(flux, 100, s, y).value);
}

void sliding(std::ostream& out) {
  row(out, "kind", "traction", "s", "T");
  for (const double load : {0.2, 0.5}) {
    const Carter c = carter(friction, load);
    for (const double s : grid(-1, 3, 400))
      row(out, "rolling", load, s, temperature(carter_flux(c), 1000, s).value);
    for (const double s : grid(-1, 3, 400))
      row(out, "sliding", load, s, temperature(sliding_flux(carter_heat(c)), 1000, s).value);
  }
}

void resolution(std::ostream& out) {
  row(out, "$n$", "$c_0$", "$1-\\kappa$", "$\\gamma_0$", "$T^*_{\\max}$", "outer", "inner");
  for (const int nodes : {50, 100, 200, 400}) {
    PrintedOptions options;
    options.nodes = nodes;
    const PrintedSolution x = printed(0.5, peclet, options);
    const double hottest = printed_max_temperature(x, peclet).temperature;
    row(out, nodes, fixed(x.c0, 6), scientific(1 - x.load_ratio, 2), scientific(x.gamma0, 2),
        fixed(hottest, 6), x.outer_iterations, x.inner_iterations);
  }
  const Values x = coupled(0.5, peclet).value;
  row(out, "coupled", fixed(x(border), 6), scientific(1 - x(load_ratio), 2),
      scientific(x(gamma0), 2), fixed(x(hottest), 6), "–", "–");
}

void coincident(std::ostream& out) {
  row(out, "$\\Theta(0)$", "$T^*_{\\max}$", "outer steps");
  for (const double value : {0.0, 0.5, 1.0}) {
    PrintedOptions options;
    options.heaviside_at_zero = value;
    const PrintedSolution x = printed(0.5, 5000, options);
    row(out, value, fixed(printed_max_temperature(x, 5000).temperature, 6), x.outer_iterations);
  }
}

void claims_table(std::ostream& out) {
  row(out, "the paper says", "paper", "published scheme", "converged", "verdict");
  const auto quoted = [](const std::string& text) {  // an asterisk is Markdown's, too
    return '"' + std::regex_replace(text, std::regex("\\*"), "\\*") + '"';
  };
  for (const Claim& c : claims())
    row(out, quoted(c.claim), quoted(c.paper), quoted(c.printed), quoted(c.converged),
        quoted(c.verdict));
}

void values(std::ostream& out) {
  nlohmann::ordered_json v;
  const PhysicalCase steel = wheel_on_rail();
  const Scene scene = scene_of(steel, friction, 0.5);
  v["hertz_p0"] = fixed(2 / pi * units_of(steel, friction).traction / 1e9, 2);
  v["steel_peclet"] = fixed(scene.peclet, 0);
  v["steel_heating"] = fixed(scene.heating, 4);
  const double compliance = 4 * (1 - steel.poisson) * steel.load / (pi * steel.shear_modulus);
  v["steel_radius"] = fixed(steel.half_width * steel.half_width / compliance, 3);
  const CoupledSolution contact = coupled(0.5, peclet);
  v["steel_creep"] = fixed(contact.value(creep), 4);
  v["steel_creep_difference"] = fixed(friction * std::abs(contact.value(gamma0)), 4);
  v["steel_eccentricity"] = fixed(std::abs(contact.eccentricity), 4);
  v["steel_border_shift"] = fixed(std::abs(contact.value(border) - carter(friction, 0.5).c0), 4);
  v["steel_creep_change"] =
      fixed(100 * std::abs(contact.value(creep_constant) / carter(friction, 0.5).creep - 1), 1);
  const HeatFlux half = carter_flux(carter(friction, 0.5));
  const Peak top = max_temperature(half, 5000);
  const double top_printed = printed_max_temperature(printed(0.5, 5000), 5000).temperature;
  v["tmax_5000"] = fixed(top.temperature.value, 7);
  v["tmax_5000_at"] = fixed(top.at, 4);
  v["tmax_5000_coupled"] = fixed(coupled(0.5, 5000).value(hottest), 5);
  v["tmax_5000_printed"] = fixed(top_printed, 6);
  v["tmax_5000_error"] = fixed(100 * (1 - top_printed / coupled(0.5, 5000).value(hottest)), 1);
  for (const int pe : {5000, 10000, 15000}) {
    const double rise = coupled(0.5, pe).value(hottest) * celsius_at(pe);
    const double at_round_speed =
        rise * (pe / 200.0) / (2 * steel.diffusivity * pe / steel.half_width);
    v["celsius_" + std::to_string(pe)] = fixed(rise, 0);
    v["celsius_" + std::to_string(pe) + "_rounded"] = fixed(at_round_speed, 0);
  }
  v["celsius_ratio"] = fixed(420.0 / 272, 2);
  v["sliding_ratio_02"] = fixed(rolling_to_sliding(0.2), 1);
  v["sliding_ratio_059"] = fixed(rolling_to_sliding(0.59), 1);
  const double kappa_printed = 1 - printed(0.5, peclet).load_ratio;
  const double kappa_coupled = 1 - contact.value(load_ratio);
  v["node_distance"] = fixed(pi / 200, 3);
  v["layer"] = fixed(1 / peclet, 5);
  v["layers_per_node"] = fixed(pi / 200 * peclet, 0);
  v["kappa_printed"] = fixed(kappa_printed, 5);
  v["kappa_coupled"] = fixed(kappa_coupled, 5);
  v["kappa_coupled_largest"] = fixed(1 - coupled(0.59, peclet).value(load_ratio), 4);
  v["kappa_first_order"] = fixed(first_order_load_change(0.5), 4);
  v["kappa_ratio"] = fixed(kappa_coupled / kappa_printed, 0);
  v["gamma_coupled"] = fixed(contact.value(gamma0), 5);
  v["gamma_first_order"] = fixed(first_order_gamma0(0.5), 4);
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
      {"values", values}};
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
