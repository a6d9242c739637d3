#pragma once
// Vertices that lie at one place: seams of textures and hard edges split a surface into several vertices there.

#include "mesh/mesh.h"

namespace reliefbake {

constexpr std::uint32_t no_position = 0xffffffff;

/// The distinct places of a mesh, numbered in the order of their first vertices.
struct Weld {
    std::vector<std::uint32_t> position_of; ///< for each vertex; no_position where a coordinate is not finite
    std::vector<std::uint32_t> first_vertex; ///< for each position
};

/// Vertices share a position when their coordinates are equal (-0 equals 0). The result does not depend on `threads`.
Weld weld_positions(const std::vector<Imath::V3d>& positions, int threads);

} // namespace reliefbake
