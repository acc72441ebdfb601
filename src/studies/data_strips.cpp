// Tangled from paper/21-hot-friction.md; edit there.
#include <algorithm>
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "studies/data.hpp"
#include "studies/strips.hpp"
#include "support/number_text.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {
namespace {

struct Published {
  const char* name;
  EllipticContact contact;
  double change, over;  // of the coefficient of friction, over so many degrees
  OnEllipse printed;
  Cells cells;
};

/// Hertz's ellipse of the locomotive: 106.7 kN, 640.7 MPa, half as long as it is wide.
const double euro = std::sqrt(0.5 * 3 * 106700 / (2 * pi * 640.7e6));
const EllipticContact ertz_wheel{5.88e-3, 10.54e-3, 770.41e6, 30, 0.0296, 0.0370, 0.3};
const EllipticContact locomotive{euro, 2 * euro, 640.7e6, 10, 0.25, 0.25, 0.33};
const Cells ertz_cells{24, 58.8, 2}, euro_cells{20, 40, 2};  // of 0.2 mm; of a twentieth of a

const Published published[] = {
    {"Ertz: constant", ertz_wheel, 0, 1, {1, 166.8}, ertz_cells},
    {"Ertz: −0.18 over 400 K", ertz_wheel, -0.18, 400, {0.8660, 137.5}, ertz_cells},
    {"Ertz: +0.18 over 400 K", ertz_wheel, 0.18, 400, {1.178, 208.9}, ertz_cells},
    {"locomotive: constant", locomotive, 0, 1, {1, 688.0}, euro_cells},
    {"locomotive: +0.19 over 1200 K", locomotive, 0.19, 1200, {1.262, 939.7}, euro_cells},
    {"locomotive: −0.19 over 1200 K", locomotive, -0.19, 1200, {0.8257, 535.1}, euro_cells},
    {"locomotive: −0.19 over 400 K", locomotive, -0.19, 400, {0.6108, 364.7}, euro_cells}};

FrictionLaw law_of(const Published& x) {
  return piecewise_linear_friction({x.over, 1 + x.change / x.contact.friction});
}

void published_cases(std::ostream& out) {
  row(out, "case", "$F_x/\\mu F_n$ printed", "its rule", "converged", "°C printed", "by its rule",
      "°C converged");
  for (const Published& x : published) {
    const OnEllipse rule = on_ellipse(x.contact, law_of(x), x.cells);
    const OnEllipse fine = on_ellipse(x.contact, law_of(x), {24, 400, 1});
    row(out, x.name, fixed(x.printed.force, 4), fixed(rule.force, 4), fixed(fine.force, 4),
        fixed(x.printed.temperature, 1), fixed(rule.temperature, 1), fixed(fine.temperature, 1));
  }
}

const FigureData published_data{"contact-cases", published_cases};

double cooler_in_per_cent(const Published& x) {
  const OnEllipse fine = on_ellipse(x.contact, law_of(x), {24, 400, 1});
  return 100 * (1 - fine.temperature / x.printed.temperature);
}

}  // namespace

void values_on_strips(nlohmann::ordered_json& v) {
  std::vector<double> cooler;
  for (const Published& x : published) cooler.push_back(cooler_in_per_cent(x));
  const auto [least, most] = std::minmax_element(cooler.begin(), cooler.end());
  v["strips_least"] = fixed(*least, 0);
  v["strips_most"] = fixed(*most, 0);
}

}  // namespace thermoroll
