#include "cli/options/map_hint_options.h"

#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "cli/options/wrap_option.h"

namespace reliefbake {

namespace {

/// Four letters of R, G, B, A or '-', no channel twice.
std::string check_channel_order(const std::string& order) {
    bool ok = order.size() == 4;
    for (std::size_t i = 0; ok && i < order.size(); ++i) {
        ok = std::string("RGBA-").find(order[i]) != std::string::npos;
        ok = ok && (order[i] == '-' || order.find(order[i], i + 1) == std::string::npos);
    }
    if (ok) return "";
    return "expected four letters of R, G, B, A or '-' for normal x, normal y, cone, depth, each channel "
           "once; found '" +
           order + "'";
}

} // namespace

void add_map_hints(CLI::App& app, MapHints& hints) {
    app.option_defaults()->group("What the file does not say (wins over its metadata)");
    add_choice(app, "--encoding", hints.encoding, encoding_words, "Encoding of the cone channel");
    add_choice(app, "--metric", hints.metric, metric_words, "Metric the cones were baked in");
    add_choice(app, "--surface", hints.surface, surface_words, "Surface the cones were baked for");
    add_wrap_hint(app, hints.wrap_x, hints.wrap_y);
    add_number(app, "--cone-max", hints.cone_max, positive_or_inf, "Ratio that the largest code stands for");
    add_choice(app, "--normal-y", hints.normal_y, normal_y_words, "Direction of the normals' y");
    add_number(app, "--depth-uv", hints.depth_scale, positive_number,
               "Depth of the relief in texture widths");
    app.add_option("--channel-order", hints.channel_order,
                   "File channels of normal x, normal y, cone, depth, e.g. RGBA or --BA ('-': absent)")
        ->check(check_channel_order)
        ->type_name("LETTERS");
    app.add_flag("--alpha-is-height", hints.alpha_is_height, "The depth channel holds height");
    app.add_flag("--holes", hints.holes, "Depth 1 is a hole through which rays fall");
    app.add_option("--relief", hints.relief,
                   "Cone map of the same heights: depth and normals for a map that holds cones alone")
        ->type_name("FILE");
    app.add_option("--level", hints.level, "Mip level of an EXR or TIFF (default 0, the largest)")
        ->check(CLI::Range(0, 30));
    add_byte_budget(app, hints.max_bytes);
}

Result<void> refuse_hints(const MapHints& h, const std::string& file, const std::string& kind) {
    const bool given = h.metric || h.encoding || h.surface || h.normal_y || h.wrap_x || h.wrap_y || h.cone_max || h.depth_scale ||
                       !h.channel_order.empty() || h.alpha_is_height || !h.relief.empty() || h.level > 0;
    if (!given) return {};
    return fail(ErrorCode::usage, file + ": is a map of kind " + kind + " and says itself what it means; leave out the options that would tell");
}

} // namespace reliefbake
