#include "cli/render/render.h"

#include "cli/options/map_hint_options.h"
#include "cli/render/picture_options.h"
#include "cli/render/render_choices.h"
#include "formats/bump_file.h"
#include "formats/map_kind.h"
#include "formats/write_image.h"
#include "shaders-reference/measure/compare.h"
#include "shaders-reference/measure/heat_map.h"
#include "shaders-reference/measure/stored_depth.h"

#include <filesystem>

namespace reliefbake {

void RenderCommand::add_to(CLI::App& app) {
    app_ = &app;
    app.add_option("MAP", options_.file, "A baked map")->required();
    app.add_option("-o,--output", options_.output, "Picture to write, PNG")->required()->type_name("PNG");
    app.add_option("--error", options_.error,
                   "Also paint how far each ray ends from the exact hit, logarithmic: 1e-5 of the depth and less dark, all of it yellow; a pixel a ray")
        ->type_name("PNG");
    add_view_options(app, options_.picture);
    app.option_defaults()->group("Technique");
    add_technique_options(app, options_.technique, options_.picture.max_steps);
    app.option_defaults()->group("Light");
    add_shadow_options(app, options_.picture);
    app.add_option("--horizon", options_.horizons, "Horizon map of the same heights (reliefbake bump --kind horizon), for --shadow horizon")
        ->type_name("FILE");
    add_choice(app, "--ao", options_.picture.ambient, ambient_words,
               "Sky seen through the cones (default cone-normal; none where cones may hold relief)");
    app.option_defaults()->group("Driver");
    add_choice(app, "--renderer", options_.backend, renderer_words, "Who draws (default osmesa)");
    app.option_defaults()->group("Map");
    add_map_hints(app, options_.hints);
    add_render_shape_options(app, options_.shape);
    add_render_mesh_options(app, options_.mesh);
}

Result<void> RenderCommand::check_output(const std::filesystem::path& path) const {
    std::error_code ignored;
    if (path.extension() != ".png" && path.extension() != ".PNG")
        return fail(ErrorCode::usage, path.string() + ": pictures are written as .png");
    for (const std::filesystem::path& input : {std::filesystem::path(options_.file), options_.hints.relief, std::filesystem::path(options_.horizons)})
        if (std::filesystem::equivalent(input, path, ignored))
            return fail(ErrorCode::usage, path.string() + ": the output is an input file; choose another name");
    return {};
}

Result<Rendering> RenderCommand::draw(const ReliefMap& map, const RenderOptions& picture) const {
    if (options_.horizons.empty()) return render(map, picture, options_.backend);
    const Result<BumpMap> horizons = read_bump_map(options_.horizons, options_.hints.max_bytes);
    if (!horizons) return tl::unexpected(horizons.error());
    Result<ReliefRenderer> renderer = ReliefRenderer::create(options_.backend);
    if (!renderer) return tl::unexpected(renderer.error());
    if (Result<void> loaded = renderer->load(map); !loaded) return tl::unexpected(loaded.error());
    if (Result<void> loaded = renderer->load_horizons(*horizons); !loaded)
        return fail(loaded.error().code, options_.horizons + ": " + loaded.error().message);
    return renderer->render(picture);
}

Result<void> RenderCommand::write_error(const ReliefMap& map, const Rendering& rendering) const {
    const Image<Quad> hits = oracle_hits(BilinearSurface(stored_depth(map)), rendering);
    const RgbImage picture = error_picture(rendering, hits);
    return write_png(options_.error, picture.width, picture.height, 3, picture.rgb);
}

Result<void> RenderCommand::run_mesh(const std::string& kind) const {
    const bool shape = kind == "shape";
    const std::string why = "is not for meshes (--mesh)";
    Result<void> fits = refuse_given(*app_, "Light", {"--tiles", "--endless", "--span", "--error", "--exact-finish", "--solid", "--on", "--axis", "--scheme",
                                                      "--projection", "--texture", "--bump", "--bump-scale", "--texture-tiles"}, why);
    if (fits && shape) fits = refuse_hints(options_.hints, options_.file, "shape").and_then([&] {
        return refuse_given(*app_, "", {"--technique"}, options_.file + " is a shape map, which does not take it");
    });
    if (fits && !shape) fits = refuse_given(*app_, "", {"--e", "--b", "--c"}, "is for shape maps (reliefbake shape)");
    if (!fits) return fits;
    return render_on_meshes({options_.file, options_.hints, options_.output, options_.picture, options_.technique, options_.shape.solid, options_.backend},
                            options_.mesh, shape);
}

Result<void> RenderCommand::run_shape() const {
    if (Result<void> hinted = refuse_hints(options_.hints, options_.file, "shape"); !hinted) return hinted;
    Result<void> fits = refuse_given(*app_, "", {"--technique", "--exact-finish", "--ao", "--endless", "--error", "--horizon", "--shadow-steps"}, options_.file + " is a shape map, which does not take it");
    if (!fits) return fits;
    return render_shape({options_.file, options_.hints.max_bytes, options_.output, options_.picture, options_.technique.steps, options_.technique.binary_steps, options_.backend},
                        options_.shape);
}

Result<void> RenderCommand::run() {
    if (Result<void> checked = check_output(options_.output); !checked) return checked;
    if (!options_.error.empty()) {
        if (Result<void> checked = check_output(options_.error); !checked) return checked;
        if (std::filesystem::path(options_.error).lexically_normal() == std::filesystem::path(options_.output).lexically_normal())
            return fail(ErrorCode::usage, "--error: names the same file as --output");
    }
    const Result<std::string> kind = kind_of_map(options_.file, options_.hints.max_bytes);
    if (!kind) return tl::unexpected(kind.error());
    const bool on_mesh = !options_.mesh.files.empty();
    if (!on_mesh)
        if (Result<void> fits = refuse_given(*app_, mesh_group, {}, "needs --mesh"); !fits) return fits;
    if (*kind == "shape" && !on_mesh) return run_shape();
    if (bump_kind_of(*kind))
        return fail(ErrorCode::usage, options_.file + ": is a map of kind " + *kind + "; a cone map is drawn, horizons with it by --shadow horizon --horizon FILE");
    if (on_mesh) return run_mesh(*kind);
    if (Result<void> fits = refuse_given(*app_, solid_group, {}, "is for shape maps (reliefbake shape)"); !fits) return fits;
    if ((options_.picture.shadow == Shadow::horizon) == options_.horizons.empty())
        return fail(ErrorCode::usage, options_.horizons.empty() ? "--shadow horizon: needs --horizon FILE" : "--horizon: needs --shadow horizon");
    const Result<ReliefMap> map = read_map(options_.file, options_.hints);
    if (!map) return tl::unexpected(map.error());

    const Result<RenderOptions> picture = plane_picture(*app_, options_.picture, options_.technique, *map);
    if (!picture) return tl::unexpected(picture.error());
    const Result<Rendering> rendering = draw(*map, *picture);
    if (!rendering) return tl::unexpected(rendering.error());
    if (!options_.error.empty())
        if (Result<void> written = write_error(*map, *rendering); !written) return written;
    const RgbImage& colour = rendering->colour;
    return write_png(options_.output, colour.width, colour.height, 3, colour.rgb);
}

} // namespace reliefbake
