#include <stdexcept>

#include <gtest/gtest.h>

#include "studies/figure_data.hpp"
#include "thermoroll/coupled.hpp"
#include "thermoroll/scene.hpp"

namespace {

using thermoroll::CoupledSolution;
using thermoroll::outcome;
using thermoroll::Outcome;
using thermoroll::Violation;

}  // namespace

// The tables count scenes by it: no contact is neither a contact nor a refusal. No scene of theirs
// ends at no contact today, so the solution is one that is told to.
TEST(FigureData, SolvesAreCountedByTheirOutcome) {
  const CoupledSolution contact = thermoroll::solve_coupled(
      {0.6, 10, 0}, thermoroll::Formulation::corrected, 1e-2, {thermoroll::traction, 0.5});
  ASSERT_TRUE(contact.violations.empty());
  EXPECT_EQ(outcome([&] { return contact; }), Outcome::contact);

  CoupledSolution no_contact = contact;
  no_contact.violations.emplace_back();
  EXPECT_EQ(outcome([&] { return no_contact; }), Outcome::no_contact);

  const auto refuse = []() -> CoupledSolution { throw std::runtime_error("not resolved"); };
  EXPECT_EQ(outcome(refuse), Outcome::refused);
}
