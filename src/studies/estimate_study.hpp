// Tangled from paper/F-data-files.md; edit there.
#pragma once

#include <array>
#include <optional>
#include <ostream>
#include <vector>

#include "thermoroll/coupled.hpp"

namespace thermoroll {

enum class StudyKind {
  one_body,
  alike,
  unlike,
  bulk_difference,
  law,
  law_of_unlike,
  printed_sign,
  nearly_alike,
  full_slip
};

/// A scene with what is given and the tolerance asked for.
struct StudyScene {
  Scene scene;
  Prescribed given;
  double tolerance;
  StudyKind kind;
  Formulation formulation = Formulation::corrected;
};

/// The scene of that number.
StudyScene study_scene(int number);

/// What a scene has shown; a ratio is NaN where it is left out.
struct StudyRow {
  int number;
  StudyKind kind;
  double tolerance, error;
  std::array<double, compared> ratio;  // by Quantity
};

/// Solve the scene of that number, and once more to 1e-10, or else to 1e-8 if the tolerance is at
/// least ten times that; nothing where either is refused.
std::optional<StudyRow> study_row(int number);

/// The rows of the scenes below a number, in their order, computed on all processors.
std::vector<StudyRow> study_rows(int count);

/// The figure's data: largest errors by tolerance, and shares of the ratios. CSV.
void write_study_figure(std::ostream& out, const std::vector<StudyRow>& rows);

/// A row for each kind of scene. CSV.
void write_study_kinds(std::ostream& out, const std::vector<StudyRow>& rows);

/// A row for each quantity. CSV.
void write_study_table(std::ostream& out, const std::vector<StudyRow>& rows);

/// What the prose quotes. JSON.
void write_study_values(std::ostream& out, const std::vector<StudyRow>& rows);

/// Rows 50, 150, 250 ... to two digits. CSV.
void write_study_sample(std::ostream& out, const std::vector<StudyRow>& rows);

}  // namespace thermoroll
