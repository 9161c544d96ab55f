#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "physics/collision/manifold.h"
#include "physics/math/lanes.h"
#include "physics/solver/contact_math.h"

namespace rubble {

/// The contacts of two bodies.
struct PairConstraints {
    int a, b;  ///< the bodies, as indices of states; 0: the world
    Manifold* manifold;
    bool isHit = false;       ///< closing fast
    bool isFollowed = false;  ///< its points are followed within the step: see updateJacobian()
    bool isStiff = false;     ///< a body is load-bearing
    bool isElastic = false;   ///< a point bounces
    bool isWarm = false;      ///< a point has an impulse to start with
    uint32_t group = 0;       ///< where it is solved
    uint32_t lane = 0;
    float reboundSpeed = 0.0f;  ///< m/s: the largest at which a point shall part
    /// The impulses to start with, summed, on A (N s), and about the centres of mass of A and B (N m s).
    glm::vec3 impulse{0.0f}, angularImpulseA{0.0f}, angularImpulseB{0.0f};
    /// The manifold's points.
    std::span<ManifoldPoint> points() const { return manifold->all(); }
};

/// Pairs that are solved together, one a lane. They share no body but the world.
struct PairGroup {
    static constexpr uint32_t kNone = ~0u;
    int a[kLanes] = {}, b[kLanes] = {};  ///< the bodies of each pair; 0 where there is none
    uint32_t pair[kLanes];               ///< indices of pairs, or kNone
    uint32_t from = 0, count = 0;        ///< of the contacts; a lane with fewer points has empty ones at the end
    bool anyHit = false, anyFollowed = false, anyRound = false, anyTorsion = false;
    bool isSteady = false;                    ///< all of its bodies are
    Lanes isHit;                              ///< 1, or 0
    Lanes biasRate, massScale, impulseScale;  ///< see Softness
    Lanes torsionArm;      ///< metres: of a lone point, its largest torque about its normal over its normal force; or 0
    Lanes torsionImpulse;  ///< about that normal on A, N m s, of a substep
};

/// What the contact solver iterates over.
struct ContactSet {
    std::vector<SolverState> states;     ///< by body; 0: the world
    std::vector<PairConstraints> pairs;  ///< in the order of the manifolds
    std::vector<PairGroup> groups;       ///< in the order in which they are solved
    uint32_t contactCount = 0;           ///< of all groups
    std::vector<Contact<Lanes>> contacts;
    std::vector<ContactStart<Lanes>> starts;  ///< by contact

    /// The state of a pair's first body.
    SolverState& stateA(const PairConstraints& pair) { return states[size_t(pair.a)]; }
    /// The state of a pair's second body.
    SolverState& stateB(const PairConstraints& pair) { return states[size_t(pair.b)]; }
    /// A point of a pair, read from its lane.
    Contact<float> contact(const PairConstraints& pair, size_t point) const {
        Contact<float> out;
        copyLane<true>(contacts[groups[pair.group].from + point], pair.lane, out, sizeof out);
        return out;
    }
    /// Writes a point of a pair to its lane.
    void setContact(const PairConstraints& pair, size_t point, const Contact<float>& contact) {
        copyLane<false>(contacts[groups[pair.group].from + point], pair.lane, contact, sizeof contact);
    }
    /// The same, without what prepare() of ContactKernels computes.
    void beginContact(const PairConstraints& pair, size_t point, const Contact<float>& contact) {
        copyLane<false>(contacts[groups[pair.group].from + point], pair.lane, contact,
                        offsetof(Contact<float>, normal));
    }
    /// The same, of what is known of it at the start of the step.
    ContactStart<float> start(const PairConstraints& pair, size_t point) const {
        ContactStart<float> out;
        copyLane<true>(starts[groups[pair.group].from + point], pair.lane, out, sizeof out);
        return out;
    }
    /// The same; round surfaces only where the pair's group has any.
    void setStart(const PairConstraints& pair, size_t point, const ContactStart<float>& start) {
        copyLane<false>(starts[groups[pair.group].from + point], pair.lane, start,
                        isRound(pair) ? sizeof start : offsetof(ContactStart<float>, a));
    }
    /// Whether a pair touches something round.
    bool isRound(const PairConstraints& pair) const { return groups[pair.group].anyRound; }
    /// A point's separation now, metres.
    float separation(const PairConstraints& pair, size_t point, const Contact<float>& contact,
                     const MotionPair<float>& motion) const {
        if (!isRound(pair)) return motion.separation(contact, nullptr);
        const ContactStart<float> round = start(pair, point);
        return motion.separation(contact, &round);
    }

private:
    /// Copies the first bytes of a lane to or from: both are nothing but floats, in the same order.
    template <bool kRead, class Wide, class Single>
    static void copyLane(Wide& wide, uint32_t lane, Single& single, size_t bytes) {
        static_assert(sizeof(Wide) == kLanes * sizeof(Single));
        for (size_t at = 0; at < bytes; at += sizeof(float)) {
            auto* one = bytesOf(single) + at;
            auto* of = bytesOf(wide) + at * kLanes + lane * sizeof(float);
            if constexpr (kRead)
                std::memcpy(one, of, sizeof(float));
            else
                std::memcpy(of, one, sizeof(float));
        }
    }
    template <class T>
    static auto bytesOf(T& of) {
        return reinterpret_cast<std::conditional_t<std::is_const_v<T>, const char*, char*>>(&of);
    }
};

/// The same vector.
inline Vec3<float> toVec3(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
/// The same vector.
inline glm::vec3 toGlm(const Vec3<float>& v) {
    return {v.x, v.y, v.z};
}
/// The velocities of a pair's bodies.
VelocityPair<float> velocitiesOf(const SolverState& A, const SolverState& B);
/// Writes the velocities back. The world's state is not written: several threads read it.
void storeVelocities(const VelocityPair<float>& velocities, SolverState& A, SolverState& B);
/// How a pair's bodies have moved.
MotionPair<float> motionsOf(const SolverState& A, const SolverState& B);

}  // namespace rubble
