// Tangled from paper/15-speed-and-accuracy.md, paper/17-least-model.md; edit there.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "thermoroll/kernels.hpp"
#include "thermoroll/scene.hpp"

namespace thermoroll {

/// A scene in which methods are compared; f = 0.6, Q* = 0.5, corrected sign.
struct Regime {
  const char* name;
  double peclet, heating;
  int most_nodes;  ///< of the published scheme, so that a run takes about a second at most
};
inline constexpr Regime regimes[] = {
    {"steel", 4360, 0.0175, 800}, {"slow", 100, 0.0175, 800}, {"hot", 100, 1, 400}};

/// What a method finds; NaN what it does not say, and everything where it does not settle.
struct Found {
  double load_ratio, hottest, creep;
  int unknowns = 0;  ///< of the coupled solver
};

/// A method at one of its settings.
struct Run {
  std::string method;           ///< "coupled"
  double setting;               ///< its number of nodes or its tolerance, 0 if it has none
  std::string name;             ///< "coupled/tol:1e-06/Pe:4360/H:0.0175"
  std::function<Found()> find;  ///< what is timed and judged
};

/// Every method at every setting that is compared in a regime.
std::vector<Run> runs(const Regime& regime);

/// The coupled solver at three tolerances over the Péclet number, with little heat and with much.
std::vector<std::pair<Scene, Run>> cost_runs();

/// A scene in either formulation.
struct Sample {
  Scene scene;
  double traction;
  Formulation formulation;
};

/// Scenes of the ranges of @tbl:random-scenes; always the same.
std::vector<Sample> random_scenes(int count);

/// The coupled solver in a regime on one grid of n unknowns; NaN where it finds no solution.
Found on_one_grid(const Regime& regime, int n);

/// The reference of all methods: the coupled solver at its least tolerance.
Found reference(const Regime& regime);

/// The relative error, 1e-11 at least, where the reference itself may err; NaN where the value is.
double error_of(double value, double exact);

/// The correct digits of kappa, T*max and xi* together; NaN where one of them is missing.
double right_digits(const Found& found, const Found& exact);

/// Errors of the coupled solver on Carter's problem with f = 0.3 and a stick zone of half-width 0.6
/// a: the force at Carter's creep and the creep at his force, relative; the traction at its worst
/// node, per f p0.
struct CarterErrors {
  int unknowns;
  double force, creep, traction;
};
CarterErrors carter_errors();

/// T*(s) of a unit flux on (-1, 1), @eq:jaeger; peclet > 0, |s| < 1.
double jaeger_band(double peclet, double s);

/// 2 sqrt(Pe) T*max per heat of a semi-elliptic band; it tends to Blok's factor as peclet grows.
double blok_factor(double peclet);

}  // namespace thermoroll
