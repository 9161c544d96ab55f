#pragma once
#include <cstdint>

#include "runtime/core/parallel_for.h"

namespace rubble {

/// How bodies rotate. Never: they keep their angular velocity. Always: they keep their angular momentum, in every
/// substep. WhereNeeded: so do those that touch nothing, or are not round and spin faster than 0.3 rad/s; the others by
/// a mean over the step.
enum class RotationRule : uint8_t { Never, WhereNeeded, Always };

struct PhysicsSettings {
    int substeps = 6;                 ///< of a step, in which contacts are solved; they are found once a step
    int iterations = 1;               ///< over the contacts in each half of a substep
    double stepSeconds = 1.0 / 60.0;  ///< of a step; the frame loop relies on this value
    double contactHertz = 90.0;       ///< stiffness of contacts, at most a quarter of the rate of substeps
    double loadBearingRatio = 30.0;   ///< of masses above which a light body under a heavy one gets stiffer contacts
    int loadBearingPasses = 8;        ///< more over such contacts; 0: none is stiffer
    double torsionRadius = 2e-3;      ///< metres: the arm of a lone contact point's friction against spin; 0: none
    double contactMargin = 0.02;      ///< metres apart up to which bodies have contacts
    bool continuous = true;           ///< fast bodies are swept, so that they do not tunnel
    double sweepThreshold = 0.02;     ///< metres of motion in a step above which a body is swept
    RotationRule rotation = RotationRule::WhereNeeded;
    double sleepTime = 0.5;           ///< s of rest before a touching body falls asleep
    double sleepVelocity = 4e-3;      ///< m/s of its farthest point, mean over that time, below which it rests
    double sleepAcceleration = 1e-3;  ///< m/s2, the same: what sleeps would move by 9 cm in 10 s at most
    uint32_t wakesPerStep = 256;      ///< sleeping bodies that touch or a lost support wakes in a step; others follow
    uint32_t awakeBodies = 1500;      ///< awake bodies from which on only 8 a step wake so
    double impactThreshold = 50.0;    ///< N s below which an impact is not reported
    double impactSpeed = 0.5;         ///< closing speed, m/s, below which it counts as resting and is not reported
    ParallelFor parallelFor;          ///< none: one thread; results do not depend on it
};

/// Presets: settings to start from; each can be changed alone. Their limits are measured by the scenes of
/// tests/physics/scenes: towers of half-metre cubes that stand 30 s, awake and with sleep; and how many times as heavy
/// a cube may be as the one that it lies on and sinks by less than 1 cm. With all three, free rotation keeps angular
/// momentum and energy.
///
///     preset     tower awake   with sleep   mass ratio
///     fast                16           20          100
///     balanced            25           60        1,000
///     accurate            30           60        3,000
PhysicsSettings fastPhysics();
/// The default preset: see fastPhysics().
PhysicsSettings balancedPhysics();
/// The most accurate preset: see fastPhysics().
PhysicsSettings accuratePhysics();

}  // namespace rubble
