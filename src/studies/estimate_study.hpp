// Tangled from paper/F-data-files.md; edit there.
#pragma once

#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "thermoroll/coupled.hpp"

namespace thermoroll {

/// A scene with what is given and the tolerance asked for.
struct StudyScene {
  Scene scene;
  Prescribed given;
  double tolerance;
};

/// The scene of that number.
StudyScene study_scene(int number);

/// What a scene has shown; a ratio is NaN where it is left out.
struct StudyRow {
  int number;
  double tolerance, error;
  std::array<double, compared> ratio;  // by Quantity
};

/// Solve the scene of that number, and once more to 1e-10; nothing where either is refused.
std::optional<StudyRow> study_row(int number);

/// The row as it stands in the file.
std::string line_of(const StudyRow& x);

/// Write the rows of so many scenes, with a header line, computed on all processors.
void write_study(int count, std::ostream& out);

/// The names that write_study_data knows.
std::vector<std::string> study_data_names();

/// Write data of that name from a file that write_study() has written: CSV with a header line, but
/// JSON for "study-values". Throws std::invalid_argument for an unknown name, std::runtime_error
/// for a file that is not such.
void write_study_data(const std::string& name, const std::string& path, std::ostream& out);

}  // namespace thermoroll
