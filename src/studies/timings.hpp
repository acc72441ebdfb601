// Tangled from paper/G-benchmarks.md; edit there.
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace thermoroll {

/// Seconds of processor time by the name of a benchmark.
using Times = std::map<std::string, double>;

/// The times of one run of the benchmarks, each the median of its repetitions, and what they are
/// worth: by how much most repetitions (nine of ten benchmarks) differ, relative to the shortest.
struct Benchmarks {
  Times times;
  std::string processor{}, compiler{};
  int repetitions = 0;
  double spread = 0;
};

/// Whether a ratio of times is at most its bar, or at least: "met" or "missed", or "not judged" if
/// its repetitions differ by more than a twentieth of it.
std::string judgement(double ratio, double spread, double bar, bool at_least);

/// Read what thermoroll-bench --benchmark_format=json has written; the median of the repetitions
/// of each benchmark. Throws std::invalid_argument for a file that is not such.
Benchmarks read_benchmarks(const std::string& path);

/// The names that write_timed_data knows.
std::vector<std::string> timed_data_names();

/// Write what the report says of times under that name: CSV with a header line, but JSON for
/// "speed". Throws std::invalid_argument for an unknown name, std::runtime_error for a time that
/// is missing.
void write_timed_data(const std::string& name, const Benchmarks& run, std::ostream& out);

}  // namespace thermoroll
