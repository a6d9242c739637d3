#include "bake/cone_bands.h"

#include "bake/cone_slopes.h"
#include "bake/parallel.h"

#include <atomic>
#include <cassert>
#include <chrono>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace reliefbake {

namespace {

/// Adds the seconds of its life.
class Seconds {
  public:
    explicit Seconds(double& sum) : sum_(sum) {}
    ~Seconds() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  private:
    double& sum_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Drops what is not wanted from `rows`; returns what is wanted and not there.
std::vector<int> keep_only(const std::set<int>& wanted, std::map<int, Image<float>>& rows) {
    std::erase_if(rows, [&](const auto& row) { return !wanted.contains(row.first); });
    std::vector<int> missing;
    for (const int row : wanted)
        if (!rows.contains(row)) missing.push_back(row);
    return missing;
}

} // namespace

ConeBands::ConeBands(DepthMap depth, const ConeOptions& options, std::pmr::memory_resource* pyramid_storage)
    : bits_(depth.bits), holes_(depth.holes), options_(options), surface_(surface_without_heights(depth.grid, depth.bits, options)) {
    assert(options.family == ConeFamily::conservative && options.ratio_max > 0 && options.tolerance >= 0);
    assert(is_baked_pixel_aspect(depth.grid.pixel_aspect));
    const Seconds pyramid(statistics_.seconds_pyramid);
    surface_.height = std::move(depth.level);
    parallel_for(surface_.grid.height, options_.threads, [&](int y) {
        for (float* h = surface_.height.row(y); h != surface_.height.row(y) + surface_.grid.width; ++h) *h = -*h;
    });
    pyramid_ = build_max_pyramid(surface_.height, options_.threads, pyramid_storage);
    const PyramidNode root = pyramid_.node(pyramid_.level_count() - 1, 0, 0);
    top_ = root.max;
}

void ConeBands::find_near(int first, int end) {
    const Seconds near(statistics_.seconds_near);
    std::set<int> wanted;
    for (int y = first; y < end; ++y) wanted.insert(surface_.grid.address_y(y) / near_block_rows);
    const std::vector<int> missing = keep_only(wanted, near_);
    std::vector<Image<float>> rows = near_slopes_of_block_rows(surface_, missing, options_.threads);
    for (std::size_t k = 0; k < missing.size(); ++k) near_.emplace(missing[k], std::move(rows[k]));
}

void ConeBands::find_far(int first, int end) {
    const Seconds search(statistics_.seconds_search);
    std::set<int> wanted;
    for (int y = first; y < end; ++y) wanted.insert(surface_.grid.address_y(y) / far_tile_rows);
    const std::vector<int> missing = keep_only(wanted, found_);
    std::vector<Image<float>> rows;
    for (const int row : missing)
        rows.push_back(Image<float>(surface_.grid.width, std::min(far_tile_rows, surface_.grid.height - row * far_tile_rows)));
    std::atomic<std::uint64_t> visits = 0;
    parallel_for(int(missing.size()), options_.threads, [&](int k) {
        visits += search_tile_row(surface_, {surface_.height, {}}, pyramid_, options_.tolerance, missing[std::size_t(k)],
                                  [&](int y) { return near_row(y); }, rows[std::size_t(k)]);
    });
    statistics_.node_tests += visits;
    for (std::size_t k = 0; k < missing.size(); ++k) found_.emplace(missing[k], std::move(rows[k]));
}

Image<float> ConeBands::bake(int first, int end) {
    assert(0 <= first && first < end && end <= surface_.grid.height);
    assert(first % band_step == 0 && (end % band_step == 0 || end == surface_.grid.height));
    // A row is raised by what was found one row away, in tiles that need near slopes one row farther.
    find_near(first - far_tile_rows - 1, end + far_tile_rows + 1);
    find_far(first - 1, end + 1);
    const Seconds search(statistics_.seconds_search);
    Image<float> ratio(surface_.grid.width, end - first);
    parallel_for(end - first, options_.threads, [&](int k) {
        const int y = first + k;
        float* row = ratio.row(k);
        std::copy_n(near_row(y), surface_.grid.width, row);
        raise_row_by_found(surface_, y, [&](int of) { return found_row(of); }, row);
        slopes_to_ratios(surface_.grid, bits_, options_, row);
        if (std::isinf(options_.ratio_max)) open_topmost_cones(surface_, top_, y, row);
    });
    return ratio;
}

ConeBands::Depth ConeBands::depth(int first, int end) const {
    const bool repeated = surface_.grid.wrap_y == Wrap::repeat;
    const int above = repeated || first > 0, below = repeated || end < surface_.grid.height;
    TexelGrid grid = surface_.grid;
    grid.height = end - first + above + below, grid.wrap_y = Wrap::clamp;
    Depth band{{grid, bits_, Image<float>(grid.width, grid.height), holes_}, above, below};
    parallel_for(grid.height, options_.threads, [&](int k) {
        const float* row = surface_.height.row(surface_.grid.address_y(first - above + k));
        std::transform(row, row + grid.width, band.map.level.row(k), [](float h) { return -h; });
    });
    return band;
}

} // namespace reliefbake
