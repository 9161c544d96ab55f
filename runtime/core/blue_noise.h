#pragma once
#include <cstdint>
#include <vector>

namespace rubble {

inline constexpr int kBlueNoiseSize = 64;  ///< side of the renderer's tile, texels

/// A tile of size x size thresholds, row by row, in which each value 0..255 occurs equally often: void-and-cluster
/// (Ulichney 1993). `size`: a power of two, at least 16. In integers, so the same everywhere. The time grows with
/// size^4: 2 ms for 32, 40 ms for 64.
std::vector<uint8_t> makeBlueNoise(int size = kBlueNoiseSize);

}  // namespace rubble
