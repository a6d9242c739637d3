#pragma once
// The command line of `reliefbake shape`, and what the stages take from it.

#include "bake/shape_map.h"
#include "formats/read_image.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <optional>
#include <string>

namespace reliefbake {

/// As given; nothing is defaulted that depends on another option.
struct ShapeCommandOptions {
    std::string input;  ///< IN
    std::string output; ///< -o, --output
    ReadOptions read;   ///< --channel, --max-bytes
    std::optional<double> threshold;    ///< --threshold
    bool invert = false;                ///< --invert
    std::optional<Wrap> wrap_x, wrap_y; ///< --wrap
    std::optional<ShapeModel> model;    ///< --model
    bool antialiased = false;           ///< --antialiased
    ShapeMapOptions bake;               ///< --method --signed --scale-f --threads
    std::optional<BitDepth> bits;       ///< --bits; default by the output's format
    bool named = false;                 ///< --exr-layout named
    bool json = false;
    bool quiet = false;
};

/// What the stages run with: every default resolved, every combination checked.
struct ShapePlan {
    ShapeCommandOptions given;
    ShapeOptions shape;   ///< bright_is_inside depends on the channel, and is not yet known
    ShapeMapOptions bake; ///< threads and bits resolved
};

void add_shape_options(CLI::App& app, ShapeCommandOptions& options);

/// Refuses (usage) options that do not fit each other or the output's format.
Result<ShapePlan> plan_shape(const ShapeCommandOptions& options);

/// XXH3-128 of every option that can change a byte of the map, the channel taken among them.
std::string argument_hash(const ShapePlan& plan, const std::string& channel);

} // namespace reliefbake
