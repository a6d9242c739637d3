#pragma once
// The door: a validated height field, and the depth plane that is stored for it.

#include "bake/bit_depth.h"
#include "bake/error.h"
#include "bake/holes.h"
#include "bake/image.h"
#include "bake/seam.h"
#include "bake/texel_grid.h"

#include <optional>
#include <string>
#include <utility>

namespace reliefbake {

enum class WrapChoice { repeat, clamp, automatic };
enum class NanPolicy { error, fill };
enum class InputKind { height, depth };
enum class RangeMode { automatic, data, fixed };

struct HeightOptions {
    InputKind input = InputKind::height;    ///< what white means: high, or deep (--input)
    RangeMode range = RangeMode::automatic; ///< which source values become height 0 and 1 (--range).
                                            ///< `automatic`: integers by their format; floats as they are if
                                            ///< all lie in 0..1, else as `data`. `data`: smallest..largest
                                            ///< finite value; a flat source becomes height 1. `fixed`:
                                            ///< range_low..range_high, and a value outside is an error
    float range_low = 0;                    ///< source value that becomes height 0
    float range_high = 1;                   ///< source value that becomes height 1
    NanPolicy nan = NanPolicy::error;       ///< what NaN, Inf and no-data values do (--nan)
    std::optional<float> no_data; ///< source value that means "no sample here" (file metadata, --no-data)
    double scale = 1;             ///< height' = scale * height + bias (001 sec. 2.2); must stay in 0..1
    double bias = 0;
    WrapChoice wrap_x = WrapChoice::automatic; ///< (--wrap)
    WrapChoice wrap_y = WrapChoice::automatic;
    double pixel_aspect = 1; ///< height of a texel divided by its width, 0.5 to 2 (--pixel-aspect)
};

/// Heights in [0,1], 1 = top; finite; at least one texel; 0 at holes. Only make_height_field makes one.
class HeightField {
  public:
    const TexelGrid& grid() const { return grid_; }
    const Image<float>& heights() const { return heights_; }
    const HoleMask& holes() const { return holes_; }
    Image<float> take_heights() && { return std::move(heights_); }

  private:
    friend class HeightFieldBuilder;
    HeightField(TexelGrid grid, Image<float> heights, HoleMask holes)
        : grid_(grid), heights_(std::move(heights)), holes_(std::move(holes)) {}
    TexelGrid grid_;
    Image<float> heights_;
    HoleMask holes_;
};

/// What the door saw and chose; printed with the result.
struct HeightReport {
    double source_low = 0, source_high = 0; ///< smallest and largest finite source value
    double range_low = 0, range_high = 1;   ///< source values that became height 0 and 1
    bool range_from_data = false;           ///< they are source_low and source_high
    std::size_t bad_texels = 0;             ///< NaN, Inf or no-data, filled
    Seam seam_x, seam_y;                    ///< the border's step against those inside
};

struct CheckedHeight {
    HeightField field;
    HeightReport report;
};

/// Validates a decoded source plane and maps it to heights. `name` is the file, for messages.
/// Errors: bad_data: NaN/Inf/no-data without NanPolicy::fill (count and first position) or nowhere a valid
/// value; values outside a fixed range; scale and bias that leave 0..1. usage: options outside their ranges.
/// `holes`: empty, or of the source's size; what the source holds there is neither judged nor measured.
/// Guarantee: an integer source of 8 or 16 bits comes back code for code from quantise_depth at its own
/// depth (with holes, but for depth 1, which they reserve), and the grid's pixel aspect is one that bake_cones accepts.
/// `source` by value: a plane that is moved in becomes the heights, where it lies.
Result<CheckedHeight> make_height_field(Image<float> source, bool source_is_integer, const HeightOptions& options,
                                        const std::string& name, HoleMask holes = {});

/// The depth plane as it is stored: what the shader will sample, and what every cone is baked for (MATHS:
/// "bake from what is stored"). level = integer code for unorm, the depth itself for floating formats; both
/// exact.
struct DepthMap {
    TexelGrid grid;
    BitDepth bits = BitDepth::float32;
    Image<float> level; ///< depth 0 (top) .. max_code(bits) (bottom), in code units
    bool holes = false; ///< depth 1 is a hole, and no solid texel is as deep (bake/holes.h)

    /// Depth in [0,1] of one stored level.
    double depth(int x, int y) const { return double(level(x, y)) / max_code(bits); }
    bool is_hole(int x, int y) const { return holes && level(x, y) == float(max_code(bits)); }
};

/// Depth = 1 - height, rounded to the nearest code of `bits`. Of a field with holes, solid texels to the nearest code below 1.
DepthMap quantise_depth(const HeightField& field, BitDepth bits);
/// The same in place of the heights.
DepthMap quantise_depth(HeightField&& field, BitDepth bits);

} // namespace reliefbake
