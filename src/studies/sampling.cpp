// Tangled from paper/F-data-files.md; edit there.
#include "studies/sampling.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

namespace thermoroll {

void on_all_processors(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> others(std::max(2u, std::thread::hardware_concurrency()) - 1);
  for (std::thread& other : others) other = std::thread(run);
  run();
  for (std::thread& other : others) other.join();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace thermoroll
