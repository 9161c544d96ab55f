#include "physics/joints.h"

#include "physics/physics_impl.h"
#include "physics/rope_points.h"

namespace rubble {
namespace {

constexpr int kRopeRest = 60;        ///< steps of hardly moving after which a rope is left alone
constexpr double kRopeSlow = 0.05;   ///< m/s
constexpr double kRopeReach = 0.25;  ///< metres around a rope in which it may touch something

std::pair<uint32_t, uint32_t> inOrder(uint32_t a, uint32_t b) {
    return a < b ? std::pair(a, b) : std::pair(b, a);
}

}  // namespace

HeldJoint& JointTable::add(std::unique_ptr<HeldJoint> joint) {
    HeldJoint& held = *joint;
    const uint32_t slot = held.handle.slot();
    if (m_joints.size() <= slot) m_joints.resize(slot + 1);
    m_joints[slot] = std::move(joint);
    ++m_count;
    if (held.joint.kind == JointKind::Rope) insertSorted(m_ropes, slot);
    for (const BodyHandle body : held.bodies) {
        if (!body) continue;
        if (m_ofBody.size() <= body.slot()) m_ofBody.resize(body.slot() + 1);
        insertSorted(m_ofBody[body.slot()], slot);
    }
    if (!held.joint.collides && held.objects[0] != HeldJoint::kNothing && held.objects[1] != HeldJoint::kNothing) {
        const auto pair = inOrder(held.objects[0], held.objects[1]);
        m_apart.insert(std::lower_bound(m_apart.begin(), m_apart.end(), pair), pair);
    }
    return held;
}

std::unique_ptr<HeldJoint> JointTable::remove(uint32_t slot) {
    if (!at(slot)) return nullptr;
    std::unique_ptr<HeldJoint> held = std::move(m_joints[slot]);
    --m_count;
    eraseSorted(m_ropes, slot);
    for (const BodyHandle body : held->bodies)
        if (body) eraseSorted(m_ofBody[body.slot()], slot);
    const auto pair = inOrder(held->objects[0], held->objects[1]);
    const auto place = std::lower_bound(m_apart.begin(), m_apart.end(), pair);
    if (!held->joint.collides && place != m_apart.end() && *place == pair) m_apart.erase(place);
    return held;
}

void JointTable::dropApart(std::vector<ObjectPair>& pairs) const {
    if (m_apart.empty()) return;
    std::erase_if(pairs, [&](const ObjectPair& pair) {
        return std::binary_search(m_apart.begin(), m_apart.end(), std::pair(pair.first->number, pair.second->number));
    });
}

void PhysicsWorld::Impl::forgetJoint(uint32_t slot) {
    const std::unique_ptr<HeldJoint> held = joints.remove(slot);
    if (!held) return;
    for (const BodyHandle body : held->bodies)
        if (DynamicBody* dynamic = body ? dynamicAt(body.slot()) : nullptr; dynamic && dynamic->handle() == body) wake(*dynamic);
}

/// Makes a joint as World has it, with the impulses that it bore if it was there before.
void PhysicsWorld::Impl::readJoint(const World& world, JointHandle handle) {
    const Joint* joint = world.joints().find(handle);
    const std::unique_ptr<HeldJoint> before = joints.remove(handle.slot());
    if (!joint) return;
    const bool isRope = joint->kind == JointKind::Rope;
    auto held = std::make_unique<HeldJoint>();
    held->handle = handle;
    held->joint = *joint;
    for (size_t i = 0; i < 2; ++i) {
        const JointEnd& end = joint->ends[i];
        held->frames[i] = world.jointToWorld(end);
        const Shape* shape = world.shapes().find(end.shape);
        if (!shape) continue;
        const bool isStatic = world.bodies().at(shape->body).isStatic;
        if (!isRope) held->objects[i] = isStatic ? kStaticObject | end.shape.slot() : shape->body.slot();
        if (isStatic) continue;
        held->bodies[i] = shape->body;
        held->frames[i] = shape->local * end.frame;
    }
    if (held->bodies[0] == held->bodies[1] && !isRope) return;  // of one body, or of two that stand still
    if (before && before->handle == handle) held->constraint = before->constraint;
    held->constraint.joint = &held->joint;
    held->constraint.handle = handle;
    const HeldJoint& added = joints.add(std::move(held));
    for (const BodyHandle body : added.bodies)
        if (DynamicBody* dynamic = body && added.drives() ? dynamicAt(body.slot()) : nullptr) wake(*dynamic);
}

void PhysicsWorld::Impl::applyJoints(const FrameChanges& changes, const World& world) {
    for (const JointBroken& broken : changes.jointsBroken) forgetJoint(broken.joint.slot());
    const auto read = [&](JointHandle handle) {
        forgetJoint(handle.slot());
        readJoint(world, handle);
        if (const HeldJoint* held = joints.at(handle.slot()))
            for (const BodyHandle body : held->bodies)
                if (DynamicBody* dynamic = body ? dynamicAt(body.slot()) : nullptr) wake(*dynamic);
    };
    for (const JointHandle handle : changes.jointsMade) read(handle);
    for (const JointMoved& moved : changes.jointsMoved) read(moved.joint);
    for (const JointHandle handle : changes.jointsChanged) read(handle);
    if (!changes.carved.empty() || !changes.shapesDestroyed.empty())
        for (const uint32_t rope : joints.ropes()) joints.at(rope)->restingFor = 0;
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
        HeldJoint& held = *joints.at(slot);
        JointConstraint& c = held.constraint;
        bool isHeld = !held.joint.ends[0].isLoose && !held.joint.ends[1].isLoose;
        for (size_t i = 0; i < 2; ++i) {
            c.bodies[i] = 0;
            c.frames[i] = held.frames[i];
            if (!held.bodies[i]) continue;
            const DynamicBody* body = dynamicAt(held.bodies[i].slot());
            isHeld = isHeld && body && body->handle() == held.bodies[i] && !body->quarantined();
            if (!isHeld) break;
            if (body->asleep()) {  // about to wake
                c.frames[i] = body->pose() * body->bodyInCenter() * held.frames[i];
                continue;
            }
            c.bodies[i] = bodyNumber[held.bodies[i].slot()];
            c.frames[i] = body->bodyInCenter() * held.frames[i];
        }
        if (isHeld) activeJoints.push_back(&c);
    }
}

void PhysicsWorld::Impl::breakJoints() {
    for (const JointConstraint* c : activeJoints) {
        const Joint& joint = *c->joint;
        const bool isTooMuch = (joint.breakForce > 0.0 && glm::length(c->force) > joint.breakForce) ||
                               (joint.breakTorque > 0.0 && glm::length(c->torque) > joint.breakTorque) ||
                               (joint.kind == JointKind::Rope && joint.rope.strength > 0.0 && glm::length(c->force) > joint.rope.strength);
        if (isTooMuch) jointBreaks.push_back(c->handle);
    }
}

/// What hangs together sleeps when all of it is calm and no motor runs.
void PhysicsWorld::Impl::settleJointed() {
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
        if (joints.at(c->handle.slot())->drives()) isAwake[size_t(rootOf(std::max(c->bodies[0], c->bodies[1])))] = true;
    for (const uint32_t slot : awake)
        if (!dynamics[slot]->wantsSleep) isAwake[size_t(rootOf(bodyNumber[slot]))] = true;
    for (const uint32_t slot : awake) {
        DynamicBody& body = *dynamics[slot];
        if (body.asleep() || !body.wantsSleep || joints.of(slot).empty() || isAwake[size_t(rootOf(bodyNumber[slot]))]) continue;
        sleep(body);
        ended.push_back(slot);
    }
}

/// Moves the points of ropes after the bodies.
void PhysicsWorld::Impl::moveRopes() {
    for (const uint32_t slot : joints.ropes()) {
        HeldJoint& held = *joints.at(slot);
        RopeStep step{.length = held.joint.rope.length, .radius = held.joint.rope.radius, .gravity = gravity, .seconds = settings.stepSeconds};
        bool isCarried = false;
        for (size_t i = 0; i < 2; ++i) {
            const DynamicBody* body = held.bodies[i] ? dynamicAt(held.bodies[i].slot()) : nullptr;
            isCarried = isCarried || (body && !body->asleep());
            if (held.joint.ends[i].isLoose) continue;
            const Pose end = body ? body->pose() * body->bodyInCenter() * held.frames[i] : held.frames[i];
            step.ends[i] = end.position;
        }
        if (!isCarried && held.restingFor >= kRopeRest) continue;
        glm::dvec3 low(1e300), high(-1e300);
        for (const RopePoint& point : held.joint.points) {
            const glm::dvec3 next = point.position + point.velocity * settings.stepSeconds;
            low = glm::min(low, glm::min(point.position, next));
            high = glm::max(high, glm::max(point.position, next));
        }
        found.clear();
        broadphase.find(low - kRopeReach, high + kRopeReach, found);
        std::sort(found.begin(), found.end(), [](const CollisionObject* a, const CollisionObject* b) { return a->number < b->number; });
        step.near = found;
        const double fastest = moveRope(held.joint.points, step, held.constraint.bends);
        held.restingFor = fastest < kRopeSlow ? held.restingFor + 1 : 0;
        ropeMotions.push_back({held.handle, held.joint.points});
    }
}

}  // namespace rubble
