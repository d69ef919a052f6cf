#pragma once

namespace knitmech::app {

/// Reads the command line, runs its command and reports every error on standard error, as JSON if --json is there.
/// @return the exit code, see ExitCode
int run_command_line(int argc, char** argv);

}  // namespace knitmech::app
