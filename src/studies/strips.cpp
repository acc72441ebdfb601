// Tangled from paper/21-hot-friction.md; edit there.
#include "studies/strips.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "thermoroll/scene.hpp"

namespace thermoroll {

/// T = before + own phi(T).
double local_temperature(const FrictionLaw& law, double before, double own) {
  double t = before;
  for (int step = 0; step < 20; ++step) {
    const RelativeFriction phi = law(t);
    t -= (t - before - own * phi.value) / (1 - own * phi.slope);
  }
  return t;
}

OnEllipse on_strip(const EllipticContact& x, const FrictionLaw& law, double y, int cells,
                   double own_weight) {
  const double end = std::sqrt(1 - y * y), h = 2 * end * x.half_length / cells;
  const double unit = 1 / (2 * x.effusivity * std::sqrt(pi * x.speed));
  std::vector<double> flux;
  OnEllipse strip{0, 0};
  for (int i = 0; i < cells; ++i) {
    const double s = end * ((2 * i + 1.0) / cells - 1);
    const double p = x.pressure * std::sqrt(std::max(0.0, end * end - s * s));
    const double slip = x.slip_ahead + (x.slip_behind - x.slip_ahead) * (1 + s) / 2;
    const double full = x.friction * p * slip * x.speed;  // of constant friction
    double before = 0;
    for (int j = 0; j < i; ++j)
      before += flux[static_cast<std::size_t>(j)] * 2 *
                (std::sqrt((i - j + 0.5) * h) - std::sqrt((i - j - 0.5) * h));
    const double own = own_weight * 2 * std::sqrt(h / 2) * unit * full;
    const double t = local_temperature(law, unit * before, own), phi = law(t).value;
    flux.push_back(phi * full);
    strip.temperature = std::max(strip.temperature, t);
    strip.force += phi * p * h;
    strip.normal += p * h;
  }
  return strip;
}

OnEllipse on_ellipse(const EllipticContact& x, const FrictionLaw& law, const Cells& cells) {
  OnEllipse all{0, 0};
  for (int k = 0; k < cells.strips; ++k) {
    const double y = (k + 0.5) / cells.strips;
    const int along =
        std::max(1, static_cast<int>(std::lround(cells.middle * std::sqrt(1 - y * y))));
    const OnEllipse strip = on_strip(x, law, y, along, cells.own_weight);
    all.force += strip.force;
    all.temperature = std::max(all.temperature, strip.temperature);
    all.normal += strip.normal;
  }
  all.force /= all.normal;
  return all;
}

}  // namespace thermoroll
