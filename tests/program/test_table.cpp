// Cells of a table against RFC 4180, whose examples these are, and what comes between cells and
// options.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program/table.hpp"

namespace {

using namespace thermoroll;
using Cells = std::vector<std::string>;

Cells cells_of(const std::string& line) {
  Cells cells;
  read_cells(line, cells);
  return cells;
}

TEST(Table, CellsByRfc4180) {
  EXPECT_EQ(cells_of("aaa,bbb,ccc"), (Cells{"aaa", "bbb", "ccc"}));
  EXPECT_EQ(cells_of("\"aaa\",\"b,b\",ccc"), (Cells{"aaa", "b,b", "ccc"}));
  EXPECT_EQ(cells_of("\"aaa\",\"b\"\"bb\",\"\""), (Cells{"aaa", "b\"bb", ""}));
  EXPECT_EQ(cells_of(""), Cells{""});
  EXPECT_EQ(cells_of(","), (Cells{"", ""}));
  EXPECT_EQ(cells_of("\"\"\"\","), (Cells{"\"", ""}));
  EXPECT_EQ(cells_of(" \t\"a \" ,\t b c \r"), (Cells{"a ", "b c"}));
  EXPECT_EQ(cells_of("a\"b,5\""), (Cells{"a\"b", "5\""})) << "a quote within a cell is a character";
}

TEST(Table, CellsBeforeABadQuoteAreKnown) {
  for (const std::string bad : {"\"", "\"a", "\"a\"b", "\"a\"\"", "\"a,b"}) {
    Cells cells;
    EXPECT_THROW(read_cells("1,2," + bad, cells), std::invalid_argument) << bad;
    EXPECT_EQ(cells, (Cells{"1", "2"})) << bad;
  }
}

TEST(Table, CellsOfARowComeBeforeTheSweep) {
  TableOptions how;
  how.constants = {{"peclet", "100"}, {"traction", "0.5"}};
  const SweepTable t = table_of("friction,creep,Id,peclet", [&] {
    how.keep = {"Id"};
    return how;
  }());
  const auto texts = [&](const std::string& line) {
    Cells cells = cells_of(line), all;
    for (const Setting& x : settings_of(t, cells)) all.push_back(x.option + '=' + x.value);
    return all;
  };
  EXPECT_EQ(texts("0.6,,x,"), (Cells{"friction=0.6", "peclet=100", "traction=0.5"}));
  EXPECT_EQ(texts("0.6,0.1,x,7"), (Cells{"friction=0.6", "creep=0.1", "peclet=7"}));
}

}  // namespace
