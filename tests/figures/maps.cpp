#include "maps.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace thermoroll_test {

namespace {

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

/// The value at a place, bilinear in its cell, and by how much one that is linear in triangles of
/// the cell, and a shift by the tolerance of a place, may differ from it.
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
    buffer = buffer << 6 | static_cast<unsigned>(value);
    bits += 6;
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

}  // namespace

Grid grid_of(const std::vector<Datum>& points) {
  Grid grid{lines_of(points, &Place::x), lines_of(points, &Place::y), {}};
  grid.z.assign(grid.x.size(), std::vector<double>(grid.y.size(), std::nan("")));
  for (const Datum& p : points)
    grid.z[line_at(grid.x, p.place.x)][line_at(grid.y, p.place.y)] = p.z;
  return grid;
}

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

}  // namespace thermoroll_test
