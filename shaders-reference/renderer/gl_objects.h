#pragma once
// Owning handles of OpenGL objects; each needs the context that made it to be current when it dies.

#include "bake/error.h"
#include "shaders-reference/renderer/gl_functions.h"

#include <string>
#include <utility>

namespace reliefbake {

/// An object name that is deleted with its owner.
template <void (*Delete)(const GlFunctions&, GLuint)>
class GlObject {
  public:
    GlObject() = default;
    GlObject(const GlFunctions& gl, GLuint name) : gl_(&gl), name_(name) {}
    GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject() {
        if (name_) Delete(*gl_, name_);
    }
    GLuint name() const { return name_; }

  private:
    const GlFunctions* gl_ = nullptr;
    GLuint name_ = 0;
};

inline void delete_texture(const GlFunctions& gl, GLuint name) { gl.DeleteTextures(1, &name); }
inline void delete_buffer(const GlFunctions& gl, GLuint name) { gl.DeleteBuffers(1, &name); }
inline void delete_framebuffer(const GlFunctions& gl, GLuint name) { gl.DeleteFramebuffers(1, &name); }
inline void delete_vertex_array(const GlFunctions& gl, GLuint name) { gl.DeleteVertexArrays(1, &name); }
inline void delete_shader(const GlFunctions& gl, GLuint name) { gl.DeleteShader(name); }
inline void delete_program(const GlFunctions& gl, GLuint name) { gl.DeleteProgram(name); }

using GlTexture = GlObject<delete_texture>;
using GlBuffer = GlObject<delete_buffer>;
using GlFramebuffer = GlObject<delete_framebuffer>;
using GlVertexArray = GlObject<delete_vertex_array>;
using GlShader = GlObject<delete_shader>;
using GlProgram = GlObject<delete_program>;

/// A texture's storage: formats as glTexImage2D takes them.
struct TextureFormat {
    GLenum internal, format, type;
};

/// Unfiltered, clamped texture; `pixels` null: contents undefined.
GlTexture make_texture(const GlFunctions& gl, const TextureFormat& format, int width, int height, const void* pixels);

/// Errors (internal): the compiler's or linker's log.
Result<GlProgram> make_program(const GlFunctions& gl, const std::string& vertex, const std::string& fragment);

} // namespace reliefbake
