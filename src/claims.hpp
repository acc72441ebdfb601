// Tangled from paper/11-results.md; edit there.
#pragma once

#include <string>
#include <vector>

namespace thermoroll {

/// A statement of the paper beside what we find; every field is text for a table.
struct Claim {
  std::string claim;      ///< what the paper says
  std::string paper;      ///< its value
  std::string printed;    ///< the published scheme's value, run again
  std::string converged;  ///< the converged value
  std::string verdict;
};

/// Every claim of the paper's text; runs the published scheme some twenty times.
std::vector<Claim> claims();

/// T*max in rolling over T*max in pure sliding with the same heat, at Pe = 1000 and f = 0.6;
/// 0 < traction < 0.6.
double rolling_to_sliding(double traction);

/// 1 - kappa and gamma0 to first order in H at high speed, @eq:first-order, with the sign as
/// printed, f = 0.6 and H = 0.0175; 0 < traction < 0.6.
double first_order_load_change(double traction);
double first_order_gamma0(double traction);

/// Degrees C that T* = 1 is worth for the wheel on the rail at a Péclet number > 0.
double celsius_at(double peclet);

}  // namespace thermoroll
