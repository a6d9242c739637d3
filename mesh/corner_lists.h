#pragma once
// Which triangles meet at each position: the adjacency of a mesh of any topology, by a counting sort.

#include "bake/large_array.h"
#include "mesh/mesh.h"
#include "mesh/weld.h"

#include <span>

namespace reliefbake {

/// Corner 3 t + k is corner k of triangle t.
struct CornerLists {
    std::vector<std::uint32_t> begin;   ///< of each position's corners; one more at the end
    LargeArray<std::uint32_t> corners; ///< in ascending order for each position
    LargeArray<Triangle> places;       ///< each triangle's positions; no_position thrice where it is left out
    std::size_t non_finite_triangles = 0;  ///< left out: a corner is not finite
    std::size_t degenerate_triangles = 0;  ///< left out: two corners lie at one position

    std::span<const std::uint32_t> at(std::uint32_t position) const {
        return std::span(corners).subspan(begin[position], begin[position + 1] - begin[position]);
    }
};

/// The result does not depend on `threads`.
CornerLists list_corners(const Mesh& mesh, const Weld& weld, int threads);

} // namespace reliefbake
