// Tangled from paper/E-fast-kernels.md; edit there.
#include "solver/product.hpp"

#include "support/simd.hpp"

namespace thermoroll {

using Eigen::Index;

using Given = Eigen::Ref<const Eigen::MatrixXd>;
using Changed = Eigen::Ref<Eigen::MatrixXd>;

template <int packs, int columns>
[[gnu::always_inline]] inline void add_block(double sign, const Given& a, const Given& b, Index i,
                                             Index j, Changed& c) {
  Pack4 sum[packs][columns] = {}, four;
  for (Index k = 0; k < a.cols(); ++k)
    for (int r = 0; r < packs; ++r) {
      load(a.data() + i + 4 * r + k * a.outerStride(), four);
      for (int l = 0; l < columns; ++l) sum[r][l] += four * b(k, j + l);
    }
  for (int r = 0; r < packs; ++r)
    for (int l = 0; l < columns; ++l) {
      load(&c(i + 4 * r, j + l), four);
      store(four + sign * sum[r][l], &c(i + 4 * r, j + l));
    }
}

template <int packs>
[[gnu::always_inline]] inline void add_rows(double sign, const Given& a, const Given& b, Index i,
                                            Changed& c) {
  Index j = 0;
  for (; j + 4 <= b.cols(); j += 4) add_block<packs, 4>(sign, a, b, i, j, c);
  for (; j < b.cols(); ++j) add_block<packs, 1>(sign, a, b, i, j, c);
}

THERMOROLL_CLONES void add_fours(double sign, const Given& a, const Given& b, Changed c) {
  Index i = 0;
  for (; i + 8 <= a.rows(); i += 8) add_rows<2>(sign, a, b, i, c);
  if (i < a.rows()) add_rows<1>(sign, a, b, i, c);
}

void add_product(double sign, const Given& a, const Given& b, Changed c) {
  const Index left = a.rows() % 4, fours = a.rows() - left;
  add_fours(sign, a.topRows(fours), b, c.topRows(fours));
  if (left > 0) c.bottomRows(left).noalias() += sign * a.bottomRows(left) * b;
}

}  // namespace thermoroll
