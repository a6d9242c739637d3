#pragma once
// The flags that say what a map's file does not: shared by explain, render and verify.

#include "formats/map_file.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace reliefbake {

/// Adds --encoding --metric --surface --wrap --cone-max --normal-y --depth-uv --channel-order
/// --alpha-is-height --relief --level --max-bytes; those given win over the file's metadata.
void add_map_hints(CLI::App& app, MapHints& hints);

} // namespace reliefbake
