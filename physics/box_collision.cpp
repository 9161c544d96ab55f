#include "physics/box_collision.h"

#include <BulletCollision/CollisionDispatch/btBoxBoxDetector.h>
#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>

#include <cmath>
#include <utility>

namespace rubble {
namespace {

/// 0..5: +x -x +y -y +z -z.
int directionOf(const btVector3& normal) {
    const int axis = normal.absolute().maxAxis();
    return axis * 2 + (normal[axis] < 0 ? 1 : 0);
}

void collect(const Collider& collider, const Bounds& near, std::vector<int>& out) {
    out.clear();
    for (int i = 0; i < collider.boxCount(); ++i)
        if (near.meets(collider.bounds(i))) out.push_back(i);
}

/// Sorts what Bullet's box against box reports by direction.
struct Sorter : btDiscreteCollisionDetectorInterface::Result {
    Sorter(std::array<std::vector<BoxContact>, 6>& out, const btMatrix3x3& worldToBoxes) : contacts(out), toBoxes(worldToBoxes) {}
    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3& normal, const btVector3& point, btScalar depth) override {
        contacts[size_t(directionOf(toBoxes * normal))].push_back({normal, point, depth});
    }
    std::array<std::vector<BoxContact>, 6>& contacts;
    btMatrix3x3 toBoxes;
};

}  // namespace

void reduceContacts(std::vector<BoxContact>& contacts) {
    if (contacts.size() <= 4) return;
    const auto best = [&](size_t from, auto&& score) {
        size_t found = from;
        btScalar highest = score(contacts[from]);
        for (size_t i = from + 1; i < contacts.size(); ++i) {
            const btScalar value = score(contacts[i]);
            if (value > highest) highest = value, found = i;
        }
        std::swap(contacts[from], contacts[found]);
    };
    best(0, [](const BoxContact& c) { return -c.depth; });
    const btVector3 a = contacts[0].point, normal = contacts[0].normal;
    best(1, [&](const BoxContact& c) { return c.point.distance2(a); });
    const btVector3 side = (contacts[1].point - a).cross(normal);
    best(2, [&](const BoxContact& c) { return std::abs(side.dot(c.point - a)); });
    const btScalar sign = side.dot(contacts[2].point - a) > 0 ? btScalar(-1) : btScalar(1);
    best(3, [&](const BoxContact& c) { return sign * side.dot(c.point - a); });
    contacts.resize(4);
}

BoxCollision::~BoxCollision() {
    for (btPersistentManifold* manifold : m_manifolds)
        if (manifold) m_dispatcher->releaseManifold(manifold);
}

void BoxCollision::getAllContactManifolds(btManifoldArray& manifolds) {
    for (btPersistentManifold* manifold : m_manifolds)
        if (manifold) manifolds.push_back(manifold);
}

void BoxCollision::processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second, const btDispatcherInfo&,
                                    btManifoldResult* result) {
    const Collider& colliderFirst = Collider::of(*first->getCollisionShape());
    const Collider& colliderSecond = Collider::of(*second->getCollisionShape());
    findContacts(colliderFirst, first->getWorldTransform(), colliderSecond, second->getWorldTransform());
    for (int direction = 0; direction < 6; ++direction) {
        std::vector<BoxContact>& contacts = m_scratch.contacts[size_t(direction)];
        btPersistentManifold*& manifold = m_manifolds[size_t(direction)];
        if (!manifold && contacts.empty()) continue;
        if (!manifold) manifold = m_dispatcher->getNewManifold(first->getCollisionObject(), second->getCollisionObject());
        keepContacts(direction, *result);
        if (manifold->getNumContacts() > 0) continue;
        m_dispatcher->releaseManifold(manifold);
        manifold = nullptr;
    }
    result->setPersistentManifold(nullptr);
}

void BoxCollision::findContacts(const Collider& first, const btTransform& firstWorld, const Collider& second, const btTransform& secondWorld) {
    for (auto& contacts : m_scratch.contacts) contacts.clear();
    const btTransform secondInFirst = firstWorld.inverseTimes(secondWorld), firstInSecond = secondInFirst.inverse();
    const Bounds nearFirst = second.bounds().seenThrough(secondInFirst), nearSecond = first.bounds().seenThrough(firstInSecond);
    if (!nearFirst.meets(first.bounds()) || !nearSecond.meets(second.bounds())) return;
    collect(first, nearFirst, m_scratch.first);
    if (m_scratch.first.empty()) return;
    collect(second, nearSecond, m_scratch.second);

    Sorter sorter(m_scratch.contacts, (firstWorld.getBasis() * first.part(0).place.getBasis()).transpose());
    btDiscreteCollisionDetectorInterface::ClosestPointInput input;
    for (const int j : m_scratch.second) {
        const Collider::Part& b = second.part(j);
        const Bounds bInFirst = second.bounds(j).seenThrough(secondInFirst);
        input.m_transformB = secondWorld * b.place;
        for (const int i : m_scratch.first) {
            if (!bInFirst.meets(first.bounds(i))) continue;
            const Collider::Part& a = first.part(i);
            input.m_transformA = firstWorld * a.place;
            btBoxBoxDetector(a.box, b.box).getClosestPoints(input, sorter, nullptr);
        }
    }
}

/// Drops points that came apart, then adds this substep's: those near an old one keep its impulse (warm start).
void BoxCollision::keepContacts(int direction, btManifoldResult& result) {
    std::vector<BoxContact>& contacts = m_scratch.contacts[size_t(direction)];
    reduceContacts(contacts);
    result.setPersistentManifold(m_manifolds[size_t(direction)]);
    result.refreshContactPoints();
    for (const BoxContact& contact : contacts) result.addContactPoint(contact.normal, contact.point, contact.depth);
}

btCollisionAlgorithm* BoxCollisionFactory::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper*,
                                                                    const btCollisionObjectWrapper*) {
    return new (info.m_dispatcher1->allocateCollisionAlgorithm(int(sizeof(BoxCollision)))) BoxCollision(info, m_scratch);
}

}  // namespace rubble
