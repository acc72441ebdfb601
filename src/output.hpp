// Tangled from paper/A-command-line.md; edit there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "claims.hpp"
#include "solution.hpp"

namespace thermoroll {

enum class Format { text, json, csv };

/// A solution in a format. Throws NotConverged where a number of it is not finite.
std::string present(const Solution& x, const std::optional<PhysicalResults>& physical,
                    Format format);

/// The table of claims in a format.
std::string present(const std::vector<Claim>& claims, Format format);

/// A temperature curve as CSV, with a column for degree C if the units are known. Throws
/// NotConverged where a temperature is not finite.
std::string curve_csv(const Curve& curve, const std::optional<Units>& units);

/// Write the text to the file, as a whole or not at all, or to standard output if file is empty.
/// Throws std::system_error.
void deliver(const std::string& text, const std::string& file);

}  // namespace thermoroll
