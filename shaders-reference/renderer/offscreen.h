#pragma once
// What every headless renderer needs: a context, its functions, a framebuffer of float planes, and reading them back.

#include "bake/error.h"
#include "bake/texel_grid.h"
#include "shaders-reference/renderer/gl_context.h"
#include "shaders-reference/renderer/gl_objects.h"
#include "shaders-reference/renderer/rendering.h"
#include "shaders-reference/renderer/scene.h"

#include <array>
#include <optional>
#include <vector>

namespace reliefbake {

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

/// Not movable: OpenGL objects point into it.
class Offscreen {
  public:
    Offscreen() = default;
    Offscreen(const Offscreen&) = delete;
    ~Offscreen() { make_current(); }

    /// Errors (usage): the backend is not available; says what to install.
    Result<void> open(RendererBackend backend);
    void make_current() const {
        if (context_) context_->make_current();
    }

    const GlFunctions& gl() const { return gl_; }
    int largest() const { return largest_; } ///< texture side the driver takes
    int width() const { return target_->width; }
    int height() const { return target_->height; }

    /// Refuses (usage) pictures that the driver cannot hold, drawn `supersample` times as large.
    Result<void> check_size(int width, int height, int supersample) const;
    /// A framebuffer of `planes` RGBA float planes and a depth plane. Errors (usage): the driver has none of that size.
    Result<void> prepare(int width, int height, int planes);
    void bind(int unit, const GlTexture& texture) const;
    /// Hits that are given instead of searched, as a texture of that unit, which lives as long as the result; null: none.
    [[nodiscard]] GlTexture bind_given(int unit, const Image<Quad>* hits) const;
    /// Makes the cleared framebuffer and the program current, for uniforms to be set.
    void begin(GLuint program) const;
    /// One triangle over the picture, to its end.
    void draw() const;

    Image<Quad> read_plane(int index) const;
    Image<float> read_depth() const;
    /// Errors (internal): what has been drawn and read since the last call failed in the driver.
    Result<void> check_errors() const;

  private:
    struct Target {
        int width = 0, height = 0;
        std::vector<GlTexture> planes;
        GlTexture depth;
        GlFramebuffer framebuffer;
    };

    std::unique_ptr<GlContext> context_;
    GlFunctions gl_;
    int largest_ = 0;
    GlVertexArray vertex_array_;
    std::optional<Target> target_;
};

/// Four channels of a texture; a null one is 0 throughout.
using Channels = std::array<const Image<float>*, 4>;

/// How the texels of a texture are stored.
enum class TexelStorage { unorm8, unorm16, float32 };

/// Linearly filtered, wrapped as the grid says. unorm: channels hold multiples of 1 / the largest code.
GlTexture upload_texture(const GlFunctions& gl, const Channels& channels, const TexelGrid& grid, TexelStorage storage);

/// OpenGL's first row is the picture's last.
template <class T>
Image<T> flipped(const Image<T>& image) {
    Image<T> result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y)
        std::copy_n(image.row(image.height() - 1 - y), image.width(), result.row(y));
    return result;
}

} // namespace reliefbake
