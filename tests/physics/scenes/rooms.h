#pragma once
#include <cstdint>

#include "tests/physics/physics_scene.h"

/// Bodies thrown into closed rooms: none may leave.
namespace rubble::known {

struct RoomShots {
    int thrown = 0;
    int outside = 0;  ///< whose centre of mass was ever outside the room's walls
};

/// Throws random boxes, plates, rods and crosses of one to six voxels into a random closed room: a box, shaft, pipe,
/// stairs or wedge with walls of one to four voxels, made of one shape or of many, at a random pose. They fly at 1 to
/// 300 m/s, and gravity turns about the room.
RoomShots throwIntoRoom(const PhysicsSettings& settings, uint64_t seed);

}  // namespace rubble::known
