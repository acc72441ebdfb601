#include "svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace thermoroll_test {

namespace {

using Attributes = std::map<std::string, std::string>;

struct Tag {
  std::string name;  // with its slash, if it ends an element
  Attributes attributes;
  bool alone = false;  // ends itself
};

std::string attribute(const Tag& tag, const std::string& name) {
  const auto found = tag.attributes.find(name);
  return found == tag.attributes.end() ? "" : found->second;
}

Tag read_tag(const std::string& inside) {
  Tag tag;
  std::size_t at = inside.find_first_of(" \n\t/", 1);
  tag.name = inside.substr(0, at);
  tag.alone = inside.back() == '/';
  while (at != inside.npos) {
    const std::size_t first = inside.find_first_not_of(" \n\t/", at);
    const std::size_t equals = inside.find('=', at);
    if (first == inside.npos || equals == inside.npos) break;
    const std::size_t last = inside.find_last_not_of(" \n\t", equals - 1);
    const std::size_t open = inside.find_first_of("'\"", equals);
    const std::size_t close = open == inside.npos ? open : inside.find(inside[open], open + 1);
    if (close == inside.npos) throw std::runtime_error("not XML: an attribute of " + tag.name);
    tag.attributes[inside.substr(first, last + 1 - first)] =
        inside.substr(open + 1, close - open - 1);
    at = close + 1;
  }
  return tag;
}

std::string without_spaces(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
  return text;
}

std::string without_entities(std::string text) {
  const std::pair<std::string, std::string> entities[] = {
      {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}};
  for (const auto& [entity, letter] : entities)
    for (std::size_t at = 0; (at = text.find(entity, at)) != text.npos; ++at)
      text.replace(at, entity.size(), letter);
  return text;
}

// The numbers of a text; what parts them is of no interest.
std::vector<double> numbers(const std::string& text) {
  std::vector<double> result;
  const char* at = text.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at) {
      ++at;
      continue;
    }
    if (!std::isfinite(value)) throw std::runtime_error("a coordinate that is none: " + text);
    result.push_back(value);
    at = end;
  }
  return result;
}

Polyline places(const std::string& text) {
  if (text.find_first_of("nN") != text.npos)  // nan, inf
    throw std::runtime_error("a coordinate that is none: " + text);
  const std::vector<double> pairs = numbers(text);
  Polyline result;
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) result.push_back({pairs[i], pairs[i + 1]});
  return result;
}

// The state of reading: where in the picture we are.
class Reader {
 public:
  Picture picture;

  void start(const Tag& tag) {
    if (tag.name == "defs") in_definitions_ = true;
    if (in_definitions_) return;
    const std::string reference = attribute(tag, "xlink:href");
    if (!reference.empty()) picture.references.push_back(reference);
    if (tag.name == "svg") picture.view_box = attribute(tag, "viewBox");
    if (tag.name == "g") start_group(tag);
    if (tag.name == "text" || tag.name == "title") words_.clear();
    raised_ = tag.name == "tspan" && is_raised(tag);
    if (tag.name == "path") add_lines(tag);
    if (tag.name == "use") add_mark(tag, reference);
    if (tag.name == "polygon") add_area(tag);
    if (tag.name == "image") add_image(tag, reference);
  }

  void end(const std::string& name) {
    if (name == "/defs") in_definitions_ = false;
    if (in_definitions_) return;
    raised_ = false;
    if (name == "/text") add_text();
    if (name == "/title") end_title();
    if (name == "/g") {
      if (groups_.empty()) throw std::runtime_error("not XML: a group ends that has not begun");
      if (!attribute(groups_.back(), "id").empty()) plot_ = -1;
      groups_.pop_back();
    }
    if (name == "/svg") ended_ = true;
  }

  void letters(const std::string& text) { words_ += (raised_ && !text.empty() ? "^" : "") + text; }

  void finish() const {
    if (!ended_ || !groups_.empty()) throw std::runtime_error("not XML: it has no end");
  }

 private:
  std::vector<Tag> groups_;
  std::string words_;
  int plot_ = -1, panel_ = 0;
  bool in_definitions_ = false, raised_ = false, ended_ = false;

  void start_group(const Tag& tag) {
    groups_.push_back(tag);
    words_.clear();
    if (attribute(tag, "id").find("_plot_") == std::string::npos) return;
    plot_ = static_cast<int>(picture.plots.size());
    picture.plots.emplace_back();
    picture.panels.push_back(panel_);
  }

  // Lowered letters are small, too, and what follows them is lifted back at its full size.
  bool is_raised(const Tag& tag) const {
    const std::string size = attribute(tag, "font-size");
    return attribute(tag, "dy").rfind('-', 0) == 0 && !groups_.empty() &&
           numbers(size) < numbers(attribute(groups_.back(), "font-size"));
  }

  void end_title() {
    (plot_ < 0 ? picture.title : picture.plots.back()) = without_entities(words_);
  }

  Item& add(Item::Kind kind, const std::string& colour) {
    Item item{};
    item.kind = kind;
    item.plot = plot_;
    item.panel = panel_;
    item.colour = without_spaces(colour);
    for (const Tag& group : groups_) item.white |= attribute(group, "color") == "white";
    picture.items.push_back(item);
    return picture.items.back();
  }

  void add_lines(const Tag& tag) {
    const std::string path = attribute(tag, "d");
    for (std::size_t at = path.find('M'); at != path.npos; at = path.find('M', at + 1)) {
      const Polyline points = places(path.substr(at, path.find('M', at + 1) - at));
      if (points.size() < 2) continue;
      Item& item = add(Item::line, attribute(tag, "stroke"));
      item.what = attribute(tag, "stroke-dasharray");
      item.points = points;
    }
  }

  void add_mark(const Tag& tag, const std::string& shape) {
    Item& item = add(Item::mark, attribute(tag, "color"));
    item.what = shape;
    item.points = places(attribute(tag, "transform").substr(10));  // behind "translate("
    item.points.resize(1);
  }

  void add_area(const Tag& tag) {
    const Polyline points = places(attribute(tag, "points"));
    add(Item::area, attribute(tag, "fill")).points = points;
  }

  void add_image(const Tag& tag, const std::string& address) {
    const auto number = [&](const char* name) { return numbers(attribute(tag, name)).at(0); };
    const Place corner{number("x"), number("y")};
    const Place other{corner.x + number("width"), corner.y + number("height")};
    Item& item = add(Item::image, "");
    item.what = address;
    item.points = {corner, other};
  }

  // The labels of the tics are the only text of a colour in numbers and black.
  void add_text() {
    if (groups_.empty()) throw std::runtime_error("not XML: a text outside of everything");
    const Tag& group = groups_.back();
    const bool of_tic = attribute(group, "fill") == "rgb(0,0,0)";
    const bool of_scale = attribute(group, "text-anchor") == "start";
    const bool drawn = !picture.panels.empty() && picture.panels.back() == panel_;
    if (of_tic && !of_scale && drawn && plot_ < 0) ++panel_;
    Item& item = add(Item::text, attribute(group, "fill"));
    item.what = without_entities(words_);
    item.anchor = attribute(group, "text-anchor");
    item.size = numbers(attribute(group, "font-size")).at(0);
    item.points = places(attribute(group, "transform").substr(10));
    item.points.resize(1);
  }
};

}  // namespace

Picture read_svg(const std::string& text) {
  Reader reader;
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) {
    const std::size_t end = text.find('>', at);
    if (end == text.npos) throw std::runtime_error("not XML: a tag without an end");
    const Tag tag = read_tag(text.substr(at + 1, end - at - 1));
    if (tag.name[0] == '/') {
      reader.end(tag.name);
    } else if (tag.name[0] != '?') {
      reader.start(tag);
      if (tag.alone) reader.end("/" + tag.name);
    }
    at = end + 1;
    reader.letters(text.substr(at, text.find('<', at) - at));
  }
  reader.finish();
  return reader.picture;
}

}  // namespace thermoroll_test
