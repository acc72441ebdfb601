// The pictures show the data, with the scales, titles and labels that tests/figures/expected/
// declares; and scripts that draw anything else are seen.
#include <gtest/gtest.h>

#include <fnmatch.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "drawing.hpp"
#include "svg.hpp"
#include "table.hpp"

using namespace thermoroll_test;

namespace {

namespace fs = std::filesystem;

const fs::path root = THERMOROLL_ROOT;

std::string read(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (!(text << file.rdbuf())) throw std::runtime_error("cannot read " + path.string());
  return text.str();
}

std::vector<std::string> figures() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(root / "figures"))
    if (entry.path().extension() == ".gp" && entry.path().stem() != "style")
      names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string first(const std::vector<std::string>& wrong) {
  return wrong.empty() ? "nothing wrong" : wrong.front();
}

/// The text with every `a` as `b` and every `b` as `a`.
std::string exchanged(const std::string& text, const std::string& a, const std::string& b) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto stands = [&](const std::string& word) {
      return !word.empty() && text.compare(at, word.size(), word) == 0;
    };
    const bool is_b = stands(b) && (b.size() > a.size() || !stands(a)), is_a = !is_b && stands(a);
    if (is_a || is_b) {
      result += is_a ? b : a;
      at += is_a ? a.size() : b.size();
    } else {
      result += text[at++];
    }
  }
  return result;
}

/// A copy of the scripts in a folder of its own.
class Scripts {
 public:
  Scripts() : folder_(testing::TempDir() + "thermoroll-XXXXXX") {
    if (mkdtemp(folder_.data()) == nullptr) throw std::runtime_error("no folder " + folder_);
    for (const auto& entry : fs::directory_iterator(root / "figures"))
      if (entry.path().extension() == ".gp") fs::copy(entry.path(), folder_);
  }
  ~Scripts() { fs::remove_all(folder_); }
  Scripts(const Scripts&) = delete;
  Scripts& operator=(const Scripts&) = delete;

  std::string text(const std::string& script) const { return read(path(script)); }
  void write(const std::string& script, const std::string& text) const {
    std::ofstream(path(script)) << text;
  }

  /// The picture that a script draws of its data, which it looks for from the project's folder.
  std::string draw(const std::string& figure) const {
    fs::current_path(root);
    const std::string drawn = folder_ + "/drawn.svg", log = folder_ + "/log";
    const std::string command = "LC_ALL=C.UTF-8 gnuplot -e \"output='" + drawn + "'\" '" +
                                path(figure) + "' 2>'" + log + "'";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("gnuplot stops: " + read(log));
    return read(drawn);
  }

 private:
  std::string folder_;

  std::string path(const std::string& script) const { return folder_ + "/" + script + ".gp"; }
};

}  // namespace

class Drawn : public testing::TestWithParam<std::string> {};

TEST_P(Drawn, ShowsItsData) {
  const auto wrong = wrong_in(GetParam(), read(root / "build/figures" / (GetParam() + ".svg")));
  EXPECT_TRUE(wrong.empty()) << wrong.size() << " things, first: " << first(wrong);
}

// Every figure has a mutation of each kind: another column, a factor, labels exchanged, a curve
// left out, an axis. Each exchanges two texts of a script, and must be seen in what the script then
// draws.
TEST_P(Drawn, MutatedScriptsAreSeen) {
  const Scripts scripts;
  ASSERT_EQ(first(wrong_in(GetParam(), scripts.draw(GetParam()))), "nothing wrong");
  std::set<std::string> kinds;
  const Table mutations = read_table(root / "tests/figures/expected/mutations.csv");
  for (std::size_t row = 0; row < mutations.rows.size(); ++row) {
    if (fnmatch(mutations.text(row, "figure").c_str(), GetParam().c_str(), 0) != 0) continue;
    const std::string &script = mutations.text(row, "script"), &from = mutations.text(row, "from"),
                      &to = mutations.text(row, "to");
    SCOPED_TRACE(script + ".gp: " + from + " -> " + to);
    const std::string text = scripts.text(script), mutated = exchanged(text, from, to);
    ASSERT_NE(mutated, text) << "it does not stand in the script";
    scripts.write(script, mutated);
    EXPECT_NE(first(wrong_in(GetParam(), scripts.draw(GetParam()))), "nothing wrong");
    scripts.write(script, text);
    kinds.insert(mutations.text(row, "kind"));
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"axis", "column", "curve", "factor", "labels"}));
}

// As in the text, whatever else of a label is italic.
TEST_P(Drawn, PecletsNumberIsUpright) {
  const std::string svg = read(root / "build/figures" / (GetParam() + ".svg"));
  const std::string italic = "font-style=\"italic\"";
  for (std::size_t at = svg.find(italic); at != svg.npos; at = svg.find(italic, at + 1)) {
    const std::size_t from = svg.find('>', at) + 1;
    const std::string text = svg.substr(from, svg.find('<', from) - from);
    EXPECT_EQ(text.find("Pe"), text.npos) << text;
  }
}

// Damage to the picture itself.
TEST_P(Drawn, DamageIsSeen) {
  const std::string svg = read(root / "build/figures" / (GetParam() + ".svg"));
  const auto expect_seen = [&](const std::string& from, const std::string& to) {
    const std::size_t at = svg.find(from, svg.find("</defs>"));
    ASSERT_NE(at, svg.npos) << from;
    const std::string damaged = std::string(svg).replace(at, from.size(), to);
    EXPECT_NE(first(wrong_in(GetParam(), damaged)), "nothing wrong") << from << " -> " << to;
  };
  expect_seen(" d='M", " d='Mnan,");
  expect_seen(" d='M", " d='Minf,");
  expect_seen(" d='M", " d='M1e4,");
  expect_seen("<g fill=\"none\" color=\"black\" stroke=\"currentColor\"",
              "<image x='0' y='0' width='1' height='1' xlink:href='a.png'/><g stroke=\"black\"");
  expect_seen("color=\"black\"", "color=\"white\"");
  expect_seen("<title>", "<title>x");
  expect_seen("</svg>", "");
  const std::string other = std::string(svg).replace(svg.find("viewBox=\"0"), 10, "viewBox=\"1");
  EXPECT_NE(first(wrong_in(GetParam(), other)), "nothing wrong");
}

INSTANTIATE_TEST_SUITE_P(Figures, Drawn, testing::ValuesIn(figures()),
                         [](const auto& name) { return exchanged(name.param, "-", "_"); });

TEST(Declared, FiguresAreThoseOfTheScripts) {
  for (const std::string table : {"axes", "curves", "labels", "mutations"}) {
    const Table rows = read_table(root / "tests/figures/expected" / (table + ".csv"));
    for (std::size_t row = 0; row < rows.rows.size(); ++row) {
      const std::string& pattern = rows.text(row, "figure");
      bool known = false;
      for (const std::string& figure : figures())
        known |= fnmatch(pattern.c_str(), figure.c_str(), 0) == 0;
      EXPECT_TRUE(known) << table << ": " << pattern;
    }
  }
}
