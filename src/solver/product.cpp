// Tangled from paper/E-fast-kernels.md; edit there.
#include "solver/product.hpp"

#include "support/simd.hpp"

namespace thermoroll {

using Eigen::Index;

using Given = Eigen::Ref<const Eigen::MatrixXd>;
using Changed = Eigen::Ref<Eigen::MatrixXd>;

template <int columns>
[[gnu::always_inline]] inline void add_block(double sign, const Given& a, const Given& b, Index i,
                                             Index j, Changed& c) {
  Pack4 sum[columns] = {}, rows;
  for (Index k = 0; k < a.cols(); ++k) {
    load(a.data() + i + k * a.outerStride(), rows);
    for (int l = 0; l < columns; ++l) sum[l] += rows * b(k, j + l);
  }
  for (int l = 0; l < columns; ++l) {
    load(&c(i, j + l), rows);
    store(rows + sign * sum[l], &c(i, j + l));
  }
}

THERMOROLL_CLONES void add_fours(double sign, const Given& a, const Given& b, Changed c) {
  for (Index i = 0; i < a.rows(); i += 4) {
    Index j = 0;
    for (; j + 8 <= b.cols(); j += 8) add_block<8>(sign, a, b, i, j, c);
    for (; j + 4 <= b.cols(); j += 4) add_block<4>(sign, a, b, i, j, c);
    for (; j < b.cols(); ++j) add_block<1>(sign, a, b, i, j, c);
  }
}

void add_product(double sign, const Given& a, const Given& b, Changed c) {
  const Index rows = a.rows(), last = rows % 4;
  const bool apart = rows < 8 || a.cols() + b.cols() < 20 || a.cols() > 504;
  const Index left = apart ? rows : last == 1 ? 5 : last;
  add_fours(sign, a.topRows(rows - left), b, c.topRows(rows - left));
  if (left > 0) c.bottomRows(left).noalias() += sign * a.bottomRows(left) * b;
}

}  // namespace thermoroll
