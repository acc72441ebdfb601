// Tangled from paper/B-command-line.md; edit there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "thermoroll/scene.hpp"
#include "thermoroll/solution.hpp"

namespace CLI {  // named only, as CLI11 takes seconds to compile wherever it is included
class App;
class Option;
class ParseError;
class Validator;
}  // namespace CLI

namespace thermoroll {

using Maybe = std::optional<double>;

struct SceneOptions {
  Maybe friction;
  Maybe traction, creep, border, creep_ratio, tangential_load;
  Maybe peclet, heating;
  Maybe load, speed, shear_modulus, poisson, expansion, diffusivity, conductivity;
  Maybe half_width, radius;
  std::string roller = "insulated", direction;
  Maybe conductivity_ratio, heating_2, peclet_2;
  Maybe conductivity_2, expansion_2, diffusivity_2;
  std::string friction_law = "constant", branch;
  Maybe friction_temperature, friction_floor, friction_reference_temperature;
  Maybe bulk_temperature, bulk_temperature_2, bulk_difference;
  Approach approach;
  std::optional<int> nodes;
  Maybe tolerance;
};

/// Whether two bulk temperatures that differ are given, or a difference that is not zero.
inline bool two_bulks(const SceneOptions& o) {
  return o.bulk_difference.value_or(0) != 0 ||
         (o.bulk_temperature_2 && o.bulk_temperature_2 != o.bulk_temperature);
}

/// Declare the options of a scene, which CLI11 will write to o.
void add_scene_options(CLI::App& command, SceneOptions& o);

/// Whether an option, named without its hyphens, stands for data in SI units; for a dimensionless
/// group in their place; for data of the roller; or for one of the quantities that prescribe.
bool is_si_option(const std::string& name);
bool is_group_option(const std::string& name);
bool is_roller_option(const std::string& name);
bool is_given_option(const std::string& name);

/// Whether a scene has one of both at most: what prescribes its state, or the size of its contact.
bool exclude_each_other(const std::string& a, const std::string& b);

/// The options that every scene in SI units has, and those that prescribe, without their hyphens.
std::vector<std::string> data_in_si_units();
std::vector<std::string> given_names();

/// The unit of an option that is a number, "1" if it has none; empty if there is no such option.
std::string unit_of_option(const std::string& name);

/// The scene that the options describe. Throws std::invalid_argument.
GivenScene read_scene(const SceneOptions& o);

/// The number that a text is as a whole, if it is finite.
std::optional<double> to_number(const std::string& text);

/// Validators for the texts of numbers, in a unit, and words, given to the option of this name.
/// They throw std::invalid_argument.
CLI::Validator finite_number(const std::string& name, const std::string& unit = "NUMBER");
CLI::Validator whole_number(const std::string& name);
CLI::Validator not_empty(const std::string& name, const std::string& allowed);
CLI::Validator file_name(const std::string& name);
CLI::Validator one_of(const std::string& name, const std::vector<std::string>& words);

/// An option for a finite number.
CLI::Option* add_number(CLI::App& command, const std::string& name, Maybe& value,
                        const std::string& meaning, const std::string& unit = "NUMBER");

/// The name that is nearest to a word by the distance of @eq:edit-distance, or the first such name;
/// empty if none is near enough to be meant: a fifth of the letters may be wrong, or one of three.
std::string nearest(const std::string& word, const std::vector<std::string>& names);

/// A name with hyphens for underscores.
std::string hyphenated(std::string name);

/// Words with a text between any two of them.
std::string joined(const std::vector<std::string>& words, const std::string& between);

/// The substitute for an option that there is not, as "--radius-2"; or nothing.
std::string instead_of(const std::string& name);

/// One line for a mistake in the options of app.
std::string reworded(const CLI::ParseError& error, const CLI::App& app);

}  // namespace thermoroll
