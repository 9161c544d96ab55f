#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "runtime/core/handle.h"
#include "runtime/core/pose.h"
#include "runtime/core/ranges.h"

namespace rubble {

/// What motion a joint leaves free. Its axis is the x axis of its ends' frames.
enum class JointKind : uint8_t {
    Ball,       ///< rotates about a common point
    Hinge,      ///< rotates about the common axis
    Prismatic,  ///< slides along the axis
    Cone,       ///< a ball joint whose axes stay within limits.high radians of each other
    Fixed,      ///< none
    Rope,       ///< a chain of points between the ends
    Wheel,  ///< end 0: the chassis, end 1: the wheel. It travels up and down along y of end 0's frame and spins about
            ///< its own x, which points left: positive spin drives forward, a positive steering angle turns left
};

/// What a joint is fixed to: a voxel of a shape, or the world. It follows that voxel into whatever piece gets it.
struct JointEnd {
    ShapeHandle shape;    ///< empty: the world
    Pose frame;           ///< in the shape's space, whose origin is the corner of its grid; metres
    glm::ivec3 cell{-1};  ///< of the voxel that holds it; negative: the nearest one, when the joint is made
    double radius = 0.2;  ///< metres from the frame's origin within which that voxel must be
    bool isFree = false;  ///< of a rope: nothing holds this end, it hangs free
};

/// Limits of the free motion: a hinge's angle, within -pi and pi radians; a prismatic joint's or a wheel's travel in
/// metres; of a ball or cone joint, `high` is the largest angle between the axes.
struct JointLimits {
    bool on = false;
    double low = 0.0, high = 0.0;
};

enum class MotorMode : uint8_t { Off, Speed, Position };

/// Drives the free motion: a hinge's or wheel's angle (radians), a prismatic joint's displacement (metres). A rope's
/// motor is a winch: it changes the rope's length.
struct JointMotor {
    MotorMode mode = MotorMode::Off;
    double target = 0.0;    ///< of a speed motor: rad/s or m/s; of a position motor: radians or metres
    double maxForce = 0.0;  ///< N m or N; a winch has no limit
};

/// A damped spring. On a hinge, prismatic joint or wheel it pulls the free motion to 0; it makes the other kinds soft.
struct JointSpring {
    double hertz = 0.0;  ///< natural frequency; 0: rigid, or no spring where the motion is free
    double dampingRatio = 1.0;
};

/// What a wheel can do for its vehicle: see DriveEdit.
struct WheelSettings {
    double driveTorque = 0.0;  ///< N m; 0: it only rolls
    double maxSpin = 60.0;     ///< rad/s at full throttle forward; backward half of it
    double brakeTorque = 0.0;  ///< N m
    double steerAngle = 0.0;   ///< radians either way; 0: it does not steer
    double steerRate = 2.0;    ///< rad/s
};

/// A rope: a chain of points with distance constraints.
struct RopeSettings {
    double length = 0.0;                       ///< metres; 0: the distance of the ends when it is made, plus `slack`
    double slack = 0.0;                        ///< metres
    uint32_t points = 0;                       ///< ends included; 0: one every 0.4 m, at least 9
    double radius = 0.03;                      ///< metres
    double massPerMetre = 1.0;                 ///< kg
    double stretch = 0.0;                      ///< share of its length by which 10 kN stretch it
    double strength = 0.0;                     ///< N at which it breaks; 0: never
    std::array<uint8_t, 3> color{60, 56, 52};  ///< sRGB
};

struct RopePoint {
    glm::dvec3 position{0.0};  ///< world, metres
    glm::dvec3 velocity{0.0};  ///< m/s
};

/// A constraint between two shapes, or a shape and the world.
struct Joint {
    std::string name;
    JointKind kind = JointKind::Ball;
    std::array<JointEnd, 2> ends;
    bool collides = false;  ///< whether the joined bodies collide with each other
    JointLimits limits;
    JointMotor motor;
    JointSpring spring;
    double friction = 0.0;   ///< N m, of a prismatic joint N, against the free motion; of a wheel: its brake
    double maxForce = 0.0;   ///< N that it pulls with at most; 0: no limit
    double maxTorque = 0.0;  ///< N m that a fixed joint turns with at most; 0: no limit
    double breakForce = 0.0, breakTorque = 0.0;  ///< N and N m, mean of a step, at which it breaks; 0: never
    double steer = 0.0;                          ///< of a wheel: radians about y
    double steerTarget = 0.0;                    ///< to which it turns by its steerRate; at first where it is
    WheelSettings wheel;
    uint32_t hand = 0;                ///< not 0: a grab, by hand - 1; see GrabEdit
    bool drives = false;              ///< a grab that holds velocities, not places
    glm::dvec3 velocity{0.0};         ///< of its first end, m/s, world
    glm::dvec3 angularVelocity{0.0};  ///< rad/s, world axes; of a fixed one
    RopeSettings rope;
    std::vector<RopePoint> points;  ///< of a rope, from end 0 to end 1
};

/// Where a rope's points are, as physics hands them over.
struct RopeMotion {
    JointHandle rope;
    std::span<const RopePoint> points;
};

inline constexpr uint32_t kMaxRopePoints = uint32_t(ranges::kRopePoints.high);

/// Why a joint is gone.
enum class JointBreak : uint8_t { VoxelGone, Force, Removed, Cut };

/// Says what is wrong with the numbers of a joint; empty: nothing. Handles are not checked.
std::string jointError(const Joint& joint);
/// The same of a motor on a joint of a kind, as far as the kind matters.
std::string jointMotorError(JointKind kind, const JointMotor& motor);
/// Says what is wrong with what the ends of a joint are on; empty: nothing. Whether their shapes exist is not checked.
std::string jointEndsError(const Joint& joint);
/// Chains all of a joint but a rope's points into a hash.
uint64_t hashJoint(const Joint& joint, uint64_t seed);
/// Chains the positions and velocities of a rope's points into a hash; other joints leave it as it is.
uint64_t hashRopePoints(const Joint& joint, uint64_t seed);

}  // namespace rubble
