// The table of a sweep: a header and rows. Every row gives a whole row of CSV. Rows that ask for
// another method than the closed form are read and not solved, for the sake of speed.
#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "fuzz.hpp"
#include "program/sweep.hpp"

namespace {

// The cells of one row of CSV with quotes, by RFC 4180; 0 if it is not exactly one whole row.
std::size_t cells_in(const std::string& row) {
  std::size_t cells = 1;
  bool inside = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == '"') inside = !inside;
    if (inside) continue;
    cells += row[i] == ',';
    if (row[i] == '\n') return i + 1 == row.size() ? cells : 0;
  }
  return 0;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace thermoroll;
  std::istringstream text(std::string(data, data + size));
  std::string line;
  std::getline(text, line);
  SweepTable table;
  if (!fuzz::done_or_refused<std::invalid_argument>([&] { table = table_of(line); })) return 0;
  const auto overlap =
      std::count_if(table.fields.begin(), table.fields.end(), [&](std::string name) {
        std::replace(name.begin(), name.end(), '_', '-');
        return std::count(table.columns.begin(), table.columns.end(), name) > 0;
      });
  const std::size_t expected =
      table.columns.size() + table.fields.size() - static_cast<std::size_t>(overlap) + 2;
  while (std::getline(text, line)) {
    bool closed = false;
    const bool read = fuzz::done_or_refused<std::invalid_argument>([&] {
      const GivenScene c = read_scene(read_row(table.columns, cells_of(line)));
      closed = c.approach.method == Method::closed_form;
    });
    if (read && !closed) continue;
    const SweepRow row = answer(table, line);
    if (row.solved && !read) fuzz::fail("solved what cannot be read: " + line);
    if (cells_in(row.text) != expected) fuzz::fail("no whole row: " + row.text);
  }
  return 0;
}
