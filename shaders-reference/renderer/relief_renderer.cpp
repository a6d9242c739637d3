#include "shaders-reference/renderer/relief_renderer.h"

#include "shaders-reference/renderer/map_textures.h"
#include "shaders-reference/renderer/max_mip.h"
#include "shaders-reference/renderer/offscreen.h"
#include "shaders-reference/renderer/resolve.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <optional>

namespace reliefbake {
namespace {

constexpr float endless_reach = 4096; ///< half the size of an endless plane, tiles: farther, float32 rays are too coarse
constexpr GLint map_unit = 0;
constexpr GLint given_unit = 1;
constexpr GLint cones_unit = 2;   ///< and 3
constexpr GLint max_mip_unit = 4;
constexpr GLint horizon_unit = 5; ///< and 6
constexpr int planes = 5; ///< colour, hit, counts, ray, light

struct CompiledProgram {
    ShaderConfig config;
    GlProgram program;
};

GlTexture upload_max_mip(const GlFunctions& gl, const MaxMip& mip) {
    const Image<float>& cells = mip.levels.front();
    GlTexture texture = make_texture(gl, {GL_R32F, GL_RED, GL_FLOAT}, cells.width(), cells.height(), cells.data());
    for (int k = 1; k <= mip.top(); ++k) {
        const Image<float>& level = mip.levels[std::size_t(k)];
        gl.TexImage2D(GL_TEXTURE_2D, k, GL_R32F, level.width(), level.height(), 0, GL_RED, GL_FLOAT, level.data());
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, mip.top());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    return texture;
}

/// What the map's cones do not serve.
Result<void> check_served(const ShaderConfig& config, bool cones) {
    const TechniqueInfo& technique = technique_info(config.technique);
    const std::string name(technique.word);
    if (technique.cones && !cones) return fail(ErrorCode::usage, "technique " + name + " needs cones; this map has none");
    if (config.technique == Technique::cone_published && std::max(config.sectors, config.levels) > 1)
        return fail(ErrorCode::usage, "technique " + name + " is for one cone a texel; this map has several");
    if (config.technique == Technique::cone_raw && config.lookup == ConeLookup::cell)
        return fail(ErrorCode::usage, "technique " + name + " is for cones of texels; this map's are of cells");
    if (config.empty_cones) return {};
    const char* const why = cones ? "; this map's cones are not" : "; this map has no cones";
    if (config.shadow == Shadow::cone_soft) return fail(ErrorCode::usage, std::string("cone-soft shadows need conservative cones") + why);
    if (config.ambient != Ambient::none) return fail(ErrorCode::usage, std::string("ambient occlusion needs conservative cones") + why);
    return {};
}

/// Empty, or why horizons do not belong to a map. Other bits are welcome: shadows need fewer than heights.
std::string horizon_misfit(const BumpMap& horizons, const ReliefMapInfo& info, const TexelGrid& grid) {
    const TexelGrid& other = horizons.grid;
    if (horizons.info.kind != BumpKind::horizon) return "shadows need a map of kind horizon";
    if (other.width != grid.width || other.height != grid.height || other.pixel_aspect != grid.pixel_aspect)
        return "the horizons are of a map of other proportions";
    if (other.wrap_x != grid.wrap_x || other.wrap_y != grid.wrap_y) return "the horizons were baked for another wrap than the map";
    const bool known = !info.source_hash.empty() && !horizons.info.source_hash.empty();
    if (known && info.source_hash != horizons.info.source_hash) return "the horizons were baked from other heights than the map";
    return "";
}

} // namespace

struct ReliefRenderer::State {
    Offscreen screen; ///< outlives what is made with it
    std::vector<CompiledProgram> programs;
    MapTextures textures;
    GlTexture horizons[2];
    double horizon_scale = 0; ///< depth of the relief that they were baked for; 0: none loaded
    GlTexture max_mip;        ///< made when a technique first asks for it
    MaxMip max_mip_size;      ///< without its levels
    int max_mip_top = 0;
    Image<float> depth;       ///< what the max mip is made of
    ShaderConfig decoder;     ///< of the map
    bool has_cones = false;
    ReliefMapInfo info;
    TexelGrid grid;
    double delta = 0;

    ~State() { screen.make_current(); }

    Result<GLuint> program(const ShaderConfig& config);
    void prepare_max_mip();
    void set_uniforms(GLuint program, const RenderOptions& options) const;
};

Result<GLuint> ReliefRenderer::State::program(const ShaderConfig& config) {
    for (const CompiledProgram& known : programs)
        if (known.config == config) return known.program.name();
    Result<GlProgram> made = make_program(screen.gl(), vertex_source(Prelude::core330), fragment_source(config, Prelude::core330));
    if (!made) return tl::unexpected<Error>(made.error());
    programs.push_back({config, std::move(*made)});
    return programs.back().program.name();
}

void ReliefRenderer::State::prepare_max_mip() {
    if (max_mip.name()) return;
    MaxMip mip = build_max_mip(depth, grid);
    screen.gl().ActiveTexture(GL_TEXTURE0 + max_mip_unit);
    max_mip = upload_max_mip(screen.gl(), mip);
    max_mip_top = mip.top();
    max_mip_size.cells_x = mip.cells_x, max_mip_size.cells_y = mip.cells_y;
}

void ReliefRenderer::State::set_uniforms(GLuint program, const RenderOptions& options) const {
    const bool repeats = grid.wrap_x == Wrap::repeat && grid.wrap_y == Wrap::repeat;
    const int tiles = repeats ? options.tiles : 1;
    const Camera camera = make_camera(grid, options.view, tiles, double(screen.width()) / screen.height());
    const float low = repeats && options.endless ? -endless_reach : 0;
    const float high = repeats && options.endless ? endless_reach : float(tiles);
    const Uniforms uniforms(screen.gl(), program);
    set_map_uniforms(uniforms, {map_unit, cones_unit}, info, grid, delta);
    uniforms.set("given_hits", given_unit);
    uniforms.set("relief_max_mip", max_mip_unit);
    uniforms.set("relief_mip_cells", max_mip_size.cells_x, max_mip_size.cells_y);
    uniforms.set("relief_mip_top", max_mip_top);
    uniforms.set("horizon_map_0", horizon_unit);
    uniforms.set("horizon_map_1", horizon_unit + 1);
    uniforms.set("horizon_diagonal", float(horizon_angle(grid, 1)));
    uniforms.set("horizon_deepen", horizon_scale > 0 ? float(info.depth_scale / horizon_scale) : 1.0f);
    uniforms.set("relief_max_steps", options.max_steps);
    uniforms.set("relief_epsilon", options.epsilon);
    uniforms.set("relief_linear_steps", options.linear_steps);
    uniforms.set("relief_binary_steps", options.binary_steps);
    uniforms.set("scene_sun", sun_direction(options.sun, options.view));
    uniforms.set("scene_shadow_steps", options.shadow_steps);
    uniforms.set("camera_eye", camera.eye);
    uniforms.set("camera_forward", camera.forward);
    uniforms.set("camera_right", camera.right);
    uniforms.set("camera_up", camera.up);
    uniforms.set("camera_range", float(camera.near), float(camera.far));
    uniforms.set("picture_size", float(screen.width()), float(screen.height()));
    uniforms.set("plane_bounds", Quad{low, low, high, high});
}

ReliefRenderer::ReliefRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
ReliefRenderer::ReliefRenderer(ReliefRenderer&&) noexcept = default;
ReliefRenderer& ReliefRenderer::operator=(ReliefRenderer&&) noexcept = default;
ReliefRenderer::~ReliefRenderer() = default;

Result<ReliefRenderer> ReliefRenderer::create(RendererBackend backend) {
    auto state = std::make_unique<State>();
    if (Result<void> opened = state->screen.open(backend); !opened) return tl::unexpected<Error>(opened.error());
    return ReliefRenderer(std::move(state));
}

Result<void> ReliefRenderer::load(const ReliefMap& map, SamplerFilter filter) {
    state_->screen.make_current();
    Result<MapTextures> textures = upload_map(state_->screen, map, filter);
    if (!textures) return tl::unexpected<Error>(textures.error());
    state_->textures = std::move(*textures);
    state_->max_mip = GlTexture();
    state_->horizon_scale = 0;
    state_->depth = map.depth;
    state_->decoder = shader_config(map, Technique::cone, false);
    state_->has_cones = has_cones(map);
    state_->info = map.info;
    state_->grid = map.grid;
    state_->delta = filter == SamplerFilter::fixed8 ? map.info.filter_delta : 0;
    return {};
}

Result<void> ReliefRenderer::load_horizons(const BumpMap& horizons) {
    State& state = *state_;
    const std::string words = horizon_misfit(horizons, state.info, state.grid);
    if (!words.empty()) return fail(ErrorCode::usage, words);
    state.screen.make_current();
    for (std::size_t group = 0; group < 2; ++group)
        state.horizons[group] = upload_group(state.screen.gl(), horizons.planes, group, horizons.grid, storage_of(horizons.info.bits, SamplerFilter::exact));
    state.horizon_scale = horizons.info.depth_scale;
    return {};
}

Result<Rendering> ReliefRenderer::render(const RenderOptions& options) {
    State& state = *state_;
    const Offscreen& screen = state.screen;
    const int width = options.width * options.supersample;
    const int height = options.height * options.supersample;
    if (Result<void> fits = screen.check_size(options.width, options.height, options.supersample); !fits) return tl::unexpected<Error>(fits.error());
    ShaderConfig config = state.decoder;
    config.technique = options.technique;
    config.exact_finish = options.exact_finish;
    config.shadow = options.shadow;
    config.ambient = options.ambient.value_or(config.ambient);
    if (Result<void> served = check_served(config, state.has_cones); !served) return tl::unexpected<Error>(served.error());
    if (options.shadow == Shadow::horizon && state.horizon_scale == 0)
        return fail(ErrorCode::usage, std::string("horizon shadows need a horizon map"));
    screen.make_current();
    const Result<GLuint> program = state.program(config);
    if (!program) return tl::unexpected<Error>(program.error());
    if (Result<void> ready = state.screen.prepare(width, height, planes); !ready) return tl::unexpected<Error>(ready.error());

    // Bind the map, its cones, the pyramid, and the hits that were given.
    if (options.technique == Technique::max_mip) state.prepare_max_mip();
    screen.bind(cones_unit, state.textures.cones[0]);
    screen.bind(cones_unit + 1, state.textures.cones[1]);
    screen.bind(max_mip_unit, state.max_mip);
    screen.bind(horizon_unit, state.horizons[0]);
    screen.bind(horizon_unit + 1, state.horizons[1]);
    const GlTexture given = screen.bind_given(given_unit, options.given);
    screen.bind(map_unit, state.textures.map);

    // Draw.
    const std::clock_t cpu_start = std::clock();
    const auto start = std::chrono::steady_clock::now();
    screen.begin(*program);
    state.set_uniforms(*program, options);
    screen.draw();
    Rendering rendering;
    rendering.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    rendering.cpu_seconds = double(std::clock() - cpu_start) / CLOCKS_PER_SEC;

    // Read back.
    rendering.colour = resolve_picture(screen.read_plane(0), options.supersample);
    rendering.hit = screen.read_plane(1);
    rendering.counts = screen.read_plane(2);
    rendering.ray = screen.read_plane(3);
    rendering.light = screen.read_plane(4);
    rendering.depth = screen.read_depth();
    if (Result<void> drawn = screen.check_errors(); !drawn) return tl::unexpected<Error>(drawn.error());
    return rendering;
}

Result<Rendering> render(const ReliefMap& map, const RenderOptions& options, RendererBackend backend, SamplerFilter filter) {
    Result<ReliefRenderer> renderer = ReliefRenderer::create(backend);
    if (!renderer) return tl::unexpected<Error>(renderer.error());
    if (Result<void> loaded = renderer->load(map, filter); !loaded) return tl::unexpected<Error>(loaded.error());
    return renderer->render(options);
}

} // namespace reliefbake
