#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/command_definitions.h"
#include "app/command_words.h"
#include "app/json_text.h"
#include "base/errors.h"
#include "base/text.h"

namespace knitmech::app {
namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  knitmech ui                            open the page in the browser\n"
    "  knitmech new jersey.toml               write a commented case file\n"
    "  knitmech check jersey.toml             see what would be run\n"
    "  knitmech run jersey.toml               simulate; leaves results/jersey\n"
    "  knitmech run --resume results/jersey   go on with a run that was interrupted\n"
    "  knitmech study study.toml              run many cases; leaves one table\n"
    "  knitmech render results/jersey --strain 0.16 --colour contact\n"
    "  knitmech render results/jersey --animate stretch -o jersey.webp\n"
    "  knitmech export jersey.toml -f abaqus -o jersey.inp\n"
    "  knitmech yarn tensile.csv --diameter \"0.12 mm\" --density \"1140 kg/m^3\"\n"
    "  knitmech compare results/jersey fabric.csv --gauge-length \"100 mm\" --width \"50 mm\"\n"
    "  knitmech parameters                    every key of a case file\n"
    "  knitmech man | man -l -                the manual page\n"
    "  source <(knitmech completion bash)     complete commands with the Tab key\n"
    "\n"
    "Exit codes: 0 done, 2 wrong input, 3 the simulation could not be finished, 4 files.";

/// What stands without a name and what the types of options are called tells which files are meant.
ValueKind kind_of(const std::string& value, std::string& extension) {
  static const std::map<std::string, std::string> kExtensions{{"CASE", "toml"}, {"STUDY", "toml"}, {"CURVE", "csv"},
                                                              {"DECK", "inp"},  {"FILE", ""},      {"CASE_OR_RUN", ""}};
  if (value == "RUN" || value == "FOLDER") return ValueKind::folder;
  const auto found = kExtensions.find(value);
  if (found == kExtensions.end()) return ValueKind::other;
  extension = found->second;
  return ValueKind::file;
}

OptionWords words_of(const CLI::Option& option) {
  OptionWords words{.help = option.get_description(), .is_required = option.get_required()};
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  if (option.get_type_size() == 0) return words;
  // "TEXT:{stretch,turn}", "INT:INT in [1 - 1024]"
  const std::string type = option.get_type_name();
  const auto colon = type.find(':');
  words.value = words.names.empty() ? option.get_name(true) : type.substr(0, colon);
  words.kind = kind_of(words.value, words.extension);
  if (colon != std::string::npos && type[colon + 1] == '{') {
    words.kind = ValueKind::choice;
    std::istringstream choices(type.substr(colon + 2, type.size() - colon - 3));
    for (std::string choice; std::getline(choices, choice, ',');) words.choices.push_back(choice);
  }
  return words;
}

ProgramWords words_of(const CLI::App& app) {
  ProgramWords program{KNITMECH_VERSION, app.get_description(), app.get_footer(), {}};
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    CommandWords words{command->get_name(), command->get_description(), command->get_footer(), {}};
    for (const CLI::Option* option : command->get_options()) words.options.push_back(words_of(*option));
    program.commands.push_back(std::move(words));
  }
  return program;
}

/// The two commands that tell of the command line itself.
void add_words(CLI::App& app, Action& action) {
  CLI::App& completion = *app.add_subcommand("completion", "Write a script that completes the command line in a shell");
  auto shell = std::make_shared<std::string>();
  completion.add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  completion.callback([&app, &action, shell] {
    action = [&app, shell] {
      const ProgramWords words = words_of(app);
      std::cout << (*shell == "bash"  ? bash_completion(words)
                    : *shell == "zsh" ? zsh_completion(words)
                                      : fish_completion(words))
                << std::flush;
      return kDone;
    };
  });
  CLI::App& manual = *app.add_subcommand("man", "Write the manual page, as knitmech man | man -l -");
  manual.callback([&app, &action] {
    action = [&app] {
      std::cout << manual_page(words_of(app)) << std::flush;
      return kDone;
    };
  });
}

ExitCode report(bool as_json, ExitCode code, const std::string& text, const std::string& json) {
  std::cerr << (as_json ? json : fmt::format("knitmech: error: {}", text)) << '\n';
  return code;
}

ExitCode run_action(const Action& action, bool as_json) {
  try {
    const ExitCode code = action();
    if (std::fflush(stdout) != 0 || !std::cout) throw FileError("cannot write to standard output");
    return code;
  } catch (const InputError& error) {
    return report(as_json, kWrongInput, error.what(), error_json(error, kWrongInput));
  } catch (const FileError& error) {
    return report(as_json, kFileTrouble, error.what(), error_json(error, kFileTrouble));
  } catch (const std::system_error& error) {
    // The standard library's own, for instance a folder that may not be looked into.
    return report(as_json, kFileTrouble, error.what(), error_json(error, kFileTrouble));
  } catch (const std::bad_alloc&) {
    const InputError error("the memory of this computer is too small for the model; take fewer stitches or elements");
    return report(as_json, kWrongInput, error.what(), error_json(error, kWrongInput));
  }
}

/// What is wrong with a word that stands where the command should be; empty if nothing is.
std::string complaint_about_command(const CLI::App& app, std::string_view word) {
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  std::vector<std::string_view> names;
  names.reserve(commands.size());
  for (const CLI::App* command : commands) names.emplace_back(command->get_name());
  if (word.starts_with('-') || std::ranges::find(names, word) != names.end()) return {};
  const std::string_view nearest = base::nearest_word(word, names);
  const std::string advice = nearest.empty() ? fmt::format("the commands are {}", base::alternatives(names))
                                             : fmt::format("did you mean {}?", nearest);
  return fmt::format("there is no command {}; {}", base::in_quotes(word), advice);
}

std::string usage_complaint(const CLI::App& app, const CLI::ParseError& error, const char* first_word) {
  std::string complaint = first_word == nullptr ? "" : complaint_about_command(app, first_word);
  if (!complaint.empty()) return complaint;
  const auto chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "knitmech" : "knitmech " + chosen.front()->get_name();
  return fmt::format("{}; see {} --help", error.what(), command);
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App app(
      "KnitMech computes the mechanics of knitted fabrics, yarn by yarn: from the measured loop to the\n"
      "force-strain curve.");
  app.name("knitmech");
  app.require_subcommand(1);
  app.set_version_flag("--version", "knitmech " KNITMECH_VERSION);

  Action action;
  define_commands(app, action);
  add_words(app, action);
  app.footer(kExamples);  // after the commands, which would take it over

  const bool as_json = std::find(argv, argv + argc, std::string_view("--json")) != argv + argc;
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::ParseError& error) {
    const InputError complaint(usage_complaint(app, error, argc > 1 ? argv[1] : nullptr));
    return report(as_json, kWrongInput, complaint.what(), error_json(complaint, kWrongInput));
  }
  return run_action(action, as_json);
}

}  // namespace knitmech::app
