#include "cli/cone/large/memory_plan.h"

#include "bake/cone_bands.h"
#include "formats/mapped_storage.h"

#include <algorithm>
#include <string>

namespace reliefbake {

namespace {

constexpr std::uint64_t mib = 1ull << 20;
constexpr std::uint64_t least_resident = 32 * mib;
constexpr int most_band_rows = 256; // enough work for many threads at any width

/// Bytes of one row of a band: near and far slopes, ratios, codes, depth, both normals, and the pixels.
std::uint64_t bytes_of_row(int width, std::uint64_t sample_bytes) { return std::uint64_t(width) * (10 * sizeof(float) + sample_bytes); }

/// A band has near slopes of three rows of blocks more than its own: two beside it, and those across a border that repeats.
std::uint64_t bytes_of_band(int width, int rows, std::uint64_t sample_bytes) {
    return bytes_of_row(width, sample_bytes) * std::uint64_t(rows) + std::uint64_t(width) * 3 * near_block_rows * sizeof(float);
}

/// 64 bytes for a quad of nodes of 4 x 4 texels, a third more for the levels above; 8 a node while the level above is made, and that
/// level beside it.
std::uint64_t pyramid_bytes(std::uint64_t texels) { return texels * 2 + texels / 16 + 64 * MappedStorage::array_step; }

std::string in_mib(std::uint64_t bytes) { return std::to_string((bytes + mib - 1) / mib) + " MiB"; }

} // namespace

std::uint64_t in_core_bytes(std::uint64_t texels, std::uint64_t sample_bytes) { return 320 * mib + texels * (30 + 3 * sample_bytes); }

Result<MemoryPlan> plan_memory(int width, int height, std::uint64_t sample_bytes, std::uint64_t ceiling, const char* name) {
    const std::uint64_t texels = std::uint64_t(width) * std::uint64_t(height), heights = texels * sizeof(float) + 4 * MappedStorage::array_step;
    const std::uint64_t least = MemoryPlan::fixed + least_resident + bytes_of_band(width, band_step, sample_bytes);
    if (ceiling < least)
        return fail(ErrorCode::budget, std::string(name) + ": rows of " + std::to_string(width) + " texels need " + in_mib(least) + " at least, out of core; --memory allows " + in_mib(ceiling));
    MemoryPlan plan;
    // An eighth for the band, a quarter at least for pages of the heights.
    const std::uint64_t step = bytes_of_band(width, band_step, sample_bytes);
    plan.band_rows = band_step;
    while (plan.band_rows < most_band_rows && bytes_of_band(width, plan.band_rows + band_step, sample_bytes) <= std::max(ceiling / 8, step)) plan.band_rows += band_step;
    plan.band = bytes_of_band(width, plan.band_rows, sample_bytes);
    plan.pyramid_in_memory = MemoryPlan::fixed + plan.band + pyramid_bytes(texels) + ceiling / 4 <= ceiling;
    plan.pyramid = plan.pyramid_in_memory ? pyramid_bytes(texels) : 0;
    plan.resident = ceiling - MemoryPlan::fixed - plan.band - plan.pyramid;
    plan.scratch = heights + (plan.pyramid_in_memory ? 0 : pyramid_bytes(texels));
    return plan;
}

} // namespace reliefbake
