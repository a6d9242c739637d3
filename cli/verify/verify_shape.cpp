#include "cli/verify/verify_shape.h"

#include "cli/verify/verify_text.h"
#include "formats/shape_file.h"
#include "formats/write_image.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace reliefbake {

namespace {

/// FOLDER/extrusion-bevelled-plane-{rendering,oracle,error,steps}.png
Result<void> write_pictures(const std::string& folder, const ShapeVerifyReport& report) {
    for (const SolidReport& solid : report.solids) {
        std::string stem = solid.name;
        std::replace(stem.begin(), stem.end(), ',', '-');
        std::erase(stem, ' ');
        const std::pair<const char*, const RgbImage&> pictures[] = {{"rendering", solid.pictures->rendering},
                                                                    {"oracle", solid.pictures->oracle},
                                                                    {"error", solid.pictures->error},
                                                                    {"steps", solid.pictures->steps}};
        for (const auto& [name, picture] : pictures) {
            const std::filesystem::path path = std::filesystem::path(folder) / (stem + "-" + name + ".png");
            Result<void> written = write_png(path, picture.width, picture.height, 3, picture.rgb);
            if (!written) return written;
        }
    }
    return {};
}

} // namespace

Result<void> verify_shape_file(const ShapeFile& file, const SolidOptions& solid, ShapeVerifyOptions options, bool json,
                               const std::string& pictures) {
    options.outward = solid.outward.value_or(options.outward);
    options.bevel = solid.bevel.value_or(options.bevel);
    options.chamfer = solid.chamfer.value_or(options.chamfer);
    options.axis = solid.axis.value_or(options.axis);
    options.depth_scale = solid.depth_scale.value_or(options.depth_scale);
    options.scheme = solid.scheme.value_or(options.scheme);
    options.pictures = !pictures.empty();
    const Result<ShapeMap> map = read_shape_map(file.name, file.max_bytes);
    if (!map) return tl::unexpected(map.error());
    const Result<ShapeVerifyReport> report = verify_shape(*map, options);
    if (!report) return fail(report.error().code, file.name + ": " + report.error().message);
    std::fputs((json ? to_json(*report).dump(2) + "\n" : verify_text(*report)).c_str(), stdout);
    if (options.pictures) {
        const Result<void> written = write_pictures(pictures, *report);
        if (!written) return written;
    }
    if (report->verdict != Verdict::unsafe) return {};
    return fail(ErrorCode::verification, file.name + ": unsafe: its distances reach into the shape; bake it again");
}

} // namespace reliefbake
