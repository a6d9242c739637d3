// The metadata of bump maps: never a crash, no fact out of its range, and what is sound comes back as it was written.

#include "formats/bump_json.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace reliefbake;
    const BumpFacts read = bump_facts_from(std::string(reinterpret_cast<const char*>(data), size));
    if (!bump_kind_of(read.kind) || !read.bad_keys.empty()) return 0;
    const BumpMapInfo& info = read.info;
    if (!(info.depth_scale > 0 && info.derivative_scale > 0 && info.error >= 0 && read.pixel_aspect > 0)) std::abort();
    for (const double fact : {info.depth_scale, info.derivative_scale, info.error, read.pixel_aspect})
        if (!std::isfinite(fact)) std::abort();
    if (bump_images(info).empty()) std::abort();

    const TexelGrid grid{8, 6, read.wrap_x, read.wrap_y, read.pixel_aspect};
    const auto replace = nlohmann::json::error_handler_t::replace;
    const BumpFacts again = bump_facts_from(to_json(info, grid).dump(-1, ' ', true, replace));
    if (again.kind != read.kind || !again.bad_keys.empty() || to_json(again.info, grid).dump(-1, ' ', true, replace) != to_json(info, grid).dump(-1, ' ', true, replace))
        std::abort();
    return 0;
}
