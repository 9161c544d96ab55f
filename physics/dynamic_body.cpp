#include "physics/dynamic_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/bullet_math.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr double kFarthest = 1e6;  ///< metres from Bullet's zero: beyond, float positions step by 6 cm
constexpr double kFastest = 1e4;   ///< m/s and rad/s
constexpr float kAngularDamping = 0.1f;

bool finiteBelow(glm::dvec3 v, double limit) {
    return std::abs(v.x) < limit && std::abs(v.y) < limit && std::abs(v.z) < limit;
}

}  // namespace

DynamicBody::DynamicBody(const World& world, BodyHandle handle, glm::dvec3 origin) : m_handle(handle), m_mass(world.bodyMass(handle)) {
    const Body& body = world.bodies().at(handle);
    if (!(m_mass.mass > 0.0)) {  // nothing but weightless materials: it must weigh something to be moved
        m_mass = MassProperties{};
        m_mass.mass = 1.0;
        m_mass.principalInertia = glm::dvec3(1.0);
    }
    m_state = {handle, body.pose, body.velocity, body.angularVelocity, body.asleep};
    m_centerInBody = {m_mass.center, m_mass.principalAxes};
    m_bodyInCenter = inverse(m_centerInBody);

    SurfaceSum surface;
    m_collider.emplace(collectBoxes(world, body, surface));
    m_inertia = toBullet(m_mass.principalInertia);
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(m_mass.mass), nullptr, m_collider->shape(), m_inertia);
    info.m_startWorldTransform = toBullet(body.pose * m_centerInBody, origin);
    const Material& material = surface.dominant(world.materials());
    info.m_friction = std::sqrt(material.friction);  // Bullet multiplies: a pair gets the geometric mean
    info.m_restitution = std::sqrt(material.restitution);
    info.m_angularDamping = kAngularDamping;
    m_rigid.emplace(info);
    m_rigid->setUserIndex(int(handle.slot()));
    m_rigid->setLinearVelocity(toBullet(body.velocity));
    m_rigid->setAngularVelocity(toBullet(body.angularVelocity));

    btVector3 low, high;
    m_collider->shape()->getAabb(btTransform::getIdentity(), low, high);
    const btVector3 size = high - low;
    m_reach = 0.5 * double(std::min({size.x(), size.y(), size.z()}));
}

std::vector<ColliderBox> DynamicBody::collectBoxes(const World& world, const Body& body, SurfaceSum& surface) const {
    std::vector<ColliderBox> boxes;
    for (const ShapeHandle shapeHandle : body.shapes) {
        const Shape& shape = world.shapes().at(shapeHandle);
        const SolidEntries solid = solidEntries(*shape.palette, world.materials());
        shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) { surface.add(*brick, *shape.palette, world.materials()); });
        std::vector<CellBox> cells = mergeGrid(shape.grid, solid);
        double voxelSize = shape.voxelSize;
        if (cells.size() > kMaxBoxes) {
            const size_t exact = cells.size();
            VoxelGrid coarse = shape.grid;
            while (cells.size() > kMaxBoxes) {
                coarse = halveGrid(coarse, solid);
                voxelSize *= 2.0;
                cells = mergeGrid(coarse, solid);
            }
            logInfo(fmt::format("physics: shape '{}' collides as {} boxes of {} m cells: exact, it would be {} (at most {})", shape.name,
                                cells.size(), voxelSize, exact, kMaxBoxes));
        }
        appendBoxes(cells, voxelSize, m_bodyInCenter * shape.local, boxes);
    }
    return boxes;
}

void DynamicBody::setAsleep(bool asleep) {
    m_asleep = asleep;
    m_rigid->setMassProps(asleep ? btScalar(0) : btScalar(m_mass.mass), asleep ? btVector3(0, 0, 0) : m_inertia);
    m_rigid->updateInertiaTensor();
    m_rigid->forceActivationState(asleep ? ISLAND_SLEEPING : ACTIVE_TAG);
    sleepersTouched.clear();
    freshlyAwake = true;
    settled = settled && asleep;
    if (!asleep) return settling.restart(m_rigid->getWorldTransform());
    m_rigid->setLinearVelocity({0, 0, 0});
    m_rigid->setAngularVelocity({0, 0, 0});
    m_rigid->clearForces();
}

bool DynamicBody::wakeInPlace() {
    if (!m_asleep || m_quarantined) return false;
    setAsleep(false);
    readd = true;
    return true;
}

bool DynamicBody::finite() const {
    const btTransform& t = m_rigid->getWorldTransform();
    bool ok = finiteBelow(fromBullet(t.getOrigin()), kFarthest) && finiteBelow(fromBullet(m_rigid->getLinearVelocity()), kFastest) &&
              finiteBelow(fromBullet(m_rigid->getAngularVelocity()), kFastest);
    for (int row = 0; row < 3; ++row) ok = ok && finiteBelow(fromBullet(t.getBasis()[row]), 2.0);
    return ok;
}

void DynamicBody::restore(glm::dvec3 origin) {
    m_rigid->setWorldTransform(toBullet(m_state.pose * m_centerInBody, origin));
    m_rigid->setInterpolationWorldTransform(m_rigid->getWorldTransform());
}

bool DynamicBody::refresh(glm::dvec3 origin) {
    const BodyPose now{m_handle, fromBullet(m_rigid->getWorldTransform(), origin) * m_bodyInCenter, fromBullet(m_rigid->getLinearVelocity()),
                       fromBullet(m_rigid->getAngularVelocity()), m_asleep};
    const bool differs = !(now.pose == m_state.pose && now.velocity == m_state.velocity && now.angularVelocity == m_state.angularVelocity &&
                           now.asleep == m_state.asleep);
    m_state = now;
    return differs;
}

}  // namespace rubble
