// Tangled from paper/23-unlike-bodies.md; edit there.
#include "solver/conduction.hpp"

#include <algorithm>
#include <cmath>

namespace thermoroll {

GradedKernels kernels_at(const GradedArray& zeta) {
  GradedKernels k(zeta.size());
  fast_kernels(static_cast<std::size_t>(zeta.size()), zeta.data(), k.data());
  return k;
}

GradedKernels pair_kernels(const Conduction& c, const GradedArray& zeta) {
  const GradedArray z = zeta / c.peclet;
  const double d1 = c.pair->slope_1, d2 = c.pair->slope_2, unit = d1 + d2 > 0 ? 1 / (d1 + d2) : 0;
  GradedKernels all = kernels_at(c.pair->peclet * z);
  const GradedKernels others = kernels_at(c.pair->other_peclet * z);
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    const Kernels k1 = all[i], &k2 = others[i];
    const Remainders r = (*c.pair)(z[i]);
    all[i] = {unit * (d1 * k1.n1 + d2 * k2.n1 + r(0)),
              unit * (d1 * k1.n2_up - d2 * k2.n2_up + r(1)),
              unit * (d1 * k1.n2_down - d2 * k2.n2_down + r(3)), k1.m_down + r(4)};
  }
  return all;
}

GradedArray pair_temperatures(const Conduction& c, double side, const GradedArray& zeta) {
  const GradedArray z = zeta / c.peclet, zeta_1 = c.pair->peclet * z;
  const GradedKernels all = kernels_at(zeta_1);
  GradedArray m(zeta.size());
  for (Eigen::Index i = 0; i < m.size(); ++i) m[i] = all[i].m_down;
  if (side > 0) m *= (-2 * zeta_1).max(-600).exp();  // numbers next to the smallest are slow
  for (Eigen::Index i = 0; i < m.size(); ++i) m(i) += (*c.pair)(z(i))(side > 0 ? 2 : 4);
  return m;
}

std::shared_ptr<const PairTable> table_of(const Scene& pair, bool crossing) {
  if (!crossing) return std::make_shared<const PairTable>(pair, false);
  static thread_local Scene last{};
  static thread_local std::shared_ptr<const PairTable> made;
  if (!made || !same_bodies(pair, last)) made = std::make_shared<const PairTable>(pair, true);
  last = pair;
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
  ahead.head(near) = behind.head(near) * (-2 * zeta.head(near)).exp();
  return ahead;
}

}  // namespace thermoroll
