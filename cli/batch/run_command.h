#pragma once
// A subcommand run inside this process.

#include "bake/error.h"
#include "cli/command.h"
#include "cli/command_files.h"

#include <string>
#include <vector>

namespace reliefbake {

struct CommandResult {
    std::string json; ///< what it printed
    std::vector<std::string> warnings;
};

/// Runs the command that `words` name, as a shell would; on this thread, its output taken. Errors: the command's; usage (the
/// parser's refusal); budget (out of memory); internal.
Result<CommandResult> run_command(const std::vector<std::string>& words);

/// The files of such a run. Errors: usage.
Result<CommandFiles> files_of_command(const std::vector<std::string>& words);

} // namespace reliefbake
