#pragma once
#include "physics/math/vec3.h"

// The formulas of a contact, for one (Real = float) or for eight at once (Real = Float8).

namespace rubble {

/// A contact point between the bodies A and B as the solver iterates it. Vectors are in world axes.
template <class Real>
struct Contact {
    Vec3<Real> tangent1, tangent2;  ///< the directions of friction
    Vec3<Real> anchorA, anchorB;    ///< from the centre of mass to the touched point, at the start of the step
    Vec3<Real> frictionInset;       ///< from where both get their impulses to where they have friction
    Real friction;
    Real normalImpulse, tangentImpulse1, tangentImpulse2;  ///< N s, of a substep
    Real totalImpulse;                                     ///< of the substeps and impacts so far, along the normal
    // What follows is computed by updateJacobian():
    Vec3<Real> normal;  ///< from B to A; that of the face, with which it turns
    Vec3<Real> rA, rB;  ///< from the centre of mass to the point at which both get their impulses
    Real separation;    ///< at the start of the step, along the normal as it is now, metres
    Real normalMass, tangentMass1, tangentMass2;
    // What follows is computed when the bodies have moved:
    Real currentSeparation;  ///< metres
};

/// A touched point of a round surface. It does not turn with the surface's spin about its axis: it stays where the
/// surface is nearest to the other body.
template <class Real>
struct RoundAnchor {
    Vec3<Real> axis;  ///< at the start of the step; 0: a sphere
    Real radius;      ///< metres; 0: the surface is not round, and its points turn with it
    Real side;        ///< of the contact's normal: -1 for body A, 1 for B
    /// How the point moves, with the anchor (from the centre of mass, at the start of the step), as the body turns.
    Vec3<Real> turn(const Mat3<Real>& rotation, const Vec3<Real>& anchor, const Vec3<Real>& normal) const {
        const Vec3<Real> from = across(normal, axis) * (side * radius);
        return rotation * (anchor - from) + across(normal, axis + rotation * axis) * (side * radius) - from;
    }

private:
    /// The unit vector across an axis that is nearest to the normal.
    static Vec3<Real> across(const Vec3<Real>& normal, const Vec3<Real>& axis) {
        const Vec3<Real> v = normal - axis * (dot(normal, axis) / larger(dot(axis, axis), Real(1e-12f)));
        return v * (Real(1.0f) / rootOf(larger(dot(v, v), Real(1e-12f))));
    }
};

/// A contact at the start of the step.
template <class Real>
struct ContactStart {
    Vec3<Real> normal;
    Real distance;           ///< between the touched points along the normal, metres
    Real separation;         ///< the same, but a penetration that is allowed counts as touching
    Real isOfB;              ///< 1: the touched point is a feature of B on a face of A; 0: one of A on a face of B
    RoundAnchor<Real> a, b;  ///< not set unless something round is touched
};

/// How two bodies have moved since the step began.
template <class Real>
struct MotionPair {
    Vec3<Real> position;  ///< of A relative to B
    Mat3<Real> rotationA, rotationB;
    /// How the touched point of A moved relative to its centre of mass.
    Vec3<Real> turnA(const Contact<Real>& c, const ContactStart<Real>* round) const {
        const Vec3<Real> turned = rotationA * c.anchorA;
        return round ? select(round->a.radius > Real(0.0f), round->a.turn(rotationA, c.anchorA, round->normal), turned)
                     : turned;
    }
    /// The same of B.
    Vec3<Real> turnB(const Contact<Real>& c, const ContactStart<Real>* round) const {
        const Vec3<Real> turned = rotationB * c.anchorB;
        return round ? select(round->b.radius > Real(0.0f), round->b.turn(rotationB, c.anchorB, round->normal), turned)
                     : turned;
    }
    /// The separation of the touched points now, metres; negative: they overlap. round: null: nothing round is touched.
    Real separation(const Contact<Real>& c, const ContactStart<Real>* round) const {
        return c.separation + dot(position + turnA(c, round) - turnB(c, round), c.normal);
    }
};

/// The velocities of two bodies while their contacts are solved.
template <class Real>
struct VelocityPair {
    Vec3<Real> vA, wA, vB, wB;  ///< world, m/s and rad/s
    Real inverseMassA, inverseMassB;
    SymmetricMat3<Real> inverseInertiaA, inverseInertiaB;  ///< world axes

    /// The relative velocity along the normal, m/s; negative: closing.
    Real normalVelocity(const Contact<Real>& c) const {
        return dot(c.normal, vA - vB) + dot(cross(c.rA, c.normal), wA) - dot(cross(c.rB, c.normal), wB);
    }
    /// The velocity of A relative to B where they have friction.
    Vec3<Real> relativeVelocity(const Contact<Real>& c) const {
        return vA - vB + cross(wA, c.rA + c.frictionInset) - cross(wB, c.rB + c.frictionInset);
    }
    /// Applies an impulse (N s) to A at the arm a from its centre of mass, and its reaction to B at b.
    void apply(const Vec3<Real>& impulse, const Vec3<Real>& a, const Vec3<Real>& b) {
        vA = vA + impulse * inverseMassA;
        wA = wA + inverseInertiaA * cross(a, impulse);
        vB = vB - impulse * inverseMassB;
        wB = wB - inverseInertiaB * cross(b, impulse);
    }
    /// Applies an impulse (N s) along the normal.
    void applyNormalImpulse(const Contact<Real>& c, const Real& impulse) { apply(c.normal * impulse, c.rA, c.rB); }
    /// Applies impulses (N s) along the two tangents.
    void applyFrictionImpulse(const Contact<Real>& c, const Real& impulse1, const Real& impulse2) {
        apply(c.tangent1 * impulse1 + c.tangent2 * impulse2, c.rA + c.frictionInset, c.rB + c.frictionInset);
    }
    /// Reduces the sliding at a point. impulses: the sums along the two tangents, N s; limit: of both together.
    void solveFriction(const Contact<Real>& c, const Real& limit, Real& impulse1, Real& impulse2) {
        const Vec3<Real> relative = relativeVelocity(c);
        const Real t1 = impulse1 - c.tangentMass1 * dot(relative, c.tangent1);
        const Real t2 = impulse2 - c.tangentMass2 * dot(relative, c.tangent2);
        const Real size2 = t1 * t1 + t2 * t2;
        const Real scale = select(size2 > limit * limit, limit / rootOf(size2), Real(1.0f));
        applyFrictionImpulse(c, t1 * scale - impulse1, t2 * scale - impulse2);
        impulse1 = t1 * scale;
        impulse2 = t2 * scale;
    }
    /// 1 / (J M^-1 J^T) of an impulse along the direction, at these arms.
    Real effectiveMass(const Vec3<Real>& direction, const Vec3<Real>& a, const Vec3<Real>& b) const {
        const Vec3<Real> xa = cross(a, direction), xb = cross(b, direction);
        const Real inverse =
            inverseMassA + inverseMassB + dot(xa, inverseInertiaA * xa) + dot(xb, inverseInertiaB * xb);
        return Real(1.0f) / larger(inverse, Real(1e-30f));
    }
};

/// Moves the point at which two bodies get a contact's impulses to where they meet now, and computes what follows from
/// it. The touched points of the two are apart before a hit and move on within the step; impulses at one point, that of
/// the feature, halfway to the face that it touches, keep the angular momentum. isRound: something round is touched.
template <class Real>
void updateJacobian(Contact<Real>& c, const ContactStart<Real>& start, bool isRound, const MotionPair<Real>& motion,
                    const VelocityPair<Real>& bodies) {
    const ContactStart<Real>* const round = isRound ? &start : nullptr;
    const Vec3<Real> turnA = motion.turnA(c, round), turnB = motion.turnB(c, round);
    const auto isOfB = start.isOfB > Real(0.5f);
    c.normal = start.normal + select(isOfB, motion.rotationA * start.normal, motion.rotationB * start.normal);
    if (round) c.normal = select(select(isOfB, start.a.radius, start.b.radius) > Real(0.0f), start.normal, c.normal);
    c.separation = start.separation * dot(start.normal, c.normal);
    const Vec3<Real> apart = start.normal * start.distance + motion.position + turnA - turnB;
    const Vec3<Real> half = c.normal * (Real(0.5f) * dot(apart, c.normal)), rest = apart - half;
    c.rA = c.anchorA + turnA - select(isOfB, rest, half);
    c.rB = c.anchorB + turnB + select(isOfB, half, rest);
    c.normalMass = bodies.effectiveMass(c.normal, c.rA, c.rB);
    c.tangentMass1 = bodies.effectiveMass(c.tangent1, c.rA + c.frictionInset, c.rB + c.frictionInset);
    c.tangentMass2 = bodies.effectiveMass(c.tangent2, c.rA + c.frictionInset, c.rB + c.frictionInset);
}

}  // namespace rubble
