// Tangled from paper/23-unlike-bodies.md, paper/24-exchanged-heat.md; edit there.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "solver/grid_solution.hpp"
#include "studies/data.hpp"
#include "studies/paper_scene.hpp"
#include "support/number_text.hpp"
#include "thermoroll/creep_law.hpp"
#include "thermoroll/solution.hpp"

namespace thermoroll {
namespace {

CoupledSolution at_border(const Scene& scene) {
  return solve_coupled(scene, {Formulation::corrected, 1e-8}, {Quantity::stick_slip_border, -0.2});
}

/// The heat of friction, on the slip zone.
Eigen::ArrayXd heat_of_friction(const CoupledSolution& x, const Eigen::ArrayXd& s) {
  const HeatFlux flux = coupled_flux(x);
  return s.unaryExpr(
      [&](double at) { return at > flux.from ? flux.density(at - flux.from, flux.to - at) : 0.0; });
}

Eigen::ArrayXd flux_into_1(const CoupledSolution& x, const Eigen::ArrayXd& s) {
  return heat_share(x.scene) * heat_of_friction(x, s) + exchanged_heat_flux(x, s);
}

Eigen::ArrayXd crowded(double from, double to, Eigen::Index n) {
  const Eigen::ArrayXd share = (Eigen::ArrayXd::LinSpaced(n, 1, static_cast<double>(n)) - 0.5) / n;
  return from + (to - from) / 2 * (1 - (pi * share).cos());
}

std::vector<CoupledSolution> at_four_speeds() {
  std::vector<CoupledSolution> all;
  for (const double pe : {1, 10, 100, 1000})
    all.push_back(at_border({paper::friction, pe, 0, {2, 0, pe / 5}}));
  return all;
}

void shares_along_the_contact(std::ostream& out) {
  row(out, "s", "1", "10", "100", "1000");
  const Eigen::ArrayXd s = crowded(-0.2, 1, 60);
  Eigen::ArrayXXd shares(s.size(), 5);
  shares.col(0) = s;
  Eigen::Index column = 1;
  for (const CoupledSolution& x : at_four_speeds())
    shares.col(column++) = flux_into_1(x, s) / heat_of_friction(x, s);
  for (const auto& r : shares.rowwise()) row(out, r(0), r(1), r(2), r(3), r(4));
}

const FigureData share_a_data{"share-a", shares_along_the_contact};

void fluxes_about_the_border(std::ostream& out) {
  row(out, "s", "1", "10", "100", "1000", "effusivity");
  const Eigen::ArrayXd s = Eigen::ArrayXd::LinSpaced(62, -0.98, 0.24);
  const std::vector<CoupledSolution> all = at_four_speeds();
  const Eigen::ArrayXd friction = heat_of_friction(all[0], s);
  const double top = heat_of_friction(all[0], Eigen::ArrayXd::LinSpaced(601, -0.2, 1)).maxCoeff();
  Eigen::ArrayXXd fluxes(s.size(), 6);
  fluxes << s, flux_into_1(all[0], s) / top, flux_into_1(all[1], s) / top,
      flux_into_1(all[2], s) / top, flux_into_1(all[3], s) / top,
      effusivity_share(all[0].scene) * friction / top;
  for (const auto& r : fluxes.rowwise()) row(out, r(0), r(1), r(2), r(3), r(4), r(5));
}

const FigureData share_b_data{"share-b", fluxes_about_the_border};

CoupledSolution warmer_by(double difference) {
  Scene scene{paper::friction, 100, 0, {1, 0}};
  scene.bulk_difference = difference;
  return at_border(scene);
}

void fluxes_of_a_hot_wheel(std::ostream& out) {
  row(out, "s", "rail", "wheel", "closed_rail", "closed_wheel");
  const double c = 0.01 * std::sqrt(100 / (2 * pi));
  const CoupledSolution x = warmer_by(0.01);
  Eigen::ArrayXd s(80);
  s << crowded(-1, -0.2, 40), crowded(-0.2, 1, 40);
  const Eigen::ArrayXd rail = flux_into_1(x, s) / c, all = heat_of_friction(x, s) / c;
  const Eigen::ArrayXd closed = (1 + s).sqrt().inverse();
  for (Eigen::Index i = 0; i < s.size(); ++i)
    row(out, s(i), rail(i), all(i) - rail(i), closed(i), -closed(i));
}

const FigureData hot_wheel_a_data{"hot-wheel-a", fluxes_of_a_hot_wheel};

std::vector<CurvePoint> curve_of(double difference, const std::vector<double>& s) {
  Scene scene{paper::friction, 100, 0, {1, 0}};
  scene.bulk_difference = difference;
  const Approach exact{Formulation::corrected, 1e-8, Method::coupled};
  return temperature_curve(solve(scene, {Quantity::stick_slip_border, -0.2}, exact), s, 0).points;
}

void temperatures_of_a_hot_wheel(std::ostream& out) {
  row(out, "s", "friction", "alone", "closed");
  std::vector<double> s{-2};
  for (const auto& part :
       {grid(-1.05, -0.95, 20), grid(-0.9, 0.9, 45), grid(0.95, 1.05, 10), grid(1.1, 4, 58)})
    s.insert(s.end(), part.begin(), part.end());
  const std::vector<CurvePoint> warm = curve_of(0.01, s), even = curve_of(0, s);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double behind = std::asin(std::sqrt(2 / (1 + std::max(s[i], 1.0)))) / pi;
    row(out, s[i], warm[i].temperature / 0.01, (warm[i].temperature - even[i].temperature) / 0.01,
        s[i] < -1 ? 0 : behind);
  }
}

const FigureData hot_wheel_b_data{"hot-wheel-b", temperatures_of_a_hot_wheel};

CreepLaw law_of_a_wheel(double friction, double difference) {
  Scene scene{friction, 100, paper::heating, {1, paper::heating}};
  scene.law = linear_friction({0.06});
  scene.bulk_difference = difference;
  return creep_law(scene, Formulation::corrected, 1e-6);
}

void grips_of_a_hot_wheel(std::ostream& out) {
  row(out, "creep", "equal", "third", "whole", "mean_third", "mean_whole");
  const double f = paper::friction, sixth = 5 * f / 6, half = f / 2;
  const CreepLaw laws[] = {law_of_a_wheel(f, 0), law_of_a_wheel(f, 0.02), law_of_a_wheel(f, 0.06),
                           law_of_a_wheel(sixth, 0), law_of_a_wheel(half, 0)};
  for (const double creep : grid(0, 0.6, 60)) {
    double q[5];
    std::transform(std::begin(laws), std::end(laws), q,
                   [&](const CreepLaw& law) { return evaluate(law, creep).value().traction; });
    row(out, creep, q[0], q[1], q[2], q[3], q[4]);
  }
}

const FigureData hot_wheel_grip_data{"hot-wheel-grip", grips_of_a_hot_wheel};

void without_slip(std::ostream& out) {
  row(out, "$\\mathrm{Pe}$", "$\\xi_0^*/X$", "$Q_0^*/X$");
  for (const double pe : {1, 10, 100, 1000, 10000}) {
    Scene scene{1, pe, 1, {1, 1}};
    scene.bulk_difference = 1 / std::sqrt(pe / pi);
    const NoSlip rest = no_slip(scene);
    row(out, pe, fixed(rest.creep, 4), fixed(rest.traction, 4));
  }
}

const FigureData no_slip_data{"no-slip", without_slip};

}  // namespace
}  // namespace thermoroll
