// Tangled from paper/23-unlike-bodies.md; edit there.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "model/kernel_table.hpp"
#include "solver/gauss_legendre.hpp"
#include "solver/pair_table.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// The kernels of a scene and the Peclet number that their distances are in; those of one body for
/// a number alone.
struct Conduction {
  Conduction(double of) : peclet(of) {}
  /// Without the crossing flux both bodies have the uniform share of heat.
  explicit Conduction(const Scene& scene, bool crossing = true);
  double peclet, slowest = 1;               // Pe, and the smaller one over it
  std::shared_ptr<const PairTable> pair{};  // of unlike bodies
};

using GradedKernels = Eigen::Array<Kernels, Eigen::Dynamic, 1, 0, most_unknowns + 24, 1>;

/// The kernels at all of these distances |zeta| > 0.
GradedKernels at_distances(const Conduction& c, const GradedArray& zeta);

/// M(side zeta), zeta > 0, of a pair: ahead of a source, or behind it for side = -1.
GradedArray pair_temperatures(const Conduction& c, double side, const GradedArray& zeta);

/// exp(x) at all places, at least exp(-600).
GradedArray exponentials(const GradedArray& exponent);

/// M at the ascending distances zeta > 0 ahead of a source, from M behind it.
GradedArray temperatures_ahead(const Conduction& c, const GradedArray& zeta,
                               const GradedArray& behind);

}  // namespace thermoroll
