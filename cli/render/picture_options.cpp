#include "cli/render/picture_options.h"

#include "cli/options/number_options.h"
#include "cli/render/render_choices.h"

#include <tuple>

namespace reliefbake {

namespace {

const NumberRule view_angle = {[](double x) { return x >= 0 && x <= 180; }, "degrees from 0 to 180"};
const NumberRule any_angle = {[](double x) { return x >= -360 && x <= 360; }, "degrees from -360 to 360"};
const NumberRule elevation = {[](double x) { return x > 0 && x <= 90; }, "degrees above 0, up to 90"};

/// --shadow, or --shadow WORD.
void add_shadow(CLI::App& app, Shadow& shadow) {
    const auto assign = [&shadow](const std::string& given) {
        if (given.empty()) {
            shadow = Shadow::height_soft;
            return;
        }
        for (const auto& [word, meaning] : shadow_words)
            if (word == given) {
                shadow = meaning;
                return;
            }
        throw CLI::ValidationError("--shadow", "expected " + alternatives(shadow_words) + ", found '" + given + "'");
    };
    app.add_option_function<std::string>("--shadow", assign, "March to the sun too, or ask a horizon map (alone: height-soft)")
        ->expected(0, 1)
        ->type_name(alternatives(shadow_words));
}

} // namespace

void add_view_options(CLI::App& app, RenderOptions& picture) {
    app.option_defaults()->group("View");
    add_number(app, "--view", picture.view.angle, view_angle,
               "Degrees between the line of sight and the relief's normal, below 90 for planes (default 45)");
    add_number(app, "--azimuth", picture.view.azimuth, any_angle,
               "Heading of the line of sight, degrees clockwise from up the image (default 0)");
    add_number(app, "--span", picture.view.span, positive_number,
               "Texture widths seen across the picture (default: the whole plane)");
    add_number(app, "--sun-azimuth", picture.sun.azimuth, any_angle,
               "Where light comes from, degrees clockwise from the heading (default -55)");
    add_number(app, "--sun-elevation", picture.sun.elevation, elevation, "Degrees above the plane (default 30)");
    app.add_option("--tiles", picture.tiles, "Repeats of the map per axis (default 1)")->check(CLI::Range(1, 1000));
    app.add_flag("--endless", picture.endless, "A plane without border (repeated maps)");
    app.add_option_function<std::string>(
           "--size", [&picture](const std::string& text) { std::tie(picture.width, picture.height) = require_size("--size", text); },
           "Picture in pixels (default 1024x768)")
        ->type_name("WxH");
    app.add_option("--supersample", picture.supersample, "Rays per pixel and axis (default 1)")->check(CLI::Range(1, 8));
}

void add_shadow_options(CLI::App& app, RenderOptions& picture) {
    add_shadow(app, picture.shadow);
    app.add_option("--shadow-steps", picture.shadow_steps, "Of the march to the sun (default 64)")->check(CLI::Range(1, 100000));
}

Result<RenderOptions> plane_picture(const CLI::App& app, const RenderOptions& given, const TechniqueOptions& technique, const ReliefMap& map) {
    if (given.view.angle >= 90) return fail(ErrorCode::usage, "--view: a plane is seen from degrees below 90");
    const bool marches = given.shadow != Shadow::none && given.shadow != Shadow::horizon;
    if (!marches && app.count("--shadow-steps") > 0)
        return fail(ErrorCode::usage, "--shadow-steps: needs a march to the sun (--shadow hard, height-soft or cone-soft)");
    const bool repeats = map.grid.wrap_x == Wrap::repeat && map.grid.wrap_y == Wrap::repeat;
    if (!repeats && (given.endless || given.tiles > 1))
        return fail(ErrorCode::usage, "--endless, --tiles: need a map that repeats; this one is clamped");
    return resolve_technique(technique, map, given.max_steps).map([&](const ResolvedTechnique& resolved) {
        RenderOptions picture = given;
        apply(resolved, picture);
        return picture;
    });
}

} // namespace reliefbake
