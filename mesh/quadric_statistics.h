#pragma once
// What all quadrics of a file look like together.

#include "mesh/quadric_bake.h"

#include <array>
#include <span>

namespace reliefbake {

/// How one term is distributed over the vertices.
struct TermStatistics {
    double lowest = 0, highest = 0, mean = 0;
    double reach = 0; ///< 99 of 100 vertices lie in -reach..reach
    static constexpr int bins = 32;
    std::array<std::size_t, bins> histogram{}; ///< of -reach..reach; the outer bins hold what lies beyond
};

struct QuadricStatistics {
    std::array<TermStatistics, 3> terms; ///< a, b, c
    double residual_rms = 0, residual_max = 0;
    double twist_share = 0; ///< see QuadricBake
};

QuadricStatistics summarise(std::span<const QuadricBake> bakes);

/// Sums the counts of several meshes.
QuadricCounts add_up(std::span<const QuadricBake> bakes);

} // namespace reliefbake
