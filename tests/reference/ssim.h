#pragma once
#include "render/float_image.h"

namespace rubble::reference {

/// Structural similarity of the luma of two sRGB-coded pictures in [0, 1] (Wang, Bovik, Sheikh, Simoncelli 2004):
/// Gaussian window of deviation 1.5 and 11 x 11 pixels, K1 = 0.01, K2 = 0.03; the mean over all windows that lie
/// inside. 1 = equal.
double ssim(const FloatImage& reference, const FloatImage& test);

}  // namespace rubble::reference
