#pragma once
#include "table.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace thermoroll_test {

constexpr double pi = 3.14159265358979323846;
constexpr double friction = 0.6;      ///< of every figure
constexpr int nodes = 200;            ///< of the published scheme
constexpr double heating = 0.0175;    ///< H, of the published scheme
constexpr double last_digit = 5e-10;  ///< relative, of numbers printed with ten digits
const std::vector<std::string> tractions{"0.2", "0.4", "0.5", "0.59"};
const std::vector<std::string> peclets{"100", "500", "1000", "5000"};

/// Points of a curve, x ascending.
struct Curve {
  std::vector<double> x, y;
};

/// build/data/NAME.csv
Table data(const std::string& name);

/// The rows whose columns have the texts given.
Curve curve(const Table& table, const std::vector<std::pair<std::string, std::string>>& where,
            const std::string& x, const std::string& y);

/// Linear interpolation; x within the curve.
double at(const Curve& c, double x);

double integral(const Curve& c);  ///< trapezium rule
double largest(const Curve& c);

/// The closed form, written here once more, apart from the program.
inline double half_width_of_stick(double traction) { return std::sqrt(1 - traction / friction); }
inline double border(double traction) { return 2 * half_width_of_stick(traction) - 1; }
inline double pressure(double s) { return s * s < 1 ? 2 / pi * std::sqrt(1 - s * s) : 0; }
inline double slip(double traction, double s) {
  const double square = (1 + s) * (s - border(traction));
  return s > border(traction) ? 2 * friction / pi * std::sqrt(square) : 0;
}
inline double creep(double traction) {
  return 2 * friction / pi * (1 - half_width_of_stick(traction));
}
/// Total heat, the integral of v* p*: by the energy identity, creep times traction per friction.
inline double heat(double traction) { return creep(traction) * traction / friction; }

}  // namespace thermoroll_test
