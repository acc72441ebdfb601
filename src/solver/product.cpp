// Tangled from paper/E-fast-kernels.md; edit there.
#include "solver/product.hpp"

#include "support/simd.hpp"

namespace thermoroll {

namespace {

/// Matrices by columns, with the distances of the columns.
struct Multiplied {
  const double *a, *b;
  Eigen::Index a_stride, b_stride, depth;
};

template <int packs, int columns>
[[gnu::always_inline]] inline void add_block(const Multiplied& x, double sign, double* c,
                                             Eigen::Index stride) {
  Pack4 sum[columns][packs] = {}, left;
  for (Eigen::Index k = 0; k < x.depth; ++k)
    for (int i = 0; i < packs; ++i) {
      load(x.a + k * x.a_stride + 4 * i, left);
      for (int j = 0; j < columns; ++j) sum[j][i] += left * x.b[k + j * x.b_stride];
    }
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < packs; ++i) {
      load(c + j * stride + 4 * i, left);
      store(left + sign * sum[j][i], c + j * stride + 4 * i);
    }
}

template <int packs>
[[gnu::always_inline]] inline void add_rows(Multiplied x, double sign, Eigen::Index columns,
                                            double* c, Eigen::Index stride) {
  Eigen::Index j = 0;
  for (; j + 4 <= columns; j += 4, x.b += 4 * x.b_stride, c += 4 * stride)
    add_block<packs, 4>(x, sign, c, stride);
  for (; j < columns; ++j, x.b += x.b_stride, c += stride) add_block<packs, 1>(x, sign, c, stride);
}

/// For a multiple of four rows.
THERMOROLL_CLONES void add_fours(Multiplied x, double sign, Eigen::Index rows, Eigen::Index columns,
                                 double* c, Eigen::Index stride) {
  Eigen::Index i = 0;
  for (; i + 8 <= rows; i += 8, x.a += 8, c += 8) add_rows<2>(x, sign, columns, c, stride);
  if (i < rows) add_rows<1>(x, sign, columns, c, stride);
}

}  // namespace

void add_product(double sign, const Eigen::Ref<const Eigen::MatrixXd>& a,
                 const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::Ref<Eigen::MatrixXd> c) {
  const Eigen::Index rows = a.rows(), depth = a.cols(), columns = b.cols(), last = rows % 4;
  const bool apart = rows < 8 || depth + columns < 20 || depth > 504;
  const Eigen::Index left = apart ? rows : last == 1 ? 5 : last;
  add_fours({a.data(), b.data(), a.outerStride(), b.outerStride(), depth}, sign, rows - left,
            columns, c.data(), c.outerStride());
  if (left > 0) c.bottomRows(left).noalias() += sign * a.bottomRows(left) * b;
}

}  // namespace thermoroll
