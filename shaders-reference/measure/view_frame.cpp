#include "shaders-reference/measure/view_frame.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {
namespace {

constexpr double narrow_field = 10;     ///< degrees: every ray of a view has nearly the view's angle
constexpr double flattest_picture = 40; ///< width over height at grazing views of one tile

} // namespace

RenderOptions view_frame(const TexelGrid& grid, double angle, double azimuth, int rays) {
    const bool endless = grid.wrap_x == Wrap::repeat && grid.wrap_y == Wrap::repeat;
    const double foreshortened = 1 / std::max(std::cos(angle * 3.14159265358979 / 180), 1 / flattest_picture);
    const double aspect = endless ? 4.0 / 3 : foreshortened;
    RenderOptions result;
    result.width = std::max(8, int(std::lround(std::sqrt(rays * aspect))));
    result.height = std::max(8, int(std::lround(std::sqrt(rays / aspect))));
    result.endless = endless;
    result.view = {angle, azimuth, narrow_field, 0};
    return result;
}

} // namespace reliefbake
