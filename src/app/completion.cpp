#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "app/command_words.h"

namespace knitmech::app {
namespace {

std::vector<std::string> command_names(const ProgramWords& program) {
  std::vector<std::string> names;
  for (const CommandWords& command : program.commands) names.push_back(command.name);
  return names;
}

std::vector<std::string> option_names(const CommandWords& command) {
  std::vector<std::string> names;
  for (const OptionWords& option : command.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// Text within single quotes of a shell that takes '\'' for one (bash, zsh).
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) {
    if (letter == '\'') {
      result += "'\\''";
    } else {
      result += letter;
    }
  }
  return result + "'";
}

/// The bash command that sets the answer for a value.
std::string bash_answer(const OptionWords& option) {
  switch (option.kind) {
    case ValueKind::choice:
      return fmt::format("_knitmech_words \"{}\"", fmt::join(option.choices, " "));
    case ValueKind::file:
      return fmt::format("_knitmech_files \"{}\"", option.extension);
    case ValueKind::folder:
      return "_knitmech_folders";
    case ValueKind::other:
      break;
  }
  return "COMPREPLY=()";
}

/// "run -o|run --output) ...;;" for each option of a command that takes a value.
std::string bash_values(const CommandWords& command) {
  std::string text;
  for (const OptionWords& option : command.options) {
    if (option.names.empty() || option.value.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) patterns.push_back(fmt::format("\"{} {}\"", command.name, name));
    text += fmt::format("    {}) {}; return ;;\n", fmt::join(patterns, "|"), bash_answer(option));
  }
  return text;
}

/// What stands without a name; empty if nothing does.
std::string bash_rest(const CommandWords& command) {
  for (const OptionWords& option : command.options) {
    if (option.names.empty()) return fmt::format("    {}) {} ;;\n", command.name, bash_answer(option));
  }
  return {};
}

constexpr const char* kBashHead =
    R"(# Completion of the knitmech command line for bash: source this file, or put it where bash-completion finds it.
_knitmech_words() { COMPREPLY=($(compgen -W "$1" -- "$current")); }
_knitmech_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$current")
}
# Files with an extension, or all, and the folders on the way to them.
_knitmech_files() {
  compopt -o filenames 2>/dev/null
  if [[ -n $1 ]]; then
    mapfile -t COMPREPLY < <(compgen -f -X "!*.$1" -- "$current"; compgen -d -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}
)";

/// How zsh's _arguments takes a value.
std::string zsh_answer(const OptionWords& option) {
  switch (option.kind) {
    case ValueKind::choice:
      return fmt::format("({})", fmt::join(option.choices, " "));
    case ValueKind::file:
      return option.extension.empty() ? "_files" : fmt::format("_files -g \"*.{}\"", option.extension);
    case ValueKind::folder:
      return "_files -/";
    case ValueKind::other:
      break;
  }
  return " ";
}

/// Text in a specification of _arguments: brackets and colons have a meaning there.
std::string for_zsh(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '[' || letter == ']' || letter == ':' || letter == '\\') result += '\\';
    result += letter;
  }
  return result;
}

std::string zsh_option(const OptionWords& option) {
  if (option.names.empty())
    return fmt::format("    {}\n", quoted(fmt::format("*:{}:{}", option.value, zsh_answer(option))));
  std::string text;
  for (const std::string& name : option.names) {
    const std::string value =
        option.value.empty() ? "" : fmt::format(":{}:{}", for_zsh(option.value), zsh_answer(option));
    text += fmt::format("    {}\n", quoted(fmt::format("{}[{}]{}", name, for_zsh(option.help), value)));
  }
  return text;
}

/// Text within single quotes of fish, which takes \' and \\.
std::string for_fish(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) {
    if (letter == '\'' || letter == '\\') result += '\\';
    result += letter;
  }
  return result + "'";
}

std::string fish_answer(const OptionWords& option) {
  switch (option.kind) {
    case ValueKind::choice:
      return fmt::format(" -x -a {}", for_fish(fmt::format("{}", fmt::join(option.choices, " "))));
    case ValueKind::file:
      return option.extension.empty() ? " -r -F"
                                      : fmt::format(" -x -a '(__fish_complete_suffix .{})'", option.extension);
    case ValueKind::folder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::other:
      break;
  }
  return option.value.empty() ? "" : " -x";
}

std::string fish_option(const std::string& command, const OptionWords& option) {
  std::string line = fmt::format("complete -c knitmech -n '__fish_seen_subcommand_from {}'", command);
  for (const std::string& name : option.names) {
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  return line + fish_answer(option) + " -d " + for_fish(option.help) + "\n";
}

}  // namespace

std::string bash_completion(const ProgramWords& program) {
  std::string values, names, rest;
  for (const CommandWords& command : program.commands) {
    values += bash_values(command);
    names += fmt::format("      {}) _knitmech_words \"{}\" ;;\n", command.name, fmt::join(option_names(command), " "));
    rest += bash_rest(command);
  }
  return std::string(kBashHead) + fmt::format(
                                      "_knitmech() {{\n"
                                      "  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - "
                                      "1]}} command=${{COMP_WORDS[1]}}\n"
                                      "  COMPREPLY=()\n"
                                      "  if ((COMP_CWORD == 1)); then\n"
                                      "    _knitmech_words \"{} --help --version\"\n"
                                      "    return\n"
                                      "  fi\n"
                                      "  case \"$command $previous\" in\n{}  esac\n"
                                      "  if [[ $current == -* ]]; then\n"
                                      "    case $command in\n{}    esac\n"
                                      "    return\n"
                                      "  fi\n"
                                      "  case $command in\n{}  esac\n"
                                      "}}\n"
                                      "complete -F _knitmech knitmech\n",
                                      fmt::join(command_names(program), " "), values, names, rest);
}

std::string zsh_completion(const ProgramWords& program) {
  std::string list, cases;
  for (const CommandWords& command : program.commands) {
    list += fmt::format("    {}\n", quoted(command.name + ":" + command.help));
    cases += fmt::format("    {}) _arguments -s \\\n", command.name);
    std::string options;
    for (const OptionWords& option : command.options) options += zsh_option(option);
    for (std::size_t i = 0; i + 1 < options.size(); ++i) {
      cases += options[i] == '\n' ? std::string(" \\\n") : std::string(1, options[i]);
    }
    cases += " ;;\n";
  }
  return fmt::format(
      "#compdef knitmech\n"
      "# Completion of the knitmech command line for zsh: put this file as _knitmech into a folder of $fpath.\n"
      "_knitmech() {{\n"
      "  local -a commands\n"
      "  commands=(\n{}  )\n"
      "  if ((CURRENT == 2)); then\n"
      "    _describe command commands\n"
      "    return\n"
      "  fi\n"
      "  local command=$words[2]\n"
      "  shift words\n"
      "  ((CURRENT--))\n"
      "  case $command in\n{}  esac\n"
      "}}\n"
      "if [[ $funcstack[1] == _knitmech ]]; then _knitmech \"$@\"; else compdef _knitmech knitmech; fi\n",
      list, cases);
}

std::string fish_completion(const ProgramWords& program) {
  const std::vector<std::string> names = command_names(program);
  std::string text =
      "# Completion of the knitmech command line for fish: put this file into ~/.config/fish/completions.\n"
      "complete -c knitmech -f\n";
  for (const CommandWords& command : program.commands) {
    text += fmt::format("complete -c knitmech -n 'not __fish_seen_subcommand_from {}' -a {} -d {}\n",
                        fmt::join(names, " "), command.name, for_fish(command.help));
    for (const OptionWords& option : command.options) text += fish_option(command.name, option);
  }
  return text;
}

}  // namespace knitmech::app
