#include "drawing.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

#include "axes.hpp"
#include "curves.hpp"
#include "labels.hpp"
#include "maps.hpp"
#include "points.hpp"
#include "svg.hpp"

namespace thermoroll_test {

namespace {

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

void check_structure(const std::string& figure, const Picture& picture, std::size_t size,
                     Wrong& wrong) {
  const std::map<std::string, std::string> heights{
      {"cost", "640"},        {"traction", "600"},     {"slip", "600"},
      {"speed", "470"},       {"evaluations", "470"},  {"estimates", "330"},
      {"convergence", "365"}, {"temperatures", "620"}, {"recipe-curves", "560"},
      {"celsius", "540"},     {"rungs", "460"}};
  const auto is_a = [&](const std::string& kind) { return figure.rfind(kind, 0) == 0; };
  const std::string height = heights.count(figure) > 0              ? heights.at(figure)
                             : is_a("speed-")                       ? "260"
                             : is_a("share-") || is_a("hot-wheel-") ? "300"
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

/// The dashed lines that are no curves, from end to end.
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

/// Words stand as far from their data as z says, in letters: 0.7 times as wide and 1.5 times as
/// high as the font. Letters are placed to a tenth of a pixel.
void check_texts(const Polyline& wanted, const std::vector<Item>& items, const std::string& z,
                 Wrong& wrong) {
  const auto shift = split(z, ' ');
  for (const Item& item : items) {
    const Place p = item.points.at(0);
    const Place base{p.x - 0.7 * item.size * std::stod(shift.at(0)),
                     p.y - half_a_letter + 1.5 * item.size * std::stod(shift.at(1))};
    if (!near_one_of(wanted, base, 0.2)) wrong.push_back("'" + item.what + "' stands elsewhere");
  }
}

/// What a curve is drawn with, by its mark.
const std::map<std::string, std::set<Item::Kind>> kinds{
    {"line", {Item::line}},    {"points", {Item::mark}}, {"both", {Item::line, Item::mark}},
    {"thinned", {Item::mark}}, {"area", {Item::area}},   {"map", {Item::image}},
    {"cells", {Item::area}},   {"hatch", {Item::line}},  {"contour", {Item::line}},
    {"text", {Item::text}}};

void check_curve(const Picture& picture, int plot, const Row& row, const Table& table,
                 const Panel& panel, const std::map<int, std::string>& key, Wrong& wrong) {
  const std::vector<Item> items = drawn(picture, plot, panel);
  const std::string &mark = row.at("mark"), &dash = row.at("dash");
  std::set<Item::Kind> found;
  for (const Item& item : items) {
    found.insert(item.kind);
    if (!dash.empty() && item.what.empty() != (dash == "full")) wrong.push_back("not " + dash);
  }
  if (found != kinds.at(mark)) return wrong.push_back("not drawn as " + mark);

  const std::vector<Datum> points = expected(table, row, panel);
  const Polyline wanted = places_of(points);
  const Polyline marks = vertices(items, Item::mark), lines = vertices(items, Item::line);
  if (mark == "line" || mark == "both") check_line(wanted, lines, panel, false, wrong);
  if (mark == "points" || mark == "both") check_points(wanted, marks, panel, wrong);
  if (mark == "area") check_line(wanted, vertices(items, Item::area), panel, true, wrong);
  if (mark == "map") check_map(points, picture, items, panel, wrong);
  if (mark == "cells") check_cells(points, items, key, wrong);
  if (mark == "hatch") check_hatch(wanted, items, wrong);
  if (mark == "contour") check_contour(grid_of(points), row.at("levels"), lines, wrong);
  if (mark == "text") check_texts(wanted, items, row.at("z"), wrong);
  if (mark != "thinned") return;
  Polyline all;
  for (const Item& item : picture.items)
    if (item.plot >= 0 && item.kind == Item::mark) all.push_back(item.points[0]);
  check_thinned(wanted, marks, all, panel, wrong);
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
      texts.push_back(item);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const bool ratio = i < labels.size() && labels[i].at("is") == "ratio";
    words +=
        (ratio ? std::regex_replace(texts[i].what, std::regex("[0-9.]+"), "#") : texts[i].what);
    words += "; ";
  }
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
