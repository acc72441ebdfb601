#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "studies/estimate_study.hpp"

namespace {

using thermoroll::StudyKind;
using thermoroll::StudyRow;

/// The lines of a file of the committed study, without its header.
std::vector<std::string> lines_of(const std::string& name) {
  std::ifstream file(THERMOROLL_ROOT "/figures/measured/study/" + name);
  std::vector<std::string> lines;
  std::string line;
  for (std::getline(file, line); std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> found;
  std::istringstream stream(line + ',');
  for (std::string cell; std::getline(stream, cell, ',');) found.push_back(cell);
  return found;
}

using Writer = void (*)(std::ostream&, const std::vector<StudyRow>&);

std::string written(Writer write, const std::vector<StudyRow>& rows) {
  std::ostringstream out;
  write(out, rows);
  return out.str();
}

}  // namespace

// One scene of a hundred is solved again. Two digits are compared, of which the second may be
// another by rounding. A true error near that of rounding has no digits, nor has a ratio of more
// than 1e4.
TEST(Study, ASampleIsWhatItWas) {
  std::map<int, std::string> sample;
  for (const std::string& line : lines_of("sample.csv")) sample[std::stoi(line)] = line;
  ASSERT_GT(sample.size(), 80u);
  for (int number = 50; number < 12000; number += 100) {
    const auto x = thermoroll::study_row(number);
    ASSERT_EQ(x.has_value(), sample.count(number) == 1) << number;
    if (!x) continue;
    std::istringstream stream(written(thermoroll::write_study_sample, {*x}));
    std::string header, line;
    std::getline(stream, header);
    std::getline(stream, line);
    const auto then = cells(sample.at(number)), now = cells(line);
    ASSERT_EQ(then.size(), now.size());
    EXPECT_EQ(then[1], now[1]) << number;
    if (x->error < 1e-10) continue;
    for (std::size_t i = 2; i < now.size(); ++i) {
      ASSERT_EQ(then[i].empty(), now[i].empty()) << number;
      if (now[i].empty()) continue;
      const double old = std::stod(then[i]);
      EXPECT_NEAR(std::stod(now[i]), old, old * (old > 1e4 ? 1 : 0.11)) << number;
    }
  }
}

// The sample is of these scenes: as large a part of it has a ratio as of all, and a quarter of
// these at least are below the median of all, and a quarter above. Both are a matter of chance, in
// a hundred scenes with a standard deviation of at most 5; a quarter is five of them away.
TEST(Study, SampleIsOfTheseScenes) {
  const auto sample = lines_of("sample.csv"), table = lines_of("study.csv");
  std::ifstream values(THERMOROLL_ROOT "/figures/measured/study/study-values.json");
  const double scenes = std::stod(nlohmann::json::parse(values)["study_scenes"].get<std::string>());
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double median = std::stod(cells(table[k])[3]);
    int below = 0, all = 0;
    for (const std::string& line : sample) {
      const std::string ratio = cells(line)[3 + k];
      all += ratio.empty() ? 0 : 1;
      below += !ratio.empty() && std::stod(ratio) < median ? 1 : 0;
    }
    const double n = static_cast<double>(sample.size());
    const double part = std::stod(cells(table[k])[1]) / scenes;
    EXPECT_NEAR(all, n * part, 5 * std::sqrt(n * part * (1 - part))) << table[k];
    EXPECT_GE(4 * below, all) << table[k];
    EXPECT_LE(4 * below, 3 * all) << table[k];
  }
}

// The error of the amplitude at the edge was up to 1.7 times too small.
TEST(Study, CrossingHeatHasItsErrors) {
  for (const int number : {5471, 10550, 10902, 11314, 11439}) {
    const thermoroll::StudyScene x = thermoroll::study_scene(number);
    const auto solved = [&x](double tolerance) {
      return *thermoroll::solve_coupled(x.scene, {x.formulation, tolerance}, x.given).crossing;
    };
    const thermoroll::CrossingHeat found = solved(x.tolerance), better = solved(x.tolerance / 100);
    EXPECT_LE(std::abs(found.heat - better.heat), found.heat_error) << number;
    EXPECT_LE(std::abs(found.edge - better.edge), found.edge_error) << number;
  }
}

// Neither the tail nor a change shows the errors of scene 504 due to a layer that the stick nodes
// do not resolve, of 2758 due to the graded rules, of 1444 due to the logarithm in the largest
// temperature, of 5691 due to the last correction, of 2851 due to layers of the heat that crosses,
// of 892, which is slow, in the largest temperature, and of 3508, where heat changes the creep less
// than both of its parts, and the whole heat less than the flux. In 5933, with a law, the border is
// off by nearly as much as is stated; in 2725 two grids agree on a layer by chance. In 400 the
// forces are Carter's but for some millionths, and so are their errors those of the heat.
TEST(Study, ErrorsThatTailsDoNotShowAreCounted) {
  const auto solved = [](const thermoroll::StudyScene& x, double tolerance) {
    return thermoroll::solve_coupled(x.scene, {thermoroll::Formulation::corrected, tolerance},
                                     x.given);
  };
  for (const int number : {504, 2758, 1444, 5691, 2851, 892, 3508, 5933, 2725, 400}) {
    const thermoroll::StudyScene x = thermoroll::study_scene(number);
    const auto found = solved(x, x.tolerance), better = solved(x, 1e-10);
    for (int i = 0; i < thermoroll::compared; ++i)
      EXPECT_LE(std::abs(found.value[i] - better.value[i]), found.error[i] + better.error[i])
          << number << ' ' << i;
    if (number != 400) continue;
    const thermoroll::Results relative = found.error / thermoroll::scale_in(x.scene, found.value);
    EXPECT_LT(relative(thermoroll::Quantity::load_ratio),
              1e-2 * relative.head(thermoroll::compared).maxCoeff());
  }
}

// What the chapter says: no tolerance is missed, and of a thousand stated errors at most one is too
// small, by a factor of two at most.
TEST(Study, EstimatesAreHonest) {
  long compared = 0, beyond = 0;
  for (const std::string& line : lines_of("study.csv")) {
    compared += std::stol(cells(line)[1]);
    beyond += std::stol(cells(line)[6]);
  }
  EXPECT_GT(compared, 50000);
  EXPECT_LE(beyond, compared / 1000);
  std::ifstream file(THERMOROLL_ROOT "/figures/measured/study/study-values.json");
  const auto values = nlohmann::json::parse(file);
  EXPECT_LE(std::stod(values.at("study_used").get<std::string>()), 100);
  EXPECT_LE(std::stod(values.at("study_worst").get<std::string>()), 2);
  EXPECT_EQ(std::stol(values.at("study_compared").get<std::string>()), compared);
  EXPECT_EQ(std::stol(values.at("study_beyond").get<std::string>()), beyond);
}

// Slip zones of a ten-thousandth and a millionth of the contact, with a law. Their heat is the
// square of that, its derivative by a few samples of the curve is wrong, and with it the correction
// of a border that is off by a billionth of the zone.
TEST(Study, TinySlipZonesWithALawMeetTheirTolerance) {
  for (const int number : {2132, 2512}) {
    const auto row = thermoroll::study_row(number);
    ASSERT_TRUE(row) << number;
    EXPECT_LE(row->error, row->tolerance) << number;
    for (const double ratio : row->ratio) EXPECT_FALSE(ratio < 1) << number;
  }
}

// Every kind of scene is in it, no tolerance of any is missed, and at most one stated error of a
// thousand is too small in any.
TEST(Study, EveryKindIsInIt) {
  const auto kinds = lines_of("study-kinds.csv");
  ASSERT_EQ(kinds.size(), 9u);
  double scenes = 0;
  for (const std::string& line : kinds) scenes += std::stod(cells(line)[1]);
  for (const std::string& line : kinds) {
    EXPECT_GE(std::stod(cells(line)[1]), 0.02 * scenes) << line;
    EXPECT_LE(std::stod(cells(line)[6]), 1) << line;
    EXPECT_LE(std::stod(cells(line)[4]), std::stod(cells(line)[2]) / 1000) << line;
  }
}

// Three rows by hand: ratios 2, 4 and none of the traction; 0.5, 10 and 20 of the border.
TEST(Study, IsSummedUp) {
  const double none = std::nan("");
  const std::vector<StudyRow> rows = {
      {1, StudyKind::law, 2e-5, 1e-7, {0.5, 1, 2, 1, 1, 1, 1, 1, 1}},
      {150, StudyKind::one_body, 2e-5, 6e-7, {10, 1, 4, 1, 1, 1, 1, 1, 1}},
      {250, StudyKind::law, 2e-5, 2e-7, {20, 1, none, 1, 1, 1, 1, 1, 1}}};
  const std::string table = written(thermoroll::write_study_table, rows),
                    data = written(thermoroll::write_study_figure, rows),
                    kinds = written(thermoroll::write_study_kinds, rows),
                    values = written(thermoroll::write_study_values, rows),
                    sample = written(thermoroll::write_study_sample, rows);
  EXPECT_NE(table.find("\ntraction,2,2.0,2,2,2,0\n"), std::string::npos) << table;
  EXPECT_NE(table.find("\nstick_slip_border,3,0.5,10,10,10,1\n"), std::string::npos) << table;
  EXPECT_NE(data.find("\nachieved,median,1.77828e-05,2e-07\n"), std::string::npos) << data;
  EXPECT_NE(data.find("\nachieved,all,1.77828e-05,6e-07\n"), std::string::npos) << data;
  EXPECT_NE(data.find("\nratio,traction,2.37137,50\n"), std::string::npos) << data;
  EXPECT_NE(kinds.find("\na law of friction,2,15,1,1,2.00,0.01\n"), std::string::npos) << kinds;
  EXPECT_NE(kinds.find("\none conducting body,1,8,1,0,1.00,0.03\n"), std::string::npos) << kinds;
  for (const char* value :
       {R"("study_scenes": "3")", R"("study_compared": "23")", R"("study_beyond": "1")",
        R"("study_worst": "2.0")", R"("study_used": "3")"})
    EXPECT_NE(values.find(value), std::string::npos) << values;
  EXPECT_EQ(sample.substr(sample.find('\n')),
            "\n150,2e-05,6e-07,4,10,1,1,1,1,1,1\n250,2e-05,2e-07,,20,1,1,1,1,1,1\n");
}
