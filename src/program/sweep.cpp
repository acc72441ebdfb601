// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#include "program/sweep.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <fstream>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "program/data_package.hpp"
#include "program/deliver.hpp"
#include "support/number_text.hpp"

namespace thermoroll {
namespace {

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
  const auto empty = [&] {
    return line.size() <= longest_line && line.find_first_not_of(" \t\r") == std::string::npos;
  };
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
  explicit Sweep(const SweepRequest& request) : request_(request), lines_(request.input) {}
  SweepCount run();

 private:
  bool has_header() const { return !request_.part || request_.part->number == 1; }
  void begin();
  std::string package_text() const;
  void open_package();
  void go_to(const Part& part);
  void continue_file();
  RowsSoFar rows_of_file();
  std::optional<SweepRow> check_beginning(const std::string& text);
  std::optional<std::string> take(long& row);
  void put(long row, SweepRow done);
  void start_another(std::vector<std::thread>& threads);
  void work();
  void fail();
  void tell();

  const SweepRequest& request_;
  Lines lines_;
  SweepTable table_;
  std::optional<Output> output_, package_;
  std::mutex reading_, writing_;
  long taken_ = 0, last_ = std::numeric_limits<long>::max();
  std::array<std::optional<SweepRow>, 1000> window_;  // row k at k modulo its size
  std::condition_variable moved_;                     // with writing_
  SweepCount count_;
  std::chrono::steady_clock::time_point told_;
  std::atomic<bool> stop_{false};
  std::exception_ptr failure_;
};

std::optional<std::string> Sweep::take(long& row) {
  const std::lock_guard<std::mutex> lock(reading_);
  if (taken_ == last_) return std::nullopt;
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
  const long before = count_.rows;
  for (; auto& next = at(count_.rows); ++count_.rows) {
    text += next->text;
    count_.failed += !next->solved;
    count_.noted += next->noted;
    next.reset();
  }
  output_->put(text, count_.rows - before);
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

SweepCount Sweep::run() {
  begin();
  std::vector<std::thread> threads;
  try {
    while (threads.size() < static_cast<std::size_t>(request_.jobs)) start_another(threads);
  } catch (...) {
    fail();
  }
  for (std::thread& thread : threads) thread.join();
  if (failure_) std::rethrow_exception(failure_);
  output_->finish();
  if (package_) package_->put(package_text());
  if (package_) package_->finish();
  return count_;
}

void Sweep::begin() {
  const std::optional<std::string> header = lines_.next(stop_);
  if (!header) throw std::invalid_argument("the table is empty: it has no header");
  table_ = table_of(*header, request_.table);
  if (!request_.package.empty()) open_package();
  if (request_.part) go_to(*request_.part);
  if (!request_.resume.empty()) return continue_file();
  output_.emplace(request_.output, Output::Kind::whole);
  if (has_header()) output_->put(header_of(table_));
}

std::string Sweep::package_text() const {
  const std::string& file = request_.resume.empty() ? request_.output : request_.resume;
  return data_package(table_, file, request_.package);
}

void Sweep::open_package() {
  package_text();  // which refuses a place that is not allowed
  package_.emplace(request_.package, Output::Kind::whole);
}

void Sweep::tell() {
  const auto now = std::chrono::steady_clock::now();
  if (!request_.progress || now - told_ < std::chrono::milliseconds(200)) return;
  told_ = now;
  std::fprintf(stderr, "thermoroll: %s    \r", summary(count_).c_str());
}

/// Throws std::invalid_argument, whose text is what the file does wrong.
RowsSoFar Sweep::rows_of_file() {
  std::ifstream file(request_.resume, std::ios::binary);
  if (!file) throw std::invalid_argument("cannot be read");
  RowsSoFar done = rows_so_far(table_, file, has_header());
  std::optional<std::string> line;
  for (long row = 0; row < done.rows; ++row)
    if (taken_++ == last_ || !(line = lines_.next(stop_)))
      throw std::invalid_argument("has more rows than the table");
  if (line && answer(table_, *line).text != done.last)
    throw std::invalid_argument("ends with another row than this sweep has there");
  return done;
}

/// The first row, if it was solved. Throws std::invalid_argument like rows_of_file().
std::optional<SweepRow> Sweep::check_beginning(const std::string& text) {
  std::string first = has_header() ? header_of(table_) : "";
  std::optional<SweepRow> solved;
  long row = 0;
  if (first.empty())
    if (const std::optional<std::string> line = take(row)) solved = answer(table_, *line);
  if (solved) first = solved->text;
  if (first.compare(0, text.size(), text) != 0)
    throw std::invalid_argument("does not begin as the results of this sweep do");
  return solved;
}

void Sweep::continue_file() {
  output_.emplace(request_.resume, Output::Kind::appended);
  RowsSoFar done;
  std::optional<SweepRow> first;
  try {
    done = rows_of_file();
    if (done.bytes == 0 && !done.rest.empty()) first = check_beginning(done.rest);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("resume = " + request_.resume + " is not allowed: it " +
                                error.what());
  }
  output_->cut(done.bytes);
  if (has_header() && done.bytes == 0) output_->put(header_of(table_));
  output_->put("", done.rows);
  count_.rows = count_.resumed = done.rows;
  count_.failed = done.failed;
  if (first) put(0, std::move(*first));
}

void Sweep::go_to(const Part& part) {
  if (lseek(request_.input, 0, SEEK_CUR) < 0)
    throw std::invalid_argument("a part can be had of a table in a file only");
  long rows = 0;
  while (lines_.next(stop_)) ++rows;
  lseek(request_.input, 0, SEEK_SET);
  lines_ = Lines(request_.input);
  const long first = rows * (part.number - 1) / part.of;
  for (long line = 0; line <= first; ++line) lines_.next(stop_);  // the header and other parts
  last_ = rows * part.number / part.of - first;
}

}  // namespace

std::string summary(const SweepCount& x) {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - x.start;
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  return std::to_string(x.rows) + " rows, " + std::to_string(x.failed) + " with an error, " +
         fixed(static_cast<double>(x.rows - x.resumed) / taken.count(), 0) + " rows/s, " +
         fixed(static_cast<double>(use.ru_maxrss) / 1024, 0) + " MB";
}

SweepCount sweep(const SweepRequest& request) { return Sweep(request).run(); }

}  // namespace thermoroll
