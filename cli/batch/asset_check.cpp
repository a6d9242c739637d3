#include "cli/batch/asset_check.h"

#include "formats/bump_file.h"
#include "formats/map_file.h"
#include "formats/shape_file.h"
#include "formats/write_image.h"
#include "shaders-reference/measure/check_bump.h"
#include "shaders-reference/measure/verify_shape.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

constexpr int rays = 7000, points = 2000, side = 96;

/// Not judged is worse than safe: somebody should look.
double severity_of(Verdict verdict) {
    switch (verdict) {
    case Verdict::safe: return 0;
    case Verdict::not_conservative: return 2;
    case Verdict::other_source: return 3;
    case Verdict::unsafe: return 4;
    }
    return 4;
}
constexpr double severity_not_judged = 1;

AssetCheck not_judged(const std::string& why) { return {"not judged: " + why, severity_not_judged, {}, {}, ""}; }

/// Means of whole blocks of pixels: at most `side` wide and high.
RgbImage shrunk(const RgbImage& picture) {
    const int factor = std::max(1, (std::max(picture.width, picture.height) + side - 1) / side);
    RgbImage small{std::max(1, picture.width / factor), std::max(1, picture.height / factor), {}};
    small.rgb.reserve(std::size_t(small.width) * std::size_t(small.height) * 3);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x)
            for (int c = 0; c < 3; ++c) {
                int sum = 0, count = 0;
                for (int j = y * factor; j < std::min((y + 1) * factor, picture.height); ++j)
                    for (int i = x * factor; i < std::min((x + 1) * factor, picture.width); ++i, ++count)
                        sum += picture.rgb[(std::size_t(j) * std::size_t(picture.width) + std::size_t(i)) * 3 + std::size_t(c)];
                small.rgb.push_back(std::uint8_t(sum / std::max(1, count)));
            }
    return small;
}

std::string thumbnail_of(const RgbImage& picture, const std::string& name) {
    if (picture.rgb.empty()) return "";
    const RgbImage small = shrunk(picture);
    return encode_png(small.width, small.height, 3, small.rgb, name).value_or("");
}

RgbImage coloured(const Image<float>& red, const Image<float>& green, const Image<float>& blue) {
    RgbImage picture{red.width(), red.height(), {}};
    const auto byte = [](float value) { return std::uint8_t(std::lround(255 * std::clamp(double(value), 0.0, 1.0))); };
    for (std::size_t k = 0; k < red.size(); ++k) picture.rgb.insert(picture.rgb.end(), {byte(red[k]), byte(green[k]), byte(blue[k])});
    return picture;
}

} // namespace

AssetCheck AssetChecker::check_cones(const std::filesystem::path& file) {
    const Result<ReliefMap> map = read_map(file);
    if (!map) return not_judged(map.error().message);
    if (!renderer_) {
        Result<ReliefRenderer> renderer = ReliefRenderer::create(RendererBackend::osmesa);
        if (!renderer) return not_judged(renderer.error().message);
        renderer_.emplace(std::move(*renderer));
    }
    VerifyOptions options;
    options.renderer = &*renderer_;
    options.rays = rays, options.points = points, options.crop = 0, options.threads = threads_;
    options.views = {{45, 30}, {70, 115}};
    options.pictures = true;
    const Result<VerifyReport> report = verify(*map, options);
    if (!report) return not_judged(report.error().message);
    const Comparison& total = report->total;
    const double share = total.rays > 0 ? 1.0 / double(total.rays) : 0;
    AssetCheck check{to_string(report->verdict), severity_of(report->verdict), double(total.missed) * share, double(total.early) * share, ""};
    check.severity += (*check.missed + *check.early) / 4;
    check.thumbnail = thumbnail_of(report->views.front().pictures->rendering, file.string());
    return check;
}

AssetCheck AssetChecker::check_shape(const std::filesystem::path& file) const {
    const Result<ShapeMap> map = read_shape_map(file);
    if (!map) return not_judged(map.error().message);
    ShapeVerifyOptions options;
    options.rays = rays, options.points = points, options.threads = threads_;
    const Result<ShapeVerifyReport> report = verify_shape(*map, options);
    AssetCheck check = report ? AssetCheck{to_string(report->verdict), severity_of(report->verdict), {}, {}, ""} : not_judged(report.error().message);
    check.thumbnail = thumbnail_of(coloured(map->distance, map->distance, map->distance), file.string());
    return check;
}

AssetCheck AssetChecker::check_bump(const std::filesystem::path& file) const {
    const Result<BumpMap> map = read_bump_map(file);
    if (!map) return not_judged(map.error().message);
    AssetCheck check = not_judged("it holds horizons alone; `reliefbake verify --relief` judges it beside its cone map");
    if (!map->depth.empty()) {
        BumpCheckOptions options;
        options.rays = rays, options.points = points, options.threads = threads_;
        const Result<BumpReport> report = verify_bump(*map, options);
        if (!report) return not_judged(report.error().message);
        check = report->violations == 0 ? AssetCheck{"holds", severity_of(Verdict::safe), {}, {}, ""} : AssetCheck{"violated", severity_of(Verdict::unsafe), {}, {}, ""};
    }
    check.thumbnail = thumbnail_of(coloured(map->planes[0], map->planes[1], map->planes.size() > 2 ? map->planes[2] : map->depth), file.string());
    return check;
}

AssetCheck AssetChecker::check(const std::filesystem::path& out, const LedgerLine& line) {
    const std::filesystem::path file = out / line.id;
    if (line.kind == "shape") return check_shape(file);
    if (line.kind == "bump") return check_bump(file);
    if (line.kind == "quadric") return not_judged("`reliefbake verify --mesh` judges a relief map on it");
    return check_cones(file);
}

} // namespace reliefbake
