#pragma once
// How much memory a bake takes, and how one out of core divides what it may have.

#include "bake/error.h"

#include <cstdint>

namespace reliefbake {

/// What a bake in core keeps at its worst, its helper process included, in bytes; `sample_bytes` are those of one pixel of the map.
///
///     | 320 MiB + texels (30 + 3 sample_bytes) |
///
std::uint64_t in_core_bytes(std::uint64_t texels, std::uint64_t sample_bytes);

/// Shares of a ceiling, in bytes. Their sum, with `fixed`, is at most the ceiling.
struct MemoryPlan {
    static constexpr std::uint64_t fixed = 384ull << 20; ///< programs, helper process, blocks on their way, pages not yet let go
    int band_rows = 0;              ///< rows baked at a time
    std::uint64_t band = 0;         ///< all that is kept for them
    bool pyramid_in_memory = false;
    std::uint64_t pyramid = 0;      ///< in memory, while it is built; 0: in the working space
    std::uint64_t resident = 0;     ///< of the heights, and of the pyramid when it lies beside them
    std::uint64_t scratch = 0;      ///< working space for both on the disk
};

/// Errors: budget (the ceiling is too low for maps of this width, and by how much). `name` is the map, for messages.
Result<MemoryPlan> plan_memory(int width, int height, std::uint64_t sample_bytes, std::uint64_t ceiling, const char* name);

} // namespace reliefbake
