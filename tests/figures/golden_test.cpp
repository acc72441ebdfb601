// The data of today against the golden data, which only `make golden` replaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "studies/figure_data.hpp"
#include "table.hpp"

using namespace thermoroll_test;

namespace {

const std::string root = THERMOROLL_ROOT;
const std::string golden_folder = root + "/figures/golden/";
const std::string data_folder = root + "/build/data/";

Table sidecar() { return read_table(golden_folder + "tolerances.csv"); }

// The tables that the program lists, without those that rest on times, and those of the counted
// evaluations and of the recipes.
std::vector<std::string> tables() {
  std::vector<std::string> names = thermoroll::figure_data_names();
  std::erase(names, "values");
  names.push_back("evaluations");
  for (const auto& entry : std::filesystem::directory_iterator(root + "/figures"))
    if (const std::string name = entry.path().stem().string(); name.rfind("recipe-", 0) == 0)
      names.push_back(name);
  return names;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string result;
  for (std::size_t i = 0; i < lines.size() && i < 10; ++i) result += lines[i] + "\n";
  return result + (lines.size() > 10 ? "and more" : "");
}

}  // namespace

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, DataAreWithinTheirTolerance) {
  const Table golden = read_table(golden_folder + GetParam() + ".csv");
  const Table today = read_table(data_folder + GetParam() + ".csv");
  ASSERT_FALSE(golden.rows.empty());
  const auto wrong = differences(golden, today, tolerances_of(sidecar(), GetParam()));
  EXPECT_TRUE(wrong.empty()) << joined(wrong);
}

// What the comparison is for: each damage to the data must be seen, in every file and column.
TEST_P(Golden, DamageIsSeen) {
  const Table golden = read_table(golden_folder + GetParam() + ".csv");
  const auto tolerances = tolerances_of(sidecar(), GetParam());
  ASSERT_TRUE(differences(golden, golden, tolerances).empty());

  Table short_one = golden;
  short_one.rows.pop_back();
  EXPECT_FALSE(differences(golden, short_one, tolerances).empty()) << "a row dropped";

  Table renamed = golden;
  renamed.header.back() += "x";
  EXPECT_FALSE(differences(golden, renamed, tolerances).empty()) << "a column renamed";

  const std::size_t row = golden.rows.size() / 2;
  for (const std::string& name : golden.header) {
    Table altered = golden;
    std::string& cell = altered.rows[row][golden.column(name)];
    const auto tolerance = tolerances.find(name);
    if (tolerance == tolerances.end()) {
      cell += "x";
      EXPECT_EQ(differences(golden, altered, tolerances).size(), 1u) << name;
      continue;
    }
    const double value = golden.number(row, name);
    const double allowed =
        tolerance->second.absolute + tolerance->second.relative * std::abs(value);
    for (const double factor : {-1.01, 1.01}) {
      char text[40];
      std::snprintf(text, sizeof text, "%.17g", value + factor * allowed);
      cell = text;
      EXPECT_EQ(differences(golden, altered, tolerances).size(), 1u) << name << " = " << cell;
    }
    for (const char* text : {"nan", "inf", "-inf", "", "0.1x", "text"}) {
      cell = text;
      EXPECT_EQ(differences(golden, altered, tolerances).size(), 1u) << name << " = " << cell;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Data, Golden, testing::ValuesIn(tables()), [](const auto& name) {
  std::string result = name.param;
  for (char& letter : result)
    if (letter == '-') letter = '_';
  return result;
});

// What else is in build/data is of no interest: a figure that has got another name leaves its data.
TEST(GoldenFolder, HasEveryTableAndNoOther) {
  std::set<std::string> expected{"tolerances"}, found;
  for (const std::string& name : tables()) expected.insert(name);
  for (const auto& entry : std::filesystem::directory_iterator(golden_folder))
    if (entry.path().extension() == ".csv") found.insert(entry.path().stem().string());
  EXPECT_EQ(found, expected);
}

TEST(GoldenFolder, EveryToleranceNamesAColumnAndItsReason) {
  const Table tolerances = sidecar();
  std::set<std::string> seen;
  for (std::size_t row = 0; row < tolerances.rows.size(); ++row) {
    const std::string& file = tolerances.text(row, "file");
    const std::string& column = tolerances.text(row, "column");
    SCOPED_TRACE(file + ", " + column);
    if (file == "values") continue;  // their test looks for each of them
    EXPECT_NO_THROW(read_table(golden_folder + file + ".csv").column(column));
    EXPECT_TRUE(seen.insert(file + "," + column).second) << "given twice";
    EXPECT_GE(tolerances.number(row, "absolute"), 0);
    EXPECT_GE(tolerances.number(row, "relative"), 0);
    EXPECT_LT(tolerances.number(row, "relative"), 0.1) << "would accept anything";
    EXPECT_GT(tolerances.text(row, "reason").size(), 10u);
  }
}

TEST(Comparison, RefusesARaggedTable) {
  EXPECT_THROW(parse_table("a,b\n1,2\n3\n"), std::runtime_error);
  EXPECT_THROW(parse_table(""), std::runtime_error);
}

TEST(Comparison, ReadsQuotedCells) {
  EXPECT_EQ(parse_table("a,b\n\"1, or \"\"2\"\"\",3\n").text(0, "a"), "1, or \"2\"");
}
