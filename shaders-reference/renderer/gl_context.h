#pragma once
// A headless OpenGL 3.3 core context. The libraries are opened when a context is asked for, so the program starts
// without them.

#include "bake/error.h"

#include <memory>
#include <string>

namespace reliefbake {

enum class RendererBackend {
    osmesa, ///< Mesa's software rasteriser, no display or device needed
    egl,    ///< EGL surfaceless: a GPU where there is one, else Mesa's software rasteriser
};

class GlContext {
  public:
    virtual ~GlContext() = default;

    /// Makes it the calling thread's current context; before every use.
    virtual bool make_current() = 0;
    /// Address of an OpenGL function. Mesa answers non-null for names that do not exist: check the version first.
    virtual void* address(const char* function) const = 0;
};

/// Errors (usage): the library is not installed (says which package holds it), or it offers no OpenGL 3.3 core.
Result<std::unique_ptr<GlContext>> make_gl_context(RendererBackend backend);

Result<std::unique_ptr<GlContext>> make_osmesa_context();
Result<std::unique_ptr<GlContext>> make_egl_context();

} // namespace reliefbake
