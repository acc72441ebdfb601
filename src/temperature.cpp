// Tangled from paper/07-temperature.md; edit there.
#include "temperature.hpp"

#include <algorithm>
#include <cmath>

#include "kernels.hpp"
#include "scene.hpp"

namespace thermoroll {

namespace {
/// Ends of the heated zone [start, end] in z = t - s, its point nearest to z = 0, and the layers
/// about that point that are 1/Pe, the depth, and multiples of 16 of them wide.
std::vector<double> difficult_points(double start, double end, double peclet, double depth) {
  const double nearest = std::clamp(0.0, start, end);
  std::vector<double> points{start, nearest, end};
  for (double width : {1 / peclet, depth})
    for (; width > 0 && width < end - start; width *= 16)
      for (double z : {nearest - width, nearest + width})
        if (start + width / 4 < z && z < end - width / 4) points.push_back(z);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}
}  // namespace

Estimate temperature(const HeatFlux& flux, double peclet, double s, double depth) {
  require(peclet > 0, "peclet", peclet, "positive");
  require(true, "s", s, "finite");
  require(depth >= 0, "depth", depth, "zero or positive");
  const double start = flux.from - s, end = flux.to - s;
  const auto heating = [&](double z) {
    return kernel::M(peclet * z, peclet * depth) * flux.density(z - start, end - z) / pi;
  };
  return integrate(heating, difficult_points(start, end, peclet, depth));
}

Estimate total_heat(const HeatFlux& flux) {
  const double length = flux.to - flux.from;
  return integrate([&](double left) { return flux.density(left, length - left); }, {0, length});
}

Peak max_temperature(const HeatFlux& flux, double peclet) {
  constexpr int samples = 24;
  const auto at = [&](int i) { return flux.from + (flux.to - flux.from) * i / samples; };
  const auto cooler = [&](double s) { return -temperature(flux, peclet, s).value; };
  int best = 0;
  for (int i = 1; i <= samples; ++i)
    if (cooler(at(i)) < cooler(at(best))) best = i;
  const double s = minimum(cooler, at(best - 1), at(best), at(best + 1));
  const Estimate top = temperature(flux, peclet, s);
  const double h = (flux.to - flux.from) / 100;
  const double bend = (cooler(s - h) + cooler(s + h) + 2 * top.value) / (h * h);  // |T''|
  return {s, 2 * std::sqrt(top.error / bend), top};
}

HeatFlux sliding_flux(double heat) {
  return {-1, 1,
          [=](double left, double right) { return heat * 2 / pi * std::sqrt(left * right); }};
}

}  // namespace thermoroll
