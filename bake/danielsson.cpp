#include "bake/danielsson.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {

namespace {

/// From a texel to the nearest one of the set that is known.
struct Way {
    std::int32_t x, y;

    std::int64_t square() const { return std::int64_t(x) * x + std::int64_t(y) * y; }
};

constexpr std::int32_t nowhere = 1 << 20; ///< farther than any picture is wide

class Propagation {
  public:
    explicit Propagation(const Image<std::uint8_t>& picture) : ways_(picture.width(), picture.height(), Way{nowhere, nowhere}) {
        for (std::size_t k = 0; k < picture.size(); ++k)
            if (picture[k] == 0) ways_[k] = {0, 0};
    }

    /// Rows from `first` on in steps of `down`: from the row before, then along the row, there and back.
    void sweep(int first, int down) {
        const int width = ways_.width(), height = ways_.height();
        for (int y = first; y >= 0 && y < height; y += down) {
            for (int x = 0; x < width; ++x)
                for (const int side : {0, -1, 1}) take(x, y, x + side, y - down);
            for (int x = 1; x < width; ++x) take(x, y, x - 1, y);
            for (int x = width - 2; x >= 0; --x) take(x, y, x + 1, y);
        }
    }

    const Image<Way>& ways() const { return ways_; }

  private:
    void take(int x, int y, int from_x, int from_y) {
        if (from_x < 0 || from_x >= ways_.width() || from_y < 0 || from_y >= ways_.height()) return;
        const Way other = ways_(from_x, from_y);
        if (other.x == nowhere) return;
        const Way way{other.x + from_x - x, other.y + from_y - y};
        if (way.square() < ways_(x, y).square()) ways_(x, y) = way;
    }

    Image<Way> ways_;
};

} // namespace

Image<float> danielsson_distances(const Image<std::uint8_t>& picture) {
    Propagation propagation(picture);
    propagation.sweep(0, 1);
    propagation.sweep(picture.height() - 1, -1);
    Image<float> out(picture.width(), picture.height());
    std::transform(propagation.ways().begin(), propagation.ways().end(), out.begin(), [](const Way& way) {
        return way.x == nowhere ? std::numeric_limits<float>::infinity() : float(std::sqrt(double(way.square())));
    });
    return out;
}

} // namespace reliefbake
