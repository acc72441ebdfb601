// Products of matrices, element by element in long double.
#include <gtest/gtest.h>

#include "solver/product.hpp"

#include "reference.hpp"

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// A sum of n terms of at most 1 is within n epsilons of n.
TEST(Product, IsItsSum) {
  for (const Index rows : {1, 5, 8, 14, 19, 20})
    for (const Index columns : {1, 4, 10})
      for (const Index depth : {1, 24, 300})
        for (const double sign : {1.0, -1.0}) {
          const MatrixXd a = MatrixXd::Random(rows + 1, depth);
          const MatrixXd b = MatrixXd::Random(depth, columns);
          const MatrixXd before = MatrixXd::Random(rows, columns);
          MatrixXd c = before;
          thermoroll::add_product(sign, a.topRows(rows), b, c);
          const auto terms = static_cast<double>(depth + 1);
          for (Index i = 0; i < rows; ++i)
            for (Index j = 0; j < columns; ++j) {
              reference::Real sum = before(i, j);
              for (Index k = 0; k < depth; ++k)
                sum += sign * reference::Real{a(i, k)} * reference::Real{b(k, j)};
              EXPECT_NEAR(c(i, j), static_cast<double>(sum), terms * terms * reference::epsilon);
            }
        }
}

}  // namespace
