// Tangled from paper/03-kernels.md; edit there.
#pragma once

namespace thermoroll {

/// Which sign the thermal slope N1 carries in the normal equation (@eq:normal): as printed, or
/// corrected so that heat makes the surface bulge outward.
enum class Formulation { printed, corrected };

/// +1 as printed, -1 corrected: the factor of N1 in @eq:normal.
constexpr double slope_sign(Formulation formulation) {
  return formulation == Formulation::printed ? 1 : -1;
}

/// Responses of the surface to a moving line of heat. All are dimensionless and take zeta = Pe z
/// (@eq:zeta), z = source less observer: zeta > 0 is upstream. Relative error below 1e-13 for
/// 1e-12 <= |zeta| <= 1e12 (of the larger term where terms cancel; of M while it exceeds 1e-87).
namespace kernel {

/// Slope N1, @eq:N1; zero for zeta <= 0 (Heaviside's step, zero at zero).
double N1(double zeta);

/// Strain N2, @eq:N2; zeta != 0, where it is logarithmically infinite.
double N2(double zeta);

/// Temperature M at the depth eta = Pe y >= 0, @eq:M-depth; (zeta, eta) != (0, 0).
double M(double zeta, double eta = 0);

/// Stick-zone kernel N, @eq:N; zeta != 0.
double N(double zeta, double friction, Formulation formulation);

}  // namespace kernel
}  // namespace thermoroll
