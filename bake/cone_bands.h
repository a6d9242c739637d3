#pragma once
// Conservative cones of a map by bands of rows: the same bits as bake_cones, in memory that does not grow with the map but for
// its heights and their pyramid, which may lie in storage that is no memory (docs/LARGE.md).

#include "bake/cone_search.h"
#include "bake/max_pyramid.h"
#include "bake/search_surface.h"

#include <map>
#include <memory_resource>

namespace reliefbake {

/// Bands begin at multiples of so many rows, and end there or with the map.
constexpr int band_step = near_block_rows;

class ConeBands {
  public:
    /// Takes the stored surface; its levels stay in their storage. `pyramid_storage` (null: the heap) outlives the bake.
    /// `options` are of ConeFamily::conservative.
    ConeBands(DepthMap depth, const ConeOptions& options, std::pmr::memory_resource* pyramid_storage);

    const TexelGrid& grid() const { return surface_.grid; }

    /// Ratios of rows [first, end), as bake_cones has them. Bands in ascending order share what lies on their borders; in any other
    /// order they cost more, and are the same.
    Image<float> bake(int first, int end);

    /// The stored surface around a band: its rows, behind `above` and before `below` rows of its neighbours, so that whatever looks
    /// at most one row up or down sees what it sees on the whole map.
    struct Depth {
        DepthMap map;
        int above, below; ///< 0 or 1
    };
    Depth depth(int first, int end) const;

    const ConeStatistics& statistics() const { return statistics_; }

  private:
    void find_near(int first, int end);
    void find_far(int first, int end);
    const float* near_row(int y) const { return near_.at(y / near_block_rows).row(y % near_block_rows); }
    const float* found_row(int y) const { return found_.at(y / far_tile_rows).row(y % far_tile_rows); }

    BitDepth bits_;
    bool holes_;
    ConeOptions options_;
    SearchSurface surface_;
    float top_ = 0; ///< largest height, where there is no cap
    MaxPyramid pyramid_;
    ConeStatistics statistics_;
    std::map<int, Image<float>> near_;  ///< rows of blocks of near slopes
    std::map<int, Image<float>> found_; ///< rows of tiles of far slopes
};

} // namespace reliefbake
