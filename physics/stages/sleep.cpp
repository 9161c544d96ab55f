#include "physics/stages/sleep.h"

#include <algorithm>

// When a body sleeps, and when it wakes.
//
// A body falls asleep when it has stayed within a small displacement of one pose for sleepTime seconds while touching
// something (or in water, or jointed, or without gravity). Poses are compared, not velocities as is usual: contacts of
// many voxels jitter, and the velocity of a body that goes nowhere may be large. The allowed displacement is
// sleepVelocity * sleepTime; it grows with the seconds for which the body has been slow ("patience"), up to four times,
// and so does a slight damping: a pile that settles ever more slowly comes to rest in the end. There are no islands of
// contacts: each body sleeps alone. Groups of jointed bodies sleep together, and not while a motor of theirs turns. A
// sleeping body wakes when it is hit harder than a threshold (contact_detection.cpp), when something that touches it
// has moved by more than kWakeDistance, by an impulse, a character's push or a change of gravity, water, joints or
// collision filters, or when what it touched is cut, moved or removed (physics_bodies.cpp). Settled bodies want a
// harder hit, and debris waits until fewer than DebrisSettings::awakeBodies are awake.

namespace rubble {
namespace {

constexpr double kWakeDistance = 0.02;  ///< metres that a body moves before it wakes what touches it
constexpr double kWakeAngle = 0.04;     ///< radians, the same
constexpr double kSlowSpeed = 0.3;      ///< m/s below which a touching body counts as slow
constexpr double kMaxPatience = 4.0;    ///< factor on the allowed displacement after some seconds of being slow

}  // namespace

void putToSleep(PhysicsBodies& bodies, const PhysicsJoints& joints, const PhysicsSettings& settings, glm::dvec3 gravity,
                size_t solverBodies) {
    const bool isWeightless = gravity == glm::dvec3(0.0);
    for (const uint32_t slot : bodies.awake()) {
        DynamicBody& body = bodies.at(slot);
        SolverBody& motion = body.motion;
        const double speed =
            std::max(glm::length(motion.velocity), glm::length(motion.angularVelocity) * body.minHalfExtent());
        body.slowSeconds = body.touching && speed < kSlowSpeed ? body.slowSeconds + settings.stepSeconds : 0.0;
        const double patience = std::min(1.0 + body.slowSeconds, kMaxPatience);
        if (body.slowSeconds > 0.0) {
            const double kept = 1.0 - settings.slowDamping * patience;
            motion.velocity *= kept;
            motion.angularVelocity *= kept;
        }
        const double allowed = settings.sleepTime * patience;
        const double restTime = body.sleepTimer.restTime(body.pose(), settings.sleepVelocity * allowed,
                                                         settings.sleepAngularVelocity * allowed, settings.stepSeconds);
        const bool isJointed = !joints.table().of(slot).empty();
        body.wantsSleep =
            restTime >= settings.sleepTime && (body.touching || body.inWater || isWeightless || isJointed);
        if (body.wantsSleep && !isJointed) bodies.putToSleep(body);
    }
    joints.putToSleep(bodies, solverBodies);
    bodies.removeEnded();
}

/// The first time after it woke, a body wakes all that its bounds touch: there are no contacts between sleeping bodies.
/// Bodies that wake are inserted into the list that is walked, so the walk finds its place again by slot.
void wakeTouched(PhysicsBodies& bodies) {
    const std::vector<uint32_t>& awake = bodies.awake();
    for (size_t i = 0; i < awake.size(); ++i) {
        const uint32_t slot = awake[i];
        DynamicBody& body = bodies.at(slot);
        if (!body.sleepTimer.hasMoved(body.pose(), kWakeDistance, kWakeAngle)) continue;
        if (body.newlyAwake) bodies.wakeTouching(body.object.low, body.object.high);
        body.newlyAwake = false;
        std::sort(body.sleepersTouched.begin(), body.sleepersTouched.end());
        for (const uint32_t touched : body.sleepersTouched)
            if (DynamicBody* sleeper = bodies.dynamicAt(touched); sleeper && !sleeper->settled)
                bodies.wakeOrWait(*sleeper);
        body.sleepersTouched.clear();
        i = size_t(std::lower_bound(awake.begin(), awake.end(), slot) - awake.begin());
    }
}

}  // namespace rubble
