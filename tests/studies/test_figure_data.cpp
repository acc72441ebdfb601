#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "studies/data.hpp"
#include "studies/figure_data.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/friction_law.hpp"
#include "thermoroll/scene.hpp"
#include "thermoroll/solution.hpp"

namespace {

using thermoroll::CoupledSolution;
using thermoroll::outcome;
using thermoroll::Outcome;
using thermoroll::Quantity;
using thermoroll::Violation;

}  // namespace

// The tables count scenes by it: no contact is neither a contact nor a refusal. No scene of theirs
// ends at no contact today, so the solution is one that is told to.
TEST(FigureData, SolvesAreCountedByTheirOutcome) {
  const CoupledSolution contact = thermoroll::solve_coupled(
      {0.6, 10, 0}, {thermoroll::Formulation::corrected, 1e-2}, {Quantity::traction, 0.5});
  ASSERT_TRUE(contact.violations.empty());
  EXPECT_EQ(outcome([&] { return contact; }), Outcome::contact);

  CoupledSolution no_contact = contact;
  no_contact.violations.emplace_back();
  EXPECT_EQ(outcome([&] { return no_contact; }), Outcome::no_contact);

  const auto refuse = []() -> CoupledSolution { throw std::runtime_error("not resolved"); };
  EXPECT_EQ(outcome(refuse), Outcome::refused);
}

// What is defined anywhere is known, in order, and written; a second of its name is refused and the
// first is kept.
TEST(FigureData, NamesAreRegisteredOnce) {
  const thermoroll::FigureData mine{"mine", [](std::ostream& out) { out << 0.12345678901; }};
  const std::vector<std::string> names = thermoroll::figure_data_names();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"mine", "values", "claims", "kernels", "traction", "rungs", "survival"})
    EXPECT_TRUE(std::binary_search(names.begin(), names.end(), name)) << name;
  EXPECT_THROW((thermoroll::FigureData{"mine", [](std::ostream&) {}}), std::logic_error);
  std::ostringstream out;
  thermoroll::write_figure_data("mine", out);
  EXPECT_EQ(out.str(), "0.123456789");  // ten digits, of which the last is a zero
  EXPECT_THROW(thermoroll::write_figure_data("theirs", out), std::invalid_argument);
}

// Each row of reference values again, but given its creep: the traction is then a result. A creep
// good to 1e-10 and half a unit of its tenth digit has a traction good to pi times that, the
// steepest slope of a creep curve, and to 1e-10 of its own; border, load ratio and constant change
// with the creep by less than ten times as much. The row in full slip is that of a program of
// another kind (Gauss panels in place of polynomials, dense matrices in place of sums).
TEST(ReferenceValues, HoldByEachPrescription) {
  std::ostringstream text;
  thermoroll::write_figure_data("reference-values", text);
  std::istringstream lines(text.str());
  std::string line;
  std::getline(lines, line);
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    SCOPED_TRACE(line);
    std::vector<std::string> cells;
    std::istringstream split(line);
    for (std::string cell; std::getline(split, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 10u);
    const auto number = [&](std::size_t i) { return std::stod(cells[i]); };
    thermoroll::Scene scene{0.6, number(1), number(2)};
    if (cells[0] == "identical") scene.roller = {1, number(2)};
    if (cells[0].find("T^*") != std::string::npos) scene.law = thermoroll::linear_friction({0.05});
    scene.direction =
        number(3) < 0 ? thermoroll::Direction::braking : thermoroll::Direction::driving;
    const thermoroll::Solution x =
        solve(scene, {thermoroll::Quantity::creep, number(5)},
              {thermoroll::Formulation::corrected, 1e-10, thermoroll::Method::coupled});
    EXPECT_NEAR(x.value(thermoroll::Quantity::traction), number(3), 3.15 * 1.5e-10 + 1e-10);
    EXPECT_NEAR(x.value(thermoroll::Quantity::stick_slip_border), number(4), 1.6e-9);
    EXPECT_NEAR(x.value(thermoroll::Quantity::load_ratio), number(6), 1.6e-9);
    EXPECT_NEAR(x.value(thermoroll::Quantity::gamma0), number(7), 1.6e-9);
    EXPECT_NEAR(x.value(thermoroll::Quantity::max_temperature) / number(8), 1, 1.6e-9);
    if (cells[0].find("full slip") != std::string::npos) {
      EXPECT_NEAR(number(6), 1.0541541018, 1.5e-10);
      EXPECT_NEAR(number(8), 0.0308691614, 1.5e-10);
    }
  }
  EXPECT_EQ(rows, 8);
}
