// What the fuzz targets share. A target is one function of bytes, called by libFuzzer (make fuzz)
// and by replay.cpp with the files of the corpus (the tests).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <typeinfo>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

/// Stop, as a crash would.
[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "FAILED: %s\n", what.c_str());
  std::abort();
}

/// Do something; true if it is done, false if it is refused by one of the errors that are allowed
/// and that say something. Whatever else is thrown ends the program.
template <class... Allowed, class Action>
bool done_or_refused(const Action& action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    if (!(... || (typeid(error) == typeid(Allowed)))) throw;
    if (*error.what() == '\0') fail("an error without a word");
    return false;
  }
}

}  // namespace fuzz
