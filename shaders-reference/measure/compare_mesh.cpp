#include "shaders-reference/measure/compare_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace reliefbake {

namespace {

struct DepthErrors {
    std::vector<float> all;
    double sum = 0;

    void add(double error) {
        all.push_back(float(error));
        sum += error;
    }
    void summarise(MeshComparison& result) {
        if (all.empty()) return;
        result.depth_mean = sum / double(all.size());
        result.depth_max = *std::max_element(all.begin(), all.end());
        const auto high = all.begin() + std::ptrdiff_t(double(all.size() - 1) * 0.99);
        std::nth_element(all.begin(), high, all.end());
        result.depth_99 = *high;
    }
};

void count_cover(bool base, bool truth, bool rendering, MeshComparison& result) {
    result.base += base;
    result.truth += truth;
    result.rendering += rendering;
    result.both += truth && rendering;
    result.holes += truth && !rendering;
    result.wrong_cover += rendering && !truth;
    result.band += base != truth;
    result.band_right += base != truth && rendering == truth;
    result.cut += base && !(truth && rendering);
    result.cut_both += base && !truth && !rendering;
}

} // namespace

MeshComparison compare_mesh(std::span<const MeshPlanes> views, double unit) {
    MeshComparison result;
    DepthErrors errors;
    double steps = 0;
    for (const MeshPlanes& view : views)
        for (std::size_t k = 0; k < view.base.size(); ++k) {
            const bool base = std::isfinite(view.base[k]), truth = std::isfinite(view.truth[k]), rendering = std::isfinite(view.rendering[k]);
            count_cover(base, truth, rendering, result);
            result.not_finite += std::isnan(view.rendering[k]);
            if (truth && rendering) errors.add(std::fabs(double(view.truth[k]) - double(view.rendering[k])) / unit);
            if (!base) continue;
            steps += view.steps[k];
            result.steps_max = std::max(result.steps_max, double(view.steps[k]));
        }
    errors.summarise(result);
    if (result.base > 0) result.steps_mean = steps / double(result.base);
    return result;
}

} // namespace reliefbake
