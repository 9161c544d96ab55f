#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "physics/bodies/solver_body.h"
#include "physics/collision/manifold.h"
#include "physics/math/simd4.h"

namespace rubble {

/// A touched point of a round surface. It does not turn with the surface's spin about its axis: it stays where the
/// surface is nearest to the other body.
struct RoundAnchor {
    Float4 axis{};        ///< at the start of the step; 0: a sphere
    float radius = 0.0f;  ///< metres; 0: the surface is not round, and its points turn with it
    float side = 0.0f;    ///< of the contact's normal: -1 for body A, 1 for B
    /// How the point moves, with the anchor (from the centre of mass, at the start of the step), as the body turns.
    Float4 turn(const SimdMat3& rotation, const Float4& anchor, const Float4& normal) const {
        if (radius == 0.0f) return rotation * anchor;
        const Float4 from = across(normal, axis) * float4(side * radius);
        return rotation * (anchor - from) + across(normal, axis + rotation * axis) * float4(side * radius) - from;
    }

private:
    /// The unit vector across an axis that is nearest to the normal.
    static Float4 across(const Float4& normal, const Float4& axis) {
        const Float4 v = normal - axis * float4(dot(normal, axis) / std::max(dot(axis, axis), 1e-12f));
        return v * float4(1.0f / std::sqrt(std::max(dot(v, v), 1e-12f)));
    }
};
/// Those of a contact.
struct RoundAnchors {
    RoundAnchor a, b;
};

/// One contact point between the bodies A and B as the solver iterates it. Vectors are in world axes.
struct ContactConstraint {
    Float4 normal;              ///< from B to A; that of the face, with which it turns
    Float4 startNormal;         ///< at the start of the step
    Float4 tangent1, tangent2;  ///< the directions of friction
    Float4 anchorA, anchorB;    ///< from the centre of mass to the touched point, at the start of the step
    Float4 rA, rB;              ///< from the centre of mass to the point at which both get their impulses
    Float4 frictionInset;       ///< from that point to where both have friction
    Float4 angularA, angularB;  ///< r x normal: the angular part of the Jacobian
    Float4 angularChangeA;      ///< of A's angular velocity for an impulse of 1 along the normal
    Float4 angularChangeB;
    float separation;  ///< at the start of the step, metres
    float normalMass, tangentMass1, tangentMass2;
    float friction, restitution;
    float initialNormalVelocity;  ///< before the solve, m/s; negative: closing
    float normalImpulse, tangentImpulse1, tangentImpulse2;
    float totalImpulse;         ///< of the substeps so far, along the normal
    float bounceImpulse;        ///< of impacts in the step so far, N s
    bool isStatic;              ///< one body does not move
    bool isStiff;               ///< a body is load-bearing
    bool isOfB;                 ///< the touched point is a feature of B on a face of A; else one of A on a face of B
    const RoundAnchors* round;  ///< null: neither is touched as what is round
    ManifoldPoint* point;       ///< that gets the result
};

/// The constraints of a manifold.
struct PairConstraints {
    int a, b;         ///< the bodies, as indices of states; 0: the world
    size_t from, to;  ///< in the list of constraints
    int passes;       ///< over the normals in each iteration, at most
    bool isHit;       ///< closing fast
    bool isFollowed;  ///< its points are followed within the step: see updateJacobian()
    Manifold* manifold;
    /// The manifold's points.
    std::span<ManifoldPoint> points() const { return manifold->all(); }
};

/// The velocities of two bodies while their contacts are solved, in registers.
struct VelocityPair {
    /// Reads the states.
    VelocityPair(const SolverState& A, const SolverState& B)
        : vA(float4(A.v)),
          wA(float4(A.w)),
          vB(float4(B.v)),
          wB(float4(B.w)),
          inverseMassA(A.inverseMass),
          inverseMassB(B.inverseMass),
          inverseInertiaA(A.inverseInertia),
          inverseInertiaB(B.inverseInertia) {}
    /// Writes the velocities back. The world's state is not written: several threads read it.
    void store(SolverState& A, SolverState& B) const {
        if (inverseMassA != 0.0f) A.v = vec3(vA), A.w = vec3(wA);
        if (inverseMassB != 0.0f) B.v = vec3(vB), B.w = vec3(wB);
    }

    /// The relative velocity along the normal, m/s; negative: closing.
    float normalVelocity(const ContactConstraint& c) const {
        const Float4 parts = c.normal * (vA - vB) + c.angularA * wA - c.angularB * wB;
        return parts[0] + parts[1] + parts[2];
    }
    /// The velocity of A relative to B where they have friction.
    Float4 relativeVelocity(const ContactConstraint& c) const {
        return vA + cross(wA, c.rA + c.frictionInset) - vB - cross(wB, c.rB + c.frictionInset);
    }
    /// Applies an impulse (N s) along the normal to A, and its reaction to B.
    void applyNormalImpulse(const ContactConstraint& c, float impulse) {
        vA += c.normal * float4(impulse * inverseMassA);
        wA += c.angularChangeA * float4(impulse);
        vB -= c.normal * float4(impulse * inverseMassB);
        wB -= c.angularChangeB * float4(impulse);
    }
    /// Applies impulses (N s) along the two tangents to A, and their reaction to B.
    void applyFrictionImpulse(const ContactConstraint& c, float impulse1, float impulse2) {
        const Float4 impulse = c.tangent1 * float4(impulse1) + c.tangent2 * float4(impulse2);
        vA += impulse * float4(inverseMassA);
        wA += inverseInertiaA * cross(c.rA + c.frictionInset, impulse);
        vB -= impulse * float4(inverseMassB);
        wB -= inverseInertiaB * cross(c.rB + c.frictionInset, impulse);
    }

    /// Reduces the sliding at a point. impulses: the sums along the two tangents, N s; limit: of both together.
    void solveFriction(const ContactConstraint& c, float limit, float& impulse1, float& impulse2) {
        const Float4 relative = relativeVelocity(c);
        float t1 = impulse1 - c.tangentMass1 * dot(relative, c.tangent1);
        float t2 = impulse2 - c.tangentMass2 * dot(relative, c.tangent2);
        const float size2 = t1 * t1 + t2 * t2;
        if (size2 > limit * limit) {
            const float scale = limit / std::sqrt(size2);
            t1 *= scale;
            t2 *= scale;
        }
        applyFrictionImpulse(c, t1 - impulse1, t2 - impulse2);
        impulse1 = t1;
        impulse2 = t2;
    }

    Float4 vA, wA, vB, wB;  ///< world, m/s and rad/s
    float inverseMassA, inverseMassB;
    SimdMat3 inverseInertiaA, inverseInertiaB;  ///< world axes
};

/// How two bodies have moved since the step began.
struct DeltaPair {
    /// Reads the states.
    DeltaPair(const SolverState& A, const SolverState& B)
        : position(float4(A.deltaPosition - B.deltaPosition)), rotationA(A.deltaRotation), rotationB(B.deltaRotation) {}
    Float4 position;  ///< of A relative to B
    SimdMat3 rotationA, rotationB;
    /// How A's touched point moved relative to B's.
    Float4 movement(const ContactConstraint& c) const {
        if (c.round)
            return position + c.round->a.turn(rotationA, c.anchorA, c.startNormal) -
                   c.round->b.turn(rotationB, c.anchorB, c.startNormal);
        return position + rotationA * c.anchorA - rotationB * c.anchorB;
    }
    /// The separation of the touched points now, metres; negative: they overlap.
    float separation(const ContactConstraint& c) const {
        return dot(c.startNormal * float4(c.separation) + movement(c), c.normal);
    }
};

/// What the contact solver iterates over.
struct ContactSet {
    std::vector<SolverState> states;     ///< by body; 0: the world
    std::vector<PairConstraints> pairs;  ///< in the order in which they are solved
    std::vector<ContactConstraint> constraints;
    std::vector<RoundAnchors> rounds;  ///< by constraint; empty: nothing round is touched

    /// The constraints of a pair.
    std::span<ContactConstraint> of(const PairConstraints& pair) {
        return {constraints.data() + pair.from, pair.to - pair.from};
    }
    /// The state of a pair's first body.
    SolverState& stateA(const PairConstraints& pair) { return states[size_t(pair.a)]; }
    /// The state of a pair's second body.
    SolverState& stateB(const PairConstraints& pair) { return states[size_t(pair.b)]; }
};

}  // namespace rubble
