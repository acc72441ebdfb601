// Tangled from paper/B-command-line.md, paper/C-output.md; edit there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "thermoroll/solution.hpp"

namespace thermoroll {

/// A word of the command line and its value.
template <class T>
struct Name {
  const char* word;
  T value;
};

inline constexpr Name<Method> method_names[] = {{"auto", Method::automatic},
                                                {"closed-form", Method::closed_form},
                                                {"first-order", Method::first_order},
                                                {"coupled", Method::coupled},
                                                {"gauss-chebyshev", Method::gauss_chebyshev}};
inline constexpr Name<Model> model_names[] = {{"closed-form", Model::closed_form},
                                              {"first-order", Model::first_order},
                                              {"coupled", Model::coupled}};
inline constexpr Name<Formulation> formulation_names[] = {{"printed", Formulation::printed},
                                                          {"corrected", Formulation::corrected}};

enum class RollerKind { insulated, identical, conducting };
inline constexpr Name<RollerKind> roller_names[] = {{"insulated", RollerKind::insulated},
                                                    {"identical", RollerKind::identical},
                                                    {"conducting", RollerKind::conducting}};
inline constexpr Name<Direction> direction_names[] = {{"driving", Direction::driving},
                                                      {"braking", Direction::braking}};

inline constexpr Name<std::optional<LawKind>> law_names[] = {
    {"constant", std::nullopt},
    {"linear", LawKind::linear},
    {"exponential", LawKind::exponential},
    {"rational", LawKind::rational},
    {"piecewise-linear", LawKind::piecewise_linear}};
inline constexpr Name<Branch> branch_names[] = {{"rising", Branch::rising},
                                                {"falling", Branch::falling}};

enum class Format { text, json, csv };
inline constexpr Name<Format> format_names[] = {
    {"text", Format::text}, {"json", Format::json}, {"csv", Format::csv}};

enum class HelpFormat { text, man, bash };
inline constexpr Name<HelpFormat> help_format_names[] = {
    {"text", HelpFormat::text}, {"man", HelpFormat::man}, {"bash", HelpFormat::bash}};

enum class RowFormat { csv, jsonl };
inline constexpr Name<RowFormat> row_format_names[] = {{"csv", RowFormat::csv},
                                                       {"jsonl", RowFormat::jsonl}};

/// The value of a word that is one of the names.
template <class T, std::size_t n>
T value_of(const Name<T> (&names)[n], const std::string& word) {
  const auto is_it = [&](const Name<T>& name) { return name.word == word; };
  return std::find_if(std::begin(names), std::end(names), is_it)->value;
}

/// The word for a value, and all words in order.
template <class T, std::size_t n>
std::string name_of(const Name<T> (&names)[n], T value) {
  const auto is_it = [&](const Name<T>& name) { return name.value == value; };
  return std::find_if(std::begin(names), std::end(names), is_it)->word;
}

template <class T, std::size_t n>
std::vector<std::string> words(const Name<T> (&names)[n]) {
  std::vector<std::string> list;
  for (const Name<T>& name : names) list.emplace_back(name.word);
  return list;
}

}  // namespace thermoroll
