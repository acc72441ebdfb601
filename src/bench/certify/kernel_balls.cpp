// Tangled from paper/M-certified.md; edit there.
#include "bench/certify/certify.hpp"

namespace thermoroll::certify {

Ball temperature_kernel(const Ball& z) {
  if (!positive(z)) return undefined();
  const auto slope = [](const Ball& x) { return scaled_k(1, x) - scaled_k(0, x); };
  return around_midpoint(
      z, [](const Ball& m) { return scaled_k(0, m); }, slope);
}

Ball slope_kernel(const Ball& z) {
  const auto n1 = [](const Ball& x) { return scaled_i(0, x) - scaled_i(1, x); };
  return around_midpoint(z, n1, [=](const Ball& x) { return 2 * n1(x) - scaled_i(1, x) / x; });
}

Ball mean_of_exponentials(int order, const Ball& z) {
  const auto slope = [](const Ball& x) { return scaled_i(0, x) - scaled_i(1, x); };
  return around_midpoint(
      z, [=](const Ball& m) { return scaled_i(order, m); }, slope);
}

Ball weighted_mean(int order, const Ball& z) {
  const auto slope = [](const Ball& x) { return (scaled_i(1, x) - scaled_i(2, x)) / x; };
  return around_midpoint(
      z, [=](const Ball& m) { return scaled_i(order, m) / m; }, slope);
}

}  // namespace thermoroll::certify
