#pragma once
// What a cone is: MATHS section 2 (001 sec. 2.4; Dummer 2006; Halli 2008; 001 sec. 3.1).
// A ray at height gap g above texel p that moves l texture widths per unit of descent may descend
// r g / (l + r), where r is the *ratio*: the cone's radius in texture widths per unit of height.

#include "bake/bit_depth.h"
#include "bake/height_field.h"
#include "bake/image.h"
#include "bake/texel_grid.h"

#include <cstdint>
#include <vector>

namespace reliefbake {

enum class Metric { l2, l1 };            ///< how horizontal distance is measured; march l1 maps with l = |vx| + |R vy|
enum class SurfaceModel { bilinear, texel }; ///< what must stay outside the cone: the filtered surface, or texel centres
enum class ConeEncoding { ratio, sqrt, radius, normal };

/// What a ray may do inside a cone (MATHS section 3; docs/FAMILIES.md).
enum class ConeFamily {
    conservative, ///< meet nothing: guarantee C
    relaxed,      ///< pierce the relief once, and not leave it again: guarantee R with RelaxedRays::strict; refine by a bracketed search
    hybrid,       ///< pierce it once, and be at most ConeOptions::hybrid_delta deep in the first surface met
};
/// The rays that a relaxed cone must not let out of the relief again.
enum class RelaxedRays {
    strict, ///< all
    top,    ///< those that start on the cone's axis at height 1, which GPU Gems 3 (chapter 18) samples; others may jump a peak
    slope,  ///< those steeper than ConeOptions::relaxed_slope
};
/// Where a stored cone is fetched, and so where it must hold.
enum class ConeLookup {
    filtered, ///< bilinear or nearest at any point: over the four cells around the texel
    cell,     ///< texelFetch at floor(uv size - 0.5), height still filtered: over that cell alone
};

struct ConeOptions {
    SurfaceModel surface = SurfaceModel::bilinear; ///< bilinear is proven safe (--surface)
    Metric metric = Metric::l2;                    ///< (--metric)
    float ratio_max = 1;      ///< widest cone, texture widths per unit of height; +inf for no cap (--cone-max)
    float tolerance = 0.001f; ///< relative; how much narrower than exact a cone may get for speed (--tolerance)
    int threads = 0;          ///< 0: all the process may use (--threads)
    ConeFamily family = ConeFamily::conservative; ///< (--kind)
    RelaxedRays rays = RelaxedRays::strict;       ///< of relaxed and hybrid cones (--relaxed)
    float relaxed_slope = 0; ///< for RelaxedRays::slope: height per texture width (--relaxed slope:S)
    float hybrid_delta = 0;  ///< for ConeFamily::hybrid: 0..1; 0 is conservative, 1 strict relaxed (--delta)
    ConeLookup lookup = ConeLookup::filtered; ///< (--lookup)
    friend bool operator==(const ConeOptions&, const ConeOptions&) = default;
};

class SharedPyramids;

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
/// HeightField, or has a pixel aspect that passes is_baked_pixel_aspect. `shared` (of this depth alone) keeps pyramids for
/// other bakes of it, and changes no bit.
ConeMap bake_cones(const DepthMap& depth, const ConeOptions& options, ConeStatistics* statistics = nullptr,
                   SharedPyramids* shared = nullptr);

/// One map per sector of azimuth: sector k of n holds rays that move by (du, R dv) at an angle in [2 pi k/n, 2 pi (k+1)/n),
/// u to the right, v down the image (MATHS section 4; 002). The family's guarantee holds in each sector, borders included.
/// `sectors`: 4 or 8; the metric is l2, or l1 with 4.
std::vector<ConeMap> bake_sector_cones(const DepthMap& depth, int sectors, const ConeOptions& options,
                                       ConeStatistics* statistics = nullptr, SharedPyramids* shared = nullptr);

/// Cones stacked above each texel (001 sec. 3.4, method 1): level k of n has its apex at height h + (1 - h) k/n above the
/// texel, level 0 on the surface. A ray above an apex may step as in that cone; the longest step wins.
std::vector<ConeMap> bake_stacked_cones(const DepthMap& depth, int levels, const ConeOptions& options,
                                        ConeStatistics* statistics = nullptr, SharedPyramids* shared = nullptr);

/// Cones in pieces (001 sec. 3.4, method 2): the free space above each texel under a line of n pieces. Of a point at height H with
/// room w = 1 - H above it, piece k of n spans heights H + w k/n to H + w (k+1)/n; map k holds the ratio of the radius at its upper
/// end to that end's height above H. Radii between ends are linear, 0 at H. A ray may step as long as it is within the radius
/// at its height. One piece is an ordinary cone. Decoded by any weighted mean of texels that is the same for all maps, the radius
/// at no height passes the nearest point of the surface above that height (docs/FAMILIES.md). `pieces`: 1 to 64.
std::vector<ConeMap> bake_piecewise_cones(const DepthMap& depth, int pieces, const ConeOptions& options,
                                          ConeStatistics* statistics = nullptr);

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

/// Rows [first, end) alone; the others are 0, and not counted.
EncodedConeMap encode_cone_rows(const ConeMap& cones, const DepthMap& depth, const EncodeOptions& options, int first, int end);

/// Ratio that a sampled value stands for. `depth` in [0,1] is the sampled depth (only `radius` reads it; at depth 0
/// it decodes to ratio_max: the top plane has nothing above it). ratio: v * ratio_max. sqrt: v^2 * ratio_max.
/// radius: v / depth. normal: v / sqrt(1 - v^2).
double decode_ratio(double value, double depth, ConeEncoding encoding, double ratio_max);

} // namespace reliefbake
