// Products of matrices, element by element in long double; the rules that all threads share.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "solver/gauss_legendre.hpp"
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

// All threads have the same rule, also where they make it at once.
TEST(GaussLegendre, ThreadsShareTheRules) {
  constexpr int n = 333;  // of no other test
  std::vector<const thermoroll::GaussLegendre*> found(4);
  std::vector<std::thread> threads;
  for (auto& rule : found) threads.emplace_back([&] { rule = &thermoroll::gauss_legendre(n); });
  for (std::thread& thread : threads) thread.join();
  for (const auto* rule : found) EXPECT_EQ(rule, &thermoroll::gauss_legendre(n));
  EXPECT_EQ(found.front()->x.size(), n);
}

}  // namespace
