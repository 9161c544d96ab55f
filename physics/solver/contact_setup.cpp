#include "physics/solver/contact_setup.h"

#include <algorithm>
#include <cmath>

#include "physics/bodies/collision_object.h"
#include "physics/collision/round_contacts.h"

namespace rubble {
namespace {

constexpr float kHitSpeed = 0.5f;  ///< closing speed, m/s, from which a pair's normals are solved in several passes
constexpr float kFollowedSpeed = 0.5f;  ///< m/s between two bodies from which their points are followed
constexpr int kHitPasses = 16;          ///< at most
constexpr float kEndCosine = 0.7f;      ///< between a normal and a cylinder's axis above which it is touched on its end
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

/// The round surface of a part of an object. side: of a normal that points away from it.
RoundAnchor roundAnchor(const CollisionObject& object, size_t part, float side, const glm::vec3& normal) {
    const ColliderPart& touched = *object.collider.parts[part];
    const RoundSurface* round = touched.round();
    if (!round) return {};
    const glm::vec3 axis(object.pose.rotation * touched.frame().rotation * glm::dvec3(round->direction()));
    if (std::abs(glm::dot(axis, normal)) > kEndCosine) return {};
    return {float4(axis), round->radius * float(touched.voxelSize()), side};
}
/// Fills in which surfaces of a contact are round; null: none.
const RoundAnchors* findRoundAnchors(const Manifold& manifold, const ManifoldPoint& point, RoundAnchors& out) {
    if (point.feature & kFirstIsRound)
        out.a = roundAnchor(*manifold.objects.first, point.feature >> 6 & 31, -1.0f, point.normal);
    if (point.feature & kSecondIsRound)
        out.b = roundAnchor(*manifold.objects.second, point.feature >> 1 & 31, 1.0f, point.normal);
    return out.a.radius != 0.0f || out.b.radius != 0.0f ? &out : nullptr;
}

/// anchorA, anchorB: from the centres of mass to where each body is touched.
void fillConstraint(ContactConstraint& c, ManifoldPoint& point, const SolverState& A, const SolverState& B,
                    const glm::vec3& anchorA, const glm::vec3& anchorB) {
    glm::vec3 tangent1, tangent2;
    tangentsOf(point.normal, tangent1, tangent2);
    c.startNormal = float4(point.normal), c.tangent1 = float4(tangent1), c.tangent2 = float4(tangent2);
    c.anchorA = float4(anchorA), c.anchorB = float4(anchorB);
    c.frictionInset = float4(point.frictionInset);
    c.isOfB = point.feature & 1;
    c.separation = point.separation;
    updateJacobian(c, A, B);
    c.friction = point.friction;
    c.restitution = point.restitution;
    c.initialNormalVelocity = VelocityPair(A, B).normalVelocity(c);
    c.normalImpulse = point.normalImpulse;
    c.tangentImpulse1 = glm::dot(point.frictionImpulse, tangent1);
    c.tangentImpulse2 = glm::dot(point.frictionImpulse, tangent2);
    c.totalImpulse = c.bounceImpulse = 0.0f;
    c.isStiff = false;
    c.isStatic = A.inverseMass == 0.0f || B.inverseMass == 0.0f;
    c.point = &point;
}

}  // namespace

void updateJacobian(ContactConstraint& c, const SolverState& A, const SolverState& B) {
    const SimdMat3 rotationA(A.deltaRotation), rotationB(B.deltaRotation);
    Float4 turnA = rotationA * c.anchorA, turnB = rotationB * c.anchorB;
    c.normal = c.startNormal + (c.isOfB ? rotationA : rotationB) * c.startNormal;
    if (c.round) {
        turnA = c.round->a.turn(rotationA, c.anchorA, c.startNormal);
        turnB = c.round->b.turn(rotationB, c.anchorB, c.startNormal);
        if ((c.isOfB ? c.round->a : c.round->b).radius != 0.0f) c.normal = c.startNormal;
    }
    const Float4 apart =
        c.startNormal * float4(c.separation) + float4(A.deltaPosition - B.deltaPosition) + turnA - turnB;
    const Float4 half = c.normal * float4(0.5f * dot(apart, c.normal));
    c.rA = c.anchorA + turnA - (c.isOfB ? apart - half : half);
    c.rB = c.anchorB + turnB + (c.isOfB ? half : apart - half);
    const SimdMat3 inverseInertiaA(A.inverseInertia), inverseInertiaB(B.inverseInertia);
    const float inverseMass = A.inverseMass + B.inverseMass;
    c.angularA = cross(c.rA, c.normal), c.angularB = cross(c.rB, c.normal);
    c.angularChangeA = inverseInertiaA * c.angularA, c.angularChangeB = inverseInertiaB * c.angularB;
    c.normalMass = 1.0f / (inverseMass + dot(c.angularA, c.angularChangeA) + dot(c.angularB, c.angularChangeB));
    const auto effectiveMass = [&](const Float4& d) {
        const Float4 xa = cross(c.rA + c.frictionInset, d), xb = cross(c.rB + c.frictionInset, d);
        return 1.0f / (inverseMass + dot(xa, inverseInertiaA * xa) + dot(xb, inverseInertiaB * xb));
    };
    c.tangentMass1 = effectiveMass(c.tangent1), c.tangentMass2 = effectiveMass(c.tangent2);
}

void prepareStates(ContactSet& set, std::span<const SolverBody> bodies) {
    set.states.assign(bodies.size(), {});
    for (size_t i = 1; i < bodies.size(); ++i) {
        SolverState& state = set.states[i];
        state.v = glm::vec3(bodies[i].velocity);
        state.w = glm::vec3(bodies[i].angularVelocity);
        state.inverseMass = float(bodies[i].inverseMass);
        state.inverseInertia = glm::mat3(worldInverseInertia(bodies[i]));
    }
}

void preparePair(ContactSet& set, PairConstraints& pair, std::span<const SolverBody> bodies, const glm::vec3& up) {
    const int a = pair.a, b = pair.b;
    const SolverState &A = set.stateA(pair), &B = set.stateB(pair);
    const glm::vec3 originA = glm::vec3(pair.manifold->origin - bodies[size_t(a)].position);
    const glm::vec3 originB = glm::vec3(pair.manifold->origin - bodies[size_t(b)].position);
    float closing = 0.0f, moving2 = 0.0f;
    size_t at = pair.from;
    for (ManifoldPoint& point : pair.points()) {
        // Before a fast hit the two touched points are far apart.
        const glm::vec3 half = point.normal * (0.5f * point.separation);
        const glm::vec3 rA = a ? originA + point.position + half : glm::vec3(0.0f),
                        rB = b ? originB + point.position - half : glm::vec3(0.0f);
        ContactConstraint& c = set.constraints[at];
        c.round = set.rounds.empty() ? nullptr : findRoundAnchors(*pair.manifold, point, set.rounds[at]);
        ++at;
        fillConstraint(c, point, A, B, rA, rB);
        c.separation = effectiveSeparation(*pair.manifold, point, up);
        closing = std::max(closing, -c.initialNormalVelocity);
        const Float4 relative = VelocityPair(A, B).relativeVelocity(c);
        moving2 = std::max(moving2, dot(relative, relative));
    }
    pair.isHit = closing > kHitSpeed;
    pair.isFollowed = pair.isHit || (a && b && moving2 > kFollowedSpeed * kFollowedSpeed);
    pair.passes = pair.isHit ? kHitPasses : 1;
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

/// Which bodies lie on which, and the impulses from above on each.
void LoadBearing::findLoads(ContactSet& set, const glm::vec3& up) {
    m_supports.clear();
    m_loads.assign(set.states.size(), 0.0f);
    for (const PairConstraints& pair : set.pairs) {
        if (!pair.a || !pair.b || pair.from == pair.to) continue;
        const float rise = glm::dot(vec3(set.constraints[pair.from].normal), up);
        if (std::abs(rise) <= kMinSupportSlope) continue;
        const size_t under = size_t(rise > 0.0f ? pair.b : pair.a), upper = size_t(rise > 0.0f ? pair.a : pair.b);
        m_supports.emplace_back(upper, under);
        for (const ContactConstraint& c : set.of(pair))
            m_loads[under] += c.normalImpulse * std::abs(glm::dot(vec3(c.normal), up));
    }
}

/// Gauss-Seidel converges slowly where a heavy body lies on a light one, and the light one would be pressed into what
/// is under it. Stiffer contacts and more passes over just these pairs help. The load is what the last step found: it
/// goes down from body to body, and where it is spread over many they bear little.
void LoadBearing::find(ContactSet& set, const glm::vec3& up, float fall, float ratio) {
    m_pairs.clear();
    const auto isHeavy = [&](size_t upper, size_t under) {
        return set.states[under].inverseMass > ratio * set.states[upper].inverseMass;
    };
    bool any = false;
    for (const PairConstraints& pair : set.pairs)
        any |= pair.a && pair.b && (isHeavy(size_t(pair.a), size_t(pair.b)) || isHeavy(size_t(pair.b), size_t(pair.a)));
    if (!any) return;
    findLoads(set, up);
    const auto bearsMuch = [&](size_t body) {
        return m_loads[body] == 0.0f || m_loads[body] * set.states[body].inverseMass > ratio * fall;
    };
    for (const auto& [upper, under] : m_supports)
        if (isHeavy(upper, under) && bearsMuch(under)) set.states[under].isLoadBearing = true;
    for (bool more = true; more;) {  // down to the ground
        more = false;
        for (const auto& [upper, under] : m_supports)
            if (set.states[upper].isLoadBearing && !set.states[under].isLoadBearing && bearsMuch(under))
                set.states[under].isLoadBearing = more = true;
    }
    for (size_t i = 0; i < set.pairs.size(); ++i) {
        const PairConstraints& pair = set.pairs[i];
        if (!set.stateA(pair).isLoadBearing && !set.stateB(pair).isLoadBearing) continue;
        m_pairs.push_back(i);
        for (ContactConstraint& c : set.of(pair)) c.isStiff = true;
    }
}

}  // namespace rubble
