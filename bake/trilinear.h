#pragma once
// Cones that stay safe when a GPU blends two mip levels (MATHS section 8).

#include "bake/cone.h"

#include <span>

namespace reliefbake {

/// Narrows conservative cones for the bilinear surface so that, at any fixed blend of two adjacent levels, the blended cone
/// holds no point of the blended surface; guarantee C of each level alone is kept. `levels` are a chain of bake_depth_mips,
/// level 0 first, with filtered lookup. Pass what bake_level_cones gave: a second call would narrow further.
void narrow_for_trilinear(std::span<ConeMap> levels);

} // namespace reliefbake
