#include "shaders-reference/renderer/shape_renderer.h"

#include "shaders-reference/renderer/offscreen.h"
#include "shaders-reference/renderer/resolve.h"
#include "shaders-reference/renderer/shape_texture.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace reliefbake {
namespace {

constexpr int map_unit = 0, given_unit = 1, colour_unit = 2, bump_unit = 3;
enum Plane { colour_plane, origin_plane, counts_plane, direction_plane, normal_plane, bumped_plane, plane_count };

struct CompiledProgram {
    SolidConfig config;
    GlProgram program;
};

bool repeats(const TexelGrid& grid) { return grid.wrap_x == Wrap::repeat && grid.wrap_y == Wrap::repeat; }

/// The farthest that the solid reaches from the shape, texture widths.
double growth(const ShapeSolid& solid) {
    const double deepest = solid.kind == SolidKind::extrusion ? 1 : solid.tiles;
    return solid.outward + (solid.bevel > 0 ? solid.bevel * std::min(deepest, solid.chamfer) : 0);
}

/// `bounded`: the map knows distances below tau alone; of an empty shape, or with f < 1.
Result<void> check_solid(const ShapeRenderOptions& options, const ShapeMapInfo& info, const TexelGrid& grid, bool bounded) {
    const ShapeSolid& solid = options.solid;
    const auto wrong = [](const std::string& message) { return fail(ErrorCode::usage, message); };
    if (!(solid.outward >= 0 && solid.outward <= most_bevel)) return wrong("e: expected a length from 0 to 1e6 texture widths");
    if (!(solid.bevel >= 0 && solid.bevel <= most_bevel)) return wrong("b: expected a number from 0 to 1e6");
    if (!(solid.chamfer >= 0)) return wrong("c: expected a number from 0 on");
    if (!(solid.axis >= 0 && solid.axis < 1)) return wrong("axis: expected a number from 0 to below 1");
    if (!(solid.depth_scale > 0 && std::isfinite(solid.depth_scale))) return wrong("depth scale: expected a number greater than 0");
    if (solid.tiles < 1) return wrong("tiles: expected 1 or more");
    if (solid.tiles > 1 && !repeats(grid)) return wrong("several tiles need a map that repeats (reliefbake shape --wrap); this one does not");
    if (solid.on_plane && solid.kind == SolidKind::revolution) return wrong("a revolution stands in a shape box, not on a plane");
    if ((options.projection == Projection::planar) != (solid.kind == SolidKind::extrusion))
        return wrong("projection planar is for extrusions, cylindrical and spherical are for revolutions");
    if (bounded && growth(solid) >= info.tau)
        return wrong("e + b min(z, c) reaches " + std::to_string(growth(solid)) + " texture widths from the shape; this map knows distances below " +
                     std::to_string(info.tau) + (info.scale_f < 1 ? ": bake it with a larger --scale-f" : ": its shape is empty"));
    return {};
}

/// The middle and radius of the ball around the domain, in the world.
Camera box_camera(const ShapeSolid& solid, double aspect, const View& view, double picture_aspect) {
    const double n = solid.tiles;
    if (solid.kind == SolidKind::revolution)
        return make_orbit_camera({0, 0, -0.5 * aspect * n}, std::hypot(1 - solid.axis, 0.5 * aspect * n), view, picture_aspect);
    return make_orbit_camera({0.5 * n, -0.5 * n * aspect, -0.5 * solid.depth_scale}, 0.5 * std::hypot(n, n * aspect, solid.depth_scale), view,
                             picture_aspect);
}

SolidConfig config_of(const ShapeRenderOptions& options, const ShapeMapInfo& info, bool colour, bool bump) {
    SolidConfig config;
    config.unorm = is_unorm(info.bits);
    config.signed_distance = info.signed_distance;
    config.kind = options.solid.kind;
    config.on_plane = options.solid.on_plane;
    config.scheme = options.scheme;
    config.projection = options.projection;
    config.colour = colour;
    config.bump = bump;
    config.shadow = options.shadow;
    return config;
}

} // namespace

struct ShapeRenderer::State {
    Offscreen screen; ///< outlives what is made with it
    std::vector<CompiledProgram> programs;
    GlTexture map, colour, bump;
    ShapeMapInfo info;
    TexelGrid grid;
    double delta = 0;
    bool bounded = false;

    ~State() { screen.make_current(); }

    Result<GLuint> program(const SolidConfig& config);
    void set_uniforms(GLuint program, const ShapeRenderOptions& options) const;
};

Result<GLuint> ShapeRenderer::State::program(const SolidConfig& config) {
    for (const CompiledProgram& known : programs)
        if (known.config == config) return known.program.name();
    Result<GlProgram> made = make_program(screen.gl(), vertex_source(Prelude::core330), solid_fragment_source(config, Prelude::core330));
    if (!made) return tl::unexpected<Error>(made.error());
    programs.push_back({config, std::move(*made)});
    return programs.back().program.name();
}

void ShapeRenderer::State::set_uniforms(GLuint program, const ShapeRenderOptions& options) const {
    const ShapeSolid& solid = options.solid;
    const double picture_aspect = double(screen.width()) / screen.height();
    const Camera camera = solid.on_plane ? make_camera(grid, options.view, solid.tiles, picture_aspect)
                                         : box_camera(solid, grid.aspect(), options.view, picture_aspect);
    const Uniforms uniforms(screen.gl(), program);
    set_shape_uniforms(uniforms, map_unit, info, grid, delta);
    set_profile_uniforms(uniforms, solid, {options.steps, options.binary_steps}, options.epsilon / grid.width);
    uniforms.set("given_hits", given_unit);
    uniforms.set("solid_colour", colour_unit);
    uniforms.set("solid_bump", bump_unit);
    uniforms.set("solid_axis", float(solid.axis));
    uniforms.set("solid_depth", float(solid.depth_scale));
    uniforms.set("solid_tiles", float(solid.tiles));
    uniforms.set("solid_repeat", float(grid.wrap_x == Wrap::repeat), float(grid.wrap_y == Wrap::repeat));
    uniforms.set("solid_bump_scale", float(options.bump_scale));
    uniforms.set("solid_texture_tiles", float(options.texture_tiles_u), float(options.texture_tiles_v));
    uniforms.set("scene_sun", sun_direction(options.sun, options.view));
    uniforms.set("camera_eye", camera.eye);
    uniforms.set("camera_forward", camera.forward);
    uniforms.set("camera_right", camera.right);
    uniforms.set("camera_up", camera.up);
    uniforms.set("camera_range", float(camera.near), float(camera.far));
    uniforms.set("picture_size", float(screen.width()), float(screen.height()));
    uniforms.set("plane_bounds", Quad{0, 0, float(solid.tiles), float(solid.tiles)});
}

ShapeRenderer::ShapeRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
ShapeRenderer::ShapeRenderer(ShapeRenderer&&) noexcept = default;
ShapeRenderer& ShapeRenderer::operator=(ShapeRenderer&&) noexcept = default;
ShapeRenderer::~ShapeRenderer() = default;

Result<ShapeRenderer> ShapeRenderer::create(RendererBackend backend) {
    auto state = std::make_unique<State>();
    if (Result<void> opened = state->screen.open(backend); !opened) return tl::unexpected<Error>(opened.error());
    return ShapeRenderer(std::move(state));
}

Result<void> ShapeRenderer::load(const ShapeMap& map, SamplerFilter filter) {
    state_->screen.make_current();
    Result<GlTexture> texture = upload_shape(state_->screen, map, filter);
    if (!texture) return tl::unexpected<Error>(texture.error());
    state_->map = std::move(*texture);
    state_->info = map.info;
    state_->grid = map.grid;
    state_->bounded = map.info.scale_f < 1 || is_empty(map);
    state_->delta = filter == SamplerFilter::fixed8 ? map.info.filter_delta : 0;
    return {};
}

Result<void> ShapeRenderer::set_textures(const ColourTexture* colour, const BumpTexture* bump) {
    const int largest = state_->screen.largest();
    const auto fits = [largest](const Image<float>& plane) { return std::max(plane.width(), plane.height()) <= largest; };
    if ((colour && !fits(colour->red)) || (bump && !fits(bump->slope_u)))
        return fail(ErrorCode::usage, "a texture is larger than the OpenGL driver's (" + std::to_string(largest) + " texels a side)");
    state_->screen.make_current();
    state_->colour = GlTexture();
    state_->bump = GlTexture();
    if (colour) {
        TexelGrid grid;
        grid.width = colour->red.width(), grid.height = colour->red.height();
        state_->colour = upload_texture(state_->screen.gl(), {&colour->red, &colour->green, &colour->blue, nullptr}, grid, TexelStorage::float32);
    }
    if (bump) state_->bump = upload_texture(state_->screen.gl(), {&bump->slope_u, &bump->slope_v, nullptr, nullptr}, bump->grid, TexelStorage::float32);
    return {};
}

Result<ShapeRendering> ShapeRenderer::render(const ShapeRenderOptions& options) {
    State& state = *state_;
    Offscreen& screen = state.screen;
    const int width = options.width * options.supersample, height = options.height * options.supersample;
    if (Result<void> fits = screen.check_size(options.width, options.height, options.supersample); !fits) return tl::unexpected<Error>(fits.error());
    if (Result<void> checked = check_solid(options, state.info, state.grid, state.bounded); !checked) return tl::unexpected<Error>(checked.error());
    screen.make_current();
    const Result<GLuint> program = state.program(config_of(options, state.info, state.colour.name() != 0, state.bump.name() != 0));
    if (!program) return tl::unexpected<Error>(program.error());
    if (Result<void> ready = screen.prepare(width, height, plane_count); !ready) return tl::unexpected<Error>(ready.error());

    // Bind the map, the textures on it, and the hits that were given.
    screen.bind(colour_unit, state.colour);
    screen.bind(bump_unit, state.bump);
    const GlTexture given = screen.bind_given(given_unit, options.given);
    screen.bind(map_unit, state.map);

    // Draw.
    const auto start = std::chrono::steady_clock::now();
    screen.begin(*program);
    state.set_uniforms(*program, options);
    screen.draw();
    ShapeRendering rendering;
    rendering.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    // Read back.
    rendering.colour = resolve_picture(screen.read_plane(colour_plane), options.supersample);
    rendering.origin = screen.read_plane(origin_plane);
    rendering.counts = screen.read_plane(counts_plane);
    rendering.direction = screen.read_plane(direction_plane);
    rendering.normal = screen.read_plane(normal_plane);
    rendering.bumped = screen.read_plane(bumped_plane);
    rendering.depth = screen.read_depth();
    if (Result<void> drawn = screen.check_errors(); !drawn) return tl::unexpected<Error>(drawn.error());
    return rendering;
}

} // namespace reliefbake
