#include "cli/bench/bench_render.h"

#include "cli/options/map_hint_options.h"
#include "cli/render/picture_options.h"
#include "cli/render/render_choices.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace reliefbake {

namespace {

/// What the rays of a frame cost, in numbers that no machine changes.
nlohmann::json count_work(const Rendering& rendering) {
    double rays = 0, steps = 0, fetches = 0;
    for (std::size_t pixel = 0; pixel < rendering.counts.size(); ++pixel) {
        if (rendering.status(pixel) == RayStatus::no_ray) continue;
        rays += 1;
        steps += rendering.counts[pixel][0];
        fetches += rendering.counts[pixel][1];
    }
    return {{"rays", rays}, {"steps_mean", rays > 0 ? steps / rays : 0}, {"fetches_mean", rays > 0 ? fetches / rays : 0}};
}

} // namespace

void BenchRenderCommand::add_to(CLI::App& app) {
    app_ = &app;
    app.add_option("MAP", file_, "A cone map")->required();
    app.add_option("--frames", frames_, "Frames that are timed, after one that is not (default 5)")->check(CLI::Range(1, 10000));
    app.add_flag("--json", json_, "Print one object");
    add_view_options(app, picture_);
    app.option_defaults()->group("Technique");
    add_technique_options(app, technique_, picture_.max_steps);
    app.option_defaults()->group("Light");
    add_shadow_options(app, picture_);
    add_choice(app, "--ao", picture_.ambient, ambient_words, "Sky seen through the cones (default none)");
    app.option_defaults()->group("Driver");
    add_choice(app, "--renderer", backend_, renderer_words, "Who draws (default osmesa)");
    app.option_defaults()->group("Map");
    add_map_hints(app, hints_);
}

Result<void> BenchRenderCommand::run() {
    if (picture_.shadow == Shadow::horizon) return fail(ErrorCode::usage, "--shadow horizon: is not timed here; a horizon map is one texture read");
    const Result<ReliefMap> map = read_map(file_, hints_);
    if (!map) return tl::unexpected(map.error());
    Result<RenderOptions> picture = plane_picture(*app_, picture_, technique_, *map);
    if (!picture) return tl::unexpected(picture.error());
    picture->ambient = picture_.ambient.value_or(Ambient::none);
    Result<ReliefRenderer> renderer = ReliefRenderer::create(backend_);
    if (!renderer) return tl::unexpected(renderer.error());
    if (Result<void> loaded = renderer->load(*map); !loaded) return fail(loaded.error().code, file_ + ": " + loaded.error().message);

    nlohmann::json result;
    std::vector<double> milliseconds, processor;
    for (int frame = 0; frame <= frames_; ++frame) { // the first compiles
        const Result<Rendering> rendering = renderer->render(*picture);
        if (!rendering) return tl::unexpected(rendering.error());
        if (frame == 0) result = count_work(*rendering);
        else milliseconds.push_back(1000 * rendering->seconds), processor.push_back(1000 * rendering->cpu_seconds);
    }
    std::sort(milliseconds.begin(), milliseconds.end());
    result["frames"] = frames_;
    result["milliseconds_least"] = milliseconds.front();
    result["milliseconds_median"] = milliseconds[milliseconds.size() / 2];
    result["processor_milliseconds_least"] = *std::min_element(processor.begin(), processor.end()); // says something on a busy machine, too
    if (json_) {
        std::printf("%s\n", result.dump(2).c_str());
        return {};
    }
    std::printf("%dx%d, %d frames: %.2f ms at best, %.2f ms the median; a ray takes %.2f steps and %.2f texture reads\n", picture->width, picture->height, frames_,
                milliseconds.front(), milliseconds[milliseconds.size() / 2], result["steps_mean"].get<double>(), result["fetches_mean"].get<double>());
    return {};
}

} // namespace reliefbake
