#include "cli/batch/predict.h"

#include "cli/batch/bake_kinds.h"
#include "formats/file_identity.h"
#include "formats/image_gate.h"
#include "formats/image_header.h"

#include <algorithm>

namespace reliefbake {

namespace {

constexpr double helper_bytes = 150e6; ///< its libraries, and what the tool itself holds
constexpr double most_bytes = 1e18;    ///< headers may claim anything

constexpr double refusal_seconds = 0.01;

/// Whether the header alone is more than the decoder takes; the heights of a map that is baked out of core may be any number.
bool is_refused(const ImageHeader& header, const std::string& kind, const CommandFiles& files) {
    if (header.width > max_side || header.height > max_side) return true;
    const std::string extension = files.outputs.front().extension().string();
    if (kind == "cone" && extension != ".png" && extension != ".tga") return false;
    constexpr double default_budget = 1u << 30;
    return 4.0 * double(header.width) * double(header.height) > (files.max_bytes > 0 ? double(files.max_bytes) : default_budget);
}

} // namespace

Prediction predict_bake(const std::string& kind, const CommandFiles& files) {
    const BakeKind& known = *find_bake_kind(kind);
    Prediction prediction;
    const double file_bytes = double(stamp_of(files.inputs.front()).value_or(FileStamp()).size);
    if (known.of_mesh) {
        prediction.bytes = std::uint64_t(60 * file_bytes + 20e6);
        prediction.seconds = 0.002 + file_bytes * known.nanoseconds * 1e-9;
        return prediction;
    }
    const std::optional<ImageHeader> header = peek_image_header(files.inputs.front());
    if (header) prediction.width = header->width, prediction.height = header->height;
    if (header && is_refused(*header, kind, files)) {
        prediction.bytes = std::uint64_t(helper_bytes), prediction.seconds = refusal_seconds;
        return prediction;
    }
    const double chain = files.mips ? 4.0 / 3.0 : 1;
    const double texels = chain * (header ? double(header->width) * double(header->height) : file_bytes);
    const double images = std::max(1.0, files.planes / 4), stored = 4 * files.sample_bytes * images;
    prediction.bytes = std::uint64_t(std::min(most_bytes, texels * (24 + 8 * files.planes + stored) + 3 * stored * texels + helper_bytes));
    prediction.seconds = 0.01 + texels * known.nanoseconds * 1e-9;
    return prediction;
}

} // namespace reliefbake
