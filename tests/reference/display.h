#pragma once
#include "render/float_image.h"
#include "samples/support/image.h"

namespace rubble::reference {

/// Linear radiance as shaders/passes/tonemap.frag shows it at this exposure, sRGB-coded in [0, 1], without bloom,
/// sharpening, vignette and dither: what pictures are compared in.
FloatImage displayed(const FloatImage& radiance, float exposure);
/// The exposure that shaders/passes/exposure.frag comes to for a picture that stands still.
float exposureFor(const FloatImage& radiance, float ofLevel);
/// In 8 bits, rows from the top.
Image toImage(const FloatImage& srgb);

}  // namespace rubble::reference
