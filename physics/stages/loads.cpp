#include "physics/stages/loads.h"

#include <algorithm>

// How a change of load wakes what sleeps.
//
// The solver takes a sleeping body for a static one: it presses on nothing, and nothing moves it. So
//   * what wakes, or loses or gains a support, wakes what it bears: its balance is theirs. Settled debris does not,
//     so that a pile of it costs what its surface does;
//   * a sleeping body remembers what its neighbours pressed on it with when it fell asleep. It wakes when those that
//     are awake press otherwise for kSteps steps on end: what is set down on it, lifted off it, or made heavier. What
//     bounces or rolls past is gone by then. A pile shifts its forces a little while parts of it stir: of 1,416 such
//     shifts in a pile of 200 that comes to rest, 12 were larger than a fifth of all that pressed on the body;
//   * what a level or a save has asleep has slept in balance, but the impulses are not in the file. If neither of two
//     has moved since it was loaded, what the one that wakes presses on the other with, when the solver has found it,
//     is what it pressed with before. So a saved pile sleeps on as one that was not saved.

namespace rubble {
namespace {

constexpr double kBears = 0.1;          ///< of a normal, its part against gravity from which a contact bears
constexpr float kTouch = 0.005f;        ///< metres apart up to which a contact may bear
constexpr double kWeightShare = 0.1;    ///< of a sleeper's weight, by which its load may change
constexpr double kImpulseShare = 0.25;  ///< of all that its neighbours pressed on it with, by which it may change too
constexpr int kSteps = 6;               ///< for which it may have changed by more
constexpr int kStepsToLearn = 30;       ///< in which the solver finds the impulses of what wakes without any

/// What a body got from the other one of a manifold in the last substep, N s.
glm::dvec3 impulseOn(const DynamicBody& body, const Manifold& manifold) {
    const glm::dvec3 first = manifold.impulseOfFirst();
    return manifold.objects.first->dynamic == &body ? first : -first;
}

/// Whether the first may bear the second.
bool bears(const Manifold& manifold, bool isFirst, glm::dvec3 up) {
    const double sign = isFirst ? -1.0 : 1.0;  // normals are toward the first
    for (const ManifoldPoint& point : manifold.all())
        if (point.separation < kTouch && sign * glm::dot(glm::dvec3(point.normal), up) > kBears) return true;
    return false;
}

/// By how much a sleeping body is pressed otherwise than before by one that now presses with an impulse, N s.
glm::dvec3 changeBy(const DynamicBody& other, DynamicBody& sleeper, const glm::dvec3& impulse) {
    std::vector<SleepLoad::Neighbour>& known = sleeper.sleepLoad.neighbours;
    auto at = std::find_if(known.begin(), known.end(),
                           [&](const SleepLoad::Neighbour& each) { return each.slot == other.handle().slot(); });
    if (at == known.end()) {
        if (!sleeper.isAsLoaded || !other.isAsLoaded) return impulse;
        at = known.insert(known.end(), {other.handle().slot(), glm::dvec3(0.0), kStepsToLearn});
    }
    if (at->stepsToLearn == 0) return impulse - at->impulse;
    --at->stepsToLearn;
    at->impulse = impulse;
    return glm::dvec3(0.0);
}

}  // namespace

bool Loads::wakeBorne(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, glm::dvec3 gravity) {
    if (gravity == glm::dvec3(0.0)) return false;
    const glm::dvec3 up = -glm::normalize(gravity);
    bool any = false;
    for (const Manifold* manifold : manifolds) {
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() == b->asleep()) continue;
        DynamicBody &sleeper = a->asleep() ? *a : *b, &other = a->asleep() ? *b : *a;
        if (!other.wakesLoad || sleeper.settled || sleeper.quarantined() || !bears(*manifold, &other == a, up))
            continue;
        bodies.wakeOrWait(sleeper);
        any = any || !sleeper.asleep();
    }
    return any;
}

void Loads::wakeOverloaded(PhysicsBodies& bodies, std::span<Manifold* const> manifolds, glm::dvec3 gravity,
                           double substep) {
    ++m_step;
    m_touched.clear();
    for (const Manifold* manifold : manifolds) {
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() == b->asleep()) continue;
        DynamicBody &sleeper = a->asleep() ? *a : *b, &other = a->asleep() ? *b : *a;
        if (sleeper.settled || sleeper.quarantined()) continue;
        SleepLoad& load = sleeper.sleepLoad;
        if (load.step != m_step) {
            if (load.step != m_step - 1) load.changedSteps = 0;
            load.step = m_step;
            load.change = glm::dvec3(0.0);
            m_touched.push_back(&sleeper);
        }
        load.change += changeBy(other, sleeper, impulseOn(sleeper, *manifold));
    }
    for (DynamicBody* sleeper : m_touched) {
        SleepLoad& load = sleeper->sleepLoad;
        double limit = kWeightShare * sleeper->mass().mass * glm::length(gravity) * substep;
        for (const SleepLoad::Neighbour& neighbour : load.neighbours)
            limit += kImpulseShare * glm::length(neighbour.impulse);
        const bool isChanged = glm::length(load.change) > limit;
        load.changedSteps = isChanged ? load.changedSteps + 1 : 0;
        if (load.changedSteps >= kSteps) bodies.wakeOrWait(*sleeper);
    }
}

void Loads::record(std::span<Manifold* const> manifolds) {
    const auto note = [](const CollisionObject& object, const CollisionObject& other, const Manifold& manifold) {
        if (!object.dynamic || !other.dynamic || object.dynamic->sleepLoad.isNoted) return;
        object.dynamic->sleepLoad.neighbours.push_back({other.body, impulseOn(*object.dynamic, manifold)});
    };
    for (const Manifold* manifold : manifolds) {
        const auto [first, second] = manifold->objects;
        note(*first, *second, *manifold);
        note(*second, *first, *manifold);
    }
}

}  // namespace rubble
