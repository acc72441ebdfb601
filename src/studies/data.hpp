// Tangled from paper/F-data-files.md; edit there.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace thermoroll {

/// The data of one name, for a figure, a table or the prose. An object of it registers them before
/// main() begins. The program is linked from objects, as from an archive the linker would take only
/// what is called by name.
struct FigureData {
  FigureData(const std::string& name, std::function<void(std::ostream&)> write);
};

/// Write the cells of one row, separated by commas.
template <class First, class... Rest>
void row(std::ostream& out, const First& first, const Rest&... rest) {
  out << first;
  ((out << ',' << rest), ...);
  out << '\n';
}

/// n + 1 equidistant points from low to high.
std::vector<double> grid(double low, double high, int n);

/// Add the numbers that the prose quotes of a chapter, or of @fig:brief, as strings.
void values_on_resolution(nlohmann::ordered_json& v);
void values_on_digits(nlohmann::ordered_json& v);
void values_on_failures(nlohmann::ordered_json& v);
void values_on_least_model(nlohmann::ordered_json& v);
void values_on_what_heat_can_do(nlohmann::ordered_json& v);
void values_on_two_bodies(nlohmann::ordered_json& v);
void values_on_full_slip(nlohmann::ordered_json& v);
void values_on_hot_friction(nlohmann::ordered_json& v);
void values_on_strips(nlohmann::ordered_json& v);
void values_in_brief(nlohmann::ordered_json& v);

}  // namespace thermoroll
