#pragma once
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "svg.hpp"

namespace thermoroll_test {

// gnuplot writes pixels to a hundredth. A tic and a point are off by half of one each, a tic beyond
// which an axis goes on by up to as much as it is long by twice that, and a line that is cut at the
// frame, by whole hundredths, by one more: 0.005 (1 + 2) + 0.01 < 0.03.
constexpr double pixel = 0.03;

using Row = std::map<std::string, std::string>;  ///< of a declared table, by its columns
using Wrong = std::vector<std::string>;          ///< what is wrong, a line each

std::string at(const Place& place);  ///< " at (x, y)"
std::vector<std::string> split(const std::string& text, char by);

struct Axis {
  bool logarithmic = false;
  double zero = 0, unit = 1;

  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  /// Where a value stands, in pixels.
  double place(double value) const { return zero + unit * scaled(value); }
};

/// A frame with its axes, and the colour scale beside it.
struct Panel {
  double left = 0, right = 0, top = 0, bottom = 0;
  Axis x, y;
  std::optional<Axis> colour;

  bool holds(const Place& p) const {
    return p.x > left - pixel && p.x < right + pixel && p.y > top - pixel && p.y < bottom + pixel;
  }
  Place place(double a, double b) const { return {x.place(a), y.place(b)}; }
};

/// Whether it is the label of a tic: alone of all texts these have a colour in numbers and are
/// black.
bool is_tic(const Item& item);

/// Reads the axes of a panel from the places and labels of their tics, and compares their scales
/// and ends with the rows of axes.csv.
Panel read_panel(const Picture& picture, int number, const std::vector<Row>& axes, Wrong& wrong);

}  // namespace thermoroll_test
