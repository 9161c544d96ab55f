#include "physics/stages/physics_joints.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/joints/rope.h"
#include "runtime/core/union_find.h"

namespace rubble {
namespace {

constexpr int kRopeRestSteps = 60;        ///< without going anywhere, after which a rope is not simulated
constexpr int kRopeMeanSteps = 8;         ///< of the mean places that are compared
constexpr double kRopeRest = 0.02;        ///< metres around where it was, within which a point goes nowhere
constexpr double kRopeMargin = 0.25;      ///< metres around a rope in which it may touch something
constexpr double kShorteningSpeed = 0.2;  ///< m/s at which a rope that was made too short pulls its ends together

/// The box that the points of a rope stay in during the step.
void boundsOf(std::span<const RopePoint> points, double seconds, glm::dvec3& low, glm::dvec3& high) {
    low = glm::dvec3(1e300), high = glm::dvec3(-1e300);
    for (const RopePoint& point : points) {
        const glm::dvec3 next = point.position + point.velocity * seconds;
        low = glm::min(low, glm::min(point.position, next));
        high = glm::max(high, glm::max(point.position, next));
    }
}

/// Where the ends of a rope are, world; none: it hangs free.
std::array<std::optional<glm::dvec3>, 2> endsOf(const JointProxy& rope, const PhysicsBodies& bodies) {
    std::array<std::optional<glm::dvec3>, 2> ends;
    for (size_t i = 0; i < 2; ++i) {
        if (rope.joint.ends[i].isFree) continue;
        const DynamicBody* body = rope.bodies[i] ? bodies.dynamicAt(rope.bodies[i].slot()) : nullptr;
        ends[i] = (body ? body->pose() * body->bodyInCenter() * rope.frames[i] : rope.frames[i]).position;
    }
    return ends;
}

/// Moves bends along with the bodies that a rope lies on.
void carryBends(std::vector<RopeBend>& bends, const PhysicsBodies& bodies) {
    for (RopeBend& bend : bends)
        if (const DynamicBody* body = bodies.find(bend.body)) bend.position = body->pose().transformPoint(bend.inBody);
}

/// Takes from the bends those on the bodies at the ends next to them, which move with these bodies: a rope pulls a body
/// from where it leaves it.
void leaveBodies(JointProxy& rope) {
    std::vector<RopeBend>& bends = rope.bends;
    const auto isOn = [&](const RopeBend& bend, size_t end) { return bend.body && bend.body == rope.bodies[end]; };
    size_t first = 0, last = bends.size();
    while (first < last && isOn(bends[first], 0)) ++first;
    while (last > first && isOn(bends[last - 1], 1)) --last;
    rope.leaves[0] = first > 0 ? std::optional(bends[first - 1].inBody) : std::nullopt;
    rope.leaves[1] = last < bends.size() ? std::optional(bends[last].inBody) : std::nullopt;
    bends.erase(bends.begin() + ptrdiff_t(last), bends.end());
    bends.erase(bends.begin(), bends.begin() + ptrdiff_t(first));
}

/// Where the rope leaves what is at its ends, world. ends: of the rope.
std::array<glm::dvec3, 2> leavesOf(const JointProxy& rope, const std::array<glm::dvec3, 2>& ends,
                                   const PhysicsBodies& bodies) {
    std::array<glm::dvec3, 2> leaves = ends;
    for (size_t i = 0; i < 2; ++i)
        if (const DynamicBody* body = rope.leaves[i] ? bodies.find(rope.bodies[i]) : nullptr)
            leaves[i] = body->pose().transformPoint(*rope.leaves[i]);
    return leaves;
}

/// Hands the new path over all of its bends to the solver. slack: of the last path.
void setPath(JointProxy& rope, const std::array<glm::dvec3, 2>& ends, double slack, double length, double seconds,
             const PhysicsBodies& bodies) {
    const double measured = length - pathLength(ends, rope.bends);
    leaveBodies(rope);
    rope.constraint.bendPoints.clear();
    for (const RopeBend& bend : rope.bends) rope.constraint.bendPoints.push_back(bend.position);
    rope.constraint.ropeLength =
        pathLength(leavesOf(rope, ends, bodies), rope.bends) + slackAfter(slack, measured, seconds);
}

/// The speed at which a rope's length changes in a step, m/s; 0 for other joints. Takes it out of what is to be wound.
double windingSpeed(JointProxy& rope, double seconds) {
    const double excess = std::min(rope.excess, kShorteningSpeed * seconds);
    const double change = rope.wound - excess;
    rope.excess -= excess;
    rope.wound = 0.0;
    return change / seconds;
}

/// Keeps what a joint's old form knew: the impulses with which the next step starts, and the path of a rope.
void takeOver(JointProxy& joint, const JointProxy& old) {
    if (joint.joint.kind != old.joint.kind) return;
    const Joint* const now = joint.constraint.joint;
    joint.constraint = old.constraint;
    joint.constraint.joint = now;
    if (joint.joint.kind != JointKind::Rope) return;
    if (joint.joint.points.size() != old.joint.points.size() || joint.bodies != old.bodies)
        joint.constraint = {.joint = now, .handle = joint.handle};
    joint.bends = old.bends;
    if (joint.bodies == old.bodies) joint.leaves = old.leaves;
    joint.excess = old.excess;
    joint.wound = old.wound + joint.joint.rope.length - old.joint.rope.length;
}

/// Counts the steps in which a rope went nowhere. Its points are compared by means over some steps: one that is caught
/// between bodies may go to and fro for ever, by more than it would within kRopeRest.
void countRest(JointProxy& rope) {
    const std::vector<RopePoint>& points = rope.joint.points;
    std::vector<glm::dvec3>& sums = rope.restSums;
    if (rope.restSteps == 0) rope.restPoints.clear();
    if (rope.restSteps % kRopeMeanSteps == 0) sums.assign(points.size(), glm::dvec3(0.0));
    for (size_t i = 0; i < points.size(); ++i) sums[i] += points[i].position;
    if (++rope.restSteps % kRopeMeanSteps != 0) return;
    bool isThere = rope.restPoints.size() == points.size();
    for (size_t i = 0; i < points.size(); ++i) {
        sums[i] /= double(kRopeMeanSteps);
        isThere = isThere && glm::distance(sums[i], rope.restPoints[i]) < kRopeRest;
    }
    if (isThere) return;
    rope.restPoints.swap(sums);
    rope.restSteps = kRopeMeanSteps;
}

/// Takes the speed of a rope that rests. Returns whether it had any.
bool stop(JointProxy& rope) {
    bool had = false;
    for (RopePoint& point : rope.joint.points)
        had = std::exchange(point.velocity, glm::dvec3(0.0)) != glm::dvec3(0.0) || had;
    return had;
}

/// Forgets what the last steps have left, impulses and the path of a rope: undo or a host has put a body elsewhere.
void forgetMotion(JointProxy& joint) {
    joint.restSteps = 0;
    joint.bends.clear();
    joint.leaves = {};
    joint.wound = joint.excess = 0.0;
    joint.constraint = {.joint = &joint.joint, .handle = joint.handle};
}

}  // namespace

std::unique_ptr<JointProxy> PhysicsJoints::destroy(uint32_t slot, PhysicsBodies& bodies) {
    std::unique_ptr<JointProxy> proxy = m_table.remove(slot);
    if (!proxy) return nullptr;
    for (const BodyHandle handle : proxy->bodies)
        if (DynamicBody* body = bodies.find(handle)) bodies.wake(*body);
    return proxy;
}

void PhysicsJoints::create(const World& world, JointHandle handle, PhysicsBodies& bodies) {
    const Joint* joint = world.joints().find(handle);
    if (!joint) return;
    const bool isRope = joint->kind == JointKind::Rope;
    auto proxy = std::make_unique<JointProxy>();
    proxy->handle = handle;
    proxy->joint = *joint;
    for (size_t i = 0; i < 2; ++i) {
        const JointEnd& end = joint->ends[i];
        proxy->frames[i] = jointToWorld(world, end);
        const Shape* shape = world.shapes().find(end.shape);
        if (!shape) continue;
        const bool isStatic = world.bodies().at(shape->body).isStatic;
        if (!isRope) proxy->objects[i] = isStatic ? kStaticObject | end.shape.slot() : shape->body.slot();
        if (isStatic) continue;
        proxy->bodies[i] = shape->body;
        proxy->frames[i] = shape->local * end.frame;
    }
    if (proxy->bodies[0] == proxy->bodies[1] && !isRope) return;  // it joins nothing: one body, or two static ones
    proxy->constraint.joint = &proxy->joint;
    proxy->constraint.handle = handle;
    const JointProxy& added = m_table.add(std::move(proxy));
    for (const BodyHandle body : added.bodies)
        if (DynamicBody* dynamic = body && added.isMotorDriven() ? bodies.dynamicAt(body.slot()) : nullptr)
            bodies.wake(*dynamic);
}

void PhysicsJoints::recreate(const World& world, JointHandle handle, PhysicsBodies& bodies) {
    const std::unique_ptr<JointProxy> old = destroy(handle.slot(), bodies);
    create(world, handle, bodies);
    JointProxy* proxy = m_table.at(handle.slot());
    if (!proxy) return;
    if (old && old->handle == handle) takeOver(*proxy, *old);
    for (const BodyHandle body : proxy->bodies)
        if (DynamicBody* dynamic = body ? bodies.dynamicAt(body.slot()) : nullptr) bodies.wake(*dynamic);
}

void PhysicsJoints::apply(const FrameChanges& changes, const World& world, PhysicsBodies& bodies) {
    for (const JointBroken& broken : changes.jointsBroken) destroy(broken.joint.slot(), bodies);
    for (const JointHandle handle : changes.jointsCreated) recreate(world, handle, bodies);
    for (const JointMoved& moved : changes.jointsMoved) recreate(world, moved.joint, bodies);
    for (const JointHandle handle : changes.jointsChanged) recreate(world, handle, bodies);
    forgetMotion(changes, bodies);
    if (!changes.carved.empty() || !changes.shapesDestroyed.empty())
        for (const uint32_t rope : m_table.ropes()) m_table.at(rope)->restSteps = 0;
}

/// Of joints whose body a host has put elsewhere. After an undo or redo also of those that it has changed, or whose
/// body it has changed, and of those on bodies that are awake.
void PhysicsJoints::forgetMotion(const FrameChanges& changes, const PhysicsBodies& bodies) {
    const auto forget = [&](uint32_t slot) {
        if (JointProxy* joint = m_table.at(slot)) rubble::forgetMotion(*joint);
    };
    const auto forgetJointsOf = [&](BodyHandle body) {
        for (const uint32_t joint : m_table.of(body.slot())) forget(joint);
    };
    for (const BodyHandle handle : changes.teleported) {
        const DynamicBody* body = bodies.find(handle);
        if (changes.isRestored || !body || body->isPlaced) forgetJointsOf(handle);
    }
    if (!changes.isRestored) return;
    for (const BodyHandle body : changes.bodiesCreated) forgetJointsOf(body);
    for (const uint32_t slot : bodies.awake()) forgetJointsOf(bodies.handles()[slot]);
    for (const JointHandle joint : changes.jointsChanged) forget(joint.slot());
}

void PhysicsJoints::begin() {
    m_broken.clear();
    m_ropeMotions.clear();
}

void PhysicsJoints::wakeJointed(PhysicsBodies& bodies) const {
    if (m_table.empty()) return;
    std::vector<uint32_t> open(bodies.awake());
    while (!open.empty()) {
        const uint32_t slot = open.back();
        open.pop_back();
        for (const uint32_t joint : m_table.of(slot))
            for (const BodyHandle other : m_table.at(joint)->bodies) {
                DynamicBody* body = other ? bodies.dynamicAt(other.slot()) : nullptr;
                if (!body || !body->asleep() || body->quarantined()) continue;
                bodies.wake(*body);
                open.push_back(other.slot());
            }
    }
}

std::span<JointConstraint* const> PhysicsJoints::gather(PhysicsBodies& bodies, double seconds) {
    findActive(bodies, seconds);
    const std::span<JointConstraint> constraints = m_constraints.gather(bodies);
    if (constraints.empty()) return m_active;
    m_solved = m_active;
    for (JointConstraint& constraint : constraints) m_solved.push_back(&constraint);
    return m_solved;
}

void PhysicsJoints::findActive(PhysicsBodies& bodies, double seconds) {
    m_active.clear();
    if (m_table.empty()) return;
    std::vector<uint32_t> slots;
    for (const uint32_t body : bodies.awake())
        for (const uint32_t joint : m_table.of(body)) slots.push_back(joint);
    std::sort(slots.begin(), slots.end());
    slots.erase(std::unique(slots.begin(), slots.end()), slots.end());
    for (const uint32_t slot : slots) {
        JointProxy& proxy = *m_table.at(slot);
        JointConstraint& c = proxy.constraint;
        bool isValid = !proxy.joint.ends[0].isFree && !proxy.joint.ends[1].isFree;
        if (isValid && proxy.joint.kind == JointKind::Rope && std::isinf(c.ropeLength)) findPath(proxy, bodies);
        c.ropeSpeed = windingSpeed(proxy, seconds);
        for (size_t i = 0; i < 2; ++i) {
            c.bodies[i] = 0;
            c.frames[i] = proxy.frames[i];
            if (!proxy.bodies[i]) continue;
            const DynamicBody* body = bodies.find(proxy.bodies[i]);
            isValid = isValid && body && !body->quarantined();
            if (!isValid) break;
            Pose frame = body->bodyInCenter() * proxy.frames[i];
            if (proxy.leaves[i]) frame.position = *proxy.leaves[i];
            if (body->asleep()) {  // it does not move in this step
                c.frames[i] = body->pose() * frame;
                continue;
            }
            c.bodies[i] = body->solverIndex;
            c.frames[i] = frame;
        }
        if (!isValid) continue;
        m_active.push_back(&c);
    }
}

double PhysicsJoints::work() const {
    double sum = 0.0;
    for (const JointConstraint* c : m_active) sum += c->work;
    return sum + m_constraints.work();
}

void PhysicsJoints::findBroken() {
    for (const JointConstraint* c : m_active) {
        const Joint& joint = *c->joint;
        const bool isTooMuch =
            (joint.breakForce > 0.0 && glm::length(c->force) > joint.breakForce) ||
            (joint.breakTorque > 0.0 && glm::length(c->torque) > joint.breakTorque) ||
            (joint.kind == JointKind::Rope && joint.rope.strength > 0.0 && glm::length(c->force) > joint.rope.strength);
        if (isTooMuch) m_broken.push_back(c->handle);
    }
}

void PhysicsJoints::putToSleep(PhysicsBodies& bodies, size_t solverBodies) const {
    if (m_active.empty()) return;
    UnionFind<> groups(solverBodies);
    std::vector<bool> isAwake(solverBodies, false);  // by a group's root
    for (const JointConstraint* c : m_active) {
        const auto [a, b] = c->bodies;
        if (a && b) groups.unite(uint32_t(a), uint32_t(b));
    }
    const auto rootOf = [&](int body) { return groups.root(uint32_t(body)); };
    for (const JointConstraint* c : m_active)
        if (m_table.at(c->handle.slot())->isMotorDriven()) isAwake[rootOf(std::max(c->bodies[0], c->bodies[1]))] = true;
    for (const uint32_t slot : bodies.awake())
        if (!bodies.at(slot).wantsSleep) isAwake[rootOf(bodies.at(slot).solverIndex)] = true;
    for (const uint32_t slot : bodies.awake()) {
        DynamicBody& body = bodies.at(slot);
        if (body.asleep() || !body.wantsSleep || !isJointed(slot) || isAwake[rootOf(body.solverIndex)]) continue;
        bodies.putToSleep(body);
    }
}

RopeStep PhysicsJoints::ropeStep(const JointProxy& rope, PhysicsBodies& bodies, double seconds) {
    RopeStep step{.length = rope.joint.rope.length,
                  .radius = rope.joint.rope.radius,
                  .ends = endsOf(rope, bodies),
                  .seconds = seconds};
    glm::dvec3 low, high;
    boundsOf(rope.joint.points, seconds, low, high);
    step.nearby = bodies.objectsIn(low - kRopeMargin, high + kRopeMargin);
    return step;
}

/// A rope without stretch that is shorter than the distance of its ends begins with that, and winds the excess up.
void PhysicsJoints::findPath(JointProxy& rope, PhysicsBodies& bodies) {
    const RopeStep step = ropeStep(rope, bodies, 0.0);
    findBends(rope.joint.points, step, rope.bends);
    const std::array<glm::dvec3, 2> ends = {*step.ends[0], *step.ends[1]};
    rope.wound = 0.0;
    rope.excess = rope.joint.rope.stretch > 0.0 ? 0.0 : std::max(glm::distance(ends[0], ends[1]) - step.length, 0.0);
    setPath(rope, ends, rope.constraint.ropeLength, step.length + rope.excess, 0.0, bodies);
}

void PhysicsJoints::moveRopes(PhysicsBodies& bodies, glm::dvec3 gravity, double seconds) {
    for (const uint32_t slot : m_table.ropes()) {
        JointProxy& rope = *m_table.at(slot);
        bool isCarried = false;
        for (const BodyHandle handle : rope.bodies) {
            const DynamicBody* body = handle ? bodies.dynamicAt(handle.slot()) : nullptr;
            isCarried = isCarried || (body && !body->asleep());
        }
        if (!isCarried && rope.restSteps > kRopeRestSteps) {
            if (stop(rope)) m_ropeMotions.push_back({rope.handle, rope.joint.points});
            continue;
        }
        RopeStep step = ropeStep(rope, bodies, seconds);
        step.gravity = gravity;
        carryBends(rope.bends, bodies);
        const bool isHeld = step.ends[0] && step.ends[1];
        const std::array<glm::dvec3, 2> ends = {step.ends[0].value_or(glm::dvec3(0.0)),
                                                step.ends[1].value_or(glm::dvec3(0.0))};
        const double slack = rope.constraint.ropeLength - pathLength(leavesOf(rope, ends, bodies), rope.bends);
        moveRope(rope.joint.points, step, rope.bends);
        if (isHeld) setPath(rope, ends, slack, step.length + rope.excess, seconds, bodies);
        countRest(rope);
        m_ropeMotions.push_back({rope.handle, rope.joint.points});
    }
}

}  // namespace rubble
