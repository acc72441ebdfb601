// Tangled from paper/13-border-and-error.md; edit there.
#pragma once

#include <Eigen/Core>

namespace thermoroll {

/// What is known of a solved scene; dimensionless.
enum class Quantity {
  stick_slip_border,   ///< c0
  slip_length,         ///< 1 - c0, to its own digits
  traction,            ///< Q*
  creep_constant,      ///< C of @eq:stick-conditions, xi* + f gamma0
  creep,               ///< xi*, @eq:true-creep
  load_ratio,          ///< kappa = P_H / P, @eq:kappa
  gamma0,              ///< gamma0 of @eq:pressure-conditions
  heat_integral,       ///< the integral of v* p*
  max_temperature,     ///< the largest T* on the surface
  max_temperature_at,  ///< s there
  eccentricity         ///< pi gamma0 / (2 kappa), of the contact's centre from the axis
};

/// The results of a scene, or their errors, by Quantity. In operator[] they are in its order.
class Results : public Eigen::Array<double, 11, 1> {
 public:
  using Array::Array;
  double operator()(Quantity q) const { return coeff(static_cast<Eigen::Index>(q)); }
  double& operator()(Quantity q) { return coeffRef(static_cast<Eigen::Index>(q)); }
};

/// How many of them, from the first on, a tolerance is for.
inline constexpr int compared = static_cast<int>(Quantity::max_temperature_at);

/// A quantity that is reported, its key in JSON and CSV, and its symbol.
struct Reported {
  Quantity quantity;
  const char *key, *symbol;
};

inline constexpr Reported reported[] = {{Quantity::traction, "traction", "Q*"},
                                        {Quantity::stick_slip_border, "stick_slip_border", "c0"},
                                        {Quantity::creep_constant, "creep_constant", "C"},
                                        {Quantity::creep, "creep", "xi*"},
                                        {Quantity::load_ratio, "load_ratio", "kappa"},
                                        {Quantity::gamma0, "gamma0", "gamma0"},
                                        {Quantity::eccentricity, "eccentricity", ""},
                                        {Quantity::heat_integral, "heat_integral", "int v*p*"},
                                        {Quantity::max_temperature, "max_temperature", "T*max"},
                                        {Quantity::max_temperature_at, "max_temperature_at", "s"}};

}  // namespace thermoroll
