#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"

namespace rubble {

/// How two bodies hang together. The axis of a joint is the x axis of its ends' frames.
enum class JointKind : uint8_t {
    Ball,       ///< one point in common
    Hinge,      ///< one axis in common: they turn about it
    Prismatic,  ///< slides along the axis and does not turn
    Cone,       ///< one point in common, and the axes at most limits.high radians apart
    Fixed,      ///< as if one
    Rope,       ///< a chain of points between the ends
    Wheel,  ///< end 0: a chassis, end 1: a wheel. It travels along y of end 0's frame, up, and spins about its own x,
            ///< which points left: then spinning forward drives forward and steering by a positive angle turns left
};

/// What a joint is fixed to: a voxel of a shape, or the world. It goes with that voxel into whatever piece has it.
struct JointEnd {
    ShapeHandle shape;  ///< empty: the world
    Pose frame;         ///< in the shape's space, whose origin is the corner of its grid; metres
    glm::ivec3 cell{
        -1};  ///< of the voxel that holds it; negative: the nearest one is looked for when the joint is made
    double radius = 0.2;  ///< metres from the frame's origin within which that voxel must be
    bool isFree = false;  ///< of a rope: nothing holds this end
};

/// Of the free motion: a hinge's angle, at most pi either way, a prismatic joint's or a wheel's travel in metres; of a
/// ball or cone joint, `high` is the largest angle between the axes.
struct JointLimits {
    bool on = false;
    double low = 0.0, high = 0.0;
};

enum class MotorMode : uint8_t { Off, Speed, Position };

/// Drives the free motion: a hinge's or wheel's turning (radians), a prismatic joint's way (metres). A rope's motor is
/// a winch: it changes its length.
struct JointMotor {
    MotorMode mode = MotorMode::Off;
    double target = 0.0;    ///< rad/s or m/s; or radians or metres
    double maxForce = 0.0;  ///< N m or N that it has; a winch has any
};

/// Of a hinge, prismatic joint or wheel: pulls the free motion to 0. Of the others: lets what they hold give.
struct JointSpring {
    double hertz = 0.0;  ///< of what hangs on it; 0: rigid, or no spring where the motion is free
    double dampingRatio = 1.0;
};

/// What a wheel can do for the vehicle that it is on: see DriveEdit.
struct WheelSettings {
    double driveTorque = 0.0;  ///< N m; 0: it only rolls
    double topSpin = 60.0;     ///< rad/s, forward; backward half of it
    double brakeTorque = 0.0;  ///< N m
    double steerAngle = 0.0;   ///< radians either way; 0: it does not steer
    double steerRate = 2.0;    ///< rad/s at which it turns there
};

struct RopeSettings {
    double length = 0.0;                       ///< metres; 0: from end to end when it is made, and `slack` more
    double slack = 0.0;                        ///< metres
    uint32_t points = 0;                       ///< of the chain, ends included; 0: one every 0.4 m, at least 3
    double radius = 0.03;                      ///< metres
    double massPerMetre = 1.0;                 ///< kg
    double stretch = 0.0;                      ///< share of its length that it gives under 10 kN
    double strength = 0.0;                     ///< N at which it breaks; 0: never
    std::array<uint8_t, 3> color{60, 56, 52};  ///< sRGB
};

struct RopePoint {
    glm::dvec3 position{0.0};  ///< world, metres
    glm::dvec3 velocity{0.0};  ///< m/s
};

struct Joint {
    std::string name;
    JointKind kind = JointKind::Ball;
    std::array<JointEnd, 2> ends;
    bool collides = false;  ///< whether what it joins touches each other
    JointLimits limits;
    JointMotor motor;
    JointSpring spring;
    double friction = 0.0;  ///< N m, of a prismatic joint N, that holds against the free motion: a wheel's brake
    double maxForce = 0.0;  ///< N that it pulls with, and no more; 0: any
    double breakForce = 0.0, breakTorque = 0.0;  ///< N and N m over a step at which it breaks; 0: never
    double steer = 0.0;                          ///< of a wheel: radians about y
    WheelSettings wheel;
    uint32_t hand = 0;  ///< not 0: a grab, by hand - 1; see GrabEdit
    RopeSettings rope;
    std::vector<RopePoint> points;  ///< of a rope, from end 0 to end 1
};

/// Where a rope's points are, as physics hands them over.
struct RopeMotion {
    JointHandle rope;
    std::span<const RopePoint> points;
};

inline constexpr uint32_t kMaxRopePoints = 256;

enum class JointBreak : uint8_t { VoxelGone, Force, Removed, Cut };

/// What is wrong with the numbers of a joint; empty: nothing.
std::string jointError(const Joint& joint);
/// Of all but a rope's points.
uint64_t hashJoint(const Joint& joint, uint64_t seed);
uint64_t hashRopePoints(const Joint& joint, uint64_t seed);

}  // namespace rubble
