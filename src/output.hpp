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

/// A temperature curve as CSV, with a column for degree C above ambient if the units are known.
/// Throws NotConverged where a temperature is not finite.
std::string curve_csv(const Curve& curve, const std::optional<Units>& units);

/// A profile as CSV, with SI columns beside the dimensionless ones if the units are known.
std::string profile_csv(const Profile& x, const std::optional<Units>& units);

/// A text and the file to write it to; standard output if file is empty.
struct Answer {
  std::string text, file;
};

/// Write the answers, each as a whole, or none where one cannot be written (what has gone to
/// standard output or a device stays there). Throws std::system_error.
void deliver(const std::vector<Answer>& answers);

}  // namespace thermoroll
