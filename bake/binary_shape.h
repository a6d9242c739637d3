#pragma once
// The door for shapes: which texels of a picture belong to the form that is extruded or revolved.

#include "bake/error.h"
#include "bake/image.h"
#include "bake/texel_grid.h"

#include <cstdint>
#include <string>

namespace reliefbake {

/// What exactly the shape is; distances are to the nearest point of it (MATHS of 003, 004 leave it open).
enum class ShapeModel {
    squares, ///< union of the squares of its texels
    centres, ///< centres of its texels: the integer Euclidean distance transform of the papers
    contour, ///< squares of its texels, each partly covered one cut by a straight edge (Gustavson & Strand 2011)
};

struct ShapeOptions {
    double threshold = 0.5;         ///< sample value, 0 to 1, from which on a texel is bright (--threshold)
    bool bright_is_inside = false;  ///< which side is the shape: the dark texels of a drawing, the opaque ones of an alpha channel
    bool invert = false;            ///< takes the other side (--invert)
    bool wrap_x = false, wrap_y = false; ///< the picture tiles: distances reach across its border (--wrap)
    ShapeModel model = ShapeModel::squares;
};

/// At least one texel. Only make_shape makes one.
class BinaryShape {
  public:
    /// Wrap::repeat: the picture tiles. Wrap::clamp: it goes on beyond its border as its border texels, which changes no distance
    /// inside it. The texels are square.
    const TexelGrid& grid() const { return grid_; }
    ShapeModel model() const { return model_; }
    /// 0 inside the shape, 1 outside.
    const Image<std::uint8_t>& outside() const { return outside_; }
    /// ShapeModel::contour alone, else empty: the part of each texel, 0 to 1, that the shape covers.
    const Image<float>& coverage() const { return coverage_; }
    std::uint64_t inside_count() const { return inside_count_; }
    bool empty() const { return empty_; } ///< no part of any texel is inside
    bool full() const { return full_; }   ///< all of every texel is

  private:
    friend Result<BinaryShape> make_shape(Image<float>, const ShapeOptions&, const std::string&);
    BinaryShape() = default;
    TexelGrid grid_;
    ShapeModel model_ = ShapeModel::squares;
    Image<std::uint8_t> outside_;
    Image<float> coverage_;
    std::uint64_t inside_count_ = 0;
    bool empty_ = true, full_ = true;
};

/// A texel is inside when its sample is below the threshold (`bright_is_inside`: at or above it), and `invert` turns that round.
/// With ShapeModel::contour, samples are how much of a texel is bright, and a texel is inside when the shape covers at least half
/// of it. `name` is the file, for messages.
/// Errors: bad_data: NaN, or for `contour` samples outside 0..1 (count and first position). usage: a threshold outside 0..1, or
/// another one than 0.5 with `contour`.
Result<BinaryShape> make_shape(Image<float> samples, const ShapeOptions& options, const std::string& name);

} // namespace reliefbake
