#include "cli/tradeoff/tradeoff_input.h"

#include "cli/argument_hash.h"
#include "formats/map_file.h"
#include "formats/map_kind.h"
#include "formats/pixel_hash.h"

#include <algorithm>

namespace reliefbake {
namespace {

std::string hash_of(const ReliefMap& map) {
    std::string text = "map";
    for (const Image<float>* plane : {&map.normal_x, &map.normal_y, &map.cone, &map.depth})
        if (!plane->empty()) text += "\n" + pixel_hash(*plane);
    for (const Image<float>& plane : map.cone_planes) text += "\n" + pixel_hash(plane);
    return hash_of_options(text + "\n" + map.info.source_hash + map.info.argument_hash);
}

Result<void> crop_to(BakeSource& source, int side, const std::string& file) {
    const Image<float>& heights = source.field->heights();
    if (side > std::min(heights.width(), heights.height()))
        return fail(ErrorCode::usage, "--crop: " + file + " is " + std::to_string(heights.width()) + "x" + std::to_string(heights.height()));
    Image<float> part(side, side);
    const int left = (heights.width() - side) / 2, top = (heights.height() - side) / 2;
    for (int y = 0; y < side; ++y) std::copy_n(heights.row(top + y) + left, side, part.row(y));
    HeightOptions options;
    options.range = RangeMode::fixed, options.wrap_x = options.wrap_y = WrapChoice::clamp;
    options.pixel_aspect = source.field->grid().pixel_aspect;
    Result<CheckedHeight> checked = make_height_field(part, false, options, file);
    if (!checked) return tl::unexpected(checked.error());
    source.field = std::move(checked->field);
    return {};
}

Result<TradeoffInput> read_baked(const std::string& file, const std::string& kind, std::uint64_t max_bytes) {
    if (kind != "cone" && kind != "acm" && kind != "cone-stack" && kind != "cone-pieces")
        return fail(ErrorCode::usage, file + ": is a map of kind " + kind + ", over which no technique of a sweep marches; give heights or a map of cones");
    MapHints hints;
    hints.max_bytes = max_bytes;
    Result<ReliefMap> map = read_map(file, hints);
    if (!map) return tl::unexpected(map.error());
    TradeoffInput input{file, hash_of(*map), map->grid.width, map->grid.height, {}, {}};
    input.map = std::move(*map);
    return input;
}

} // namespace

Result<TradeoffInput> read_tradeoff_input(const ConeCommandOptions& given, int crop) {
    const Result<std::string> kind = kind_of_map(given.input, given.read.max_bytes);
    if (!kind) return tl::unexpected(kind.error());
    if (!kind->empty()) {
        if (crop > 0) return fail(ErrorCode::usage, "--crop: " + given.input + " is a baked map, whose cones are those of the whole");
        return read_baked(given.input, *kind, given.read.max_bytes);
    }
    StageClock clock(false);
    Result<BakeSource> source = read_source(given, clock);
    if (!source) return tl::unexpected(source.error());
    if (crop > 0)
        if (Result<void> cropped = crop_to(*source, crop, given.input); !cropped) return tl::unexpected(cropped.error());
    const TexelGrid& grid = source->field->grid();
    TradeoffInput input{given.input, hash_of_options("height\n" + source->image.pixel_hash + "\n" + source_text(given) + "\n" + std::to_string(crop)), grid.width, grid.height, {}, {}};
    input.source = std::move(*source);
    return input;
}

Representation stored_representation(const ReliefMap& map) {
    const ReliefMapInfo& info = map.info;
    Representation stored;
    stored.kind = map.cone.empty() && map.cone_planes.empty() ? "height" : info.kind;
    stored.planes = std::max(1, info.planes);
    stored.cone.family = info.family, stored.cone.rays = info.rays, stored.cone.lookup = info.lookup;
    stored.cone.metric = info.metric, stored.cone.surface = info.surface;
    stored.cone.relaxed_slope = float(info.relaxed_slope), stored.cone.hybrid_delta = float(info.hybrid_delta);
    stored.cone.ratio_max = info.cone_max, stored.cone.tolerance = float(info.tolerance);
    stored.encoding = info.encoding, stored.bits = info.bits;
    return stored;
}

} // namespace reliefbake
