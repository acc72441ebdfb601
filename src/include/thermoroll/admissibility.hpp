// Tangled from paper/04-integral-equations.md; edit there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

// The library and its users must align alike, or memory of one is freed wrongly by the other.
static_assert(EIGEN_MAX_ALIGN_BYTES == 64, "compile with -DEIGEN_MAX_ALIGN_BYTES=64");

namespace thermoroll {

/// The factors of a solution at ascending s inside (-1, 1), on both zones: pressure is
/// p* / sqrt(1 - s^2), slip is v* / sqrt((1 + s)(s - c0)) beyond the border, or v* in full slip,
/// and (f phi p* - q*) / sqrt((1 + s)(c0 - s)) before it. Dimensionless.
struct Factors {
  double friction, border, load_ratio;  ///< f, c0, kappa
  Eigen::ArrayXd s, pressure, slip;
  Eigen::ArrayXd phi{};  ///< of a law of friction; empty if friction is constant
};

/// A condition of @eq:admissible that fails: "separation" (p < 0), "backward slip" (v < 0),
/// "traction above friction", "traction below -friction" (on stick), or "no load" (kappa <= 0), in
/// from < s < to.
struct Violation {
  std::string what;
  double from, to;
};

/// The violated conditions, in that order; a NaN is a violation. Empty for a contact.
std::vector<Violation> violations(const Factors& at);

/// The violations of b that a has too: of the same condition, in an interval that shares half of
/// what both cover together. Without a value if they disagree: none is shared, and one has some.
std::optional<std::vector<Violation>> agreed_violations(const std::vector<Violation>& a,
                                                        const std::vector<Violation>& b);

}  // namespace thermoroll
