#include "shaders-reference/renderer/plain_mesh.h"

#include "shaders-reference/renderer/offscreen.h"
#include "shaders-reference/renderer/resolve.h"
#include "shaders-reference/renderer/shader_source.h"

#include <cstddef>
#include <limits>

namespace reliefbake {

namespace {

enum Plane { colour_plane, place_plane, plane_count };

GlBuffer make_vertex_buffer(const GlFunctions& gl) {
    GLuint name = 0;
    gl.GenBuffers(1, &name);
    GlBuffer buffer(gl, name);
    gl.BindBuffer(GL_ARRAY_BUFFER, name);
    for (const auto& [index, offset] : {std::pair(0u, offsetof(DisplacedVertex, position)), std::pair(1u, offsetof(DisplacedVertex, normal))}) {
        gl.EnableVertexAttribArray(index);
        gl.VertexAttribPointer(index, 3, GL_FLOAT, GL_FALSE, sizeof(DisplacedVertex), reinterpret_cast<const void*>(offset));
    }
    return buffer;
}

} // namespace

struct PlainMeshRenderer::State {
    Offscreen screen; ///< outlives what is made with it
    GlProgram program;
    GlVertexArray layout;
    GlBuffer vertices;

    ~State() { screen.make_current(); }
};

PlainMeshRenderer::PlainMeshRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
PlainMeshRenderer::PlainMeshRenderer(PlainMeshRenderer&&) noexcept = default;
PlainMeshRenderer& PlainMeshRenderer::operator=(PlainMeshRenderer&&) noexcept = default;
PlainMeshRenderer::~PlainMeshRenderer() = default;

Result<PlainMeshRenderer> PlainMeshRenderer::create(RendererBackend backend) {
    auto state = std::make_unique<State>();
    if (Result<void> opened = state->screen.open(backend); !opened) return tl::unexpected<Error>(opened.error());
    const GlFunctions& gl = state->screen.gl();
    const auto source = [](const char* shared, const char* file) {
        return prelude_text(Prelude::core330).append(shader_text(shared)).append(shader_text(file));
    };
    Result<GlProgram> program = make_program(gl, source("mesh_camera.glsl", "mesh_plain.vert"), source("light.glsl", "mesh_plain.frag"));
    if (!program) return tl::unexpected<Error>(program.error());
    state->program = std::move(*program);
    GLuint name = 0;
    gl.GenVertexArrays(1, &name);
    state->layout = GlVertexArray(gl, name);
    gl.BindVertexArray(name);
    state->vertices = make_vertex_buffer(gl);
    return PlainMeshRenderer(std::move(state));
}

Result<PlainMeshRendering> PlainMeshRenderer::render(const PlainMeshOptions& options, const TriangleSource& triangles) {
    Offscreen& screen = state_->screen;
    const GlFunctions& gl = screen.gl();
    if (Result<void> fits = screen.check_size(options.width, options.height, options.supersample); !fits) return tl::unexpected<Error>(fits.error());
    screen.make_current();
    if (Result<void> ready = screen.prepare(options.width * options.supersample, options.height * options.supersample, plane_count); !ready)
        return tl::unexpected<Error>(ready.error());

    screen.begin(state_->program.name());
    gl.DepthFunc(GL_LESS);
    const Uniforms uniforms(gl, state_->program.name());
    uniforms.set("camera_eye", options.camera.eye);
    uniforms.set("camera_forward", options.camera.forward);
    uniforms.set("camera_right", options.camera.right);
    uniforms.set("camera_up", options.camera.up);
    uniforms.set("camera_range", float(options.camera.near), float(options.camera.far));
    uniforms.set("scene_sun", options.sun);
    gl.BindVertexArray(state_->layout.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, state_->vertices.name());
    Result<void> drawn = triangles([&](std::span<const DisplacedVertex> batch) {
        gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(batch.size_bytes()), batch.data(), GL_STREAM_DRAW);
        gl.DrawArrays(GL_TRIANGLES, 0, GLsizei(batch.size()));
    });
    gl.Finish();
    if (!drawn) return tl::unexpected<Error>(drawn.error());

    PlainMeshRendering rendering;
    rendering.colour = resolve_picture(screen.read_plane(colour_plane), options.supersample);
    const Image<Quad> place = screen.read_plane(place_plane);
    rendering.distance = Image<float>(place.width(), place.height());
    for (std::size_t k = 0; k < place.size(); ++k) rendering.distance[k] = place[k][3] > 0 ? place[k][0] : std::numeric_limits<float>::infinity();
    if (Result<void> checked = screen.check_errors(); !checked) return tl::unexpected<Error>(checked.error());
    return rendering;
}

TriangleSource plain_triangles(const Mesh& mesh) {
    return [&mesh](const TriangleSink& sink) -> Result<void> {
        std::vector<DisplacedVertex> vertices;
        vertices.reserve(3 * mesh.triangles.size());
        for (const Triangle& t : mesh.triangles)
            for (const std::uint32_t v : t) vertices.push_back({Imath::V3f(mesh.positions[v]), mesh.normals[v], mesh.uvs[v]});
        sink(vertices);
        return {};
    };
}

TriangleSource displaced_triangles(const Mesh& mesh, const BilinearSurface& relief, const MeshRelief& how, const DisplaceOptions& options) {
    return [&mesh, &relief, how, options](const TriangleSink& sink) -> Result<void> {
        const Result<std::uint64_t> made = displace(mesh, relief, how, options, sink);
        if (!made) return tl::unexpected<Error>(made.error());
        return {};
    };
}

} // namespace reliefbake
