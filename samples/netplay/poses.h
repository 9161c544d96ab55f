#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "samples/netplay/wire.h"

namespace netplay {

using Vec3 = std::array<double, 3>;  ///< x, y, z
using Quat = std::array<double, 4>;  ///< x, y, z, w

/// Where a body is after a step, by the number that the server has given it.
struct BodyPose {
    uint32_t id = 0;
    Vec3 position{};  ///< of its frame, metres, world
    Quat rotation{0.0, 0.0, 0.0, 1.0};
    bool isAsleep = false;
};

/// The most that writing a pose moves a position along an axis, metres.
inline constexpr double kPositionError = 1.0 / 1024.0;
/// The most bytes that a row of putPoses() takes where positions are within 256 m of the origin, about.
inline constexpr size_t kPoseBytes = 15;

/// Appends poses, sorted by id, each id once: the distance from the id before, the position in steps of 1/512 m, the
/// rotation as the three smaller components with ten bits each, and whether the body sleeps. About 12 bytes each.
void putPoses(BitWriter& out, const std::vector<BodyPose>& poses);
/// Reads them; none if it fails in the reader. limit: more are refused.
std::vector<BodyPose> getPoses(BitReader& in, size_t limit);

/// A position as above.
void putPosition(BitWriter& out, const Vec3& position);
/// Reads it. Fails if a component is not finite or beyond 1e9.
Vec3 getPosition(BitReader& in);

}  // namespace netplay
