#pragma once

#include <functional>

#include "app/commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace knitmech::app {

/// The command that the command line asks for, once it is read.
using Action = std::function<ExitCode()>;

/// Adds all commands with their options. Reading a command line with `app` then sets `action`, which outlives it.
void define_commands(CLI::App& app, Action& action);

}  // namespace knitmech::app
