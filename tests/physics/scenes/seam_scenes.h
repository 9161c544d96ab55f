#pragma once
#include "tests/physics/physics_scene.h"

/// Scenes of floors of flush tiles, over which things go as over one slab.
namespace rubble::known {

/// How the shapes of a floor are held.
enum class Tiles { Slab, Shapes, Bodies, TurnedBodies, DynamicShapes };
inline constexpr int kTile = 8, kTiles = 16;  ///< voxels of a tile, and tiles of the floor on a side

/// Adds a floor of 12.8 m from the origin along x and z, whose top is at y = 0. turn: of the floor about the origin.
void addTiledFloor(PhysicsScene& scene, Tiles tiles, uint8_t entry, const glm::dquat& turn);

/// What lies on the tiles.
struct Rider {
    VoxelGrid grid;
    double speed = 5.0, friction = 0.3, yaw = 0.0;  ///< m/s; radians from the way that it goes
    CollisionShape shape = CollisionShape::Voxels;  ///< what is round rolls
};
/// How it went.
struct Ride {
    double distance = 0.0, aside = 0.0, highest = 0.0;  ///< metres
    double turned = 0.0;                                ///< radians about the floor's normal
};

/// What lies on the tiles and goes along them, aslant by 0.2 radians, for 10 m at most. turn: of all.
Ride rideOver(Tiles tiles, const Rider& rider, const glm::dquat& turn);

}  // namespace rubble::known
