#pragma once
#include "render/float_image.h"

namespace rubble::reference {

/// relMSE of linear images: the mean over pixels and channels of (test - reference)^2 / (reference^2 + 0.01) (Rousselle
/// et al. 2011). The share of the worst pixels `droppedShare` is left out, as one firefly would dominate the mean.
double relativeError(const FloatImage& reference, const FloatImage& test, double droppedShare = 0.001);

}  // namespace rubble::reference
