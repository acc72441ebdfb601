#include "axes.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace thermoroll_test {

namespace {

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

/// The axis on which two values have two places.
Axis through(const Tic& a, const Tic& b, bool logarithmic) {
  Axis axis;
  axis.logarithmic = logarithmic;
  axis.unit = (b.place - a.place) / (axis.scaled(b.value) - axis.scaled(a.value));
  axis.zero = a.place - axis.unit * axis.scaled(a.value);
  return axis;
}

/// The tics of an axis of a panel: below, to the left, or to the right of a colour scale. A tic's
/// line stands before its label.
std::vector<Tic> tics(const Picture& picture, int panel, char axis) {
  const std::string anchor = axis == 'x' ? "middle" : axis == 'y' ? "end" : "start";
  std::vector<Tic> result;
  for (std::size_t i = 1; i < picture.items.size(); ++i) {
    const Item& label = picture.items[i];
    if (!is_tic(label) || label.what.empty()) continue;
    if (label.panel != panel || label.anchor != anchor) continue;
    const Place line = picture.items[i - 1].points.at(0);
    result.push_back({value_of(label.what), axis == 'x' ? line.x : line.y});
  }
  return result;
}

Axis read_axis(const Picture& picture, int panel, const Row& row, double first, double last,
               Wrong& wrong) {
  const double from = std::stod(row.at("from")), to = std::stod(row.at("to"));
  const bool logarithmic = row.at("scale") == "log";
  // Without tics, as beside a panel that has them, the curves alone tell whether it is so.
  if (row.at("scale") == "bare") return through({from, first}, {to, last}, false);
  if (row.at("scale") == "bare log") return through({from, first}, {to, last}, true);
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

}  // namespace

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

bool is_tic(const Item& item) { return item.kind == Item::text && item.colour == "rgb(0,0,0)"; }

Panel read_panel(const Picture& picture, int number, const std::vector<Row>& axes, Wrong& wrong) {
  Panel panel;
  const auto box = split(picture.view_box, ' ');
  panel.right = std::stod(box.at(2));
  panel.bottom = std::stod(box.at(3));
  for (const Item& item : picture.items)  // the frame: down the left side and to the right
    if (item.plot < 0 && item.panel == number && item.kind == Item::line &&
        item.colour == "rgb(0,0,0)" && item.points.size() == 3) {
      panel.left = item.points[0].x;
      panel.top = item.points[0].y;
      panel.right = item.points[2].x;
      panel.bottom = item.points[2].y;
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

}  // namespace thermoroll_test
