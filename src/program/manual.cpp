// Tangled from paper/B-command-line.md; edit there.
#include "program/manual.hpp"

#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>

namespace thermoroll {
namespace {

bool takes_value(const CLI::Option& option) {
  return option.get_type_size() != 0 && !option.get_type_name().empty();
}

std::string roff(const std::string& text) {
  static const std::map<char, std::string> own{{'\\', "\\e"},  {'-', "\\-"},    {'^', "\\(ha"},
                                               {'~', "\\(ti"}, {'\'', "\\(aq"}, {'`', "\\(ga"}};
  std::string escaped = text.find('.') == 0 ? "\\&" : "";
  for (const char c : text) escaped += own.count(c) == 0 ? std::string(1, c) : own.at(c);
  return escaped;
}

std::string options_in_roff(const CLI::App& command) {
  std::string page;
  for (const std::string& group : command.get_groups()) {
    page += ".SS \"" + roff(group) + "\"\n";
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_group() != group) continue;
      page += ".TP\n\\fB" + roff(option->get_name()) + "\\fR";
      if (takes_value(*option)) page += " \\fI" + roff(option->get_type_name()) + "\\fR";
      page += '\n' + roff(option->get_description()) + '\n';
    }
  }
  return page;
}

std::string footer_in_roff(const std::string& footer) {
  std::istringstream lines(footer);
  std::string page;
  bool example = false;
  for (std::string line; std::getline(lines, line);) {
    const bool indented = line.find("  ") == 0;
    if (indented != example) page += indented ? ".PP\n.nf\n" : ".fi\n";
    example = indented;
    page += line.empty() ? ".PP\n" : roff(line) + '\n';
  }
  return example ? page + ".fi\n" : page;
}

constexpr const char* completion_begin = R"(# Completion of thermoroll for bash.
complete_thermoroll() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= i
  [ "$word" != = ] || word=
  [ "$before" != = ] || before=${COMP_WORDS[COMP_CWORD - 2]}
  for i in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case " $commands " in *" $i "*) command=$i && break ;; esac
  done
  local words= files=
  local list=
  case "$command $before" in
)";

constexpr const char* completion_end = R"(  esac
  local IFS=$' \n' done=
  [ -z "$list" ] || [ "${word%,*}" = "$word" ] || done=${word%,*},
  COMPREPLY=($(compgen -P "$done" -W "$words" -- "${word#"$done"}"))
  [ -z "$files" ] || { IFS=$'\n' && COMPREPLY+=($(compgen -f -- "$word")); }
  [ -z "$files" ] || compopt -o filenames 2>/dev/null || :
}
complete -F complete_thermoroll thermoroll
)";

std::string after_options(const CLI::App& app, const std::string& name, const Words& more) {
  std::string cases;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() || !takes_value(*option)) continue;
    std::string type = option->get_type_name(), follows = ":";
    const bool is_word = type.find('|') != std::string::npos;
    std::replace(type.begin(), type.end(), '|', ' ');
    if (is_word) follows = "words='" + type + '\'';
    if (type == "FILE") follows = "files=yes";
    if (more.count(option->get_name()) > 0) {
      follows = "words='" + more.at(option->get_name()) + "'";
      if (type.find(',') != std::string::npos) follows += " list=yes";
    }
    cases.append("  ").append(name).append(" ").append(option->get_name());
    cases.append("') ").append(follows).append(" ;;\n");
  }
  return cases;
}

std::string after_subcommand(const CLI::App& app, const std::string& all) {
  std::string words, more;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_positional()) words += option->get_name() + ' ';
  if (app.get_name() == "figure-data")
    more = R"( words+=$("${COMP_WORDS[0]}" figure-data --list 2>/dev/null))";
  else if (app.get_name() == "help")
    more = " words+='" + all + '\'';
  else if (app.get_option_no_throw("TABLE") != nullptr)
    more = " files=yes";
  return "  '" + app.get_name() + " '*) words='" + words + "--config '" + more + " ;;\n";
}

}  // namespace

std::string manual_page(const CLI::App& program, const Footers& endings,
                        const std::string& version) {
  const std::string number = version.substr(0, version.find(' '));
  std::string page = ".TH THERMOROLL 1 \"\" \"thermoroll " + number + "\" \"User Commands\"\n";
  page += ".SH NAME\nthermoroll \\- " + roff(program.get_description()) + '\n';
  page += ".SH SYNOPSIS\n\\fBthermoroll\\fR \\fISUBCOMMAND\\fR [\\fIOPTION\\fR]...\n";
  page += ".SH DESCRIPTION\n" + footer_in_roff(endings.at("")) + options_in_roff(program);
  for (const CLI::App* command : program.get_subcommands({})) {
    page += ".SH \"thermoroll " + roff(command->get_name()) + "\"\n";
    page += roff(command->get_description()) + ".\n" + options_in_roff(*command);
    page += ".SS \"\"\n" + footer_in_roff(endings.at(command->get_name()));
  }
  return page;
}

std::string bash_completion(const CLI::App& program, const Words& more) {
  std::string all, options, others;
  for (const CLI::App* command : program.get_subcommands({})) all += command->get_name() + ' ';
  for (const CLI::App* command : program.get_subcommands({})) {
    options += after_options(*command, '\'' + command->get_name(), more);
    others += after_subcommand(*command, all);
  }
  std::string begin = completion_begin;
  begin.replace(begin.find("$commands"), 9, all);
  return begin + after_options(program, "*'", more) + options + others + "  *) words='" + all +
         "--help --version --config' ;;\n" + completion_end;
}

}  // namespace thermoroll
