#pragma once
#include "tests/physics/physics_scene.h"

/// Scenes of floors of flush tiles, over which things go as over one slab, and of gaps that are narrower than what
/// goes over them.
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

/// A crate of 0.4 m that slides without friction over a gap between two slabs.
struct GapSlide {
    Tiles tiles = Tiles::Bodies;  ///< Bodies, Shapes, or DynamicShapes: two bodies that lie on a floor
    double voxel = 0.1;           ///< of the slabs, metres
    double gap = 0.05, speed = 6.0;
    double beyond = 0.0001;  ///< metres by which the crate's front has passed the gap when a step begins
    double yaw = 0.0;        ///< of the crate
};
/// What the gap did.
struct GapRide {
    double highest = 0.0;  ///< metres that the crate rose
    double lost = 0.0;     ///< share of its speed
    double tilted = 0.0;   ///< radians
};
/// How the crate gets over the gap.
GapRide rideOverGap(const GapSlide& slide);

}  // namespace rubble::known
