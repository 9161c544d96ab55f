#pragma once
#include "tests/physics/physics_scene.h"

/// Scenes of joints with known answers.
namespace rubble::known {

/// A frame whose x axis is the world's z, for hinges that swing in the plane of x and y.
Pose hingeAt(glm::dvec3 place);
/// Adds a joint between two bodies of a level at their poses; -1: the world.
LevelJoint& addJoint(Level& level, JointKind kind, int first, int second, const Pose& frame);

struct Pendulum {
    double period = 0.0;    ///< s, over at most ten swings
    double expected = 0.0;  ///< of a rigid body of that moment of inertia and amplitude
    double kept = 0.0;      ///< fraction of the amplitude after them
};
/// A bar of 1 m on a hinge at its upper end, released at an angle.
Pendulum swing(const PhysicsSettings& settings, double degrees);

/// A bar that swings on a hinge against a limit (radians): how far it went beyond at most, radians.
double hitLimit(const PhysicsSettings& settings, double limit);

struct Motor {
    double acceleration = 0.0, expected = 0.0;  ///< rad/s2, over the first half second
    double speed = 0.0;                         ///< rad/s, at the end
};
/// A bar rotated about its middle by a motor with a target of 5 rad/s and a torque of 20 N m.
Motor turn(const PhysicsSettings& settings);

/// How far from its target a position motor ends: metres or radians after 4 s. It lifts a beam of this length (metres),
/// which it holds at one end, by 1 m along a vertical axis, or turns it about a horizontal one by half a radian.
/// maxForce: N or N m; 0: no limit.
double missedBy(const PhysicsSettings& settings, JointKind kind, double length, double maxForce);

/// The period of a block on an undamped prismatic spring, s.
double springPeriod(const PhysicsSettings& settings, double hertz);

/// The part of its amplitude that a block on a prismatic spring keeps after five half swings from its start.
double springKeeps(const PhysicsSettings& settings, double hertz, double dampingRatio);

/// The force at which a fixed joint of this break force (N) breaks, as a fraction of it.
double breakFixed(const PhysicsSettings& settings, double force);

struct Chain {
    double apart = 0.0, worst = 0.0;  ///< metres between the ends of a joint, at the end and at most
};
/// A chain that is released horizontally and swings for a time.
Chain swingChain(const PhysicsSettings& settings, int links, double seconds);

/// A block that hangs from a chain of links, each `ratio` times as light: how far the joints are apart at rest, metres.
double hangHeavy(const PhysicsSettings& settings, int links, double ratio);

struct RopeSwing {
    double stretched = 0.0;               ///< path from end to end beyond the rope's length, at most, metres
    double longest = 0.0;                 ///< length of the chain of points beyond the rope's, at most, metres
    double period = 0.0, expected = 0.0;  ///< s
};
/// A block that swings on a rope of 5 m, `ratio` times as heavy as one of the rope's points.
RopeSwing swingOnRope(const PhysicsSettings& settings, double ratio);

struct Pulley {
    double risen = 0.0;  ///< metres by which the light block has risen in 1.5 s
    double sunk = 0.0;   ///< depth of the rope's points inside the beam, at most, metres
};
/// A rope over a beam with a block on each end, one four times as heavy.
Pulley hangOver(const PhysicsSettings& settings);

}  // namespace rubble::known
