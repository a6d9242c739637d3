#pragma once
// A shared library opened by name at run time.

#include <dlfcn.h>

#include <memory>

namespace reliefbake {

class DynamicLibrary {
  public:
    explicit DynamicLibrary(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {}

    explicit operator bool() const { return handle_ != nullptr; }

    template <class Function>
    bool load(Function& function, const char* name) const {
        function = reinterpret_cast<Function>(dlsym(handle_.get(), name));
        return function != nullptr;
    }

  private:
    struct Close {
        void operator()(void* handle) const { dlclose(handle); }
    };
    std::unique_ptr<void, Close> handle_;
};

} // namespace reliefbake
