#pragma once
#include "render/float_image.h"

namespace rubble::reference {

/// The paper's default: a display 0.7 m wide of 3840 pixels, seen from 0.7 m.
inline constexpr double kPixelsPerDegree = 67.0206;

/// LDR-FLIP (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: a difference evaluator for
/// alternating images", HPG 2020): in x the difference that a viewer notices who flips between the two, 0 to 1. Colour
/// differences are taken in Hunt-adjusted CIELAB after filtering by contrast sensitivity, then raised by differences of
/// edges and points: map = color^(1 - feature). Both images hold sRGB colours in [0, 1] and have the same size.
FloatImage flipMap(const FloatImage& reference, const FloatImage& test, double pixelsPerDegree = kPixelsPerDegree);
/// Mean of flipMap().
double flip(const FloatImage& reference, const FloatImage& test, double pixelsPerDegree = kPixelsPerDegree);

}  // namespace rubble::reference
