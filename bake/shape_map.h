#pragma once
// A shape map: a binary shape, the distance to it, and the gradient of that distance (003 sec. 2, 004 formulas 2-7).

#include "bake/binary_shape.h"
#include "bake/bit_depth.h"
#include "bake/image.h"
#include "bake/texel_grid.h"

#include <map>
#include <string>

namespace reliefbake {

enum class DistanceMethod { exact, danielsson };

/// What a shape map means; stored as metadata, printed by `explain`. Lengths are in texture widths unless they say texels.
struct ShapeMapInfo {
    ShapeModel model = ShapeModel::squares;
    DistanceMethod method = DistanceMethod::exact;
    bool signed_distance = false; ///< inside the shape the distance is minus that to its outside; else 0
    bool inverted = false;        ///< the other side of the source picture was taken
    BitDepth bits = BitDepth::unorm8;
    bool named = false;           ///< EXR channels shape.gx, shape.gy, shape.distance, shape.mask instead of R, G, B, A
    double scale_f = 1;           ///< f: distances beyond f times the largest are stored as that, 0 < f <= 1
    double max_distance = 0;      ///< texels: largest distance |d| to the shape of all texels
    double tau = 0;               ///< texture widths of the distance code 1 (004 formula 5): f max_distance / width; > 0
    double filter_delta = 0;      ///< how far a sampler with 8-bit weights may misplace a lookup; subtract it from a safe step there
    std::string guarantee;        ///< "S", or empty (method danielsson)
    std::string version;          ///< of reliefbake
    std::string source_hash;      ///< XXH3-128 of the decoded source plane
    std::string argument_hash;    ///< XXH3-128 of the options that fix the result
    std::map<std::string, double> statistics; ///< inside_texels; danielsson: wrong_texels, error_max (texels)
};

/// Channels hold what a sampler returns. File channels: R = gradient_x, G = gradient_y, B = distance, A = shape.
struct ShapeMap {
    ShapeMapInfo info;
    TexelGrid grid;
    /// Unit gradient of the distance, in the directions of u and of v (v grows down the image), or 0 where it has none. Unorm:
    /// 0.5 g + 0.5; floating: g.
    Image<float> gradient_x, gradient_y;
    /// Code c. Distance in texture widths: tau c, or signed tau (2 c - 1) in unorm formats; floating signed: tau c, c in -1..1.
    Image<float> distance;
    Image<float> shape; ///< 0 inside, 1 outside; model contour: 1 - coverage
};

/// The distance, in texture widths, that a sampled code stands for.
inline double decoded_distance(double code, const ShapeMapInfo& info) {
    return info.tau * (info.signed_distance && is_unorm(info.bits) ? 2 * code - 1 : code);
}

/// Whether no part of any texel is inside.
bool is_empty(const ShapeMap& map);

/// How far one may go from anywhere, in texture widths, where the bilinearly filtered distance is `distance`, without entering the
/// shape: Guarantee S. A distance D averaged over texels whose places vary by no more than 1/2 texel^2 is at most
/// sqrt(d^2 + 1/2): its value at texel B is at most |B - q| for every q of the shape, and E|B - q| <= sqrt(|x - q|^2 + 1/2).
double safe_distance(double distance, const TexelGrid& grid);

struct ShapeMapOptions {
    DistanceMethod method = DistanceMethod::exact; ///< danielsson: the papers' vector propagation; a little too large here and there (--method)
    bool signed_distance = false; ///< (--signed)
    double scale_f = 1;           ///< 0 < f <= 1 (--scale-f)
    BitDepth bits = BitDepth::unorm8; ///< (--bits)
    int threads = 0;              ///< the result does not depend on it (--threads)
};

/// Errors: usage: scale_f outside its range; danielsson with another model than centres, or a tile.
/// Defined where there is nothing to measure: an empty shape lies as far as the map's diagonal from everywhere, and so does the
/// outside of a full one (signed); a full shape without sign has tau of one texel and distance 0.
/// Guarantee S: safe_distance of the decoded and bilinearly filtered distance never exceeds the distance to the shape, for every
/// bit depth: codes are rounded down. Not with DistanceMethod::danielsson.
Result<ShapeMap> bake_shape_map(const BinaryShape& shape, const ShapeMapOptions& options);

} // namespace reliefbake
