#include "cli/verify/verify.h"

#include "cli/options/map_hint_options.h"
#include "cli/options/range_option.h"
#include "cli/options/thread_option.h"
#include "cli/render/render_choices.h"
#include "cli/verify/verify_bump.h"
#include "cli/verify/verify_shape.h"
#include "cli/verify/verify_text.h"
#include "formats/bump_file.h"
#include "formats/map_kind.h"
#include "formats/write_image.h"
#include "shaders-reference/measure/stored_depth.h"

#include <cstdio>
#include <filesystem>
#include <utility>

namespace reliefbake {

namespace {

/// FOLDER/view-ANGLE-AZIMUTH-{rendering,oracle,error,steps}.png
Result<void> write_pictures(const std::string& folder, const VerifyReport& report) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return fail(ErrorCode::cannot_create, folder + ": cannot create the folder: " + error.message());
    for (const ViewReport& view : report.views) {
        char stem[64];
        std::snprintf(stem, sizeof stem, "view-%02.0f-%03.0f-", view.angle, view.azimuth);
        const std::pair<const char*, const RgbImage&> pictures[] = {{"rendering", view.pictures->rendering},
                                                                    {"oracle", view.pictures->oracle},
                                                                    {"error", view.pictures->error},
                                                                    {"steps", view.pictures->steps}};
        for (const auto& [name, picture] : pictures) {
            const std::filesystem::path path = std::filesystem::path(folder) / (std::string(stem) + name + ".png");
            Result<void> written = write_png(path, picture.width, picture.height, 3, picture.rgb);
            if (!written) return written;
        }
    }
    return {};
}

constexpr int enough_halvings = 24; // of the whole depth: 2^-24

} // namespace

void VerifyCommand::add_to(CLI::App& app) {
    app_ = &app;
    app.add_option("MAP", options_.file, "A baked map")->required();
    app.add_flag("--json", options_.json, "Print one object (docs/FORMATS.md)");
    app.add_option("--pictures", options_.pictures, "Folder for pictures of every view: rendering, oracle, error, steps")
        ->type_name("DIR");
    app.option_defaults()->group("Source");
    CLI::Option* source =
        app.add_option("--source", options_.source, "Height map to compare the stored depth with")->type_name("HEIGHT");
    for (CLI::Option* option : {app.add_option("--channel", options_.read.channel, "Its channel (default: the only one, else luminance)"),
                                add_choice(app, "--input", options_.height.input, input_words, "What white means in it (default height)"),
                                add_range_option(app, options_.height)})
        option->needs(source);
    app.option_defaults()->group("Effort");
    app.add_option("--rays", options_.verify.rays, "Rays over all views, about (default 300000)")
        ->check(CLI::Range(100, 100000000));
    app.add_option("--points", options_.verify.points, "Points of the direct check (default 20000)")
        ->check(CLI::Range(0, 100000000));
    app.add_option("--seed", options_.verify.seed, "Of the direct check (default 1)");
    app.add_option("--crop", options_.verify.crop, "Side of the crop whose tightness is measured; 0: none (default 64)")
        ->check(CLI::Range(0, 1024));
    add_thread_option(app, options_.verify.threads);
    app.option_defaults()->group("Technique");
    add_technique_options(app, options_.technique, options_.verify.max_steps);
    add_choice(app, "--filter", options_.verify.filter, filter_words,
               "Weights of the sampler: float, or 8-bit fixed point (default float)");
    add_choice(app, "--renderer", options_.verify.backend, renderer_words, "Who draws (default osmesa)");
    app.option_defaults()->group("Map");
    add_map_hints(app, options_.hints);
    add_solid_options(app, options_.solid);
    add_verify_mesh_options(app, options_.mesh);
}

Result<void> VerifyCommand::run_shape() const {
    if (Result<void> hinted = refuse_hints(options_.hints, options_.file, "shape"); !hinted) return hinted;
    Result<void> fits = refuse_given(*app_, "Source", {"--technique", "--exact-finish", "--crop"}, options_.file + " is a shape map, which does not take it");
    if (!fits) return fits;
    const Result<int> threads = resolve_threads(options_.verify.threads);
    if (!threads) return tl::unexpected(threads.error());
    ShapeVerifyOptions options;
    options.backend = options_.verify.backend;
    options.filter = options_.verify.filter;
    if (app_->get_option("--rays")->count() > 0) options.rays = options_.verify.rays;
    options.points = options_.verify.points;
    options.seed = options_.verify.seed;
    options.steps = options_.technique.steps.value_or(options.steps);
    options.binary_steps = options_.technique.binary_steps.value_or(options.binary_steps);
    options.threads = *threads;
    return verify_shape_file({options_.file, options_.hints.max_bytes}, options_.solid, options, options_.json, options_.pictures);
}

/// Curved relief: the mesh is the judge, not the oracle of planes.
Result<void> VerifyCommand::run_mesh(const std::string& kind, int threads) const {
    if (bump_kind_of(kind)) return fail(ErrorCode::usage, "--mesh: " + options_.file + " is a map of kind " + kind + ", which holds no relief");
    const bool shape = kind == "shape";
    const char* why = "says nothing to a judgement on a mesh (--mesh)";
    Result<void> fits = refuse_given(*app_, "", {"--source", "--rays", "--points", "--seed", "--crop", "--exact-finish", "--filter", "--axis", "--scheme"}, why);
    if (fits && shape) fits = refuse_hints(options_.hints, options_.file, "shape").and_then([&] {
        return refuse_given(*app_, "", {"--technique"}, options_.file + " is a shape map, which does not take it");
    });
    if (fits && !shape) fits = refuse_given(*app_, "", {"--e", "--b", "--c"}, "is for shape maps (reliefbake shape)");
    if (fits && options_.mesh.ideal)
        fits = refuse_given(*app_, "", {"--technique", "--steps", "--binary-steps", "--correction", "--terms"}, "is the shader's; --ideal marches without it");
    if (!fits) return fits;
    return verify_on_mesh({options_.file, options_.hints, options_.mesh, options_.technique, options_.solid, shape, options_.verify.backend, threads, options_.json,
                           options_.pictures});
}

Result<DepthMap> VerifyCommand::read_source(const ReliefMap& map) const {
    const Result<SourceImage> image = read_image(options_.source, options_.read);
    if (!image) return tl::unexpected(image.error());
    // The map says itself where its holes are; another size is told below.
    HoleMask holes = map.depth.empty() ? HoleMask() : stored_holes(stored_depth(map));
    if (holes.width() != image->plane.width() || holes.height() != image->plane.height()) holes = {};
    const Result<CheckedHeight> height =
        make_height_field(image->plane, image->is_integer, options_.height, options_.source, std::move(holes));
    if (!height) return tl::unexpected(height.error());
    return quantise_depth(height->field, map.info.bits);
}

/// Derivatives, normals, horizons: no ray is followed, but for shadows.
Result<void> VerifyCommand::run_bump(const std::string& kind) const {
    for (const char* unread : {"--pictures", "--source", "--crop", "--technique", "--exact-finish", "--steps", "--binary-steps", "--filter"})
        if (app_->count(unread) > 0) return fail(ErrorCode::usage, std::string(unread) + ": says nothing to a map of kind " + kind);
    if (kind != word_of(BumpKind::horizon))
        for (const char* unread : {"--rays", "--points", "--seed", "--renderer"})
            if (app_->count(unread) > 0)
                return fail(ErrorCode::usage, std::string(unread) + ": is for maps that are sampled; every texel of a map of kind " + kind + " is checked");
    MapHints hints = options_.hints;
    const std::string relief = std::exchange(hints.relief, {}).string();
    if (Result<void> checked = refuse_hints(hints, options_.file, kind); !checked) return checked;
    const Result<int> threads = resolve_threads(options_.verify.threads);
    if (!threads) return tl::unexpected(threads.error());
    Result<BumpMap> map = read_bump_map(options_.file, hints.max_bytes);
    if (!map) return tl::unexpected(map.error());
    if (Result<void> depth = take_depth(*map, options_.file, relief, hints.max_bytes); !depth) return depth;
    const Result<BumpReport> report =
        verify_bump(*map, {options_.verify.points, options_.verify.seed, *threads, options_.verify.rays, options_.verify.backend});
    if (!report) return tl::unexpected(report.error());
    std::fputs((options_.json ? to_json(*report).dump(2) + "\n" : verify_bump_text(*map, *report)).c_str(), stdout);
    if (report->violations == 0) return {};
    return fail(ErrorCode::verification, options_.file + ": violated: its values are not those of the depth that it was baked for; bake it again");
}

Result<void> VerifyCommand::run() {
    const Result<std::string> kind = kind_of_map(options_.file, options_.hints.max_bytes);
    if (!kind) return tl::unexpected(kind.error());
    const bool on_mesh = !options_.mesh.file.empty();
    if (!on_mesh)
        if (Result<void> fits = refuse_given(*app_, mesh_group, {}, "needs --mesh"); !fits) return fits;
    if (*kind != "shape" && !on_mesh)
        if (Result<void> fits = refuse_given(*app_, solid_group, {}, "is for shape maps (reliefbake shape)"); !fits) return fits;
    if (bump_kind_of(*kind) && !on_mesh) return run_bump(*kind);
    VerifyOptions options = options_.verify;
    const Result<int> threads = resolve_threads(options.threads);
    if (!threads) return tl::unexpected(threads.error());
    options.threads = *threads;
    options.pictures = !options_.pictures.empty();
    if (options.pictures) {
        std::error_code ignored;
        std::filesystem::create_directories(options_.pictures, ignored);
        if (!std::filesystem::is_directory(options_.pictures, ignored))
            return fail(ErrorCode::cannot_create, options_.pictures + ": cannot create this folder");
    }
    if (on_mesh) return run_mesh(*kind, *threads);
    if (*kind == "shape") return run_shape();
    const Result<ReliefMap> map = read_map(options_.file, options_.hints);
    if (!map) return tl::unexpected(map.error());
    const Result<ResolvedTechnique> technique = resolve_technique(options_.technique, *map, options.max_steps);
    if (!technique) return tl::unexpected(technique.error());
    options.technique = technique->technique;
    options.exact_finish = technique->exact_finish;
    options.max_steps = technique->max_steps;
    options.linear_steps = technique->linear_steps;
    options.binary_steps = technique->binary_steps;
    // What a map promises shows when its march may end and its last step is narrowed down; a shader's counts are for --steps.
    const bool refines = technique->technique == Technique::relaxed || technique->technique == Technique::relaxed_secant;
    if (refines && !options_.technique.steps) options.max_steps = options_.verify.max_steps;
    if (refines && !options_.technique.binary_steps) options.binary_steps = enough_halvings;
    DepthMap source;
    if (!options_.source.empty()) {
        Result<DepthMap> read = read_source(*map);
        if (!read) return tl::unexpected(read.error());
        source = std::move(*read);
        options.source = &source;
    }

    const Result<VerifyReport> report = verify(*map, options);
    if (!report) return tl::unexpected(report.error());
    std::fputs((options_.json ? to_json(*report).dump(2) + "\n" : verify_text(*report)).c_str(), stdout);
    if (options.pictures) {
        const Result<void> written = write_pictures(options_.pictures, *report);
        if (!written) return written;
    }
    if (report->verdict == Verdict::other_source)
        return fail(ErrorCode::verification, options_.file + ": its depth is not that of " + options_.source +
                                                 ": give the options of the bake (--channel, --input, --range), or the right file");
    if (report->verdict != Verdict::unsafe) return {};
    return fail(ErrorCode::verification, options_.file + ": unsafe: bake it again, or see which metric, surface and "
                                                         "encoding it was made for (reliefbake explain)");
}

} // namespace reliefbake
