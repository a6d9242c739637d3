#pragma once
// Texels without a sample: NaN, Inf, or the source's no-data value.

#include "bake/holes.h"
#include "bake/image.h"

#include <cstdint>
#include <optional>

namespace reliefbake {

struct BadTexels {
    Image<std::uint8_t> mask; ///< 1 where there is no sample; empty when there is one everywhere
    std::size_t count = 0;
    int first_x = 0, first_y = 0; ///< in row order; meaningful when count > 0
};

/// `holes` are not looked at: nobody needs a sample there.
BadTexels find_bad_texels(const Image<float>& plane, std::optional<float> no_data, const HoleMask& holes = {});

/// Counts holes among the bad texels, so that fill_bad_texels fills them too.
void add_holes(const HoleMask& holes, BadTexels& bad);

/// Gives every bad texel the value of the nearest good one: fewest steps to a 4-neighbour, not across the
/// border; among equals the one whose flood came first, in row order from the good texels. Needs one good
/// texel.
void fill_bad_texels(Image<float>& plane, BadTexels bad);

} // namespace reliefbake
