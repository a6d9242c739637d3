#pragma once
// What a cone is: MATHS section 2 (001 sec. 2.4; Dummer 2006; Halli 2008; 001 sec. 3.1).
// A ray at height gap g above texel p that moves l texture widths per unit of descent may descend
// r g / (l + r), where r is the *ratio*: the cone's radius in texture widths per unit of height.

#include "bake/bit_depth.h"
#include "bake/height_field.h"
#include "bake/image.h"
#include "bake/texel_grid.h"

#include <cstdint>

namespace reliefbake {

enum class Metric { l2, l1 };            ///< how horizontal distance is measured; march l1 maps with l = |vx| + |R vy|
enum class SurfaceModel { bilinear, texel }; ///< what must stay outside the cone: the filtered surface, or texel centres
enum class ConeEncoding { ratio, sqrt, radius, normal };

struct ConeOptions {
    SurfaceModel surface = SurfaceModel::bilinear; ///< bilinear is proven safe (--surface)
    Metric metric = Metric::l2;                    ///< (--metric)
    float ratio_max = 1;      ///< widest cone, texture widths per unit of height; +inf for no cap (--cone-max)
    float tolerance = 0.001f; ///< relative; how much narrower than exact a cone may get for speed (--tolerance)
    int threads = 0;          ///< 0: all the process may use (--threads)
};

/// Cone ratios, one per texel, in (0, ratio_max]; a conservative cone under the guarantee C of MATHS.
struct ConeMap {
    TexelGrid grid;
    ConeOptions options;
    Image<float> ratio;
};

/// Seconds and counts of one bake.
struct ConeStatistics {
    double seconds_near = 0;    ///< local constraints (gradients, nearest texels)
    double seconds_pyramid = 0; ///< building the pyramid
    double seconds_search = 0;  ///< the search itself
    std::uint64_t node_tests = 0;
};

/// Bakes cones for the stored surface. Guarantee C: no point of the decoded surface lies inside any cone, read with
/// bilinear or nearest filtering. Same bits for every thread count and SIMD width. `depth` is quantised from a
/// HeightField, or has a pixel aspect that passes is_baked_pixel_aspect.
ConeMap bake_cones(const DepthMap& depth, const ConeOptions& options, ConeStatistics* statistics = nullptr);

struct EncodeOptions {
    ConeEncoding encoding = ConeEncoding::sqrt; ///< (--encoding)
    BitDepth bits = BitDepth::unorm8;           ///< of the cone channel (--bits)
};

/// Codes as the GPU samples them: unorm code / max_code, or the half/float value; rounded *down*, so that the
/// decoded cone is never wider than the baked one.
struct EncodedConeMap {
    TexelGrid grid;
    ConeEncoding encoding = ConeEncoding::sqrt;
    BitDepth bits = BitDepth::unorm8;
    float ratio_max = 1;
    Image<float> value;
    std::size_t zero_codes = 0; ///< texels whose cone is narrower than the smallest code: a ray falls back there
};

EncodedConeMap encode_cones(const ConeMap& cones, const DepthMap& depth, const EncodeOptions& options);

/// Ratio that a sampled value stands for. `depth` in [0,1] is the sampled depth (only `radius` reads it; at depth 0
/// it decodes to ratio_max: the top plane has nothing above it). ratio: v * ratio_max. sqrt: v^2 * ratio_max.
/// radius: v / depth. normal: v / sqrt(1 - v^2).
double decode_ratio(double value, double depth, ConeEncoding encoding, double ratio_max);

} // namespace reliefbake
