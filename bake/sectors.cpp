#include "bake/sectors.h"

#include <cassert>

namespace reliefbake {

std::vector<Sector> sectors_of(int count) {
    assert(count == 4 || count == 8);
    constexpr Flip quadrants[] = {{false, false}, {true, false}, {true, true}, {false, true}}; // counted from +u towards +v
    std::vector<Sector> sectors;
    for (int q = 0; q < 4; ++q) {
        const Wedge flat{0, 1}, upright{1, Wedge().t1};
        if (count == 4) {
            sectors.push_back({quadrants[q], {}});
            continue;
        }
        // Angles grow from the u axis in quadrants 0 and 2, towards it in 1 and 3.
        sectors.push_back({quadrants[q], q % 2 == 0 ? flat : upright});
        sectors.push_back({quadrants[q], q % 2 == 0 ? upright : flat});
    }
    return sectors;
}

} // namespace reliefbake
