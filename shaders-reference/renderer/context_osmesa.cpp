// OSMesa: Mesa's off-screen software context. Mesa 25.1 removed it, so nothing outside this file knows it.

#include "shaders-reference/renderer/dynamic_library.h"
#include "shaders-reference/renderer/gl_context.h"

#include <GL/osmesa.h>

#include <array>

namespace reliefbake {
namespace {

constexpr int dummy_size = 16; ///< OSMesa wants a buffer of its own; all drawing goes to framebuffer objects

class OsmesaContext final : public GlContext {
  public:
    OsmesaContext() : library_("libOSMesa.so.8") {}

    ~OsmesaContext() override {
        if (context_) destroy_(context_);
    }

    Result<void> open() {
        if (!library_) {
            return fail(ErrorCode::usage, "cannot load libOSMesa.so.8: install it (Debian: apt install libosmesa6) or use "
                                          "--renderer egl");
        }
        if (!library_.load(create_, "OSMesaCreateContextAttribs") || !library_.load(destroy_, "OSMesaDestroyContext") ||
            !library_.load(make_current_, "OSMesaMakeCurrent") || !library_.load(address_, "OSMesaGetProcAddress")) {
            return fail(ErrorCode::usage, "libOSMesa.so.8 is too old: it lacks OSMesaCreateContextAttribs");
        }
        const int attributes[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3, 0};
        context_ = create_(attributes, nullptr);
        if (!context_ || !make_current()) {
            return fail(ErrorCode::usage, "libOSMesa.so.8 offers no OpenGL 3.3 core context");
        }
        return {};
    }

    bool make_current() override {
        return make_current_(context_, buffer_.data(), GL_UNSIGNED_BYTE, dummy_size, dummy_size) != 0;
    }

    void* address(const char* function) const override { return reinterpret_cast<void*>(address_(function)); }

  private:
    DynamicLibrary library_;
    decltype(&OSMesaCreateContextAttribs) create_ = nullptr;
    decltype(&OSMesaDestroyContext) destroy_ = nullptr;
    decltype(&OSMesaMakeCurrent) make_current_ = nullptr;
    decltype(&OSMesaGetProcAddress) address_ = nullptr;
    OSMesaContext context_ = nullptr;
    std::array<unsigned char, dummy_size * dummy_size * 4> buffer_{};
};

} // namespace

Result<std::unique_ptr<GlContext>> make_osmesa_context() {
    auto context = std::make_unique<OsmesaContext>();
    if (Result<void> opened = context->open(); !opened) return tl::unexpected<Error>(opened.error());
    return context;
}

} // namespace reliefbake
