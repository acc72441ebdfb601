// Tangled from paper/C-output.md; edit there.
#include "program/deliver.hpp"

#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <mutex>
#include <set>
#include <stdexcept>
#include <utility>

namespace thermoroll {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const std::string& what, int reason) {
  throw std::system_error(reason, std::generic_category(), "cannot write " + what);
}

/// Write to an open file, or null, and close it. The name is for the error.
void write(std::FILE* file, const std::string& text, const std::string& name) {
  if (file == nullptr) cannot_write(name, errno);
  const bool whole = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int reason = errno;
  const bool closed = std::fclose(file) == 0;
  if (!whole || !closed) cannot_write(name, whole ? errno : reason);
}

std::timed_mutex naming;
std::set<std::string> unfinished;  // their temporary names

/// Create the file aside; null where that cannot be.
std::FILE* create_beside(Written& x) {
  const std::lock_guard<std::timed_mutex> whole(naming);
  for (int k = 0;; ++k) {
    const std::string name = "thermoroll-" + std::to_string(getpid()) + '-' + std::to_string(k);
    const std::string aside = (fs::path(x.target).parent_path() / name).string();
    std::FILE* file = std::fopen(aside.c_str(), "wx");
    if (file != nullptr) unfinished.insert(x.aside = aside);
    if (file != nullptr || errno != EEXIST) return file;
  }
}

/// Null where that cannot be.
std::FILE* open_aside(Written& x) {
  std::error_code problem;
  const fs::file_status old = fs::status(x.file, problem);
  x.is_new = old.type() == fs::file_type::not_found;
  if (!x.is_new && problem) cannot_write(x.file, problem.value());
  if (!x.is_new && !fs::is_regular_file(old)) return std::fopen(x.file.c_str(), "w");
  if (!x.is_new && access(x.file.c_str(), W_OK) != 0) cannot_write(x.file, errno);
  x.target = place_of(x.file, problem).string();
  if (problem) cannot_write(x.file, problem.value());
  std::FILE* file = create_beside(x);
  if (file != nullptr && !x.is_new) fs::permissions(x.aside, old.permissions(), problem);
  return file;
}

void put_in_place(Written& x) {
  const std::lock_guard<std::timed_mutex> whole(naming);
  if (std::rename(x.aside.c_str(), x.target.c_str()) != 0) cannot_write(x.file, errno);
  unfinished.erase(x.aside);
  x.aside = x.is_new ? x.target : "";
}

void take_back(const Written& x) {
  const std::lock_guard<std::timed_mutex> whole(naming);
  std::remove(x.aside.c_str());  // nothing, if it has none
  unfinished.erase(x.aside);
}

void write_at_once(std::FILE* file, const std::string& text, const std::string& name) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if (!whole || std::fflush(file) != 0) cannot_write(name, errno);
}

bool is_output(const std::string& file) { return file.empty() || file == "-"; }

void to_output(const std::string& text) { write_at_once(stdout, text, "to standard output"); }

std::FILE* open_to_append(const std::string& name) {
  std::error_code none;
  if (fs::exists(name, none) && !fs::is_regular_file(name, none))
    throw std::invalid_argument("resume = " + name + " is not allowed: it must be a file");
  std::FILE* file = std::fopen(name.c_str(), "ab");
  if (file != nullptr && flock(fileno(file), LOCK_EX | LOCK_NB) != 0)
    cannot_write(name + ", to which another sweep appends", errno);
  return file;
}

}  // namespace

std::filesystem::path place_of(std::filesystem::path file, std::error_code& problem) {
  const auto is_missing = [&] {
    return fs::status(file, problem).type() == fs::file_type::not_found;
  };
  while (is_missing() && fs::is_symlink(file, problem))
    file = file.parent_path() / fs::read_symlink(file, problem);
  return fs::weakly_canonical(file, problem);
}

namespace {
std::timed_mutex writing;
std::atomic<long> counted{-1};  // the rows of a sweep that are written
}  // namespace

long rows_written() { return counted; }

bool stop_output(std::chrono::milliseconds longest) {
  const bool stopped = writing.try_lock_until(std::chrono::system_clock::now() + longest);
  if (naming.try_lock_until(std::chrono::system_clock::now() + longest))
    for (const std::string& file : unfinished) std::remove(file.c_str());
  return stopped;
}

Output::Output(const std::string& file, Kind kind) : written_{file, "", ""} {
  const std::lock_guard<std::timed_mutex> whole(writing);
  counted = 0;
  if (is_output(file)) return;
  file_ = kind == Kind::appended ? open_to_append(file) : open_aside(written_);
  if (file_ == nullptr) cannot_write(file, errno);
}

void Output::put(const std::string& text, long rows) {
  const std::lock_guard<std::timed_mutex> whole(writing);
  write_at_once(file_, text, file_ == stdout ? "to standard output" : written_.file);
  counted += rows;
}

void Output::cut(std::uintmax_t bytes) {
  const std::lock_guard<std::timed_mutex> whole(writing);
  if (ftruncate(fileno(file_), static_cast<off_t>(bytes)) != 0) cannot_write(written_.file, errno);
}

void Output::finish() {
  const std::lock_guard<std::timed_mutex> whole(writing);
  if (file_ == stdout) return;
  std::FILE* file = std::exchange(file_, stdout);
  if (std::fclose(file) != 0) cannot_write(written_.file, errno);
  if (!written_.aside.empty()) put_in_place(written_);
  written_.aside.clear();
}

Output::~Output() {
  const std::lock_guard<std::timed_mutex> whole(writing);
  if (file_ != stdout) std::fclose(file_);
  take_back(written_);
}

void deliver(const std::vector<Answer>& answers) {
  const std::lock_guard<std::timed_mutex> whole(writing);
  std::vector<Written> written;
  try {
    for (const Answer& answer : answers) {
      if (is_output(answer.file)) continue;
      Written& x = written.emplace_back(Written{answer.file, "", ""});
      write(open_aside(x), answer.text, x.file);
    }
    for (const Answer& answer : answers)
      if (is_output(answer.file)) to_output(answer.text);
    for (Written& x : written)
      if (!x.aside.empty()) put_in_place(x);
  } catch (...) {
    for (const Written& x : written) take_back(x);
    throw;
  }
}

}  // namespace thermoroll
