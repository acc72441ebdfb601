// Tangled from paper/B-data-files.md; edit there.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace thermoroll {

/// The names that write_figure_data knows.
std::vector<std::string> figure_data_names();

/// Write the data of that name: CSV with a header line, but JSON for "values". Throws
/// std::invalid_argument for an unknown name.
void write_figure_data(const std::string& name, std::ostream& out);

}  // namespace thermoroll
