// Tangled from paper/K-from-other-languages.md; edit there.
#include <thermoroll.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <new>
#include <thread>

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

FrictionLaw friction_of(const thermoroll_scene& x) {
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
    throw std::invalid_argument("direction = braking contradicts a positive traction or creep");
  return direction;
}

Prescribed given_of(const thermoroll_scene& x) {
  constexpr Quantity quantities[] = {Quantity::traction, Quantity::creep,
                                     Quantity::stick_slip_border};
  const int quantity = word<int>("quantity", x.quantity, THERMOROLL_STICK_SLIP_BORDER);
  const auto branch = word<Branch>("branch", x.branch, THERMOROLL_FALLING);
  if (branch == Branch::falling && quantity != THERMOROLL_TRACTION)
    throw std::invalid_argument(
        "branch = falling is for a given traction: a creep or a border has one solution");
  return {quantities[quantity], x.given, branch};
}

Scene scene_of(const thermoroll_scene& x) {
  return {x.friction,      x.peclet,       x.heating,        roller_of(x),
          direction_of(x), friction_of(x), x.bulk_difference};
}

Approach approach_of(const thermoroll_scene& x) {
  if (x.unused != 0) throw std::invalid_argument("unused is not 0");
  return {word<Formulation>("formulation", x.formulation, THERMOROLL_CORRECTED), x.tolerance,
          word<Method>("method", x.method, THERMOROLL_GAUSS_CHEBYSHEV), x.nodes};
}

void copy(const Results& from, thermoroll_values& to) {
  static_assert(offsetof(thermoroll_values, heat_1) == sizeof(double) * Results::SizeAtCompileTime);
  std::memcpy(&to, from.data(), offsetof(thermoroll_values, heat_1));
}

void share_heat(const Scene& scene, const CoupledSolution* found, thermoroll_result& to) {
  const double heat = to.value.heat_integral, share = effusivity_share(scene);
  to.value.heat_1 = share * heat;
  to.value.heat_2 = effusivity_ratio(scene) * share * heat;
  to.error.heat_1 = share * to.error.heat_integral;
  to.error.heat_2 = effusivity_ratio(scene) * to.error.heat_1;
  if (found == nullptr || !found->crossing) return;
  to.value.heat_1 = heat_share(scene) * heat + found->crossing->heat;
  to.value.heat_2 = heat - to.value.heat_1;
  to.error.heat_1 = to.error.heat_2 = to.error.heat_integral + found->crossing->heat_error;
}

void tell_limit(const Scene& scene, const CoupledSolution* found, thermoroll_result& to) {
  if (found == nullptr || !found->limit) return;
  const TractionLimit& limit = *found->limit;
  to.value.traction_limit = sign_of(scene.direction) * limit.traction;
  to.value.creep_at_traction_limit = sign_of(scene.direction) * limit.creep;
  to.error.traction_limit = limit.traction_error;
  to.error.creep_at_traction_limit = limit.creep_error;
}

template <std::size_t n>
void write(const std::string& message, char (&to)[n]) {
  std::fill(to + message.copy(to, n - 1), to + n, '\0');
}

thermoroll_result empty_result() {
  thermoroll_result x{};
  x.size = sizeof x;
  x.model = THERMOROLL_NO_MODEL;
  for (thermoroll_values* values : {&x.value, &x.error})
    std::fill_n(&values->stick_slip_border, sizeof *values / sizeof(double), std::nan(""));
  return x;
}

thermoroll_result result_of(const Solution& x) {
  thermoroll_result to = empty_result();
  const auto* found = std::get_if<CoupledSolution>(&x.found);
  copy(x.value, to.value);
  if (x.error) copy(*x.error, to.error);
  share_heat(x.scene, found, to);
  tell_limit(x.scene, found, to);
  if (x.model) to.model = static_cast<int32_t>(*x.model);
  if (x.model == Model::coupled) to.unknowns = found->unknowns;
  write(x.reason, to.message);
  return to;
}

int status_of(const std::exception& error) {
  if (dynamic_cast<const std::invalid_argument*>(&error) != nullptr) return THERMOROLL_REFUSED;
  if (dynamic_cast<const NotConverged*>(&error) != nullptr) return THERMOROLL_NOT_CONVERGED;
  if (dynamic_cast<const NoContact*>(&error) != nullptr) return THERMOROLL_NO_CONTACT;
  return THERMOROLL_FAILED;
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
    const Solution x = solve(scene_of(scene), given_of(scene), approach_of(scene));
    refuse_what_is_no_contact(x);
    result = result_of(x);
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

std::string ends_of(const CreepLaw& law) {
  std::string text;
  for (const LawHalf* half : {&law.driving, &law.braking})
    if (!half->reason.empty())
      text += (text.empty() ? "" : "; ") +
              std::string(half == &law.driving ? "driving: " : "braking: ") + half->reason;
  return text;
}

void tell(const CreepLaw& law, thermoroll_law_info& info) {
  info.driving_end = law.driving.last_creep;
  info.braking_end = law.braking.last_creep;
  write(ends_of(law), info.message);
}

thermoroll_law_value value_of(const CreepLaw& law, double creep) {
  const std::optional<LawValue> x = evaluate(law, creep);
  const double none = std::nan(""), unit = (creep < 0 ? law.braking : law.driving).unit_creep;
  thermoroll_law_value y{sizeof y, THERMOROLL_REFUSED, none, none, none, none, none, none, none};
  if (!x) return y;
  y.status = THERMOROLL_DONE;
  y.traction = x->traction;
  y.slope = x->slope;
  y.max_temperature = x->temperature;
  y.stick_slip_border = x->border;
  y.traction_error = law.traction_error;
  y.max_temperature_error = law.temperature_error * std::max(1.0, std::abs(creep) / unit);
  y.stick_slip_border_error = x->border == -1 ? 0 : law.border_error;
  return y;
}

template <class Row>
bool is_known(const Row* rows) {
  return rows != nullptr && rows->size == sizeof(Row);
}

}  // namespace

struct thermoroll_law {
  thermoroll::CreepLaw law;
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

thermoroll_law* thermoroll_law_new(const thermoroll_scene* scene, double reach,
                                   thermoroll_law_info* info) {
  if (!is_known(info)) return nullptr;
  *info = {sizeof *info, THERMOROLL_REFUSED, std::nan(""), std::nan(""), "no scene of this size"};
  if (!is_known(scene)) return nullptr;
  thermoroll_law* made = nullptr;
  attempt(*info, [&] {
    const Approach by = approach_of(*scene);
    const CreepLaw law = creep_law(scene_of(*scene), by.formulation, by.tolerance, reach);
    tell(law, *info);
    made = new thermoroll_law{law};
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
    values[row] = value_of(law->law, creeps[row]);
    all = all && values[row].status == THERMOROLL_DONE;
  }
  return all ? THERMOROLL_DONE : THERMOROLL_ROWS_FAILED;
}

void thermoroll_law_free(thermoroll_law* law) { delete law; }
