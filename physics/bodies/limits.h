#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace rubble {

/// The numbers that physics computes with. Speeds, spins and masses beyond are clamped, however large; a body that gets
/// farther than kMaxDistance is frozen there. Each clamp is counted, and the first of a kind is warned of.
/// OPERATING_ENVELOPE.md reports how accurate the simulation is within these limits.
namespace limits {
inline constexpr double kMaxSpeed = 5e3;         ///< m/s
inline constexpr double kMaxAngularSpeed = 1e3;  ///< rad/s
inline constexpr double kMinMass = 1e-9;         ///< kg
inline constexpr double kMaxMass = 1e12;         ///< kg
inline constexpr double kMaxDistance = 1e6;      ///< m from the level's middle, where floats are 6 cm apart
}  // namespace limits

/// What can exceed a limit.
enum class LimitKind : uint8_t { Speed, Spin, Mass, Distance, kCount };
/// How often each did.
using LimitCounts = std::array<uint64_t, size_t(LimitKind::kCount)>;

}  // namespace rubble
