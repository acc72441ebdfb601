// Tangled from paper/M-certified.md; edit there.
#pragma once

#include <functional>
#include <string>

#include "bench/certify/ball.hpp"

namespace thermoroll::certify {

/// Carter's solution, @eq:carter, for the doubles f and Q* as they are.
struct ColdContact {
  ColdContact(double friction, double traction)
      : f(friction), b(root((f - traction) / f)), l(1 - b), c0(2 * b - 1) {
    unit = 4 * f / (pi_ball() * pi_ball());
  }
  Ball f, b, l, c0, unit;
};

/// Writes a row: the cells before a ball, its midpoint and its radius.
using Rows = std::function<void(const std::string&, const Ball&)>;

/// e^z K0(z), and without a digit unless z > 0; e^-z (I0 - I1); e^-z I_order; and that over z.
Ball temperature_kernel(const Ball& z);
Ball slope_kernel(const Ball& z);
Ball mean_of_exponentials(int order, const Ball& z);
Ball weighted_mean(int order, const Ball& z);

/// Compute the rows of each table.
void certified_temperatures(const Rows& rows);
void certified_tables(const Rows& rows);
void certified_first_order(const Rows& rows);

}  // namespace thermoroll::certify
