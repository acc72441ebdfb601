#pragma once
#include <limits>
#include <string>
#include <vector>

#include "axes.hpp"
#include "table.hpp"

namespace thermoroll_test {

struct Datum {
  Place place;  ///< where it must stand
  double z;     ///< the third column, where there is one
};

/// The time of a run in the data of the benchmarks, 0 if it has none.
double seconds_of(const std::string& name);

/// The points that a row of curves.csv says a curve must show. Columns may be lists of numbers:
/// points that no data have.
std::vector<Datum> expected(const Table& table, const Row& curve, const Panel& panel);
Polyline places_of(const std::vector<Datum>& points);

double distance(const Place& a, const Place& b);
bool near_one_of(const Polyline& places, const Place& p, double tolerance = pixel);

/// What was drawn of one curve, without its sample in a key above the frame.
std::vector<Item> drawn(const Picture& picture, int plot, const Panel& panel);
Polyline vertices(const std::vector<Item>& items, Item::Kind kind);

/// A line goes through its data and nowhere else; the border of an area may follow the frame, too.
void check_line(const Polyline& wanted, const Polyline& found, const Panel& panel, bool area,
                Wrong& wrong);
/// Points stand on data, and every datum has one.
void check_points(const Polyline& wanted, const Polyline& found, const Panel& panel, Wrong& wrong);
/// Points stand on data, and every datum has one of all the points not farther than 3.5 % of the
/// plot.
void check_thinned(const Polyline& wanted, const Polyline& found, const Polyline& all,
                   const Panel& panel, Wrong& wrong);

}  // namespace thermoroll_test
