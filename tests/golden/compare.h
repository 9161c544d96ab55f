#pragma once
#include "samples/support/image.h"

namespace rubble {

/// How two pictures of one size differ.
struct Difference {
    Image image;       ///< four times as strong as it is
    double share = 0;  ///< of pixels that differ clearly: by more than 24 of 255
    double mean = 0;   ///< of all channels, of 255
};
Difference compare(const Image& actual, const Image& expected);

/// Compilers and GL versions round differently, and a rounded ray may miss a corner: a few pixels may differ, all
/// together may not.
bool looksAlike(const Difference& difference);

}  // namespace rubble
