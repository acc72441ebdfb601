// Tangled from paper/A-one-answer.md; edit there.
#pragma once

#include <Eigen/Core>

#include "thermoroll/coupled.hpp"

namespace thermoroll {

/// Positions, pressures, tractions and their bounds on both zones, and the slip velocity and heat
/// flux on the slip zone, where the traction is its bound.
struct Curves {
  Eigen::ArrayXd slip_at, slip_pressure, slip_traction, slip, heat_flux;
  Eigen::ArrayXd stick_at, stick_pressure, stick_traction, stick_bound;
};

/// The curves at -1 <= x <= 1, the variable of each zone, at -1 of which is the border.
Curves curves_at(const Eigen::ArrayXd& x, const SmoothTractions& by, double friction);

/// The variables x of one stick zone as those of another grid, at the same places.
Eigen::ArrayXd stick_places(const Eigen::ArrayXd& x, const SmoothTractions& from,
                            const SmoothTractions& to);

/// Points in the variables of @lst:curves-code: those of the stick zone descend from the leading
/// edge, without the border, and those of the slip zone ascend.
struct PlotPoints {
  Eigen::ArrayXd stick, slip;
};

/// The profiles of a solution at these points, with zeros for the temperature.
Profile profile_at(const CoupledSolution& x, const PlotPoints& at);

}  // namespace thermoroll
