// Tangled from paper/21-hot-friction.md; edit there.
#pragma once

#include <cmath>

#include "thermoroll/friction_law.hpp"

namespace thermoroll {

/// SI units; two bodies of one effusivity. The slip is over the speed, at both ends of the middle
/// strip.
struct EllipticContact {
  double half_length, half_width, pressure, speed, slip_ahead, slip_behind, friction;
  double effusivity = std::sqrt(50 * 7850 * 450.0);  // of steel, sqrt(K rho c)
};

struct OnEllipse {
  double force;        // of a strip in N/m, of all over that of constant friction
  double temperature;  // the largest, in degrees
  double normal = 0;   // the integral of the pressure over the same cells, N/m
};

/// Strips on half of the ellipse, cells on the middle one, and the weight of a cell for its own
/// temperature over that of @eq:strip.
struct Cells {
  int strips;
  double middle, own_weight;
};

/// The force and the largest temperature by strips, @eq:strip; the law is by the rise in degrees.
OnEllipse on_ellipse(const EllipticContact& x, const FrictionLaw& law, const Cells& cells);

}  // namespace thermoroll
