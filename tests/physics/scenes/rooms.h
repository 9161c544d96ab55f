#pragma once
#include <cstdint>

#include "tests/physics/physics_scene.h"

/// Bodies thrown into closed rooms: none may leave.
namespace rubble::known {

struct RoomShots {
    int thrown = 0;
    int outside = 0;  ///< whose centre of mass was ever outside the room's walls
};

struct RoomSettings {
    uint64_t seed = 1;
    int bodies = 40;       ///< that are in the room at the same time
    double fastest = 300;  ///< m/s
    int steps = 40;
    bool turns = true;  ///< gravity turns about the room
};

/// Throws random boxes, plates, rods and crosses of one to six voxels into a random closed room: a box, shaft, pipe,
/// stairs or wedge with walls of one to four voxels, made of one shape or of many, at a random pose.
RoomShots throwIntoRoom(const PhysicsSettings& settings, const RoomSettings& room);

}  // namespace rubble::known
