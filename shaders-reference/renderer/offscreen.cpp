#include "shaders-reference/renderer/offscreen.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace reliefbake {
namespace {

/// Interleaves channels as the texture's type; unorm values become integer codes of `full`.
template <class Code>
std::vector<Code> interleave(const Channels& channels, std::size_t count, float full) {
    std::vector<Code> texels;
    texels.reserve(count * 4);
    const auto code = [full](float value) {
        if constexpr (std::is_floating_point_v<Code>) return value;
        else return Code(std::lround(value * full));
    };
    for (std::size_t i = 0; i < count; ++i)
        for (const Image<float>* channel : channels) texels.push_back(channel ? code((*channel)[i]) : Code(0));
    return texels;
}

GLint gl_wrap(Wrap wrap) { return wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE; }

} // namespace

GlTexture upload_texture(const GlFunctions& gl, const Channels& channels, const TexelGrid& grid, TexelStorage storage) {
    const std::size_t count = std::size_t(grid.width) * std::size_t(grid.height);
    const auto texture_of = [&](const TextureFormat& format, const void* pixels) {
        return make_texture(gl, format, grid.width, grid.height, pixels);
    };
    GlTexture texture;
    switch (storage) {
    case TexelStorage::unorm8: texture = texture_of({GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE}, interleave<GLubyte>(channels, count, 255).data()); break;
    case TexelStorage::unorm16: texture = texture_of({GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT}, interleave<GLushort>(channels, count, 65535).data()); break;
    case TexelStorage::float32: texture = texture_of({GL_RGBA32F, GL_RGBA, GL_FLOAT}, interleave<GLfloat>(channels, count, 1).data()); break;
    }
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, gl_wrap(grid.wrap_x));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, gl_wrap(grid.wrap_y));
    return texture;
}

Result<void> Offscreen::open(RendererBackend backend) {
    Result<std::unique_ptr<GlContext>> made = make_gl_context(backend);
    if (!made) return tl::unexpected<Error>(made.error());
    context_ = std::move(*made);
    bool complete = true;
#define RELIEFBAKE_GL_LOAD(type, name)                                                                                   \
    gl_.name = reinterpret_cast<type>(context_->address("gl" #name));                                                    \
    complete = complete && gl_.name;
    RELIEFBAKE_GL_FUNCTIONS(RELIEFBAKE_GL_LOAD)
#undef RELIEFBAKE_GL_LOAD
    GLint major = 0, minor = 0;
    if (complete) {
        gl_.GetIntegerv(GL_MAJOR_VERSION, &major);
        gl_.GetIntegerv(GL_MINOR_VERSION, &minor);
    }
    if (major * 10 + minor < 33) return fail(ErrorCode::usage, "the OpenGL driver is older than 3.3 core");
    gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &largest_);
    GLuint name = 0;
    gl_.GenVertexArrays(1, &name);
    vertex_array_ = GlVertexArray(gl_, name);
    return {};
}

Result<void> Offscreen::check_size(int width, int height, int supersample) const {
    if (width >= 1 && height >= 1 && std::max(width * supersample, height * supersample) <= largest_) return {};
    return fail(ErrorCode::usage, std::string("the picture, supersampled, must have 1 to ") + std::to_string(largest_) + " pixels a side");
}

Result<void> Offscreen::prepare(int width, int height, int planes) {
    if (target_ && target_->width == width && target_->height == height && int(target_->planes.size()) == planes) return {};
    target_.emplace();
    target_->width = width;
    target_->height = height;
    GLuint name = 0;
    gl_.GenFramebuffers(1, &name);
    target_->framebuffer = GlFramebuffer(gl_, name);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, name);
    std::vector<GLenum> attachments;
    for (int i = 0; i < planes; ++i) {
        target_->planes.push_back(make_texture(gl_, {GL_RGBA32F, GL_RGBA, GL_FLOAT}, width, height, nullptr));
        attachments.push_back(GLenum(GL_COLOR_ATTACHMENT0 + i));
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, target_->planes.back().name(), 0);
    }
    target_->depth = make_texture(gl_, {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT}, width, height, nullptr);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target_->depth.name(), 0);
    gl_.DrawBuffers(planes, attachments.data());
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return {};
    target_.reset();
    return fail(ErrorCode::usage, std::string("the OpenGL driver cannot render to float textures of ") + std::to_string(width) + "x" +
                                      std::to_string(height));
}

void Offscreen::bind(int unit, const GlTexture& texture) const {
    gl_.ActiveTexture(GLenum(GL_TEXTURE0 + unit));
    gl_.BindTexture(GL_TEXTURE_2D, texture.name());
}

GlTexture Offscreen::bind_given(int unit, const Image<Quad>* hits) const {
    gl_.ActiveTexture(GLenum(GL_TEXTURE0 + unit));
    if (!hits) return {};
    const Image<Quad> rows = flipped(*hits);
    return make_texture(gl_, {GL_RGBA32F, GL_RGBA, GL_FLOAT}, rows.width(), rows.height(), rows.data());
}

void Offscreen::begin(GLuint program) const {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target_->framebuffer.name());
    gl_.Viewport(0, 0, target_->width, target_->height);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_ALWAYS);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.UseProgram(program);
}

void Offscreen::draw() const {
    gl_.BindVertexArray(vertex_array_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl_.Finish();
}

Image<Quad> Offscreen::read_plane(int index) const {
    Image<Quad> plane(target_->width, target_->height);
    gl_.ReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + index));
    gl_.ReadPixels(0, 0, target_->width, target_->height, GL_RGBA, GL_FLOAT, plane.data());
    return flipped(plane);
}

Image<float> Offscreen::read_depth() const {
    Image<float> plane(target_->width, target_->height);
    gl_.ReadPixels(0, 0, target_->width, target_->height, GL_DEPTH_COMPONENT, GL_FLOAT, plane.data());
    return flipped(plane);
}

Result<void> Offscreen::check_errors() const {
    if (gl_.GetError() == GL_NO_ERROR) return {};
    return fail(ErrorCode::internal, std::string("the OpenGL driver reports an error"));
}

} // namespace reliefbake
