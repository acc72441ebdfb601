// Tangled from paper/F-data-files.md; edit there.
#include <algorithm>
#include <cmath>

#include "studies/comparison.hpp"
#include "studies/data.hpp"

namespace thermoroll {
namespace {

void errors(std::ostream& out, const Regime& regime) {
  row(out, "method", "setting", "name", "quantity", "error");
  const Found exact = reference(regime);
  for (const Run& run : runs(regime)) {
    const Found found = run.find();
    const auto compare = [&](const char* quantity, double value, double wanted) {
      const double error = std::max(std::abs(value / wanted - 1), 1e-11);
      if (!std::isnan(value)) row(out, run.method, run.setting, run.name, quantity, error);
    };
    compare("load", found.load_ratio - 1, exact.load_ratio - 1);
    compare("temperature", found.hottest, exact.hottest);
    compare("creep", found.creep, exact.creep);
  }
}

FigureData speed_data(const Regime& regime) {
  return {std::string("speed-") + regime.name, [=](std::ostream& out) { errors(out, regime); }};
}

const FigureData speed_panels[] = {speed_data(regimes[0]), speed_data(regimes[1]),
                                   speed_data(regimes[2])};

void cost(std::ostream& out) {
  row(out, "tolerance", "heating", "peclet", "name", "unknowns");
  for (const auto& [scene, run] : cost_runs())
    if (const Found found = run.find(); found.unknowns > 0)
      row(out, run.setting, scene.heating, scene.peclet, run.name, found.unknowns);
}

const FigureData cost_data{"cost", cost};

}  // namespace
}  // namespace thermoroll
