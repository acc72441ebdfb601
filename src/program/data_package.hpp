// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#pragma once

#include <string>

#include "program/table.hpp"

namespace thermoroll {

/// The Frictionless data package in the file `package` that describes the results in the file
/// `data`, as JSON. Throws std::invalid_argument unless `data` is in its folder, or in one below.
std::string data_package(const SweepTable& t, const std::string& data, const std::string& package);

}  // namespace thermoroll
