#pragma once
// A mip chain of maps whose values every depth can hold, all different.

#include "bake/relief_map.h"

#include <algorithm>
#include <vector>

namespace reliefbake::test {

inline Image<float> codes(int width, int height, BitDepth bits, int seed) {
    Image<float> plane(width, height);
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const int code = int((i * 7 + i / 251 + std::size_t(seed) * 31) % 256);
        plane[i] = bits == BitDepth::unorm8    ? float(code) / 255.0f
                   : bits == BitDepth::unorm16 ? float(code * 257 - code % 3 * (code > 3)) / 65535.0f
                                               : float(code) / 256.0f;
    }
    return plane;
}

inline std::vector<ReliefMap> mip_chain(int width, int height, BitDepth bits, const ReliefMapInfo& given = {}) {
    std::vector<ReliefMap> chain;
    const double aspect = double(height) / width * 1.25;
    for (int n = 0;; ++n) {
        ReliefMap map;
        map.info = given;
        map.info.bits = bits;
        const int w = std::max(1, width >> n), h = std::max(1, height >> n);
        map.grid = {w, h, Wrap::repeat, Wrap::clamp, aspect * w / h};
        map.normal_x = codes(w, h, bits, 4 * n);
        map.normal_y = codes(w, h, bits, 4 * n + 1);
        map.cone = codes(w, h, bits, 4 * n + 2);
        map.depth = codes(w, h, bits, 4 * n + 3);
        for (int k = 0; k < given.planes; ++k) map.cone_planes.push_back(codes(w, h, bits, 100 + 8 * n + k));
        chain.push_back(std::move(map));
        if (w == 1 && h == 1) break;
    }
    for (ReliefMap& map : chain) map.info.levels = int(chain.size());
    return chain;
}

} // namespace reliefbake::test
