#pragma once
#include <string>
#include <vector>

namespace thermoroll_test {

/// A place in a picture, in pixels, y downwards.
struct Place {
  double x, y;
};

using Polyline = std::vector<Place>;

/// One thing that gnuplot has drawn.
struct Item {
  enum Kind { line, mark, text, area, image } kind;
  int plot = -1;       ///< of which plot command's curve, counted from 0; -1 outside of them
  int panel = 0;       ///< of a picture with several, counted from 0
  bool white = false;  ///< in a group that would vanish on a light page
  std::string colour;  ///< as rgb(0,114,178)
  std::string what;    ///< a line's dashes, a mark's shape, a text's words, an image's address
  std::string anchor;  ///< of a text: start, middle, end
  double size = 0;     ///< of a text's letters
  Polyline points;  ///< of a line or an area; the one place of a mark or a text; an image's corners
};

/// A picture by gnuplot's svg terminal.
struct Picture {
  std::string title, view_box;
  std::vector<std::string> plots;       ///< the titles of the curves in the order of drawing
  std::vector<int> panels;              ///< of each of the curves
  std::vector<std::string> references;  ///< every xlink:href
  std::vector<Item> items;              ///< in the order of drawing
};

/// Reads a picture; throws std::runtime_error for what is not one or has a coordinate that is no
/// finite number. Raised letters of a text stand behind a ^.
Picture read_svg(const std::string& text);

}  // namespace thermoroll_test
