// throughput FILE: the seconds that a program in C++ takes to solve the scenes of a file, each
// three numbers (traction, Pe, H), by a thread on each processor.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>
#include <vector>

#include "thermoroll/thermoroll.hpp"

struct Row {
  double traction, peclet, heating;
};

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::ifstream file(arguments[1], std::ios::binary);
  std::vector<Row> rows;
  for (Row row{}; file.read(reinterpret_cast<char*>(&row), sizeof row);) rows.push_back(row);
  std::vector<double> creeps(rows.size());
  const auto start = std::chrono::steady_clock::now();
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t k = next++; k < rows.size(); k = next++) {
      const thermoroll::Scene scene{0.6, rows[k].peclet, rows[k].heating};
      const thermoroll::Prescribed given{thermoroll::Quantity::traction, rows[k].traction};
      creeps[k] = thermoroll::solve(scene, given).value(thermoroll::Quantity::creep);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k)
    threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::printf("%.6f\n", taken.count());
  return rows.empty() || *std::min_element(creeps.begin(), creeps.end()) <= 0 ? 1 : 0;
}
