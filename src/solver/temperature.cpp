// Tangled from paper/07-temperature.md; edit there.
#include "thermoroll/temperature.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

namespace {
/// The ends of the heated zone, start <= 0 <= end, the point 0 between them, and powers of 16
/// of the given widths to both sides of it, unless an end is about as near.
std::vector<double> difficult_points(double start, double end,
                                     std::initializer_list<double> widths) {
  std::vector<double> points{start, 0, end};
  for (double width : widths)
    for (; width > 0 && width < end - start; width *= 16)
      for (const double u : {-width, width})
        if (start + width / 4 < u && u < end - width / 4) points.push_back(u);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}
}  // namespace

Estimate temperature(const HeatFlux& flux, double peclet, double s, double depth, double scale) {
  require(peclet > 0, "peclet", peclet, "positive");
  require(true, "s", s, "finite");
  require(depth >= 0, "depth", depth, "zero or positive");
  const double nearest = std::clamp(s, flux.from, flux.to), gap = nearest - s;
  const double start = flux.from - nearest, end = flux.to - nearest;
  const auto integrand = [&](double u) {
    return kernel::M(peclet * (gap + u), peclet * depth) * flux.density(u - start, end - u) / pi;
  };
  return integrate(integrand,
                   difficult_points(start, end, {1 / peclet, depth, std::abs(gap), -start, end}),
                   scale);
}

Estimate total_heat(const HeatFlux& flux) {
  const double length = flux.to - flux.from;
  return integrate([&](double left) { return flux.density(left, length - left); }, {0, length});
}

Peak hottest_point(const HeatFlux& flux, double peclet) {
  constexpr int samples = 24;
  const double length = flux.to - flux.from;
  const auto place = [&](double share) { return flux.from + length * share; };
  const auto cooler = [&](double share) { return -temperature(flux, peclet, place(share)).value; };
  const auto at = [&](int i) { return static_cast<double>(i) / samples; };
  int best = 0;
  for (int i = 1; i <= samples; ++i)
    if (cooler(at(i)) < cooler(at(best))) best = i;
  const double share = minimum(cooler, at(best - 1), at(best), at(best + 1)), h = 0.01;
  const Estimate top = temperature(flux, peclet, place(share));
  const double bend = (cooler(share - h) + cooler(share + h) + 2 * top.value) / (h * h);  // |T''|
  return {place(share), length * 2 * std::sqrt(top.error / bend), top};
}

HeatFlux sliding_flux(double heat) {
  return {-1, 1,
          [=](double left, double right) { return heat * 2 / pi * std::sqrt(left * right); }};
}

}  // namespace thermoroll
