// Tangled from paper/F-data-files.md; edit there.
#include <algorithm>
#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/creep_law.hpp"

namespace thermoroll {
namespace {

const double full_slip = 2 * paper::friction / pi;  // Carter's xi* there

std::vector<double> relative_tractions(const Scene& scene, const std::vector<double>& creeps) {
  const CreepLaw law = creep_law(scene, Formulation::corrected, 1e-5, {0, 3 * full_slip});
  std::vector<double> tractions(creeps.size());
  std::transform(creeps.begin(), creeps.end(), tractions.begin(), [&](double u) {
    return evaluate(law, u * full_slip).value().traction / paper::friction;
  });
  return tractions;
}

void creep_in_brief(std::ostream& out) {
  row(out, "curve", "creep", "traction");
  const std::vector<double> creeps = grid(0, 2, 160);
  for (const double u : creeps)
    row(out, "Carter", u, carter_creep_curve(paper::friction, u * full_slip) / paper::friction);
  const auto curve = [&](const std::string& name, const Scene& scene) {
    const std::vector<double> tractions = relative_tractions(scene, creeps);
    for (std::size_t i = 0; i < creeps.size(); ++i) row(out, name, creeps[i], tractions[i]);
  };
  curve("constant friction", paper::wheel(false, false));
  for (const bool two : {true, false}) {
    curve(two ? "two bodies" : "one body", paper::wheel(two, true));
    const TractionLimit top = paper::largest_traction(paper::wheel(two, true));
    row(out, "maximum", top.creep / full_slip, top.traction / paper::friction);
  }
}

const FigureData brief_data{"brief", creep_in_brief};

}  // namespace

void values_in_brief(nlohmann::ordered_json& v) {
  const std::vector<double> creeps = grid(0, 2, 160);
  const std::vector<double> tractions = relative_tractions(paper::wheel(false, false), creeps);
  double most = 0;
  for (std::size_t i = 0; i < creeps.size(); ++i) {
    const double cold = carter_creep_curve(paper::friction, creeps[i] * full_slip);
    most = std::max(most, std::abs(tractions[i] - cold / paper::friction));
  }
  v["brief_distortion"] = fixed(std::ceil(1000 * most) / 10, 1);
  v["brief_one"] =
      fixed(100 * paper::largest_traction(paper::wheel(false, true)).traction / paper::friction, 0);
  v["brief_two"] =
      fixed(100 * paper::largest_traction(paper::wheel(true, true)).traction / paper::friction, 0);
}

}  // namespace thermoroll
