#pragma once
// Options of every bake for whoever calls it from a build: -MF, -MT, --if-changed.

#include "bake/error.h"
#include "cli/command_files.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <string>
#include <vector>

namespace reliefbake {

struct BuildOptions {
    std::string depfile, target;
    bool if_changed = false;

    void add_to(CLI::App& app);
    /// Before the bake. Errors: usage (a depfile that would replace an input or the output; options that do not fit each other).
    Result<void> begin(const PlannedCommand& command) const;
    /// After it: the depfile, written atomically. Errors: usage (a name with a line break), cannot_create, write_failed.
    Result<void> end(const PlannedCommand& command) const;
};

/// -MF and -MT as the long options they stand for: CLI11's short options have one letter.
std::vector<std::string> with_long_options(int argc, char** argv);

} // namespace reliefbake
