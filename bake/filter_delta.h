#pragma once
// How far a GPU's filtered depth may be from the exact bilinear one (MATHS section 2, guarantee C;
// RENDERER.md).

#include "bake/height_field.h"

namespace reliefbake {

/// Largest |sampled - exact| depth over all points, in units of the relief's depth. For samplers whose
/// bilinear weights have 8 fractional bits, rounded (D3D11.3 functional spec sec. 7.18.8, Vulkan
/// subTexelPrecisionBits >= 4, in practice 8) and, for 8-bit textures, whose two interpolations each cut to 8
/// bits (llvmpipe). With steps Dx, Dy between neighbouring texels:
///
///     | delta <= (max |Dx| + max |Dy|) / 512   [ + 2 / 255 for unorm8 ] |
///
/// A march that subtracts delta from its height gap is safe under such a sampler.
double filter_delta(const DepthMap& depth);

} // namespace reliefbake
