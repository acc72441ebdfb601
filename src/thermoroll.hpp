// Tangled from paper/C-build.md; edit there.
#pragma once

#include "solution.hpp"
#include "temperature.hpp"
