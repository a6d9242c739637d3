#pragma once
// Distance transforms that Python's packages bring, found at run time: OpenCV (python3-opencv) and SciPy (python3-scipy).

#include "bake/error.h"
#include "bake/image.h"

#include <nlohmann/json.hpp>

#include <cstdint>

namespace reliefbake {

struct PeerRun {
    int threads = 1;
    int repeat = 3; ///< runs; the fastest counts
};

/// One object for each package that python3 can import, an empty array without any: name, version, ns_per_pixel (the output reused where
/// the package can), wrong (share of pixels that are not ours to a relative 1e-6), error_max (pixels). `ours`: distances to the
/// centres of texels of 0.
/// Errors: write_failed (no room for temporary files).
Result<nlohmann::json> time_python_peers(const Image<std::uint8_t>& picture, const Image<float>& ours, const PeerRun& run);

} // namespace reliefbake
