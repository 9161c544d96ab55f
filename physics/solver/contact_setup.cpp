#include "physics/solver/contact_setup.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// Closing speeds, m/s, from which a pair's normals are solved in several passes, and how many.
constexpr float kHitSpeed = 1.0f, kFastSpeed = 20.0f;
constexpr int kHitPasses = 2, kFastPasses = 8;
constexpr float kSameFace = 0.9f;         ///< cosine between normals that belong to one face
constexpr float kMinSupportSlope = 0.3f;  ///< vertical part of a normal above which one body lies on the other
/// m/s that the warm start may give a body. Balanced impulses cancel.
constexpr float kMaxWarmStartSpeed = 4.0f;
constexpr int kRejectionRounds = 4;  ///< in which the rejection spreads to neighbours that become unbalanced by it

/// Two unit vectors across the normal. t1 comes from two of its components; the threshold, about 1 / sqrt(3), sees to
/// it that these are not both small.
void tangentsOf(const glm::vec3& n, glm::vec3& t1, glm::vec3& t2) {
    t1 = std::abs(n.x) > 0.57f ? glm::vec3(n.y, -n.x, 0.0f) : glm::vec3(0.0f, n.z, -n.y);
    t1 /= std::sqrt(glm::dot(t1, t1));
    t2 = glm::cross(n, t1);
}

/// Against tunnelling by rotation. Two bodies that meet fast could turn around the few points that touch, past each
/// other. So their inscribed spheres, of the radius minHalfExtent about the centres of mass, may not pass the plane in
/// which the bodies meet, however they tumble. This is one more constraint, without leverage.
void addInscribedSphere(ContactSet& set, PairConstraints& pair, const ContactConstraint& fastest) {
    const SolverState &A = set.stateA(pair), &B = set.stateB(pair);
    ContactConstraint sphere = fastest;
    // The smallest separation of all points of the face: the fastest may be a point that a spin brings in from above.
    sphere.separation = 1e9f;
    for (const ContactConstraint& c : set.of(pair)) {
        if (dot(c.normal, sphere.normal) < kSameFace) continue;
        const float overA = pair.a ? std::max(0.0f, -dot(c.rA, c.normal) - A.minHalfExtent) : 0.0f;
        const float overB = pair.b ? std::max(0.0f, dot(c.rB, c.normal) - B.minHalfExtent) : 0.0f;
        sphere.separation = std::min(sphere.separation, c.separation + overA + overB);
    }
    sphere.rA = sphere.rB = sphere.angularA = sphere.angularB = sphere.angularChangeA = sphere.angularChangeB =
        float4(0.0f);
    sphere.normalMass = 1.0f / (A.inverseMass + B.inverseMass);
    sphere.friction = sphere.restitution = 0.0f;
    sphere.normalImpulse = sphere.tangentImpulse1 = sphere.tangentImpulse2 = 0.0f;
    sphere.isInscribedSphere = true;
    set.constraints[pair.to++] = sphere;
}

/// All but the separation. rA, rB: from the centres of mass to where each body is touched.
void fillConstraint(ContactConstraint& c, ManifoldPoint& point, const SolverState& A, const SolverState& B,
                    const glm::vec3& rA, const glm::vec3& rB) {
    glm::vec3 tangent1, tangent2;
    tangentsOf(point.normal, tangent1, tangent2);
    const auto effectiveMass = [&](const glm::vec3& d) {
        const glm::vec3 xa = glm::cross(rA, d), xb = glm::cross(rB, d);
        const float k =
            A.inverseMass + B.inverseMass + glm::dot(xa, A.inverseInertia * xa) + glm::dot(xb, B.inverseInertia * xb);
        return k > 0.0f ? 1.0f / k : 0.0f;
    };
    c.normal = float4(point.normal), c.tangent1 = float4(tangent1), c.tangent2 = float4(tangent2);
    c.rA = float4(rA), c.rB = float4(rB);
    c.angularA = cross(c.rA, c.normal), c.angularB = cross(c.rB, c.normal);
    c.angularChangeA = float4(A.inverseInertia * vec3(c.angularA));
    c.angularChangeB = float4(B.inverseInertia * vec3(c.angularB));
    c.normalMass = effectiveMass(point.normal);
    c.tangentMass1 = effectiveMass(tangent1);
    c.tangentMass2 = effectiveMass(tangent2);
    c.friction = point.friction;
    c.restitution = point.restitution;
    c.initialNormalVelocity = VelocityPair(A, B).normalVelocity(c);
    c.normalImpulse = point.normalImpulse;
    c.tangentImpulse1 = glm::dot(point.frictionImpulse, tangent1);
    c.tangentImpulse2 = glm::dot(point.frictionImpulse, tangent2);
    c.totalImpulse = c.maxImpulse = c.bounceImpulse = 0.0f;
    c.isStiff = c.isInscribedSphere = false;
    c.isStatic = A.inverseMass == 0.0f || B.inverseMass == 0.0f;
    c.point = &point;
}

}  // namespace

void prepareStates(ContactSet& set, std::span<const SolverBody> bodies) {
    set.states.assign(bodies.size(), {});
    for (size_t i = 1; i < bodies.size(); ++i) {
        SolverState& state = set.states[i];
        state.v = glm::vec3(bodies[i].velocity);
        state.w = glm::vec3(bodies[i].angularVelocity);
        state.inverseMass = float(bodies[i].inverseMass);
        state.minHalfExtent = float(bodies[i].minHalfExtent);
        state.inverseInertia = glm::mat3(worldInverseInertia(bodies[i]));
    }
}

void preparePair(ContactSet& set, PairConstraints& pair, std::span<const SolverBody> bodies, const glm::vec3& up,
                 float seconds) {
    const int a = pair.a, b = pair.b;
    const SolverState &A = set.stateA(pair), &B = set.stateB(pair);
    const glm::vec3 originA = glm::vec3(pair.manifold->origin - bodies[size_t(a)].position);
    const glm::vec3 originB = glm::vec3(pair.manifold->origin - bodies[size_t(b)].position);
    size_t fastest = pair.from, at = pair.from;
    // m/s, of a point or of the bodies as a whole: a spinning body may come while the points that touch recede.
    float closing = 0.0f;
    for (ManifoldPoint& point : pair.points()) {
        // Before a fast hit the two touched points are far apart.
        const glm::vec3 half = point.normal * (0.5f * point.separation);
        const glm::vec3 rA = a ? originA + point.position + half : glm::vec3(0.0f),
                        rB = b ? originB + point.position - half : glm::vec3(0.0f);
        ContactConstraint& c = set.constraints[at++];
        fillConstraint(c, point, A, B, rA, rB);
        c.separation = effectiveSeparation(*pair.manifold, point, up);
        if (c.initialNormalVelocity < set.constraints[fastest].initialNormalVelocity) fastest = at - 1;
        closing = std::max({closing, -c.initialNormalVelocity, -glm::dot(A.v - B.v, point.normal)});
    }
    const float speed = -set.constraints[fastest].initialNormalVelocity;
    pair.passes = speed > kFastSpeed ? kFastPasses : speed > kHitSpeed ? kHitPasses : 1;
    const float thinnest = std::min(a ? A.minHalfExtent : 1e9f, b ? B.minHalfExtent : 1e9f);
    if (closing * seconds > thinnest) addInscribedSphere(set, pair, set.constraints[fastest]);
}

void addInscribedSpheresOfHit(ContactSet& set) {
    bool any = false;
    for (const PairConstraints& pair : set.pairs)
        if (pair.hasInscribedSphere()) set.stateA(pair).isHitByFast = set.stateB(pair).isHitByFast = any = true;
    if (!any) return;
    for (PairConstraints& pair : set.pairs) {
        const bool isWithWorld = !pair.a || !pair.b;
        if (!isWithWorld || !set.states[size_t(pair.a + pair.b)].isHitByFast || pair.hasInscribedSphere()) continue;
        const std::span<ContactConstraint> points = set.of(pair);
        const ContactConstraint fastest =
            *std::min_element(points.begin(), points.end(), [](const ContactConstraint& c, const ContactConstraint& d) {
                return c.initialNormalVelocity < d.initialNormalVelocity;
            });
        addInscribedSphere(set, pair, fastest);
    }
}

void WarmStartFilter::reject(ContactSet& set) {
    for (int round = 0; round < kRejectionRounds; ++round) {
        m_sums.assign(set.states.size(), {});
        for (const PairConstraints& pair : set.pairs) {
            Sum &a = m_sums[size_t(pair.a)], &b = m_sums[size_t(pair.b)];
            for (const ContactConstraint& c : set.of(pair)) {
                const Float4 impulse = c.normal * float4(c.normalImpulse) + c.tangent1 * float4(c.tangentImpulse1) +
                                       c.tangent2 * float4(c.tangentImpulse2);
                a.impulse += impulse, a.angularImpulse += cross(c.rA, impulse);
                b.impulse -= impulse, b.angularImpulse -= cross(c.rB, impulse);
            }
        }
        for (size_t i = 1; i < set.states.size(); ++i) {
            const SolverState& state = set.states[i];
            Sum& sum = m_sums[i];
            const float speed2 = dot(sum.impulse, sum.impulse) * state.inverseMass * state.inverseMass;
            // Twice the energy of the spin over the mass, which is comparable with a squared speed.
            const float spin2 =
                dot(sum.angularImpulse, SimdMat3(state.inverseInertia) * sum.angularImpulse) * state.inverseMass;
            sum.isRejected = !state.isJointed && speed2 + spin2 > kMaxWarmStartSpeed * kMaxWarmStartSpeed;
        }
        bool any = false;
        for (const PairConstraints& pair : set.pairs) {
            if (!m_sums[size_t(pair.a)].isRejected && !m_sums[size_t(pair.b)].isRejected) continue;
            for (ContactConstraint& c : set.of(pair)) {
                any |= c.normalImpulse != 0.0f;
                c.normalImpulse = c.tangentImpulse1 = c.tangentImpulse2 = 0.0f;
            }
        }
        if (!any) return;
    }
}

/// Gauss-Seidel converges slowly where a heavy body lies on a light one, and the light one would be pressed into what
/// is under it. Stiffer contacts and more passes over just these pairs help.
void findLoadBearing(ContactSet& set, const glm::vec3& up, float ratio, std::vector<size_t>& pairs) {
    const auto lower = [&](const PairConstraints& pair) -> SolverState* {
        const float rise = pair.to > pair.from ? glm::dot(vec3(set.constraints[pair.from].normal), up) : 0.0f;
        return rise > kMinSupportSlope ? &set.stateB(pair) : rise < -kMinSupportSlope ? &set.stateA(pair) : nullptr;
    };
    const auto upper = [&](const PairConstraints& pair, const SolverState* under) {
        return under == &set.stateB(pair) ? &set.stateA(pair) : &set.stateB(pair);
    };
    bool any = false;
    for (const PairConstraints& pair : set.pairs) {
        if (!pair.a || !pair.b) continue;
        const float a = set.stateA(pair).inverseMass, b = set.stateB(pair).inverseMass;
        if (a <= ratio * b && b <= ratio * a) continue;
        SolverState* under = lower(pair);
        if (under && under->inverseMass > ratio * upper(pair, under)->inverseMass) under->isLoadBearing = any = true;
    }
    for (bool more = any; more;) {  // down to the ground
        more = false;
        for (const PairConstraints& pair : set.pairs) {
            SolverState* under = lower(pair);
            if (under && under->inverseMass > 0.0f && !under->isLoadBearing && upper(pair, under)->isLoadBearing)
                under->isLoadBearing = more = true;
        }
    }
    if (!any) return;
    for (size_t i = 0; i < set.pairs.size(); ++i) {
        const PairConstraints& pair = set.pairs[i];
        if (!set.stateA(pair).isLoadBearing && !set.stateB(pair).isLoadBearing) continue;
        pairs.push_back(i);
        for (ContactConstraint& c : set.of(pair)) c.isStiff = true;
    }
}

}  // namespace rubble
