// Tangled from paper/F-data-files.md; edit there.
#include <cstdlib>
#include <fstream>
#include <string>

#include "studies/estimate_study.hpp"

int main(int argc, char** argv) {
  const int count = argc == 3 ? std::atoi(argv[1]) : 0;
  if (count <= 0) return 2;
  const std::string folder = argv[2];
  std::ofstream figure(folder + "/estimates.csv"), table(folder + "/study.csv"),
      kinds(folder + "/study-kinds.csv"), values(folder + "/study-values.json"),
      sample(folder + "/sample.csv");
  const auto rows = thermoroll::study_rows(count);
  thermoroll::write_study_figure(figure, rows);
  thermoroll::write_study_table(table, rows);
  thermoroll::write_study_kinds(kinds, rows);
  thermoroll::write_study_values(values, rows);
  thermoroll::write_study_sample(sample, rows);
  const bool summed_up = figure.flush() && table.flush() && kinds.flush();
  return summed_up && values.flush() && sample.flush() ? 0 : 1;
}
