#include "cli/scene/bake_cost.h"

#include <cassert>
#include <string_view>

namespace reliefbake {
namespace {

/// As `reliefbake bench scene` measured them on the example scene (docs/SCENE.md), on one thread.
constexpr BakeCost costs[] = {{"cones", 870},  {"relaxed cones", 1130}, {"cone normals", 930}, {"4 sectors", 1850}, {"8 sectors", 4470}, {"open cones", 380},
                              {"depth and normals", 480}, {"normals", 400}, {"horizons", 1290}, {"distances", 1330}, {"quadrics", 17200}};

} // namespace

double nanoseconds_of(const std::string& what) {
    for (const BakeCost& cost : costs)
        if (std::string_view(cost.what) == what) return cost.nanoseconds;
    assert(false);
    return 0;
}

double predicted_seconds(const SceneMap& map) { return 1e-9 * nanoseconds_of(map.what) * double(map.units); }

} // namespace reliefbake
