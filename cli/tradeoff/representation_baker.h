#pragma once
// Bakes representations of one height field in memory.

#include "bake/normal_map.h"
#include "bake/relief_map.h"
#include "bake/shared_pyramids.h"
#include "cli/cone/stored_height.h"
#include "cli/tradeoff/candidate.h"

#include <optional>

namespace reliefbake {

struct BakedRepresentation {
    Representation made_of;
    ReliefMap map;
    double seconds = 0; ///< to bake it: cones, codes and normals; what several share counts for each, but pyramids for the first
};

/// One at a time, so that a sweep's memory is that of one bake. The stored depth with its pyramids and normals, and the cones, are
/// kept for the next: order representations by bits and level, then so that encodings of the same cones follow each other.
class RepresentationBaker {
  public:
    /// `source`: with its field; outlives the baker. `depth_scale`: of the relief in texture widths. `threads`: 0: all.
    RepresentationBaker(const BakeSource& source, double depth_scale, int threads)
        : source_(source), depth_scale_(depth_scale), threads_(threads) {}

    /// The same bits as the tool's commands write, for any number of threads; valid until the next call.
    /// Errors (usage): a level that the field does not have.
    Result<const BakedRepresentation*> bake(const Representation& wanted);

  private:
    struct Surface {
        BitDepth bits;
        int level;
        DepthMap depth;
        SharedPyramids pyramids;
        NormalMap normals;
        double seconds; ///< of the normals
    };
    struct Cones {
        Representation made_of;
        std::vector<ConeMap> planes;
        double seconds;
    };

    Result<void> prepare_surface(const Representation& wanted);
    void prepare_cones(const Representation& wanted);

    const BakeSource& source_;
    double depth_scale_;
    int threads_;
    std::optional<Surface> surface_;
    std::optional<Cones> cones_;
    std::optional<BakedRepresentation> baked_;
};

} // namespace reliefbake
