#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "app/command_words.h"

namespace knitmech::app {
namespace {

/// Text as roff takes it: a hyphen that is typed is not one that is read, and a line must not begin with a point.
std::string in_roff(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    const bool begins_line = result.empty() || result.back() == '\n';
    if (begins_line && (letter == '.' || letter == '\'')) result += "\\&";
    if (letter == '\\') {
      result += "\\e";
    } else if (letter == '-') {
      result += "\\-";
    } else {
      result += letter;
    }
  }
  return result;
}

std::string head_of(const OptionWords& option) {
  std::string value = option.value.empty() ? "" : "\\fI" + in_roff(option.value) + "\\fR";
  if (option.names.empty()) return value;
  std::string text;
  for (const std::string& name : option.names) {
    text += (text.empty() ? "\\fB" : ", \\fB") + in_roff(name) + "\\fR";
  }
  return value.empty() ? text : text + " " + value;
}

std::string section_of(const CommandWords& command) {
  std::string text = fmt::format(".SS \"{}", in_roff(command.name));
  for (const OptionWords& option : command.options) {
    if (option.names.empty())
      text += fmt::format(fmt::runtime(option.is_required ? " {}" : " [{}]"), in_roff(option.value));
  }
  text += fmt::format(" [options]\"\n{}.\n", in_roff(command.help));
  for (const OptionWords& option : command.options) {
    text +=
        fmt::format(".TP\n{}\n{}{}.\n", head_of(option), in_roff(option.help), option.is_required ? " (required)" : "");
    if (!option.choices.empty())
      text += fmt::format("One of: {}.\n", in_roff(fmt::format("{}", fmt::join(option.choices, ", "))));
  }
  if (!command.footer.empty())
    text += ".PP\n.nf\n" + in_roff(command.footer) + (command.footer.ends_with('\n') ? "" : "\n") + ".fi\n";
  return text;
}

/// Lines of the footer of the program between "Examples:" and the exit codes.
std::string examples_in(const std::string& footer) {
  std::string examples;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  ")) examples += line.substr(2) + "\n";
  }
  return examples;
}

constexpr const char* kExitStatus = R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 2
Wrong input: the command line, a case file, a curve, a deck.
.TP
.B 3
The simulation was interrupted or could not be finished; what was computed is kept.
.TP
.B 4
A file cannot be read or written.
)";

}  // namespace

std::string manual_page(const ProgramWords& program) {
  std::string text = fmt::format(".TH KNITMECH 1 \"\" \"KnitMech {}\" \"User Commands\"\n", in_roff(program.version));
  text += ".SH NAME\nknitmech \\- mechanics of knitted fabrics, yarn by yarn\n";
  text += ".SH SYNOPSIS\n.B knitmech\n.I command\n[options]\n";
  text += fmt::format(
      ".SH DESCRIPTION\n{}\n.PP\nErrors go to standard error as one sentence, or with \\fB\\-\\-json\\fR as JSON.\n",
      in_roff(program.about));
  text += ".SH COMMANDS\n";
  for (const CommandWords& command : program.commands) text += section_of(command);
  text += kExitStatus;
  text += ".SH EXAMPLES\n.nf\n" + in_roff(examples_in(program.footer)) + ".fi\n";
  return text;
}

}  // namespace knitmech::app
