#pragma once
// Maps for shading that are made of a height map: derivatives, normals, horizons; as they lie in a file.

#include "bake/bit_depth.h"
#include "bake/derivative_map.h"
#include "bake/horizon_map.h"
#include "bake/image.h"
#include "bake/normal_map.h"
#include "bake/relief_map.h"
#include "bake/signed_code.h"
#include "bake/texel_grid.h"

#include <map>
#include <string>
#include <vector>

namespace reliefbake {

enum class BumpKind {
    derivative, ///< dH/du, dH/dv (bake/derivative_map.h): 003's depth map
    normal,     ///< unit normals x, y, z (bake/normal_map.h)
    horizon,    ///< sines of eight horizons (bake/horizon_map.h)
};

/// What a bump map means; stored as metadata, printed by `explain`.
struct BumpMapInfo {
    BumpKind kind = BumpKind::derivative;
    BitDepth bits = BitDepth::unorm16;
    ChannelLayout layout = ChannelLayout::rgba; ///< rgba; named (one EXR); pair (horizons: two RGBA files, the second's stem ends in _b)
    SignedCodes codes = SignedCodes::centred;   ///< derivative, normal: how integers hold signs
    DerivativeKernel kernel = DerivativeKernel::central; ///< derivative, normal
    NormalY normal_y = NormalY::gl; ///< normal
    double derivative_scale = 1;  ///< derivative: that of the largest integer code; 1 in floating formats, which hold derivatives themselves
    double depth_scale = 0.1;     ///< normal, horizon: depth of the relief in texture widths, S
    double error = 0;             ///< largest |decoded value - exact one of the stored depth|, at texel centres
    std::string version{};        ///< of reliefbake
    std::string source_hash{};    ///< XXH3-128 of the decoded source plane
    std::string argument_hash{};  ///< XXH3-128 of the options that fix the result
    std::map<std::string, double> statistics{};
};

/// Planes hold what a sampler returns. derivative: du, dv; normal: x, y, z; horizon: one an azimuth. Depth, beside them, is the
/// stored depth that they were baked for; horizons in two RGBA files have none.
struct BumpMap {
    BumpMapInfo info;
    TexelGrid grid;
    std::vector<Image<float>> planes;
    Image<float> depth;
};

constexpr int bump_planes(BumpKind kind) {
    return kind == BumpKind::derivative ? 2 : kind == BumpKind::normal ? 3 : horizon_azimuths;
}

/// Whether the file holds the depth.
inline bool holds_depth(const BumpMapInfo& info) { return info.layout != ChannelLayout::pair; }

/// What a stored value stands for: a derivative (height per u or v), a component of the normal in the file's own convention,
/// or the sine of a horizon.
float decode_bump(float value, const BumpMapInfo& info);

// Encoding. The infos bring bits, layout, codes, kernel and conventions; what the values add (scale, error, statistics) is
// filled in. Values are rounded to the nearest code.

/// Largest |dH/du|, |dH/dv|.
double largest_derivative(const DerivativeMap& map);

/// `info.derivative_scale` holds for integers: no derivative is larger, or it is an assertion.
BumpMap encode_derivatives(BumpMapInfo info, const DepthMap& depth, const DerivativeMap& derivatives);
BumpMap encode_normals(BumpMapInfo info, const DepthMap& depth, const NormalMap& normals);
BumpMap encode_horizons(BumpMapInfo info, const DepthMap& depth, const HorizonMap& horizons);

} // namespace reliefbake
