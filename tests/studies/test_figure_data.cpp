#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "studies/data.hpp"
#include "studies/figure_data.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/scene.hpp"

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
      {0.6, 10, 0}, thermoroll::Formulation::corrected, 1e-2, {Quantity::traction, 0.5});
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
