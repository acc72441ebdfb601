// The other ways in to the solver: C, a row of a sweep, and the law of all creeps.
#pragma once

#include <string>

#include "properties.hpp"
#include "thermoroll/solution.hpp"

namespace soak {

/// The functions for C give the numbers of the library, and the hottest point is the hottest.
void examine_in_c(const Record& record, const thermoroll::GivenScene& given);

/// A row of a sweep, some of whose options are the sweep's own, has the numbers of the library;
/// read again, it is the same row.
void examine_row(const Record& record, const std::string& options, std::uint64_t number,
                 const thermoroll::GivenScene& given);

/// The law of a scene in SI units is where the scene is, to ten times the errors of both.
void examine_law(const Record& record, const thermoroll::GivenScene& given);

}  // namespace soak
