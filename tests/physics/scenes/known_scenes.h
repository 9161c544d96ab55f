#pragma once
#include <functional>
#include <vector>

#include "tests/physics/physics_scene.h"

/// Scenes with known answers, each a function of the settings that returns how far off it came out (ACCURACY: P01 to
/// P22).
namespace rubble::known {

/// A material of this friction, restitution and density in the table of a scene; returns its palette entry.
uint8_t setMaterial(PhysicsScene& scene, uint8_t entry, float friction, float restitution, uint32_t density = 2000);

/// Settings under which nothing falls asleep.
PhysicsSettings sleepless(PhysicsSettings settings);

/// How the free rotation of a body kept what it must, as the largest relative departure from the start.
struct FreeSpin {
    double momentum = 0.0;   ///< of the length of L
    double direction = 0.0;  ///< of L, radians
    double energy = 0.0;
    std::vector<double> flips;        ///< times at which the spin about the middle axis changed its sign, s
    glm::dquat rotation{1, 0, 0, 0};  ///< of the principal axes, at the end
};
FreeSpin spinFreely(const PhysicsSettings& settings, VoxelGrid grid, glm::dvec3 angularVelocity, double seconds);
/// The T-handle of the space station, in voxels.
VoxelGrid tHandle();
/// The same of any distance to turn a body: `step` takes rotation and angular velocity (both in principal axes) 1/60 s
/// further.
using SpinStep = std::function<void(glm::dquat& rotation, glm::dvec3& angularVelocityInBody)>;
FreeSpin spinBy(const SpinStep& step, glm::dvec3 inertia, glm::dvec3 angularVelocityInBody, double seconds);
/// The same by Runge and Kutta's method in double, `substeps` of 1/60 s, of a body of these moments (principal axes).
SpinStep rungeKutta(glm::dvec3 inertia, int substeps);
FreeSpin spinReference(glm::dvec3 inertia, glm::dvec3 angularVelocityInBody, double seconds, int substeps);

/// A block on a plane of friction 0.6, tilted by `degrees`, its side turned by `heading` radians about the plane's
/// normal.
struct Slide {
    double distance = 0.0;      ///< metres within the last second of `seconds`
    double acceleration = 0.0;  ///< m/s2, over the second half
};
Slide slideDown(const PhysicsSettings& settings, double degrees, double heading, double friction, double seconds);

/// A tower of cubes of half a metre. Of the tower after `seconds`:
struct Tower {
    double lower = 0.0;    ///< how much lower its top is than if nothing gave distance, metres
    double aside = 0.0;    ///< farthest that any cube is from the axis, metres
    double fastest = 0.0;  ///< m/s
    int awake = 0;
    bool stands() const { return lower < 0.25 && aside < 0.25; }
};
Tower stack(const PhysicsSettings& settings, int cubes, double seconds);

/// How far a cube sinks into one that is `ratio` times as light and lies under it, in 10 s, metres.
double sink(const PhysicsSettings& settings, double ratio);

/// Fastest movement of bodies of `size` voxels of `voxelSize` metres that have lain for 6 s, over a further second,
/// m/s.
double unrest(const PhysicsSettings& settings, double voxelSize, glm::ivec3 size, double gravity = 9.81);

/// Shots of random cubes of one to four voxels at a wall of `thickness` voxels; returns how many went through.
struct Shots {
    int fired = 0, through = 0;
};
Shots shoot(const PhysicsSettings& settings, int count, uint64_t seed, double fastest, double slowest = 1.0,
            int thickness = 1);
/// The same two at a time, aimed to meet at the wall at one moment, from other sides and at other speeds: how many
/// pairs sent one of them through. late: the most, in seconds, that the second comes later.
Shots shootPairs(const PhysicsSettings& settings, int count, uint64_t seed, double fastest, double late = 0.002);

/// A block without friction that slides over `voxels` cells at 5 m/s; shapes: into how many flush shapes the floor is
/// cut.
struct SeamRide {
    double lost = 0.0;     ///< share of its speed
    double highest = 0.0;  ///< metres above where it lay
    double aside = 0.0;    ///< metres
};
SeamRide rideOverSeams(const PhysicsSettings& settings, int voxels, int shapes);

/// Two cubes that meet head on at 4 m/s, one twice as heavy.
struct Collision {
    double momentum = 0.0;     ///< that was lost or gained, as a share
    double restitution = 0.0;  ///< speed apart by speed together
};
Collision collide(const PhysicsSettings& settings, double restitution);

/// Cubes of half a metre, count^3 of them, dropped into a box of walls.
struct Container {
    double meanOverlap = 0.0, worstOverlap = 0.0;  ///< metres, measured from the voxels
    double fastest = 0.0;                          ///< m/s, at the end
    bool allInside = true;
};
Container fillContainer(const PhysicsSettings& settings, int count, double seconds);

/// Two cubes that start with `share` of them in each other: the fastest that they get, and how deep they still are
/// after 3 s.
struct Recovery {
    double fastest = 0.0, overlap = 0.0;
};
Recovery partOverlapping(const PhysicsSettings& settings, double share);

/// A floor at `middle` (body 0), and pieces that fall, slide and tumble; where their centres are after 4 s, from
/// `middle`.
Level tumblingLevel(glm::dvec3 middle);
std::vector<glm::dvec3> tumble(const PhysicsSettings& settings, glm::dvec3 middle);

}  // namespace rubble::known
