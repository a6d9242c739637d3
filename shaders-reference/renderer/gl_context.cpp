#include "shaders-reference/renderer/gl_context.h"

namespace reliefbake {

Result<std::unique_ptr<GlContext>> make_gl_context(RendererBackend backend) {
    return backend == RendererBackend::osmesa ? make_osmesa_context() : make_egl_context();
}

} // namespace reliefbake
