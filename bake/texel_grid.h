#pragma once
// Where texels are: the one place that knows texel centres, addressing and the metric (docs/TERMINOLOGY.md).

namespace reliefbake {

enum class Wrap { repeat, clamp };

/// Texels between half as high and twice as high as wide: as far as the proof of the far constraints reaches
/// (docs/SAFETY.md; SearchSurface::distance_deflation).
constexpr double least_pixel_aspect = 0.5, largest_pixel_aspect = 2;
inline bool is_baked_pixel_aspect(double aspect) {
    return aspect >= least_pixel_aspect && aspect <= largest_pixel_aspect;
}

/// The geometry of a map: size, addressing, and the isotropic metric in units of the texture's width.
/// Texel (i,j) has its centre at u = (i + 0.5) / width, v = (j + 0.5) / height; row 0 is the image's top row.
/// A *cell* (i,j) is the square between the centres of texels i, i+1 and j, j+1: one bilinear patch.
struct TexelGrid {
    int width = 1;
    int height = 1;
    Wrap wrap_x = Wrap::repeat;
    Wrap wrap_y = Wrap::repeat;
    double pixel_aspect = 1; ///< height of a texel divided by its width

    /// R of the metric |(du,dv)|^2 = du^2 + (R dv)^2.
    double aspect() const { return double(height) / double(width) * pixel_aspect; }
    /// Distance between texel centres, in texture widths.
    double pitch_x() const { return 1.0 / width; }
    double pitch_y() const { return pixel_aspect / width; }

    static double centre(int i, int count) { return (i + 0.5) / count; }

    /// The stored texel that index i stands for.
    static int address(int i, int count, Wrap wrap) {
        if (wrap == Wrap::clamp) return i < 0 ? 0 : i >= count ? count - 1 : i;
        int m = i % count;
        return m < 0 ? m + count : m;
    }
    int address_x(int i) const { return address(i, width, wrap_x); }
    int address_y(int j) const { return address(j, height, wrap_y); }

    friend bool operator==(const TexelGrid&, const TexelGrid&) = default;
};

} // namespace reliefbake
