#include "formats/shape_json.h"

#include "formats/fact_reader.h"

#include <array>

namespace reliefbake {

using nlohmann::json;

namespace {

// The words of the file format, in the order of the enumerators.
constexpr std::array model_words{"squares", "centres", "contour"};
constexpr std::array method_words{"exact", "danielsson"};

} // namespace

json to_json(const ShapeMapInfo& info, const TexelGrid& grid) {
    return {
        {"kind", "shape"},
        {"version", info.version},
        {"width", grid.width},
        {"height", grid.height},
        {"aspect", grid.aspect()},
        {"wrap", wrap_to_json(grid)},
        {"model", model_words[std::size_t(info.model)]},
        {"method", method_words[std::size_t(info.method)]},
        {"signed", info.signed_distance},
        {"inverted", info.inverted},
        {"bits", bits_to_json(info.bits)},
        {"layout", layout_words[info.named]},
        {"channels", shape_channels(info)},
        {"scale_f", info.scale_f},
        {"max_distance", info.max_distance},
        {"tau", info.tau},
        {"units", "texture widths"},
        {"filter_delta", info.filter_delta},
        {"guarantee", info.guarantee},
        {"source_hash", info.source_hash},
        {"argument_hash", info.argument_hash},
        {"statistics", numbers_to_json(info.statistics)},
    };
}

std::vector<std::string> shape_channels(const ShapeMapInfo& info) {
    if (info.named) return {"shape.gx", "shape.gy", "shape.distance", "shape.mask"};
    return {"R", "G", "B", "A"};
}

ShapeFacts shape_facts_from(const std::string& text) {
    ShapeFacts facts;
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object()) return facts;
    const FactReader reader(object, facts.bad_keys);
    constexpr double longest = 1e6; // texels, and texture widths: far beyond any image
    facts.kind = reader.text("kind").value_or("");
    ShapeMapInfo& info = facts.info;
    info.model = reader.required(reader.word<ShapeModel>("model", model_words), "model");
    info.method = reader.word<DistanceMethod>("method", method_words).value_or(DistanceMethod::exact);
    info.signed_distance = reader.required(reader.flag("signed"), "signed");
    info.inverted = reader.flag("inverted").value_or(false);
    if (const auto layout = reader.text("layout")) info.named = *layout == layout_words[1];
    info.scale_f = reader.number("scale_f", 0, 1).value_or(1);
    info.max_distance = reader.number("max_distance", 0, longest).value_or(0);
    info.tau = reader.required(reader.number("tau", 1e-12, longest), "tau");
    info.filter_delta = reader.number("filter_delta", 0, 1).value_or(0);
    info.guarantee = reader.text("guarantee").value_or("");
    reader.origin(info);
    const auto wrap = reader.required(reader.wrap("wrap"), "wrap");
    facts.wrap_x = wrap.first;
    facts.wrap_y = wrap.second;
    return facts;
}

} // namespace reliefbake
