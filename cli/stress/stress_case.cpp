#include "cli/stress/stress_case.h"

#include "shaders-reference/measure/check_cones.h"
#include "shaders-reference/measure/stored_depth.h"
#include "shaders-reference/measure/tightness.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace reliefbake {
namespace {

std::size_t different_values(const Image<float>& plane) {
    std::vector<float> values(plane.begin(), plane.end());
    std::sort(values.begin(), values.end());
    return std::size_t(std::unique(values.begin(), values.end()) - values.begin());
}

VerifyOptions judged_by(const StressField& field, const StressEffort& effort) {
    VerifyOptions options;
    options.rays = effort.rays, options.points = effort.points, options.crop = effort.crop, options.threads = effort.threads;
    options.renderer = effort.renderer;
    for (const double angle : field.angles)
        for (const double azimuth : {0.0, 115.0}) options.views.push_back({angle, azimuth});
    return options;
}

} // namespace

bool StressResult::holds() const {
    return cones.violations == 0 && (!rays || rays->missed == 0) && (!exact || exact->violated + exact->undecided == 0);
}

Result<BakeSource> stress_source(const StressField& field, BitDepth bits, Wrap wrap) {
    Image<float> heights(field.width, field.height);
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x) heights(x, y) = float(field.value(x, y, quantum_of(bits)));
    HeightOptions options;
    options.range = field.range;
    options.pixel_aspect = field.pixel_aspect;
    options.wrap_x = options.wrap_y = wrap == Wrap::repeat ? WrapChoice::repeat : WrapChoice::clamp;
    Result<CheckedHeight> checked = make_height_field(heights, false, options, field.name);
    if (!checked) return tl::unexpected(checked.error());
    return BakeSource{SourceImage{}, "", checked->report, std::move(checked->field)};
}

Result<StressResult> judge_stress_map(const StressField& field, const ReliefMap& map, const StressEffort& effort) {
    StressResult result{field.name, map.grid, field.depth_scale, map.info.encoding, map.info.bits};
    result.levels = different_values(map.depth);
    result.ratio_mean = map.info.statistics.at("ratio_mean");
    result.dead = std::size_t(map.info.statistics.at("zero_codes"));
    const Result<VerifyReport> report = verify(map, judged_by(field, effort));
    if (!report) return tl::unexpected(report.error());
    result.cones = report->cones, result.rays = report->total, result.tightness = report->tightness.value();
    if (field.exact) result.exact = check_exactly(map, effort.exact_points, effort.threads);
    return result;
}

Result<StressResult> run_stress_case(const StressField& field, RepresentationBaker& baker, ConeEncoding encoding, BitDepth bits,
                                     const StressEffort& effort) {
    Representation wanted;
    wanted.encoding = encoding, wanted.bits = bits;
    const Result<const BakedRepresentation*> baked = baker.bake(wanted);
    if (!baked) return tl::unexpected(baked.error());
    return judge_stress_map(field, (*baked)->map, effort);
}

Result<StressResult> run_largest_case(const StressField& field, ConeEncoding encoding, BitDepth bits, const StressEffort& effort) {
    Result<BakeSource> source = stress_source(field, bits, Wrap::repeat);
    if (!source) return tl::unexpected(source.error());
    DepthMap depth = quantise_depth(*source->field, bits);
    source->field.reset();
    StressResult result{field.name, depth.grid, field.depth_scale, encoding, bits};
    ConeOptions options;
    options.threads = effort.threads;
    ReliefMap map;
    {
        ConeMap cones = bake_cones(depth, options);
        result.ratio_mean = std::accumulate(cones.ratio.begin(), cones.ratio.end(), 0.0) / double(cones.ratio.size());
        EncodedConeMap encoded = encode_cones(cones, depth, {encoding, bits});
        result.dead = encoded.zero_codes;
        map.cone = std::move(encoded.value);
    }
    map.grid = depth.grid;
    map.info.encoding = encoding, map.info.bits = bits;
    const BilinearSurface surface(depth);
    map.depth = std::move(depth.level);
    for (float& level : map.depth) level /= float(max_code(bits));
    ConeCheckOptions check;
    check.points = effort.points, check.threads = effort.threads;
    result.cones = check_cones(map, surface, check);
    TightnessOptions tight;
    tight.crop = effort.crop, tight.threads = effort.threads;
    result.tightness = tightness(map, surface, tight);
    return result;
}

} // namespace reliefbake
