#pragma once
#include "render/float_image.h"

namespace rubble::reference {

/// relMSE: the mean over pixels and channels of (test - reference)^2 / (reference^2 + 0.01) (Rousselle et al. 2011 and
/// after), of linear pictures. The share of the pixels (0.001) that are worst is left out: one bright speck would be
/// all it says.
double relativeError(const FloatImage& reference, const FloatImage& test, double droppedShare = 0.001);

}  // namespace rubble::reference
