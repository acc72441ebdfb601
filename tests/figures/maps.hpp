#pragma once
#include <map>
#include <string>
#include <vector>

#include "points.hpp"

namespace thermoroll_test {

/// Data on a grid, in pixels; what is no number is NaN.
struct Grid {
  std::vector<double> x, y;
  std::vector<std::vector<double>> z;  ///< z[i][j] at x[i], y[j]
};

Grid grid_of(const std::vector<Datum>& points);

/// Where a level crosses the lines of the grid.
Polyline crossings(const Grid& grid, double level);

/// Every vertex stands on a level, and most crossings of a level with the grid are vertices: not
/// those where a label has its gap, nor those beside what was not computed.
void check_contour(const Grid& grid, const std::string& levels, const Polyline& found,
                   Wrong& wrong);

/// The cells of an image have the places and, by the colour scale, the values of the data.
void check_map(const std::vector<Datum>& points, const Picture& picture,
               const std::vector<Item>& items, const Panel& panel, Wrong& wrong);

/// Filled cells stand on the data and have the colour that the key gives to their value.
void check_cells(const std::vector<Datum>& points, const std::vector<Item>& items,
                 const std::map<int, std::string>& key, Wrong& wrong);

/// Strokes stand on the data.
void check_hatch(const Polyline& wanted, const std::vector<Item>& items, Wrong& wrong);

}  // namespace thermoroll_test
