// The metadata of any file: never a crash, no fact that breaks its promise, and a second reading of what we write agrees.

#include "formats/map_json.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace reliefbake;
    const MapMetadata read = map_metadata_from(std::string(reinterpret_cast<const char*>(data), size));
    if (read.cone_max && !(*read.cone_max > 0)) std::abort();
    for (const auto& fact : {read.depth_scale, read.pixel_aspect, read.filter_delta, read.tolerance})
        if (fact && !std::isfinite(*fact)) std::abort();

    ReliefMapInfo info;
    info.statistics = read.statistics;
    if (read.cone_max) info.cone_max = *read.cone_max;
    const auto replace = nlohmann::json::error_handler_t::replace;
    const MapMetadata again = map_metadata_from(to_json(info, {}).dump(-1, ' ', true, replace));
    if (again.cone_max != info.cone_max || !again.bad_keys.empty()) std::abort();
    return 0;
}
