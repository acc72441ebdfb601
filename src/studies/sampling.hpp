// Tangled from paper/F-data-files.md; edit there.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace thermoroll {

/// Random numbers that are the same on every machine, log_uniform() but for the rounding of pow.
struct Random {
  std::mt19937_64 bits;
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // 0 <= x < 1
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
};

/// Do the work for 0 to count - 1; it must not throw.
void on_all_processors(std::size_t count, const std::function<void(std::size_t)>& work);

/// The median of at least one number.
double median(std::vector<double> values);

}  // namespace thermoroll
