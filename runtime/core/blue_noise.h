#pragma once
#include <cstdint>
#include <vector>

namespace rubble {

inline constexpr int kBlueNoiseSize = 64;  ///< of the renderer's tile

/// A tile of size x size thresholds (a power of two, 16 at least), each of 0..255 equally often, made by
/// void-and-cluster (Ulichney 1993). In integers: the same everywhere. The time goes with size^4: 2 ms for 32, 40 ms
/// for 64.
std::vector<uint8_t> makeBlueNoise(int size = kBlueNoiseSize);

}  // namespace rubble
