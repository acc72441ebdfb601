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
}
