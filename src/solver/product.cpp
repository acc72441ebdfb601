// Tangled from paper/E-fast-kernels.md; edit there.
#include "solver/product.hpp"

#include "support/simd.hpp"

namespace thermoroll {

using Eigen::Index;

using Given = Eigen::Ref<const Eigen::MatrixXd>;
using Changed = Eigen::Ref<Eigen::MatrixXd>;

template <class Pack, int packs, int columns>
[[gnu::always_inline]] inline void add_block(double sign, const Given& a, const Given& b, Index i,
                                             Index j, Changed& c) {
  constexpr Index size = sizeof(Pack) / sizeof(double);
  Pack sum[packs][columns] = {}, pack;
  for (Index k = 0; k < a.cols(); ++k)
    for (int r = 0; r < packs; ++r) {
      load(a.data() + i + size * r + k * a.outerStride(), pack);
      for (int l = 0; l < columns; ++l) sum[r][l] += pack * b(k, j + l);
    }
  for (int r = 0; r < packs; ++r)
    for (int l = 0; l < columns; ++l) {
      load(&c(i + size * r, j + l), pack);
      store(pack + sign * sum[r][l], &c(i + size * r, j + l));
    }
}

template <class Pack, int packs>
[[gnu::always_inline]] inline void add_rows(double sign, const Given& a, const Given& b, Index& i,
                                            Changed& c) {
  constexpr int rows = packs * sizeof(Pack) / sizeof(double);
  for (; i + rows <= a.rows(); i += rows) {
    Index j = 0;
    for (; j + 4 <= b.cols(); j += 4) add_block<Pack, packs, 4>(sign, a, b, i, j, c);
    for (; j < b.cols(); ++j) add_block<Pack, packs, 1>(sign, a, b, i, j, c);
  }
}

THERMOROLL_CLONES void add_product(double sign, const Given& a, const Given& b, Changed c) {
  using Pack2 [[gnu::vector_size(16)]] = double;
  using Pack1 [[gnu::vector_size(8)]] = double;
  Index i = 0;
  add_rows<Pack4, 2>(sign, a, b, i, c);
  add_rows<Pack4, 1>(sign, a, b, i, c);
  add_rows<Pack2, 1>(sign, a, b, i, c);
  add_rows<Pack1, 1>(sign, a, b, i, c);
}

Eigen::MatrixXd product(double factor, const Given& a, const Given& b) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(a.rows(), b.cols());
  add_product(factor, a, b, c);
  return c;
}

}  // namespace thermoroll
