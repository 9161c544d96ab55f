#pragma once
#include "tests/physics/physics_scene.h"

/// Scenes of joints with known answers (ACCURACY: P07).
namespace rubble::known {

/// A bar of 1 m on a hinge at its upper end, let go at an angle.
struct Pendulum {
    double period = 0.0;    ///< s, over ten swings to and fro or fewer
    double expected = 0.0;  ///< of a rigid body of that moment of inertia and amplitude
    double kept = 0.0;      ///< share of the amplitude after them
};
Pendulum swing(const PhysicsSettings& settings, double degrees);

/// A bar that swings on a hinge against a limit: how far beyond it was at most, radians.
double hitLimit(const PhysicsSettings& settings, double limit);

/// A bar turned about its middle by a motor that is to reach 5 rad/s with 20 N m.
struct Motor {
    double acceleration = 0.0, expected = 0.0;  ///< rad/s2, over the first half second
    double speed = 0.0;                         ///< at the end
};
Motor turn(const PhysicsSettings& settings);

/// A block on a prismatic spring without damping, s.
double springPeriod(const PhysicsSettings& settings, double hertz);

/// The force at which a fixed joint broke that bears any less, as a share of what it was to bear.
double breakFixed(const PhysicsSettings& settings, double force);

/// A chain of links, let go level; the farthest that the ends of a joint are apart after some seconds, and within them,
/// metres.
struct Chain {
    double apart = 0.0, worst = 0.0;
};
Chain swingChain(const PhysicsSettings& settings, int links, double seconds);

/// A block that hangs from a link `ratio` times as light: how far the joints are apart at rest, metres.
double hangHeavy(const PhysicsSettings& settings, int links, double ratio);

/// A block that swings on a rope of 5 m, `ratio` times as heavy as one of its points: how much longer than that the way
/// from end to end was at most, metres; and the period of its swing.
struct RopeSwing {
    double stretched = 0.0;
    double longest = 0.0;  ///< of the chain of points, beyond its length, metres
    double period = 0.0, expected = 0.0;
};
RopeSwing swingOnRope(const PhysicsSettings& settings, double ratio);

/// A rope over a beam with a block on each end, one four times as heavy: how far the light one has risen in 1.5 s, and
/// how far the rope's points are inside the beam at most, metres.
struct Pulley {
    double risen = 0.0, sunk = 0.0;
};
Pulley hangOver(const PhysicsSettings& settings);

}  // namespace rubble::known
