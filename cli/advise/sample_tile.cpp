#include "cli/advise/sample_tile.h"

#include <algorithm>

namespace reliefbake {

Result<HeightField> sample_tile(const HeightField& field, int side, const std::string& name) {
    const Image<float>& heights = field.heights();
    const int left = (heights.width() - side) / 2, top = (heights.height() - side) / 2;
    Image<float> tile(2 * side, 2 * side);
    for (int y = 0; y < side; ++y) {
        const float* from = heights.row(top + y) + left;
        for (float* row : {tile.row(y), tile.row(2 * side - 1 - y)}) {
            std::copy_n(from, side, row);
            std::reverse_copy(from, from + side, row + side);
        }
    }
    HeightOptions options;
    options.range = RangeMode::fixed, options.wrap_x = options.wrap_y = WrapChoice::repeat;
    options.pixel_aspect = field.grid().pixel_aspect;
    Result<CheckedHeight> checked = make_height_field(tile, false, options, name);
    if (!checked) return tl::unexpected(checked.error());
    return std::move(checked->field);
}

Candidate on_tile(Candidate candidate, double widths) {
    candidate.map.cone.ratio_max = float(candidate.map.cone.ratio_max * widths); // none stays none
    return candidate;
}

} // namespace reliefbake
