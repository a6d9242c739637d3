#include "bake/bad_texels.h"

#include <cassert>
#include <cmath>
#include <vector>

namespace reliefbake {

namespace {

struct Texel {
    int x, y;
};

/// Calls visit(neighbour) for those inside the image: left, right, up, down.
template <class Visit>
void for_each_neighbour(Texel t, const Image<float>& plane, Visit visit) {
    if (t.x > 0) visit(Texel{t.x - 1, t.y});
    if (t.x + 1 < plane.width()) visit(Texel{t.x + 1, t.y});
    if (t.y > 0) visit(Texel{t.x, t.y - 1});
    if (t.y + 1 < plane.height()) visit(Texel{t.x, t.y + 1});
}

/// Good texels beside bad ones, in row order: where the flood starts.
std::vector<Texel> shore(const Image<float>& plane, const Image<std::uint8_t>& bad) {
    std::vector<Texel> texels;
    for (int y = 0; y < plane.height(); ++y)
        for (int x = 0; x < plane.width(); ++x) {
            if (bad(x, y)) continue;
            bool beside = false;
            for_each_neighbour({x, y}, plane, [&](Texel n) { beside = beside || bad(n.x, n.y); });
            if (beside) texels.push_back({x, y});
        }
    return texels;
}

} // namespace

BadTexels find_bad_texels(const Image<float>& plane, std::optional<float> no_data, const HoleMask& holes) {
    BadTexels bad;
    for (int y = 0; y < plane.height(); ++y)
        for (int x = 0; x < plane.width(); ++x) {
            const float value = plane(x, y);
            if (std::isfinite(value) && !(no_data && value == *no_data)) continue;
            if (!holes.empty() && holes(x, y)) continue;
            if (bad.count++ == 0) {
                bad.first_x = x;
                bad.first_y = y;
                bad.mask = Image<std::uint8_t>(plane.width(), plane.height());
            }
            bad.mask(x, y) = 1;
        }
    return bad;
}

void add_holes(const HoleMask& holes, BadTexels& bad) {
    if (bad.mask.empty() && !holes.empty()) bad.mask = Image<std::uint8_t>(holes.width(), holes.height());
    for (std::size_t k = 0; k < holes.size(); ++k)
        if (holes[k]) bad.mask[k] = 1, ++bad.count;
}

void fill_bad_texels(Image<float>& plane, BadTexels bad) {
    assert(bad.count < plane.size());
    if (bad.count == 0) return;
    // Flood ring by ring from the shore: each ring holds the texels that are one step further from a good
    // one.
    std::vector<Texel> ring = shore(plane, bad.mask), next;
    while (!ring.empty()) {
        next.clear();
        for (const Texel from : ring)
            for_each_neighbour(from, plane, [&](Texel to) {
                if (!bad.mask(to.x, to.y)) return;
                bad.mask(to.x, to.y) = 0;
                plane(to.x, to.y) = plane(from.x, from.y);
                next.push_back(to);
            });
        ring.swap(next);
    }
}

} // namespace reliefbake
