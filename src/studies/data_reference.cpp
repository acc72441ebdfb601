// Tangled from paper/F-data-files.md; edit there.
#include <string>

#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/solution.hpp"

namespace thermoroll {
namespace {

void reference_row(std::ostream& out, const std::string& roller, const Scene& scene,
                   const Prescribed& given) {
  const Solution x = solve(scene, given, {Formulation::corrected, 1e-10, Method::coupled});
  const auto digits = [&](Quantity what) { return fixed(x.value(what), 10); };
  const Results relative = *x.error / scale_of(x.value);
  row(out, roller, scene.peclet, scene.heating, digits(Quantity::traction),
      digits(Quantity::stick_slip_border), digits(Quantity::creep), digits(Quantity::load_ratio),
      digits(Quantity::gamma0), fixed(x.value(Quantity::max_temperature), 13),
      scientific(relative.head(compared).maxCoeff(), 1));
}

void reference_values(std::ostream& out) {
  row(out, "roller", "$\\mathrm{Pe}$", "$H$", "$Q^*$", "$c_0$", "$\\xi^*$", "$\\kappa$",
      "$\\gamma_0$", "$T^*_{\\max}$", "error");
  const double f = paper::friction;
  const Prescribed half{Quantity::traction, 0.5};
  reference_row(out, "insulated", {f, paper::peclet, paper::heating}, half);
  reference_row(out, "insulated", {f, 10000, 0.07}, {Quantity::traction, 0.3});
  reference_row(out, "insulated", {f, 100, 1}, half);
  reference_row(out, "insulated", {f, 1, 2}, half);
  Scene braking{f, 100, 1};
  braking.direction = Direction::braking;
  reference_row(out, "insulated; braking", braking, {Quantity::traction, -0.5});
  reference_row(out, "identical", {f, 100, 1, {1, 1}}, half);
  reference_row(out, "insulated; full slip", {f, 100, 1}, {Quantity::creep, 0.5});
  Scene falling{f, 100, paper::heating};
  falling.law = linear_friction({0.05});
  reference_row(out, "insulated; $f(1-T^*/0.05)$", falling, {Quantity::creep, 0.2});
}

const FigureData reference_data{"reference-values", reference_values};

}  // namespace
}  // namespace thermoroll
