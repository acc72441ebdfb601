// Prints results of random scenes to the last bit. Compiled twice: with the library, and with the
// library's sources, without optimisation and without AVX2; Plain.SameToTheLastBit compares.
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>

#include "driven.hpp"
#include "solver/least_model.hpp"
#include "solver/surface.hpp"

int main() {
  using namespace thermoroll;
  std::mt19937 random(20260101);
  const auto up_to = [&](double x) { return x * static_cast<double>(random()) / 0x1p32; };
  for (int i = 0; i < 40; ++i) {
    const double f = 0.05 + up_to(1), q = f * (0.001 + up_to(0.998));
    const Driven scene{f, q, std::pow(10, -2 + up_to(8)), std::pow(10, -4 + up_to(3.5))};
    const double tolerance = std::pow(10, -2 - i % 4);
    const Formulation sign = i % 2 == 0 ? Formulation::corrected : Formulation::printed;
    try {
      const CoupledSolution x = solve_coupled(scene, {sign, tolerance}, {Quantity::traction, q});
      const Eigen::ArrayXd s = Eigen::ArrayXd::LinSpaced(20, -1, 3);
      const SurfaceCurve curve = surface_curve(smooth_flux(x), scene.peclet, s, tolerance);
      for (const double value : x.value) std::printf("%a ", value);
      for (const double error : x.error) std::printf("%a ", error);
      for (const double value : curve.temperature) std::printf("%a ", value);
      const Choice least = least_model(scene, {sign, tolerance}, {Quantity::traction, q});
      std::printf("%d %a\n", static_cast<int>(least.model), least.solution.value(Quantity::creep));
    } catch (const std::exception& refusal) {
      std::puts(refusal.what());
    }
  }
  for (int i = 0; i < 4; ++i) {  // moved ends
    const Scene scene{0.7 + up_to(0.3), std::pow(10, 5 + up_to(1)), 0.8 + up_to(0.5)};
    const CoupledSolution x = solve_coupled(scene, {Formulation::corrected, 1e-4},
                                            {Quantity::stick_slip_border, -0.5 + up_to(0.5)});
    std::printf("%d ", x.variable.beta > 0);
    for (const double value : x.value) std::printf("%a ", value);
    std::puts("");
  }
  for (int i = 0; i < 12; ++i) {  // two bodies, their bulk temperatures, a law of friction
    Scene scene{0.3, std::pow(10, 1 + up_to(3)), std::pow(10, -2 + up_to(1.5))};
    scene.roller = {0.5 + up_to(2), scene.heating * up_to(2), scene.peclet * (0.1 + up_to(0.8))};
    if (i % 3 == 1) scene.bulk_difference = 0.1 / std::sqrt(scene.peclet);
    if (i % 3 == 2) scene.law = linear_friction({0.3 / std::sqrt(scene.peclet)});
    const CoupledSolution x = solve_coupled(scene, {Formulation::corrected, 1e-4},
                                            {Quantity::stick_slip_border, -0.8 + up_to(1.6)});
    for (const double value : x.value) std::printf("%a ", value);
    for (const double error : x.error) std::printf("%a ", error);
    std::puts("");
  }
}
