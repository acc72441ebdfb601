// The numbers in the prose: build/data/values.json against figures/golden/values.json, which only
// `make golden` replaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "table.hpp"
#include "thermoroll/scene.hpp"

using namespace thermoroll_test;

namespace {

using Values = nlohmann::ordered_json;

const std::string root = THERMOROLL_ROOT;

Values read_values(const std::string& path) {
  std::ifstream file(root + path);
  return Values::parse(file);
}

/// A number as it is shown, "-0.0014" or "$5\cdot10^{-8}$", and a unit in its last place.
struct Shown {
  double value, unit;
  std::size_t decimals;
};

/// Whether a text is a number as a whole; words are not.
bool shows_number(const std::string& text, Shown& shown) {
  static const std::regex pattern(R"(\$?(-?[0-9]+(\.([0-9]+))?)(\\cdot10\^\{(-?[0-9]+)\}\$)?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, pattern)) return false;
  const std::string exponent = parts[5].matched ? parts[5].str() : "0";
  shown.decimals = parts[3].str().size();
  shown.value = std::stod(parts[1].str() + "e" + exponent);
  shown.unit = std::pow(10, std::stoi(exponent) - static_cast<int>(shown.decimals));
  return true;
}

/// By how much a value may differ: by a unit in its last place, as its own error is far smaller and
/// no more than tips the rounding; the sidecar has those that may differ by something else, and
/// why.
double allowed(const std::string& key, const Shown& shown) {
  static const auto others =
      tolerances_of(read_table(root + "/figures/golden/tolerances.csv"), "values");
  const auto other = others.find(key);
  return other == others.end() ? shown.unit : other->second.absolute;
}

/// What is wrong with today's values.
std::vector<std::string> differences(const Values& golden, const Values& today) {
  std::vector<std::string> wrong;
  if (golden.size() != today.size()) wrong.push_back("not as many values");
  for (const auto& [key, value] : golden.items()) {
    const std::string expected = value, found = today.value(key, "");
    Shown a{}, b{};
    bool same = expected == found;
    if (!same && shows_number(expected, a) && shows_number(found, b)) {
      same = std::abs(a.value - b.value) < 1.001 * allowed(key, a) && a.decimals == b.decimals;
    }
    if (!same) wrong.push_back(key + ": '" + found + "' instead of '" + expected + "'");
  }
  return wrong;
}

/// The text with the first number in it moved by so much in units of its last place.
std::string moved(const std::string& text, double units) {
  static const std::regex number(R"(-?[0-9]+(\.[0-9]+)?)");
  std::smatch found;
  std::regex_search(text, found, number);
  const std::size_t point = found.str().find('.');
  const int decimals =
      point == std::string::npos ? 0 : static_cast<int>(found.str().size() - point) - 1;
  char other[40];
  std::snprintf(other, sizeof other, "%.*f", decimals,
                std::stod(found.str()) + units * std::pow(10, -decimals));
  return std::string(found.prefix()) + other + std::string(found.suffix());
}

}  // namespace

TEST(Values, AreWithinTheirTolerance) {
  const auto wrong = differences(read_values("/figures/golden/values.json"),
                                 read_values("/build/data/values.json"));
  EXPECT_TRUE(wrong.empty()) << testing::PrintToString(wrong);
}

TEST(Values, AreFinite) {
  const Values values = read_values("/build/data/values.json");
  for (const auto& [key, value] : values.items()) {
    const std::string text = value.get<std::string>();
    EXPECT_FALSE(text.ends_with("nan") || text.ends_with("inf")) << key << ": " << text;
  }
}

// What the comparison is for: every value is guarded, its sign and its last digit as well.
TEST(Values, DamageIsSeen) {
  const Values golden = read_values("/figures/golden/values.json");
  ASSERT_TRUE(differences(golden, golden).empty());
  const auto expect_seen = [&](const std::string& key, const std::string& text) {
    Values altered = golden;
    altered[key] = text;
    EXPECT_EQ(differences(golden, altered).size(), 1u) << key << ": " << text;
  };
  for (const auto& [key, value] : golden.items()) {
    const std::string text = value;
    expect_seen(key, "");
    expect_seen(key, text + "x");
    Shown shown{};
    if (!shows_number(text, shown)) continue;
    const double units = std::max(1.0, 2 * allowed(key, shown) / shown.unit);
    expect_seen(key, moved(text, units));
    expect_seen(key, moved(text, -units));
    if (shown.decimals > 0) expect_seen(key, text.substr(0, text.size() - 1));
    if (shown.decimals > 0 || shown.value > 1) {
      expect_seen(key, text[0] == '-' ? text.substr(1) : "-" + text);
    }
  }
  Values shorter = golden;
  shorter.erase("kappa_ratio");
  EXPECT_FALSE(differences(golden, shorter).empty());
  Values longer = golden;
  longer["another"] = "1";
  EXPECT_FALSE(differences(golden, longer).empty());
}

TEST(Values, EveryToleranceNamesAValueAndItsReason) {
  const Table tolerances = read_table(root + "/figures/golden/tolerances.csv");
  const Values golden = read_values("/figures/golden/values.json");
  for (std::size_t row = 0; row < tolerances.rows.size(); ++row) {
    if (tolerances.text(row, "file") != "values") continue;
    EXPECT_TRUE(golden.contains(tolerances.text(row, "column"))) << tolerances.text(row, "column");
  }
}

// @tbl:steel shows what the program computes with, to the last digit.
TEST(Values, TableOfSteelIsTheCaseInFull) {
  const Values values = read_values("/build/data/values.json");
  const thermoroll::PhysicalScene steel = thermoroll::wheel_on_rail();
  const std::pair<const char*, double> fields[] = {{"steel_load", steel.load},
                                                   {"steel_speed", steel.speed},
                                                   {"steel_half_width", steel.half_width},
                                                   {"steel_shear_modulus", steel.shear_modulus},
                                                   {"steel_poisson", steel.poisson},
                                                   {"steel_expansion", steel.expansion},
                                                   {"steel_diffusivity", steel.diffusivity},
                                                   {"steel_conductivity", steel.conductivity}};
  for (const auto& [key, value] : fields) {
    Shown shown{};
    ASSERT_TRUE(shows_number(values.at(key), shown)) << key;
    EXPECT_EQ(shown.value, value) << key;
  }
  EXPECT_EQ(values.at("steel_friction"), "0.6");
}
