#include <vector>

#include <gtest/gtest.h>

#include "studies/sampling.hpp"

TEST(Sampling, EveryIndexIsWorkedOnOnce) {
  for (const std::size_t count : {0u, 1u, 1000u}) {
    std::vector<int> times(count, 0);
    thermoroll::on_all_processors(count, [&](std::size_t i) { ++times[i]; });
    EXPECT_EQ(times, std::vector<int>(count, 1));
  }
}

TEST(Sampling, MedianIsInTheMiddle) {
  EXPECT_EQ(thermoroll::median({5}), 5);
  EXPECT_EQ(thermoroll::median({9, 1, 4}), 4);
  EXPECT_EQ(thermoroll::median({9, 1, 4, 3}), 4);
}

// The standard says what the generator gives: the 10000th number from its own seed.
TEST(Sampling, NumbersAreTheSameEverywhere) {
  thermoroll::Random random{std::mt19937_64{}};
  random.bits.discard(9999);
  EXPECT_EQ(random.uniform(), static_cast<double>(9981545732273789042u >> 11) * 0x1p-53);
  for (int i = 0; i < 1000; ++i) {
    const double x = random.log_uniform(1e-3, 1e5);
    EXPECT_TRUE(1e-3 <= x && x < 1e5) << x;
  }
}
