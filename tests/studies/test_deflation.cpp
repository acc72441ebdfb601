// Solutions by deflation, against the solver and against a scene that has two.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "studies/deflation.hpp"
#include "thermoroll/admissibility.hpp"
#include "thermoroll/coupled.hpp"

namespace {

using namespace thermoroll;
using Eigen::VectorXd;

const Random random_numbers{std::mt19937_64(1)};

ContactGrid grid_at(const Scene& scene, double c0) {
  return contact_grid(scene, Formulation::corrected, {1 - c0, 1 + c0}, 24);
}

// Where friction rises by f at every 0.45 of T*, there are two contacts at the border 0. A solve at
// that border finds one of them. The difference from other grids is below 1e-6. Deflation leads
// from one start to both.
TEST(Deflation, FindsBothContactsAtOneBorder) {
  Scene scene{0.4, 0.1, 0};
  scene.law = linear_friction({-0.45});
  const ContactGrid grid = grid_at(scene, 0);
  const std::vector<VectorXd> found = distinct_solutions(grid, 1, random_numbers);
  ASSERT_EQ(found.size(), 2U);
  std::vector<double> tractions;
  for (const VectorXd& h : found) {
    EXPECT_TRUE(violations(factors(grid, h)).empty());
    tractions.push_back(resultants(grid, h).traction);
  }
  std::sort(tractions.begin(), tractions.end());
  EXPECT_NEAR(tractions[0], 0.5465, 5e-5);
  EXPECT_NEAR(tractions[1], 0.6954, 5e-5);
  const CoupledSolution x =
      solve_coupled(scene, {Formulation::corrected, 1e-8}, {Quantity::stick_slip_border, 0});
  EXPECT_NEAR(tractions[0], x.value(Quantity::traction), 1e-6);
}

// Steps by differences are Newton's to 1e-7 of them, and they end below 1e-9 of the solution.
TEST(Deflation, FindsTheSolutionOfTheSolverAlone) {
  for (const double heating : {0.0, 0.1, 1.0}) {
    const ContactGrid grid = grid_at({0.6, 100, heating}, -0.2);
    const std::vector<VectorXd> found = distinct_solutions(grid, 4, random_numbers);
    ASSERT_EQ(found.size(), 1U) << heating;
    VectorXd h = carter_h(grid);
    ASSERT_GT(solve_flux(grid, h), 0);
    EXPECT_LT((found[0] - h).norm(), 1e-8 * h.norm()) << heating;
  }
}

}  // namespace
