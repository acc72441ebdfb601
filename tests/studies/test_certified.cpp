// The program against the balls that make certify has left in figures/measured/.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "model/kernel_table.hpp"
#include "reference.hpp"
#include "solver/least_model.hpp"
#include "studies/paper_scene.hpp"
#include "thermoroll/carter.hpp"
#include "thermoroll/temperature.hpp"

namespace {

using namespace thermoroll;

using Row = std::vector<std::string>;

// The rows of a file below its head.
std::vector<Row> rows(const std::string& part) {
  std::ifstream file(THERMOROLL_ROOT "/figures/measured/certified-" + part + ".csv");
  std::vector<Row> all;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    all.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) all.back().push_back(cell);
  }
  return all;
}

// The error of the program's value against the ball whose midpoint and radius begin at a cell of a
// row: at most the radius and the estimate. Returns its ratio to the estimate.
double ratio(const Row& row, std::size_t at, double value, double estimate) {
  const double error = std::abs(value - std::stod(row[at])), radius = std::stod(row[at + 1]);
  EXPECT_LE(error, radius + estimate) << row[0] << ' ' << row[1] << ' ' << row[2];
  return error / estimate;
}

TEST(Certified, TemperaturesAreWithinTheirErrors) {
  double most = 0;
  const std::vector<Row> all = rows("temperatures");
  ASSERT_GE(all.size(), 8U);
  for (const Row& row : all) {
    const HeatFlux flux = carter_flux(carter(paper::friction, std::stod(row[0])));
    const double peclet = std::stod(row[1]);
    const bool hottest = row[2] == "maximum";
    const Estimate found = hottest ? hottest_point(flux, peclet).temperature
                                   : temperature(flux, peclet, std::stod(row[2]));
    EXPECT_LT(std::stod(row[4]), 1e-5 * found.value) << "the ball is small";
    const double at = ratio(row, 3, found.value, found.error);
    if (!hottest) most = std::max(most, at);
  }
  std::cout << "largest error of a temperature by its estimate: " << most << '\n';
}

// Each change per H at Carter's border, by a scene with so little heat that the second order is
// below the resolution.
TEST(Certified, FirstOrderIsWithinItsErrors) {
  double most = 0;
  const std::vector<Row> all = rows("first-order");
  ASSERT_GE(all.size(), 16U);
  for (const Row& row : all) {
    const double heating = 1e-3;
    const Carter c = carter(paper::friction, std::stod(row[0]));
    const Scene scene{paper::friction, std::stod(row[1]), heating};
    const CoupledSolution x =
        first_order(scene, {Formulation::corrected, 1e-9}, {Quantity::stick_slip_border, c.c0});
    const std::map<std::string, std::pair<Quantity, double>> cold{
        {"$\\kappa$", {Quantity::load_ratio, 1}},
        {"$\\gamma_0$", {Quantity::gamma0, 0}},
        {"$Q^*$", {Quantity::traction, std::stod(row[0])}},
        {"$\\xi^*$", {Quantity::creep, c.creep}}};
    const auto& [quantity, value] = cold.at(row[2]);
    most = std::max(
        most, ratio(row, 3, (x.value(quantity) - value) / heating, x.error(quantity) / heating));
  }
  std::cout << "largest error of a change by heat by its estimate: " << most << '\n';
}

// What the header of the table promises, on every cell; and look-ups at ends of cells, where the
// polynomial's errors are largest, by the integrals of reference.hpp.
TEST(Certified, TablesKeepWhatTheHeaderSays) {
  const std::vector<Row> all = rows("tables");
  ASSERT_EQ(all.size(), 4U);
  double bound[4];
  for (std::size_t i = 0; i < 4; ++i) {
    bound[i] = std::stod(all[i][1]) + std::stod(all[i][2]);
    EXPECT_LT(bound[i], 1e-13) << all[i][0];
  }
  const std::vector<KernelCell> cells = kernel_cells();
  ASSERT_EQ(cells.size(), 672U);
  for (std::size_t i = 40; i < cells.size(); i += 60) {
    const double x = std::nextafter(cells[i].high, 0);
    const Kernels k = fast_kernels(x);
    using reference::Real;
    const Real n1 = reference::N1(x), up = reference::N2(x), down = reference::N2(-x);
    EXPECT_LE(std::abs(k.n1 - n1), bound[0] * n1 + 1e-15L * n1) << x;
    EXPECT_LE(std::abs(k.n2_up - up), (bound[1] + 1e-15L) * reference::size_of_N2(x, up)) << x;
    EXPECT_LE(std::abs(k.n2_down - down), (bound[2] + 1e-15L) * down) << x;
    const Real m = reference::K0_scaled(x);
    EXPECT_LE(std::abs(k.m_down - m), (bound[3] + 1e-15L) * m) << x;
  }
}

}  // namespace
