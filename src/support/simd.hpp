// Tangled from paper/E-fast-kernels.md; edit there.
#pragma once

#include <cstring>

namespace thermoroll {

/// Four numbers at a time: one register of a processor with AVX2, two of any other of its kind.
using Pack4 [[gnu::vector_size(32)]] = double;

/// Take the four numbers from there on, or put them there.
inline void load(const double* from, Pack4& x) { std::memcpy(&x, from, sizeof x); }
inline void store(const Pack4& x, double* to) { std::memcpy(to, &x, sizeof x); }

/// Their sum.
inline double sum_of(const Pack4& x) { return (x[0] + x[1]) + (x[2] + x[3]); }

}  // namespace thermoroll

/// A function compiled twice, with and without AVX2 (or once, without, on request); which is called
/// is found when the program is loaded. That is too early for GCC's thread sanitizer.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(THERMOROLL_ONCE) && \
    !defined(__SANITIZE_THREAD__)
#define THERMOROLL_CLONES [[gnu::target_clones("avx2", "default")]]
#else
#define THERMOROLL_CLONES
#endif
