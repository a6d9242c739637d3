#include "shaders-reference/renderer/gl_objects.h"

#include <array>

namespace reliefbake {
namespace {

Result<GlShader> compile(const GlFunctions& gl, GLenum stage, const std::string& source) {
    GlShader shader(gl, gl.CreateShader(stage));
    const char* text = source.c_str();
    gl.ShaderSource(shader.name(), 1, &text, nullptr);
    gl.CompileShader(shader.name());
    GLint compiled = 0;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    std::array<char, 2048> log{};
    gl.GetShaderInfoLog(shader.name(), GLsizei(log.size()), nullptr, log.data());
    return fail(ErrorCode::internal, std::string("a shader does not compile: ") + log.data());
}

} // namespace

GlTexture make_texture(const GlFunctions& gl, const TextureFormat& format, int width, int height, const void* pixels) {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    GlTexture texture(gl, name);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GLint(format.internal), width, height, 0, format.format, format.type, pixels);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

Result<GlProgram> make_program(const GlFunctions& gl, const std::string& vertex, const std::string& fragment) {
    const Result<GlShader> vertex_shader = compile(gl, GL_VERTEX_SHADER, vertex);
    if (!vertex_shader) return tl::unexpected<Error>(vertex_shader.error());
    const Result<GlShader> fragment_shader = compile(gl, GL_FRAGMENT_SHADER, fragment);
    if (!fragment_shader) return tl::unexpected<Error>(fragment_shader.error());
    GlProgram program(gl, gl.CreateProgram());
    gl.AttachShader(program.name(), vertex_shader->name());
    gl.AttachShader(program.name(), fragment_shader->name());
    gl.LinkProgram(program.name());
    GLint linked = 0;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked) return program;
    std::array<char, 2048> log{};
    gl.GetProgramInfoLog(program.name(), GLsizei(log.size()), nullptr, log.data());
    return fail(ErrorCode::internal, std::string("a shader program does not link: ") + log.data());
}

} // namespace reliefbake
