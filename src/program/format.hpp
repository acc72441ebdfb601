// Tangled from paper/C-output.md; edit there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "program/names.hpp"
#include "studies/claims.hpp"
#include "thermoroll/solution.hpp"

namespace thermoroll {

/// The kind of the roller, as the options name it: identical if all of its constants are the same.
RollerKind kind_of(const Scene& scene);

/// A datum of a scene in SI units, by the name of its option.
struct SiDatum {
  const char* name;
  double value;
  const char* unit;
};

/// All of them; those of the second body if it is conducting.
std::vector<SiDatum> data_in_si(const PhysicalScene& x, bool conducting);

/// A solution in a format. Throws NotConverged where a number of it is not finite.
std::string present(const Solution& x, const std::optional<FoundInSi>& physical, Format format);

/// A column's name and a row's cell in it, not yet quoted.
struct Field {
  std::string name, cell;
};

/// Which optional columns a table has, beyond those of insulated rollers, constant friction and an
/// unknown bulk temperature.
struct MoreColumns {
  bool roller = false, law = false, bulk = false;
};

/// The names and cells of a solution as CSV; the names depend on nothing but whether there are
/// physical results and which columns are wanted. Throws NotConverged where a number of it is not
/// finite.
std::vector<Field> csv_fields(const Solution& x, const std::optional<FoundInSi>& physical,
                              const MoreColumns& with);

/// The symbol, if it has one, and the unit of a column of numbers; "1" if it is dimensionless.
struct ColumnMeaning {
  std::string symbol, unit;
};
ColumnMeaning meaning_of(const std::string& column);

/// A text as a cell of CSV: between quotes where it must be.
std::string quoted(std::string text);

/// The table of claims in a format.
std::string present(const std::vector<Claim>& claims, Format format);

/// A temperature curve, and its depth in units of a.
struct DepthCurve {
  double depth;
  Curve curve;
};

/// Temperature curves as CSV, with columns for m and degree C above the bulk if the units are
/// known, and for the depth if there are several. Throws NotConverged where a temperature is not
/// finite.
std::string curve_csv(const std::vector<DepthCurve>& curves, const std::optional<Units>& units);

/// A profile as CSV, with SI columns beside the dimensionless ones if the units are known.
std::string profile_csv(const Profile& x, const std::optional<Units>& units);

}  // namespace thermoroll
