// Tangled from paper/16-where-methods-fail.md, paper/F-data-files.md; edit there.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "thermoroll/coupled.hpp"

namespace thermoroll {

/// The names that write_figure_data knows, in alphabetical order.
std::vector<std::string> figure_data_names();

/// Write the data of that name: CSV with a header line, but JSON for "values". Throws
/// std::invalid_argument for an unknown name.
void write_figure_data(const std::string& name, std::ostream& out);

/// An admissible solution, one that violates a condition of contact, or a refusal.
enum class Outcome { contact, no_contact, refused };

/// How a solve ends; std::runtime_error is its refusal.
Outcome outcome(const std::function<CoupledSolution()>& solve);

}  // namespace thermoroll
