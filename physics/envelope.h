#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace rubble {

/// What physics computes with. Speeds, spins and masses beyond are clamped; what goes farther than kFarthest is frozen there.
/// Each is counted, and warned of once a kind. OPERATING_ENVELOPE.md says how much of it holds how well.
namespace envelope {
inline constexpr double kFastest = 5e3;      ///< m/s
inline constexpr double kFastestSpin = 1e3;  ///< rad/s
inline constexpr double kLightest = 1e-9;    ///< kg
inline constexpr double kHeaviest = 1e12;    ///< kg
inline constexpr double kFarthest = 1e6;     ///< m from the middle of the level: beyond, broadphase's floats step by 6 cm
inline constexpr double kAbsurd = 1e9;       ///< m/s and rad/s: no value but an error; like NaN, it freezes its body where it is
}  // namespace envelope

/// What can be beyond the envelope.
enum class Excess : uint8_t { Speed, Spin, Mass, Place, kCount };
/// How often each was.
using ExcessCounts = std::array<uint64_t, size_t(Excess::kCount)>;

}  // namespace rubble
