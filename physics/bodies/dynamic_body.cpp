#include "physics/bodies/dynamic_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/math/clamp_length.h"
#include "runtime/core/planted_fault.h"

namespace rubble {
namespace {

/// Of a voxel, by which a body must move to be through a wall of one: less than that, contacts take back.
constexpr double kMinPass = 0.25;

/// Whether each coordinate is a number below the limit.
bool finiteBelow(glm::dvec3 v, double limit) {
    return std::abs(v.x) < limit && std::abs(v.y) < limit && std::abs(v.z) < limit;
}

Pose inverse(const Pose& pose) {
    const glm::dquat rotation = glm::conjugate(pose.rotation);
    return {-(rotation * pose.position), rotation};
}

/// Whether an object may have another one inside.
bool mayHold(const CollisionObject& object, const CollisionObject& other) {
    const auto& parts = object.collider.parts;
    if (parts.size() != 1) return true;
    if (parts[0]->round()) return false;
    const PartSurface* surface = parts[0]->whole();
    if (!surface) return true;
    const int gap = surface->widestGap;
    return gap > 0 && (gap + 1) * parts[0]->voxelSize() >= 2.0 * other.minHalfExtent;  // one more: edges overlap
}

}  // namespace

DynamicBody::DynamicBody(const World& world, BodyHandle handle)
    : m_handle(handle), m_shapes(world.bodies().at(handle).shapes) {
    for (const ShapeHandle shape : m_shapes)
        object.collider.parts.push_back(
            std::make_unique<ColliderPart>(world.shapes().at(shape), Pose{}, world.materials()));
    object.body = object.number = handle.slot();
    object.dynamic = this;
    takeState(world);
}

void DynamicBody::takeState(const World& world) {
    const Body& body = world.bodies().at(m_handle);
    m_mass = bodyMass(world, m_handle);
    if (!(m_mass.mass > 0.0)) {  // all its materials are weightless, but only a mass can be moved
        m_mass = MassProperties{};
        m_mass.mass = 1.0;
        m_mass.principalInertia = glm::dvec3(1.0);
    }
    const double mass = std::clamp(m_mass.mass, limits::kMinMass, limits::kMaxMass);
    m_hasClampedMass = mass != m_mass.mass;
    m_mass.principalInertia *= mass / m_mass.mass;
    m_mass.mass = mass;
    m_state = {m_handle, body.pose, body.velocity, body.angularVelocity, body.asleep, body.waitsToWake};
    gravityScale = body.gravityScale;
    linearDamping = body.linearDamping, angularDamping = body.angularDamping;
    const Pose centerInBody{m_mass.center, m_mass.principalAxes};
    m_bodyInCenter = inverse(centerInBody);

    const Pose center = body.pose * centerInBody;
    motion = {};
    motion.position = center.position;
    motion.rotation = center.rotation;
    motion.velocity = body.velocity;
    motion.angularVelocity = body.angularVelocity;
    motion.inertia = m_mass.principalInertia;
    motion.inverseMass = 1.0 / m_mass.mass;

    for (size_t i = 0; i < m_shapes.size(); ++i)
        object.collider.parts[i]->setFrame(m_bodyInCenter * world.shapes().at(m_shapes[i]).local);
    object.radius = object.collider.radius();
    setPose();
    glm::dvec3 low, high;
    object.collider.bounds(low, high);
    object.minHalfExtent = 0.5 * std::min({high.x - low.x, high.y - low.y, high.z - low.z});
}

bool DynamicBody::update(const World& world, const FrameChanges& changes) {
    if (m_quarantined || world.bodies().at(m_handle).shapes != m_shapes) return false;
    for (size_t i = 0; i < m_shapes.size(); ++i)
        if (world.shapes().at(m_shapes[i]).grid.size() != object.collider.parts[i]->grid().size()) return false;
    std::vector<glm::ivec3> bricks;
    for (size_t i = 0; i < m_shapes.size(); ++i) {
        if (std::find(changes.carved.begin(), changes.carved.end(), m_shapes[i]) == changes.carved.end()) continue;
        changedBricks(changes, m_shapes[i], bricks);
        object.collider.parts[i]->update(world.shapes().at(m_shapes[i]), bricks, world.materials());
    }
    const Pose center = pose(), known = m_state.pose, frame = m_bodyInCenter;
    takeState(world);
    if (m_state.pose == known && m_bodyInCenter == frame) {  // it stays where it is: to the last bit, as frames round
        motion.position = center.position;
        motion.rotation = center.rotation;
        setPose();
    }
    isAsLoaded = false;
    forgetContacts();
    setAsleep(false);
    return true;
}

void DynamicBody::forgetMotion(const World& world) {
    if (!m_asleep) takeState(world);
    forgetContacts();
    setAsleep(m_asleep);
}

void DynamicBody::forgetContacts() {
    object.isNew = true;
    touching = false;
    held = stuckSteps = 0;
    sleepLoad = {};
}

ColliderPart* DynamicBody::partOf(ShapeHandle shape) const {
    const auto found = std::find(m_shapes.begin(), m_shapes.end(), shape);
    return found == m_shapes.end() ? nullptr : object.collider.parts[size_t(found - m_shapes.begin())].get();
}

void DynamicBody::setAsleep(bool asleep) {
    m_asleep = asleep;
    sleepersTouched.clear();
    newlyAwake = wakesLoad = true;
    pairsFound = false;
    settled = settled && asleep;
    if (!asleep) return sleepTimer.restart(pose());
    motion.velocity = motion.angularVelocity = glm::dvec3(0.0);
}

void DynamicBody::restartRest() {
    sleepTimer.restartRest(pose());
    wantsSleep = false;
    wakesLoad = true;
}

bool DynamicBody::finite() const {
    const glm::dquat& q = motion.rotation;
    constexpr double kLargest = 1e150;  // its square is a number too
    return finiteBelow(motion.position, kLargest) && finiteBelow(motion.velocity, kLargest) &&
           finiteBelow(motion.angularVelocity, kLargest) && finiteBelow({q.x, q.y, q.z}, 2.0) && std::abs(q.w) < 2.0;
}

bool DynamicBody::isFartherThan(double distance, glm::dvec3 origin) const {
    return !finiteBelow(motion.position - origin, distance);
}

bool DynamicBody::clamp(LimitCounts& counts) {
    if (isPlanted("energy-gain")) motion.velocity *= 1.002;
    const bool speed = clampLength(motion.velocity, limits::kMaxSpeed),
               spin = clampLength(motion.angularVelocity, limits::kMaxAngularSpeed);
    counts[size_t(LimitKind::Speed)] += speed;
    counts[size_t(LimitKind::Spin)] += spin;
    const bool mass = std::exchange(m_hasClampedMass, false);
    counts[size_t(LimitKind::Mass)] += mass;
    return speed || spin || mass;
}

double DynamicBody::damp(double seconds) {
    if (linearDamping == 0.0 && angularDamping == 0.0) return 0.0;
    const double before = kineticEnergy(motion);
    motion.velocity /= 1.0 + seconds * linearDamping;  // the implicit step: stable at any rate
    motion.angularVelocity /= 1.0 + seconds * angularDamping;
    return kineticEnergy(motion) - before;
}

void DynamicBody::restore() {
    const Pose center = m_state.pose * inverse(m_bodyInCenter);
    motion.position = center.position;
    motion.rotation = center.rotation;
    motion.velocity = motion.angularVelocity = glm::dvec3(0.0);
    setPose();
}

bool DynamicBody::refresh() {
    const BodyPose now{m_handle, bodyPose(), motion.velocity, motion.angularVelocity, m_asleep, waits};
    const bool differs = !(now.pose == m_state.pose && now.velocity == m_state.velocity &&
                           now.angularVelocity == m_state.angularVelocity && now.asleep == m_state.asleep &&
                           now.waitsToWake == m_state.waitsToWake);
    m_state = now;
    return differs;
}

void DynamicBody::applyImpulse(glm::dvec3 impulse, glm::dvec3 position) {
    motion.velocity += impulse * motion.inverseMass;
    motion.angularVelocity += worldInverseInertia(motion) * glm::cross(position - motion.position, impulse);
}

glm::dvec3 velocityAt(const CollisionObject& object, const glm::dvec3& point) {
    if (!object.dynamic || object.dynamic->asleep()) return glm::dvec3(0.0);
    const SolverBody& motion = object.dynamic->motion;
    return motion.velocity + glm::cross(motion.angularVelocity, point - motion.position);
}

bool mayBeInside(const CollisionObject& a, const CollisionObject& b) {
    return mayHold(a, b) || mayHold(b, a);
}

bool mayPass(const CollisionObject& a, const CollisionObject& b, double displacement) {
    if (!a.dynamic || a.dynamic->asleep() || !b.dynamic || b.dynamic->asleep()) return true;
    return displacement > (mayBeInside(a, b) ? kMinPass * std::min(a.smallestVoxel, b.smallestVoxel)
                                             : a.minHalfExtent + b.minHalfExtent);
}

}  // namespace rubble
