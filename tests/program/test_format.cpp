// What is printed of a solution, against the solution itself.
#include "driven.hpp"
#include "program/format.hpp"
#include "program/law_output.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace thermoroll;
using enum thermoroll::Quantity;

namespace {

const Driven scene{0.6, 0.5, 300, 1};
const Approach scheme{.method = Method::gauss_chebyshev, .nodes = 60};

std::map<std::string, std::string> cells_of(const Solution& x) {
  std::map<std::string, std::string> cells;
  for (const Field& field : csv_fields(x, {}, {true, true, true})) cells[field.name] = field.cell;
  return cells;
}

/// The words of the line of a text that begins with this word.
std::vector<std::string> line_of(const std::string& text, const std::string& first) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    if (!words.empty() && words[0] == first) return words;
  }
  return {};
}

}  // namespace

// In these scenes no two of a solution's counts are the same, so that none can stand for another.
TEST(Output, CountsAreThoseOfTheSolution) {
  const Solution x = solve(scene, {.method = Method::coupled}), y = solve(scene, scheme);
  const auto& coupled = std::get<CoupledSolution>(x.found);
  const auto& printed = std::get<PublishedSolution>(y.found);
  ASSERT_NE(coupled.unknowns, coupled.newton_steps);
  ASSERT_NE(printed.outer_iterations, printed.inner_iterations);
  EXPECT_EQ(cells_of(x)["unknowns"], std::to_string(coupled.unknowns));
  EXPECT_EQ(cells_of(x)["newton_iterations"], std::to_string(coupled.newton_steps));
  EXPECT_EQ(cells_of(y)["outer_iterations"], std::to_string(printed.outer_iterations));
  EXPECT_EQ(cells_of(y)["inner_iterations"], std::to_string(printed.inner_iterations));
  EXPECT_EQ(cells_of(y)["nodes"], "60");
  const std::string text = present(x, {}, Format::text), of_scheme = present(y, {}, Format::text);
  EXPECT_EQ(line_of(text, "newton_iterations").back(), std::to_string(coupled.newton_steps));
  EXPECT_EQ(line_of(of_scheme, "outer_iterations").back(),
            std::to_string(printed.outer_iterations));
}

// An error is rounded to one digit, by at most a third: 1.5 may become 2.
TEST(Output, TextHasTheErrorsOfTheSolution) {
  const PhysicalScene c = wheel_on_rail();
  const Solution x = thermoroll::solve(scene_of(c, 0.6), {Quantity::traction, 0.5});
  const FoundInSi si = in_si_units(x, c);
  const std::string text = present(x, si, Format::text);
  const auto expect_error = [&](const char* name, std::size_t column, double error) {
    const std::vector<std::string> words = line_of(text, name);
    ASSERT_GT(words.size(), column) << name;
    EXPECT_NEAR(std::stod(words[column]) / error, 1, 0.34) << name;
  };
  expect_error("stick_slip_border", 3, (*x.error)(stick_slip_border));
  expect_error("creep", 3, (*x.error)(creep));
  expect_error("load_ratio", 3, (*x.error)(load_ratio));
  expect_error("max_temperature", 3, (*x.error)(max_temperature));
  expect_error("radius", 3, si.error->radius);
  expect_error("max_pressure", 4, si.error->max_pressure);
  expect_error("max_traction", 4, si.error->max_traction);
  expect_error("max_heat_flux", 4, si.error->max_heat_flux);
  expect_error("max_temperature_celsius", 3, si.error->max_temperature_celsius);
}

// Of two bodies the text has the heat into either: W/m in SI units, where both add up to the power
// that friction turns into heat. Six digits of the larger part leave 1e-5 of the sum. An error is
// rounded by a third at most, and with a radius has twice that of the half-width.
TEST(Output, TextHasTheHeatOfBothBodies) {
  PhysicalScene c = wheel_on_rail();
  c.expansion_2 = 1.6e-5;
  c.conductivity_2 = 20;
  const Solution x = thermoroll::solve(scene_of(c, 0.6), {Quantity::traction, 0.5});
  const auto heat = [&](const std::optional<FoundInSi>& si, const char* name, std::size_t column) {
    return std::stod(line_of(present(x, si, Format::text), name).at(column));
  };
  for (const bool from_radius : {false, true}) {
    const FoundInSi si = in_si_units(x, c, from_radius);
    const double all = si.value.dissipation;
    EXPECT_NEAR(heat(si, "heat_1", 1) + heat(si, "heat_2", 1), all, 1e-5 * all);
    EXPECT_GT(heat(si, "heat_1", 1), heat(si, "heat_2", 1));
    EXPECT_EQ(line_of(present(x, si, Format::text), "heat_2").back(), "W/m");
    const double share = heat(si, "heat_1", 1) / all;
    EXPECT_NEAR(heat(si, "heat_1", 2) / (share * si.error->dissipation), 1, 0.34);
  }
  const double all = x.value(Quantity::heat_integral);
  EXPECT_NEAR(heat({}, "heat_1", 1) + heat({}, "heat_2", 1), all, 1e-8 * all);
  EXPECT_EQ(line_of(present(x, {}, Format::text), "heat_1").size(), 3U);
  EXPECT_TRUE(line_of(present(solve(scene), {}, Format::text), "heat_1").empty());
}

// Where the program chose the model, it says which and why; where the user did, that is no news.
TEST(Output, TextTellsTheChosenModelAndWhy) {
  const Solution x = solve(scene);
  const std::string text = present(x, {}, Format::text);
  EXPECT_EQ(line_of(text, "model"),
            (std::vector<std::string>{"model", name_of(model_names, *x.model)}));
  EXPECT_NE(text.find(x.reason), std::string::npos);
  EXPECT_FALSE(x.reason.empty());
  EXPECT_TRUE(line_of(present(solve(scene, {.method = Method::coupled}), {}, Format::text), "model")
                  .empty());
}

// A cell is read back as RFC 4180 says: what stands between quotes, each doubled quote being one.
TEST(Output, QuotedCellsReadBack) {
  for (const std::string text : {"", "plain", "a b", "a,b", "\"", "\"\"", "say \"no\", twice",
                                 "two\nlines", "a\r", ",\",\""}) {
    std::string cell = quoted(text), read;
    if (cell.empty() || cell.front() != '"') {
      EXPECT_EQ(cell.find_first_of(",\"\r\n"), std::string::npos) << text;
      EXPECT_EQ(cell, text);
      continue;
    }
    ASSERT_GE(cell.size(), 2U);
    ASSERT_EQ(cell.back(), '"');
    for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
      if (cell[i] == '"') {
        ASSERT_EQ(cell[++i], '"') << "a quote alone in " << cell;
        ASSERT_LT(i + 1, cell.size()) << cell;
      }
      read += cell[i];
    }
    EXPECT_EQ(read, text);
  }
}

// A single number of a scene in SI units or of its errors that is not finite is refused by name.
TEST(Output, NoResultThatIsNotFinite) {
  const PhysicalScene c = wheel_on_rail();
  const Solution x = thermoroll::solve(scene_of(c, 0.6), {Quantity::traction, 0.5},
                                       {.method = Method::closed_form});
  FoundInSi value = in_si_units(x, c), error = value;
  value.value.max_traction = error.error->max_traction = std::nan("");
  for (const FoundInSi& si : {value, error}) try {
      present(x, si, Format::json);
      ADD_FAILURE() << "written";
    } catch (const NotConverged& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("max_traction is"), std::string::npos);
    }
}

// A law of no creep has no value; one of a half with a piece of NaN has no finite one.
TEST(Output, NoRowWithoutAFiniteValue) {
  thermoroll::CreepLaw law{};
  EXPECT_THROW(creep_curve_csv(law, {0.25}, {}), thermoroll::NotResolved);
  thermoroll::LawPiece piece{0, 1, {1}, {1}, {1}};
  law.driving.pieces = {piece};
  law.driving.last_creep = 1;
  EXPECT_NE(creep_curve_csv(law, {0.25}, {}).find("\n0.25,0.25,"), std::string::npos);
  law.driving.pieces[0].traction[0] = std::nan("");
  EXPECT_THROW(creep_curve_csv(law, {0.25}, {}), thermoroll::NotResolved);
}

TEST(Output, NoTemperatureThatIsNotFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double t : {infinity, -infinity, std::nan("")}) {
    const Curve curve{{{0, 1, 0.1}, {0.25, t, {}}}, true};
    try {
      curve_csv({{0, curve}}, {});
      ADD_FAILURE() << "written: " << t;
    } catch (const NotConverged& refusal) {
      EXPECT_STREQ(refusal.what(), "no finite temperature found at s = 0.25");
    }
  }
}
