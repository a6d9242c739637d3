#pragma once
// The command line of `reliefbake cone`, and what the stages take from it.

#include "bake/acm_adaptive.h"
#include "bake/cone.h"
#include "bake/error.h"
#include "bake/height_field.h"
#include "bake/relief_map.h"
#include "cli/cone/family_options.h"
#include "cli/cone/large/large_options.h"
#include "cli/options/alpha_options.h"
#include "formats/read_image.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// As given; nothing is defaulted that depends on another option.
struct ConeCommandOptions {
    std::string input;    ///< IN
    std::string output;   ///< -o, --output
    ReadOptions read;     ///< --channel, --max-bytes
    AlphaOptions alpha;   ///< --alpha --alpha-threshold
    HeightOptions height; ///< --input --range --nan --no-data --scale --bias --wrap --pixel-aspect
    std::string command = "cone"; ///< its name: cone, acm, cone-normal, cone-stack
    std::string kind = "cone"; ///< what the command bakes: "cone", "acm", "cone-stack", "cone-pieces"
    int planes = 1;            ///< sectors of an acm (--sectors), levels or pieces of a stack (--levels)
    std::optional<AdaptiveOptions> adaptive; ///< acm --method adaptive
    FamilyOptions family;      ///< --kind --relaxed --delta --lookup
    std::string relief_output; ///< --relief: a cone map with depth and normals, beside a map of cones alone
    ConeOptions cone;     ///< --surface --metric --tolerance --cone-max --threads
    ConeEncoding encoding = ConeEncoding::sqrt;
    std::optional<BitDepth> bits;        ///< --bits; default by the output's format
    std::optional<ChannelLayout> layout; ///< --exr-layout
    HeldPlanes held;      ///< --channels
    NormalY normal_y = NormalY::gl;
    std::optional<double> depth_uv;     ///< --depth-uv
    std::optional<double> size_metres;  ///< --size
    std::optional<double> depth_metres; ///< --depth
    bool mips = false;      ///< --mips: a chain of levels, each with heights and cones of its own
    int level = 0;          ///< --level: mip level of the heights that is baked as level 0
    std::optional<int> mip_levels; ///< --mip-levels: of the chain, from the largest on; unset: all
    bool trilinear = false; ///< --trilinear: cones that hold under a blend of two levels
    LargeOptions large;     ///< --memory --out-of-core --rows
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

// Groups of options, for the commands that share some of them.
void add_input_options(CLI::App& app, ConeCommandOptions& options);  ///< IN, Source, Proportions
void add_run_options(CLI::App& app, ConeCommandOptions& options);    ///< those, --alpha, --threads --json --quiet: the same for all maps of a run
void add_search_options(CLI::App& app, ConeCommandOptions& options); ///< --surface --metric --tolerance
void add_cone_max_option(CLI::App& app, ConeCommandOptions& options);
void add_output_options(CLI::App& app, ConeCommandOptions& options); ///< -o --bits --normal-y
void add_encoding_option(CLI::App& app, ConeCommandOptions& options);
void add_exr_layout_option(CLI::App& app, ConeCommandOptions& options);

/// Copies what add_run_options sets.
void copy_run_options(const ConeCommandOptions& from, ConeCommandOptions& to);

/// Refuses (usage) options that do not fit each other or the output's format.
Result<ConePlan> plan_cone(const ConeCommandOptions& options);

/// Refuses (usage) files that two plans of a run would write, also where only their case differs, and those that are its input.
Result<void> validate_outputs(const std::vector<ConePlan>& plans);

} // namespace reliefbake
