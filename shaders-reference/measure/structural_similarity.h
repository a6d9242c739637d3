#pragma once
// How alike two pictures look (Wang, Bovik, Sheikh and Simoncelli 2004, "Image quality assessment: from error visibility to structural
// similarity"). FLIP is not in Debian 12; the compare_Yee of its OpenImageIO 2.4 answers 0 for black and white squares on grey.

#include "shaders-reference/renderer/rendering.h"

namespace reliefbake {

/// Mean structural similarity (SSIM) of the luma (Rec. 709 weights on the sRGB codes) of two pictures of the same size: 1 for equal ones, symmetric.
/// A window of 11 x 11 with Gaussian weights of 1.5 pixels, cut off at the borders; K1 = 0.01, K2 = 0.03, L = 255.
double structural_similarity(const RgbImage& a, const RgbImage& b);

} // namespace reliefbake
