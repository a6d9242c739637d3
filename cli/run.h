#pragma once
// From a command line to an exit status.

namespace reliefbake {

/// Parses the command line and runs the subcommand it names. Returns the exit status: 0, or an ErrorCode;
/// every error leaves one line on stderr. --help and --version print to stdout and return 0.
int run_command_line(int argc, char** argv) noexcept;

} // namespace reliefbake
