// Tangled from paper/12-coupled-problem.md; edit there.
#include "solver/gauss_legendre.hpp"

#include <array>
#include <atomic>
#include <memory>
#include <new>

#include <gsl/gsl_integration.h>

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd legendre(const ArrayXd& x, Index n) {
  MatrixXd p = MatrixXd::Ones(x.size(), n);
  if (n > 1) p.col(1) = x;
  for (Index l = 1; l + 1 < n; ++l) {
    const double down = 1 - 1 / static_cast<double>(l + 1);  // l / (l + 1)
    p.col(l + 1) = (1 + down) * x * p.col(l).array() - down * p.col(l - 1).array();
  }
  return p;
}

static GaussLegendre make_rule(int n, bool with_polynomials) {
  GaussLegendre rule{ArrayXd(n), ArrayXd(n), {}, {}, {}, {}};
  const auto size = static_cast<std::size_t>(n);
  gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(size);
  if (table == nullptr) throw std::bad_alloc();
  for (std::size_t i = 0; i < size; ++i) {
    const auto k = static_cast<Index>(i);
    gsl_integration_glfixed_point(-1, 1, i, &rule.x(k), &rule.w(k), table);
  }
  gsl_integration_glfixed_table_free(table);
  rule.rho = (1 + rule.x) / 2;
  rule.cube = rule.rho.cube();
  const MatrixXd all = legendre(rule.x, n + 1);
  if (with_polynomials) rule.p = all.leftCols(n);
  const ArrayXd slope_of_p_n = n * (all.col(n - 1).array() - rule.x * all.col(n).array());
  rule.w = 2 * (1 - rule.x.square()) / slope_of_p_n.square();
  rule.dcube = 1.5 * rule.w * rule.rho.square();
  return rule;
}

static const GaussLegendre& kept_rule(int n, bool with_polynomials) {
  static std::array<std::atomic<const GaussLegendre*>, 4096> made[2] = {};
  auto& place = made[with_polynomials ? 1 : 0].at(static_cast<std::size_t>(n));
  const GaussLegendre* kept = place;
  if (kept == nullptr) {
    auto own = std::make_unique<const GaussLegendre>(n == 0 ? GaussLegendre{}
                                                            : make_rule(n, with_polynomials));
    if (place.compare_exchange_strong(kept, own.get())) kept = own.release();
  }
  return *kept;
}

const GaussLegendre& gauss_legendre(int n) { return kept_rule(n, true); }

const GaussLegendre& quadrature_rule(int n) { return kept_rule(n, false); }

MatrixXd to_legendre(const GaussLegendre& rule) {
  const ArrayXd l = ArrayXd::LinSpaced(rule.x.size(), 0, static_cast<double>(rule.x.size() - 1));
  return (l + 0.5).matrix().asDiagonal() * rule.p.transpose() * rule.w.matrix().asDiagonal();
}

VectorXd to_legendre(const GaussLegendre& rule, const VectorXd& values) {
  VectorXd c = rule.p.transpose() * rule.w.matrix().cwiseProduct(values);
  for (Index l = 0; l < c.size(); ++l) c(l) *= static_cast<double>(l) + 0.5;
  return c;
}

double tail(const VectorXd& coefficients) {
  const double largest = coefficients.lpNorm<Eigen::Infinity>();
  const VectorXd last = coefficients.tail(coefficients.size() / 4);
  return largest > 0 ? last.lpNorm<Eigen::Infinity>() / largest : 0;
}

}  // namespace thermoroll
