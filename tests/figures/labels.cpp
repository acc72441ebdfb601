#include "labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "maps.hpp"
#include "points.hpp"

namespace thermoroll_test {

namespace {

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

/// The number in it is the ratio of the times of two runs, to two digits.
void check_ratio(const Label& label, Wrong& wrong) {
  const auto names = split(label.row.at("of"), ' ');
  const double ratio = seconds_of(names.at(0)) / seconds_of(names.at(1));
  const std::size_t digit = label.text.what.find_first_of("0123456789");
  const double told = digit == std::string::npos ? 0 : std::stod(label.text.what.substr(digit));
  if (!(std::abs(told / ratio - 1) < 0.051)) wrong.push_back("'" + label.text.what + "' is wrong");
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

}  // namespace

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

void check_labels(const Picture& picture, const Panel& panel, const std::vector<Row>& rows,
                  const std::vector<Row>& curves, const std::map<std::string, int>& plots,
                  const Table& table, const std::vector<Item>& texts, Wrong& wrong) {
  std::set<int> named;
  for (const Row& row : rows)
    if (row.at("is") == "curve") named.insert(plots.at(row.at("of")));
  const auto contour = std::find_if(curves.begin(), curves.end(),
                                    [](const Row& curve) { return curve.at("mark") == "contour"; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Label label{texts[i], rows[i]};
    const std::string &is = rows[i].at("is"), &of = rows[i].at("of");
    if (is == "curve")
      check_name(picture, label, plots.at(of), panel, named, wrong);
    else if (is == "key")
      check_key(picture, label, plots.at(of), wrong);
    else if (is == "level")
      check_level(label, grid_of(expected(table, *contour, panel)), contour->at("levels"), wrong);
    else if (is == "ratio")
      check_ratio(label, wrong);
    else if (is == "x" || is == "y" || is == "heading" || is == "colour")
      check_place(label, panel, wrong);
    else if (is != "cells" && is != "text" && !is.empty())  // these are looked at with their curve
      wrong.push_back("labels.csv: what is '" + is + "'?");
  }
}

}  // namespace thermoroll_test
