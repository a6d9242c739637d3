#include "shaders-reference/renderer/mesh_renderer.h"

#include "shaders-reference/renderer/map_textures.h"
#include "shaders-reference/renderer/mesh_source.h"
#include "shaders-reference/renderer/mesh_vertices.h"
#include "shaders-reference/renderer/resolve.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>

namespace reliefbake {

namespace {

constexpr int map_unit = 0, cones_unit = 1; // and 2
enum Plane { colour_plane, place_plane, plane_count };

struct CompiledProgram {
    MeshConfig config;
    GlProgram program;
};

/// A mesh on the GPU.
struct Object {
    GlVertexArray layout;
    GlBuffer buffer;
    GLsizei vertices = 0;
    bool quadrics = false;
    MeshRelief relief;
    bool ends_u = false, ends_v = false;
};

Object upload(const GlFunctions& gl, const std::vector<MeshVertex>& vertices) {
    Object object;
    GLuint name = 0;
    gl.GenVertexArrays(1, &name);
    object.layout = GlVertexArray(gl, name);
    gl.BindVertexArray(name);
    gl.GenBuffers(1, &name);
    object.buffer = GlBuffer(gl, name);
    gl.BindBuffer(GL_ARRAY_BUFFER, name);
    gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(MeshVertex)), vertices.data(), GL_STATIC_DRAW);
    const struct { int floats; std::size_t offset; } attributes[] = {
        {3, offsetof(MeshVertex, position)}, {3, offsetof(MeshVertex, normal)},  {4, offsetof(MeshVertex, tangent)},
        {2, offsetof(MeshVertex, uv)},       {3, offsetof(MeshVertex, quadric)}, {4, offsetof(MeshVertex, chart)},
        {3, offsetof(MeshVertex, bend_u)},   {3, offsetof(MeshVertex, bend_v)}};
    GLuint index = 0;
    for (const auto& attribute : attributes) {
        gl.EnableVertexAttribArray(index);
        gl.VertexAttribPointer(index++, attribute.floats, GL_FLOAT, GL_FALSE, sizeof(MeshVertex), reinterpret_cast<const void*>(attribute.offset));
    }
    object.vertices = GLsizei(vertices.size());
    return object;
}

bool sinks_cone(Correction correction) { return correction == Correction::cone || correction == Correction::cone_published; }
bool is_published(Correction correction) { return correction == Correction::ray_published || correction == Correction::cone_published; }

int path_of(Correction correction) {
    if (is_published(correction)) return published_path;
    return correction == Correction::none ? 0 : correction == Correction::bent ? 2 : 1;
}

} // namespace

struct MeshRenderer::State {
    Offscreen screen; ///< outlives what is made with it
    std::vector<CompiledProgram> programs;
    MapTextures relief;
    GlTexture shape;
    std::vector<Object> objects;
    bool solid = false;
    bool has_cones = false;
    ShaderConfig decoder;
    ReliefMapInfo info;
    ShapeMapInfo shape_info;
    TexelGrid grid;

    ~State() { screen.make_current(); }

    Result<void> check(const MeshRenderOptions& options) const;
    Result<GLuint> program(const MeshRenderOptions& options);
    void set_uniforms(const Uniforms& uniforms, const MeshRenderOptions& options) const;
};

Result<void> MeshRenderer::State::check(const MeshRenderOptions& options) const {
    const auto wrong = [](const char* message) { return fail(ErrorCode::usage, message); };
    if (!solid && !relief.map.name()) return wrong("no map has been loaded");
    for (const Object& object : objects) {
        if (options.correction != Correction::none && !object.quadrics)
            return wrong("the mesh has no quadrics: bake them with `reliefbake quadric`, or leave the correction out (none)");
        if (!(object.relief.depth_scale > 0 && std::isfinite(object.relief.depth_scale))) return wrong("depth scale: expected a number greater than 0");
    }
    if (solid) return sinks_cone(options.correction) ? wrong("corrections of the cone are for cone maps; a shape map has none") : Result<void>();
    if (is_published(options.correction) && (options.technique == Technique::binary || std::max(decoder.sectors, decoder.levels) > 1))
        return wrong("the published corrections are for maps of one cone a texel, followed by their cones");
    switch (options.technique) {
    case Technique::cone:
    case Technique::relaxed: return has_cones ? Result<void>() : wrong("this technique needs cones; the map has none");
    case Technique::binary: return sinks_cone(options.correction) ? wrong("correction cone needs a technique that reads cones") : Result<void>();
    default: return wrong("on meshes the techniques are cone, relaxed and binary");
    }
}

Result<GLuint> MeshRenderer::State::program(const MeshRenderOptions& options) {
    MeshConfig config;
    config.solid = solid;
    config.shape_unorm = is_unorm(shape_info.bits), config.shape_signed = shape_info.signed_distance;
    config.decoder = decoder;
    config.path = path_of(options.correction);
    config.sunk_cone = sinks_cone(options.correction);
    config.halves = is_published(options.correction) && options.technique == Technique::relaxed;
    config.search = options.technique == Technique::binary;
    config.twist = options.twist;
    for (const CompiledProgram& known : programs)
        if (known.config == config) return known.program.name();
    Result<GlProgram> made = make_program(screen.gl(), mesh_vertex_source(Prelude::core330), mesh_fragment_source(config, Prelude::core330));
    if (!made) return tl::unexpected<Error>(made.error());
    programs.push_back({config, std::move(*made)});
    return programs.back().program.name();
}

void MeshRenderer::State::set_uniforms(const Uniforms& uniforms, const MeshRenderOptions& options) const {
    if (solid) {
        set_shape_uniforms(uniforms, map_unit, shape_info, grid, 0);
        set_profile_uniforms(uniforms, options.solid, {options.max_steps, options.binary_steps}, double(options.epsilon) / grid.width);
    } else {
        set_map_uniforms(uniforms, {map_unit, cones_unit}, info, grid, 0);
        uniforms.set("relief_max_steps", options.max_steps);
        uniforms.set("relief_linear_steps", options.linear_steps);
        uniforms.set("relief_binary_steps", options.binary_steps);
        uniforms.set("relief_epsilon", options.epsilon);
        uniforms.set("mesh_normal_scale", float(info.depth_scale));
    }
    uniforms.set("mesh_aspect", float(grid.aspect()));
    uniforms.set("mesh_repeat", float(grid.wrap_x == Wrap::repeat), float(grid.wrap_y == Wrap::repeat));
    uniforms.set("scene_sun", options.sun);
    uniforms.set("camera_eye", options.camera.eye);
    uniforms.set("camera_forward", options.camera.forward);
    uniforms.set("camera_right", options.camera.right);
    uniforms.set("camera_up", options.camera.up);
    uniforms.set("camera_range", float(options.camera.near), float(options.camera.far));
}

MeshRenderer::MeshRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
MeshRenderer::MeshRenderer(MeshRenderer&&) noexcept = default;
MeshRenderer& MeshRenderer::operator=(MeshRenderer&&) noexcept = default;
MeshRenderer::~MeshRenderer() = default;

Result<MeshRenderer> MeshRenderer::create(RendererBackend backend) {
    auto state = std::make_unique<State>();
    if (Result<void> opened = state->screen.open(backend); !opened) return tl::unexpected<Error>(opened.error());
    return MeshRenderer(std::move(state));
}

Result<void> MeshRenderer::load(const ReliefMap& map) {
    State& state = *state_;
    if (map.info.kind == "cone-pieces") return fail(ErrorCode::usage, "cones in pieces are for planes; bake another map of cones for meshes");
    state.screen.make_current();
    Result<MapTextures> textures = upload_map(state.screen, map, SamplerFilter::exact);
    if (!textures) return tl::unexpected<Error>(textures.error());
    state.relief = std::move(*textures);
    state.solid = false;
    state.decoder = shader_config(map, Technique::cone, false);
    state.has_cones = has_cones(map);
    state.info = map.info;
    state.grid = map.grid;
    return {};
}

Result<void> MeshRenderer::load(const ShapeMap& map) {
    State& state = *state_;
    state.screen.make_current();
    Result<GlTexture> texture = upload_shape(state.screen, map, SamplerFilter::exact);
    if (!texture) return tl::unexpected<Error>(texture.error());
    state.shape = std::move(*texture);
    state.solid = true;
    state.shape_info = map.info;
    state.grid = map.grid;
    return {};
}

Result<void> MeshRenderer::set_objects(const std::vector<MeshObject>& objects) {
    std::vector<Object> uploaded;
    state_->screen.make_current();
    for (const MeshObject& object : objects) {
        const Result<std::vector<MeshVertex>> vertices = mesh_vertices(*object.mesh);
        if (!vertices) return tl::unexpected<Error>(vertices.error());
        if (vertices->size() > std::size_t(std::numeric_limits<GLsizei>::max()) / sizeof(MeshVertex))
            return fail(ErrorCode::usage, "the mesh has more triangles than the renderer takes");
        uploaded.push_back(upload(state_->screen.gl(), *vertices));
        uploaded.back().relief = object.relief;
        uploaded.back().ends_u = object.ends_u, uploaded.back().ends_v = object.ends_v;
        uploaded.back().quadrics = !object.mesh->quadrics.empty();
    }
    state_->objects = std::move(uploaded);
    return {};
}

Result<MeshRendering> MeshRenderer::render(const MeshRenderOptions& options) {
    State& state = *state_;
    Offscreen& screen = state.screen;
    const GlFunctions& gl = screen.gl();
    if (Result<void> fits = screen.check_size(options.width, options.height, options.supersample); !fits) return tl::unexpected<Error>(fits.error());
    if (Result<void> checked = state.check(options); !checked) return tl::unexpected<Error>(checked.error());
    screen.make_current();
    const Result<GLuint> program = state.program(options);
    if (!program) return tl::unexpected<Error>(program.error());
    if (Result<void> ready = screen.prepare(options.width * options.supersample, options.height * options.supersample, plane_count); !ready)
        return tl::unexpected<Error>(ready.error());

    // Draw.
    if (!state.solid) {
        screen.bind(cones_unit, state.relief.cones[0]);
        screen.bind(cones_unit + 1, state.relief.cones[1]);
    }
    screen.bind(map_unit, state.solid ? state.shape : state.relief.map);
    const auto start = std::chrono::steady_clock::now();
    screen.begin(*program);
    gl.DepthFunc(GL_LEQUAL); // what passed lies at depth 1, as far as the empty picture
    const Uniforms uniforms(gl, *program);
    state.set_uniforms(uniforms, options);
    for (const Object& object : state.objects) {
        uniforms.set("mesh_depth_scale", float(object.relief.depth_scale));
        uniforms.set("mesh_tiles", float(object.relief.tiles_u), float(object.relief.tiles_v));
        uniforms.set("mesh_ends", float(object.ends_u), float(object.ends_v));
        gl.BindVertexArray(object.layout.name());
        gl.DrawArrays(GL_TRIANGLES, 0, object.vertices);
    }
    gl.Finish();
    MeshRendering rendering;
    rendering.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    // Read back.
    const Image<Quad> colour = screen.read_plane(colour_plane), place = screen.read_plane(place_plane);
    rendering.colour = resolve_picture(colour, options.supersample);
    rendering.distance = rendering.steps = rendering.fetches = Image<float>(place.width(), place.height());
    for (std::size_t k = 0; k < place.size(); ++k) {
        // A colour that is not finite counts as a distance that is not.
        const float sum = colour[k][0] + colour[k][1] + colour[k][2];
        rendering.distance[k] = colour[k][3] == 0 ? std::numeric_limits<float>::infinity() : std::isfinite(sum) ? place[k][0] : sum - sum;
        rendering.steps[k] = place[k][1];
        rendering.fetches[k] = place[k][2];
    }
    if (Result<void> drawn = screen.check_errors(); !drawn) return tl::unexpected<Error>(drawn.error());
    return rendering;
}

} // namespace reliefbake
