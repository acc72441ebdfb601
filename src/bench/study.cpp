// Tangled from paper/F-data-files.md; edit there.
#include <cstdlib>
#include <iostream>

#include "studies/estimate_study.hpp"

int main(int argc, char** argv) {
  const int count = argc == 2 ? std::atoi(argv[1]) : 0;
  if (count <= 0) return 2;
  thermoroll::write_study(count, std::cout);
  return std::cout ? 0 : 1;
}
