#include "shaders-reference/renderer/relief_renderer.h"

#include "shaders-reference/renderer/gl_objects.h"
#include "shaders-reference/renderer/resolve.h"

#include <chrono>
#include <cmath>
#include <optional>

namespace reliefbake {
namespace {

constexpr float endless_reach = 4096; ///< half the size of an endless plane, tiles: farther, float32 rays are too coarse
constexpr GLint map_unit = 0;
constexpr GLint given_unit = 1;
constexpr int planes = 4; ///< colour, hit, counts, ray

struct CompiledProgram {
    ShaderConfig config;
    GlProgram program;
};

/// Framebuffer of one picture size; textures in the order of relief_plane.frag's outputs.
struct Target {
    int width = 0;
    int height = 0;
    GlTexture plane[planes];
    GlTexture depth;
    GlFramebuffer framebuffer;
};

/// Interleaves the four channels as the texture's type; unorm values become integer codes of `full`.
template <class Code>
std::vector<Code> interleave(const ReliefMap& map, float full) {
    std::vector<Code> texels;
    texels.reserve(map.depth.size() * 4);
    const auto code = [full](float value) {
        if constexpr (std::is_floating_point_v<Code>) return value;
        else return Code(std::lround(value * full));
    };
    for (std::size_t i = 0; i < map.depth.size(); ++i)
        for (const Image<float>* channel : {&map.normal_x, &map.normal_y, &map.cone, &map.depth})
            texels.push_back(code((*channel)[i]));
    return texels;
}

GLint gl_wrap(Wrap wrap) { return wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE; }

GlTexture upload(const GlFunctions& gl, const ReliefMap& map, SamplerFilter filter) {
    const int width = map.grid.width;
    const int height = map.grid.height;
    GlTexture texture;
    if (filter == SamplerFilter::fixed8) {
        texture = make_texture(gl, {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE}, width, height,
                               interleave<GLubyte>(map, 255).data());
    } else if (is_unorm(map.info.bits)) {
        texture = make_texture(gl, {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT}, width, height,
                               interleave<GLushort>(map, 65535).data());
    } else {
        texture = make_texture(gl, {GL_RGBA32F, GL_RGBA, GL_FLOAT}, width, height, interleave<GLfloat>(map, 1).data());
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, gl_wrap(map.grid.wrap_x));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, gl_wrap(map.grid.wrap_y));
    return texture;
}

/// OpenGL's first row is the picture's last.
template <class T>
Image<T> flipped(const Image<T>& image) {
    Image<T> result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y)
        std::copy_n(image.row(image.height() - 1 - y), image.width(), result.row(y));
    return result;
}

/// Sets uniforms by name; names that a program does not use are ignored by OpenGL.
class Uniforms {
  public:
    Uniforms(const GlFunctions& gl, GLuint program) : gl_(gl), program_(program) {}
    void set(const char* name, float x) const { gl_.Uniform1f(at(name), x); }
    void set(const char* name, int x) const { gl_.Uniform1i(at(name), x); }
    void set(const char* name, int x, int y) const { gl_.Uniform2i(at(name), x, y); }
    void set(const char* name, float x, float y) const { gl_.Uniform2f(at(name), x, y); }
    void set(const char* name, const Vec3& v) const { gl_.Uniform3f(at(name), float(v[0]), float(v[1]), float(v[2])); }
    void set(const char* name, const Quad& v) const { gl_.Uniform4f(at(name), v[0], v[1], v[2], v[3]); }

  private:
    GLint at(const char* name) const { return gl_.GetUniformLocation(program_, name); }
    const GlFunctions& gl_;
    GLuint program_;
};

} // namespace

struct ReliefRenderer::State {
    std::unique_ptr<GlContext> context;
    GlFunctions gl;
    int largest = 0; ///< texture side the driver takes
    GlVertexArray vertex_array;
    std::vector<CompiledProgram> programs;
    std::optional<Target> target;
    GlTexture map;
    ReliefMapInfo info;
    TexelGrid grid;
    double delta = 0;

    ~State() {
        if (context) context->make_current();
    }

    Result<void> open(RendererBackend backend);
    Result<GLuint> program(const ShaderConfig& config);
    Result<void> prepare_target(int width, int height);
    void set_uniforms(GLuint program, const RenderOptions& options) const;
    Image<Quad> read_plane(int index) const;
    Image<float> read_depth() const;
};

Result<void> ReliefRenderer::State::open(RendererBackend backend) {
    Result<std::unique_ptr<GlContext>> made = make_gl_context(backend);
    if (!made) return tl::unexpected<Error>(made.error());
    context = std::move(*made);
    bool complete = true;
#define RELIEFBAKE_GL_LOAD(type, name)                                                                                   \
    gl.name = reinterpret_cast<type>(context->address("gl" #name));                                                      \
    complete = complete && gl.name;
    RELIEFBAKE_GL_FUNCTIONS(RELIEFBAKE_GL_LOAD)
#undef RELIEFBAKE_GL_LOAD
    GLint major = 0, minor = 0;
    if (complete) {
        gl.GetIntegerv(GL_MAJOR_VERSION, &major);
        gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    }
    if (major * 10 + minor < 33) return fail(ErrorCode::usage, "the OpenGL driver is older than 3.3 core");
    gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    GLuint name = 0;
    gl.GenVertexArrays(1, &name);
    vertex_array = GlVertexArray(gl, name);
    return {};
}

Result<GLuint> ReliefRenderer::State::program(const ShaderConfig& config) {
    for (const CompiledProgram& known : programs)
        if (known.config == config) return known.program.name();
    Result<GlProgram> made = make_program(gl, vertex_source(Prelude::core330), fragment_source(config, Prelude::core330));
    if (!made) return tl::unexpected<Error>(made.error());
    programs.push_back({config, std::move(*made)});
    return programs.back().program.name();
}

Result<void> ReliefRenderer::State::prepare_target(int width, int height) {
    if (target && target->width == width && target->height == height) return {};
    target.emplace();
    target->width = width;
    target->height = height;
    GLuint name = 0;
    gl.GenFramebuffers(1, &name);
    target->framebuffer = GlFramebuffer(gl, name);
    gl.BindFramebuffer(GL_FRAMEBUFFER, name);
    GLenum attachments[planes];
    for (int i = 0; i < planes; ++i) {
        target->plane[i] = make_texture(gl, {GL_RGBA32F, GL_RGBA, GL_FLOAT}, width, height, nullptr);
        attachments[i] = GLenum(GL_COLOR_ATTACHMENT0 + i);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachments[i], GL_TEXTURE_2D, target->plane[i].name(), 0);
    }
    target->depth = make_texture(gl, {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT}, width, height, nullptr);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target->depth.name(), 0);
    gl.DrawBuffers(planes, attachments);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return {};
    target.reset();
    return fail(ErrorCode::usage, std::string("the OpenGL driver cannot render to float textures of ") + std::to_string(width) + "x" +
                                      std::to_string(height));
}

void ReliefRenderer::State::set_uniforms(GLuint program, const RenderOptions& options) const {
    const bool repeats = grid.wrap_x == Wrap::repeat && grid.wrap_y == Wrap::repeat;
    const int tiles = repeats ? options.tiles : 1;
    const Camera camera = make_camera(grid, options.view, tiles, double(target->width) / target->height);
    const float low = repeats && options.endless ? -endless_reach : 0;
    const float high = repeats && options.endless ? endless_reach : float(tiles);
    const Uniforms uniforms(gl, program);
    uniforms.set("relief_map", map_unit);
    uniforms.set("given_hits", given_unit);
    uniforms.set("relief_cone_max", info.cone_max);
    uniforms.set("relief_aspect", float(grid.aspect()));
    uniforms.set("relief_delta", float(delta));
    uniforms.set("relief_repeat", grid.wrap_x == Wrap::repeat, grid.wrap_y == Wrap::repeat);
    uniforms.set("relief_max_steps", options.max_steps);
    uniforms.set("relief_epsilon", options.epsilon);
    uniforms.set("relief_linear_steps", options.linear_steps);
    uniforms.set("relief_binary_steps", options.binary_steps);
    uniforms.set("scene_depth_scale", float(info.depth_scale));
    uniforms.set("scene_sun", sun_direction(options.sun, options.view));
    uniforms.set("scene_shadow_steps", options.shadow_steps);
    uniforms.set("camera_eye", camera.eye);
    uniforms.set("camera_forward", camera.forward);
    uniforms.set("camera_right", camera.right);
    uniforms.set("camera_up", camera.up);
    uniforms.set("camera_range", float(camera.near), float(camera.far));
    uniforms.set("picture_size", float(target->width), float(target->height));
    uniforms.set("plane_bounds", Quad{low, low, high, high});
}

Image<Quad> ReliefRenderer::State::read_plane(int index) const {
    Image<Quad> plane(target->width, target->height);
    gl.ReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + index));
    gl.ReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, plane.data());
    return flipped(plane);
}

Image<float> ReliefRenderer::State::read_depth() const {
    Image<float> plane(target->width, target->height);
    gl.ReadPixels(0, 0, target->width, target->height, GL_DEPTH_COMPONENT, GL_FLOAT, plane.data());
    return flipped(plane);
}

ReliefRenderer::ReliefRenderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
ReliefRenderer::ReliefRenderer(ReliefRenderer&&) noexcept = default;
ReliefRenderer& ReliefRenderer::operator=(ReliefRenderer&&) noexcept = default;
ReliefRenderer::~ReliefRenderer() = default;

Result<ReliefRenderer> ReliefRenderer::create(RendererBackend backend) {
    auto state = std::make_unique<State>();
    if (Result<void> opened = state->open(backend); !opened) return tl::unexpected<Error>(opened.error());
    return ReliefRenderer(std::move(state));
}

Result<void> ReliefRenderer::load(const ReliefMap& map, SamplerFilter filter) {
    if (std::max(map.grid.width, map.grid.height) > state_->largest) {
        return fail(ErrorCode::usage, std::string("the map is larger than the OpenGL driver's textures (") +
                                          std::to_string(state_->largest) + " texels a side)");
    }
    if (filter == SamplerFilter::fixed8 && map.info.bits != BitDepth::unorm8) {
        return fail(ErrorCode::usage, "--filter fixed8 tests 8-bit maps only; this map is not 8-bit");
    }
    state_->context->make_current();
    state_->map = upload(state_->gl, map, filter);
    state_->info = map.info;
    state_->grid = map.grid;
    state_->delta = filter == SamplerFilter::fixed8 ? map.info.filter_delta : 0;
    return {};
}

Result<Rendering> ReliefRenderer::render(const RenderOptions& options) {
    State& state = *state_;
    const GlFunctions& gl = state.gl;
    const int width = options.width * options.supersample;
    const int height = options.height * options.supersample;
    if (options.width < 1 || options.height < 1 || std::max(width, height) > state.largest) {
        return fail(ErrorCode::usage, std::string("the picture, supersampled, must have 1 to ") + std::to_string(state.largest) +
                                          " pixels a side");
    }
    state.context->make_current();
    const Result<GLuint> program =
        state.program(shader_config(state.info, options.technique, options.exact_finish));
    if (!program) return tl::unexpected<Error>(program.error());
    if (Result<void> ready = state.prepare_target(width, height); !ready) return tl::unexpected<Error>(ready.error());

    // Bind the map, and the hits that were given.
    GlTexture given;
    gl.ActiveTexture(GL_TEXTURE0 + given_unit);
    if (options.given) {
        const Image<Quad> rows = flipped(*options.given);
        given = make_texture(gl, {GL_RGBA32F, GL_RGBA, GL_FLOAT}, rows.width(), rows.height(), rows.data());
    }
    gl.ActiveTexture(GL_TEXTURE0 + map_unit);
    gl.BindTexture(GL_TEXTURE_2D, state.map.name());

    // Draw.
    const auto start = std::chrono::steady_clock::now();
    gl.BindFramebuffer(GL_FRAMEBUFFER, state.target->framebuffer.name());
    gl.Viewport(0, 0, width, height);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_ALWAYS);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.UseProgram(*program);
    state.set_uniforms(*program, options);
    gl.BindVertexArray(state.vertex_array.name());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Finish();
    Rendering rendering;
    rendering.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    // Read back.
    rendering.colour = resolve_picture(state.read_plane(0), options.supersample);
    rendering.hit = state.read_plane(1);
    rendering.counts = state.read_plane(2);
    rendering.ray = state.read_plane(3);
    rendering.depth = state.read_depth();
    if (gl.GetError() != GL_NO_ERROR) return fail(ErrorCode::internal, "the OpenGL driver reports an error");
    return rendering;
}

Result<Rendering> render(const ReliefMap& map, const RenderOptions& options, RendererBackend backend, SamplerFilter filter) {
    Result<ReliefRenderer> renderer = ReliefRenderer::create(backend);
    if (!renderer) return tl::unexpected<Error>(renderer.error());
    if (Result<void> loaded = renderer->load(map, filter); !loaded) return tl::unexpected<Error>(loaded.error());
    return renderer->render(options);
}

} // namespace reliefbake
