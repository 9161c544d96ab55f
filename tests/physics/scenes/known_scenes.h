#pragma once
#include <functional>
#include <vector>

#include "tests/physics/physics_scene.h"

/// Scenes with known answers. Each is a function of the settings that returns how far off the simulation is.
namespace rubble::known {

/// Adds a material to a scene's table under a palette entry, which it returns. density: kg/m3.
uint8_t setMaterial(PhysicsScene& scene, uint8_t entry, float friction, float restitution, uint32_t density = 2000);

/// The settings with sleep switched off.
PhysicsSettings sleepless(PhysicsSettings settings);

/// Conservation in free rotation: the largest relative departures from the start.
struct FreeSpin {
    double momentum = 0.0;   ///< of the length of the angular momentum L
    double direction = 0.0;  ///< of L, radians
    double energy = 0.0;
    std::vector<double> flips;        ///< times at which the spin about the middle axis changed its sign, s
    glm::dquat rotation{1, 0, 0, 0};  ///< of the principal axes, at the end
};
/// A body of voxels that rotates without gravity, simulated by physics.
FreeSpin spinFreely(const PhysicsSettings& settings, VoxelGrid grid, glm::dvec3 angularVelocity, double seconds);
/// A T-handle in voxels: it flips about its middle axis (Dzhanibekov).
VoxelGrid tHandle();
/// A method that rotates a body through 1/60 s; rotation and angular velocity are in principal axes.
using SpinStep = std::function<void(glm::dquat& rotation, glm::dvec3& angularVelocityInBody)>;
/// spinFreely() by any method. inertia: principal moments.
FreeSpin spinBy(const SpinStep& step, glm::dvec3 inertia, glm::dvec3 angularVelocityInBody, double seconds);
/// The classical Runge-Kutta method in double, with substeps of 1/60 s.
SpinStep rungeKutta(glm::dvec3 inertia, int substeps);
/// spinBy() with rungeKutta().
FreeSpin spinReference(glm::dvec3 inertia, glm::dvec3 angularVelocityInBody, double seconds, int substeps);

struct Slide {
    double distance = 0.0;      ///< metres in the last second
    double acceleration = 0.0;  ///< m/s2, over the second half
};
/// A block on a tilted plane; its side is rotated by `heading` radians about the plane's normal.
Slide slideDown(const PhysicsSettings& settings, double degrees, double heading, double friction, double seconds);

struct Tower {
    double lower = 0.0;    ///< metres by which the top is lower than that of rigid cubes
    double aside = 0.0;    ///< largest distance of a cube from the axis, metres
    double fastest = 0.0;  ///< m/s
    int awake = 0;         ///< cubes
    /// Whether it has not fallen.
    bool stands() const { return lower < 0.25 && aside < 0.25; }
};
/// A tower of cubes of half a metre, after a time.
Tower stack(const PhysicsSettings& settings, int cubes, double seconds);
/// How far a cube of a stack is from its place after 10 s, at most, in voxels. Each has 4x4x4 voxels of `voxelSize`
/// metres; they may sleep.
double farthestInStack(const PhysicsSettings& settings, double voxelSize, int cubes);

/// How far a cube sinks in 10 s into one under it that is `ratio` times as light, metres.
double sink(const PhysicsSettings& settings, double ratio);

/// The largest speed, over one second, of bodies of `size` voxels of `voxelSize` metres that have lain for 6 s, m/s.
double unrest(const PhysicsSettings& settings, double voxelSize, glm::ivec3 size, double gravity = 9.81);

struct Shots {
    int fired = 0, through = 0;
};
/// Shots of random cubes of one to four voxels, from `slowest` to `fastest` m/s, at a wall of `thickness` voxels:
/// how many tunnel.
Shots shoot(const PhysicsSettings& settings, int count, uint64_t seed, double fastest, double slowest = 1.0,
            int thickness = 1);
/// The same for pairs, aimed to meet at the wall from different sides and at different speeds: how many pairs sent one
/// through. late: seconds by which the second comes later, at most.
Shots shootPairs(const PhysicsSettings& settings, int count, uint64_t seed, double fastest, double late = 0.002);

struct SeamRide {
    double lost = 0.0;     ///< fraction of the speed
    double highest = 0.0;  ///< metres above the start
    double aside = 0.0;    ///< metres
};
/// A block without friction that slides over `voxels` cells at 5 m/s; the floor is cut into this many flush shapes.
SeamRide rideOverSeams(const PhysicsSettings& settings, int voxels, int shapes);

struct Collision {
    double momentum = 0.0;     ///< lost or gained, as a fraction
    double restitution = 0.0;  ///< relative speed after the hit divided by that before
};
/// Two cubes that meet head on at 4 m/s, one twice as heavy.
Collision collide(const PhysicsSettings& settings, double restitution);

struct Container {
    double meanOverlap = 0.0, worstOverlap = 0.0;  ///< metres, measured from the voxels
    double fastest = 0.0;                          ///< m/s, at the end
    bool allInside = true;
};
/// count^3 cubes of half a metre, dropped into a box of walls.
Container fillContainer(const PhysicsSettings& settings, int count, double seconds);

struct Recovery {
    double fastest = 0.0;  ///< m/s
    double overlap = 0.0;  ///< after 3 s, metres
};
/// Two cubes that start with a fraction of their size inside each other.
Recovery partOverlapping(const PhysicsSettings& settings, double share);

/// A floor at `middle` (body 0), and pieces that fall, slide and tumble.
Level tumblingLevel(glm::dvec3 middle);
/// The centres of the pieces of tumblingLevel() after 4 s, relative to `middle`.
std::vector<glm::dvec3> tumble(const PhysicsSettings& settings, glm::dvec3 middle);

}  // namespace rubble::known
