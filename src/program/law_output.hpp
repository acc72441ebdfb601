// Tangled from paper/22-creep-curve.md, paper/C-output.md; edit there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/names.hpp"
#include "thermoroll/creep_law.hpp"
#include "thermoroll/creep_law_by_speed.hpp"

namespace thermoroll {

enum class Language { c, python, modelica, json };
inline constexpr Name<Language> language_names[] = {{"c", Language::c},
                                                    {"python", Language::python},
                                                    {"modelica", Language::modelica},
                                                    {"json", Language::json}};

/// A law in a language, with its data in SI units if it has any; the scene and the data of a law
/// for a range of speeds are those at the lowest.
std::string law_text(const CreepLawBySpeed& law, const Scene& of, Formulation formulation,
                     const std::optional<PhysicalScene>& si, Language language);

/// The first and last creep xi*, where requested, and the number of rows.
struct CurveRange {
  double from, to;
  int points;
};

/// Creeps in a range of the law that are dense where the curve bends; the first and the last are
/// those of the range. At least two.
std::vector<double> curve_points(const CreepLaw& law, const CurveRange& range, double friction);

/// The law at these creeps, a row for each, with columns in SI units if they are known.
std::string creep_curve_csv(const CreepLaw& law, const std::vector<double>& creeps,
                            const std::optional<LawUnits>& units);

}  // namespace thermoroll
