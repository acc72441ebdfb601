// Tangled from paper/A-one-answer.md; edit there.
#pragma once

#include "thermoroll/kernels.hpp"

namespace thermoroll {

/// The least model that meets the tolerance; Carter's closed form without thermal deformation, its
/// first order in H, the coupled solver; the published Gauss-Chebyshev scheme.
enum class Method { automatic, closed_form, first_order, coupled, gauss_chebyshev };

/// How a scene is to be solved.
struct Approach {
  Formulation formulation = Formulation::corrected;  ///< makes no difference to the closed form
  double tolerance = 1e-6;                           ///< of all but the scheme, 1e-11 to 1e-2
  Method method = Method::automatic;                 ///< for solve(); others are one method
  int nodes = 200;                                   ///< of the scheme, 3 to 5000
};

}  // namespace thermoroll
