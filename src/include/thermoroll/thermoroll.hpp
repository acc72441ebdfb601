// Tangled from paper/H-build.md; edit there.
#pragma once

// Solve with solve(); results are dimensionless. A program that links the library has GSL's error
// handler, which would abort, turned off: GSL's errors are looked at and thrown as exceptions.

#include "thermoroll/creep_law.hpp"
#include "thermoroll/solution.hpp"
#include "thermoroll/temperature.hpp"
