#pragma once
// Sectors of azimuth, as mirrored wedges of one quadrant (MATHS section 4; 002 sec. II-B).

#include "bake/flip.h"
#include "bake/search_surface.h"

#include <vector>

namespace reliefbake {

/// Directions that become `wedge` (dx, dy >= 0) when the image is flipped.
struct Sector {
    Flip flip;
    Wedge wedge;
};

/// Sector k of 4 or 8: angles of (du, R dv) in [2 pi k/n, 2 pi (k+1)/n], borders included.
std::vector<Sector> sectors_of(int count);

/// Offsets of a footprint in the flipped image.
inline Footprint flipped(Footprint f, Flip flip) {
    if (flip.x) f = {-f.x_high, -f.x_low, f.y_low, f.y_high};
    if (flip.y) f = {f.x_low, f.x_high, -f.y_high, -f.y_low};
    return f;
}

} // namespace reliefbake
