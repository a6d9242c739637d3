#include "cli/bench/pictures.h"

#include "shaders-reference/measure/random.h"

#include <algorithm>
#include <cassert>

namespace reliefbake {

namespace {

/// Discs of a hundredth to a tenth of the side.
void draw_blobs(Image<std::uint8_t>& picture, SplitMix& random) {
    const int size = picture.width();
    for (int k = 0; k < 40; ++k) {
        const std::int64_t cx = random.below(size), cy = random.below(size), r = std::max(1, size / 100 + random.below(size / 10 + 1));
        for (std::int64_t y = std::max<std::int64_t>(0, cy - r); y < std::min<std::int64_t>(size, cy + r); ++y)
            for (std::int64_t x = std::max<std::int64_t>(0, cx - r); x < std::min<std::int64_t>(size, cx + r); ++x)
                if ((x - cx) * (x - cx) + (y - cy) * (y - cy) < r * r) picture(int(x), int(y)) = 0;
    }
}

/// Lines from border to border, one texel wide.
void draw_lines(Image<std::uint8_t>& picture, SplitMix& random) {
    const int size = picture.width();
    for (int k = 0; k < 30; ++k) {
        const std::int64_t from = random.below(size), to = random.below(size);
        for (std::int64_t t = 0; t < size; ++t) {
            const int other = int(from + (to - from) * t / size);
            (k % 2 ? picture(int(t), other) : picture(other, int(t))) = 0;
        }
    }
}

} // namespace

const std::vector<std::string>& picture_names() {
    static const std::vector<std::string> names{"blobs", "lines", "pixel", "diagonal", "dots"};
    return names;
}

Image<std::uint8_t> make_picture(const std::string& name, int size) {
    Image<std::uint8_t> picture(size, size, 1);
    SplitMix random(1);
    if (name == "blobs") draw_blobs(picture, random);
    else if (name == "lines") draw_lines(picture, random);
    else if (name == "pixel") picture(size / 3, size / 2) = 0;
    else if (name == "diagonal")
        for (int k = 0; k < size; ++k) picture(k, k) = 0;
    else {
        assert(name == "dots");
        for (std::uint8_t& texel : picture) texel = random.below(100) != 0;
    }
    return picture;
}

} // namespace reliefbake
