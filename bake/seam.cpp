#include "bake/seam.h"

#include <cmath>

namespace reliefbake {

namespace {

double row_step(const float* a, const float* b, int count) {
    double sum = 0;
    for (int x = 0; x < count; ++x)
        sum += std::fabs(double(a[x]) - double(b[x]));
    return sum;
}

double column_steps(const float* row, int count) {
    double sum = 0;
    for (int x = 1; x < count; ++x)
        sum += std::fabs(double(row[x]) - double(row[x - 1]));
    return sum;
}

/// Ratio of the means: `border` sums one step per line, `inside` sums steps - 1 of them.
double seam(double border, double inside, int texels) {
    return inside > 0 ? border * (texels - 1) / inside : 0;
}

} // namespace

Seams measure_seams(const Image<float>& plane) {
    const int width = plane.width(), height = plane.height();
    double border_x = 0, inside_x = 0, inside_y = 0;
    for (int y = 0; y < height; ++y) {
        const float* row = plane.row(y);
        border_x += std::fabs(double(row[0]) - double(row[width - 1]));
        inside_x += column_steps(row, width);
        if (y > 0) inside_y += row_step(row, plane.row(y - 1), width);
    }
    const double border_y = row_step(plane.row(0), plane.row(height - 1), width);
    return {seam(border_x, inside_x, width), seam(border_y, inside_y, height)};
}

} // namespace reliefbake
