#include "cli/explain/explain_shape.h"

#include "bake/wrap_words.h"
#include "cli/explain/explain_lines.h"
#include "cli/report/format_text.h"
#include "cli/shape/shape_choices.h"
#include "formats/shape_json.h"

namespace reliefbake {

namespace {

const char* model_lines(ShapeModel model) {
    switch (model) {
    case ShapeModel::squares: return "The shape is the union of the squares of its texels";
    case ShapeModel::centres: return "The shape is the centres of its texels";
    case ShapeModel::contour: return "The shape is the squares of its texels, those of anti-aliased edges cut where the coverage says";
    }
    return "";
}

} // namespace

std::string explain_shape_text(const ShapeMap& map) {
    const ShapeMapInfo& info = map.info;
    const std::vector<std::string> channels = shape_channels(info);
    const std::string b = channels[2], gradient = "vec2(" + channels[0] + ", " + channels[1] + ")";
    const bool scaled = is_unorm(info.bits);
    std::string text = title_line("shape", map.grid, info.bits, info.version);
    text += "Sample it with linear or nearest filtering, " + addressing_of(map.grid) + ", no sRGB decoding, no mips.\n";
    text += std::string(model_lines(info.model)) + (info.inverted ? "; it is the other side of its picture.\n" : ".\n");
    text += "  distance " + digits(info.tau) + " * " + (info.signed_distance && scaled ? "(2.0 * " + b + " - 1.0)" : b) +
            " texture widths; at most " + digits(info.max_distance) + " texels, of which codes span " + digits(info.scale_f) + ".\n" +
            (info.signed_distance ? "           Inside the shape it is minus the distance to its outside.\n" : "");
    if (!info.guarantee.empty())
        text += "  safe     A filtered distance D allows a step of sqrt(max(0.0, D * D - " + digits(0.5 / map.grid.width / map.grid.width) +
                ")) (guarantee S); where the sampler has\n           8-bit weights, " + digits(info.filter_delta) + " less.\n";
    else text += "  safe     Nothing is guaranteed: the distances of this method are a little too large here and there.\n";
    text += "  gradient normalize(" + (scaled ? "2.0 * " + gradient + " - 1.0" : gradient) + "), u to the right, v down the image.\n";
    text += "  shape    " + channels[3] + "; 0 inside, 1 outside; fetch it unfiltered.\n";
    return text + statistics_lines(info.statistics) + source_line(info.source_hash, info.argument_hash);
}

} // namespace reliefbake
