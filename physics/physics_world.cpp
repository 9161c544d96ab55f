#include "physics/physics_world.h"

#include "physics/collision/impacts.h"
#include "physics/physics_impl.h"
#include "physics/stages/physics_reports.h"
#include "physics/stages/sleep.h"
#include "runtime/core/prefetch.h"

namespace rubble {

PhysicsWorld::PhysicsWorld(const PhysicsSettings& settings) : m_impl(std::make_unique<Impl>(settings)) {}
PhysicsWorld::~PhysicsWorld() = default;

void PhysicsWorld::load(const World& world) {
    const LimitCounts counts = m_impl->bodies.limits().counts();
    m_impl = std::make_unique<Impl>(PhysicsSettings(m_impl->settings));
    m_impl->bodies.limits().setCounts(counts);
    m_impl->load(world);
    m_impl->ground.update(world, m_impl->bodies, false);
    if (m_reports && world.data().levelReplaced) m_reports->forget();
}

void PhysicsWorld::apply(const FrameChanges& changes, const World& world) {
    Impl& impl = *m_impl;
    // What World says is awake comes first. Other debris waits for the step.
    impl.bodies.budget().setDebrisLimit(0);
    impl.applyChanges(changes, world);
    impl.ground.update(world, impl.bodies, true);
    impl.applyImpulses(changes);
    impl.joints.constrain(changes, world, impl.bodies);
    if (m_reports) m_reports->addEdited(changes, world);
    for (const BodyHandle handle : changes.settled)
        if (DynamicBody* body = impl.bodies.find(handle)) body->settled = body->asleep();
    impl.bodies.budget().setDebrisLimit(world.settings().debris.awakeBodies);
}

void PhysicsWorld::setSettings(const PhysicsSettings& settings) {
    m_impl->settings = settings;
}

void PhysicsWorld::step() {
    Impl& impl = *m_impl;
    const PhysicsSettings& settings = impl.settings;
    WaterVolumes* waters = impl.waters.empty() ? nullptr : &impl.waters;
    impl.poses.clear();
    impl.impacts.clear();
    impl.work = 0.0;
    impl.characters.begin();
    impl.joints.begin();
    impl.bodies.wakeWaiting(settings);
    impl.joints.wakeJointed(impl.bodies);
    PhysicsReports* const reports = m_reports.get();
    if (reports) reports->begin();
    if (!impl.bodies.awake().empty()) {
        const std::vector<uint32_t>& awake = impl.bodies.awake();
        for (size_t i = 0; i < awake.size(); ++i) {
            if (i + 4 < awake.size()) prefetch(&impl.bodies.at(awake[i + 4]), sizeof(DynamicBody));
            DynamicBody& body = impl.bodies.at(awake[i]);
            body.inWater = false;
            body.motion.gravityScale = float(body.gravityScale);
            impl.work += body.damp(settings.stepSeconds);
            if (waters) impl.work += waters->applyForces(body, impl.gravity, settings.stepSeconds);
            if (reports && body.inWater) reports->addInWater(body, impl.waters.inSlot(body.waterSlot));
            impl.bodies.limits().clamp(body);  // contacts are searched along the motion
        }
        impl.contacts.find(impl.bodies, impl.joints, settings, impl.gravity);
        impl.contacts.recordTouching(impl.bodies);
        impl.solver.solve(impl.bodies, impl.contacts.manifolds(), impl.joints, impl.gravity, settings);
        for (const uint32_t slot : impl.bodies.awake())
            if (const DynamicBody& body = impl.bodies.at(slot); body.motion.gravityScale != 1.0f)
                impl.work += buoyancyWork(body, impl.gravity);
        if (impl.continuous.stop(impl.bodies, impl.joints.table(), settings, impl.gravity))
            impl.solver.keepMomentum(impl.bodies);
        impl.work += impl.joints.work();
        impl.joints.findBroken();
        impl.bodies.quarantineInvalid();
        if (reports) reports->addContacts(impl.contacts.manifolds(), impl.bodies);
        putToSleep(impl.bodies, impl.contacts.manifolds(), impl.joints, settings, impl.gravity,
                   impl.solver.bodyCount());
        Loads::record(impl.contacts.manifolds());
        impl.loads.wakeOverloaded(impl.bodies, impl.contacts.manifolds(), impl.gravity,
                                  settings.stepSeconds / settings.substeps);
        impl.contacts.keepResting();
        wakeTouched(impl.bodies);
        findImpacts(impl.contacts.manifolds(), settings.impactSpeed, settings.impactThreshold, impl.bodies.handles(),
                    impl.impacts);
    }
    impl.joints.moveRopes(impl.bodies, impl.gravity, settings.stepSeconds);
    impl.work += impl.characters.move(impl.bodies, waters, impl.gravity, settings.stepSeconds);
    impl.bodies.reportPoses(impl.poses);
}

std::span<const BodyPose> PhysicsWorld::poses() const {
    return m_impl->poses;
}

std::span<const CharacterMove> PhysicsWorld::characters() const {
    return m_impl->characters.moves();
}

std::span<const Impact> PhysicsWorld::impacts() const {
    return m_impl->impacts;
}

std::span<const JointHandle> PhysicsWorld::jointBreaks() const {
    return m_impl->joints.broken();
}

std::span<const RopeMotion> PhysicsWorld::ropes() const {
    return m_impl->joints.ropeMotions();
}

void PhysicsWorld::report(const ReportFilter& filter) {
    if (!filter.any()) return m_reports.reset();
    if (m_reports) return m_reports->setFilter(filter);
    m_reports = std::make_unique<PhysicsReports>(filter);
}

std::span<const ReportedContact> PhysicsWorld::contacts() const {
    return m_reports ? m_reports->contacts() : std::span<const ReportedContact>();
}

std::span<const WaterEntry> PhysicsWorld::waterEntries() const {
    return m_reports ? m_reports->waterEntries() : std::span<const WaterEntry>();
}

PhysicsStats PhysicsWorld::stats() const {
    PhysicsBodies& bodies = m_impl->bodies;
    PhysicsStats stats;
    stats.work = m_impl->work;
    stats.clamped = m_impl->bodies.limits().counts();
    stats.awake = int(bodies.awake().size());
    for (uint32_t slot = 0; slot < bodies.handles().size(); ++slot) stats.bodies += bodies.dynamicAt(slot) != nullptr;
    for (const uint32_t slot : bodies.awake()) stats.crowded += bodies.dynamicAt(slot)->object.isCrowded;
    stats.waiting = int(bodies.budget().waiting());
    stats.leftOut = int(m_impl->contacts.leftOut());
    stats.bricksLeftOut = int(m_impl->contacts.bricksLeftOut());
    stats.candidates = int(m_impl->contacts.candidates());
    for (const Manifold* manifold : m_impl->contacts.manifolds())
        stats.pairs += manifold->count > 0, stats.contacts += manifold->count;
    return stats;
}

}  // namespace rubble
