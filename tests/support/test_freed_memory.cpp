// That the C library keeps what a program frees.
#include <unistd.h>

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "support/freed_memory.hpp"

namespace {

// The end of the heap moves for the first of two blocks of the same size, and stays when that is
// freed. Both are larger than what the C library would map apart. Under the sanitizers, and with
// another C library, memory is not theirs to keep, and there is no such test.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
char written(std::size_t size) {
  const std::vector<char> all(size, 1);
  return all[size / 2];
}

TEST(FreedMemory, IsKept) {
  thermoroll::keep_freed_memory();
  const std::size_t size = std::size_t{1} << 24;
  const char* const start = static_cast<char*>(sbrk(0));
  ASSERT_EQ(written(size), 1);
  const char* const end = static_cast<char*>(sbrk(0));
  EXPECT_GE(end - start, static_cast<std::ptrdiff_t>(size));
  ASSERT_EQ(written(size), 1);
  EXPECT_EQ(sbrk(0), end);
}
#endif

}  // namespace
