#include "drawing.hpp"

#include <fnmatch.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "curves.hpp"
#include "svg.hpp"

namespace thermoroll_test {

namespace {

// gnuplot writes pixels to a hundredth. A tic and a point are off by half of one each, a tic beyond
// which an axis goes on by up to as much as it is long by twice that, and a line that is cut at the
// frame, by whole hundredths, by one more: 0.005 (1 + 2) + 0.01 < 0.03.
constexpr double pixel = 0.03;

using Wrong = std::vector<std::string>;

std::string at(const Place& place) {
  char text[60];
  std::snprintf(text, sizeof text, " at (%.2f, %.2f)", place.x, place.y);
  return text;
}

std::vector<std::string> split(const std::string& text, char by) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, by);) parts.push_back(part);
  return parts;
}

// --- The declared tables
// --------------------------------------------------------------------------

using Row = std::map<std::string, std::string>;

/// The rows of expected/NAME.csv that are of the figure; its name there may be a pattern.
std::vector<Row> declared(const std::string& name, const std::string& figure) {
  const Table table =
      read_table(std::string(THERMOROLL_ROOT) + "/tests/figures/expected/" + name + ".csv");
  std::vector<Row> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (fnmatch(table.text(i, "figure").c_str(), figure.c_str(), 0) != 0) continue;
    Row row;
    for (const std::string& column : table.header) row[column] = table.text(i, column);
    rows.push_back(row);
  }
  return rows;
}

std::vector<Row> of_panel(const std::vector<Row>& rows, int panel) {
  std::vector<Row> result;
  for (const Row& row : rows)
    if (std::stoi(row.at("panel")) == panel + 1) result.push_back(row);
  return result;
}

// --- Axes
// -----------------------------------------------------------------------------------------

struct Tic {
  double value, place;
};

/// The number that the label of a tic says: "−1", "10^−4", "50 %", "0.1 ms".
double value_of(std::string label) {
  for (std::size_t minus = 0; (minus = label.find("−")) != label.npos;)
    label.replace(minus, std::string("−").size(), "-");
  if (const std::size_t power = label.find("10^"); power != label.npos)
    return std::pow(10, std::stod(label.substr(power + 3)));
  std::size_t end = 0;
  const double number = std::stod(label, &end);
  const std::string unit = label.substr(label.find_first_not_of(' ', end) == label.npos
                                            ? label.size()
                                            : label.find_first_not_of(' ', end));
  const std::map<std::string, double> units{
      {"", 1}, {"%", 0.01}, {"s", 1}, {"ms", 1e-3}, {"µs", 1e-6}};
  return number * units.at(unit);
}

struct Axis {
  bool logarithmic = false;
  double zero = 0, unit = 1;  ///< the place of a value is zero + unit * scaled(value)

  double scaled(double value) const { return logarithmic ? std::log10(value) : value; }
  double place(double value) const { return zero + unit * scaled(value); }
  double scaled_at(double place) const { return (place - zero) / unit; }
};

/// The axis on which two values have two places.
Axis through(const Tic& a, const Tic& b, bool logarithmic) {
  Axis axis;
  axis.logarithmic = logarithmic;
  axis.unit = (b.place - a.place) / (axis.scaled(b.value) - axis.scaled(a.value));
  axis.zero = a.place - axis.unit * axis.scaled(a.value);
  return axis;
}

struct Panel {
  double left = 0, right = 0, top = 0, bottom = 0;
  Axis x, y;
  std::optional<Axis> colour;

  bool holds(const Place& p) const {
    return p.x > left - pixel && p.x < right + pixel && p.y > top - pixel && p.y < bottom + pixel;
  }
  Place place(double a, double b) const { return {x.place(a), y.place(b)}; }
};

bool is_tic(const Item& item) { return item.kind == Item::text && item.colour == "rgb(0,0,0)"; }

/// The tics of an axis of a panel: below, to the left, or to the right of a colour scale. A tic's
/// line stands before its label.
std::vector<Tic> tics(const Picture& picture, int panel, char axis) {
  const std::string anchor = axis == 'x' ? "middle" : axis == 'y' ? "end" : "start";
  std::vector<Tic> result;
  for (std::size_t i = 1; i < picture.items.size(); ++i) {
    const Item& label = picture.items[i];
    if (!is_tic(label) || label.panel != panel || label.anchor != anchor) continue;
    const Place line = picture.items[i - 1].points.at(0);
    result.push_back({value_of(label.what), axis == 'x' ? line.x : line.y});
  }
  return result;
}

Axis read_axis(const Picture& picture, int panel, const Row& row, double first, double last,
               Wrong& wrong) {
  const double from = std::stod(row.at("from")), to = std::stod(row.at("to"));
  const bool logarithmic = row.at("scale") == "log";
  if (row.at("scale") == "bare") return through({from, first}, {to, last}, false);
  const std::string name = row.at("axis") + " axis";
  std::vector<Tic> found = tics(picture, panel, row.at("axis")[0]);
  if (found.size() < 2) throw std::runtime_error(name + ": no tics");
  const auto by_value = [](const Tic& a, const Tic& b) { return a.value < b.value; };
  std::sort(found.begin(), found.end(), by_value);
  if (logarithmic && !(found.front().value > 0)) throw std::runtime_error(name + ": a tic at 0");
  const Axis axis = through(found.front(), found.back(), logarithmic);
  for (const Tic& tic : found)
    if (!(std::abs(axis.place(tic.value) - tic.place) < pixel))
      wrong.push_back(name + ": no " + row.at("scale") + " scale");
  if (!(std::abs(axis.place(from) - first) < pixel && std::abs(axis.place(to) - last) < pixel))
    wrong.push_back(name + ": it does not go from " + row.at("from") + " to " + row.at("to"));
  return axis;
}

Panel read_panel(const Picture& picture, int number, const std::vector<Row>& axes, Wrong& wrong) {
  Panel panel;
  const auto box = split(picture.view_box, ' ');
  panel.right = std::stod(box.at(2)), panel.bottom = std::stod(box.at(3));
  for (const Item& item : picture.items)  // the frame: down the left side and to the right
    if (item.plot < 0 && item.panel == number && item.kind == Item::line &&
        item.colour == "rgb(0,0,0)" && item.points.size() == 3) {
      panel.left = item.points[0].x, panel.top = item.points[0].y;
      panel.right = item.points[2].x, panel.bottom = item.points[2].y;
    }
  for (const Row& row : axes) {
    const char axis = row.at("axis")[0];
    if (axis == 'x')
      panel.x = read_axis(picture, number, row, panel.left, panel.right, wrong);
    else if (axis == 'y')
      panel.y = read_axis(picture, number, row, panel.bottom, panel.top, wrong);
    else
      panel.colour = read_axis(picture, number, row, panel.bottom, panel.top, wrong);
  }
  return panel;
}

// --- Data
// -----------------------------------------------------------------------------------------

/// What the formulas as printed should lose, @eq:digits-lost.
double law(const std::string& name, double zeta) {
  if (name == "law slope") return std::log10(2 * zeta);
  if (name == "law near") return std::log10(1 / (zeta * std::log(2 / zeta)));
  return std::log10(std::sqrt(pi / 2 * zeta));  // law far
}

double seconds_of(const std::string& name) {
  static const Table times = data("times");
  for (std::size_t i = 0; i < times.rows.size(); ++i)
    if (times.text(i, "name") == name) return times.number(i, "seconds");
  return 0;  // as in the scripts: nothing to be drawn on a logarithmic axis
}

/// A column, a column times a factor, its logarithm, a time or a law.
double quantity(const Table& table, std::size_t row, const std::string& what) {
  if (what.rfind("law ", 0) == 0) return law(what, table.number(row, "zeta"));
  if (what == "seconds") return seconds_of(table.text(row, "name"));
  if (what.rfind("log10 ", 0) == 0) return std::log10(table.number(row, what.substr(6)));
  const std::size_t times = what.find('*');
  if (times == what.npos) return table.number(row, what);
  return std::stod(what.substr(0, times)) * table.number(row, what.substr(times + 1));
}

/// Whether a row is one of those meant: every condition holds, as "method=printed" or "zeta>3".
bool meant(const Table& table, std::size_t row, const std::string& where) {
  for (const std::string& condition : split(where, ';')) {
    const std::size_t sign = condition.find_first_of("=<>");
    const std::string name = condition.substr(0, sign), value = condition.substr(sign + 1);
    bool holds = false;
    if (name == "every")
      holds = row % std::stoul(value) == 0;
    else if (condition[sign] == '=')
      holds = table.text(row, name) == value;
    else if (condition[sign] == '<')
      holds = table.number(row, name) < std::stod(value);
    else
      holds = table.number(row, name) > std::stod(value);
    if (!holds) return false;
  }
  return true;
}

struct Datum {
  Place place;  ///< where it must stand
  double z;     ///< the third column, where there is one
};

/// The points that a curve must show. Columns may be lists of numbers: points that no data have.
std::vector<Datum> expected(const Table& table, const Row& curve, const Panel& panel) {
  std::vector<Datum> result;
  if (curve.at("x").find(' ') != std::string::npos) {
    const auto x = split(curve.at("x"), ' '), y = split(curve.at("y"), ' ');
    for (std::size_t i = 0; i < x.size(); ++i)
      result.push_back({panel.place(std::stod(x[i]), std::stod(y.at(i))), 0});
    return result;
  }
  const bool has_z = !curve.at("z").empty() && curve.at("mark") != "text";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (!meant(table, row, curve.at("where"))) continue;
    const Place place =
        panel.place(quantity(table, row, curve.at("x")), quantity(table, row, curve.at("y")));
    const double z = has_z ? quantity(table, row, curve.at("z")) : 0;
    if (std::isfinite(place.x) && std::isfinite(place.y)) result.push_back({place, z});
  }
  return result;
}

// --- Distances
// ------------------------------------------------------------------------------------

double distance(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double distance_to_segment(const Place& p, const Place& a, const Place& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  if (square == 0) return distance(p, a);
  const double share = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
  return distance(p, {a.x + share * dx, a.y + share * dy});
}

double distance_to(const Polyline& line, const Place& p) {
  double least = line.empty() ? std::numeric_limits<double>::infinity() : distance(p, line[0]);
  for (std::size_t i = 1; i < line.size(); ++i)
    least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

bool near_one_of(const Polyline& places, const Place& p, double tolerance = pixel) {
  return std::any_of(places.begin(), places.end(),
                     [&](const Place& other) { return distance(other, p) < tolerance; });
}

// --- Curves
// ---------------------------------------------------------------------------------------

/// What was drawn of one curve, without its sample in a key above the frame.
std::vector<Item> drawn(const Picture& picture, int plot, const Panel& panel) {
  std::vector<Item> result;
  for (const Item& item : picture.items) {
    const auto above = [&](const Place& p) { return p.y < panel.top - pixel; };
    if (item.plot == plot && !std::all_of(item.points.begin(), item.points.end(), above))
      result.push_back(item);
  }
  return result;
}

Polyline vertices(const std::vector<Item>& items, Item::Kind kind) {
  Polyline result;
  for (const Item& item : items)
    if (item.kind == kind) result.insert(result.end(), item.points.begin(), item.points.end());
  return result;
}

Polyline places_of(const std::vector<Datum>& points) {
  Polyline result;
  for (const Datum& point : points) result.push_back(point.place);
  return result;
}

bool on_the_frame(const Panel& panel, const Place& p) {
  return std::min({std::abs(p.x - panel.left), std::abs(p.x - panel.right),
                   std::abs(p.y - panel.top), std::abs(p.y - panel.bottom)}) < pixel;
}

/// A line goes through its data and nowhere else; the border of an area may follow the frame, too.
void check_line(const Polyline& wanted, const Polyline& found, const Panel& panel, bool area,
                Wrong& wrong) {
  for (const Place& p : wanted)
    if (panel.holds(p) && !near_one_of(found, p)) wrong.push_back("no datum drawn" + at(p));
  for (const Place& p : found)
    if (!(distance_to(wanted, p) < pixel) && !(area && on_the_frame(panel, p)))
      wrong.push_back("no datum" + at(p));
}

/// Points stand on data, and every datum has one.
void check_points(const Polyline& wanted, const Polyline& found, const Panel& panel, Wrong& wrong) {
  for (const Place& p : wanted)
    if (panel.holds(p) && !near_one_of(found, p)) wrong.push_back("no datum drawn" + at(p));
  for (const Place& p : found)
    if (!near_one_of(wanted, p)) wrong.push_back("no datum" + at(p));
}

/// Points stand on data, and every datum has one of the panel's not farther than 3.5 % of the plot.
void check_thinned(const Polyline& wanted, const Polyline& found, const Polyline& all,
                   const Panel& panel, Wrong& wrong) {
  const auto near = [&](const Place& p) {
    return std::any_of(all.begin(), all.end(), [&](const Place& q) {
      return std::hypot((p.x - q.x) / (panel.right - panel.left),
                        (p.y - q.y) / (panel.bottom - panel.top)) < 0.035 + 1e-3;
    });
  };
  for (const Place& p : wanted)
    if (panel.holds(p) && !near(p)) wrong.push_back("no datum drawn" + at(p));
  for (const Place& p : found)
    if (!near_one_of(wanted, p)) wrong.push_back("no datum" + at(p));
}

// --- Contours
// -------------------------------------------------------------------------------------

/// Data on a grid, in pixels; what is no number is NaN.
struct Grid {
  std::vector<double> x, y;
  std::vector<std::vector<double>> z;  ///< z[i][j] at x[i], y[j]
};

/// The values of a coordinate, in order; rounding may have told equal ones apart.
std::vector<double> lines_of(const std::vector<Datum>& points, double Place::*coordinate) {
  std::vector<double> all, result;
  for (const Datum& point : points) all.push_back(point.place.*coordinate);
  std::sort(all.begin(), all.end());
  for (const double value : all)
    if (result.empty() || value > result.back() + pixel) result.push_back(value);
  return result;
}

std::size_t line_at(const std::vector<double>& lines, double value) {
  const auto nearest = std::min_element(lines.begin(), lines.end(), [&](double a, double b) {
    return std::abs(a - value) < std::abs(b - value);
  });
  return static_cast<std::size_t>(nearest - lines.begin());
}

Grid grid_of(const std::vector<Datum>& points) {
  Grid grid{lines_of(points, &Place::x), lines_of(points, &Place::y), {}};
  grid.z.assign(grid.x.size(), std::vector<double>(grid.y.size(), std::nan("")));
  for (const Datum& p : points)
    grid.z[line_at(grid.x, p.place.x)][line_at(grid.y, p.place.y)] = p.z;
  return grid;
}

/// The value at a place, bilinear in its cell, and by how much another interpolation of the cell's
/// corners and a shift of two hundredths of a pixel may differ from it.
struct Interpolated {
  double value, doubt;
};

Interpolated interpolate(const Grid& grid, const Place& p) {
  const auto cell = [](const std::vector<double>& lines, double value) {
    const auto next = std::upper_bound(lines.begin() + 1, lines.end() - 1, value);
    return static_cast<std::size_t>(next - lines.begin()) - 1;
  };
  const std::size_t i = cell(grid.x, p.x), j = cell(grid.y, p.y);
  const double width = grid.x[i + 1] - grid.x[i], height = grid.y[j + 1] - grid.y[j];
  const double u = (p.x - grid.x[i]) / width, v = (p.y - grid.y[j]) / height;
  const double a = grid.z[i][j], b = grid.z[i + 1][j], c = grid.z[i][j + 1],
               d = grid.z[i + 1][j + 1];
  const double slope = std::max({a, b, c, d}) - std::min({a, b, c, d});
  return {(1 - u) * (1 - v) * a + u * (1 - v) * b + (1 - u) * v * c + u * v * d,
          std::abs(a + d - b - c) / 4 + 2 * pixel * slope / std::min(width, height)};
}

/// Where a level crosses the lines of the grid.
Polyline crossings(const Grid& grid, double level) {
  Polyline result;
  const auto between = [&](double a, double b) { return (a < level) != (b < level); };
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    for (std::size_t j = 0; j < grid.y.size(); ++j) {
      const double here = grid.z[i][j];
      if (i + 1 < grid.x.size() && between(here, grid.z[i + 1][j])) {
        const double share = (level - here) / (grid.z[i + 1][j] - here);
        result.push_back({grid.x[i] + share * (grid.x[i + 1] - grid.x[i]), grid.y[j]});
      }
      if (j + 1 < grid.y.size() && between(here, grid.z[i][j + 1])) {
        const double share = (level - here) / (grid.z[i][j + 1] - here);
        result.push_back({grid.x[i], grid.y[j] + share * (grid.y[j + 1] - grid.y[j])});
      }
    }
  return result;
}

/// Every vertex stands on a level, and most crossings of a level with the grid are vertices: not
/// those where a label has its gap, nor those beside what was not computed.
void check_contour(const Grid& grid, const std::string& levels, const Polyline& found,
                   Wrong& wrong) {
  for (const Place& p : found) {
    const Interpolated here = interpolate(grid, p);
    bool on_one = !std::isfinite(here.value);  // beside what was not computed
    for (const std::string& level : split(levels, ' '))
      on_one |= std::abs(here.value - std::stod(level)) <= here.doubt;
    if (!on_one) wrong.push_back("no level" + at(p));
  }
  for (const std::string& level : split(levels, ' ')) {
    int seen = 0, all = 0;
    for (const Place& p : crossings(grid, std::stod(level))) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
      ++all;
      seen += near_one_of(found, p) ? 1 : 0;
    }
    if (2 * seen <= all)
      wrong.push_back("level " + level + ": " + std::to_string(seen) + " of " +
                      std::to_string(all) + " crossings drawn");
  }
}

// --- Maps
// -----------------------------------------------------------------------------------------

using Colour = std::array<int, 3>;

Colour colour_of(const std::string& rgb) {
  Colour colour{};
  if (std::sscanf(rgb.c_str(), "rgb(%d,%d,%d)", &colour[0], &colour[1], &colour[2]) != 3)
    throw std::runtime_error("no colour: " + rgb);
  return colour;
}

std::vector<unsigned char> from_base64(const std::string& text) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  unsigned buffer = 0, bits = 0;
  for (const char letter : text) {
    const std::size_t value = letters.find(letter);
    if (value == letters.npos) continue;  // a line's end, or the padding
    buffer = buffer << 6 | static_cast<unsigned>(value), bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes.push_back(static_cast<unsigned char>(buffer >> bits & 0xFF));
  }
  return bytes;
}

struct Bitmap {
  std::size_t width = 0, height = 0;
  std::vector<unsigned char> bytes;

  Colour at(std::size_t column, std::size_t row) const {
    const unsigned char* start = &bytes.at(3 * (row * width + column));
    return {start[0], start[1], start[2]};
  }
};

Bitmap read_png(const std::string& address) {
  const std::vector<unsigned char> file = from_base64(address.substr(address.find(',') + 1));
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, file.data(), file.size()) == 0)
    throw std::runtime_error("no image");
  png.format = PNG_FORMAT_RGB;
  Bitmap bitmap{png.width, png.height, std::vector<unsigned char>(PNG_IMAGE_SIZE(png))};
  if (png_image_finish_read(&png, nullptr, bitmap.bytes.data(), 0, nullptr) == 0)
    throw std::runtime_error("no image");
  return bitmap;
}

/// The colour scale: its strips, from the lowest value up.
struct Strip {
  double bottom, top;  ///< in pixels
  Colour colour;
};

std::vector<Strip> colour_scale(const Picture& picture, const Panel& panel) {
  std::vector<Strip> strips;
  for (const Item& item : picture.items)
    if (item.plot < 0 && item.kind == Item::area && item.points.at(0).x > panel.right)
      strips.push_back({item.points.at(0).y, item.points.at(2).y, colour_of(item.colour)});
  if (strips.size() < 2) return strips;
  Strip beyond =
      strips.back();  // a strip has the colour of its lower end: what the scale ends with
  for (std::size_t channel = 0; channel < 3; ++channel)
    beyond.colour[channel] += beyond.colour[channel] - strips[strips.size() - 2].colour[channel];
  strips.push_back(beyond);
  return strips;
}

/// Whether a colour is that of the strips about a value, to one strip up or down.
bool is_colour_of(const Colour& colour, double place, const std::vector<Strip>& strips) {
  std::size_t k = 0;
  while (k + 2 < strips.size() && strips[k].top > place) ++k;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    int low = 255, high = 0;
    for (std::size_t i = k == 0 ? 0 : k - 1; i < std::min(k + 2, strips.size()); ++i) {
      low = std::min(low, strips[i].colour[channel]);
      high = std::max(high, strips[i].colour[channel]);
    }
    if (colour[channel] < low - 1 || colour[channel] > high + 1) return false;
  }
  return true;
}

/// The picture's cells have the places and, by the colour scale, the values of the data.
void check_map(const std::vector<Datum>& points, const Picture& picture,
               const std::vector<Item>& items, const Panel& panel, Wrong& wrong) {
  if (items.size() != 1 || items[0].kind != Item::image) return wrong.push_back("no map");
  if (!panel.colour) return wrong.push_back("no colour scale");
  const Bitmap bitmap = read_png(items[0].what);
  const Place first = items[0].points[0], last = items[0].points[1];
  const std::vector<Strip> strips = colour_scale(picture, panel);
  if (points.size() != bitmap.width * bitmap.height || strips.size() < 50)
    return wrong.push_back("not as many cells as data");
  const double width = (last.x - first.x) / static_cast<double>(bitmap.width);
  const double height = (last.y - first.y) / static_cast<double>(bitmap.height);
  for (const Datum& p : points) {
    const double column = (p.place.x - first.x) / width - 0.5;
    const double row = (p.place.y - first.y) / height - 0.5;
    const double aside =
        std::max(std::abs(column - std::round(column)), std::abs(row - std::round(row)));
    if (!(aside < 0.25) || !panel.holds(p.place)) return wrong.push_back("no cell" + at(p.place));
    const Colour colour = bitmap.at(static_cast<std::size_t>(std::lround(column)),
                                    static_cast<std::size_t>(std::lround(row)));
    if (!is_colour_of(colour, panel.colour->place(p.z), strips))
      wrong.push_back("a colour of another value" + at(p.place));
  }
}

/// Filled cells stand on the data and have the colour that the key gives to their value.
void check_cells(const std::vector<Datum>& points, const std::vector<Item>& items,
                 const std::map<int, std::string>& key, Wrong& wrong) {
  if (items.size() != points.size()) wrong.push_back("not as many cells as data");
  for (const Item& item : items) {
    const Place a = item.points.at(0), b = item.points.at(2);
    const Place middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const auto datum = std::find_if(points.begin(), points.end(), [&](const Datum& p) {
      return distance(p.place, middle) < pixel;
    });
    if (datum == points.end())
      wrong.push_back("no datum" + at(middle));
    else if (const auto known = key.find(static_cast<int>(datum->z));
             known == key.end() || known->second != item.colour)
      wrong.push_back("another colour than in the key" + at(middle));
  }
}

/// Strokes stand on the data.
void check_hatch(const Polyline& wanted, const std::vector<Item>& items, Wrong& wrong) {
  Polyline middles;
  for (const Item& item : items)
    middles.push_back({(item.points.at(0).x + item.points.at(1).x) / 2,
                       (item.points.at(0).y + item.points.at(1).y) / 2});
  for (const Place& p : wanted)
    if (!near_one_of(middles, p)) wrong.push_back("not hatched" + at(p));
  for (const Place& p : middles)
    if (!near_one_of(wanted, p)) wrong.push_back("hatched" + at(p));
}

// --- Texts
// ----------------------------------------------------------------------------------------

constexpr double half_a_letter = 5.53;  // by which gnuplot puts the base of a text below its place

struct Box {
  Place low, high;
};

/// About where a text of the picture stands: letters are half as wide as they are high.
Box box_of(const Item& text) {
  double letters = 0;
  for (const char byte : text.what) letters += (byte & 0xC0) != 0x80 && byte != '^' ? 1 : 0;
  const double width = 0.5 * text.size * letters;
  const Place p = text.points.at(0);
  const double left = text.anchor == "start" ? p.x
                      : text.anchor == "end" ? p.x - width
                                             : p.x - width / 2;
  return {{left, p.y - 0.7 * text.size}, {left + width, p.y}};
}

double distance_to(const Box& box, const Place& p) {
  return std::hypot(std::max({box.low.x - p.x, p.x - box.high.x, 0.0}),
                    std::max({box.low.y - p.y, p.y - box.high.y, 0.0}));
}

/// What is drawn of a curve is nowhere nearer to the box than this. Segments are walked in pixels.
double distance_to(const std::vector<Item>& items, const Box& box) {
  double least = std::numeric_limits<double>::infinity();
  for (const Item& item : items)
    for (std::size_t i = 0; i < item.points.size(); ++i) {
      const Place b = item.points[i],
                  a = i == 0 || item.kind == Item::mark ? b : item.points[i - 1];
      const int steps = 1 + static_cast<int>(distance(a, b));
      for (int k = 0; k <= steps; ++k)
        least = std::min(least, distance_to(box, {a.x + (b.x - a.x) * k / steps,
                                                  a.y + (b.y - a.y) * k / steps}));
    }
  return least;
}

/// Where a label points: the far end of a thin line that starts beside it, or else the label
/// itself.
Box pointer_of(const Picture& picture, const Item& label) {
  const Box box = box_of(label);
  for (const Item& item : picture.items)
    if (item.plot < 0 && item.panel == label.panel && item.kind == Item::line &&
        item.points.size() == 2 && item.what.empty() && item.colour == "rgb(127,127,127)")
      for (const bool turned : {false, true}) {
        const Place near = item.points[turned ? 1 : 0], far = item.points[turned ? 0 : 1];
        if (distance_to(box, near) < 6) return {far, far};
      }
  return box;
}

/// The sample left of a text of a key, outside of the curves.
std::optional<Item> sample_of(const Picture& picture, const Item& label) {
  const Place p = label.points.at(0);
  for (const Item& item : picture.items) {
    if (item.plot >= 0 || item.panel != label.panel || item.points.empty()) continue;
    if (item.kind != Item::mark && item.kind != Item::line) continue;
    const auto beside = [&](const Place& q) {
      return std::abs(q.y - (p.y - half_a_letter)) < 7 && q.x < p.x && q.x > p.x - 40;
    };
    if (std::all_of(item.points.begin(), item.points.end(), beside)) return item;
  }
  return std::nullopt;
}

/// A text and what it is declared to be, within a panel.
struct Label {
  Item text;
  Row row;
};

void check_place(const Label& label, const Panel& panel, Wrong& wrong) {
  const Place p = label.text.points.at(0);
  const Box box = box_of(label.text);
  const std::string& is = label.row.at("is");
  const bool above = p.y < panel.top - 5;
  const bool ok = is == "x" ? label.text.anchor == "middle" && p.y > panel.bottom + 30 &&
                                  std::abs(p.x - (panel.left + panel.right) / 2) < 1
                  : is == "colour" ? above && box.high.x > panel.right
                                   : above && box.low.x < panel.left + 12;  // y, heading
  if (!ok) wrong.push_back("'" + label.text.what + "' does not stand beside its axis");
}

void check_key(const Picture& picture, const Label& label, int plot, Wrong& wrong) {
  if (label.text.plot >= 0) {  // gnuplot's own key: the sample is of the same curve
    if (label.text.plot != plot) wrong.push_back("'" + label.text.what + "' names another curve");
    return;
  }
  const std::optional<Item> sample = sample_of(picture, label.text);
  for (const Item& item : picture.items)
    if (sample && item.plot == plot && item.kind == sample->kind &&
        (item.colour == sample->colour || sample->colour == "black") &&
        (item.kind == Item::line || item.what == sample->what))
      return;
  wrong.push_back("the sample of '" + label.text.what + "' looks like no part of its curve");
}

void check_name(const Picture& picture, const Label& label, int plot, const Panel& panel,
                const std::set<int>& named, Wrong& wrong) {
  const Box pointer = pointer_of(picture, label.text);
  const std::vector<Item> own = drawn(picture, plot, panel);
  for (const int other : named) {
    const std::vector<Item> items = drawn(picture, other, panel);
    if (items.at(0).kind == own.at(0).kind &&
        distance_to(items, pointer) < distance_to(own, pointer))
      wrong.push_back("'" + label.text.what + "' stands nearer to '" +
                      picture.plots[static_cast<std::size_t>(other)] + "'");
  }
}

/// The lines of no other level are nearer.
void check_level(const Label& label, const Grid& grid, const std::string& levels, Wrong& wrong) {
  const Box box = box_of(label.text);
  const auto distance_to_level = [&](const std::string& level) {
    double least = std::numeric_limits<double>::infinity();
    for (const Place& p : crossings(grid, std::stod(level)))
      least = std::min(least, distance_to(box, p));
    return least;
  };
  const double own = distance_to_level(label.row.at("of"));
  for (const std::string& level : split(levels, ' '))
    if (distance_to_level(level) < own)
      wrong.push_back("'" + label.text.what + "' stands nearer to the level " + level);
}

// --- The whole
// ------------------------------------------------------------------------------------

void check_structure(const std::string& figure, const Picture& picture, std::size_t size,
                     Wrong& wrong) {
  const std::string height = figure.rfind("speed-", 0) == 0 ? "900"
                             : figure == "cost"             ? "640"
                                                            : "380";
  if (picture.view_box != "0 0 560 " + height) wrong.push_back("viewBox");
  std::string id = figure;
  std::replace(id.begin(), id.end(), '-', '_');
  if (picture.title != id) wrong.push_back("title");
  if (size > 300000) wrong.push_back("too large");
  for (const std::string& reference : picture.references)
    if (reference[0] != '#' && reference.rfind("data:", 0) != 0)
      wrong.push_back("something external");
  for (const Item& item : picture.items) {
    if (item.white) wrong.push_back("something white");
    for (const Place& p : item.points)
      if (std::min(p.x, p.y) < -40 || std::max(p.x, p.y) > 1000)
        wrong.push_back("a coordinate that is none" + at(p));
  }
}

void check_rules(const Picture& picture, int number, const Panel& panel,
                 const std::vector<Row>& rules, Wrong& wrong) {
  std::vector<Polyline> found;
  for (const Item& item : picture.items)
    if (item.plot < 0 && item.panel == number && item.kind == Item::line && !item.what.empty())
      found.push_back(item.points);
  if (found.size() != rules.size()) return wrong.push_back("not as many dashed lines as declared");
  for (std::size_t k = 0; k < rules.size(); ++k) {
    const Polyline wanted = places_of(expected({}, rules[k], panel));
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (!(distance(wanted[i], found[k].at(i)) < pixel))
        wrong.push_back(rules[k].at("curve") + ": it does not stand" + at(wanted[i]));
  }
}

void check_curve(const Picture& picture, int plot, const Row& row, const Table& table,
                 const Panel& panel, const std::map<int, std::string>& key, Wrong& wrong) {
  const std::vector<Item> items = drawn(picture, plot, panel);
  if (items.empty()) return wrong.push_back("an empty curve");
  const std::vector<Datum> points = expected(table, row, panel);
  const Polyline wanted = places_of(points);
  const std::string& mark = row.at("mark");
  const Polyline marks = vertices(items, Item::mark), lines = vertices(items, Item::line);
  if (mark == "line" || mark == "both") check_line(wanted, lines, panel, false, wrong);
  if (mark == "points" || mark == "both") check_points(wanted, marks, panel, wrong);
  if (mark == "area") check_line(wanted, vertices(items, Item::area), panel, true, wrong);
  if (mark == "map") check_map(points, picture, items, panel, wrong);
  if (mark == "cells") check_cells(points, items, key, wrong);
  if (mark == "hatch") check_hatch(wanted, items, wrong);
  if (mark == "contour") check_contour(grid_of(points), row.at("levels"), lines, wrong);
  if (mark == "thinned") {
    Polyline all;
    for (const Item& item : picture.items)
      if (item.plot >= 0 && item.kind == Item::mark) all.push_back(item.points[0]);
    check_thinned(wanted, marks, all, panel, wrong);
  }
  if (mark == "text") {
    const auto shift =
        split(row.at("z"), ' ');  // in letters: 0.7 times as wide and 1.5 times as high as the font
    for (const Item& item : items) {
      const Place p = item.points.at(0);
      const Place base{p.x - 0.7 * item.size * std::stod(shift.at(0)),
                       p.y - half_a_letter + 1.5 * item.size * std::stod(shift.at(1))};
      if (!near_one_of(wanted, base, 0.2)) wrong.push_back("'" + item.what + "' stands elsewhere");
    }
  }
}

void check_labels(const Picture& picture, const Panel& panel, const std::vector<Row>& rows,
                  const std::vector<Row>& curves, const std::map<std::string, int>& plots,
                  const Table& table, const std::vector<Item>& texts, Wrong& wrong) {
  std::set<int> named;
  for (const Row& row : rows)
    if (row.at("is") == "curve") named.insert(plots.at(row.at("of")));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Label label{texts[i], rows[i]};
    const std::string &is = rows[i].at("is"), &of = rows[i].at("of");
    if (is == "x" || is == "y" || is == "heading" || is == "colour")
      check_place(label, panel, wrong);
    if (is == "curve") check_name(picture, label, plots.at(of), panel, named, wrong);
    if (is == "key") check_key(picture, label, plots.at(of), wrong);
    if (is != "level") continue;
    for (const Row& curve : curves)
      if (curve.at("mark") == "contour") {
        check_level(label, grid_of(expected(table, curve, panel)), curve.at("levels"), wrong);
        break;
      }
  }
}

void check_panel(const std::string& figure, const Picture& picture, int number, Wrong& wrong) {
  const auto axes = of_panel(declared("axes", figure), number);
  const auto all = of_panel(declared("curves", figure), number);
  const auto labels = of_panel(declared("labels", figure), number);
  if (axes.empty() || all.empty()) return wrong.push_back("nothing is declared of a panel");
  const Panel panel = read_panel(picture, number, axes, wrong);

  std::vector<Row> curves, rules;
  for (const Row& row : all) (row.at("mark") == "rule" ? rules : curves).push_back(row);
  std::vector<int> plots;
  for (std::size_t k = 0; k < picture.plots.size(); ++k)
    if (picture.panels[k] == number) plots.push_back(static_cast<int>(k));
  std::string found, wanted;
  for (const int plot : plots) found += picture.plots[static_cast<std::size_t>(plot)] + "; ";
  for (const Row& row : curves) wanted += row.at("curve") + "; ";
  if (found != wanted) return wrong.push_back("curves: " + found + "instead of " + wanted);

  std::vector<Item> texts;
  std::string words, declared_words;
  for (const Item& item : picture.items)
    if (item.kind == Item::text && item.panel == number && !is_tic(item) && !item.what.empty())
      texts.push_back(item), words += item.what + "; ";
  for (const Row& row : labels) declared_words += row.at("text") + "; ";
  if (words != declared_words)
    return wrong.push_back("labels: " + words + "instead of " + declared_words);

  std::map<int, std::string> key;  // colours of cells
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i].at("is") == "cells")
      if (const auto sample = sample_of(picture, texts[i]))
        key[std::stoi(labels[i].at("of"))] = sample->colour;

  const Table table = data(figure);
  std::map<std::string, int> places;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    places[curves[k].at("curve")] = plots[k];
    Wrong here;
    check_curve(picture, plots[k], curves[k], table, panel, key, here);
    for (const std::string& what : here) wrong.push_back(curves[k].at("curve") + ": " + what);
  }
  check_rules(picture, number, panel, rules, wrong);
  check_labels(picture, panel, labels, curves, places, table, texts, wrong);
}

}  // namespace

std::vector<std::string> wrong_in(const std::string& figure, const std::string& svg) {
  Wrong wrong;
  try {
    const Picture picture = read_svg(svg);
    check_structure(figure, picture, svg.size(), wrong);
    if (picture.panels.empty()) return {"no curves"};
    for (int panel = 0; panel <= picture.panels.back(); ++panel)
      check_panel(figure, picture, panel, wrong);
  } catch (const std::exception& error) {
    wrong.push_back(error.what());
  }
  return wrong;
}

}  // namespace thermoroll_test
