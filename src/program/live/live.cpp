// Tangled from paper/J-live-page.md; edit there.
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <typeinfo>

#include <Eigen/Core>

#include "solver/curves.hpp"
#include "solver/full_slip.hpp"
#include "solver/grid_solution.hpp"
#include "solver/least_model.hpp"
#include "solver/surface.hpp"
#include "support/number_text.hpp"
#include "thermoroll/coupled.hpp"

using namespace thermoroll;
using enum Quantity;
using Eigen::ArrayXd;
using Eigen::Index;

extern "C" {

[[noreturn, clang::import_module("page"), clang::import_name("refuse")]] void refuse(
    const char* why);

void* __cxa_allocate_exception(std::size_t size) { return std::malloc(size); }

/// Everything that is thrown has std::exception as its first base.
[[noreturn]] void __cxa_throw(void* thrown, std::type_info*, void (*)(void*)) {
  refuse(static_cast<const std::exception*>(thrown)->what());
}
}

namespace thermoroll {

static std::string text(const char* format, int digits, double value) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, format, digits, value);
  return buffer;
}

std::string shortest(double value) { return text("%.*g", 15, value); }
std::string rounded(double value, int digits) { return text("%.*g", digits, value); }
double number_of(const std::string& text) { return std::strtod(text.c_str(), nullptr); }
std::string with_exponent(double value, int digits) { return text("%.*e", digits - 1, value); }
std::string fixed(double value, int decimals) { return text("%.*f", decimals, value); }
std::string scientific(double value, int digits) { return text("%.*e", digits, value); }

}  // namespace thermoroll

namespace {

/// A scene and the prescribed quantity as the page writes them; Direction, LawKind, Quantity and
/// Method by their numbers. A law below 0 is constant friction.
struct Question {
  double friction, peclet, heating, conductivity_ratio, heating_2, direction;
  double law, law_temperature, law_floor, quantity, value, tolerance, method;
};

/// The answer to it; with a law and a prescribed traction, also the largest traction and its creep.
struct Answer {
  double model, unknowns, inadmissible, largest_traction, its_creep;
  double value[11], error[11];  // by Quantity
};

Question question;
Answer answer;
Choice last;
constexpr int points = 60;  // of each part of a curve
double curve[10 * points];

Scene scene_of(const Question& q) {
  Scene scene{q.friction, q.peclet, q.heating, {q.conductivity_ratio, q.heating_2}};
  scene.direction = static_cast<Direction>(q.direction);
  if (q.law >= 0)
    scene.law = LawOfFriction{static_cast<LawKind>(q.law), {q.law_temperature, q.law_floor}};
  return scene;
}

Choice solution_of(const Question& q) {
  const Approach by{Formulation::corrected, q.tolerance, static_cast<Method>(q.method)};
  check_method(scene_of(q), by.method);
  return solve_by_method(scene_of(q), by, {static_cast<Quantity>(q.quantity), q.value});
}

}  // namespace

extern "C" {

Question* thermoroll_question() { return &question; }
Answer* thermoroll_answer() { return &answer; }
double* thermoroll_curve() { return curve; }
const char* thermoroll_reason() { return last.reason.c_str(); }

void thermoroll_solve() {
  last = solution_of(question);
  const CoupledSolution& x = last.solution;
  answer.model = static_cast<double>(last.model);
  answer.unknowns = x.unknowns;
  answer.inadmissible = x.violations.empty() ? 0 : 1;
  answer.largest_traction = x.limit ? x.limit->traction : std::nan("");
  answer.its_creep = x.limit ? x.limit->creep : std::nan("");
  for (int i = 0; i < 11; ++i) answer.value[i] = x.value[i];
  for (int i = 0; i < 11; ++i) answer.error[i] = x.error[i];
  const auto given = static_cast<std::size_t>(question.quantity);
  answer.value[given] = question.value;
  answer.error[given] = 0;
}

int thermoroll_contact() {
  const CoupledSolution& x = last.solution;
  const SmoothTractions by = smooth_tractions(x, x.unknowns);
  const ArrayXd places = -ArrayXd::LinSpaced(points, 0.01, pi - 0.01).cos();
  const Curves y = curves_at(places, by, x.scene.friction);
  double* to = curve;
  const auto row = [&](double s, double p, double bound, double q, double v) {
    for (const double number : {s, p, bound, q, v}) *to++ = number;
  };
  for (Index i = points - 1; by.stick > 0 && i >= 0; --i)
    row(y.stick_at(i), y.stick_pressure(i), y.stick_bound(i), y.stick_traction(i), 0);
  for (Index i = 0; i < points; ++i)
    row(y.slip_at(i), y.slip_pressure(i), y.slip_traction(i), y.slip_traction(i), y.slip(i));
  return static_cast<int>(to - curve);
}

int thermoroll_temperature() {
  const CoupledSolution& x = last.solution;
  const SmoothFlux flux = smooth_flux(x);
  const ArrayXd inside = (1 - ArrayXd::LinSpaced(points, 0, pi).cos()) / 2;
  ArrayXd s(2 * points);
  s << -1.4, ArrayXd::LinSpaced(9, -1.2, 1 - flux.slip - 1e-3), 1 - flux.slip + flux.slip * inside,
      1 + 2 * ArrayXd::LinSpaced(points - 10, 0.01, 1).square();
  const SurfaceCurve t = surface_curve(flux, Conduction(x.scene), s, 1e-6);
  for (Index i = 0; i < s.size(); ++i) {
    curve[2 * i] = s(i);
    curve[2 * i + 1] = heat_share(x.scene) * t.temperature(i);
  }
  return static_cast<int>(2 * s.size());
}

int thermoroll_creep_curve() {
  const Scene scene = scene_of(question);
  constexpr auto formulation = Formulation::corrected;
  double* to = curve;
  const auto row = [&](const GridSolution& x) {
    for (const Quantity q : {creep, traction, max_temperature}) *to++ = x.value(q);
    return x.newton_steps > 0 && x.value(load_ratio) > 0;
  };
  GridSolution x;
  for (int i = 1; i < points; ++i) {
    const double share = static_cast<double>(i) / points, slip = 2 * share * share;
    x = solve_on_grid(scene, formulation, 20, {slip, 2 - slip}, x);
    if (!row(x)) return static_cast<int>(to - curve) - 3;
  }
  const double first = next_to_full_slip(scene, formulation, 20).value(creep);
  x = {};
  SlippingGrids grids{scene, formulation};
  for (int i = 0; i < points; ++i) {
    x = solve_slipping_grid(grids, 20, first * (1 + 2.0 * i / points), x);
    if (!row(x)) return static_cast<int>(to - curve) - 3;
  }
  return static_cast<int>(to - curve);
}

int thermoroll_wheel() {
  PhysicalScene wheel = wheel_on_rail();
  wheel.speed = 1;
  const Scene scene = scene_of(wheel, 1);
  const Units units = units_of(wheel, 1);
  int n = 0;
  const double hertz = 2 / pi * units.traction;
  const double size = 2 * (1 - wheel.poisson) * hertz / wheel.shear_modulus;
  for (const double x :
       {scene.peclet, scene.heating, units.temperature, wheel.half_width, hertz, size})
    curve[n++] = x;
  return n;
}
}
