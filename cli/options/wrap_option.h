#pragma once
// --wrap: one word for both axes, or X,Y.

#include "bake/height_field.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <optional>
#include <string>

namespace reliefbake {

/// Adds --wrap repeat|clamp|auto or X,Y.
void add_wrap_option(CLI::App& app, WrapChoice& x, WrapChoice& y);

/// The same for a map that lies in a file, where nothing is left to measure: repeat|clamp or X,Y.
void add_wrap_hint(CLI::App& app, std::optional<Wrap>& x, std::optional<Wrap>& y);

/// The same words with another help text, where nothing is measured.
void add_told_wrap(CLI::App& app, std::optional<Wrap>& x, std::optional<Wrap>& y, const std::string& help);

} // namespace reliefbake
