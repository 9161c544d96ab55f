#include "physics/stages/sleep.h"

#include <algorithm>

#include "physics/solver/blockwise.h"

// When a body sleeps, and when it wakes.
//
// A body may fall asleep when it is at rest (sleep_timer.h) and touches something, or is in water, jointed, or without
// gravity. Rest means balance, not slowness: what sleeps would not move by a voxel in the next ten seconds. What bears
// it must rest too, or its support may be about to move; what lies on it or leans on it need not. There are no islands
// of contacts beyond that, so a pile sleeps while something stirs at its side. Groups of jointed bodies sleep together,
// and not while a motor of theirs turns. Neither falling asleep nor waking moves what is in balance: contacts stay as
// soft as they were (contact_setup.cpp) and keep their impulses (resting_contacts.h). A sleeping body wakes when a
// hit would give it more speed than what rests may have (contact_detection.cpp), when something that touches it has
// moved by more than kWakeDistance, when its load changes (loads.cpp), by an impulse, a character's push or a change of
// gravity, water, joints or collision filters, or when what it touched is cut, moved or removed, or something is made
// where it is (physics_bodies.cpp). Settled bodies want a harder hit, and do not wake with what came to touch them
// after they had settled: that cannot bear them. Debris waits until fewer than DebrisSettings::awakeBodies are awake,
// and in one step no more than PhysicsSettings::wakesPerStep wake because of others. The others wait for the next
// steps; what hits one of them meanwhile meets a wall.

namespace rubble {
namespace {

constexpr double kWakeDistance = 0.02;  ///< metres that a body moves before it wakes what touches it
constexpr double kMinShare = 0.01;      ///< of a body's weight, from which what lifts it bears it

/// Keeps awake what an awake body bears that does not rest. substep: s.
void keepBorneAwake(std::span<Manifold* const> manifolds, glm::dvec3 gravity, double substep) {
    const double least = kMinShare * glm::dot(gravity, gravity) * substep;
    for (const Manifold* manifold : manifolds) {
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() || b->asleep() || (a->rests && b->rests)) continue;
        const double lift =
            -glm::dot(manifold->impulseOfFirst(), gravity);  // of the first; its weight gives gravity^2 m
        if (lift > least * a->mass().mass && !b->rests) a->wantsSleep = false;
        if (-lift > least * b->mass().mass && !a->rests) b->wantsSleep = false;
    }
}

}  // namespace

void putToSleep(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, const PhysicsJoints& joints,
                const PhysicsSettings& settings, glm::dvec3 gravity, size_t solverBodies) {
    const bool isWeightless = gravity == glm::dvec3(0.0);
    const RestLimits limits{settings.sleepTime, settings.sleepVelocity, settings.sleepAcceleration,
                            settings.stepSeconds};
    bool any = false;
    forEachBlockwise(settings.parallelFor ? &settings.parallelFor : nullptr, bodies.awake().size(), [&](size_t i) {
        DynamicBody& body = bodies.at(bodies.awake()[i]);
        body.rests = body.sleepTimer.rests(body.pose(), body.object.radius, limits);
    });
    for (const uint32_t slot : bodies.awake()) {
        DynamicBody& body = bodies.at(slot);
        body.wantsSleep = body.rests && (body.touching || body.inWater || isWeightless || body.gravityScale == 0.0 ||
                                         joints.isJointed(slot));
        any = any || body.wantsSleep;
    }
    if (any) keepBorneAwake(manifolds, gravity, settings.stepSeconds / settings.substeps);
    for (const uint32_t slot : bodies.awake())
        if (DynamicBody& body = bodies.at(slot); body.wantsSleep && !joints.isJointed(slot)) bodies.putToSleep(body);
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
        if (!body.sleepTimer.hasMoved(body.pose(), body.object.radius, kWakeDistance)) continue;
        if (body.newlyAwake) bodies.wakeTouching(body.object.low, body.object.high);
        body.newlyAwake = body.isAsLoaded = false;
        std::sort(body.sleepersTouched.begin(), body.sleepersTouched.end());
        for (const uint32_t touched : body.sleepersTouched)
            if (DynamicBody* sleeper = bodies.dynamicAt(touched)) bodies.wakeOrWait(*sleeper);
        body.sleepersTouched.clear();
        i = size_t(std::lower_bound(awake.begin(), awake.end(), slot) - awake.begin());
    }
}

}  // namespace rubble
