// Tangled from paper/10-coupled-solver.md; edit there.
#include "solver/surface.hpp"

#include <cmath>

#include "solver/contact_grid.hpp"

namespace thermoroll {

using Eigen::ArrayXd;
using Eigen::Index;

SmoothFlux smooth_flux(const Carter& c) {
  const ZoneLengths at{2 * c.slip_half_width, 2 * c.b};
  return {at.slip, at.stick, carter_h(at, c.friction)};
}

SmoothFlux smooth_flux(const CoupledSolution& x) {
  return {x.value(slip_length), 1 + x.value(border), x.h};
}

namespace {
/// Estimated error of all temperatures, of which the largest is top, from what eight more nodes
/// have changed at most.
double quadrature_error(int nodes, double change, double top) {
  return change / 2 + (6 * std::pow(nodes, -6) + 1e-14) * top;
}
}  // namespace

SurfaceCurve surface_curve(const SmoothFlux& x, double peclet, const ArrayXd& s, double tolerance) {
  require(peclet > 0, "peclet", peclet, "positive");
  require(tolerance >= 1e-12, "tolerance", tolerance, "at least 1e-12");
  for (const double place : s) require(true, "s", place, "finite");
  if (s.size() == 0) return {s, 0};
  const Index every = s.size() / 20 + 1, own = (s.size() + every - 1) / every;
  ArrayXd some(own + 4);
  for (Index i = 0; i < own; ++i) some(i) = s(i * every);
  const ArrayXd y = gauss_legendre(4).x;
  for (Index i = 0; i < 4; ++i)
    some(own + i) = 1 - x.slip * (1 - SlipPoint(1 + y(i), 1 - y(i)).t());
  const auto with = [&](int nodes, const ArrayXd& at) {
    return surface_temperature({x.slip, x.stick}, peclet, x.h, at, gauss_legendre(nodes));
  };
  int nodes = 40;
  for (ArrayXd before = with(nodes, some);;) {
    const ArrayXd now = with(nodes += 8, some);
    const double top = now.maxCoeff();
    const double error = quadrature_error(nodes, (now - before).abs().maxCoeff(), top);
    if (error <= tolerance * top || nodes >= most_unknowns) return {with(nodes, s), error};
    before = now;
  }
}

Peak hottest_point(const SmoothFlux& x, double peclet, double tolerance) {
  int nodes = 40;
  for (HottestPoint before = find_hottest(x.slip, peclet, x.h, {}, gauss_legendre(nodes));;) {
    const HottestPoint now = find_hottest(x.slip, peclet, x.h, before, gauss_legendre(nodes += 8));
    const double error = quadrature_error(nodes, std::abs(now.value - before.value), now.value);
    if (error <= tolerance * now.value || nodes >= most_unknowns) {
      const double moved = std::abs(now.y - before.y) + 1e-9;
      const SlipPoint at(1 + now.y, 1 - now.y);
      const double s = (x.stick - x.slip) / 2 + x.slip * at.t();
      const double at_error = 6 * x.slip * at.u * at.v * at.du * moved;
      return {s, at_error, {now.value, error}};
    }
    before = now;
  }
}

}  // namespace thermoroll
