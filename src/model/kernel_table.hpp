// Tangled from paper/E-fast-kernels.md; edit there.
#pragma once

#include <cstddef>
#include <vector>

namespace thermoroll {

/// The kernels at one distance x = |zeta|: N1(x), N2(x), N2(-x) and M(-x). (N1(-x) is zero, and
/// M(x) is M(-x) times exp(-2x).)
struct Kernels {
  double n1, n2_up, n2_down, m_down;
};

/// The functions of kernels.hpp from a table, distance > 0; relative error below 1e-13 (of the
/// larger term where terms cancel).
Kernels fast_kernels(double distance);

/// The same for n distances.
void fast_kernels(std::size_t n, const double* distance, Kernels* k);

/// The kernels N1 and N2 at one zeta.
struct SlopeAndStrain {
  double n1, n2;
};

/// kernel::N1 and kernel::N2 from the table, zeta != 0.
SlopeAndStrain fast_slope_and_strain(double zeta);

/// kernel::M at the surface from the table, zeta != 0; error relative to kernel::M(-|zeta|), that
/// is, to what the same source does downstream.
double fast_temperature(double zeta);

/// A cell of the table and its coefficients of u^0 ... u^9 in turn, four kernels each, in the order
/// of Kernels; u is -1 at low and 1 at high.
struct KernelCell {
  double low, high;
  const double* coefficients;
};

/// All cells, from short to long distances.
std::vector<KernelCell> kernel_cells();

}  // namespace thermoroll
