#include "physics/joints/joint_table.h"

#include "physics/joints/rope.h"
#include "physics/physics_impl.h"

namespace rubble {
namespace {

constexpr int kRopeRestSteps = 60;    ///< steps of hardly moving after which a rope is left alone
constexpr double kRopeSlow = 0.05;    ///< m/s
constexpr double kRopeMargin = 0.25;  ///< metres around a rope in which it may touch something

std::pair<uint32_t, uint32_t> inOrder(uint32_t a, uint32_t b) {
    return a < b ? std::pair(a, b) : std::pair(b, a);
}

}  // namespace

JointProxy& JointTable::add(std::unique_ptr<JointProxy> joint) {
    JointProxy& proxy = *joint;
    const uint32_t slot = proxy.handle.slot();
    if (m_joints.size() <= slot) m_joints.resize(slot + 1);
    m_joints[slot] = std::move(joint);
    ++m_count;
    if (proxy.joint.kind == JointKind::Rope) insertSorted(m_ropes, slot);
    for (const BodyHandle body : proxy.bodies) {
        if (!body) continue;
        if (m_ofBody.size() <= body.slot()) m_ofBody.resize(body.slot() + 1);
        insertSorted(m_ofBody[body.slot()], slot);
    }
    if (!proxy.joint.collides && proxy.objects[0] != JointProxy::kNothing && proxy.objects[1] != JointProxy::kNothing) {
        const auto pair = inOrder(proxy.objects[0], proxy.objects[1]);
        m_nonColliding.insert(std::lower_bound(m_nonColliding.begin(), m_nonColliding.end(), pair), pair);
    }
    return proxy;
}

std::unique_ptr<JointProxy> JointTable::remove(uint32_t slot) {
    if (!at(slot)) return nullptr;
    std::unique_ptr<JointProxy> proxy = std::move(m_joints[slot]);
    --m_count;
    eraseSorted(m_ropes, slot);
    for (const BodyHandle body : proxy->bodies)
        if (body) eraseSorted(m_ofBody[body.slot()], slot);
    const auto pair = inOrder(proxy->objects[0], proxy->objects[1]);
    const auto place = std::lower_bound(m_nonColliding.begin(), m_nonColliding.end(), pair);
    if (!proxy->joint.collides && place != m_nonColliding.end() && *place == pair) m_nonColliding.erase(place);
    return proxy;
}

void JointTable::removeNonColliding(std::vector<ObjectPair>& pairs) const {
    if (m_nonColliding.empty()) return;
    std::erase_if(pairs, [&](const ObjectPair& pair) {
        return std::binary_search(m_nonColliding.begin(), m_nonColliding.end(),
                                  std::pair(pair.first->number, pair.second->number));
    });
}

void PhysicsWorld::Impl::destroyJoint(uint32_t slot) {
    const std::unique_ptr<JointProxy> proxy = joints.remove(slot);
    if (!proxy) return;
    for (const BodyHandle body : proxy->bodies)
        if (DynamicBody* dynamic = body ? dynamicAt(body.slot()) : nullptr; dynamic && dynamic->handle() == body)
            wake(*dynamic);
}

/// Makes a joint as World has it, with the impulses that it bore if it was there before.
void PhysicsWorld::Impl::createJoint(const World& world, JointHandle handle) {
    const Joint* joint = world.joints().find(handle);
    const std::unique_ptr<JointProxy> before = joints.remove(handle.slot());
    if (!joint) return;
    const bool isRope = joint->kind == JointKind::Rope;
    auto proxy = std::make_unique<JointProxy>();
    proxy->handle = handle;
    proxy->joint = *joint;
    for (size_t i = 0; i < 2; ++i) {
        const JointEnd& end = joint->ends[i];
        proxy->frames[i] = world.jointToWorld(end);
        const Shape* shape = world.shapes().find(end.shape);
        if (!shape) continue;
        const bool isStatic = world.bodies().at(shape->body).isStatic;
        if (!isRope) proxy->objects[i] = isStatic ? kStaticObject | end.shape.slot() : shape->body.slot();
        if (isStatic) continue;
        proxy->bodies[i] = shape->body;
        proxy->frames[i] = shape->local * end.frame;
    }
    if (proxy->bodies[0] == proxy->bodies[1] && !isRope) return;  // of one body, or of two that stand still
    if (before && before->handle == handle) proxy->constraint = before->constraint;
    proxy->constraint.joint = &proxy->joint;
    proxy->constraint.handle = handle;
    const JointProxy& added = joints.add(std::move(proxy));
    for (const BodyHandle body : added.bodies)
        if (DynamicBody* dynamic = body && added.isMotorDriven() ? dynamicAt(body.slot()) : nullptr) wake(*dynamic);
}

void PhysicsWorld::Impl::applyJoints(const FrameChanges& changes, const World& world) {
    for (const JointBroken& broken : changes.jointsBroken) destroyJoint(broken.joint.slot());
    const auto read = [&](JointHandle handle) {
        destroyJoint(handle.slot());
        createJoint(world, handle);
        if (const JointProxy* proxy = joints.at(handle.slot()))
            for (const BodyHandle body : proxy->bodies)
                if (DynamicBody* dynamic = body ? dynamicAt(body.slot()) : nullptr) wake(*dynamic);
    };
    for (const JointHandle handle : changes.jointsCreated) read(handle);
    for (const JointMoved& moved : changes.jointsMoved) read(moved.joint);
    for (const JointHandle handle : changes.jointsChanged) read(handle);
    if (!changes.carved.empty() || !changes.shapesDestroyed.empty())
        for (const uint32_t rope : joints.ropes()) joints.at(rope)->restSteps = 0;
}

/// What is jointed to something awake is awake.
void PhysicsWorld::Impl::wakeJointed() {
    if (joints.empty()) return;
    std::vector<uint32_t> open(awake);
    while (!open.empty()) {
        const uint32_t slot = open.back();
        open.pop_back();
        for (const uint32_t joint : joints.of(slot))
            for (const BodyHandle other : joints.at(joint)->bodies) {
                DynamicBody* body = other ? dynamicAt(other.slot()) : nullptr;
                if (!body || !body->asleep() || body->quarantined()) continue;
                wake(*body);
                open.push_back(other.slot());
            }
    }
}

/// The joints of what is awake, between the solver's bodies.
void PhysicsWorld::Impl::gatherJoints() {
    activeJoints.clear();
    if (joints.empty()) return;
    std::vector<uint32_t> slots;
    for (const uint32_t body : awake)
        for (const uint32_t joint : joints.of(body)) slots.push_back(joint);
    std::sort(slots.begin(), slots.end());
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    for (const uint32_t slot : slots) {
        JointProxy& proxy = *joints.at(slot);
        JointConstraint& c = proxy.constraint;
        bool isHeld = !proxy.joint.ends[0].isFree && !proxy.joint.ends[1].isFree;
        for (size_t i = 0; i < 2; ++i) {
            c.bodies[i] = 0;
            c.frames[i] = proxy.frames[i];
            if (!proxy.bodies[i]) continue;
            const DynamicBody* body = dynamicAt(proxy.bodies[i].slot());
            isHeld = isHeld && body && body->handle() == proxy.bodies[i] && !body->quarantined();
            if (!isHeld) break;
            if (body->asleep()) {  // about to wake
                c.frames[i] = body->pose() * body->bodyInCenter() * proxy.frames[i];
                continue;
            }
            c.bodies[i] = bodyNumber[proxy.bodies[i].slot()];
            c.frames[i] = body->bodyInCenter() * proxy.frames[i];
        }
        if (isHeld) activeJoints.push_back(&c);
    }
}

void PhysicsWorld::Impl::breakJoints() {
    for (const JointConstraint* c : activeJoints) {
        const Joint& joint = *c->joint;
        const bool isTooMuch =
            (joint.breakForce > 0.0 && glm::length(c->force) > joint.breakForce) ||
            (joint.breakTorque > 0.0 && glm::length(c->torque) > joint.breakTorque) ||
            (joint.kind == JointKind::Rope && joint.rope.strength > 0.0 && glm::length(c->force) > joint.rope.strength);
        if (isTooMuch) jointBreaks.push_back(c->handle);
    }
}

/// What hangs together sleeps when all of it is restTime and no motor runs.
void PhysicsWorld::Impl::putJointedToSleep() {
    std::vector<int> group(bodies.size());
    for (size_t i = 0; i < group.size(); ++i) group[i] = int(i);
    const auto rootOf = [&](int i) {
        while (group[size_t(i)] != i) i = group[size_t(i)] = group[size_t(group[size_t(i)])];
        return i;
    };
    std::vector<bool> isAwake(bodies.size(), false);
    for (const JointConstraint* c : activeJoints) {
        const auto [a, b] = c->bodies;
        if (a && b) group[size_t(std::max(rootOf(a), rootOf(b)))] = std::min(rootOf(a), rootOf(b));
    }
    for (const JointConstraint* c : activeJoints)
        if (joints.at(c->handle.slot())->isMotorDriven())
            isAwake[size_t(rootOf(std::max(c->bodies[0], c->bodies[1])))] = true;
    for (const uint32_t slot : awake)
        if (!dynamics[slot]->wantsSleep) isAwake[size_t(rootOf(bodyNumber[slot]))] = true;
    for (const uint32_t slot : awake) {
        DynamicBody& body = *dynamics[slot];
        if (body.asleep() || !body.wantsSleep || joints.of(slot).empty() || isAwake[size_t(rootOf(bodyNumber[slot]))])
            continue;
        sleep(body);
        ended.push_back(slot);
    }
}

/// Moves the points of ropes after the bodies.
void PhysicsWorld::Impl::moveRopes() {
    for (const uint32_t slot : joints.ropes()) {
        JointProxy& proxy = *joints.at(slot);
        RopeStep step{.length = proxy.joint.rope.length,
                      .radius = proxy.joint.rope.radius,
                      .gravity = gravity,
                      .seconds = settings.stepSeconds};
        bool isCarried = false;
        for (size_t i = 0; i < 2; ++i) {
            const DynamicBody* body = proxy.bodies[i] ? dynamicAt(proxy.bodies[i].slot()) : nullptr;
            isCarried = isCarried || (body && !body->asleep());
            if (proxy.joint.ends[i].isFree) continue;
            const Pose end = body ? body->pose() * body->bodyInCenter() * proxy.frames[i] : proxy.frames[i];
            step.ends[i] = end.position;
        }
        if (!isCarried && proxy.restSteps >= kRopeRestSteps) continue;
        glm::dvec3 low(1e300), high(-1e300);
        for (const RopePoint& point : proxy.joint.points) {
            const glm::dvec3 next = point.position + point.velocity * settings.stepSeconds;
            low = glm::min(low, glm::min(point.position, next));
            high = glm::max(high, glm::max(point.position, next));
        }
        found.clear();
        broadphase.find(low - kRopeMargin, high + kRopeMargin, found);
        std::sort(found.begin(), found.end(),
                  [](const CollisionObject* a, const CollisionObject* b) { return a->number < b->number; });
        step.near = found;
        const double fastest = moveRope(proxy.joint.points, step, proxy.constraint.bendPoints);
        proxy.restSteps = fastest < kRopeSlow ? proxy.restSteps + 1 : 0;
        ropeMotions.push_back({proxy.handle, proxy.joint.points});
    }
}

}  // namespace rubble
