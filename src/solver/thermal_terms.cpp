// Tangled from paper/12-coupled-problem.md; edit there.
#include "solver/thermal_terms.hpp"

#include "solver/exchange.hpp"
#include "solver/graded_rule.hpp"
#include "solver/product.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

/// N1, N2 and, if asked for, M at the distances zeta (columns), increased by `further` (rows).
struct FurtherKernels {
  MatrixXd n1, n2, m;
};

FurtherKernels kernels_further(const Conduction& c, const GradedArray& zeta, const ArrayXd& further,
                               bool temperature) {
  const Index rows = further.size(), columns = zeta.size();
  FurtherKernels k{MatrixXd(rows, columns), MatrixXd(rows, columns), {}};
  if (temperature) k.m.resize(rows, columns);
  for (Index j = 0; j < columns; ++j) {
    const GradedArray at = zeta[j] + further;
    const GradedKernels all = at_distances(c, at);
    GradedArray behind(rows);
    for (Index i = 0; i < rows; ++i) {
      k.n1(i, j) = all[i].n1;
      k.n2(i, j) = all[i].n2_up;
      behind[i] = all[i].m_down;
    }
    if (temperature) k.m.col(j) = temperatures_ahead(c, at, behind).matrix();
  }
  return k;
}

void fill_own_row(const Sums& sums, Index target, ThermalTerms& thermal, MatrixXd& by_dh) {
  thermal.f.row(target) = sums.row(0);
  thermal.df.row(target) = sums.row(1);
  by_dh.row(target) = sums.row(2);
  thermal.g.row(target) += sums.row(3);
  if (sums.rows() > node_weights) thermal.temperature.row(target) += sums.row(5);
}

void fill_row_of_image(const Sums& sums, Index image, ThermalTerms& thermal) {
  for (Index l = 0; l < sums.cols(); ++l) {
    const double sign = l % 2 == 0 ? 1 : -1;
    thermal.g(image, l) += sign * sums(4, l);
    if (sums.rows() > node_weights) thermal.temperature(image, l) += sign * sums(6, l);
  }
}

void fill_stick_rows(ThermalTerms& thermal, const Scene& scene, const Conduction& conduction,
                     const Nodes& z, const GaussLegendre& rule) {
  const Index m = z.d.size();
  const double slip = z.zones.slip, peclet = conduction.peclet * slip;
  const ArrayXd gap = z.d / slip, further = peclet * (gap - gap.minCoeff());
  GradedRule graded;
  grade(graded, peclet, gap.minCoeff(), 0, 2, rule, z.zones.variable);
  const bool law = scene.law != nullptr;
  const FurtherKernels to_stick = kernels_further(conduction, graded.zeta, further, law);
  const MatrixXd heat = graded.heat.matrix().asDiagonal() * legendre(graded.y, thermal.f.cols());
  thermal.f.bottomRows(m).setZero();
  add_product(1, to_stick.n1, heat, thermal.f.bottomRows(m));
  add_product(1, to_stick.n2, heat, thermal.g.bottomRows(m));
  if (law) thermal.temperature.bottomRows(m) = product(1, to_stick.m, heat);
}

/// The kernels of two bodies contain the share of the strain.
void apply_factors(ThermalTerms& thermal, const Scene& scene, Formulation formulation, double slip,
                   bool is_pair) {
  const double sign = slope_sign(formulation), in_n = -sign * scene.friction;  // @eq:N
  const double strain = is_pair ? sign_of(scene.direction) : strain_share(scene);
  const double strength = scene.friction * scene.peclet * heating_of_both(scene) * slip;
  thermal.g = strength * slip * (strain / pi * thermal.g + in_n * thermal.f);
  thermal.f *= -sign * strength * slip;
  thermal.df *= -sign * strength;
  thermal.temperature *= heat_share(scene) * slip * slip / pi;
}

}  // namespace

ThermalTerms thermal_terms(const Scene& scene, Formulation formulation, const Nodes& z, Index terms,
                           const GaussLegendre& rule) {
  const Index n = z.y.size(), m = z.d.size();
  const Conduction conduction(scene, !exchanges(scene, z.zones));
  const double slip = z.zones.slip, peclet = conduction.peclet * slip;
  ThermalTerms thermal{MatrixXd(n + m, terms), MatrixXd(n, terms), MatrixXd::Zero(n + m, terms)};
  if (scene.law) thermal.temperature.setZero(n + m, terms);
  GradedRule graded;
  KernelWeights weights;
  const Index columns = scene.law ? hot_weights : node_weights;
  Sums sums(columns, terms);
  MatrixXd by_dh(n, terms);
  for (Index i = 0; i < n; ++i) {
    grade(graded, peclet, 0, 1 + z.y(i), 1 - z.y(i), rule, z.zones.variable);
    kernel_weights(conduction, graded, columns, weights);
    legendre_sums(graded.y, weights, sums);
    fill_own_row(sums, i, thermal, by_dh);
    if (z.zones.variable.clustered()) {
      grade(graded, peclet, 0, 1 + z.y(i), 1 - z.y(i), rule, mirrored(z.zones.variable));
      kernel_weights(conduction, graded, columns, weights);
      legendre_sums(graded.y, weights, sums);
    }
    fill_row_of_image(sums, n - 1 - i, thermal);
  }
  thermal.df += by_derivatives(by_dh);
  if (m > 0) fill_stick_rows(thermal, scene, conduction, z, rule);
  apply_factors(thermal, scene, formulation, slip, conduction.pair != nullptr);
  return thermal;
}

}  // namespace thermoroll
