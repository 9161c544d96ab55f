#pragma once
#include "render/float_image.h"
#include "samples/support/image.h"

namespace rubble::reference {

/// Linear radiance tone-mapped as in shaders/passes/tonemap.frag, as sRGB in [0, 1], for comparisons: without bloom,
/// sharpening, vignette and dither.
FloatImage displayed(const FloatImage& radiance, float exposure);
/// The exposure that shaders/passes/exposure.frag converges to for a still image. ofLevel: the level's own exposure.
float exposureFor(const FloatImage& radiance, float ofLevel);
/// sRGB in [0, 1] as 8 bits, rows from the top.
Image toImage(const FloatImage& srgb);

}  // namespace rubble::reference
