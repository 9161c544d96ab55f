#pragma once
#include <array>
#include <cstdint>

namespace rubble {

/// What physics computes with; what is beyond is clamped to it, counted, and warned of once a kind. OPERATING_ENVELOPE.md
/// says how much of it holds how well.
namespace envelope {
inline constexpr double kFastest = 5e3;      ///< m/s
inline constexpr double kFastestSpin = 1e3;  ///< rad/s
inline constexpr double kLightest = 1e-9;    ///< kg
inline constexpr double kHeaviest = 1e12;    ///< kg
inline constexpr double kFarthest = 1e6;     ///< m from the middle of the level: beyond, broadphase's floats step by 6 cm
}  // namespace envelope

/// What can be beyond the envelope.
enum class Excess : uint8_t { Speed, Spin, Mass, Place, kCount };
using ExcessCounts = std::array<uint64_t, size_t(Excess::kCount)>;

}  // namespace rubble
