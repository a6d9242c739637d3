#pragma once
// Polygons as triangles.

#include "mesh/mesh.h"

#include <span>

namespace reliefbake {

/// Cuts a polygon into a fan from its first vertex; a quadrilateral along the other diagonal where that is clearly shorter, so that rounding does
/// not turn the diagonals of a regular grid. Fewer than three corners: none.
inline void append_polygon(Mesh& mesh, std::span<const std::uint32_t> corners) {
    if (corners.size() == 4) {
        const auto length = [&](int a, int b) { return (mesh.positions[corners[a]] - mesh.positions[corners[b]]).length2(); };
        constexpr double clearly = 0.98; // of the squared lengths
        if (length(1, 3) < clearly * length(0, 2)) {
            mesh.triangles.push_back({corners[0], corners[1], corners[3]});
            mesh.triangles.push_back({corners[1], corners[2], corners[3]});
            return;
        }
    }
    for (std::size_t k = 2; k < corners.size(); ++k) mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

} // namespace reliefbake
