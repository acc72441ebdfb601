// Tangled from paper/05-closed-form.md; edit there.
#include "thermoroll/carter.hpp"

#include <algorithm>
#include <cmath>

#include "support/number_text.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

double hertz_pressure(double s) {
  return std::abs(s) < 1 ? 2 / pi * std::sqrt((1 - s) * (1 + s)) : 0;
}

Carter carter(double friction, double traction) {
  require(friction > 0, "friction", friction, "positive");
  require(traction > 0 && traction < friction, "traction", traction,
          "above 0 and below the friction, " + shortest(friction));
  const double b = std::sqrt((friction - traction) / friction);
  const double slip_half_width = traction / friction / (1 + b);  // 1 - b
  return {friction, b, slip_half_width, 2 * b - 1, 2 * friction / pi * slip_half_width};
}

double carter_traction(const Carter& c, double s) {
  const double stuck = std::max((1 + s) * (c.c0 - s), 0.0);
  return c.friction * (hertz_pressure(s) - 2 / pi * std::sqrt(stuck));
}

double carter_slip(const Carter& c, double s) {
  return s > c.c0 ? 2 * c.friction / pi * std::sqrt((1 + s) * (s - c.c0)) : 0;
}

HeatFlux carter_flux(const Carter& c) {
  const double scale = 4 * c.friction / (pi * pi), stick = 2 * c.b;  // 1 + s = 2b + left
  return {c.c0, 1, [=](double left, double right) {
            return scale * (stick + left) * std::sqrt(left * right);
          }};
}

double carter_heat(const Carter& c) {
  return c.creep * c.slip_half_width * (1 + c.b);  // xi* Q*/f
}

double carter_creep_curve(double friction, double creep) {
  require(friction > 0, "friction", friction, "positive");
  require(creep >= 0, "creep", creep, "zero or positive");
  const double slip_half_width = std::min(pi * creep / (2 * friction), 1.0);  // 1 - b
  return friction * slip_half_width * (2 - slip_half_width);
}

}  // namespace thermoroll
