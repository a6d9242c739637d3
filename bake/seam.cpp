#include "bake/seam.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace reliefbake {

namespace {

constexpr double widest_seam = 3;

/// steps[i]: summed |difference| of lines i and i + 1; the last one is the border's.
Seam seam_of(const std::vector<double>& steps) {
    double sum = 0, largest = 0;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        sum += steps[i];
        largest = std::max(largest, steps[i]);
    }
    if (!(sum > 0)) return {};
    const double mean = sum / double(steps.size() - 1);
    return {steps.back() / mean, largest / mean};
}

} // namespace

Seams measure_seams(const Image<float>& plane) {
    const int width = plane.width(), height = plane.height();
    std::vector<double> across(width, 0.0), down(height, 0.0);
    for (int y = 0; y < height; ++y) {
        const float* row = plane.row(y);
        const float* below = plane.row(y + 1 < height ? y + 1 : 0);
        for (int x = 0; x < width; ++x) {
            across[x] += std::fabs(double(row[x + 1 < width ? x + 1 : 0]) - double(row[x]));
            down[y] += std::fabs(double(below[x]) - double(row[x]));
        }
    }
    return {seam_of(across), seam_of(down)};
}

Wrap wrap_for_seam(const Seam& seam) {
    return seam.border < widest_seam || seam.border <= seam.steepest ? Wrap::repeat : Wrap::clamp;
}

} // namespace reliefbake
