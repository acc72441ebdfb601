// Tangled from paper/B-command-line.md; edit there.
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "program/scene_options.hpp"
#include "program/table.hpp"

namespace thermoroll {

/// The options of the subcommands.
struct Options {
  SceneOptions of_scene;
  std::string config;
  std::string at = "-1.5:4:551", depth = "0";
  std::string name, times, format = "text", language = "c", help = "text", output, profile;
  std::optional<int> profile_points;
  Maybe from, to, from_ratio, to_ratio, to_speed;
  int points = 101;
  std::optional<int> jobs;
  std::string table, columns, keep, rows_format = "csv", resume, part, package;
  TableOptions of_table;
  bool list = false, verbose = false, trace = false;
};

/// A command line as read: a subcommand with its options or, where that is empty, a text and the
/// file that it is for.
struct Command {
  std::string subcommand;
  Options options;
  std::string text, file;
};

/// Read a command line, without the program's name, and the scene file that it names. Throws
/// std::invalid_argument.
Command read_command(const std::vector<std::string>& arguments);

/// Execute a command line, answers and notes included. Throws std::exception.
void run(const Command& c);

/// The points that the text of an option describes, "A:B:N" or "A,B,...". Throws
/// std::invalid_argument.
std::vector<double> read_points(const std::string& name, const std::string& text);

/// The version and, where it is known, the revision: "0.2.0 (6d936e9)". The build writes the body.
const char* version();

}  // namespace thermoroll
