// Tangled from paper/C-output.md; edit there.
#include "program/deliver.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <system_error>

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

/// A file to be written: its name as given, that without links, and where it is written until it is
/// whole. This is empty for a device, which is in its place.
struct Written {
  std::string file, target, aside;
};

/// Create the file aside; null where that cannot be.
std::FILE* create_beside(Written& x) {
  for (int k = 0;; ++k) {
    const std::string name = "thermoroll-" + std::to_string(getpid()) + '-' + std::to_string(k);
    const std::string aside = (fs::path(x.target).parent_path() / name).string();
    std::FILE* file = std::fopen(aside.c_str(), "wx");
    if (file != nullptr) x.aside = aside;
    if (file != nullptr || errno != EEXIST) return file;
  }
}

void write_aside(Written& x, const std::string& text) {
  std::error_code problem;
  const fs::file_status old = fs::status(x.file, problem);
  const bool is_new = old.type() == fs::file_type::not_found;
  if (!is_new && problem) cannot_write(x.file, problem.value());
  if (!is_new && !fs::is_regular_file(old))
    return write(std::fopen(x.file.c_str(), "w"), text, x.file);
  if (!is_new && access(x.file.c_str(), W_OK) != 0) cannot_write(x.file, errno);
  x.target = fs::weakly_canonical(x.file, problem).string();
  if (problem) cannot_write(x.file, problem.value());
  std::FILE* file = create_beside(x);
  if (file != nullptr && !is_new) fs::permissions(x.aside, old.permissions(), problem);
  write(file, text, x.file);
}

void put_in_place(const Written& x) {
  if (std::rename(x.aside.c_str(), x.target.c_str()) != 0) cannot_write(x.file, errno);
}

void to_output(const std::string& text) {
  const bool whole = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!whole || std::fflush(stdout) != 0) cannot_write("to standard output", errno);
}

}  // namespace

namespace {
std::timed_mutex writing;
}

void print(const std::string& text) {
  const std::lock_guard<std::timed_mutex> whole(writing);
  to_output(text);
}

bool stop_output(std::chrono::milliseconds longest) { return writing.try_lock_for(longest); }

void deliver(const std::vector<Answer>& answers) {
  const std::lock_guard<std::timed_mutex> whole(writing);
  const auto is_output = [](const Answer& x) { return x.file.empty() || x.file == "-"; };
  std::vector<Written> written;
  try {
    for (const Answer& answer : answers)
      if (!is_output(answer))
        write_aside(written.emplace_back(Written{answer.file, "", ""}), answer.text);
    for (const Answer& answer : answers)
      if (is_output(answer)) to_output(answer.text);
    for (const Written& x : written)
      if (!x.aside.empty()) put_in_place(x);
  } catch (...) {
    for (const Written& x : written) std::remove(x.aside.c_str());  // nothing, if it has none
    throw;
  }
}

}  // namespace thermoroll
