// Tangled from paper/K-from-other-languages.md; edit there.
#include <thermoroll.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <map>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "support/number_text.hpp"
#include "thermoroll/thermoroll.hpp"

namespace {

using namespace thermoroll;

template <class Word>
Word word(const char* name, int32_t number, int last) {
  require(0 <= number && number <= last, name, number, "from 0 to " + std::to_string(last));
  return static_cast<Word>(number);
}

void refuse_unused(std::initializer_list<double> data, const char* message) {
  for (const double x : data)
    if (x != 0) throw std::invalid_argument(message);
}

bool in_si(const thermoroll_scene& x) { return x.load != 0; }

void refuse_other_kind(const thermoroll_scene& x) {
  if (in_si(x))
    return refuse_unused(
        {x.peclet, x.heating, x.conductivity_ratio, x.heating_2, x.peclet_2, x.bulk_difference},
        "peclet, heating, conductivity_ratio, heating_2, peclet_2 and "
        "bulk_difference are not for data in SI units, which have a load");
  const double bulk = std::isnan(x.bulk_temperature) && std::isnan(x.bulk_temperature_2) ? 0 : 1;
  refuse_unused(
      {x.speed, x.half_width, x.radius, x.shear_modulus, x.poisson, x.expansion, x.diffusivity,
       x.conductivity, x.expansion_2, x.conductivity_2, x.diffusivity_2, bulk},
      "load = 0 is not allowed: data in SI units need it");
}

Roller roller_of(const thermoroll_scene& x) {
  const auto kind = word<thermoroll_roller>("roller", x.roller, THERMOROLL_CONDUCTING);
  if (kind != THERMOROLL_CONDUCTING)
    refuse_unused({x.conductivity_ratio, x.heating_2, x.peclet_2},
                  "conductivity_ratio, heating_2 and peclet_2 are for a conducting roller only");
  if (kind == THERMOROLL_INSULATED) return {};
  if (kind == THERMOROLL_IDENTICAL) return {1, x.heating};
  require(x.conductivity_ratio > 0, "conductivity_ratio", x.conductivity_ratio, "positive");
  return {x.conductivity_ratio, x.heating_2, x.peclet_2 == x.peclet ? 0 : x.peclet_2};
}

void read_roller(const thermoroll_scene& x, PhysicalScene& si) {
  const auto kind = word<thermoroll_roller>("roller", x.roller, THERMOROLL_CONDUCTING);
  if (kind == THERMOROLL_CONDUCTING) {
    require(x.conductivity_2 > 0, "conductivity_2", x.conductivity_2, "positive");
    si.expansion_2 = x.expansion_2;
    si.conductivity_2 = x.conductivity_2;
    si.diffusivity_2 = x.diffusivity_2;
    return;
  }
  refuse_unused({x.expansion_2, x.conductivity_2, x.diffusivity_2},
                "expansion_2, conductivity_2 and diffusivity_2 are for a conducting roller only");
  if (kind == THERMOROLL_INSULATED) return;
  si.expansion_2 = si.expansion;
  si.conductivity_2 = si.conductivity;
  si.diffusivity_2 = si.diffusivity;
}

std::optional<LawOfFriction> friction_of(const thermoroll_scene& x) {
  const int kind = word<int>("friction_law", x.friction_law, THERMOROLL_PIECEWISE_LINEAR);
  const double reference = x.friction_reference_temperature;
  if (kind != THERMOROLL_CONSTANT)
    return LawOfFriction{static_cast<LawKind>(kind - 1),
                         {x.friction_temperature, x.friction_floor, reference}};
  refuse_unused({x.friction_temperature, x.friction_floor, reference},
                "friction_temperature, friction_floor and friction_reference_temperature are for "
                "friction that depends on temperature");
  return {};
}

Direction direction_of(const thermoroll_scene& x) {
  const auto direction = word<Direction>("direction", x.direction, THERMOROLL_BRAKING);
  if (direction == Direction::braking && x.quantity != THERMOROLL_STICK_SLIP_BORDER && x.given > 0)
    throw std::invalid_argument(
        "direction = braking contradicts the given quantity, which is "
        "positive: it drives");
  const bool warmer = x.bulk_temperature_2 < x.bulk_temperature ||
                      x.bulk_temperature_2 > x.bulk_temperature || x.bulk_difference != 0;
  if (direction == Direction::braking && x.quantity != THERMOROLL_STICK_SLIP_BORDER && warmer)
    throw std::invalid_argument("direction is for a given border where bulk temperatures differ");
  return direction;
}

Prescribed given_of(const thermoroll_scene& x) {
  constexpr Quantity quantities[] = {Quantity::traction, Quantity::creep,
                                     Quantity::stick_slip_border, Quantity::creep,
                                     Quantity::traction};
  const int quantity = word<int>("quantity", x.quantity, THERMOROLL_TANGENTIAL_LOAD);
  const auto branch = word<Branch>("branch", x.branch, THERMOROLL_FALLING);
  if (branch == Branch::falling && quantities[quantity] != Quantity::traction)
    throw std::invalid_argument("branch = falling is for a given traction only");
  if (quantity >= THERMOROLL_CREEP_RATIO && !in_si(x))
    throw std::invalid_argument(
        "a creep ratio or a tangential load needs data in SI units, which have a load");
  const double unit = quantity == THERMOROLL_TANGENTIAL_LOAD ? x.load : 1;
  return {quantities[quantity], x.given / unit, branch};
}

Scene scene_of(const thermoroll_scene& x) {
  Scene scene{x.friction, x.peclet, x.heating, roller_of(x), direction_of(x)};
  if (const auto law = friction_of(x)) scene.law = *law;
  scene.bulk_difference = x.bulk_difference;
  return scene;
}

std::optional<double> known(double x) {
  return std::isnan(x) ? std::nullopt : std::optional<double>(x);
}

PhysicalScene physical_of(const thermoroll_scene& x) {
  PhysicalScene si{x.load,    x.speed,     x.half_width,  x.shear_modulus,
                   x.poisson, x.expansion, x.diffusivity, x.conductivity};
  if ((x.half_width == 0) == (x.radius == 0))
    throw std::invalid_argument("data in SI units need either half_width or radius");
  if (!std::isnan(x.bulk_temperature_2) && std::isnan(x.bulk_temperature))
    throw std::invalid_argument("bulk_temperature_2 needs bulk_temperature");
  read_roller(x, si);
  si.direction = direction_of(x);
  si.bulk_temperature = known(x.bulk_temperature);
  si.bulk_temperature_2 = known(x.bulk_temperature_2);
  si.law = friction_of(x);
  return si;
}

std::string as_given(const thermoroll_scene& x) {
  if (x.quantity == THERMOROLL_CREEP_RATIO) return "creep_ratio = " + shortest(x.given);
  if (x.quantity == THERMOROLL_TANGENTIAL_LOAD) return "tangential_load = " + shortest(x.given);
  return "";
}

Approach approach_of(const thermoroll_scene& x) {
  require(x.places == THERMOROLL_ALONG_CONTACT, "places", x.places, "0, or 1 in a profile");
  return {word<Formulation>("formulation", x.formulation, THERMOROLL_CORRECTED), x.tolerance,
          word<Method>("method", x.method, THERMOROLL_GAUSS_CHEBYSHEV), x.nodes};
}

GivenScene given_scene(const thermoroll_scene& x) {
  refuse_other_kind(x);
  const Prescribed given = given_of(x);
  const Approach approach = approach_of(x);
  if (!in_si(x)) return {scene_of(x), given, approach, {}, {}};
  const PhysicalScene si = physical_of(x);
  GivenScene scene{{x.friction, 0, 0}, given, approach, si, {}};
  if (x.radius != 0) scene.radius = x.radius;
  if (x.quantity == THERMOROLL_CREEP_RATIO) scene.unit = CreepUnit::ratio;
  scene.as_given = as_given(x);
  return scene;
}

void copy(const Results& from, thermoroll_values& to) {
  static_assert(offsetof(thermoroll_values, heat_1) == sizeof(double) * Results::SizeAtCompileTime);
  std::memcpy(&to, from.data(), offsetof(thermoroll_values, heat_1));
}

void share_heat(const Solution& x, thermoroll_result& to) {
  const Heats heat = heats(x);
  to.value.heat_1 = heat.into_half_space.value;
  to.value.heat_2 = heat.into_cylinder.value;
  if (!x.error) return;
  to.error.heat_1 = heat.into_half_space.error;
  to.error.heat_2 = heat.into_cylinder.error;
}

void tell_limit(const Scene& scene, const CoupledSolution* found, thermoroll_result& to) {
  if (found == nullptr || !found->limit) return;
  const TractionLimit& limit = *found->limit;
  to.value.traction_limit = sign_of(scene.direction) * limit.traction;
  to.error.traction_limit = limit.traction_error;
  if (!limit.has_creep()) return;
  to.value.creep_at_traction_limit = sign_of(scene.direction) * limit.creep;
  to.error.creep_at_traction_limit = limit.creep_error;
}

template <std::size_t n>
void write(std::string_view text, char (&to)[n]) {
  if (text.size() >= n) text = text.substr(0, text.rfind("; ", n - 1));
  std::fill(to + text.copy(to, n - 1), to + n, '\0');
}

/// Fill a structure that has doubles only with NaN.
template <class Numbers>
void empty(Numbers& x) {
  double none[sizeof x / sizeof(double)];
  std::fill(std::begin(none), std::end(none), std::nan(""));
  std::memcpy(&x, none, sizeof x);
}

thermoroll_result empty_result() {
  thermoroll_result x{};
  x.size = sizeof x;
  x.model = THERMOROLL_NO_MODEL;
  for (thermoroll_values* values : {&x.value, &x.error}) empty(*values);
  for (thermoroll_physical* values : {&x.physical, &x.physical_error}) empty(*values);
  empty(x.unit);
  return x;
}

void copy(const PhysicalResults& from, thermoroll_physical& to) {
  static_assert(offsetof(thermoroll_physical, heat_1) == sizeof from);
  std::memcpy(&to, &from, sizeof from);
}

void copy(const FoundInSi& from, thermoroll_result& to) {
  copy(from.value, to.physical);
  to.physical.heat_1 = from.heat_1.value;
  to.physical.heat_2 = from.heat_2.value;
  if (from.error) {
    copy(*from.error, to.physical_error);
    to.physical_error.heat_1 = from.heat_1.error;
    to.physical_error.heat_2 = from.heat_2.error;
  }
  if (!from.contact_temperature_celsius) return;
  to.physical.contact_temperature_celsius = *from.contact_temperature_celsius;
  to.physical_error.contact_temperature_celsius = to.physical_error.max_temperature_celsius;
}

std::string in_short(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes)
    text += (text.empty() ? "" : "; ") + note.substr(0, note.find(" ("));
  return text;
}

void require_finite(bool all) {
  if (!all) throw NotConverged("no finite result was found: some data are too large or too small");
}

/// All numbers but so many of the last, which may be NaN.
template <class Numbers>
void require_finite(const Numbers& x, std::ptrdiff_t but) {
  double all[sizeof x / sizeof(double)];
  std::memcpy(all, &x, sizeof x);
  require_finite(
      std::all_of(std::begin(all), std::end(all) - but, [](double y) { return std::isfinite(y); }));
}

void require_finite(const thermoroll_result& x, bool has_error, bool in_si) {
  require_finite(x.value, 2);
  if (has_error) require_finite(x.error, 2);
  if (!in_si) return;
  require_finite(x.unit, 0);
  require_finite(x.physical, 1);
  if (has_error) require_finite(x.physical_error, 1);
}

thermoroll_result result_of(const SolvedScene& solved) {
  const auto& [x, units, physical] = solved;
  thermoroll_result to = empty_result();
  const auto* found = std::get_if<CoupledSolution>(&x.found);
  copy(x.value, to.value);
  if (x.error) copy(*x.error, to.error);
  share_heat(x, to);
  tell_limit(x.scene, found, to);
  if (x.model) to.model = static_cast<int32_t>(*x.model);
  if (x.model == Model::coupled) to.unknowns = found->unknowns;
  write(x.reason, to.message);
  if (units)
    to.unit = {units->length, units->traction, units->slip, units->heat_flux, units->temperature};
  if (physical) copy(*physical, to);
  if (physical) write(in_short(physical->notes), to.notes);
  require_finite(to, x.error.has_value(), physical.has_value());
  return to;
}

int status_of(const std::exception& error) {
  if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr) return THERMOROLL_REFUSED;
  if (dynamic_cast<const NotConverged*>(&error) != nullptr) return THERMOROLL_NOT_CONVERGED;
  if (dynamic_cast<const NoContact*>(&error) != nullptr) return THERMOROLL_NO_CONTACT;
  return THERMOROLL_FAILED;
}

/// A refusal that names an option of the command line names the member: underscores for hyphens.
void name_member(char* message) {
  char* const end = std::strchr(message, ' ');
  if (end != nullptr && std::strncmp(end, " = ", 3) == 0) std::replace(message, end, '-', '_');
}

/// Do the work, or write why it failed into an answer or the info of a law.
template <class Told, class Work>
void attempt(Told& told, const Work& work) noexcept try {
  work();
} catch (const std::bad_alloc&) {
  told.status = THERMOROLL_FAILED;
  write("there is not enough memory", told.message);
} catch (const std::exception& error) {
  told.status = status_of(error);
  write(error.what(), told.message);
  name_member(told.message);
} catch (...) {
  told.status = THERMOROLL_FAILED;
}

void refuse_what_is_no_contact(const Solution& x) {
  if (!x.converged) throw NotConverged("the iteration did not converge");
  if (!x.violations.empty())
    throw NoContact("the solution is no contact: " + x.violations.front().what);
}

void solve_row(const thermoroll_scene& scene, thermoroll_result& result) noexcept {
  result = empty_result();
  attempt(result, [&] {
    const SolvedScene x = solve_scene(given_scene(scene));
    refuse_what_is_no_contact(x.solution);
    const thermoroll_result found = result_of(x);
    result = found;
  });
}

/// Do the work for each row, on so many threads.
template <class Work>
void for_each_row(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t row = next++; row < count; row = next++) work(row);
  };
  const std::size_t all = threads > 0 ? static_cast<std::size_t>(threads)
                                      : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> others;
  try {
    others.reserve(std::min(all, count) - 1);
    while (others.size() + 1 < std::min(all, count)) others.emplace_back(take);
  } catch (const std::exception&) {  // those that have started are enough
  }
  take();
  for (std::thread& thread : others) thread.join();
}

void copy(const Profile& from, double friction, thermoroll_point* to) {
  const bool shared = from.heat_flux_1.size() > 0;
  const ProfileErrors& error = *from.error;
  for (Eigen::Index k = 0; k < from.s.size(); ++k)
    to[k] = {sizeof *to,
             THERMOROLL_DONE,
             from.s(k),
             from.pressure(k),
             from.traction(k),
             from.slip(k),
             from.heat_flux(k),
             from.temperature(k),
             shared ? from.heat_flux_1(k) : from.heat_flux(k),
             shared ? from.heat_flux_2(k) : 0,
             0,
             error.temperature,
             from.friction.size() > 0 ? from.friction(k) : friction,
             error.pressure,
             error.traction,
             error.slip,
             error.heat_flux};
}

thermoroll_result along_contact(const thermoroll_scene& scene, thermoroll_point* points,
                                std::size_t count) {
  require(2 <= count && count <= 100000, "count", static_cast<double>(count), "from 2 to 100000");
  const SolvedScene x = solve_scene(given_scene(scene));
  refuse_what_is_no_contact(x.solution);
  const Profile found = profile(x.solution, static_cast<int>(count));
  require_finite((found.pressure * 0 + found.traction * 0 + found.slip * 0 + found.heat_flux * 0 +
                      found.temperature * 0 ==
                  0)
                     .all());
  const thermoroll_result told = result_of(x);
  copy(found, x.solution.scene.friction, points);
  return told;
}

std::vector<CurvePoint> temperatures_of(const Solution& x, const thermoroll_point* points,
                                        std::size_t count) {
  std::map<double, std::vector<std::size_t>> of_depth;
  for (std::size_t k = 0; k < count; ++k) of_depth[points[k].depth].push_back(k);
  std::vector<CurvePoint> all(count);
  for (const auto& [depth, places] : of_depth) {
    std::vector<double> at;
    for (const std::size_t k : places) at.push_back(points[k].s);
    const Curve curve = temperature_curve(x, at, depth);
    for (std::size_t i = 0; i < places.size(); ++i) all[places[i]] = curve.points[i];
  }
  return all;
}

thermoroll_point empty_point(double s, double depth) {
  const double none = std::nan("");
  constexpr std::uint32_t size = sizeof(thermoroll_point);
  return {size, 0,     s,    none, none, none, none, none, none,
          none, depth, none, none, none, none, none, none};
}

thermoroll_result where_given(const thermoroll_scene& scene, thermoroll_point* points,
                              std::size_t count) {
  require(count <= 100000, "count", static_cast<double>(count), "from 1 to 100000");
  for (std::size_t k = 0; k < count; ++k) {
    require(true, "s", points[k].s, "finite");
    require(points[k].depth >= 0, "depth", points[k].depth, "zero or positive");
  }
  thermoroll_scene plain = scene;
  plain.places = THERMOROLL_ALONG_CONTACT;
  const SolvedScene x = solve_scene(given_scene(plain));
  refuse_what_is_no_contact(x.solution);
  const thermoroll_result told = result_of(x);
  const std::vector<CurvePoint> found = temperatures_of(x.solution, points, count);
  for (const CurvePoint& point : found) require_finite(std::isfinite(point.temperature));
  for (std::size_t k = 0; k < count; ++k) {
    points[k].temperature = found[k].temperature;
    points[k].temperature_error = found[k].error.value_or(std::nan(""));
  }
  return told;
}

std::pair<Scene, LawUnits> scene_of_law(const thermoroll_scene& x) {
  const GivenScene given = given_scene(x);
  if (!given.physical) return {given.scene, LawUnits{}};
  if (given.radius)
    throw std::invalid_argument(
        "a law in SI units needs half_width: from a radius it would differ");
  check(*given.physical);
  return {scene_of(*given.physical, x.friction), law_units(*given.physical, x.friction)};
}

std::string ends_of(const CreepLaw& law) {
  std::string text;
  for (const LawHalf* half : {&law.driving, &law.braking})
    if (!half->reason.empty())
      text += (text.empty() ? "" : "; ") +
              std::string(half == &law.driving ? "driving: " : "braking: ") + half->reason;
  return text;
}

void tell(const CreepLaw& law, const LawUnits& unit, thermoroll_law_info& info) {
  const auto reach = [](const LawHalf& half) { return std::max(half.last_creep, 0.0); };
  info.driving_end = (reach(law.driving) + law.no_slip_creep) * unit.creep;
  info.braking_end = (reach(law.braking) - law.no_slip_creep) * unit.creep;
  write(ends_of(law), info.message);
}

thermoroll_law_value value_of(const CreepLaw& law, const LawUnits& in, double given) {
  const double creep = given / in.creep;
  const std::optional<LawValue> x = evaluate(law, creep);
  const double none = std::nan("");
  thermoroll_law_value y{sizeof y, THERMOROLL_REFUSED, none, none, none, none, none, none, none};
  if (!x) return y;
  y.status = THERMOROLL_DONE;
  y.traction = x->traction * in.traction;
  y.slope = x->slope * in.traction / in.creep;
  y.max_temperature = x->temperature * in.temperature;
  y.stick_slip_border = x->border;
  y.traction_error = law.traction_error * in.traction;
  const LawSide side = side_of(law, creep);
  const double grown = std::max(1.0, side.size / side.half.unit_creep);
  y.max_temperature_error = law.temperature_error * grown * in.temperature;
  y.stick_slip_border_error = border_error_at(law, creep);
  return y;
}

template <class Row>
bool is_known(const Row* rows) {
  return rows != nullptr && rows->size == sizeof(Row);
}

}  // namespace

struct thermoroll_law {
  thermoroll::CreepLaw law;
  thermoroll::LawUnits unit;
};

const char* thermoroll_message(int status) {
  constexpr const char* messages[] = {"done",
                                      "no solution was found, or not to the tolerance",
                                      "refused: data out of range",
                                      "the iteration did not converge",
                                      "some rows have an error",
                                      "the solution is no contact"};
  return 0 <= status && status <= THERMOROLL_NO_CONTACT ? messages[status] : "no such status";
}

void thermoroll_scene_init(thermoroll_scene* scene, size_t size) {
  const Approach by;
  thermoroll_scene x{};
  x.size = static_cast<uint32_t>(size);
  x.formulation = static_cast<int32_t>(by.formulation);
  x.tolerance = by.tolerance;
  x.nodes = by.nodes;
  x.bulk_temperature = x.bulk_temperature_2 = std::nan("");
  if (scene != nullptr) std::memcpy(scene, &x, std::min(size, sizeof x));
}

int thermoroll_solve(const thermoroll_scene* scenes, thermoroll_result* results, size_t count,
                     int threads) {
  if (count == 0 && threads >= 0) return THERMOROLL_DONE;
  if (threads < 0 || !is_known(scenes) || !is_known(results)) return THERMOROLL_REFUSED;
  for_each_row(count, threads, [&](std::size_t row) { solve_row(scenes[row], results[row]); });
  const auto solved = [](const thermoroll_result& x) { return x.status == THERMOROLL_DONE; };
  return std::all_of(results, results + count, solved) ? THERMOROLL_DONE : THERMOROLL_ROWS_FAILED;
}

int thermoroll_profile(const thermoroll_scene* scene, thermoroll_result* result,
                       thermoroll_point* points, size_t count) {
  if (count == 0 || !is_known(scene) || !is_known(result) || !is_known(points))
    return THERMOROLL_REFUSED;
  thermoroll_result told = empty_result();
  const bool as_given = scene->places == THERMOROLL_AS_GIVEN;
  const double none = std::nan("");
  for (size_t k = 0; k < count; ++k)
    points[k] = as_given ? empty_point(points[k].s, points[k].depth) : empty_point(none, none);
  attempt(told, [&] {
    const thermoroll_result found = (as_given ? where_given : along_contact)(*scene, points, count);
    told = found;
  });
  for (size_t k = 0; k < count; ++k) points[k].status = told.status;
  *result = told;
  return result->status;
}

thermoroll_law* thermoroll_law_new(const thermoroll_scene* scene, double reach,
                                   thermoroll_law_info* info) {
  if (!is_known(info)) return nullptr;
  *info = {sizeof *info, THERMOROLL_REFUSED, std::nan(""), std::nan(""), "no scene of this size"};
  if (!is_known(scene)) return nullptr;
  thermoroll_law* made = nullptr;
  attempt(*info, [&] {
    const Approach by = approach_of(*scene);
    const auto [of, unit] = scene_of_law(*scene);
    if (!(reach > 0))  // infinity is
      throw std::invalid_argument("reach = " + shortest(reach) +
                                  " is not allowed: it must be positive");
    const double farthest = reach / unit.creep;
    const CreepLaw law = creep_law(of, by.formulation, by.tolerance, {-farthest, farthest});
    tell(law, unit, *info);
    made = new thermoroll_law{law, unit};
    info->status = THERMOROLL_DONE;
  });
  return made;
}

int thermoroll_law_evaluate(const thermoroll_law* law, const double* creeps,
                            thermoroll_law_value* values, size_t count) {
  if (count == 0) return THERMOROLL_DONE;
  if (law == nullptr || creeps == nullptr || !is_known(values)) return THERMOROLL_REFUSED;
  bool all = true;
  for (std::size_t row = 0; row < count; ++row) {
    values[row] = value_of(law->law, law->unit, creeps[row]);
    all = all && values[row].status == THERMOROLL_DONE;
  }
  return all ? THERMOROLL_DONE : THERMOROLL_ROWS_FAILED;
}

void thermoroll_law_free(thermoroll_law* law) { delete law; }
