#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace rubble {

/// What physics computes with. Speeds, spins and masses beyond are clamped; what goes farther than kMaxDistance is
/// frozen there. Each is counted, and warned of once a kind. OPERATING_ENVELOPE.md says how much of it holds how well.
namespace limits {
inline constexpr double kMaxSpeed = 5e3;         ///< m/s
inline constexpr double kMaxAngularSpeed = 1e3;  ///< rad/s
inline constexpr double kMinMass = 1e-9;         ///< kg
inline constexpr double kMaxMass = 1e12;         ///< kg
inline constexpr double kMaxDistance =
    1e6;  ///< m from the middle of the level: beyond, broadphase's toFloat4 step by 6 cm
inline constexpr double kInvalidSpeed =
    1e9;  ///< m/s and rad/s: no value but an error; like NaN, it freezes its body where it is
}  // namespace limits

/// What can be beyond the envelope.
enum class LimitKind : uint8_t { Speed, Spin, Mass, Distance, kCount };
/// How often each was.
using LimitCounts = std::array<uint64_t, size_t(LimitKind::kCount)>;

}  // namespace rubble
