#pragma once
// A baked map as it lies in a file: the four sampled channels and everything a shader must know to decode them.

#include "bake/cone.h"
#include "bake/image.h"
#include "bake/texel_grid.h"

#include <map>
#include <string>
#include <vector>

namespace reliefbake {

enum class NormalY { gl, dx };
/// How the planes lie in image files (formats/map_layout.h).
enum class ChannelLayout {
    rgba,  ///< one RGBA image
    named, ///< one EXR with channels relief.nx, relief.ny, relief.depth, relief.cone or cone4.s0, cone8.s0, stack.k0, pieces.k0, ...
    side,  ///< eight sectors: two RGBA images side by side in one (002 sec. II-D)
    pair,  ///< eight sectors: two RGBA files
};

/// What a map of kind "cone" holds beside the depth. One without cones is followed by searches that need none.
struct HeldPlanes {
    bool normals = true;
    bool cones = true;

    friend bool operator==(const HeldPlanes&, const HeldPlanes&) = default;
};

/// The meaning of a map; stored as metadata, printed by `explain`. Keys of `explain --json` are these names.
struct ReliefMapInfo {
    std::string kind = "cone";  ///< "cone", "acm" (sectors), "cone-stack", "cone-pieces"
    ConeFamily family = ConeFamily::conservative;
    RelaxedRays rays = RelaxedRays::strict; ///< relaxed, hybrid
    double relaxed_slope = 0;   ///< RelaxedRays::slope
    double hybrid_delta = 0;    ///< hybrid
    ConeLookup lookup = ConeLookup::filtered;
    int planes = 0;             ///< but for kind "cone": number of ReliefMap::cone_planes
    int levels = 1;             ///< mip levels in the file; every other fact is that of level 0, filter_delta of all
    bool trilinear = false;     ///< cones hold under a blend of two adjacent levels too (bake/trilinear.h)
    bool holes = false;         ///< depth 1 is a hole, and only holes are as deep (bake/holes.h)
    Metric metric = Metric::l2;
    ConeEncoding encoding = ConeEncoding::sqrt;
    BitDepth bits = BitDepth::unorm8;
    SurfaceModel surface = SurfaceModel::bilinear;
    ChannelLayout layout = ChannelLayout::rgba;
    HeldPlanes held;            ///< kind "cone"
    NormalY normal_y = NormalY::gl;
    float cone_max = 1;         ///< ratio that the largest code stands for (ratio, sqrt); cap of the bake
    double depth_scale = 0.1;   ///< depth of the relief in texture widths
    double filter_delta = 0;    ///< largest height error of a sampler with 8-bit weights; the march subtracts it
    double tolerance = 0;       ///< relative tolerance of the bake
    std::string guarantee;      ///< "C" when the cones are conservative for `surface`, "R" when strictly relaxed, else empty
    std::string version;        ///< of reliefbake
    std::string source_hash;    ///< XXH3-128 of the decoded source plane (16 bytes, hex)
    std::string alpha_hash;     ///< of the plane that holes come from, likewise; empty without one
    std::string argument_hash;  ///< XXH3-128 of the options that fix the result
    std::map<std::string, double> statistics; ///< zero_codes, ratio_mean, depth_min, depth_max ...
};

/// Channels hold what a sampler returns: unorm code / max_code, or the half/float value.
/// Normals: unorm stores 0.5 n + 0.5, floating formats n itself.
struct ReliefMap {
    ReliefMapInfo info;
    TexelGrid grid;
    Image<float> normal_x, normal_y, cone, depth;
    /// Kind "acm": 4 or 8 planes, one a sector; kinds "cone-stack", "cone-pieces": one a level. `cone` is then empty. Encoded as `cone`.
    std::vector<Image<float>> cone_planes;
};

} // namespace reliefbake
