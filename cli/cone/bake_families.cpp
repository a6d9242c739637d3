#include "cli/cone/bake_families.h"

#include "cli/choices.h"
#include "cli/cone/channel_options.h"
#include "cli/cone/mip_options.h"
#include "cli/options/number_options.h"

#include <limits>

namespace reliefbake {

namespace {

void add_layout_options(CLI::App& app, ConeCommandOptions& options) {
    app.option_defaults()->group("Result");
    add_choice(app, "--layout", options.layout, layout_words,
               "named: one EXR with depth and normals; cones alone: rgba (up to 4 planes), side (8 in one image of twice the width), "
               "pair (8 in two files, the second named ..._b) (default named for .exr, else rgba or side)");
    app.add_option("--relief", options.relief_output, "Also write a cone map with depth and normals, for layouts of cones alone")
        ->type_name("FILE");
}

} // namespace

void ConeCommand::add_own_options(CLI::App& app) {
    add_search_options(app, options_);
    add_cone_max_option(app, options_);
    add_family_options(app, options_.family, true);
    add_output_options(app, options_);
    add_encoding_option(app, options_);
    add_single_cone_result_options(app);
}

/// The options of large maps are a whole run's: not for --also.
void SingleConeCommand::add_to(CLI::App& app) {
    BakeCommand::add_to(app);
    add_large_options(app, options_.large);
}

void SingleConeCommand::add_single_cone_result_options(CLI::App& app) {
    app_ = &app;
    add_exr_layout_option(app, options_);
    add_channels_option(app, options_);
    add_mip_options(app, options_);
}

Result<ConeCommandOptions> SingleConeCommand::given() const {
    return check_channels(*app_, options_).map([&] { return options_; });
}

void AcmCommand::add_own_options(CLI::App& app) {
    options_.command = options_.kind = "acm";
    options_.planes = 4;
    add_search_options(app, options_);
    add_cone_max_option(app, options_);
    app.add_option("--sectors", options_.planes, "Sectors of azimuth, counted from +u towards +v (default 4)")
        ->check(CLI::IsMember({4, 8}));
    static const Words<Method> method_words = {{"exact", Method::exact}, {"adaptive", Method::adaptive}};
    add_choice(app, "--method", method_, method_words,
               "exact; or 002's Algorithm 1, approximate: cones hold surface, and rays miss (default exact)");
    app.add_option("--levels", levels_, "adaptive: levels above the map; 0 is the original ring search (default 3)")->check(CLI::Range(0, 16));
    add_number(app, "--similarity", similarity_, fraction_number,
               "adaptive: height by which a texel may differ from its parent and copy its cones (default 0.05)");
    add_family_options(app, options_.family, false);
    add_output_options(app, options_);
    add_encoding_option(app, options_);
    add_layout_options(app, options_);
    add_mip_options(app, options_);
}

Result<ConeCommandOptions> AcmCommand::given() const {
    if (method_ == Method::exact) {
        if (levels_ || similarity_) return fail(ErrorCode::usage, "--levels, --similarity: need --method adaptive");
        return options_;
    }
    if (options_.family.family != ConeFamily::conservative || options_.family.lookup != ConeLookup::filtered ||
        options_.cone.metric != Metric::l2)
        return fail(ErrorCode::usage, "--method adaptive: bakes filtered l2 cones as published; leave --kind, --lookup and --metric out");
    ConeCommandOptions options = options_;
    options.adaptive = AdaptiveOptions();
    options.adaptive->sectors = options_.planes;
    options.adaptive->levels = levels_.value_or(options.adaptive->levels);
    options.adaptive->similarity = similarity_.value_or(options.adaptive->similarity);
    return options;
}

void ConeNormalCommand::add_own_options(CLI::App& app) {
    options_.command = "cone-normal";
    options_.encoding = ConeEncoding::normal;
    options_.cone.ratio_max = std::numeric_limits<float>::infinity();
    add_search_options(app, options_);
    add_family_options(app, options_.family, true);
    add_output_options(app, options_);
    add_single_cone_result_options(app);
}

void ConeStackCommand::add_own_options(CLI::App& app) {
    options_.command = "cone-stack";
    options_.planes = 4;
    add_search_options(app, options_);
    add_cone_max_option(app, options_);
    app.add_option("--levels", options_.planes, "Cones or pieces above each texel; the first stands on it (default 4)")->check(CLI::Range(1, 16));
    app.add_option("--method", method_, "1: whole cones, the longest step wins; 2: one line of pieces, of which a step leaves through one (default 1)")
        ->check(CLI::IsMember({1, 2}));
    add_output_options(app, options_);
    add_encoding_option(app, options_);
    add_layout_options(app, options_);
    add_mip_options(app, options_);
}

Result<ConeCommandOptions> ConeStackCommand::given() const {
    ConeCommandOptions options = options_;
    options.kind = method_ == 1 ? "cone-stack" : "cone-pieces";
    return options;
}

std::unique_ptr<BakeCommand> make_bake_command(const std::string& name) {
    if (name == "cone") return std::make_unique<ConeCommand>();
    if (name == "acm") return std::make_unique<AcmCommand>();
    if (name == "cone-normal") return std::make_unique<ConeNormalCommand>();
    if (name == "cone-stack") return std::make_unique<ConeStackCommand>();
    return nullptr;
}

} // namespace reliefbake
