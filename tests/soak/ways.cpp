#include "ways.hpp"

#include <thermoroll.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "program/table.hpp"

using namespace thermoroll;

namespace soak {
namespace {

void set_law(const LawOfFriction& law, thermoroll_scene& to) {
  to.friction_law = static_cast<int32_t>(law.kind) + 1;
  to.friction_temperature = law.of.scale;
  to.friction_floor = law.of.floor;
  to.friction_reference_temperature = law.of.reference;
}

void set_groups(const Scene& from, thermoroll_scene& to) {
  to.peclet = from.peclet;
  to.heating = from.heating;
  to.roller = from.roller.conductivity_ratio > 0 ? THERMOROLL_CONDUCTING : THERMOROLL_INSULATED;
  to.conductivity_ratio = from.roller.conductivity_ratio;
  to.heating_2 = from.roller.heating;
  to.peclet_2 = from.roller.peclet;
  to.bulk_difference = from.bulk_difference;
  if (const auto* law = from.law.target<LawOfFriction>()) set_law(*law, to);
}

void set_physical(const PhysicalScene& from, thermoroll_scene& to) {
  to.load = from.load;
  to.speed = from.speed;
  to.half_width = from.half_width;
  to.shear_modulus = from.shear_modulus;
  to.poisson = from.poisson;
  to.expansion = from.expansion;
  to.diffusivity = from.diffusivity;
  to.conductivity = from.conductivity;
  to.roller = from.conductivity_2 > 0 ? THERMOROLL_CONDUCTING : THERMOROLL_INSULATED;
  to.expansion_2 = from.expansion_2;
  to.conductivity_2 = from.conductivity_2;
  to.diffusivity_2 = from.diffusivity_2;
  to.bulk_temperature = from.bulk_temperature.value_or(std::nan(""));
  to.bulk_temperature_2 = from.bulk_temperature_2.value_or(std::nan(""));
  if (from.law) set_law(*from.law, to);
}

thermoroll_scene in_c(const GivenScene& from) {
  thermoroll_scene to;
  thermoroll_scene_init(&to, sizeof to);
  to.friction = from.scene.friction;
  to.given = from.given.value;
  const bool by_border = from.given.quantity == Quantity::stick_slip_border;
  to.quantity = from.given.quantity == Quantity::traction ? THERMOROLL_TRACTION
                : by_border                               ? THERMOROLL_STICK_SLIP_BORDER
                : from.unit == CreepUnit::ratio           ? THERMOROLL_CREEP_RATIO
                                                          : THERMOROLL_CREEP;
  const Direction direction = from.physical ? from.physical->direction : from.scene.direction;
  if (by_border) to.direction = static_cast<int32_t>(direction);
  to.branch = static_cast<int32_t>(from.given.branch);
  to.method = static_cast<int32_t>(from.approach.method);
  to.formulation = static_cast<int32_t>(from.approach.formulation);
  to.tolerance = from.approach.tolerance;
  if (from.physical)
    set_physical(*from.physical, to);
  else
    set_groups(from.scene, to);
  return to;
}

/// The scene solved by the library; nothing where it has no answer that is a contact.
std::optional<Solution> solved(const GivenScene& given) {
  try {
    const Solution x = solve_scene(given).solution;
    if (x.violations.empty()) return x;
  } catch (const std::runtime_error&) {
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

thermoroll_result answer_in_c(const thermoroll_scene& scene) {
  thermoroll_result result{};
  result.size = sizeof result;
  thermoroll_solve(&scene, &result, 1, 1);
  return result;
}

/// The temperature where the surface is hottest, and below.
void examine_places(const Record& record, thermoroll_scene scene, const thermoroll_result& told) {
  scene.places = THERMOROLL_AS_GIVEN;
  thermoroll_result result{};
  result.size = sizeof result;
  thermoroll_point points[2]{};
  points[0].size = sizeof points[0];
  points[0].s = points[1].s = told.value.max_temperature_at;
  points[1].depth = 0.01;
  if (thermoroll_profile(&scene, &result, points, 2) != THERMOROLL_DONE)
    return record.beside("temperatures in C", "not resolved");
  const double off = points[0].temperature - told.value.max_temperature;
  record.within("the hottest point in C is the hottest", off, points[0].temperature_error);
  // A colder body above may leave it warmer below the surface.
  if (scene.bulk_difference != 0 || std::isfinite(scene.bulk_temperature_2)) return;
  record.within("below the hottest point it is no hotter",
                std::max(points[1].temperature - points[0].temperature, 0.0),  // or NaN
                10 * (points[0].temperature_error + points[1].temperature_error));
}

}  // namespace

void examine_in_c(const Record& record, const GivenScene& given) {
  const std::optional<Solution> x = solved(given);
  const thermoroll_scene scene = in_c(given);
  const thermoroll_result found = answer_in_c(scene);
  record.require("C answers where the library does",
                 x.has_value() == (found.status == THERMOROLL_DONE));
  record.require("C has results or NaN", x.has_value() == std::isfinite(found.value.creep));
  if (!x) return;
  record.require("C has the numbers of the library",
                 std::memcmp(&found.value, x->value.data(),
                             sizeof(double) * Results::SizeAtCompileTime) == 0 &&
                     std::memcmp(&found.error, x->error->data(),
                                 sizeof(double) * Results::SizeAtCompileTime) == 0);
  examine_places(record, scene, found);
}

void examine_row(const Record& record, const std::string& options, std::uint64_t number,
                 const GivenScene& given) {
  TableOptions how;
  how.constants = {{"method", "coupled"}};
  how.columns = {"id"};
  std::string header = "id", line = "\"a, \"\"b\"\"\"", option, value;
  std::istringstream words(options);
  for (std::uint64_t bits = number / 2; words >> option >> value; bits /= 2) {
    option.erase(0, 2);
    if (bits % 2 == 1) {
      how.constants.push_back({option, value});
      continue;
    }
    header += ',' + option;
    line += ',' + value;
    how.columns.push_back(option);
  }
  for (const char* result : {"load_ratio", "max_temperature", "error_estimate.max_temperature"})
    how.columns.emplace_back(result);
  how.columns.emplace_back("status");
  const SweepTable table = table_of(header, how);
  const SweepRow row = answer(table, line);
  const std::optional<Solution> x = solved(given);
  record.require("a row is solved where the library does it", x.has_value() == row.solved);
  if (!x) return;
  std::vector<std::string> cells;
  read_cells(row.text.substr(0, row.text.size() - 1), cells);
  const auto number_at = [&](std::size_t from_end) {
    return std::strtod(cells.at(cells.size() - from_end).c_str(), nullptr);
  };
  record.require("a row has the numbers of the library",
                 number_at(4) == x->value(Quantity::load_ratio) &&
                     number_at(3) == x->value(Quantity::max_temperature) &&
                     number_at(2) == (*x->error)(Quantity::max_temperature));
  const Quantity prescribed = given.given.quantity;
  how.given = prescribed == Quantity::traction ? "traction"
              : prescribed == Quantity::creep  ? "creep"
                                               : "stick-slip-border";
  const std::string names = header_of(table);
  const SweepRow again = answer(table_of(names.substr(0, names.size() - 1), how),
                                row.text.substr(0, row.text.size() - 1));
  record.require("a row that is read again is the same", again.text == row.text);
}

void examine_law(const Record& record, const GivenScene& given) {
  thermoroll_scene scene = in_c(given);
  const thermoroll_result found = answer_in_c(scene);
  if (found.status != THERMOROLL_DONE) return;
  const double creep = found.physical.creep_ratio;
  // With the sign as printed heat may turn the creep against the traction, and a law of creeps has
  // the solution that pulls with this creep.
  if (creep * found.physical.tangential_load < 0 &&
      given.approach.formulation == Formulation::printed)
    return record.beside("a law", "the creep is against the traction");
  scene.tolerance = 1e-3;
  thermoroll_law_info info{};
  info.size = sizeof info;
  thermoroll_law* law = thermoroll_law_new(&scene, std::numeric_limits<double>::infinity(), &info);
  if (law == nullptr) return record.beside("a law", thermoroll_message(info.status));
  thermoroll_law_value at{};
  at.size = sizeof at;
  const int status = thermoroll_law_evaluate(law, &creep, &at, 1);
  thermoroll_law_free(law);
  if (status != THERMOROLL_DONE) return record.beside("a law", "ends before the scene");
  const thermoroll_physical& error = found.physical_error;
  record.within(
      "the law is where the scene is", at.traction - found.physical.tangential_load,
      10 * (at.traction_error + error.tangential_load + std::abs(at.slope) * error.creep_ratio));
  record.within("the law is as hot as the scene",
                at.max_temperature - found.physical.max_temperature_celsius,
                10 * (at.max_temperature_error + error.max_temperature_celsius));
}

}  // namespace soak
