// The scene file, for both subcommands that read one.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "fuzz.hpp"
#include "program/command.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string name =
      std::filesystem::temp_directory_path() / ("thermoroll-fuzz-" + std::to_string(getpid()));
  std::ofstream(name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  for (const char* subcommand : {"solve", "temperature"})
    fuzz::done_or_refused<std::invalid_argument>([&] {
      const thermoroll::Command c = thermoroll::read_command({subcommand, "--config", name});
      if (c.subcommand != subcommand) fuzz::fail("another subcommand: " + c.subcommand);
      thermoroll::read_scene(c.options.of_scene);
    });
  std::remove(name.c_str());
  return 0;
}
