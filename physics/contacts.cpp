#include "physics/contacts.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <tuple>

#include "physics/bullet_math.h"

namespace rubble {
namespace {

btVector3 velocityAt(const btCollisionObject& object, const btVector3& point) {
    const btRigidBody* body = btRigidBody::upcast(&object);
    return body ? body->getVelocityInLocalPoint(point - body->getCenterOfMassPosition()) : btVector3(0, 0, 0);
}

}  // namespace

double ContactLog::approachSpeed(const btPersistentManifold& manifold) {
    double fastest = 0.0;
    for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const btVector3 relative =
            velocityAt(*manifold.getBody0(), point.getPositionWorldOnA()) - velocityAt(*manifold.getBody1(), point.getPositionWorldOnB());
        fastest = std::max(fastest, -double(relative.dot(point.m_normalWorldOnB)));
    }
    return fastest;
}

void ContactLog::beforeSolve(btDispatcher& dispatcher) {
    m_approach.resize(size_t(dispatcher.getNumManifolds()));
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) m_approach[size_t(i)] = approachSpeed(*dispatcher.getManifoldByIndexInternal(i));
}

void ContactLog::afterSolve(btDispatcher& dispatcher, double minSpeed) {
    const auto first = m_hits.size();
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        if (!(m_approach[size_t(i)] > minSpeed)) continue;
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        const int slot0 = manifold.getBody0()->getUserIndex(), slot1 = manifold.getBody1()->getUserIndex();
        const double sign = slot0 > slot1 ? 1.0 : -1.0;
        for (int p = 0; p < manifold.getNumContacts(); ++p) {
            const btManifoldPoint& point = manifold.getContactPoint(p);
            const double impulse = point.getAppliedImpulse();
            if (!(impulse > 0.0)) continue;
            m_hits.push_back({std::max(slot0, slot1), std::min(slot0, slot1), fromBullet(point.getPositionWorldOnB()) * impulse,
                              fromBullet(point.m_normalWorldOnB) * (impulse * sign), impulse});
        }
    }
    const auto begin = m_hits.begin() + std::ptrdiff_t(first);
    // The impulse breaks ties so that equal pairs add up in one order.
    std::sort(begin, m_hits.end(), [](const Hit& a, const Hit& b) {
        return std::tuple(a.body, a.other, a.impulse, a.position.x, a.position.y, a.position.z) <
               std::tuple(b.body, b.other, b.impulse, b.position.x, b.position.y, b.position.z);
    });
    size_t kept = first;
    for (size_t i = first; i < m_hits.size(); ++i) {
        Hit& hit = m_hits[i];
        if (kept > first && m_hits[kept - 1].body == hit.body && m_hits[kept - 1].other == hit.other) {
            Hit& sum = m_hits[kept - 1];
            sum.position += hit.position;
            sum.normal += hit.normal;
            sum.impulse += hit.impulse;
        } else {
            m_hits[kept++] = hit;
        }
    }
    m_hits.erase(m_hits.begin() + std::ptrdiff_t(kept), m_hits.end());
}

void ContactLog::impacts(double threshold, const std::vector<BodyHandle>& handles, glm::dvec3 origin, std::vector<Impact>& out) const {
    for (const Hit& hit : m_hits) {
        if (hit.impulse < threshold) continue;
        const double length = glm::length(hit.normal);
        out.push_back({handles[size_t(hit.body)], handles[size_t(hit.other)], origin + hit.position / hit.impulse,
                       length > 0.0 ? hit.normal / length : glm::dvec3(0.0, 1.0, 0.0), hit.impulse});
    }
}

}  // namespace rubble
