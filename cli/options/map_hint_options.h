#pragma once
// The flags that say what a map's file does not: shared by explain, render and verify.

#include "formats/map_file.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace reliefbake {

/// Adds --encoding --metric --surface --wrap --cone-max --normal-y --depth-uv --channel-order
/// --alpha-is-height --holes --relief --level --max-bytes; those given win over the file's metadata.
void add_map_hints(CLI::App& app, MapHints& hints);

/// Refuses (usage) hints, but the byte budget, for a file of a kind that always says what it means.
Result<void> refuse_hints(const MapHints& hints, const std::string& file, const std::string& kind);

} // namespace reliefbake
