// The functions of thermoroll.h against the C++ library that they stand for, and their refusals.
#include <thermoroll.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <new>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "thermoroll/thermoroll.hpp"

// Allocations until memory runs out; never, if it is negative.
std::atomic<long> allocations_left{-1};

// Those of Eigen and GSL, too, unless a sanitizer has a malloc() of its own.
#ifdef __SANITIZE_ADDRESS__
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const found = allocations_left == 0 ? nullptr : std::malloc(size + 1);
  if (found == nullptr) throw std::bad_alloc();
  if (allocations_left > 0) --allocations_left;
  return found;
}
[[gnu::noinline]] void operator delete(void* block) noexcept { std::free(block); }
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept { std::free(block); }
#else
extern "C" {
void* __libc_malloc(std::size_t size);
void* malloc(std::size_t size) noexcept {
  if (allocations_left == 0) return nullptr;
  if (allocations_left > 0) --allocations_left;
  return __libc_malloc(size);
}
}
#endif

namespace {

using thermoroll::Direction;
using thermoroll::Formulation;
using thermoroll::LawKind;
using thermoroll::LawOfFriction;
using thermoroll::Method;
using thermoroll::Prescribed;
using thermoroll::Quantity;
using thermoroll::Scene;
using thermoroll::Solution;

constexpr double infinity = std::numeric_limits<double>::infinity();

thermoroll_scene steel() {
  thermoroll_scene x;
  thermoroll_scene_init(&x, sizeof x);
  x.given = 0.5;
  x.friction = 0.6;
  x.peclet = 4360;
  x.heating = 0.0175;
  return x;
}

thermoroll_scene hot() {
  thermoroll_scene x = steel();
  x.peclet = 100;
  x.given = 0.3;
  x.friction_law = THERMOROLL_LINEAR;
  x.friction_temperature = 0.02;
  return x;
}

thermoroll_scene conducting() {
  thermoroll_scene x = steel();
  x.roller = THERMOROLL_CONDUCTING;
  x.conductivity_ratio = 4;
  x.heating_2 = 0.05;
  return x;
}

thermoroll_scene scheme() {
  thermoroll_scene x = steel();
  x.method = THERMOROLL_GAUSS_CHEBYSHEV;
  x.formulation = THERMOROLL_PRINTED;
  x.nodes = 40;
  return x;
}

std::vector<thermoroll_result> solved(const std::vector<thermoroll_scene>& scenes,
                                      int threads = 1) {
  std::vector<thermoroll_result> results(scenes.size());
  results[0].size = sizeof results[0];
  const int status = thermoroll_solve(scenes.data(), results.data(), scenes.size(), threads);
  const bool all = std::all_of(results.begin(), results.end(),
                               [](const thermoroll_result& x) { return x.status == 0; });
  EXPECT_EQ(status, all ? THERMOROLL_DONE : THERMOROLL_ROWS_FAILED);
  return results;
}

thermoroll_result answer(const thermoroll_scene& scene) { return solved({scene})[0]; }

template <class Numbers>
std::vector<double> numbers(const Numbers& of) {
  std::vector<double> all(sizeof of / sizeof(double));
  std::memcpy(all.data(), &of, sizeof of);
  return all;
}

template <class Numbers>
void expect_nan(const Numbers& values) {
  for (const double x : numbers(values)) EXPECT_TRUE(std::isnan(x)) << x;
}

// Scenes of all kinds, and what they are in C++.
struct Pair {
  thermoroll_scene c;
  Scene scene;
  Prescribed given;
  thermoroll::Approach approach{};
};

std::vector<Pair> pairs() {
  const Scene plain{0.6, 4360, 0.0175};
  Scene alike = plain, other = plain, soft{0.6, 100, 0.0175}, brakes = plain, warm = plain;
  alike.roller = {1, 0.0175};
  other.roller = {4, 0.05, 760};
  warm.roller = {1, 0.0175};
  warm.bulk_difference = 0.001;
  soft.law = LawOfFriction{LawKind::linear, {0.02}};
  brakes.direction = Direction::braking;
  std::vector<Pair> all;
  all.push_back({steel(), plain, {Quantity::traction, 0.5}});
  all.push_back({steel(), alike, {Quantity::creep, -0.1}, {Formulation::corrected, 1e-3}});
  all.back().c.roller = THERMOROLL_IDENTICAL;
  all.back().c.quantity = THERMOROLL_CREEP;
  all.back().c.given = -0.1;
  all.back().c.tolerance = 1e-3;
  all.push_back({conducting(), other, {Quantity::traction, 0.5}});
  all.back().c.peclet_2 = 760;
  all.push_back({steel(), warm, {Quantity::traction, 0.5}});
  all.back().c.roller = THERMOROLL_IDENTICAL;
  all.back().c.bulk_difference = 0.001;
  all.push_back({hot(), soft, {Quantity::traction, 0.3}});
  all.push_back({hot(), soft, {Quantity::traction, 0.3, thermoroll::Branch::falling}});
  all.back().c.branch = THERMOROLL_FALLING;
  all.push_back({steel(), brakes, {Quantity::stick_slip_border, 0.2}});
  all.back().c.quantity = THERMOROLL_STICK_SLIP_BORDER;
  all.back().c.given = 0.2;
  all.back().c.direction = THERMOROLL_BRAKING;
  all.push_back({scheme(),
                 plain,
                 {Quantity::traction, 0.5},
                 {Formulation::printed, 1e-6, Method::gauss_chebyshev, 40}});
  return all;
}

// The bytes of members are the binary interface: they may be appended to and never moved.
TEST(Interface, StructuresAreFixed) {
  EXPECT_EQ(sizeof(thermoroll_scene), 248U);
  EXPECT_EQ(offsetof(thermoroll_scene, load), 136U);
  EXPECT_EQ(offsetof(thermoroll_scene, bulk_temperature_2), 240U);
  EXPECT_EQ(offsetof(thermoroll_scene, given), 8U);
  EXPECT_EQ(offsetof(thermoroll_scene, conductivity_ratio), 48U);
  EXPECT_EQ(offsetof(thermoroll_scene, friction_temperature), 88U);
  EXPECT_EQ(offsetof(thermoroll_scene, tolerance), 120U);
  EXPECT_EQ(sizeof(thermoroll_values), 15 * sizeof(double));
  EXPECT_EQ(offsetof(thermoroll_values, max_temperature), 64U);
  EXPECT_EQ(sizeof(thermoroll_physical), 15 * sizeof(double));
  EXPECT_EQ(sizeof(thermoroll_result), 1048U);
  EXPECT_EQ(offsetof(thermoroll_result, unit), 512U);
  EXPECT_EQ(offsetof(thermoroll_result, notes), 792U);
  EXPECT_EQ(sizeof(thermoroll_point), 128U);
  EXPECT_EQ(offsetof(thermoroll_point, depth), 72U);
  EXPECT_EQ(offsetof(thermoroll_result, value), 16U);
  EXPECT_EQ(offsetof(thermoroll_result, error), 136U);
  EXPECT_EQ(offsetof(thermoroll_result, message), 256U);
  EXPECT_EQ(sizeof(thermoroll_law_info), 280U);
  EXPECT_EQ(offsetof(thermoroll_law_info, message), 24U);
  EXPECT_EQ(sizeof(thermoroll_law_value), 64U);
  EXPECT_EQ(offsetof(thermoroll_law_value, traction), 8U);
  EXPECT_EQ(THERMOROLL_TANGENTIAL_LOAD, 4);
  EXPECT_EQ(THERMOROLL_PIECEWISE_LINEAR, 4);
  EXPECT_EQ(THERMOROLL_GAUSS_CHEBYSHEV, 4);
  EXPECT_EQ(THERMOROLL_MODEL_COUPLED, 2);
}

void expect_same(const thermoroll::Results& expected, const thermoroll_values& found) {
  for (int k = 0; k < expected.size(); ++k)
    EXPECT_EQ(expected[k], numbers(found)[static_cast<std::size_t>(k)]) << "result " << k;
}

TEST(Interface, SameAsTheLibrary) {
  for (const Pair& pair : pairs()) {
    const Solution x = thermoroll::solve(pair.scene, pair.given, pair.approach);
    const thermoroll_result found = answer(pair.c);
    ASSERT_EQ(found.status, 0) << found.message;
    EXPECT_EQ(found.size, sizeof found);
    expect_same(x.value, found.value);
    if (x.error)
      expect_same(*x.error, found.error);
    else
      expect_nan(found.error);
    EXPECT_EQ(found.model, x.model ? static_cast<int>(*x.model) : THERMOROLL_NO_MODEL);
    EXPECT_EQ(found.message, x.reason);
    const auto* coupled = std::get_if<thermoroll::CoupledSolution>(&x.found);
    EXPECT_EQ(found.unknowns, x.model == thermoroll::Model::coupled ? coupled->unknowns : 0);
  }
}

// The heat into both bodies is the whole, to the rounding of a product and a sum.
TEST(Interface, HeatIsShared) {
  for (const Pair& pair : pairs()) {
    const thermoroll_result x = answer(pair.c);
    const double heat = x.value.heat_integral;
    EXPECT_NEAR(x.value.heat_1 + x.value.heat_2, heat, 1e-15 * heat);
    EXPECT_EQ(x.value.heat_2 == 0, pair.scene.roller.conductivity_ratio == 0);
  }
  EXPECT_EQ(answer(pairs()[1].c).value.heat_1, answer(pairs()[1].c).value.heat_2);
  const thermoroll_result crossing =
      answer(pairs()[3].c);  // the warmer roller keeps less than half
  EXPECT_GT(crossing.value.heat_1, 0.55 * crossing.value.heat_integral);
  EXPECT_GE(crossing.error.heat_1, crossing.error.heat_integral);
}

TEST(Interface, LargestTractionIsTold) {
  thermoroll_scene scene = hot();
  const thermoroll_result driving = answer(scene);
  EXPECT_GT(driving.value.traction_limit, 0.3);
  EXPECT_GT(driving.value.creep_at_traction_limit, driving.value.creep);
  scene.given = -0.3;
  const thermoroll_result braking = answer(scene);
  EXPECT_LT(braking.value.traction_limit, -0.3);
  EXPECT_LT(braking.value.creep_at_traction_limit, braking.value.creep);
  EXPECT_GT(braking.error.traction_limit, 0);
  EXPECT_GT(braking.error.creep_at_traction_limit, 0);
  EXPECT_TRUE(std::isnan(answer(steel()).value.traction_limit));
}

TEST(Interface, FailedRowsAreNaN) {
  thermoroll_scene refused = steel(), unresolved = steel(), diverges = scheme(), lifts = scheme();
  refused.friction = -1;
  unresolved.heating = 1e6;
  unresolved.peclet = 100;
  diverges.heating = 30;
  lifts.heating = 30;
  lifts.peclet = 1000;
  lifts.nodes = 200;
  const auto rows = solved({steel(), refused, unresolved, diverges, lifts, steel()}, 2);
  EXPECT_EQ(rows[1].status, THERMOROLL_REFUSED);
  EXPECT_STREQ(rows[1].message, "friction = -1 is not allowed: it must be positive");
  EXPECT_EQ(rows[2].status, THERMOROLL_FAILED) << rows[2].message;
  EXPECT_EQ(rows[3].status, THERMOROLL_NOT_CONVERGED) << rows[3].message;
  EXPECT_EQ(rows[4].status, THERMOROLL_NO_CONTACT) << rows[4].message;
  for (std::size_t k = 1; k < 5; ++k) {
    expect_nan(rows[k].value);
    expect_nan(rows[k].error);
    expect_nan(rows[k].physical);
    expect_nan(rows[k].physical_error);
    expect_nan(rows[k].unit);
    EXPECT_STREQ(rows[k].notes, "");
    EXPECT_EQ(rows[k].model, THERMOROLL_NO_MODEL);
    EXPECT_EQ(rows[k].unknowns, 0);
    EXPECT_GT(std::strlen(rows[k].message), 10U);
  }
  EXPECT_EQ(std::memcmp(&rows[0], &rows[5], sizeof rows[0]), 0);
}

// The longest refusal of a dimensionless scene is told to its end.
TEST(Interface, MessagesAreWhole) {
  thermoroll_scene scene = hot();
  scene.method = THERMOROLL_CLOSED_FORM;
  const std::string message = answer(scene).message;
  EXPECT_EQ(message.substr(message.find_last_of(' ')), " auto");
  for (int status = 0; status <= 5; ++status)
    EXPECT_STRNE(thermoroll_message(status), thermoroll_message(6));
  EXPECT_STREQ(thermoroll_message(-1), thermoroll_message(6));
  EXPECT_STREQ(thermoroll_message(0), "done");
}

template <class Row>
bool same_bytes(const std::vector<Row>& x, const std::vector<Row>& y) {
  if (x.size() != y.size()) return false;
  return x.empty() || std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0;
}

// A few hundred scenes of very different cost, by any number of threads and by two callers at once.
TEST(Interface, AnyNumberOfThreads) {
  std::vector<thermoroll_scene> scenes;
  for (int k = 0; k < 60; ++k) {
    scenes.push_back(steel());
    scenes.back().given = 0.01 * k - 0.3;
    scenes.back().heating = k % 3 == 0 ? 1.0 : 1e-5;
    scenes.back().friction = k % 10 == 9 ? -1 : 0.6;
  }
  std::vector<thermoroll_result> by_other;
  std::thread other([&] { by_other = solved(scenes, 2); });
  const auto beside = solved(scenes, 2);  // what is computed at its first use, all compute at once
  other.join();
  const auto alone = solved(scenes, 1);
  EXPECT_TRUE(same_bytes(by_other, alone) && same_bytes(beside, alone));
  for (const int threads : {0, 2, 7, 1000})
    EXPECT_TRUE(same_bytes(solved(scenes, threads), alone)) << threads;
}

TEST(Interface, RefusesOtherStructures) {
  const thermoroll_scene scene = steel();
  thermoroll_scene longer = scene;
  longer.size += 8;
  thermoroll_result result{};
  result.size = sizeof result;
  result.status = 77;
  thermoroll_result shorter = result;
  shorter.size -= 8;
  EXPECT_EQ(thermoroll_solve(nullptr, &result, 1, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(thermoroll_solve(&scene, nullptr, 1, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(thermoroll_solve(&longer, &result, 1, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(thermoroll_solve(&scene, &shorter, 1, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(thermoroll_solve(&scene, &result, 1, -1), THERMOROLL_REFUSED);
  EXPECT_EQ(result.status, 77);
  EXPECT_EQ(shorter.status, 77);
  EXPECT_EQ(thermoroll_solve(nullptr, nullptr, 0, 1), THERMOROLL_DONE);
  EXPECT_EQ(thermoroll_solve(&scene, &result, 1, 1), THERMOROLL_DONE);
}

TEST(Interface, DefaultsAreThoseOfTheLibrary) {
  const thermoroll_scene x = steel();
  const thermoroll::Approach approach;
  EXPECT_EQ(x.size, sizeof x);
  EXPECT_EQ(x.tolerance, approach.tolerance);
  EXPECT_EQ(x.nodes, approach.nodes);
  EXPECT_EQ(x.formulation, static_cast<int>(approach.formulation));
  EXPECT_EQ(x.method, static_cast<int>(approach.method));
  EXPECT_EQ(x.quantity, THERMOROLL_TRACTION);
  thermoroll_scene whole = x;
  whole.tolerance = 0.25;
  thermoroll_scene_init(&whole, offsetof(thermoroll_scene, tolerance));  // an older caller's
  EXPECT_EQ(whole.size, offsetof(thermoroll_scene, tolerance));
  EXPECT_EQ(whole.friction, 0);
  EXPECT_EQ(whole.tolerance, 0.25);
  thermoroll_scene_init(nullptr, sizeof x);
  EXPECT_STREQ(thermoroll_version(), "0.2.0");
}

// Each member has an effect on a scene that uses it: another answer, or a refusal that names it.
template <class Number>
void expect_effect(const thermoroll_scene& scene, Number thermoroll_scene::*member,
                   std::type_identity_t<Number> other, const char* refusal = "") {
  const thermoroll_result before = answer(scene);
  ASSERT_EQ(before.status, 0) << before.message;
  thermoroll_scene changed = scene;
  changed.*member = other;
  const thermoroll_result after = answer(changed);
  if (*refusal != 0) {
    EXPECT_EQ(after.status, THERMOROLL_REFUSED) << refusal;
    EXPECT_NE(std::string(after.message).find(refusal), std::string::npos) << after.message;
    return;
  }
  EXPECT_EQ(after.status, 0) << after.message;
  EXPECT_NE(std::memcmp(&before, &after, sizeof before), 0);
}

TEST(Interface, EveryMemberIsRead) {
  using S = thermoroll_scene;
  expect_effect(steel(), &S::quantity, THERMOROLL_CREEP);
  expect_effect(steel(), &S::given, 0.4);
  expect_effect(steel(), &S::friction, 0.7);
  expect_effect(steel(), &S::peclet, 4000);
  expect_effect(steel(), &S::heating, 0.02);
  expect_effect(steel(), &S::roller, THERMOROLL_IDENTICAL);
  expect_effect(conducting(), &S::conductivity_ratio, 3);
  expect_effect(conducting(), &S::heating_2, 0.04);
  expect_effect(conducting(), &S::peclet_2, 5000);
  expect_effect(conducting(), &S::bulk_difference, 0.0001);
  expect_effect(hot(), &S::friction_law, THERMOROLL_RATIONAL);
  expect_effect(hot(), &S::branch, THERMOROLL_FALLING);
  expect_effect(hot(), &S::friction_temperature, 0.03);
  S decaying = hot();
  decaying.friction_law = THERMOROLL_EXPONENTIAL;
  expect_effect(decaying, &S::friction_floor, 0.8);
  expect_effect(decaying, &S::friction_reference_temperature, -0.001);
  expect_effect(steel(), &S::method, THERMOROLL_CLOSED_FORM);
  expect_effect(steel(), &S::formulation, THERMOROLL_PRINTED);
  expect_effect(steel(), &S::tolerance, 1e-9);
  expect_effect(scheme(), &S::nodes, 60);
  S border = steel();
  border.quantity = THERMOROLL_STICK_SLIP_BORDER;
  border.given = 0.2;
  expect_effect(border, &S::direction, THERMOROLL_BRAKING);
}

TEST(Interface, RefusesWhatHasNoEffect) {
  using S = thermoroll_scene;
  const char* roller = "for a conducting roller only";
  const char* law = "for friction that depends on temperature";
  expect_effect(steel(), &S::conductivity_ratio, 1, roller);
  expect_effect(steel(), &S::heating_2, 1, roller);
  expect_effect(steel(), &S::peclet_2, 1, roller);
  expect_effect(steel(), &S::friction_temperature, 1, law);
  expect_effect(steel(), &S::friction_floor, 1, law);
  expect_effect(steel(), &S::friction_reference_temperature, 1, law);
  expect_effect(steel(), &S::direction, THERMOROLL_BRAKING, "contradicts");
  expect_effect(steel(), &S::branch, THERMOROLL_FALLING, "branch");
  expect_effect(steel(), &S::places, 1,
                "places = 1 is not allowed: it must be 0, or 1 in a profile");
  expect_effect(conducting(), &S::conductivity_ratio, 0, "conductivity_ratio = 0");
  S creep = hot();
  creep.quantity = THERMOROLL_CREEP;
  expect_effect(creep, &S::branch, THERMOROLL_FALLING, "branch = falling is for a given traction");
  S warmer = conducting();
  warmer.bulk_difference = 1e-6;
  for (const double given : {0.1, -0.1}) {
    warmer.given = given;
    expect_effect(warmer, &S::direction, THERMOROLL_BRAKING, given > 0 ? "drives" : "bulk");
  }
}

// The wheel of the recipes: at a creep of one per cent, its friction falls as it warms up.
thermoroll_scene wheel() {
  thermoroll_scene x;
  thermoroll_scene_init(&x, sizeof x);
  x.quantity = THERMOROLL_CREEP_RATIO;
  x.given = 0.01;
  x.friction = 0.35;
  x.roller = THERMOROLL_IDENTICAL;
  x.friction_law = THERMOROLL_EXPONENTIAL;
  x.friction_temperature = 400;
  x.friction_floor = 0.4;
  x.load = 1.2e7;
  x.speed = 40;
  x.half_width = 7.8e-3;
  x.shear_modulus = 8.1e10;
  x.poisson = 0.3;
  x.expansion = 1.1e-5;
  x.diffusivity = 1.4e-5;
  x.conductivity = 50;
  x.bulk_temperature = 20;
  return x;
}

thermoroll_scene wheel_of_two_metals() {
  thermoroll_scene x = wheel();
  x.roller = THERMOROLL_CONDUCTING;
  x.expansion_2 = 1.6e-5;
  x.conductivity_2 = 20;
  x.diffusivity_2 = 5e-6;
  return x;
}

// The same scenes in C++. The structures' members have the order of PhysicalResults.
struct SiPair {
  thermoroll_scene c;
  thermoroll::GivenScene cpp;
};

std::vector<SiPair> si_pairs() {
  using thermoroll::CreepUnit;
  thermoroll::PhysicalScene si{1.2e7, 40, 7.8e-3, 8.1e10, 0.3, 1.1e-5, 1.4e-5, 50};
  std::vector<SiPair> all;
  thermoroll_scene c = wheel();  // an insulated roller, constant friction and an unknown bulk
  c.roller = THERMOROLL_INSULATED;
  c.friction_law = THERMOROLL_CONSTANT;
  c.friction_temperature = c.friction_floor = 0;
  c.bulk_temperature = std::nan("");
  c.quantity = THERMOROLL_TRACTION;
  c.given = -0.2;
  all.push_back({c, {{0.35, 0, 0}, {Quantity::traction, -0.2}, {}, si, {}}});
  c.quantity = THERMOROLL_TANGENTIAL_LOAD;
  c.given = 3e6;
  c.half_width = 0;
  c.radius = 0.46;
  si.half_width = 0;
  all.push_back({c, {{0.35, 0, 0}, {Quantity::traction, 0.25}, {}, si, 0.46}});
  si = {1.2e7, 40, 7.8e-3, 8.1e10, 0.3, 1.1e-5, 1.4e-5, 50, 1.1e-5, 50, 1.4e-5};
  si.bulk_temperature = 20;
  si.law = LawOfFriction{LawKind::exponential, {400, 0.4}};
  const Prescribed ratio{Quantity::creep, 0.01};
  all.push_back({wheel(), {{0.35, 0, 0}, ratio, {}, si, {}, CreepUnit::ratio}});
  si.expansion_2 = 1.6e-5;
  si.conductivity_2 = 20;
  si.diffusivity_2 = 5e-6;
  si.law->of.reference = 30;
  c = wheel_of_two_metals();
  c.friction_reference_temperature = 30;
  c.tolerance = 1e-3;  // as the law has a kink
  const thermoroll::Approach rough{Formulation::corrected, 1e-3};
  all.push_back({c, {{0.35, 0, 0}, ratio, rough, si, {}, CreepUnit::ratio}});
  return all;
}

void expect_same(const thermoroll::PhysicalResults& expected, const thermoroll_physical& found) {
  EXPECT_EQ(std::memcmp(&expected, &found, sizeof expected), 0);
}

TEST(Interface, SiScenesAreThoseOfTheLibrary) {
  for (const auto& [c, cpp] : si_pairs()) {
    const thermoroll::SolvedScene x = thermoroll::solve_scene(cpp);
    const thermoroll_result found = answer(c);
    ASSERT_EQ(found.status, 0) << found.message;
    expect_same(x.solution.value, found.value);
    expect_same(x.physical->value, found.physical);
    expect_same(*x.physical->error, found.physical_error);
    EXPECT_EQ(found.physical.heat_1, x.physical->heat_1.value);
    EXPECT_EQ(found.physical.heat_2, x.physical->heat_2.value);
    EXPECT_EQ(found.physical_error.heat_1, x.physical->heat_1.error);
    EXPECT_EQ(found.physical_error.heat_2, x.physical->heat_2.error);
    EXPECT_EQ(numbers(found.unit),
              (std::vector<double>{x.units->length, x.units->traction, x.units->slip,
                                   x.units->heat_flux, x.units->temperature}));
    const double bulk = c.bulk_temperature, rise = found.physical.max_temperature_celsius;
    if (std::isnan(bulk)) {
      EXPECT_TRUE(std::isnan(found.physical.contact_temperature_celsius));
      EXPECT_TRUE(std::isnan(found.physical_error.contact_temperature_celsius));
    } else {
      EXPECT_EQ(found.physical.contact_temperature_celsius, bulk + rise);
      EXPECT_EQ(found.physical_error.contact_temperature_celsius,
                found.physical_error.max_temperature_celsius);
    }
    EXPECT_STREQ(found.notes, "");
  }
  expect_nan(answer(steel()).physical);
  expect_nan(answer(steel()).unit);
}

// Seven notes are more than fit: no note is cut.
TEST(Interface, NotesThatDoNotFitAreLeftOut) {
  thermoroll_scene x = wheel();
  x.friction_law = THERMOROLL_CONSTANT;
  x.friction_temperature = x.friction_floor = 0;
  x.friction = 3;
  x.half_width = 7.8;
  x.quantity = THERMOROLL_TRACTION;
  x.given = 2;
  x.load = 1.2e8;
  x.shear_modulus = 8.1e5;
  x.diffusivity = 1.4e5;
  x.conductivity = 50;
  x.method = THERMOROLL_CLOSED_FORM;
  const thermoroll_result found = answer(x);
  ASSERT_EQ(found.status, 0) << found.message;
  const std::string notes = found.notes, last = notes.substr(notes.rfind("; ") + 2);
  EXPECT_GT(notes.size(), 150U) << notes;
  EXPECT_NE(last.find(" is above "), std::string::npos) << notes;
  EXPECT_NE(std::string("0123456789").find(last.back()), std::string::npos) << notes;
}

// Memory that runs out at any allocation of a solved scene or a refused one ends nothing: it is
// told, or the scene is answered as ever. A solved one makes some thousand allocations, of which
// every third is tried.
TEST(Interface, LackOfMemoryIsTold) {
  for (const double traction : {0.3, 0.9}) {
    thermoroll_scene scene = hot();
    scene.quantity = THERMOROLL_TRACTION;
    scene.given = traction;
    const int status = answer(scene).status;
    int told = 0;
    thermoroll_result found{};
    for (long left = 0; left < 100000; left += 3) {
      found = {};
      found.size = sizeof found;
      allocations_left = left;
      thermoroll_solve(&scene, &found, 1, 1);
      allocations_left = -1;
      if (found.status == status) break;
      EXPECT_EQ(found.status, THERMOROLL_FAILED) << left;
      EXPECT_STREQ(found.message, "there is not enough memory");
      ++told;
    }
    EXPECT_EQ(found.status, status) << "with enough memory";
    EXPECT_GT(told, traction < 0.5 ? 50 : 5);
  }
}

// A modulus in GPa and a creep of a fifth: four notes fit, and each begins with its number.
TEST(Interface, NotesAreWhole) {
  thermoroll_scene x = wheel();
  x.shear_modulus = 2e9;
  x.given = 0.2;
  x.friction_law = THERMOROLL_CONSTANT;
  x.friction_temperature = x.friction_floor = 0;
  x.speed = 4000;
  const thermoroll_result found = answer(x);
  ASSERT_EQ(found.status, 0) << found.message;
  const std::string notes = found.notes;
  for (const char* name :
       {"half_width_over_radius = ", "; creep_ratio = 0.2 is above 0.1; ",
        "; hertz_pressure = 9.79e+08 is above 2e+08; ", "; contact_temperature_celsius = "})
    EXPECT_NE(notes.find(name), std::string::npos) << name << " is not in " << notes;
  EXPECT_EQ(notes.substr(notes.size() - 4), "1500");
}

TEST(Interface, NoteOfALengthInMillimetres) {
  thermoroll_scene by_width = wheel(), by_radius = wheel();
  by_width.half_width *= 1000;
  by_radius.radius = 460;
  by_radius.half_width = 0;
  for (const thermoroll_scene& scene : {by_width, by_radius}) {
    const thermoroll_result found = answer(scene);
    ASSERT_EQ(found.status, 0) << found.message;
    EXPECT_EQ(std::string(found.notes).find("half_width = "), 0U) << found.notes;
  }
  EXPECT_STREQ(answer(wheel()).notes, "");
}

TEST(Interface, EveryMemberInSiUnitsIsRead) {
  using S = thermoroll_scene;
  expect_effect(wheel(), &S::given, 0.02);
  expect_effect(wheel(), &S::friction, 0.3);
  for (double S::*member : {&S::load, &S::speed, &S::half_width, &S::shear_modulus, &S::poisson,
                            &S::expansion, &S::diffusivity, &S::conductivity})
    expect_effect(wheel(), member, 1.1 * (wheel().*member));
  for (double S::*member : {&S::expansion_2, &S::conductivity_2, &S::diffusivity_2})
    expect_effect(wheel_of_two_metals(), member, 1.1 * (wheel_of_two_metals().*member));
  expect_effect(wheel(), &S::friction_temperature, 300);
  expect_effect(wheel(), &S::friction_reference_temperature, 10);
  expect_effect(wheel(), &S::bulk_temperature, 30);
  S warm = wheel();
  warm.friction_law = THERMOROLL_CONSTANT;
  warm.friction_temperature = warm.friction_floor = 0;
  expect_effect(warm, &S::bulk_temperature_2, 30);
  S given = wheel();
  given.half_width = 0;
  given.radius = 0.46;
  expect_effect(given, &S::radius, 0.5);
  S same = wheel_of_two_metals(), zero = same;  // no diffusivity of its own
  same.diffusivity_2 = same.diffusivity;
  zero.diffusivity_2 = 0;
  const thermoroll_result a = answer(same), b = answer(zero);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST(Interface, RefusesBadSiData) {
  using S = thermoroll_scene;
  const char* kind = "are not for data in SI units";
  for (double S::*group : {&S::peclet, &S::heating, &S::conductivity_ratio, &S::heating_2,
                           &S::peclet_2, &S::bulk_difference})
    expect_effect(wheel(), group, 1, kind);
  for (double S::*data :
       {&S::speed, &S::half_width, &S::radius, &S::shear_modulus, &S::poisson, &S::expansion,
        &S::diffusivity, &S::conductivity, &S::expansion_2, &S::conductivity_2, &S::diffusivity_2,
        &S::bulk_temperature, &S::bulk_temperature_2})
    expect_effect(steel(), data, 1, "load = 0 is not allowed");
  for (double S::*data : {&S::expansion_2, &S::conductivity_2, &S::diffusivity_2})
    expect_effect(wheel(), data, 1, "for a conducting roller only");
  expect_effect(wheel(), &S::radius, 0.46, "either half_width or radius");
  expect_effect(wheel(), &S::half_width, 0, "either half_width or radius");
  expect_effect(wheel(), &S::shear_modulus, 0, "shear_modulus = 0 is not allowed");
  expect_effect(wheel(), &S::load, std::nan(""), "load = nan is not allowed");
  expect_effect(wheel_of_two_metals(), &S::conductivity_2, 0, "conductivity_2 = 0 is not allowed");
  expect_effect(wheel(), &S::direction, THERMOROLL_BRAKING, "contradicts");
  expect_effect(steel(), &S::quantity, THERMOROLL_CREEP_RATIO, "a creep ratio or a tangential");
  expect_effect(steel(), &S::quantity, THERMOROLL_TANGENTIAL_LOAD, "a creep ratio or a tangential");
  S cold = wheel();
  cold.bulk_temperature = std::nan("");
  expect_effect(cold, &S::bulk_temperature_2, 1, "bulk_temperature_2 needs bulk_temperature");
  S alone = wheel_of_two_metals();
  alone.roller = THERMOROLL_INSULATED;
  alone.expansion_2 = alone.conductivity_2 = alone.diffusivity_2 = 0;
  alone.bulk_temperature = 20;
  expect_effect(alone, &S::bulk_temperature_2, 50,
                "bulk_temperature_2 = 50 is not allowed: it must be 20, that of the half-space");
  S pulled = wheel();
  pulled.quantity = THERMOROLL_TANGENTIAL_LOAD;
  pulled.friction_law = THERMOROLL_CONSTANT;
  pulled.friction_temperature = pulled.friction_floor = 0;
  pulled.given = 3e6;
  expect_effect(pulled, &S::given, 6e6, "tangential_load = 6e+06: traction = 0.5 is not allowed");
  S spun = wheel();
  expect_effect(spun, &S::given, std::nan(""), "creep_ratio = nan: creep = nan");
}

std::vector<thermoroll_point> points_of(const thermoroll_scene& scene, std::size_t count,
                                        thermoroll_result& result) {
  std::vector<thermoroll_point> points(count);
  points[0].size = sizeof points[0];
  result = {};
  result.size = sizeof result;
  EXPECT_EQ(thermoroll_profile(&scene, &result, points.data(), count), result.status);
  return points;
}

TEST(Interface, ProfileIsThatOfTheLibrary) {
  thermoroll_scene brakes = conducting();
  brakes.given = -0.5;
  for (const thermoroll_scene& scene : {steel(), wheel(), brakes, wheel_of_two_metals()}) {
    thermoroll_result result;
    const std::vector<thermoroll_point> found = points_of(scene, 33, result);
    const thermoroll_result expected = answer(scene);
    ASSERT_EQ(result.status, 0) << result.message;
    EXPECT_EQ(std::memcmp(&result, &expected, sizeof result), 0);
    thermoroll::GivenScene cpp{{0.6, 4360, 0.0175}, {Quantity::traction, 0.5}, {}, {}, {}};
    if (scene.load != 0) cpp = si_pairs()[scene.roller == THERMOROLL_IDENTICAL ? 2 : 3].cpp;
    if (scene.load != 0) cpp.physical->law->of.reference = 0;
    cpp.approach = {};
    if (scene.given == -0.5) cpp.scene.roller = {4, 0.05};
    if (scene.given == -0.5) cpp.given.value = -0.5;
    const thermoroll::Profile x = thermoroll::profile(thermoroll::solve_scene(cpp).solution, 33);
    const bool insulated = scene.roller == THERMOROLL_INSULATED;
    for (Eigen::Index k = 0; k < 33; ++k) {
      const thermoroll_point& y = found[static_cast<std::size_t>(k)];
      EXPECT_EQ(y.size, sizeof y);
      EXPECT_EQ(y.status, 0);
      EXPECT_EQ(y.s, x.s(k));
      EXPECT_EQ(y.pressure, x.pressure(k));
      EXPECT_EQ(y.traction, x.traction(k));
      EXPECT_EQ(y.slip, x.slip(k));
      EXPECT_EQ(y.heat_flux, x.heat_flux(k));
      EXPECT_EQ(y.temperature, x.temperature(k));
      EXPECT_EQ(y.heat_flux_1, insulated ? x.heat_flux(k) : x.heat_flux_1(k));
      EXPECT_EQ(y.heat_flux_2, insulated ? 0 : x.heat_flux_2(k));
      EXPECT_EQ(y.friction, scene.friction_law == THERMOROLL_CONSTANT ? 0.6 : x.friction(k));
      EXPECT_EQ(y.pressure_error, x.error->pressure);
      EXPECT_EQ(y.traction_error, x.error->traction);
      EXPECT_EQ(y.slip_error, x.error->slip);
      EXPECT_EQ(y.heat_flux_error, x.error->heat_flux);
      EXPECT_EQ(y.temperature_error, x.error->temperature);
    }
  }
}

// A row behind the contact and two below it, of all kinds of scenes, by any order of depths.
TEST(Interface, TemperaturesAreThoseOfTheLibrary) {
  const std::vector<std::pair<double, double>> places{{-1, 0}, {0.3, 0},    {1.7, 0},   {1.7, 0.05},
                                                      {40, 1}, {0.3, 0.05}, {-2, 0.05}, {1.7, 0}};
  for (const Pair& pair : pairs()) {
    const bool scheme = pair.c.method == THERMOROLL_GAUSS_CHEBYSHEV;
    thermoroll_scene scene = pair.c;
    scene.places = THERMOROLL_AS_GIVEN;
    std::vector<thermoroll_point> points(places.size());
    points[0].size = sizeof points[0];
    for (std::size_t k = 0; k < places.size(); ++k) points[k].s = places[k].first;
    if (!scheme)
      for (std::size_t k = 0; k < places.size(); ++k) points[k].depth = places[k].second;
    thermoroll_result result{};
    result.size = sizeof result;
    ASSERT_EQ(thermoroll_profile(&scene, &result, points.data(), points.size()), 0)
        << result.message;
    const thermoroll_result expected = answer(pair.c);
    EXPECT_EQ(std::memcmp(&result, &expected, sizeof result), 0);
    const Solution x = thermoroll::solve(pair.scene, pair.given, pair.approach);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const thermoroll_point& y = points[k];
      const auto alone = thermoroll::temperature_curve(x, {y.s}, y.depth).points[0];
      EXPECT_EQ(y.size, sizeof y);
      EXPECT_EQ(y.status, 0);
      EXPECT_EQ(y.s, places[k].first);
      EXPECT_EQ(y.depth, scheme ? 0 : places[k].second);
      // One by one or together, they are within their errors.
      EXPECT_NEAR(y.temperature, alone.temperature, alone.error.value_or(0)) << k;
      EXPECT_EQ(std::isnan(y.temperature_error), scheme);
      EXPECT_TRUE(scheme || std::abs(y.temperature_error - *alone.error) <= 0.5 * *alone.error)
          << k;
      EXPECT_TRUE(std::isnan(y.pressure) && std::isnan(y.heat_flux_2) && std::isnan(y.friction));
    }
    EXPECT_EQ(points[2].temperature, points[7].temperature);
    const double above = points[1].temperature;  // far ahead of the heat it may be zero
    EXPECT_TRUE(scheme || points[5].temperature < above || above == 0);
  }
}

TEST(Interface, PlacesThatAreNot) {
  thermoroll_scene scene = steel();
  scene.places = THERMOROLL_AS_GIVEN;
  const auto told = [&](const thermoroll_scene& of, double s, double depth) {
    thermoroll_point points[2]{};
    points[0].size = sizeof points[0];
    points[1].s = s;
    points[1].depth = depth;
    thermoroll_result result{};
    result.size = sizeof result;
    EXPECT_EQ(thermoroll_profile(&of, &result, points, 2), THERMOROLL_REFUSED);
    EXPECT_TRUE(std::isnan(points[0].temperature) && std::isnan(points[1].temperature));
    EXPECT_EQ(points[1].status, THERMOROLL_REFUSED);
    EXPECT_EQ(std::memcmp(&points[1].s, &s, sizeof s), 0);
    expect_nan(result.value);
    return std::string(result.message);
  };
  EXPECT_EQ(told(scene, std::nan(""), 0), "s = nan is not allowed: it must be finite");
  EXPECT_EQ(told(scene, infinity, 0), "s = inf is not allowed: it must be finite");
  EXPECT_EQ(told(scene, 0, -0.1), "depth = -0.1 is not allowed: it must be zero or positive");
  EXPECT_EQ(told(scene, 0, std::nan("")).find("depth = nan is not allowed"), 0U);
  thermoroll_scene by_scheme = scheme();
  by_scheme.places = THERMOROLL_AS_GIVEN;
  EXPECT_EQ(told(by_scheme, 0, 0.1).find("depth = 0.1 is not allowed: it must be 0 with"), 0U);
  std::vector<thermoroll_point> many(100001);
  many[0].size = sizeof many[0];
  thermoroll_result result{};
  result.size = sizeof result;
  EXPECT_EQ(thermoroll_profile(&scene, &result, many.data(), many.size()), THERMOROLL_REFUSED);
  EXPECT_STREQ(result.message, "count = 100001 is not allowed: it must be from 1 to 100000");
  scene.places = 2;
  thermoroll_point point{};
  point.size = sizeof point;
  EXPECT_EQ(thermoroll_profile(&scene, &result, &point, 1), THERMOROLL_REFUSED);
}

// Data that overflow: the program says the same with the same status, and writes nothing.
TEST(Interface, OnlyFiniteAnswers) {
  thermoroll_scene slow = steel(), tough = wheel();
  slow.peclet = 5e-324;
  EXPECT_EQ(answer(slow).status, THERMOROLL_REFUSED);
  tough.friction_law = THERMOROLL_CONSTANT;
  tough.friction_temperature = tough.friction_floor = 0;
  tough.method = THERMOROLL_CLOSED_FORM;
  tough.friction = 1e300;
  EXPECT_EQ(answer(tough).status, THERMOROLL_REFUSED);
  thermoroll_scene strong = tough;  // only the power is infinite: the units and the groups are not
  strong.roller = THERMOROLL_INSULATED;
  strong.quantity = THERMOROLL_TRACTION;
  strong.friction = 1e5;
  strong.given = 9e4;
  strong.load = 1e12;
  strong.half_width = 1e10;
  strong.speed = 1;
  strong.shear_modulus = 1e-287;
  strong.diffusivity = 1000;
  strong.conductivity = 1e20;
  const thermoroll_result x = answer(strong);
  EXPECT_EQ(x.status, THERMOROLL_NOT_CONVERGED);
  EXPECT_EQ(std::string(x.message).find("no finite result was found"), 0U) << x.message;
  expect_nan(x.value);
  expect_nan(x.physical);
  thermoroll_result result;
  for (const thermoroll_point& point : points_of(strong, 3, result)) {
    EXPECT_EQ(point.status, THERMOROLL_NOT_CONVERGED);
    EXPECT_TRUE(std::isnan(point.s));
  }
  strong.method = THERMOROLL_GAUSS_CHEBYSHEV;  // it has no errors, which would be infinite as well
  strong.expansion = 0;
  EXPECT_EQ(answer(strong).status, THERMOROLL_NOT_CONVERGED) << answer(strong).message;
}

TEST(Interface, ProfilesThatAreNot) {
  thermoroll_scene refused = steel(), unknown = steel();
  refused.friction = -1;
  unknown.size += 8;
  thermoroll_result result;
  for (const auto& [scene, count] : {std::pair(refused, 5U), std::pair(scheme(), 5U),
                                     std::pair(steel(), 1U), std::pair(steel(), 100001U)}) {
    for (const thermoroll_point& point : points_of(scene, count, result)) {
      EXPECT_EQ(point.status, THERMOROLL_REFUSED);
      EXPECT_TRUE(std::isnan(point.s + point.temperature));
    }
    expect_nan(result.value);
    EXPECT_GT(std::strlen(result.message), 10U);
  }
  EXPECT_STREQ(result.message, "count = 100001 is not allowed: it must be from 2 to 100000");
  thermoroll_point point{};
  point.size = sizeof point;
  const thermoroll_scene scene = steel();
  EXPECT_EQ(thermoroll_profile(nullptr, &result, &point, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(thermoroll_profile(&unknown, &result, &point, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(thermoroll_profile(&scene, nullptr, &point, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(thermoroll_profile(&scene, &result, nullptr, 1), THERMOROLL_REFUSED);
  result.status = 77;
  EXPECT_EQ(thermoroll_profile(&scene, &result, &point, 0), THERMOROLL_REFUSED);
  point.size -= 8;
  EXPECT_EQ(thermoroll_profile(&scene, &result, &point, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(result.status, 77);
  EXPECT_EQ(point.status, 0);
}

TEST(Interface, RefusesNumbersThatAreNoWords) {
  using S = thermoroll_scene;
  const std::pair<int32_t S::*, std::string> words[] = {
      {&S::quantity, "quantity"},         {&S::roller, "roller"}, {&S::direction, "direction"},
      {&S::friction_law, "friction_law"}, {&S::branch, "branch"}, {&S::method, "method"},
      {&S::formulation, "formulation"}};
  for (const auto& [member, name] : words) {
    expect_effect(steel(), member, -1, (name + " = -1 is not allowed").c_str());
    expect_effect(steel(), member, 5, (name + " = 5 is not allowed").c_str());
  }
}

TEST(Interface, RefusesWhatIsNoNumber) {
  using S = thermoroll_scene;
  for (double S::*member :
       {&S::given, &S::friction, &S::peclet, &S::heating, &S::tolerance, &S::conductivity_ratio,
        &S::heating_2, &S::peclet_2, &S::bulk_difference})
    for (const double x : {std::nan(""), infinity}) {
      S scene = conducting();
      scene.*member = x;
      EXPECT_EQ(answer(scene).status, THERMOROLL_REFUSED);
    }
  for (double S::*member :
       {&S::friction_temperature, &S::friction_floor, &S::friction_reference_temperature}) {
    S scene = hot();
    scene.*member = std::nan("");
    EXPECT_EQ(answer(scene).status, THERMOROLL_REFUSED);
  }
}

thermoroll_law* law_of(const thermoroll_scene& scene, double reach, thermoroll_law_info& info) {
  info = {};
  info.size = sizeof info;
  return thermoroll_law_new(&scene, reach, &info);
}

TEST(Interface, LawIsThatOfTheLibrary) {
  thermoroll_scene scene = steel();
  scene.tolerance = 1e-3;
  thermoroll_law_info info;
  thermoroll_law* law = law_of(scene, 2, info);
  ASSERT_NE(law, nullptr) << info.message;
  const auto expected =
      thermoroll::creep_law({0.6, 4360, 0.0175}, Formulation::corrected, 1e-3, {-2, 2});
  EXPECT_EQ(info.status, 0);
  EXPECT_EQ(info.driving_end, expected.driving.last_creep);
  EXPECT_EQ(info.braking_end, expected.braking.last_creep);
  EXPECT_EQ(info.message,
            "driving: " + expected.driving.reason + "; braking: " + expected.braking.reason);
  const std::vector<double> creeps{-1.5, -0.1, 0, 0.2, 1, 1e9, std::nan("")};
  std::vector<thermoroll_law_value> values(creeps.size());
  values[0].size = sizeof values[0];
  EXPECT_EQ(thermoroll_law_evaluate(law, creeps.data(), values.data(), creeps.size()), 4);
  EXPECT_EQ(thermoroll_law_evaluate(law, creeps.data(), values.data(), 5), 0);
  for (std::size_t k = 0; k < 5; ++k) {
    const auto x = thermoroll::evaluate(expected, creeps[k]);
    const double unit = (creeps[k] < 0 ? expected.braking : expected.driving).unit_creep;
    ASSERT_TRUE(x);
    EXPECT_EQ(values[k].status, 0);
    EXPECT_EQ(values[k].traction, x->traction);
    EXPECT_EQ(values[k].slope, x->slope);
    EXPECT_EQ(values[k].max_temperature, x->temperature);
    EXPECT_EQ(values[k].stick_slip_border, x->border);
    EXPECT_EQ(values[k].traction_error, expected.traction_error);
    EXPECT_EQ(values[k].max_temperature_error,
              expected.temperature_error * std::max(1.0, std::abs(creeps[k]) / unit));
    EXPECT_EQ(values[k].stick_slip_border_error, thermoroll::border_error_at(expected, creeps[k]));
  }
  for (std::size_t k = 5; k < creeps.size(); ++k) {
    EXPECT_EQ(values[k].status, THERMOROLL_REFUSED);
    EXPECT_TRUE(std::isnan(values[k].traction + values[k].max_temperature_error));
  }
  thermoroll_law_free(law);
}

// With a bulk difference the state without slip is beyond a short reach: only the half of braking
// is needed, from there on, and driving ends where it begins.
TEST(Interface, LawEndsWithoutSlipWhereNoMoreIsAskedFor) {
  thermoroll_scene scene;
  thermoroll_scene_init(&scene, sizeof scene);
  scene.friction = 0.3;
  scene.peclet = 50;
  scene.heating = scene.heating_2 = 0.2;
  scene.roller = THERMOROLL_CONDUCTING;
  scene.conductivity_ratio = 1;
  scene.bulk_difference = 0.1;
  scene.tolerance = 1e-3;
  thermoroll_law_info info;
  thermoroll_law* law = law_of(scene, 0.001, info);
  ASSERT_NE(law, nullptr) << info.message;
  EXPECT_GT(info.driving_end, 0.001);
  const double beside[] = {info.driving_end * (1 - 1e-6), info.driving_end * (1 + 1e-6)};
  thermoroll_law_value values[2]{};
  values[0].size = sizeof values[0];
  EXPECT_EQ(thermoroll_law_evaluate(law, beside, values, 2), 4);
  EXPECT_EQ(values[0].status, 0);
  EXPECT_EQ(values[1].status, 2);
  thermoroll_law_free(law);
}

// In SI units the law has creep ratios, N/m and degree C: each is that of the library in its unit.
TEST(Interface, LawInSiUnits) {
  thermoroll_law_info info;
  thermoroll_scene scene = wheel();
  scene.tolerance = 1e-3;
  thermoroll_law* law = law_of(scene, 0.03, info);
  ASSERT_NE(law, nullptr) << info.message;
  EXPECT_NEAR(info.driving_end, 0.03, 1e-15);
  thermoroll::PhysicalScene si = *si_pairs()[2].cpp.physical;
  const auto unit = thermoroll::law_units(si, 0.35);
  const auto expected =
      thermoroll::creep_law(thermoroll::scene_of(si, 0.35), Formulation::corrected, 1e-3,
                            {-0.03 / unit.creep, 0.03 / unit.creep});
  const double ratio = 0.02;
  thermoroll_law_value y{};
  y.size = sizeof y;
  ASSERT_EQ(thermoroll_law_evaluate(law, &ratio, &y, 1), 0);
  const auto x = thermoroll::evaluate(expected, ratio / unit.creep);
  EXPECT_DOUBLE_EQ(y.traction, x->traction * 1.2e7);
  EXPECT_DOUBLE_EQ(y.slope, x->slope * 1.2e7 / unit.creep);
  EXPECT_DOUBLE_EQ(y.max_temperature, x->temperature * unit.temperature);
  EXPECT_DOUBLE_EQ(y.traction_error, expected.traction_error * 1.2e7);
  const double grown = ratio / unit.creep / expected.driving.unit_creep;
  EXPECT_GT(grown, 1);
  EXPECT_DOUBLE_EQ(y.max_temperature_error, expected.temperature_error * grown * unit.temperature);
  thermoroll_law_free(law);
  scene.half_width = 0;
  scene.radius = 0.46;
  EXPECT_EQ(law_of(scene, 0.03, info), nullptr);
  EXPECT_NE(std::string(info.message).find("needs half_width"), std::string::npos);
  scene.radius = 0;
  EXPECT_EQ(law_of(scene, 0.03, info), nullptr);
  EXPECT_EQ(info.status, THERMOROLL_REFUSED);
}

// Laws made in C and in C++, their values, a profile and a message, by one caller.
struct FromLaw {
  std::vector<thermoroll_law_value> in_c;
  std::vector<thermoroll_point> points;
  std::vector<double> in_cpp;
  std::string message;
};

bool operator==(const FromLaw& x, const FromLaw& y) {
  return same_bytes(x.in_c, y.in_c) && same_bytes(x.points, y.points) &&
         same_bytes(x.in_cpp, y.in_cpp) && x.message == y.message;
}

FromLaw evaluated(const thermoroll_law* in_c, const thermoroll::CreepLaw& in_cpp) {
  const std::vector<double> creeps{-0.4, -0.1, 0, 0.05, 0.2, 0.3, 0.7};
  FromLaw found;
  found.in_c.resize(creeps.size());
  found.in_c[0].size = sizeof found.in_c[0];
  EXPECT_EQ(thermoroll_law_evaluate(in_c, creeps.data(), found.in_c.data(), creeps.size()), 0);
  for (const double creep : creeps)
    found.in_cpp.push_back(thermoroll::evaluate(in_cpp, creep).value().traction);
  return found;
}

thermoroll::CreepLaw soft_law() {
  Scene soft{0.6, 100, 0.0175};
  soft.law = LawOfFriction{LawKind::linear, {0.02}};
  return thermoroll::creep_law(soft, Formulation::corrected, 1e-2, {-1, 1});
}

FromLaw made_and_evaluated() {
  thermoroll_scene scene = hot();
  scene.tolerance = 1e-2;
  thermoroll_law_info info;
  thermoroll_law* law = law_of(scene, 1, info);
  FromLaw found = evaluated(law, soft_law());
  thermoroll_law_free(law);
  thermoroll_result result;
  found.points = points_of(scene, 9, result);
  scene.friction = -1;
  found.message = answer(scene).message;
  return found;
}

std::vector<FromLaw> at_once(const std::function<FromLaw()>& work) {
  std::vector<FromLaw> found(3);
  std::vector<std::thread> threads;
  for (FromLaw& x : found) threads.emplace_back([&] { x = work(); });
  for (std::thread& thread : threads) thread.join();
  return found;
}

// Each of several threads makes laws of its own, and all evaluate one that they share. They come
// first, so that what is computed at its first use is computed by all at once.
TEST(Interface, LawsOfSeveralThreads) {
  const std::vector<FromLaw> own = at_once(made_and_evaluated);
  const FromLaw alone = made_and_evaluated();
  EXPECT_EQ(alone.message, "friction = -1 is not allowed: it must be positive");
  EXPECT_NE(alone.in_cpp[0], alone.in_cpp[1]);
  for (const FromLaw& x : own) EXPECT_TRUE(x == alone);

  thermoroll_scene scene = steel();
  scene.tolerance = 1e-2;
  thermoroll_law_info info;
  thermoroll_law* law = law_of(scene, 1, info);
  const thermoroll::CreepLaw in_cpp = soft_law();
  const auto evaluate_both = [&] { return evaluated(law, in_cpp); };
  for (const FromLaw& x : at_once(evaluate_both)) EXPECT_TRUE(x == evaluate_both());
  thermoroll_law_free(law);
}

TEST(Interface, LawsThatAreNot) {
  thermoroll_law_info info;
  thermoroll_scene scene = steel();
  scene.tolerance = 1e-9;
  EXPECT_EQ(law_of(scene, infinity, info), nullptr);
  EXPECT_EQ(info.status, THERMOROLL_REFUSED);
  EXPECT_NE(std::string(info.message).find("1e-09 is not allowed"), std::string::npos)
      << info.message;
  EXPECT_TRUE(std::isnan(info.driving_end));
  scene.size = 1;
  EXPECT_EQ(law_of(scene, infinity, info), nullptr);
  EXPECT_STREQ(info.message, "no scene of this size");
  EXPECT_EQ(thermoroll_law_new(&scene, infinity, nullptr), nullptr);
  thermoroll_law_value value{};
  value.size = sizeof value;
  const double creep = 0;
  EXPECT_EQ(thermoroll_law_evaluate(nullptr, &creep, &value, 1), THERMOROLL_REFUSED);
  EXPECT_EQ(thermoroll_law_evaluate(nullptr, nullptr, nullptr, 0), THERMOROLL_DONE);
  thermoroll_law_free(nullptr);
}

}  // namespace
