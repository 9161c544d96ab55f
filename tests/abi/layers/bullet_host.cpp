#include "tests/abi/layers/bullet_host.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

constexpr btScalar kStep = btScalar(1.0 / 60.0);
constexpr double kMinImpulse = 20.0, kMinSpeed = 0.5;  // N s, m/s: softer hits break nothing

btVector3 vectorOf(const double (&v)[3]) {
    return {btScalar(v[0]), btScalar(v[1]), btScalar(v[2])};
}

btTransform transformOf(const double (&position)[3], const double (&rotation)[4]) {
    return btTransform(
        btQuaternion(btScalar(rotation[0]), btScalar(rotation[1]), btScalar(rotation[2]), btScalar(rotation[3])),
        vectorOf(position));
}

void copy(const btVector3& from, double (&to)[3]) {
    for (int i = 0; i < 3; ++i) to[i] = double(from[i]);
}

/// All rows that a function of the table lists.
template <class Row, class List>
std::vector<Row> rowsOf(List&& list) {
    uint32_t count = 0;
    EXPECT_EQ(list(static_cast<Row*>(nullptr), 0u, &count), RUBBLE_OK);
    std::vector<Row> rows(count);
    EXPECT_EQ(list(rows.data(), count, &count), RUBBLE_OK);
    return rows;
}

}  // namespace

BulletHost::BulletHost(const rubble_api& api, rubble_world world) : m_api(api), m_world(world) {
    m_floor.setFriction(btScalar(0.8));
    m_bullet.addRigidBody(&m_floor);
}

BulletHost::~BulletHost() {
    if (m_ball) m_bullet.removeRigidBody(m_ball.get());
    for (auto& [handle, rigid] : m_bodies) m_bullet.removeRigidBody(rigid.body.get());
    m_bullet.removeRigidBody(&m_floor);
}

void BulletHost::frame() {
    EXPECT_EQ(m_api.step(m_world), RUBBLE_OK) << m_api.get_last_error();
    follow();
    pushBodies();
    for (auto& [handle, rigid] : m_bodies)
        rigid.velocity = rigid.body->getLinearVelocity(), rigid.spin = rigid.body->getAngularVelocity();
    if (m_ball) m_ballVelocity = m_ball->getLinearVelocity();
    m_bullet.stepSimulation(kStep, 0);
    handBack();
    reportImpacts();
}

void BulletHost::follow() {
    rubble_events events = {};
    events.struct_size = sizeof events;
    EXPECT_EQ(m_api.get_events(m_world, &events), RUBBLE_OK);
    for (uint32_t i = 0; i < events.bodies_destroyed_count; ++i) remove(events.bodies_destroyed[i]);
    const auto list = [&](rubble_rigid_body* out, uint32_t capacity, uint32_t* count) {
        return m_api.get_rigid_bodies(m_world, RUBBLE_BODIES_CHANGED, out, capacity, count);
    };
    for (const rubble_rigid_body& row : rowsOf<rubble_rigid_body>(list)) {
        remove(row.body);
        make(row);
    }
}

void BulletHost::remove(rubble_body body) {
    const auto found = m_bodies.find(body);
    if (found == m_bodies.end()) return;
    m_bullet.removeRigidBody(found->second.body.get());
    m_bodies.erase(found);
}

void BulletHost::make(const rubble_rigid_body& row) {
    const auto list = [&](rubble_body_box* out, uint32_t capacity, uint32_t* count) {
        return m_api.get_body_boxes(m_world, row.body, out, capacity, count);
    };
    const std::vector<rubble_body_box> boxes = rowsOf<rubble_body_box>(list);
    if (boxes.empty()) return;
    Rigid rigid;
    rigid.centerInBody = transformOf(row.center, row.inertia_rotation);
    rigid.compound = std::make_unique<btCompoundShape>();
    for (const rubble_body_box& box : boxes) {
        rigid.boxes.push_back(std::make_unique<btBoxShape>(vectorOf(box.half_size)));
        rigid.boxes.back()->setMargin(btScalar(0.01));
        rigid.compound->addChildShape(rigid.centerInBody.inverse() * transformOf(box.center, box.rotation),
                                      rigid.boxes.back().get());
    }
    const bool isStatic = row.flags & RUBBLE_BODY_STATIC;
    btRigidBody::btRigidBodyConstructionInfo info(isStatic ? 0 : btScalar(row.mass), nullptr, rigid.compound.get(),
                                                  isStatic ? btVector3(0, 0, 0) : vectorOf(row.inertia));
    info.m_startWorldTransform = transformOf(row.position, row.rotation) * rigid.centerInBody;
    info.m_friction = btScalar(0.6);
    rigid.body = std::make_unique<btRigidBody>(info);
    rigid.body->setLinearVelocity(vectorOf(row.velocity));
    rigid.body->setAngularVelocity(vectorOf(row.angular_velocity));
    m_bullet.addRigidBody(rigid.body.get());
    m_bodies.emplace(row.body, std::move(rigid));
}

void BulletHost::pushBodies() {
    const auto list = [&](rubble_body_impulse* out, uint32_t capacity, uint32_t* count) {
        return m_api.get_body_impulses(m_world, out, capacity, count);
    };
    for (const rubble_body_impulse& row : rowsOf<rubble_body_impulse>(list)) {
        btRigidBody& body = *m_bodies.at(row.body).body;
        body.activate();
        body.applyImpulse(vectorOf(row.impulse), vectorOf(row.position) - body.getCenterOfMassPosition());
    }
}

void BulletHost::handBack() {
    std::vector<rubble_body_state> states;
    for (const auto& [handle, rigid] : m_bodies) {
        if (rigid.body->isStaticObject()) continue;
        const btTransform pose = rigid.body->getCenterOfMassTransform() * rigid.centerInBody.inverse();
        const btQuaternion rotation = pose.getRotation();
        rubble_body_state state = {};
        state.body = handle;
        copy(pose.getOrigin(), state.position);
        for (int i = 0; i < 4; ++i) state.rotation[i] = double(rotation[i]);
        copy(rigid.body->getLinearVelocity(), state.velocity);
        copy(rigid.body->getAngularVelocity(), state.angular_velocity);
        if (!rigid.body->isActive()) state.flags = RUBBLE_BODY_ASLEEP;
        states.push_back(state);
    }
    EXPECT_EQ(m_api.set_body_states(m_world, states.data(), uint32_t(states.size())), RUBBLE_OK)
        << m_api.get_last_error();
}

void BulletHost::reportImpacts() {
    std::map<const btCollisionObject*, std::pair<rubble_body, const Rigid*>> handles;
    for (const auto& [handle, rigid] : m_bodies) handles[rigid.body.get()] = {handle, &rigid};
    const auto velocityAt = [&](const btCollisionObject* object, const btVector3& point) {
        if (object == m_ball.get()) return m_ballVelocity;
        const auto found = handles.find(object);
        if (found == handles.end()) return btVector3(0, 0, 0);
        const Rigid& rigid = *found->second.second;
        return rigid.velocity + rigid.spin.cross(point - rigid.body->getCenterOfMassPosition());
    };
    std::vector<rubble_impact> rows;
    for (int i = 0; i < m_dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *m_dispatcher.getManifoldByIndexInternal(i);
        rubble_impact row = {};
        btVector3 place(0, 0, 0), normal(0, 0, 0);
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            const btManifoldPoint& point = manifold.getContactPoint(p);
            row.impulse += double(point.getAppliedImpulse());
            place += point.getPositionWorldOnB() * point.getAppliedImpulse();
            normal += point.m_normalWorldOnB * point.getAppliedImpulse();
        }
        if (row.impulse < kMinImpulse || normal.length2() <= 0) continue;
        place /= btScalar(row.impulse);
        normal.normalize();
        row.speed =
            -double(normal.dot(velocityAt(manifold.getBody0(), place) - velocityAt(manifold.getBody1(), place)));
        if (row.speed < kMinSpeed) continue;
        const auto handleOf = [&](const btCollisionObject* object) {
            const auto found = handles.find(object);
            return found == handles.end() ? rubble_body(0) : found->second.first;
        };
        row.body = handleOf(manifold.getBody0()), row.other = handleOf(manifold.getBody1());
        if (!row.body && !row.other) continue;
        copy(place, row.position), copy(normal, row.normal);
        floorImpacts += manifold.getBody0() == &m_floor || manifold.getBody1() == &m_floor;
        rows.push_back(row);
    }
    impacts += int(rows.size());
    EXPECT_EQ(m_api.report_impacts(m_world, rows.data(), uint32_t(rows.size())), RUBBLE_OK) << m_api.get_last_error();
}

void BulletHost::shoot(btVector3 from, btVector3 velocity, btScalar radius, btScalar mass) {
    m_ballShape = std::make_unique<btSphereShape>(radius);
    btVector3 inertia;
    m_ballShape->calculateLocalInertia(mass, inertia);
    m_ball = std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, m_ballShape.get(), inertia));
    m_ball->setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), from));
    m_ball->setLinearVelocity(velocity);
    m_bullet.addRigidBody(m_ball.get());
}

double BulletHost::highestSpeed() const {
    double highest = 0.0;
    for (const auto& [handle, rigid] : m_bodies)
        if (rigid.body->isActive()) highest = std::max(highest, double(rigid.body->getLinearVelocity().length()));
    return highest;
}

int BulletHost::dynamicBodies() const {
    int count = 0;
    for (const auto& [handle, rigid] : m_bodies) count += !rigid.body->isStaticObject();
    return count;
}

double BulletHost::lowestPoint() const {
    double lowest = 1e9;
    for (const auto& [handle, rigid] : m_bodies) {
        for (int i = 0; i < rigid.compound->getNumChildShapes(); ++i) {
            btVector3 low, high;
            rigid.compound->getChildShape(i)->getAabb(
                rigid.body->getCenterOfMassTransform() * rigid.compound->getChildTransform(i), low, high);
            lowest = std::min(lowest, double(low.y()));
        }
    }
    return lowest;
}

}  // namespace rubble
