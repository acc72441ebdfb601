// Tangled from paper/F-data-files.md; edit there.
#include <algorithm>
#include <cmath>
#include <utility>

#include "studies/claims.hpp"
#include "studies/comparison.hpp"
#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/temperature.hpp"

namespace thermoroll {
namespace {

double drawn(double temperature) { return std::abs(temperature) < 1e-12 ? 0 : temperature; }

void temperature_curve(std::ostream& out, double load, double pe) {
  const HeatFlux flux = coupled_flux(paper::coupled(load, pe, Formulation::corrected));
  for (const double s : grid(-1, 3, 200))
    row(out, "corrected", load, pe, s, drawn(temperature(flux, pe, s).value));
  const PublishedSolution x = paper::scheme(load, pe);
  std::vector<double> points(x.grid.s.begin(), x.grid.s.end());
  std::reverse(points.begin(), points.end());
  for (const double s : grid(1.1, 3, 19)) points.push_back(s);
  for (const double s : points)
    row(out, "scheme", load, pe, s, drawn(published_temperature(x, pe, s)));
}

void temperature_by_peclet(std::ostream& out) {
  row(out, "method", "traction", "peclet", "s", "T");
  for (const double load : paper::tractions)
    for (const double pe : paper::peclets) temperature_curve(out, load, pe);
}

const FigureData temperatures_data{"temperatures", temperature_by_peclet};

void temperature_by_load(std::ostream& out) {
  row(out, "method", "traction", "peclet", "s", "T");
  for (const double load : paper::tractions) temperature_curve(out, load, 1000);
}

const FigureData temperature_load_data{"temperature-load", temperature_by_load};

void subsurface(std::ostream& out) {
  row(out, "s", "y", "T");
  const HeatFlux flux = coupled_flux(paper::coupled(0.5, 100, Formulation::corrected));
  for (const double y : grid(0, 0.5, 25))
    for (const double s : grid(-1.48, 3, 112))
      row(out, s, y, drawn(temperature(flux, 100, s, y).value));
}

const FigureData subsurface_data{"subsurface", subsurface};

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

const FigureData sliding_data{"sliding", sliding};

void celsius_of_speed(std::ostream& out) {
  row(out, "kind", "speed", "celsius");
  for (const double pe : grid(1000, 17000, 32))
    row(out, "converged", speed_at(pe),
        celsius_per_unit_at(pe) * paper::coupled(0.5, pe).value(Quantity::max_temperature));
  for (const double u : grid(0, 1, 44)) row(out, "law", 88 * u * u, 272 * std::sqrt(88.0 / 25) * u);
  for (const double pe : {5000.0, 10000.0, 15000.0})
    row(out, "scheme", speed_at(pe), celsius_per_unit_at(pe) * paper::scheme_max(0.5, pe));
  for (const auto& [speed, celsius] : {std::pair{25, 272}, {50, 420}, {75, 490}})
    row(out, "paper", speed, celsius);
}

const FigureData celsius_data{"celsius", celsius_of_speed};

void bands(std::ostream& out) {
  row(out, "band", "$\\mathrm{Pe}$", "known", "here");
  const HeatFlux uniform{-1, 1, [](double, double) { return 1; }};
  for (const double pe : {0.1, 1.0, 10.0, 100.0, 5000.0}) {
    const Peak top = hottest_point(uniform, pe);
    row(out, "uniform", pe, fixed(jaeger_band(pe, top.at), 9), fixed(top.temperature.value, 9));
  }
  row(out, "semi-elliptic", "∞", "1.11", fixed(blok_factor(1e8), 4));
}

const FigureData bands_data{"bands", bands};

}  // namespace
}  // namespace thermoroll
