#pragma once
#include "samples/support/image.h"

namespace rubble {

/// How two images of one size differ.
struct Difference {
    Image image;       ///< the differences of each channel, times four
    double share = 0;  ///< of pixels that differ by more than 24 of 255 in a channel
    double mean = 0;   ///< mean difference of all channels, of 255
};
/// The images must have the same size.
Difference compare(const Image& actual, const Image& expected);

/// True if at most 0.5 % of the pixels differ clearly and the mean is at most 1. Compilers and GL versions round
/// differently, and a rounded ray may miss a corner.
bool looksAlike(const Difference& difference);

}  // namespace rubble
