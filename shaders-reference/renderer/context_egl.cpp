// EGL without a surface: the vendor's driver where there is one, else Mesa's software rasteriser.

#include "shaders-reference/renderer/dynamic_library.h"
#include "shaders-reference/renderer/gl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace reliefbake {
namespace {

class EglContext final : public GlContext {
  public:
    EglContext() : library_("libEGL.so.1") {}

    ~EglContext() override {
        if (display_ == EGL_NO_DISPLAY) return;
        make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) destroy_(display_, context_);
        terminate_(display_);
    }

    Result<void> open() {
        if (!library_) {
            return fail(ErrorCode::usage, "cannot load libEGL.so.1: install it (Debian: apt install libegl1 libgl1-mesa-dri) "
                                          "or use --renderer osmesa");
        }
        if (!library_.load(get_display_, "eglGetPlatformDisplay") || !library_.load(initialize_, "eglInitialize") ||
            !library_.load(terminate_, "eglTerminate") || !library_.load(bind_api_, "eglBindAPI") ||
            !library_.load(create_, "eglCreateContext") || !library_.load(destroy_, "eglDestroyContext") ||
            !library_.load(make_current_, "eglMakeCurrent") || !library_.load(address_, "eglGetProcAddress")) {
            return fail(ErrorCode::usage, "libEGL.so.1 is older than EGL 1.5");
        }
        EGLDisplay display = get_display_(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display == EGL_NO_DISPLAY || !initialize_(display, nullptr, nullptr)) {
            return fail(ErrorCode::usage, "EGL offers no surfaceless display (Debian: apt install libgl1-mesa-dri)");
        }
        display_ = display;
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
        if (bind_api_(EGL_OPENGL_API)) context_ = create_(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context_ == EGL_NO_CONTEXT || !make_current()) {
            return fail(ErrorCode::usage, "EGL offers no OpenGL 3.3 core context without a surface");
        }
        return {};
    }

    bool make_current() override { return make_current_(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE; }

    void* address(const char* function) const override { return reinterpret_cast<void*>(address_(function)); }

  private:
    DynamicLibrary library_;
    decltype(&eglGetPlatformDisplay) get_display_ = nullptr;
    decltype(&eglInitialize) initialize_ = nullptr;
    decltype(&eglTerminate) terminate_ = nullptr;
    decltype(&eglBindAPI) bind_api_ = nullptr;
    decltype(&eglCreateContext) create_ = nullptr;
    decltype(&eglDestroyContext) destroy_ = nullptr;
    decltype(&eglMakeCurrent) make_current_ = nullptr;
    decltype(&eglGetProcAddress) address_ = nullptr;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

} // namespace

Result<std::unique_ptr<GlContext>> make_egl_context() {
    auto context = std::make_unique<EglContext>();
    if (Result<void> opened = context->open(); !opened) return tl::unexpected<Error>(opened.error());
    return context;
}

} // namespace reliefbake
