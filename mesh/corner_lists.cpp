#include "mesh/corner_lists.h"

#include "bake/parallel.h"

#include <algorithm>
#include <utility>

namespace reliefbake {

namespace {

enum class Use { ring, non_finite, degenerate };

Use use_of(const Triangle& triangle, const Weld& weld) {
    const std::uint32_t p[] = {weld.position_of[triangle[0]], weld.position_of[triangle[1]], weld.position_of[triangle[2]]};
    if (p[0] == no_position || p[1] == no_position || p[2] == no_position) return Use::non_finite;
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0] ? Use::degenerate : Use::ring;
}

/// Each thread owns a range of positions and looks at all triangles: no two write to one place, and reading is cheap.
int range_count(std::size_t positions, int threads) {
    constexpr std::size_t small = 65536;
    constexpr int most = 8;
    if (positions < small) return 1;
    return std::clamp(threads > 0 ? threads : available_threads(), 1, most);
}

} // namespace

CornerLists list_corners(const Mesh& mesh, const Weld& weld, int threads) {
    const std::size_t positions = weld.first_vertex.size();
    CornerLists lists;
    lists.begin.assign(positions + 1, 0);

    LargeArray<Triangle>& places = lists.places;
    places.resize(mesh.triangles.size());
    std::vector<Use> uses(mesh.triangles.size());
    constexpr std::size_t block_triangles = 16384;
    const int blocks = int((places.size() + block_triangles - 1) / block_triangles);
    parallel_for(blocks, threads, [&](int block) {
        const std::size_t first = std::size_t(block) * block_triangles;
        for (std::size_t t = first; t < std::min(first + block_triangles, places.size()); ++t) {
            uses[t] = use_of(mesh.triangles[t], weld);
            for (int k = 0; k < 3; ++k)
                places[t][k] = uses[t] == Use::ring ? weld.position_of[mesh.triangles[t][k]] : no_position;
        }
    });
    for (const Use use : uses) {
        lists.non_finite_triangles += use == Use::non_finite;
        lists.degenerate_triangles += use == Use::degenerate;
    }

    const int ranges = range_count(positions, threads);
    const auto each_corner = [&](int range, const auto& visit) {
        const std::uint32_t low = std::uint32_t(positions * std::size_t(range) / std::size_t(ranges));
        const std::uint32_t width = std::uint32_t(positions * (std::size_t(range) + 1) / std::size_t(ranges)) - low;
        const std::uint32_t* place = places.empty() ? nullptr : places[0].data();
        for (std::size_t corner = 0; corner < 3 * places.size(); ++corner)
            if (place[corner] - low < width) visit(place[corner], std::uint32_t(corner));
    };
    parallel_for(ranges, threads, [&](int range) {
        each_corner(range, [&](std::uint32_t place, std::uint32_t) { ++lists.begin[place]; });
    });
    std::uint32_t total = 0;
    for (std::uint32_t& begin : lists.begin) begin = std::exchange(total, total + begin);
    lists.corners.resize(total);
    std::vector<std::uint32_t> next(lists.begin.begin(), lists.begin.end() - 1);
    parallel_for(ranges, threads, [&](int range) {
        each_corner(range, [&](std::uint32_t place, std::uint32_t corner) { lists.corners[next[place]++] = corner; });
    });
    return lists;
}

} // namespace reliefbake
