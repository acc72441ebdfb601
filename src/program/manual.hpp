// Tangled from paper/B-command-line.md; edit there.
#pragma once

#include <map>
#include <string>

namespace CLI {
class App;
}  // namespace CLI

namespace thermoroll {

/// The text that stands below the help of each subcommand, and of the program at "".
using Footers = std::map<std::string, const char*>;

/// The manual page of a program with its subcommands, for the macros man of roff.
std::string manual_page(const CLI::App& program, const Footers& endings,
                        const std::string& version);

/// The words that may follow an option, beside those that it declares, with blanks between them.
using Words = std::map<std::string, std::string>;

/// The completion of its subcommands, options and words, for bash.
std::string bash_completion(const CLI::App& program, const Words& more);

}  // namespace thermoroll
