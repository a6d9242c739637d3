#pragma once
// reliefbake --describe json: every command and option, for man pages, completions and build scripts (cli/schema/describe.schema.json).

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <nlohmann/json.hpp>

namespace reliefbake {

/// The commands below `root` in the order of --help, those of a group ("bench cone") by their whole path. Options in the order in which
/// they were declared.
nlohmann::ordered_json describe(const CLI::App& root);

} // namespace reliefbake
