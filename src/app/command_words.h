#pragma once

#include <string>
#include <vector>

namespace knitmech::app {

/// What may stand for a value on the command line.
enum class ValueKind { other, choice, file, folder };

/// An option of a command, or what stands without a name.
struct OptionWords {
  std::vector<std::string> names{};  ///< "-o", "--output"; empty for what stands without a name
  std::string value{};               ///< "FILE", "CASE"; empty for a flag
  ValueKind kind = ValueKind::other;
  std::string extension{};             ///< of the files that are meant, without the dot; empty: any
  std::vector<std::string> choices{};  ///< of a choice
  std::string help{};
  bool is_required = false;
};

/// A command as the help knows it: what completions and the manual page are made of.
struct CommandWords {
  std::string name, help, footer;
  std::vector<OptionWords> options;  ///< those with a name, and what stands without one
};

/// The whole command line.
struct ProgramWords {
  std::string version, about;
  std::string footer;  ///< examples and exit codes
  std::vector<CommandWords> commands;
};

/// Scripts that complete the command line in a shell; each is read by its shell as it stands.
[[nodiscard]] std::string bash_completion(const ProgramWords& program);
[[nodiscard]] std::string zsh_completion(const ProgramWords& program);
[[nodiscard]] std::string fish_completion(const ProgramWords& program);

/// The manual page knitmech(1), for man.
[[nodiscard]] std::string manual_page(const ProgramWords& program);

}  // namespace knitmech::app
