#pragma once
#include "render/float_image.h"

namespace rubble::reference {

/// The paper's default: a display 0.7 m wide of 3840 pixels, seen from 0.7 m.
inline constexpr double kPixelsPerDegree = 67.0206;

/// FLIP for pictures of low dynamic range (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild: "FLIP: a
/// difference evaluator for alternating images", HPG 2020): for each pixel in x what a viewer who flips between the two
/// notices, 0 to 1. Both hold sRGB-coded rgb in [0, 1] and have one size.
FloatImage flipMap(const FloatImage& reference, const FloatImage& test, double pixelsPerDegree = kPixelsPerDegree);
/// Mean of the map.
double flip(const FloatImage& reference, const FloatImage& test, double pixelsPerDegree = kPixelsPerDegree);

}  // namespace rubble::reference
