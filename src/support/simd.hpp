// Tangled from paper/E-fast-kernels.md; edit there.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace thermoroll {

/// Four numbers at a time: one register of a processor with AVX2, two of any other of its kind.
using Pack4 [[gnu::vector_size(32)]] = double;

/// Take the numbers of a pack from there on, or put them there.
template <class Pack>
inline void load(const double* from, Pack& x) {
  std::memcpy(&x, from, sizeof x);
}
template <class Pack>
inline void store(const Pack& x, double* to) {
  std::memcpy(to, &x, sizeof x);
}

/// Their sum, and the sums of four packs, added in the same order.
inline double sum_of(const Pack4& x) { return (x[0] + x[1]) + (x[2] + x[3]); }
[[gnu::always_inline]] inline void sums_of(const Pack4* x, Pack4& sums) {
  Pack4 pairs[2];
  for (int i = 0; i < 2; ++i) {
    const Pack4 &a = x[2 * i], &b = x[2 * i + 1];
    pairs[i] = Pack4{a[0], b[0], a[2], b[2]} + Pack4{a[1], b[1], a[3], b[3]};
  }
  sums = Pack4{pairs[0][0], pairs[0][1], pairs[1][0], pairs[1][1]} +
         Pack4{pairs[0][2], pairs[0][3], pairs[1][2], pairs[1][3]};
}

/// 1/13!, 1/12! ... 1/2!
inline constexpr double inverse_factorials[] = {
    1 / 6227020800.0, 1 / 479001600.0, 1 / 39916800.0, 1 / 3628800.0, 1 / 362880.0, 1 / 40320.0,
    1 / 5040.0,       1 / 720.0,       1 / 120.0,      1 / 24.0,      1 / 6.0,      1 / 2.0};

/// 2^k and exp(r) - 1, of which x is k ln 2 + r; |x| < 700.
[[gnu::always_inline]] inline void split_exp(const Pack4& x, Pack4& power, Pack4& rest) {
  using Bits [[gnu::vector_size(32)]] = std::int64_t;
  constexpr double whole = 0x1.8p52 + 1023;
  const Pack4 shifted = x * 0x1.71547652b82fep0 + whole, k = shifted - whole;
  const Pack4 r = x - k * 0x1.62e42feep-1 - k * 0x1.a39ef35793c76p-33, square = r * r;
  Pack4 even = {}, odd = {};
  for (const double* c = inverse_factorials; c < std::end(inverse_factorials); c += 2) {
    even = even * square + c[1];
    odd = odd * square + c[0];
  }
  power = reinterpret_cast<Pack4>(reinterpret_cast<Bits>(shifted) << 52);
  rest = r + square * (even + r * odd);
}

/// y = exp(x) - 1 for |x| < 700, with an error of at most three roundings.
[[gnu::always_inline]] inline void exp_less_one(const Pack4& x, Pack4& y) {
  Pack4 power, rest;
  split_exp(x, power, rest);
  y = (power - 1) + power * rest;
}

/// y = exp(x) for |x| < 700, with an error of at most two.
[[gnu::always_inline]] inline void exp_of(const Pack4& x, Pack4& y) {
  Pack4 power, rest;
  split_exp(x, power, rest);
  y = power + power * rest;
}

/// y = sinh(x) for |x| < 700, from it, with an error of at most five.
[[gnu::always_inline]] inline void sinh_of(const Pack4& x, Pack4& y) {
  Pack4 grown;
  exp_less_one(x < 0 ? -x : x, grown);
  y = (grown + grown / (1 + grown)) / 2;
  y = x < 0 ? -y : y;
}
inline void sinh_of(double x, double& y) { y = std::sinh(x); }

}  // namespace thermoroll

/// A function compiled twice, with and without AVX2 (or once, without, on request); which is called
/// is found when the program is loaded. That is too early for GCC's thread sanitizer, and Clang 14
/// does not find such a function from another file.
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(THERMOROLL_ONCE) && \
    !defined(__SANITIZE_THREAD__) && !defined(__clang__)
#define THERMOROLL_CLONES [[gnu::target_clones("avx2", "default")]]
#else
#define THERMOROLL_CLONES
#endif
