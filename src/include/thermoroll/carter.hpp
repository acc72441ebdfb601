// Tangled from paper/05-closed-form.md; edit there.
#pragma once

#include <functional>

namespace thermoroll {

/// A dimensionless heat flux v* p* on (from, to), zero elsewhere.
struct HeatFlux {
  double from;  ///< start of the heated zone, c0 in rolling, -1 in sliding
  double to;    ///< its end, 1 in a contact
  /// The flux at the distances left = s - from >= 0 and right = to - s >= 0 from the ends.
  std::function<double(double left, double right)> density;
};

/// Hertz and Carter's solution at H = 0, @eq:carter. Dimensionless.
struct Carter {
  double friction;         ///< f
  double b;                ///< half-width of the stick zone, in (0, 1]; 1 by rounding
  double slip_half_width;  ///< 1 - b, half-width of the slip zone, to full relative accuracy
  double c0;               ///< stick-slip border, 2b - 1
  double creep;            ///< xi*
};

/// Solve for 0 < traction < friction; throws std::invalid_argument otherwise.
Carter carter(double friction, double traction);

/// Isothermal pressure p*(s), @eq:hertz; zero outside [-1, 1]. Dimensionless (per P/a).
double hertz_pressure(double s);

/// Traction q*(s), @eq:carter-traction; zero outside [-1, 1]. Dimensionless (per P/a).
double carter_traction(const Carter& c, double s);

/// Slip velocity v*(s) for s <= 1, @eq:carter-slip; zero in the stick zone.
double carter_slip(const Carter& c, double s);

/// The heat flux v* p*, @eq:carter-heat.
HeatFlux carter_flux(const Carter& c);

/// The integral of v* p* over the contact, @eq:energy.
double carter_heat(const Carter& c);

/// Traction at a given creep xi* >= 0, finite, @eq:creep-curve; throws std::invalid_argument.
double carter_creep_curve(double friction, double creep);

}  // namespace thermoroll
