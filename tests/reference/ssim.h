#pragma once
#include "render/float_image.h"

namespace rubble::reference {

/// Structural similarity of the luma of two sRGB images in [0, 1] (Wang, Bovik, Sheikh, Simoncelli 2004, eq. 13):
/// Gaussian windows of 11 x 11 pixels with deviation 1.5, K1 = 0.01, K2 = 0.03; the mean over all windows inside the
/// image. 1 means equal.
double ssim(const FloatImage& reference, const FloatImage& test);

}  // namespace rubble::reference
