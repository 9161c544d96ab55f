#pragma once
#include <cstdint>

#include "tests/physics/physics_scene.h"

/// Bodies thrown into closed rooms: none may leave.
namespace rubble::known {

struct RoomShots {
    int thrown = 0;
    int outside = 0;  ///< whose centre of mass was ever outside the room's walls
};

/// Free: a body that flies and spins itself, and is hit by what is in it.
enum class RoomBody { Fixed, Free };

/// Throws random boxes, plates, rods and crosses of one to six voxels into a random closed room: a box, shaft, pipe,
/// stairs or wedge with walls of one to four voxels, made of one shape or of many, at a random pose. They fly at 1 to
/// 300 m/s, and gravity turns about the room; a free one itself moves at up to 10 m/s and 3 rad/s, in all without
/// gravity.
RoomShots throwIntoRoom(const PhysicsSettings& settings, uint64_t seed, RoomBody body = RoomBody::Fixed);

}  // namespace rubble::known
