#pragma once
#include <span>
#include <vector>

#include "physics/collision/crowd.h"
#include "physics/collision/narrowphase.h"
#include "physics/stages/physics_bodies.h"
#include "physics/stages/physics_joints.h"
#include "physics/stages/physics_settings.h"

namespace rubble {

/// The contacts of a step: broadphase, narrowphase, and the sleeping bodies that are woken by a hit.
class ContactDetection {
public:
    /// Finds the contacts of all awake bodies, and wakes what they hit hard, or bear if they have just woken.
    void find(PhysicsBodies& bodies, const PhysicsJoints& joints, const PhysicsSettings& settings, glm::dvec3 gravity);
    /// Notes in the bodies which are touching, and which sleeping bodies each touches.
    void recordTouching(PhysicsBodies& bodies) const;
    /// Keeps the impulses of contacts of which nothing is awake any more. To be called when bodies have fallen asleep.
    void keepResting() { m_narrowphase.keepResting(); }
    /// Forgets the contacts of all steps before.
    void forget() { m_narrowphase.forget(); }
    /// The manifolds of this step, sorted by the numbers of their objects.
    std::span<Manifold* const> manifolds() const { return m_narrowphase.manifolds(); }
    /// How many pairs were tested in the last step.
    size_t candidates() const { return m_narrowphase.candidates(); }
    /// See Narrowphase::bricksLeftOut().
    size_t bricksLeftOut() const { return m_narrowphase.bricksLeftOut(); }
    /// How many pairs of bodies in crowds were left out in the last step, some of them counted for both.
    size_t leftOut() const { return m_leftOut; }

private:
    /// What a hit gives to a body that it woke, or that touches sleeping ones.
    struct Push {
        glm::dvec3 velocity{0.0};  ///< about, m/s
        double mass = 0.0;         ///< kg, of it and of all that comes along from the hitter on; 0: there is none
    };
    void notePushes(double seconds);
    void notePush(const DynamicBody& body, glm::dvec3 velocity, glm::dvec3 push, const Manifold& manifold, double mass);
    bool wakeHit(PhysicsBodies& bodies, double seconds);
    glm::dvec3 pushOf(const Manifold& manifold, const DynamicBody& hitter, double seconds) const;
    /// Null: nothing has pushed it in this step.
    const Push* pushOn(const DynamicBody& body) const;

    Narrowphase m_narrowphase;
    Crowds m_crowds;
    std::vector<CollisionObject*> m_moving;  ///< whose pairs are searched
    std::vector<ObjectPair> m_pairs;
    std::vector<Push> m_pushes;      ///< of this step, by slot
    std::vector<uint32_t> m_pushed;  ///< slots of those that there are
    size_t m_leftOut = 0;
};

}  // namespace rubble
