// Tangled from paper/M-certified.md; edit there.
#include <cstdio>
#include <string>

#include <acb.h>

#include "bench/certify/certify.hpp"

namespace thermoroll::certify {
namespace {

#ifdef ARB_VERSION
constexpr char library[] = "Arb " ARB_VERSION;
#else
constexpr char library[] = "FLINT " FLINT_VERSION;
#endif

/// "m,r" of a real ball, the midpoint with sixteen digits, or three of a large ball.
std::string in_decimals(const Ball& x) {
  const bool rough = acb_rel_accuracy_bits(x.of()) < 8;
  char* const text = arb_get_str(acb_realref(x.of()), rough ? 3 : 16, rough ? ARB_STR_MORE : 0);
  std::string all = text;
  flint_free(text);
  const std::size_t at = all.find(" +/- ");
  if (at == std::string::npos) return all + ",0";
  const std::string middle = at > 1 ? all.substr(1, at - 1) : "0";
  return middle + "," + all.substr(at + 5, all.size() - at - 6);
}

}  // namespace
}  // namespace thermoroll::certify

int main(int count, char** words) {
  using namespace thermoroll::certify;
  if (count < 4) {
    std::fputs("thermoroll-certify temperatures|tables|first-order REVISION DATE\n", stderr);
    return 2;
  }
  const std::string part = words[1], when = std::string(words[2]) + "," + words[3];
  const Rows rows = [&](const std::string& before, const Ball& x) {
    std::printf("%s,%s,%s,%s\n", before.c_str(), in_decimals(x).c_str(), library, when.c_str());
    std::fflush(stdout);
  };
  if (part == "temperatures")
    certified_temperatures(rows);
  else if (part == "tables")
    certified_tables(rows);
  else if (part == "first-order")
    certified_first_order(rows);
  else
    return 2;
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? 0 : 1;
}
