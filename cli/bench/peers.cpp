#include "cli/bench/peers.h"

#include "bake/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace reliefbake {

namespace {

/// Heights 0..1 and the nearest image of a displacement, for loops that look at every texel.
class Field {
  public:
    explicit Field(const DepthMap& depth) : grid_(depth.grid), heights_(depth.level.width(), depth.level.height()) {
        for (std::size_t k = 0; k < heights_.size(); ++k) heights_[k] = 1 - depth.level[k] / float(max_code(depth.bits));
        highest_ = *std::max_element(heights_.begin(), heights_.end());
    }

    const TexelGrid& grid() const { return grid_; }
    float highest() const { return highest_; }
    float at(int x, int y) const { return heights_(grid_.address_x(x), grid_.address_y(y)); }
    const float* row(int y) const { return heights_.row(y); }

    /// Squared length, in texture widths, of a displacement in texels.
    float distance_sq(int dx, int dy) const {
        if (grid_.wrap_x == Wrap::repeat) dx = std::min(std::abs(dx), grid_.width - std::abs(dx));
        if (grid_.wrap_y == Wrap::repeat) dy = std::min(std::abs(dy), grid_.height - std::abs(dy));
        const float x = float(dx) * float(grid_.pitch_x()), y = float(dy) * float(grid_.pitch_y());
        return x * x + y * y;
    }

  private:
    TexelGrid grid_;
    Image<float> heights_;
    float highest_;
};

float brute_force(const Field& field, int x, int y, float ratio_max) {
    const TexelGrid& grid = field.grid();
    const float own = field.row(y)[x];
    float best = ratio_max * ratio_max;
    for (int j = 0; j < grid.height; ++j) {
        const float* row = field.row(j);
        for (int i = 0; i < grid.width; ++i) {
            const float rise = row[i] - own;
            if (rise > 0) best = std::min(best, field.distance_sq(i - x, j - y) / (rise * rise));
        }
    }
    return std::sqrt(best);
}

float expanding_ring(const Field& field, int x, int y, float ratio_max) {
    const TexelGrid& grid = field.grid();
    const float own = field.at(x, y), most_rise = field.highest() - own;
    if (most_rise <= 0) return ratio_max;
    float best = ratio_max;
    const float pitch = float(std::min(grid.pitch_x(), grid.pitch_y()));
    const auto test = [&](int dx, int dy) {
        const float rise = field.at(x + dx, y + dy) - own;
        if (rise > 0) best = std::min(best, std::sqrt(field.distance_sq(dx, dy)) / rise);
    };
    // Half the period at most; then the other image is nearer.
    const int last = std::max(grid.width, grid.height);
    for (int r = 1; r < last && float(r) * pitch < best * most_rise; ++r) {
        const int rx = std::min(r, grid.width / 2), ry = std::min(r, grid.height / 2);
        for (int d = -rx; d <= rx; ++d) test(d, -ry), test(d, ry);
        for (int d = -ry + 1; d < ry; ++d) test(-rx, d), test(rx, d);
    }
    return best;
}

/// Max mips down to one texel; level 0 is the field itself.
std::vector<Image<float>> max_mips(const Field& field) {
    std::vector<Image<float>> levels;
    levels.emplace_back(field.grid().width, field.grid().height);
    for (int y = 0; y < field.grid().height; ++y)
        for (int x = 0; x < field.grid().width; ++x) levels[0](x, y) = field.at(x, y);
    while (levels.back().size() > 1) {
        const Image<float>& below = levels.back();
        Image<float> level((below.width() + 1) / 2, (below.height() + 1) / 2, 0);
        for (int y = 0; y < below.height(); ++y)
            for (int x = 0; x < below.width(); ++x) level(x / 2, y / 2) = std::max(level(x / 2, y / 2), below(x, y));
        levels.push_back(std::move(level));
    }
    return levels;
}

float quick_cone(const Field& field, const std::vector<Image<float>>& mips, int x, int y, float ratio_max) {
    const TexelGrid& grid = field.grid();
    const float own = field.at(x, y);
    float best = ratio_max * ratio_max;
    for (std::size_t k = 0; k < mips.size(); ++k) {
        const Image<float>& mip = mips[k];
        const int side = 1 << k, cx = x >> k, cy = y >> k;
        for (int b = -1; b <= 1; ++b)
            for (int a = -1; a <= 1; ++a) {
                if (a == 0 && b == 0) continue;
                const float rise = mip(TexelGrid::address(cx + a, mip.width(), grid.wrap_x),
                                       TexelGrid::address(cy + b, mip.height(), grid.wrap_y)) - own;
                if (rise <= 0) continue;
                // From the texel to the nearest texel of that block.
                const int dx = a < 0 ? x - (cx * side - 1) : a > 0 ? (cx + 1) * side - x : 0;
                const int dy = b < 0 ? y - (cy * side - 1) : b > 0 ? (cy + 1) * side - y : 0;
                const float px = float(dx) * float(grid.pitch_x()), py = float(dy) * float(grid.pitch_y());
                best = std::min(best, (px * px + py * py) / (rise * rise));
            }
    }
    return std::sqrt(best);
}

/// A displacement in texels, by the shorter way round.
int nearest_image(int d, int count, Wrap wrap) {
    if (wrap == Wrap::clamp) return d;
    return 2 * d > count ? d - count : 2 * d < -count ? d + count : d;
}

/// The texel that holds a coordinate of 0..1, or lies at its place beyond the border.
int texel_at(float coordinate, int count, Wrap wrap) {
    const float place = coordinate * float(count);
    const int i = int(place) - (float(int(place)) > place);
    return i >= 0 && i < count ? i : TexelGrid::address(i, count, wrap);
}

/// Depth of the nearest texel.
float depth_at(const Field& field, float u, float v) {
    const TexelGrid& grid = field.grid();
    return 1 - field.row(texel_at(v, grid.height, grid.wrap_y))[texel_at(u, grid.width, grid.wrap_x)];
}

/// The ray from the top of texel (x, y)'s axis through the surface at (i, j), on to the floor: how far out and how deep it is when
/// it has left the relief; the cone to that point, or ratio_max where it never leaves above the texel's own depth. Maps that
/// repeat: through the nearest image of (i, j); the original knows none.
float sampled_exit(const Field& field, int x, int y, int i, int j, float ratio_max) {
    constexpr int steps = 128;
    const TexelGrid& grid = field.grid();
    const float target = 1 - field.at(i, j), own = 1 - field.at(x, y);
    if (target <= 0) return ratio_max; // the ray would be level
    const float u = float(TexelGrid::centre(x, grid.width)), v = float(TexelGrid::centre(y, grid.height));
    const float du = float(nearest_image(i - x, grid.width, grid.wrap_x)) / float(grid.width) / target;
    const float dv = float(nearest_image(j - y, grid.height, grid.wrap_y)) / float(grid.height) / target;
    const float step = (1 - target) / steps;
    float t = target + step;
    // Outside the relief the original only counts on; below the texel's depth it answers ratio_max.
    for (int k = 1; k < steps && t < own && depth_at(field, u + t * du, v + t * dv) <= t; ++k) t += step;
    if (t >= own) return ratio_max;
    return std::hypot(t * du, t * dv * float(grid.aspect())) / (own - t);
}

} // namespace

Peer sampled_relaxed_peer() {
    return {"sampled-relaxed", "sampled relaxed cones", "GPU Gems 3, chapter 18", ConeFamily::relaxed, [](const DepthMap& depth, float ratio_max) -> TexelBaker {
                return [field = std::make_shared<Field>(depth), ratio_max](int x, int y) {
                    float ratio = ratio_max;
                    for (int j = 0; j < field->grid().height; ++j)
                        for (int i = 0; i < field->grid().width; ++i)
                            if (i != x || j != y) ratio = std::min(ratio, sampled_exit(*field, x, y, i, j, ratio_max));
                    return ratio;
                };
            }};
}

Peer brute_force_peer() {
    return {"brute-force", "brute force", "Dummer 2006", ConeFamily::conservative, [](const DepthMap& depth, float ratio_max) -> TexelBaker {
                return [field = std::make_shared<Field>(depth), ratio_max](int x, int y) {
                    return brute_force(*field, x, y, ratio_max);
                };
            }};
}

Peer expanding_ring_peer() {
    return {"expanding-ring", "expanding ring", "002 sec. II-B", ConeFamily::conservative, [](const DepthMap& depth, float ratio_max) -> TexelBaker {
                return [field = std::make_shared<Field>(depth), ratio_max](int x, int y) {
                    return expanding_ring(*field, x, y, ratio_max);
                };
            }};
}

Peer quick_cone_map_peer() {
    return {"quick-cone-map", "quick cone map", "Valasek & Ban 2022", ConeFamily::conservative, [](const DepthMap& depth, float ratio_max) -> TexelBaker {
                const auto field = std::make_shared<Field>(depth);
                return [field, mips = max_mips(*field), ratio_max](int x, int y) {
                    return quick_cone(*field, mips, x, y, ratio_max);
                };
            }};
}

const std::vector<Peer>& all_peers() {
    static const std::vector<Peer> peers = {brute_force_peer(), expanding_ring_peer(), quick_cone_map_peer(), sampled_relaxed_peer()};
    return peers;
}

Image<float> bake_peer(const Peer& peer, const DepthMap& depth, float ratio_max, int threads) {
    Image<float> ratio(depth.grid.width, depth.grid.height);
    const TexelBaker bake = peer.prepare(depth, ratio_max);
    parallel_for(depth.grid.height, threads, [&](int y) {
        for (int x = 0; x < depth.grid.width; ++x) ratio(x, y) = bake(x, y);
    });
    return ratio;
}

} // namespace reliefbake
