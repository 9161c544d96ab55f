#pragma once
#include <utility>
#include <vector>

#include "tests/physics/physics_scene.h"

/// Scenes of impacts with known answers. Nothing in them sleeps or falls.
namespace rubble::known {

/// A crate that flies down a closed shaft of one shape, along its walls.
struct ShaftShot {
    int size = 1;         ///< of the crate, voxels
    bool isSnug = false;  ///< touches four walls, not two
    int end = 1;          ///< thickness of the shaft's end, voxels
    double speed = 1;     ///< m/s
};
/// Whether the crate stays inside.
bool staysInShaft(const PhysicsSettings& settings, const ShaftShot& shot);

/// What a plank did that fell flat on a ledge.
struct LedgeHit {
    double spin = 0.0, speed = 0.0;                  ///< rad/s, m/s downward
    double expectedSpin = 0.0, expectedSpeed = 0.0;  ///< of a rigid body that only the ledge's edge pushes
};
/// A plank of 2 m falls flat at `speed` m/s with a share of its length (0 to 0.5) on a ledge. Its spin is then
/// v d / (I / m + d^2), with d from the centre to the edge.
LedgeHit landOnLedge(const PhysicsSettings& settings, double speed, double share = 0.2);

/// Speeds of a plate that hit the floor at 4 m/s and slid along it at 8 m/s.
struct ObliqueBounce {
    double up = 0.0, expectedUp = 0.0;      ///< m/s, after the hit
    double lost = 0.0, expectedLost = 0.0;  ///< m/s along the floor: mu (1 + e) v_n
};
/// A plate without spin that hits the floor aslant.
ObliqueBounce bounceAslant(const PhysicsSettings& settings, double friction, double restitution);

constexpr int kCradleBodies = 5;
/// A row of bodies that touch, along x, without friction; the first `incoming` come in a little later.
void addCradle(PhysicsScene& scene, bool areBalls, int incoming, double speed, float restitution = 1.0f);
/// The largest error of a speed after an elastic row was hit, as a share of the incoming speed: as many leave as came.
double cradleError(const PhysicsSettings& settings, bool areBalls, int incoming, double speed);
/// A ball of voxels.
VoxelGrid ball(int across, uint8_t entry);

/// A blade of 8 m that spins about the world's y axis, and a post that it meets.
struct Blade {
    double spin;      ///< rad/s
    double at;        ///< metres from the axis to the post
    double angle;     ///< radians from the blade to the post
    int thickness;    ///< of the blade, voxels
    int post;         ///< its side, voxels
    bool isHinged;    ///< to the world
    bool isAtItsEnd;  ///< the axis; else in the middle
    bool hasMotor;    ///< that turns it on
    bool isPostStatic;
};
struct BladeHit {
    bool isHit = false;
    bool passed = false;  ///< the post has been on both sides of the blade
    double energy = 0.0;  ///< after the hit, as a share of that before
};
/// Spins until the blade has hit the post, or for a whole turn.
BladeHit spinBlade(const PhysicsSettings& settings, const Blade& blade);

/// Angular momentum that a body of one layer loses to the floor on which it spins flat, in 0.6 of the time to rest.
struct SpinDown {
    double lost = 0.0, expected = 0.0;  ///< rad/s; expected: mu m g r / I for the mean distance r of its lowest layer
};
/// grid: of entry 7, with friction 0.4. spin: rad/s.
SpinDown spinDown(const PhysicsSettings& settings, const VoxelGrid& grid, double spin);
/// Discs, rings, plates, bars and tables by name, for spinDown().
std::vector<std::pair<const char*, VoxelGrid>> spinDownGrids();

}  // namespace rubble::known
