#include "cli/options/solid_options.h"

#include "cli/choices.h"
#include "cli/options/number_options.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

const NumberRule growth_number = {[](double x) { return x >= 0 && x <= most_bevel; }, "a number from 0 to 1e6"};
const NumberRule depth_number = {[](double x) { return std::isfinite(x) && x >= 0; }, "a number from 0 on"};
const NumberRule axis_number = {[](double x) { return x >= 0 && x < 1; }, "a number from 0 to below 1"};

const Words<SolidKind> solid_words = {{"extrusion", SolidKind::extrusion}, {"revolution", SolidKind::revolution}};
const Words<bool> place_words = {{"plane", true}, {"box", false}};
const Words<CircleScheme> scheme_words = {{"corrected", CircleScheme::corrected}, {"published", CircleScheme::published}};

} // namespace

void add_solid_options(CLI::App& app, SolidOptions& options) {
    app.option_defaults()->group(solid_group);
    add_number(app, "--e", options.outward, growth_number, "Extension: grows the shape, texture widths");
    add_number(app, "--b", options.bevel, growth_number, "Bevel: grows it this much more per unit of depth, texture widths");
    add_number(app, "--c", options.chamfer, depth_number, "Chamfer: the depth from which on walls are upright again, 0 to 1 (with --b)");
    add_number(app, "--axis", options.axis, axis_number, "Revolution: u of the axis; what lies right of it is turned (default 0)");
    add_number(app, "--depth-scale", options.depth_scale, positive_number, "Extrusion: depth of the relief, texture widths (default 0.2)");
    add_choice(app, "--scheme", options.scheme, scheme_words, "Steps that never enter the solid, or as printed in the papers (default corrected)");
}

void add_solid_kind_options(CLI::App& app, SolidOptions& options) {
    app.option_defaults()->group(solid_group);
    add_choice(app, "--solid", options.kind, solid_words, "What is made of the shape (default extrusion)");
    add_choice(app, "--on", options.on_plane, place_words, "Extrusion: standing in a plane, or in a box of the map's size (default plane)");
}

Result<void> refuse_given(const CLI::App& app, const std::string& group, std::initializer_list<const char*> flags, const std::string& why) {
    for (const CLI::Option* option : app.get_options()) {
        const std::string name = option->get_name();
        const bool listed = std::any_of(flags.begin(), flags.end(), [&](const char* flag) { return name == flag; });
        if (option->count() > 0 && ((!group.empty() && option->get_group() == group) || listed)) return fail(ErrorCode::usage, name + ": " + why);
    }
    return {};
}

Result<ShapeSolid> resolve_solid(const SolidOptions& options) {
    constexpr double default_depth = 0.2;
    ShapeSolid solid;
    solid.kind = options.kind.value_or(SolidKind::extrusion);
    const bool extruded = solid.kind == SolidKind::extrusion;
    if (options.chamfer && !options.bevel) return fail(ErrorCode::usage, "--c: needs --b: a chamfer ends a bevel");
    if (options.axis && extruded) return fail(ErrorCode::usage, "--axis: is for --solid revolution");
    if (options.depth_scale && !extruded) return fail(ErrorCode::usage, "--depth-scale: is for --solid extrusion; a revolution is as high as its map");
    if (options.on_plane.value_or(false) && !extruded) return fail(ErrorCode::usage, "--on plane: is for --solid extrusion; a revolution stands in a box");
    solid.on_plane = options.on_plane.value_or(extruded);
    solid.outward = options.outward.value_or(0);
    solid.bevel = options.bevel.value_or(0);
    solid.chamfer = options.chamfer.value_or(solid.chamfer);
    solid.axis = options.axis.value_or(0);
    solid.depth_scale = options.depth_scale.value_or(default_depth);
    return solid;
}

} // namespace reliefbake
