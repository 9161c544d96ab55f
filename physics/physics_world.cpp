#include "physics/physics_world.h"

#include <fmt/format.h>

#include "physics/physics_impl.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr double kUneven = 1.1;    ///< ratio of a body's moments of inertia above which its spin is not simply kept
constexpr double kSpinning = 0.3;  ///< rad/s
constexpr double kHardHit = 2.0;   ///< times what two that stay together share: they part as fast as they met

/// How fast something of a body is at most, squared and no more than doubled, m2/s2.
double speedSquares(const DynamicBody& body) {
    const glm::dvec3 &v = body.motion.velocity, &w = body.motion.angularVelocity;
    return 2.0 * (glm::dot(v, v) + glm::dot(w, w) * body.object.radius * body.object.radius);
}
/// Whether bodies whose squares add up to this may secondaryVelocity one by more than half its thickness in a step: a
/// first look, without roots.
bool needsSecondarySweep(double squares, double thin, double seconds) {
    return 2.0 * kHardHit * kHardHit * squares * seconds * seconds > thin * thin;
}

}  // namespace

PhysicsSettings fastPhysics() {
    PhysicsSettings settings;
    settings.substeps = 3;
    settings.loadBearingRatio = 10.0;
    settings.rotation = RotationRule::Never;
    return settings;
}

PhysicsSettings balancedPhysics() {
    return {};
}

PhysicsSettings accuratePhysics() {
    PhysicsSettings settings;
    settings.substeps = 16;
    settings.iterations = 2;
    settings.contactHertz = 240.0;
    settings.slowDamping = 0.0;
    settings.rotation = RotationRule::Always;
    return settings;
}

void PhysicsWorld::Impl::applyWater() {
    for (const uint32_t slot : awake)
        dynamics[slot]->inWater = !waters.empty() && waters.act(*dynamics[slot], gravity, settings.stepSeconds);
}

void PhysicsWorld::Impl::moveCharacters() {
    for (auto& [handle, character] : characters) {
        const Character before = character;
        CharacterSurroundings around{
            .waters = waters.empty() ? nullptr : &waters, .gravity = gravity, .seconds = settings.stepSeconds};
        const double minHalfExtent = characterQueryRadius(character, settings.stepSeconds);
        broadphase.find(before.position - minHalfExtent,
                        before.position + glm::dvec3(0.0, character.height, 0.0) + minHalfExtent, around.objects);
        std::sort(around.objects.begin(), around.objects.end(),
                  [](const CollisionObject* a, const CollisionObject* b) { return a->number < b->number; });
        pushes.clear();
        moveCharacter(character, around, handles, pushes);
        for (const CharacterPush& push : pushes) {
            if (push.wakes) wakeOrWait(*push.body);
            if (!push.body->asleep()) push.body->applyImpulse(push.impulse, push.position);
        }
        character.wantsJump = false;
        if (character == before) continue;
        characterMoves.push_back({handle, character.position, character.velocity, character.grounded,
                                  character.crouched, character.swimming, character.ground});
    }
}

/// Contacts of what moves, with what it hits and wakes.
void PhysicsWorld::Impl::findContacts() {
    const NarrowphaseSettings narrow{.margin = settings.contactMargin,
                                     .seconds = settings.stepSeconds,
                                     .sweepThreshold = settings.continuous ? settings.sweepThreshold : 1e300};
    narrowphase.begin();
    for (const uint32_t slot : awake) dynamics[slot]->known = false;
    for (bool more = true; more; more = wakeHit()) {
        moving.clear();
        for (const uint32_t slot : awake) {
            DynamicBody& body = *dynamics[slot];
            if (body.known) continue;
            body.setPose();
            broadphase.move(body.object, body.motion.velocity * settings.stepSeconds,
                            settings.contactMargin +
                                body.object.radius * glm::length(body.motion.angularVelocity) * settings.stepSeconds);
            moving.push_back(&body.object);
        }
        pairs.clear();
        broadphase.findPairs(
            moving, [](const CollisionObject& o) { return o.dynamic->known; }, pairs);
        if (!joints.empty()) joints.removeNonColliding(pairs);
        for (CollisionObject* object : moving) object->dynamic->known = true;
        narrowphase.collide(pairs, narrow, settings.parallelFor ? settings.parallelFor : ParallelFor(serialFor));
    }
    if (settings.continuous) sweepSecondary(narrow);
}

/// What a fast one hits may be far by the end of the step, where it did not look for contacts: it is swept once more,
/// as it would fly on from a hit that takes nothing, against what does not move.
void PhysicsWorld::Impl::sweepSecondary(const NarrowphaseSettings& narrow) {
    double fastest = 0.0, thinnest = 1e9;
    for (const uint32_t slot : awake) {
        fastest = std::max(fastest, speedSquares(*dynamics[slot]));
        thinnest = std::min(thinnest, dynamics[slot]->minHalfExtent());
    }
    if (!needsSecondarySweep(2.0 * fastest, thinnest, settings.stepSeconds)) return;
    moving.clear();
    for (const Manifold* manifold : narrowphase.manifolds()) {
        DynamicBody *a = manifold->objects.first->dynamic, *b = manifold->objects.second->dynamic;
        if (!a || !b || a->asleep() || b->asleep() ||
            !needsSecondarySweep(speedSquares(*a) + speedSquares(*b), std::min(a->minHalfExtent(), b->minHalfExtent()),
                                 settings.stepSeconds))
            continue;
        const glm::dvec3 away = approachVelocity(*manifold, settings.stepSeconds);
        const double all = a->mass().mass + b->mass().mass;
        const glm::dvec3 secondaryA = away * (kHardHit * b->mass().mass / all),
                         secondaryB = away * (-kHardHit * a->mass().mass / all);
        for (const auto& [body, secondaryVelocity] : {std::pair(a, secondaryA), std::pair(b, secondaryB)}) {
            if (glm::length(secondaryVelocity) * settings.stepSeconds <= body->minHalfExtent()) continue;
            if (body->secondaryVelocity == glm::dvec3(0.0)) moving.push_back(&body->object);
            body->secondaryVelocity += secondaryVelocity;
        }
    }
    if (moving.empty()) return;
    for (CollisionObject* object : moving) {
        const SolverBody& motion = object->dynamic->motion;
        broadphase.move(
            *object, (motion.velocity + object->dynamic->secondaryVelocity) * settings.stepSeconds,
            settings.contactMargin + object->radius * glm::length(motion.angularVelocity) * settings.stepSeconds);
    }
    pairs.clear();
    broadphase.findPairs(
        moving, [](const CollisionObject&) { return true; }, pairs);
    if (!joints.empty()) joints.removeNonColliding(pairs);
    narrowphase.collideAgain(pairs, narrow);
    for (CollisionObject* object : moving) object->dynamic->secondaryVelocity = glm::dvec3(0.0);
}

void PhysicsWorld::Impl::solve() {
    bodies.assign(1, {});
    bodyNumber.resize(dynamics.size());
    for (const uint32_t slot : awake) {
        bodyNumber[slot] = int(bodies.size());
        SolverBody& body = dynamics[slot]->motion;
        const glm::dvec3& i = body.inertia;
        const double unevenness = std::max({i.x, i.y, i.z}) / std::min({i.x, i.y, i.z});
        body.conservesMomentum = settings.rotation == RotationRule::Always ||
                                 (settings.rotation == RotationRule::WhereNeeded && unevenness > kUneven &&
                                  glm::length(body.angularVelocity) > kSpinning);
        bodies.push_back(body);
    }
    bodyOf.clear();
    const auto numberOf = [&](const CollisionObject& object) {
        return object.dynamic && !object.dynamic->asleep() ? bodyNumber[object.body] : 0;
    };
    for (const Manifold* manifold : narrowphase.manifolds())
        bodyOf.emplace_back(numberOf(*manifold->objects.first), numberOf(*manifold->objects.second));
    gatherJoints();
    energy.note(bodies);
    solver.solve(bodies, narrowphase.manifolds(), bodyOf, gravity,
                 {.substeps = settings.substeps,
                  .iterations = settings.iterations,
                  .seconds = settings.stepSeconds,
                  .contactHertz = settings.contactHertz,
                  .loadBearingRatio = settings.loadBearingRatio,
                  .loadBearingPasses = settings.loadBearingPasses,
                  .parallelFor = settings.parallelFor ? &settings.parallelFor : nullptr},
                 activeJoints);
    energy.hold(bodies, bodyOf, activeJoints, gravity);
    for (const uint32_t slot : awake) {
        dynamics[slot]->motion = bodies[size_t(bodyNumber[slot])];
        dynamics[slot]->setPose();
    }
}

bool PhysicsWorld::Impl::isOutOfRange(const DynamicBody& body) {
    if (!body.isFartherThan(limits::kMaxDistance, broadphase.origin())) return false;
    const LimitCounts before = clamped;
    ++clamped[size_t(LimitKind::Distance)];
    warnOfLimits(before);
    return true;
}

void PhysicsWorld::Impl::clamp(DynamicBody& body) {
    const LimitCounts before = clamped;
    if (body.clamp(clamped)) warnOfLimits(before);
}

/// Of what was never beyond the envelope before.
void PhysicsWorld::Impl::warnOfLimits(const LimitCounts& before) {
    static constexpr const char* kWhat[] = {"faster than 5,000 m/s is clamped to that",
                                            "spinning faster than 1,000 rad/s is clamped to that",
                                            "a mass below 1e-9 or above 1e12 kg is clamped to that",
                                            "what gets farther than 1,000 km from the middle of the level stays there"};
    for (size_t i = 0; i < clamped.size(); ++i)
        if (before[i] == 0 && clamped[i] > 0)
            logWarning(fmt::format("physics: {}; PhysicsStats count how often", kWhat[i]));
}

void PhysicsWorld::Impl::quarantineBroken() {
    for (const uint32_t slot : awake) {
        DynamicBody& body = *dynamics[slot];
        if (body.finite() && !isOutOfRange(body)) {
            clamp(body);
            continue;
        }
        if (!body.finite())
            logWarning(fmt::format(
                "physics: body {} got a pose or velocity that is no number: it is frozen where it last was", slot));
        broadphase.remove(body.object);
        body.restore();
        body.setAsleep(true);
        body.quarantine();
        ended.push_back(slot);
    }
    for (const uint32_t slot : ended) leaveAwake(*dynamics[slot]);
}

void PhysicsWorld::Impl::reportPoses() {
    std::sort(ended.begin(), ended.end());
    auto next = ended.begin();
    const auto add = [&](uint32_t slot) {
        if (dynamics[slot] && dynamics[slot]->refresh()) poses.push_back(dynamics[slot]->state());
    };
    for (const uint32_t slot : awake) {
        for (; next != ended.end() && *next < slot; ++next) add(*next);
        if (next != ended.end() && *next == slot) ++next;  // slept and woke in one step
        add(slot);
    }
    for (; next != ended.end(); ++next) add(*next);
    ended.clear();
}

PhysicsWorld::PhysicsWorld(const PhysicsSettings& settings) : m_impl(std::make_unique<Impl>(settings)) {}
PhysicsWorld::~PhysicsWorld() = default;

void PhysicsWorld::apply(const FrameChanges& changes, const World& world, bool rebuild) {
    rebuild = rebuild || changes.levelReplaced;
    if (rebuild) {  // not cleared: trees remember
        const LimitCounts clamped = m_impl->clamped;
        m_impl = std::make_unique<Impl>(PhysicsSettings(m_impl->settings));
        m_impl->clamped = clamped;
    }
    Impl& impl = *m_impl;
    impl.awakeDebrisLimit = 0;  // what World says is awake comes first; the others wait for the step
    if (rebuild)
        impl.loadAll(world);
    else
        impl.setGravity(world);
    if (!rebuild && !changes.empty()) {
        impl.forget(changes);
        impl.refreshStatic(changes, world);
        impl.refreshDynamic(changes, world);
        impl.refreshFilters(changes, world);
        impl.refreshWaters(changes, world);
        impl.refreshCharacters(changes, world);
    }
    if (!rebuild) impl.applyJoints(changes, world);
    impl.applyImpulses(changes);
    for (const BodyHandle handle : changes.settled)
        if (DynamicBody* body = impl.dynamicAt(handle.slot()); body && body->handle() == handle)
            body->settled = body->asleep();
    impl.awakeDebrisLimit = world.settings().debris.awakeBodies;
}

void PhysicsWorld::step() {
    Impl& impl = *m_impl;
    impl.poses.clear();
    impl.impacts.clear();
    impl.characterMoves.clear();
    impl.jointBreaks.clear();
    impl.ropeMotions.clear();
    impl.wakeWaiting();
    impl.wakeJointed();
    if (!impl.awake.empty()) {
        impl.applyWater();
        impl.findContacts();
        impl.recordContacts();
        impl.solve();
        impl.breakJoints();
        impl.quarantineBroken();
        impl.putToSleep();
        impl.wakeTouched();
        findImpacts(impl.narrowphase.manifolds(), impl.settings.impactSpeed, impl.settings.impactThreshold,
                    impl.handles, impl.impacts);
    }
    impl.moveRopes();
    impl.moveCharacters();
    impl.reportPoses();
}

std::span<const BodyPose> PhysicsWorld::poses() const {
    return m_impl->poses;
}
std::span<const CharacterMove> PhysicsWorld::characters() const {
    return m_impl->characterMoves;
}
std::span<const Impact> PhysicsWorld::impacts() const {
    return m_impl->impacts;
}

std::span<const JointHandle> PhysicsWorld::jointBreaks() const {
    return m_impl->jointBreaks;
}

std::span<const RopeMotion> PhysicsWorld::ropes() const {
    return m_impl->ropeMotions;
}

PhysicsStats PhysicsWorld::stats() const {
    PhysicsStats stats;
    stats.clamped = m_impl->clamped;
    stats.awake = int(m_impl->awake.size());
    for (const auto& body : m_impl->dynamics) stats.bodies += body != nullptr;
    for (const Manifold* manifold : m_impl->narrowphase.manifolds())
        stats.pairs += manifold->count > 0, stats.contacts += manifold->count;
    return stats;
}

}  // namespace rubble
