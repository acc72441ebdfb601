// Tangled from paper/12-coupled-problem.md; edit there.
#include "solver/graded_rule.hpp"

#include <cmath>

#include "support/simd.hpp"

namespace thermoroll {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

[[gnu::always_inline]] inline void crowd(const SlipPoint& from, Pack4& step, Pack4& eta,
                                         Pack4& rest, Pack4& weight) {
  const double beta = from.beta;
  Pack4 a, b, ahead;
  sinh_of(beta * eta, a);
  sinh_of(beta * rest, b);
  sinh_of(beta * step, ahead);
  const Pack4 sum = a + b;
  step = from.end / from.sum * ahead / sum;
  weight *= beta * from.end / (sum * sum);
  eta = 2 * a / sum;
  rest = 2 * b / sum;
}

[[gnu::always_inline]] inline void cluster(const SlipPoint& from, Pack4& step, Pack4& eta,
                                           Pack4& rest, Pack4& weight) {
  rest = -rest;
  for (std::size_t i = 2; i-- > 0;) {
    const Cluster& c = from.clusters[i];
    if (c.rate == 0) continue;
    Pack4 half;
    sinh_of(c.rate / 2 * (from.before[i] - c.middle + step), half);
    weight *= c.width * c.rate * (1 + 2 * half * half);
    step_across(c, -1, eta);
    step_across(c, 1, rest);
    step_across(c, from.before[i], step);
  }
  rest = -rest;
}

THERMOROLL_CLONES void grade(GradedRule& graded, double peclet, double gap, double left,
                             double right, const GaussLegendre& rule, const SlipVariable& by) {
  const SlipPoint from(left, right, by);
  double end_growth = by.beta > 0 ? 4 * by.beta / from.end : 1;  // of psi by y
  for (const Cluster& c : by.clusters) end_growth *= growth_at(c, -1);
  const double at_end = 22 * std::sqrt((1 / peclet + gap) / 27) / end_growth;
  const double delta = 6 * std::min(at_end, 1 / (peclet * 6 * from.u * from.v * from.du));
  const double ell = std::log1p(right / delta);
  for (GradedArray* x : {&graded.y, &graded.zeta, &graded.heat, &graded.by_h, &graded.by_dh})
    x->resize(rule.x.size());
  Pack4 cube, dcube, grown, u, v, apart;
  for (Index k = 0; k < rule.x.size(); k += 4) {
    load(&rule.cube[k], cube);
    load(&rule.dcube[k], dcube);
    exp_less_one(ell * cube, grown);
    const Pack4 dy = ell * delta * dcube * (1 + grown);
    Pack4 step = delta * grown, eta = left + step, rest = right - step, dpsi = dy;
    store(from.y + step, &graded.y[k]);
    if (by.beta > 0) crowd(from, step, eta, rest, dpsi);
    if (by.clustered()) cluster(from, step, eta, rest, dpsi);
    slip_cubic(eta, u);
    slip_cubic(rest, v);
    t_beyond(from, step, u, v, apart);
    store(peclet * (apart + gap), &graded.zeta[k]);
    Pack4 omega = (1 + 2 * u) * (1 + 2 * v);
    for (int i = 0; i < 4; ++i) omega[i] = std::sqrt(omega[i]);
    const Pack4 uv = u * v, root = uv * omega, du = (3 + 12 * eta * rest) * (1 / 22.0);
    const Pack4 middle = v * v * (1 + 2 * u) - u * u * (1 + 2 * v);  // 1 - 2t
    store(root * dy, &graded.by_dh[k]);
    store(6 * uv * du * (root * dpsi), &graded.heat[k]);
    store(3 * middle / omega * du * dpsi, &graded.by_h[k]);
  }
}

void kernel_weights(const Conduction& c, const GradedRule& graded, Index columns,
                    KernelWeights& weights) {
  const GradedKernels kernels = at_distances(c, graded.zeta);
  weights.resize(graded.y.size(), columns);
  GradedArray behind(graded.y.size());
  for (Index i = 0; i < graded.y.size(); ++i) {
    const Kernels& k = kernels[i];
    weights.row(i).head<node_weights>() << k.n1 * graded.heat(i), k.n1 * graded.by_h(i),
        k.n1 * graded.by_dh(i), k.n2_up * graded.heat(i), k.n2_down * graded.heat(i);
    behind[i] = k.m_down;
  }
  if (columns == node_weights) return;
  weights.col(5) = graded.heat * temperatures_ahead(c, graded.zeta, behind);
  weights.col(6) = graded.heat * behind;
}

/// The leading coefficients k_l, and the factors l^2 / (4 l^2 - 1).
struct Monic {
  Monic() : leading(GradedArray::Ones(size)), factor(GradedArray::Zero(size)) {
    for (Index l = 1; l < size; ++l) {
      const auto order = static_cast<double>(l);
      leading[l] = leading[l - 1] * (2 - 1 / order);
      factor[l] = order * order / (4 * order * order - 1);
    }
  }
  static constexpr Index size = GradedArray::MaxRowsAtCompileTime;
  GradedArray leading, factor;
};

const Monic& monic() {
  static const Monic all;
  return all;
}

template <Index columns>
[[gnu::always_inline]] inline void add_up(const Pack4* packs, double leading, double* sums) {
  Index w = 0;
  for (Pack4 four; w + 4 <= columns; w += 4) {
    sums_of(packs + w, four);
    store(leading * four, sums + w);
  }
  for (; w < columns; ++w) sums[w] = leading * sum_of(packs[w]);
}

template <Index columns>
[[gnu::always_inline]] inline void sum_columns(const GradedArray& y, const KernelWeights& weights,
                                               Sums& sums) {
  const Monic& k = monic();
  GradedArray now = GradedArray::Ones(y.size()), next = y;
  Pack4 x, p, q, weight;
  for (Index l = 0; l < sums.cols(); l += 2) {
    Pack4 even[columns] = {}, odd[columns] = {};
    const double less_p = k.factor[l + 1], less_q = k.factor[l + 2];
    for (Index i = 0; i < y.size(); i += 4) {
      load(&y[i], x);
      load(&now[i], p);
      load(&next[i], q);
      for (Index w = 0; w < columns; ++w) {
        load(&weights(i, w), weight);
        even[w] += weight * p;
        odd[w] += weight * q;
      }
      p = x * q - less_p * p;
      store(p, &now[i]);
      store(x * p - less_q * q, &next[i]);
    }
    add_up<columns>(even, k.leading[l], &sums(0, l));
    if (l + 1 < sums.cols()) add_up<columns>(odd, k.leading[l + 1], &sums(0, l + 1));
  }
}

THERMOROLL_CLONES void legendre_sums(const GradedArray& y, const KernelWeights& weights,
                                     Sums& sums) {
  sums.resize(weights.cols(), sums.cols());
  if (weights.cols() == node_weights)
    sum_columns<node_weights>(y, weights, sums);
  else if (weights.cols() == hot_weights)
    sum_columns<hot_weights>(y, weights, sums);
  else
    sum_columns<most_weights>(y, weights, sums);
}

MatrixXd by_derivatives(const MatrixXd& sums) {
  MatrixXd derivatives = MatrixXd::Zero(sums.rows(), sums.cols());
  for (Index l = 1; l < derivatives.cols(); ++l) {
    derivatives.col(l) = static_cast<double>(2 * l - 1) * sums.col(l - 1);
    if (l > 1) derivatives.col(l) += derivatives.col(l - 2);
  }
  return derivatives;
}

template <int packs>
[[gnu::always_inline]] inline void sum_series(double side, const double* y, const GradedArray& c,
                                              const GradedArray& factor, double* sums) {
  Pack4 x[packs], now[packs] = {}, after[packs] = {};
  for (Index i = 0; i < packs; ++i) {
    load(y + 4 * i, x[i]);
    x[i] *= side;
  }
  for (Index l = c.size(); l-- > 0;)
    for (int i = 0; i < packs; ++i) {
      const Pack4 next = (c[l] - factor[l + 1] * after[i]) + x[i] * now[i];
      after[i] = now[i];
      now[i] = next;
    }
  for (Index i = 0; i < packs; ++i) store(now[i], sums + 4 * i);
}

THERMOROLL_CLONES GradedArray series(double side, const GradedArray& y, const VectorXd& c) {
  const GradedArray scaled = c.array() * monic().leading.head(c.size());
  GradedArray sums(y.size());
  Index k = 0;
  for (; k + 16 <= y.size(); k += 16) sum_series<4>(side, &y[k], scaled, monic().factor, &sums[k]);
  if (k < y.size()) sum_series<2>(side, &y[k], scaled, monic().factor, &sums[k]);
  return sums;
}

VectorXd derivative(const VectorXd& c) {
  VectorXd d = VectorXd::Zero(c.size());
  for (Index l = c.size() - 2; l >= 0; --l)
    d(l) = static_cast<double>(2 * l + 1) *
           (c(l + 1) + (l + 2 < c.size() ? d(l + 2) / static_cast<double>(2 * l + 5) : 0));
  return d;
}

}  // namespace thermoroll
