#pragma once
// One subcommand of the tool, and the table that `main` walks.

#include "bake/error.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <memory>
#include <span>

namespace reliefbake {

/// A subcommand: an options struct filled by CLI11, and the work. Made only when its name stands on the
/// command line's parser, run at most once.
class Command {
  public:
    virtual ~Command() = default;

    /// Declares every option; a value that cannot be right alone is refused here.
    virtual void add_to(CLI::App& app) = 0;

    /// Refuses options that do not fit each other, then works. What a script reads goes to stdout; stderr
    /// stays empty unless something is wrong. An error's message is printed by `main`, its code is the exit
    /// status.
    virtual Result<void> run() = 0;
};

struct CommandEntry {
    const char* path;    ///< "cone", or "bench cone" for a command inside a group
    const char* summary; ///< one line of --help
    std::unique_ptr<Command> (*make)();
};

/// All subcommands, in the order of --help.
std::span<const CommandEntry> commands();

} // namespace reliefbake
