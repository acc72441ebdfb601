// soak SCENES SECONDS [SEED [TABLE]]: examine so many random scenes, or as many as fit into the
// seconds if these are not 0, on all processors, and print what became of them. Each block of
// scenes is a process of its own, so that a crash or a hang costs one scene and is told like any
// other failure.
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "properties.hpp"

namespace {

constexpr std::uint64_t block_size = 200;
constexpr int seconds_a_scene = 60;  // of processor time, before it counts as a hang

soak::Depth depth_of(std::uint64_t number) {
  if (number % 1000 == 0) return soak::Depth::energy;
  if (number % 50 == 0) return soak::Depth::profiles;
  return number % 2 == 0 ? soak::Depth::again : soak::Depth::results;
}

std::string written(const soak::Totals& x) {
  std::ostringstream out;
  out.precision(17);
  for (const auto& [what, count] : x.outcomes) out << "outcome\t" << what << '\t' << count << '\n';
  for (const auto& [what, count] : x.beside) out << "beside\t" << what << '\t' << count << '\n';
  for (const auto& [what, w] : x.worst)
    out << "worst\t" << what << '\t' << w.share << ' ' << w.number << '\n';
  for (const auto& [decade, c] : x.compared)
    out << "compared\t" << decade << '\t' << c.scenes << ' ' << c.beyond << ' ' << c.worst << '\n';
  for (const auto& [what, scene] : x.failures) out << "failure\t" << what << '\t' << scene << '\n';
  return out.str();
}

soak::Totals totals_from(const std::string& text) {
  soak::Totals totals;
  std::istringstream lines(text);
  for (std::string kind, what, value; std::getline(lines, kind, '\t');) {
    std::getline(lines, what, '\t');
    std::getline(lines, value);
    if (kind == "outcome") totals.outcomes[what] = std::stol(value);
    if (kind == "beside") totals.beside[what] = std::stol(value);
    if (kind == "failure") totals.failures[what] = value;
    if (kind == "compared") {
      soak::Compared& c = totals.compared[std::stoi(what)];
      std::istringstream(value) >> c.scenes >> c.beyond >> c.worst;
    }
    if (kind == "worst") {
      const std::size_t blank = value.find(' ');
      totals.worst[what] = {std::stod(value), std::stoull(value.substr(blank + 1))};
    }
  }
  return totals;
}

/// A process that examines the scenes from `next` to `end`.
struct Block {
  pid_t process = 0;
  std::FILE* totals = nullptr;  // what came of them, a temporary file
  std::atomic<std::uint64_t>* next = nullptr;
  std::uint64_t end = 0;
};

void examine_block(const Block& block, std::uint64_t seed) {
  soak::Totals totals;
  for (; *block.next < block.end; ++*block.next) {
    const itimerval limit{{0, 0}, {seconds_a_scene, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    const std::uint64_t number = *block.next;
    soak::examine(number, soak::sample(seed, number), depth_of(number), totals);
  }
  std::fputs(written(totals).c_str(), block.totals);
  std::_Exit(std::fflush(block.totals) == 0 ? 0 : 1);
}

void start(Block& block, std::uint64_t seed) {
  block.totals = std::tmpfile();
  if (block.totals == nullptr) throw std::runtime_error("no temporary file");
  block.process = fork();
  if (block.process == 0) examine_block(block, seed);
}

/// The totals of a block that has ended, and one failure more if it did not end well.
soak::Totals totals_of(const Block& block, int status, std::uint64_t seed) {
  std::string text;
  std::rewind(block.totals);
  for (int c = std::fgetc(block.totals); c != EOF; c = std::fgetc(block.totals))
    text += static_cast<char>(c);
  std::fclose(block.totals);
  soak::Totals totals = totals_from(text);
  if (status == 0) return totals;
  const std::uint64_t number = *block.next;
  const std::string what = WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "an odd end";
  ++totals.outcomes["killed: " + what];
  totals.failures["killed: " + what] =
      std::to_string(number) + ": " + soak::text(soak::sample(seed, number));
  return totals;
}

/// The estimates against finer solutions: a line of the report, and a table, a row for each decade
/// of tolerances.
void report_compared(const std::map<int, soak::Compared>& compared, const char* table) {
  soak::Compared all;
  std::ostringstream rows;
  rows << "tolerance,compared,beyond the estimate,largest error by estimate\n";
  for (const auto& [decade, c] : compared) {
    char worst[16];
    std::snprintf(worst, sizeof worst, "%.2f", c.worst);
    rows << "1e" << decade << " to 1e" << decade + 1 << ',' << c.scenes << ',' << c.beyond << ','
         << worst << '\n';
    all = {all.scenes + c.scenes, all.beyond + c.beyond, std::max(all.worst, c.worst)};
  }
  std::printf("%ld compared with finer solutions: %ld beyond the estimate, at most %.3g times\n",
              all.scenes, all.beyond, all.worst);
  std::FILE* file = table != nullptr ? std::fopen(table, "w") : nullptr;
  if (file == nullptr) return;
  std::fputs(rows.str().c_str(), file);
  std::fclose(file);
}

int report(const soak::Totals& totals, std::uint64_t seed, double seconds) {
  long count = 0, answers = 0;
  for (const auto& [what, n] : totals.outcomes) {
    count += n;
    if (what.rfind("solved", 0) == 0) answers += n;
  }
  std::printf(
      "%ld scenes of seed %llu in %.0f s: %ld solved, %ld refused, %zu of %zu properties failed\n",
      count, static_cast<unsigned long long>(seed), seconds, answers, count - answers,
      totals.failures.size(), totals.worst.size());
  for (const auto& [what, n] : totals.outcomes) std::printf("%10ld %s\n", n, what.c_str());
  for (const auto& [what, n] : totals.beside) std::printf("%10ld (%s)\n", n, what.c_str());
  std::printf("largest share of what is allowed, and its scene:\n");
  for (const auto& [what, w] : totals.worst)
    std::printf("%10.3g %s (%llu)\n", w.share, what.c_str(),
                static_cast<unsigned long long>(w.number));
  for (const auto& [what, scene] : totals.failures)
    std::printf("FAILED: not so: %s, in scene %s\n", what.c_str(), scene.c_str());
  return totals.failures.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::uint64_t scenes = std::strtoull(argv[1], nullptr, 10);
  const double most_seconds = std::strtod(argv[2], nullptr);
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  soak::Totals totals;
  const soak::Sample first{{0.6, 100, 0.1}, {thermoroll::Quantity::traction, 0.5}, {}, 1e-4};
  soak::examine(0, first, soak::Depth::energy, totals);  // fills tables
  totals = {};
  std::vector<Block> blocks(std::max(1u, std::thread::hardware_concurrency()));
  void* shared = mmap(nullptr, blocks.size() * sizeof(std::atomic<std::uint64_t>),
                      PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) return 1;
  std::uint64_t next = 0;
  const auto more = [&] { return most_seconds > 0 ? seconds() < most_seconds : next < scenes; };
  const auto begin_block = [&](Block& block) {
    if (!more()) return;
    *block.next = next;
    block.end = next += block_size;
    if (most_seconds <= 0) block.end = std::min(block.end, scenes);
    start(block, seed);
  };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    blocks[i].next = static_cast<std::atomic<std::uint64_t>*>(shared) + i;
    begin_block(blocks[i]);
  }
  int status = 0;
  for (pid_t ended = wait(&status); ended > 0; ended = wait(&status))
    for (Block& block : blocks) {
      if (block.process != ended) continue;
      totals.add(totals_of(block, status, seed));
      if (status != 0 && ++*block.next < block.end)
        start(block, seed);  // what is left of it
      else
        begin_block(block);
      break;
    }
  const int failed = report(totals, seed, seconds());
  report_compared(totals.compared, argc > 4 ? argv[4] : nullptr);
  return failed;
}
