#pragma once

namespace reliefbake {

/// How the map lies in the texture. Mesa's rasteriser filters 8-bit textures with 8-bit weights, as much hardware
/// does; wider ones exactly, to float32.
enum class SamplerFilter {
    exact,  ///< 16-bit unorm, or float32 (--filter float)
    fixed8, ///< 8-bit texture: height errs by up to the map's filter_delta (--filter fixed8)
};

} // namespace reliefbake
