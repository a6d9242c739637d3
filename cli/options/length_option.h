#pragma once
// Physical lengths: a number and its unit.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <optional>
#include <string>

namespace reliefbake {

/// Adds an option that takes a length > 0 with its unit, mm, cm or m; `metres` receives it in metres.
CLI::Option* add_length(CLI::App& app, const std::string& flag, std::optional<double>& metres,
                        const std::string& help);

} // namespace reliefbake
