// Tangled from paper/23-unlike-bodies.md; edit there.
#include "solver/conduction.hpp"

#include <algorithm>
#include <cstring>

#include "support/simd.hpp"

namespace thermoroll {

GradedKernels kernels_at(const GradedArray& zeta) {
  GradedKernels k(zeta.size());
  fast_kernels(static_cast<std::size_t>(zeta.size()), zeta.data(), k.data());
  return k;
}

THERMOROLL_CLONES GradedKernels pair_kernels(const Conduction& c, const GradedArray& zeta) {
  const PairTable& pair = *c.pair;
  const GradedArray z = zeta / c.peclet;
  GradedKernels all = kernels_at(pair.peclet * z), rest(z.size());
  const GradedKernels others = kernels_at(pair.other_peclet * z);
  remainders(pair, static_cast<std::size_t>(z.size()), z.data(), rest.data());
  const double both = pair.slope_1 + pair.slope_2, unit = both > 0 ? 1 / both : 0;
  const double d1 = unit * pair.slope_1, d2 = unit * pair.slope_2;
  const Pack4 of_1 = {d1, d1, d1, 1}, of_2 = {d2, -d2, -d2, 0}, of_rest = {unit, unit, unit, 1};
  Pack4 k1, k2, r;
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    std::memcpy(&k1, &all[i], sizeof k1);
    std::memcpy(&k2, &others[i], sizeof k2);
    std::memcpy(&r, &rest[i], sizeof r);
    k1 = of_1 * k1 + of_2 * k2 + of_rest * r;
    std::memcpy(&all[i], &k1, sizeof k1);
  }
  return all;
}

GradedArray pair_temperatures(const Conduction& c, double side, const GradedArray& zeta) {
  const GradedArray z = zeta / c.peclet, zeta_1 = c.pair->peclet * z;
  const auto n = static_cast<std::size_t>(z.size());
  const GradedKernels all = kernels_at(zeta_1);
  GradedArray m(zeta.size()), rest(zeta.size());
  for (Eigen::Index i = 0; i < m.size(); ++i) m[i] = all[i].m_down;
  if (side > 0) {
    temperatures_upstream(*c.pair, n, z.data(), rest.data());
    return m * exponentials(-2 * zeta_1) + rest;
  }
  GradedKernels of_pair(zeta.size());
  remainders(*c.pair, n, z.data(), of_pair.data());
  for (Eigen::Index i = 0; i < m.size(); ++i) m[i] += of_pair[i].m_down;
  return m;
}

THERMOROLL_CLONES GradedArray exponentials(const GradedArray& exponent) {
  GradedArray power = exponent.max(-600);
  Pack4 four;
  Eigen::Index i = 0;
  for (; i + 4 <= power.size(); i += 4) {
    load(&power[i], four);
    exp_of(four, four);
    store(four, &power[i]);
  }
  for (; i < power.size(); ++i) {
    exp_of(Pack4{} + power[i], four);
    power[i] = four[0];
  }
  return power;
}

std::shared_ptr<const PairTable> table_of(const Scene& pair, bool crossing) {
  if (!crossing) return std::make_shared<const PairTable>(pair, false);
  static thread_local Scene last{};
  static thread_local std::shared_ptr<const PairTable> made;
  if (!made || !same_bodies(pair, last)) made = std::make_shared<const PairTable>(pair, true);
  (last = pair).law = nullptr;  // it may hold a caller's data
  return made;
}

Conduction::Conduction(const Scene& scene, bool crossing) : peclet(scene.peclet) {
  if (!is_unlike(scene)) return;
  peclet = std::max(scene.peclet, peclet_2(scene));
  slowest = std::min(scene.peclet, peclet_2(scene)) / peclet;
  pair = table_of(scene, crossing);
}

GradedKernels at_distances(const Conduction& c, const GradedArray& zeta) {
  return c.pair ? pair_kernels(c, zeta) : kernels_at(zeta);
}

GradedArray temperatures_ahead(const Conduction& c, const GradedArray& zeta,
                               const GradedArray& behind) {
  if (c.pair) return pair_temperatures(c, 1, zeta);
  GradedArray ahead = GradedArray::Zero(zeta.size());
  const Eigen::Index near = (zeta < 20).count();
  ahead.head(near) = behind.head(near) * exponentials(-2 * zeta.head(near));
  return ahead;
}

}  // namespace thermoroll
