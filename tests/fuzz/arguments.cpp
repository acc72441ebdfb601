// The command line: one argument a line. It is read, and so are the scene and the points in it;
// none of it is solved.
#include <sstream>
#include <stdexcept>
#include <vector>

#include "fuzz.hpp"
#include "program/command.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream text(std::string(data, data + size));
  std::vector<std::string> arguments;
  for (std::string line; std::getline(text, line);) {
    if (line.find('/') != std::string::npos) return 0;  // no files elsewhere
    arguments.push_back(line);
  }
  fuzz::done_or_refused<std::invalid_argument>([&] {
    const thermoroll::Command c = thermoroll::read_command(arguments);
    if (c.subcommand.empty() == c.text.empty()) fuzz::fail("neither a subcommand nor a text");
    if (c.subcommand == "temperature" &&
        (thermoroll::read_points("at", c.options.at).empty() ||
         thermoroll::read_points("depth", c.options.depth).empty()))
      fuzz::fail("no points");
    if (c.subcommand == "temperature" || c.subcommand == "solve")
      thermoroll::read_scene(c.options.of_scene);
  });
  return 0;
}
