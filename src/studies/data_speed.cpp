// Tangled from paper/F-data-files.md; edit there.
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "studies/comparison.hpp"
#include "studies/data.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

void errors(std::ostream& out, const Regime& regime) {
  row(out, "method", "setting", "name", "quantity", "error");
  const Found exact = reference(regime);
  for (const Run& run : runs(regime)) {
    const Found found = run.find();
    const auto compare = [&](const char* quantity, double error) {
      if (!std::isnan(error)) row(out, run.method, run.setting, run.name, quantity, error);
    };
    const bool again = run.method == "closed_form" && !std::isnan(found.hottest);
    if (!again) compare("load", error_of(found.load_ratio - 1, exact.load_ratio - 1));
    compare("temperature", error_of(found.hottest, exact.hottest));
    if (!again) compare("creep", error_of(found.creep, exact.creep));
  }
}

FigureData speed_data(const Regime& regime) {
  return {std::string("speed-") + regime.name, [=](std::ostream& out) { errors(out, regime); }};
}

const FigureData speed_panels[] = {speed_data(regimes[0]), speed_data(regimes[1]),
                                   speed_data(regimes[2])};

void digits_by_run(std::ostream& out) {
  row(out, "method", "setting", "name", "digits");
  const Found exact = reference(regimes[0]);
  for (const Run& run : runs(regimes[0]))
    if (const double digits = right_digits(run.find(), exact); !std::isnan(digits))
      row(out, run.method, run.setting, run.name, digits);
}

const FigureData speed_chart{"speed", digits_by_run};

void digits_by_unknowns(std::ostream& out) {
  row(out, "regime", "method", "unknowns", "digits");
  for (const Regime& regime : {regimes[0], regimes[2]}) {
    const Found exact = reference(regime);
    const auto write = [&](const std::string& method, int n, const Found& found) {
      if (const double digits = right_digits(found, exact); !std::isnan(digits))
        row(out, regime.name, method, n, digits);
    };
    for (const Run& run : runs(regime))
      if (run.setting > 1 && run.method != "gauss_chebyshev")  // the cached scheme finds the same
        write(run.method, static_cast<int>(run.setting), run.find());
    for (const int n : {5, 7, 10, 14, 20, 28, 40, 56, 80, 112})
      write("coupled", n, on_one_grid(regime, n));
  }
}

const FigureData convergence_data{"convergence", digits_by_unknowns};

double digits_of(const Regime& regime, const std::string& name) {
  const auto all = runs(regime);
  const auto run = std::find_if(all.begin(), all.end(),
                                [&](const Run& x) { return x.name.starts_with(name + "/"); });
  return right_digits(run->find(), reference(regime));
}

void cost(std::ostream& out) {
  row(out, "tolerance", "heating", "peclet", "name", "unknowns");
  for (const auto& [scene, run] : cost_runs())
    if (const Found found = run.find(); found.unknowns > 0)
      row(out, run.setting, scene.heating, scene.peclet, run.name, found.unknowns);
}

const FigureData cost_data{"cost", cost};

}  // namespace

void values_on_digits(nlohmann::ordered_json& v) {
  const Regime &wheel = regimes[0], &hot = regimes[2];
  const std::string scheme = "gauss_chebyshev_thrifty/n:", means = "gauss_chebyshev_moments/n:";
  v["digits_closed_form"] = fixed(digits_of(wheel, "closed_form"), 1);
  v["digits_first_order"] = fixed(digits_of(wheel, "first_order"), 1);
  v["digits_scheme_25"] = fixed(digits_of(wheel, scheme + "25"), 1);
  v["digits_scheme_200"] = fixed(digits_of(wheel, scheme + "200"), 1);
  v["digits_scheme_800"] = fixed(digits_of(wheel, scheme + "800"), 1);
  v["digits_coupled_6"] = fixed(digits_of(wheel, "coupled/tol:1e-06"), 0);
  const double gained = digits_of(hot, means + "400") - digits_of(hot, means + "25");
  v["digits_doubling"] = fixed(gained / std::log2(400 / 25), 1);
}

}  // namespace thermoroll
