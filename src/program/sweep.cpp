// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#include "program/sweep.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include <CLI/CLI.hpp>

#include "program/deliver.hpp"
#include "program/exit_status.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

struct RowOptions {
  RowOptions() { add_scene_options(row, values); }
  SceneOptions values;
  CLI::App row;
};

std::vector<std::string> read_header(const std::string& line) {
  const std::string mark = "\xEF\xBB\xBF";  // the byte-order mark
  std::vector<std::string> columns = cells_of(line.substr(line.find(mark) == 0 ? mark.size() : 0));
  if (line.find('"') != std::string::npos)
    throw std::invalid_argument(
        "the header has quotes, which are not read: write its names without");
  if (line.find('\r') < line.find_last_not_of('\r'))
    throw std::invalid_argument(
        "the lines end in carriage returns alone: save them with line feeds");
  const RowOptions options;
  std::set<std::string> seen;
  for (const std::string& name : columns) {
    if (options.row.get_option_no_throw("--" + name) == nullptr || name == "help")
      throw std::invalid_argument("the header names what is no option of solve: " + name);
    if (!seen.insert(name).second)
      throw std::invalid_argument("the header names " + name + " twice");
  }
  if (seen.count("friction") == 0) throw std::invalid_argument("the header lacks friction");
  return columns;
}

std::size_t place(const std::string& name, const std::vector<std::string>& columns) {
  return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                  columns.begin());
}

std::string as_option(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

/// The cells as read, then those fields that have no column among them, then the last two columns;
/// fields that were not found are left empty.
std::string with_results(const SweepTable& table, std::vector<std::string> cells,
                         const std::vector<Field>& found, const std::string& status,
                         const std::string& error) {
  cells.resize(table.columns.size());
  std::string row, results;
  auto next = found.begin();
  for (const std::string& name : table.fields) {
    const std::string cell = next != found.end() && next->name == name ? next++->cell : "";
    const std::size_t column = place(as_option(name), table.columns);
    if (column == cells.size())
      results += cell + ',';
    else if (cells[column].empty())
      cells[column] = cell;
  }
  for (const std::string& cell : cells) row += quoted(cell) + ',';
  return row + results + status + ',' + quoted(error) + '\n';
}

constexpr std::size_t longest_line = 10000;

/// The lines of a file descriptor, as they come.
class Lines {
 public:
  explicit Lines(int file) : file_(file) {}
  std::optional<std::string> next(const std::atomic<bool>& stop);

 private:
  bool fill(const std::atomic<bool>& stop);
  int file_;
  std::array<char, 65536> buffer_{};
  std::size_t at_ = 0, end_ = 0;
};

/// Nothing at the end of the file, or if stopped. Longer lines are cut to longest_line + 1.
std::optional<std::string> Lines::next(const std::atomic<bool>& stop) {
  std::string line;
  const auto empty = [&] { return line.find_first_not_of(" \t\r") == std::string::npos; };
  while (!stop && (at_ < end_ || fill(stop))) {
    const char c = buffer_[at_++];
    if (c != '\n' && line.size() <= longest_line) line += c;
    if (c == '\n' && !empty()) return line;
    if (c == '\n') line.clear();
  }
  return stop || empty() ? std::nullopt : std::optional(line);
}

bool Lines::fill(const std::atomic<bool>& stop) {
  pollfd input{file_, POLLIN, 0};
  ssize_t count = -1;
  while (count < 0) {
    if (stop) return false;
    if (poll(&input, 1, 100) == 0) continue;
    count = read(file_, buffer_.data(), buffer_.size());
    if (count < 0 && errno != EAGAIN && errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "cannot read the table");
  }
  at_ = 0;
  end_ = static_cast<std::size_t>(count);
  return count > 0;
}

class Sweep {
 public:
  Sweep(int file, bool progress) : lines_(file), progress_(progress) {}
  SweepCount run(int jobs);

 private:
  std::optional<std::string> take(long& row);
  void put(long row, SweepRow done);
  void start_another(std::vector<std::thread>& threads);
  void work();
  void fail();
  void tell();

  Lines lines_;
  SweepTable table_;
  std::mutex reading_, writing_;
  long taken_ = 0;
  std::array<std::optional<SweepRow>, 1000> window_;  // row k at k modulo its size
  std::condition_variable moved_;                     // with writing_
  SweepCount count_;
  bool progress_;
  std::chrono::steady_clock::time_point told_;
  std::atomic<bool> stop_{false};
  std::exception_ptr failure_;
};

std::optional<std::string> Sweep::take(long& row) {
  const std::lock_guard<std::mutex> lock(reading_);
  std::optional<std::string> line = lines_.next(stop_);
  if (line) row = taken_++;
  return line;
}

void Sweep::put(long row, SweepRow done) {
  const long size = static_cast<long>(window_.size());
  const auto at = [&](long k) -> auto& { return window_[static_cast<std::size_t>(k % size)]; };
  std::unique_lock<std::mutex> lock(writing_);
  moved_.wait(lock, [&] { return row - count_.rows < size || stop_; });
  if (stop_) return;
  at(row) = std::move(done);
  std::string text;
  for (; auto& next = at(count_.rows); ++count_.rows) {
    text += next->text;
    count_.failed += !next->solved;
    next.reset();
  }
  print(text);
  tell();
  moved_.notify_all();
}

/// In a handler, with writing_ free.
void Sweep::fail() {
  const std::lock_guard<std::mutex> lock(writing_);
  if (!stop_.exchange(true)) failure_ = std::current_exception();
  moved_.notify_all();
}

void Sweep::work() {
  try {
    long row = 0;
    while (const std::optional<std::string> line = take(row)) put(row, answer(table_, *line));
  } catch (...) {
    fail();
  }
}

void Sweep::start_another(std::vector<std::thread>& threads) {
  try {
    threads.emplace_back([this] { work(); });
  } catch (const std::system_error& error) {
    throw std::system_error(error.code(), "cannot solve more than " +
                                              std::to_string(threads.size()) +
                                              " rows at a time (see --jobs)");
  }
}

SweepCount Sweep::run(int jobs) {
  const std::optional<std::string> header = lines_.next(stop_);
  if (!header) throw std::invalid_argument("the table is empty: it has no header");
  table_ = table_of(*header);
  std::vector<Field> names;
  for (const std::string& name : table_.fields) names.push_back({name, name});
  print(with_results(table_, table_.columns, names, "status", "error"));
  std::vector<std::thread> threads;
  try {
    while (threads.size() < static_cast<std::size_t>(jobs)) start_another(threads);
  } catch (...) {
    fail();
  }
  for (std::thread& thread : threads) thread.join();
  if (failure_) std::rethrow_exception(failure_);
  return count_;
}

void Sweep::tell() {
  const auto now = std::chrono::steady_clock::now();
  if (!progress_ || now - told_ < std::chrono::milliseconds(200)) return;
  told_ = now;
  std::fprintf(stderr, "thermoroll: %s    \r", summary(count_).c_str());
}

}  // namespace

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = line.find(',', begin);
    std::string cell = line.substr(begin, end - begin);
    cell.erase(0, std::min(cell.find_first_not_of(" \t"), cell.size()));
    cell.erase(cell.find_last_not_of(" \t\r") + 1);
    cells.push_back(cell);
  }
  return cells;
}

SceneOptions read_row(const std::vector<std::string>& columns,
                      const std::vector<std::string>& cells) {
  if (cells.size() != columns.size())
    throw std::invalid_argument("the row has " + std::to_string(cells.size()) +
                                " cells and the header " + std::to_string(columns.size()));
  std::vector<std::string> arguments;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!cells[i].empty()) arguments.push_back("--" + columns[i] + '=' + cells[i]);
  thread_local std::optional<RowOptions> options;
  if (!options || options->row.parse_order().size() > 10000) options.emplace();
  options->values = {};
  try {
    options->row.parse(arguments);
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(reworded(error, options->row));
  }
  return options->values;
}

SweepTable table_of(const std::string& header) {
  SweepTable t{read_header(header), {}};
  const auto has = [&](const char* name) { return place(name, t.columns) < t.columns.size(); };
  t.with = {has("roller"), has("friction-law"), has("bulk-temperature")};
  std::optional<FoundInSi> physical;
  if (std::any_of(t.columns.begin(), t.columns.end(), is_si_option)) physical.emplace();
  for (const Field& field : csv_fields(Solution{}, physical, t.with))
    t.fields.push_back(field.name);
  return t;
}

SweepRow answer(const SweepTable& table, const std::string& line) {
  const std::vector<std::string> cells = cells_of(line);
  std::vector<Field> found;
  try {
    if (line.size() > longest_line)
      throw std::invalid_argument("the row has more than " + std::to_string(longest_line) +
                                  " characters");
    if (line.find('\0') != std::string::npos)
      throw std::invalid_argument("the row holds a null character");
    const SolvedScene x = solve_scene(read_scene(read_row(table.columns, cells)));
    found = csv_fields(x.solution, x.physical, table.with);
    require_contact(x.solution);
    return {with_results(table, cells, found, "0", ""), true};
  } catch (const std::exception& error) {
    const std::string status = std::to_string(status_of(error));
    return {with_results(table, cells, found, status, message_of(error)), false};
  }
}

std::string summary(const SweepCount& x) {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - x.start;
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return std::to_string(x.rows) + " rows, " + std::to_string(x.failed) + " with an error, " +
         fixed(static_cast<double>(x.rows) / taken.count(), 0) + " rows/s, " +
         fixed(static_cast<double>(use.ru_maxrss) / 1024, 0) + " MB";
}

SweepCount sweep(int file, int jobs, bool progress) { return Sweep(file, progress).run(jobs); }

}  // namespace thermoroll
