#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "points.hpp"

namespace thermoroll_test {

// By which gnuplot puts the base of a text below its place.
constexpr double half_a_letter = 5.53;

/// The sample left of a text of a key, outside of the curves.
std::optional<Item> sample_of(const Picture& picture, const Item& text);

/// Whether the texts of a panel name what the rows of labels.csv, in the same order, say that they
/// do. `plots` has the curves by their titles, and `curves` their rows of curves.csv.
void check_labels(const Picture& picture, const Panel& panel, const std::vector<Row>& rows,
                  const std::vector<Row>& curves, const std::map<std::string, int>& plots,
                  const Table& table, const std::vector<Item>& texts, Wrong& wrong);

}  // namespace thermoroll_test
