#pragma once
// The command line of `reliefbake cone`, and what the stages take from it.

#include "bake/acm_adaptive.h"
#include "bake/cone.h"
#include "bake/error.h"
#include "bake/height_field.h"
#include "bake/relief_map.h"
#include "cli/family_options.h"
#include "formats/read_image.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <optional>
#include <string>

namespace reliefbake {

/// As given; nothing is defaulted that depends on another option.
struct ConeCommandOptions {
    std::string input;    ///< IN
    std::string output;   ///< -o, --output
    ReadOptions read;     ///< --channel, --max-bytes
    HeightOptions height; ///< --input --range --nan --no-data --scale --bias --wrap --pixel-aspect
    std::string kind = "cone"; ///< what the command bakes: "cone", "acm", "cone-stack", "cone-pieces"
    int planes = 1;            ///< sectors of an acm (--sectors), levels or pieces of a stack (--levels)
    std::optional<AdaptiveOptions> adaptive; ///< acm --method adaptive
    FamilyOptions family;      ///< --kind --relaxed --delta --lookup
    std::string relief_output; ///< --relief: a cone map with depth and normals, beside a map of cones alone
    ConeOptions cone;     ///< --surface --metric --tolerance --cone-max --threads
    ConeEncoding encoding = ConeEncoding::sqrt;
    std::optional<BitDepth> bits;        ///< --bits; default by the output's format
    std::optional<ChannelLayout> layout; ///< --exr-layout
    NormalY normal_y = NormalY::gl;
    std::optional<double> depth_uv;     ///< --depth-uv
    std::optional<double> size_metres;  ///< --size
    std::optional<double> depth_metres; ///< --depth
    bool mips = false;      ///< --mips: a chain of levels, each with heights and cones of its own
    bool trilinear = false; ///< --trilinear: cones that hold under a blend of two levels
    bool json = false;
    bool quiet = false;
};

/// What the stages run with: every default resolved, every combination checked.
struct ConePlan {
    ConeCommandOptions given;
    BitDepth bits = BitDepth::unorm16;
    ChannelLayout layout = ChannelLayout::rgba;
    double depth_scale = 0.1;  ///< depth of the relief in texture widths
    ConeOptions cone;          ///< threads resolved
    std::string argument_hash; ///< of the options that fix the result
};

void add_cone_options(CLI::App& app, ConeCommandOptions& options);

// Its groups, for the commands that share some of them.
void add_input_options(CLI::App& app, ConeCommandOptions& options);  ///< IN, Source, Proportions
void add_search_options(CLI::App& app, ConeCommandOptions& options); ///< --surface --metric --tolerance --threads
void add_cone_max_option(CLI::App& app, ConeCommandOptions& options);
void add_output_options(CLI::App& app, ConeCommandOptions& options); ///< -o --bits --normal-y --json --quiet
void add_encoding_option(CLI::App& app, ConeCommandOptions& options);
void add_exr_layout_option(CLI::App& app, ConeCommandOptions& options);

/// Refuses (usage) options that do not fit each other or the output's format.
Result<ConePlan> plan_cone(const ConeCommandOptions& options);

} // namespace reliefbake
