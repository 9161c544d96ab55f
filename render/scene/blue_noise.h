#pragma once
#include <cstdint>
#include <vector>

namespace rubble {

inline constexpr int kBlueNoiseSize = 64;

/// A tile of 64x64 thresholds, each of 0..255 equally often, made by void-and-cluster (Ulichney 1993). The same every time.
std::vector<uint8_t> makeBlueNoise();

}  // namespace rubble
