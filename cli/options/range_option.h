#pragma once
// --range: which source values become height 0 and 1.

#include "bake/height_field.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace reliefbake {

/// Adds --range auto|data|LO:HI.
CLI::Option* add_range_option(CLI::App& app, HeightOptions& options);

} // namespace reliefbake
