#include "cli/argument_hash.h"

#include "cli/choices.h"
#include "cli/report/format_text.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace reliefbake {

namespace {

/// The shortest digits that read back as the same number, in every locale.
std::string result_text(const ConePlan& plan) {
    std::string text = "\nsurface=" + word_of(surface_words, plan.cone.surface);
    text += "\nmetric=" + word_of(metric_words, plan.cone.metric);
    text += "\ntolerance=" + digits(plan.cone.tolerance) + "\ncone-max=" + digits(plan.cone.ratio_max);
    text += "\ndepth-uv=" + digits(plan.depth_scale) + "\nbits=" + word_of(bits_words, plan.bits);
    text += "\nplanes=" + std::to_string(plan.given.planes) + "\nkind=" + word_of(family_words, plan.cone.family);
    if (plan.given.adaptive)
        text += "\nadaptive=" + std::to_string(plan.given.adaptive->levels) + ":" + digits(plan.given.adaptive->similarity);
    text += "\nrelaxed=" + std::to_string(int(plan.cone.rays)) + ":" + digits(plan.cone.relaxed_slope);
    text += "\ndelta=" + digits(plan.cone.hybrid_delta) + "\nlookup=" + word_of(lookup_words, plan.cone.lookup);
    text += "\nencoding=" + word_of(encoding_words, plan.given.encoding);
    text += "\nnormal-y=" + word_of(normal_y_words, plan.given.normal_y);
    if (plan.given.held != HeldPlanes()) text += "\nheld=" + std::to_string(plan.given.held.normals) + std::to_string(plan.given.held.cones);
    if (plan.given.level > 0) text += "\nlevel=" + std::to_string(plan.given.level);
    if (plan.given.mip_levels) text += "\nmip-levels=" + std::to_string(*plan.given.mip_levels);
    if (plan.given.mips) text += plan.given.trilinear ? "\nmips=trilinear" : "\nmips=nearest";
    return text + "\nlayout=" + word_of(layout_words, plan.layout) + "\n";
}

} // namespace

std::string source_text(const ConeCommandOptions& o) {
    const HeightOptions& h = o.height;
    std::string text = "channel=" + o.read.channel + "\ninput=" + word_of(input_words, h.input);
    text += "\nrange=" + std::to_string(int(h.range));
    if (h.range == RangeMode::fixed) text += ":" + digits(h.range_low) + ":" + digits(h.range_high);
    text += "\nnan=" + word_of(nan_words, h.nan);
    if (h.no_data) text += "\nno-data=" + digits(*h.no_data);
    text += "\nscale=" + digits(h.scale) + "\nbias=" + digits(h.bias);
    if (!o.alpha.from.empty()) text += "\nalpha-threshold=" + digits(o.alpha.threshold);
    text += "\nwrap=" + std::to_string(int(h.wrap_x)) + "," + std::to_string(int(h.wrap_y));
    return text + "\npixel-aspect=" + digits(h.pixel_aspect);
}

std::string hash_of_options(const std::string& text) {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits(text.data(), text.size()));
    std::string hex;
    for (const unsigned char byte : canonical.digest)
        for (const int nibble : {byte >> 4, byte & 15})
            hex += "0123456789abcdef"[nibble];
    return hex;
}

std::string argument_hash(const ConePlan& plan) {
    return hash_of_options(plan.given.kind + "\n" + source_text(plan.given) + result_text(plan));
}

} // namespace reliefbake
