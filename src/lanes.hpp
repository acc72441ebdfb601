// Tangled from paper/10-coupled-solver.md; edit there.
#pragma once

namespace thermoroll {

/// Four numbers at a time: one register of a processor with AVX2, two of any other of its kind.
using Four = double __attribute__((vector_size(32), aligned(8), may_alias));

/// The four numbers from x on.
inline Four& four(double* x) { return *reinterpret_cast<Four*>(x); }
inline const Four& four(const double* x) { return *reinterpret_cast<const Four*>(x); }

/// Their sum.
inline double total(const Four& x) { return (x[0] + x[1]) + (x[2] + x[3]); }

}  // namespace thermoroll

/// A function compiled twice, with and without AVX2; which is called is found when the program is
/// loaded.
#if defined(__x86_64__) && defined(__gnu_linux__)
#define TWICE __attribute__((target_clones("avx2", "default")))
#else
#define TWICE
#endif
