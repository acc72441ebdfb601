// Tangled from paper/12-coupled-problem.md; edit there.
#pragma once

#include <array>

namespace thermoroll {

/// x to place + width sinh(rate (x - middle)), @eq:cluster; the identity if the rate is 0.
struct Cluster {
  double place = 0, width = 0, rate = 0, middle = 0;
  bool operator==(const Cluster& x) const { return place == x.place && width == x.width; }
};

/// The variable y of @eq:angles: beta, and the clusters from psi on.
struct SlipVariable {
  double beta = 0;
  std::array<Cluster, 2> clusters{};
  bool clustered() const { return clusters[0].rate > 0; }
  bool operator==(const SlipVariable& x) const { return beta == x.beta && clusters == x.clusters; }
};

}  // namespace thermoroll
