// Tangled from paper/10-coupled-solver.md; edit there.
#pragma once

namespace thermoroll {

/// The kernels N1 and N2 at one zeta.
struct SlopeAndStrain {
  double n1, n2;
};

/// kernel::N1 and kernel::N2 from tables, zeta != 0; relative error below 1e-13 (of the larger
/// term where terms cancel).
SlopeAndStrain fast_slope_and_strain(double zeta);

/// kernel::M at the surface from a table, zeta != 0; error below 1e-13 of kernel::M(-|zeta|), that
/// is, of what the same source does downstream.
double fast_temperature(double zeta);

}  // namespace thermoroll
