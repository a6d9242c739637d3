#include "cli/render/render_shape.h"

#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "formats/bump_file.h"
#include "formats/read_image.h"
#include "formats/shape_file.h"
#include "formats/write_image.h"

#include <cmath>

namespace reliefbake {

namespace {

const Words<Projection> projection_words = {{"cylindrical", Projection::cylindrical}, {"spherical", Projection::spherical}};

double linear_light(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

/// A picture's channels as linear light; a grey one three times. 8- and 16-bit pictures hold sRGB, floats linear light.
Result<ColourTexture> read_colour(const std::string& file) {
    ReadOptions options;
    const Result<SourceImage> probe = read_image(file, options);
    if (!probe) return tl::unexpected(probe.error());
    const bool coloured = probe->channel_names.size() >= 3;
    ColourTexture texture;
    for (auto [channel, plane] : {std::pair{"R", &texture.red}, std::pair{"G", &texture.green}, std::pair{"B", &texture.blue}}) {
        options.channel = coloured ? channel : "";
        Result<SourceImage> image = read_image(file, options);
        if (!image) return tl::unexpected(image.error());
        for (float& value : image->plane) {
            if (!std::isfinite(value)) return fail(ErrorCode::bad_data, file + ": a texture holds numbers; found NaN or infinity");
            if (image->is_integer) value = float(linear_light(value));
        }
        *plane = std::move(image->plane);
    }
    return texture;
}

/// The derivatives of a bump map, both per texture width.
Result<BumpTexture> read_bump(const std::string& file) {
    Result<BumpMap> map = read_bump_map(file);
    if (!map) return tl::unexpected(map.error());
    if (map->info.kind != BumpKind::derivative)
        return fail(ErrorCode::bad_data, file + ": expected derivatives (reliefbake bump), found a map of kind " + word_of(map->info.kind));
    for (float& value : map->planes[0]) value = decode_bump(value, map->info);
    for (float& value : map->planes[1]) value = float(decode_bump(value, map->info) / map->grid.aspect());
    return BumpTexture{map->grid, std::move(map->planes[0]), std::move(map->planes[1])};
}

/// Loads what --texture and --bump name.
Result<void> lay_textures(ShapeRenderer& renderer, const RenderShapeOptions& options) {
    ColourTexture colour;
    BumpTexture bump;
    if (!options.texture.empty()) {
        Result<ColourTexture> read = read_colour(options.texture);
        if (!read) return tl::unexpected(read.error());
        colour = std::move(*read);
    }
    if (!options.bump.empty()) {
        Result<BumpTexture> read = read_bump(options.bump);
        if (!read) return tl::unexpected(read.error());
        bump = std::move(*read);
    }
    return renderer.set_textures(options.texture.empty() ? nullptr : &colour, options.bump.empty() ? nullptr : &bump);
}

Result<ShapeRenderOptions> resolve_picture(const ShapePicture& given, const RenderShapeOptions& options) {
    const Result<ShapeSolid> solid = resolve_solid(options.solid);
    if (!solid) return tl::unexpected(solid.error());
    const bool extruded = solid->kind == SolidKind::extrusion;
    if (options.projection && extruded) return fail(ErrorCode::usage, "--projection: is for --solid revolution");
    if (options.bump_scale && options.bump.empty()) return fail(ErrorCode::usage, "--bump-scale: needs --bump");
    if (options.texture_tiles && options.bump.empty() && options.texture.empty())
        return fail(ErrorCode::usage, "--texture-tiles: needs --texture or --bump");
    if (solid->on_plane && given.picture.view.angle >= 90)
        return fail(ErrorCode::usage, "--view: a plane is seen from degrees below 90; a box (--on box) from all sides");
    if (!solid->on_plane && given.picture.view.span > 0) return fail(ErrorCode::usage, "--span: is for planes; a box is seen whole");

    const CircleCounts counts = published_counts(solid->kind);
    ShapeRenderOptions picture;
    picture.solid = *solid;
    picture.solid.tiles = given.picture.tiles;
    picture.scheme = options.solid.scheme.value_or(CircleScheme::corrected);
    picture.steps = given.steps.value_or(counts.steps);
    picture.binary_steps = given.binary_steps.value_or(counts.binary_steps);
    picture.projection = options.projection.value_or(extruded ? Projection::planar : Projection::cylindrical);
    picture.bump_scale = options.bump_scale.value_or(1);
    if (options.texture_tiles) std::tie(picture.texture_tiles_u, picture.texture_tiles_v) = *options.texture_tiles;
    picture.width = given.picture.width, picture.height = given.picture.height;
    picture.supersample = given.picture.supersample;
    picture.view = given.picture.view;
    picture.sun = given.picture.sun;
    picture.shadow = given.picture.shadow == Shadow::hard;
    return picture;
}

} // namespace

void add_render_shape_options(CLI::App& app, RenderShapeOptions& options) {
    add_solid_kind_options(app, options.solid);
    add_solid_options(app, options.solid);
    add_choice(app, "--projection", options.projection, projection_words, "Revolution: how textures lie on it (default cylindrical)");
    app.add_option("--texture", options.texture, "Picture to lay on the solid")->type_name("FILE");
    app.add_option("--bump", options.bump, "Derivatives of a height map, for bumps (reliefbake bump)")->type_name("FILE");
    add_number(app, "--bump-scale", options.bump_scale, finite_number, "Depth of the bumps, texture widths (default 1)");
    app.add_option_function<std::string>(
           "--texture-tiles", [&options](const std::string& given) { options.texture_tiles = require_repeats("--texture-tiles", given); },
           "Repeats of the textures over the solid (default 1)")
        ->type_name("N[,M]");
}

Result<void> render_shape(const ShapePicture& given, const RenderShapeOptions& options) {
    if (given.picture.shadow != Shadow::none && given.picture.shadow != Shadow::hard)
        return fail(ErrorCode::usage, "--shadow: solids of shape maps cast hard shadows (--shadow hard)");
    const Result<ShapeRenderOptions> picture = resolve_picture(given, options);
    if (!picture) return tl::unexpected(picture.error());
    const Result<ShapeMap> map = read_shape_map(given.file, given.max_bytes);
    if (!map) return tl::unexpected(map.error());
    Result<ShapeRenderer> renderer = ShapeRenderer::create(given.backend);
    if (!renderer) return tl::unexpected(renderer.error());
    if (Result<void> loaded = renderer->load(*map); !loaded) return loaded;
    if (Result<void> laid = lay_textures(*renderer, options); !laid) return laid;
    const Result<ShapeRendering> rendering = renderer->render(*picture);
    if (!rendering) return fail(rendering.error().code, given.file + ": " + rendering.error().message);
    return write_png(given.output, rendering->colour.width, rendering->colour.height, 3, rendering->colour.rgb);
}

} // namespace reliefbake
