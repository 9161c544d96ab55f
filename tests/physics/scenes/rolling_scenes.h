#pragma once
#include "tests/physics/physics_scene.h"

/// Scenes of what rolls, with known answers.
namespace rubble::known {

/// A disc of voxels about z: `across` cells wide, `wide` cells long.
VoxelGrid disc(int across, int wide, uint8_t entry);
/// The radius of the smallest cylinder around the voxels of disc(), metres.
double rollingRadius(int across, double voxel);
/// A disc of voxels that rolls along x on a road, body 1; its middle is at x = 0. slope: degrees, downward along x.
void addRollingDisc(PhysicsScene& scene, int across, double speed, double slope = 0.0);

/// A car of a box on four wheels that drives along x.
struct Car {
    double drive = 0.0, drag = 0.0, brake = 0.0;  ///< torque of each wheel, N m
    double steer = 0.0;                           ///< of the front wheels, radians
    double speed = 0.0;                           ///< at the start, m/s
    double slope = 0.0;                           ///< degrees, downward along x
    uint32_t density = 400;                       ///< of the body, kg/m3
    int split = 0;                                ///< voxels from the ground's side at which it is two shapes; 0: one
};
inline constexpr double kWheelBase = 2.6, kGroundSide = 2.95;  ///< metres
inline constexpr int kAcross = 16;                             ///< of a wheel: voxels of half the usual size

/// Adds a car (body 1, then its wheels) and its ground, and loads the scene.
void addCar(PhysicsScene& scene, const Car& car);
/// Mass, and that with the wheels' inertia, kg.
struct CarMass {
    double mass = 0.0, effective = 0.0;
};
/// Of the car of addCar().
CarMass massOf(const PhysicsScene& scene);
/// The mean acceleration of a car along its way after the first half second, m/s2.
double acceleration(const Car& car, double seconds);

}  // namespace rubble::known
