// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#pragma once

#include <cstdlib>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace thermoroll {

/// Have the C library keep what this program frees, up to 64 MB, as the next solve needs it.
inline void keep_freed_memory() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, 1 << 26);
#endif
}

}  // namespace thermoroll
