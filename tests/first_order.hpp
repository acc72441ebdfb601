// The thermal effect on load and eccentricity to first order in H, from the integral equation.
#pragma once

#include <cmath>

#include "reference.hpp"

namespace reference {

/// 1 - kappa and gamma0 per f H, to first order in H, of the integral equations themselves. The
/// normal equation has a bounded pressure only if the integrals of its right side with
/// 1/sqrt(1-s^2) and s/sqrt(1-s^2) fit; with Carter's heat g that gives, for f = 0.6 and the sign
/// as printed,
///   1 - kappa = f H  int g(t) int s/sqrt(1-s^2) Pe N1(Pe (t-s)) ds dt,
///   gamma0 = -(f H/pi) int g(t) int 1/sqrt(1-s^2) Pe N1(Pe (t-s)) ds dt.
struct FirstOrder {
  Real load_loss, gamma0;
};
inline FirstOrder first_order(double traction, Real peclet) {
  constexpr double friction = 0.6;
  const Real b = std::sqrt(1 - traction / static_cast<Real>(friction)), step = 1 / 8.0L;
  const auto moment = [&](bool odd) {
    return integral(
        [&](Real left, Real right) {
          const Real heat = 4 * friction / (pi * pi) * (2 * b + left) * std::sqrt(left * right);
          const Real length = 2 * b + left;  // from s = -1 to s = t = 1 - right
          // int N1 / sqrt(1-s^2) over distances z = t - s, in panels that resolve z = 1/Pe.
          Real sum = 0, from = 0;
          for (Real to = 1 / peclet; from < length; from = to, to *= 16) {
            const Real end = to < length / 2 ? to : length;
            sum += integral(
                [&](Real near, Real far) {
                  const Real z = from + near, s = 1 - right - z;
                  const Real ahead = end == length ? far : 1 + s;  // 1 + s
                  return (odd ? s : 1) * peclet * N1(peclet * z) / std::sqrt(ahead * (right + z));
                },
                end - from, step);
            to = end;
          }
          return heat * sum;
        },
        2 - 2 * b, step);
  };
  return {moment(true), -moment(false) / pi};
}

}  // namespace reference
