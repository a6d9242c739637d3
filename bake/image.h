#pragma once
// One plane of pixels.

#include "bake/large_array.h"

#include <cassert>
#include <cstddef>

namespace reliefbake {

/// Owning single-channel plane, row-major, the image's top row first.
template <class T>
class Image {
  public:
    Image() = default;
    Image(int width, int height, T fill = T{})
        : width_(width), height_(height), pixels_(std::size_t(width) * std::size_t(height), fill) {
        assert(width > 0 && height > 0);
    }
    /// Unfilled, in `storage`, which outlives the image and what it is moved to; null is the heap.
    static Image unfilled(int width, int height, std::pmr::memory_resource* storage) {
        assert(width > 0 && height > 0);
        Image image;
        image.width_ = width, image.height_ = height;
        image.pixels_ = LargeArray<T>(std::size_t(width) * std::size_t(height), LargeAllocator<T>(storage));
        return image;
    }

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t size() const { return pixels_.size(); }
    bool empty() const { return pixels_.empty(); }

    T* data() { return pixels_.data(); }
    const T* data() const { return pixels_.data(); }
    T* row(int y) { return pixels_.data() + std::size_t(y) * std::size_t(width_); }
    const T* row(int y) const { return pixels_.data() + std::size_t(y) * std::size_t(width_); }
    T& operator()(int x, int y) { return row(y)[x]; }
    const T& operator()(int x, int y) const { return row(y)[x]; }
    T& operator[](std::size_t i) { return pixels_[i]; }
    const T& operator[](std::size_t i) const { return pixels_[i]; }

    auto begin() { return pixels_.begin(); }
    auto end() { return pixels_.end(); }
    auto begin() const { return pixels_.begin(); }
    auto end() const { return pixels_.end(); }

    friend bool operator==(const Image&, const Image&) = default;

  private:
    int width_ = 0;
    int height_ = 0;
    LargeArray<T> pixels_;
};

} // namespace reliefbake
