#include "points.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "curves.hpp"

namespace thermoroll_test {

double seconds_of(const std::string& name) {
  static const Table times = data("times");
  for (std::size_t i = 0; i < times.rows.size(); ++i)
    if (times.text(i, "name") == name) return times.number(i, "seconds");
  return 0;  // as in the scripts: nothing to be drawn on a logarithmic axis
}

namespace {

/// What the formulas as printed should lose, @eq:digits-lost.
double law(const std::string& name, double zeta) {
  if (name == "law slope") return std::log10(2 * zeta);
  if (name == "law near") return std::log10(1 / (zeta * std::log(2 / zeta)));
  if (name == "law far") return std::log10(std::sqrt(pi / 2 * zeta));
  throw std::runtime_error("curves.csv: no " + name);
}

/// A temperature without the one on the square root of the speed through the last row of the law.
double beyond_law(const Table& table, std::size_t row) {
  std::size_t last = table.rows.size() - 1;
  while (table.text(last, "kind") != "law") --last;
  const double root = table.number(last, "celsius") / std::sqrt(table.number(last, "speed"));
  return table.number(row, "celsius") - root * std::sqrt(table.number(row, "speed"));
}

/// A column, a column times a factor, its logarithm, a time, a law, or what is beyond it.
double quantity(const Table& table, std::size_t row, const std::string& what) {
  if (what.rfind("law ", 0) == 0) return law(what, table.number(row, "zeta"));
  if (what == "celsius beyond law") return beyond_law(table, row);
  if (what == "seconds") return seconds_of(table.text(row, "name"));
  if (what.rfind("log10 ", 0) == 0) return std::log10(table.number(row, what.substr(6)));
  const std::size_t times = what.find('*');
  if (times == what.npos) return table.number(row, what);
  return std::stod(what.substr(0, times)) * table.number(row, what.substr(times + 1));
}

/// Whether no other run of its method has more digits at no more of a quantity, such as time.
bool is_best(const Table& table, std::size_t row, const std::string& cost) {
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (table.text(i, "method") == table.text(row, "method") &&
        table.number(i, "digits") > table.number(row, "digits") + 1e-4 &&
        quantity(table, i, cost) <= quantity(table, row, cost))
      return false;
  return true;
}

/// Whether a row is one of those meant: every condition holds, as "method=printed" or "zeta>3".
bool meant(const Table& table, std::size_t row, const std::vector<std::string>& where) {
  for (const std::string& condition : where) {
    const std::size_t sign = condition.find_first_of("=<>");
    const std::string name = condition.substr(0, sign), value = condition.substr(sign + 1);
    bool holds = false;
    if (name == "best")
      holds = is_best(table, row, value);
    else if (name == "every")
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

bool on_the_frame(const Panel& panel, const Place& p) {
  return std::min({std::abs(p.x - panel.left), std::abs(p.x - panel.right),
                   std::abs(p.y - panel.top), std::abs(p.y - panel.bottom)}) < pixel;
}

}  // namespace

std::vector<Datum> expected(const Table& table, const Row& curve, const Panel& panel) {
  std::vector<Datum> result;
  if (curve.at("x").find(' ') != std::string::npos) {
    const auto x = split(curve.at("x"), ' '), y = split(curve.at("y"), ' ');
    for (std::size_t i = 0; i < x.size(); ++i)
      result.push_back({panel.place(std::stod(x[i]), std::stod(y.at(i))), 0});
    return result;
  }
  const std::vector<std::string> where = split(curve.at("where"), ';');
  const bool has_z = !curve.at("z").empty() && curve.at("mark") != "text";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (!meant(table, row, where)) continue;
    const Place place =
        panel.place(quantity(table, row, curve.at("x")), quantity(table, row, curve.at("y")));
    const double z = has_z ? quantity(table, row, curve.at("z")) : 0;
    if (std::isfinite(place.x) && std::isfinite(place.y)) result.push_back({place, z});
  }
  return result;
}

double distance(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

bool near_one_of(const Polyline& places, const Place& p, double tolerance) {
  return std::any_of(places.begin(), places.end(),
                     [&](const Place& other) { return distance(other, p) < tolerance; });
}

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

void check_line(const Polyline& wanted, const Polyline& found, const Panel& panel, bool area,
                Wrong& wrong) {
  for (const Place& p : wanted)
    if (panel.holds(p) && !near_one_of(found, p)) wrong.push_back("no datum drawn" + at(p));
  for (const Place& p : found)
    if (!(distance_to(wanted, p) < pixel) && !(area && on_the_frame(panel, p)))
      wrong.push_back("no datum" + at(p));
}

void check_points(const Polyline& wanted, const Polyline& found, const Panel& panel, Wrong& wrong) {
  for (const Place& p : wanted)
    if (panel.holds(p) && !near_one_of(found, p)) wrong.push_back("no datum drawn" + at(p));
  for (const Place& p : found)
    if (!near_one_of(wanted, p)) wrong.push_back("no datum" + at(p));
}

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

}  // namespace thermoroll_test
