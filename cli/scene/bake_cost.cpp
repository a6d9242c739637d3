#include "cli/scene/bake_cost.h"

#include <cassert>
#include <string_view>

namespace reliefbake {
namespace {

/// Estimates; `reliefbake bench scene` prints measured ones beside them.
constexpr BakeCost costs[] = {{"cones", 500},  {"relaxed cones", 500}, {"cone normals", 500}, {"4 sectors", 1000}, {"8 sectors", 2000}, {"open cones", 500},
                              {"depth and normals", 100}, {"normals", 200}, {"horizons", 500}, {"distances", 300}, {"quadrics", 2000}};

} // namespace

double nanoseconds_of(const std::string& what) {
    for (const BakeCost& cost : costs)
        if (std::string_view(cost.what) == what) return cost.nanoseconds;
    assert(false);
    return 0;
}

double predicted_seconds(const SceneMap& map) { return 1e-9 * nanoseconds_of(map.what) * double(map.units); }

} // namespace reliefbake
