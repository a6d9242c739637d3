#pragma once
// Where each encoding stops being useful: what its codes leave of cones that get narrower and narrower.

#include "bake/cone.h"

#include <vector>

namespace reliefbake {

struct Usefulness {
    int width = 0;         ///< texels across white noise of full height: the wider, the narrower its cones
    ConeEncoding encoding = ConeEncoding::sqrt;
    BitDepth bits = BitDepth::unorm8;
    double ratio = 0;      ///< mean cone before encoding, texture widths per unit of height
    double dead = 0;       ///< share of texels whose code is 0 (StressResult::dead)
    double kept = 0;       ///< mean over texels of the decoded cone over the one before encoding

    double slope() const { return 1 / ratio; }
    bool is_useful() const { return kept >= least_kept && dead <= most_dead; }

    /// A march takes up to 1 / kept times the steps; a dead texel stops it at every cell.
    static constexpr double least_kept = 0.75, most_dead = 0.001;
};

/// Strips of white noise 16 texels high, repeated, of widths 16, 32, ... up to `widest`, in every encoding and bit depth.
std::vector<Usefulness> measure_usefulness(int widest, int threads);

/// The greatest slope up to which an encoding and bit depth are useful at every slope measured; 0: at none.
double useful_slope(const std::vector<Usefulness>& measured, ConeEncoding encoding, BitDepth bits);

} // namespace reliefbake
