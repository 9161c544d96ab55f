#include "physics/solver/contact_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/bodies/dynamic_body.h"
#include "physics/collision/round_contacts.h"

namespace rubble {
namespace {

constexpr float kHitSpeed = 0.5f;  ///< closing speed, m/s, from which a pair's normals are solved in several passes
constexpr float kFollowedSpeed = 0.5f;  ///< m/s between two bodies from which their points are followed
constexpr float kEndCosine = 0.7f;      ///< between a normal and a cylinder's axis above which it is touched on its end
constexpr float kNothing = std::numeric_limits<float>::max();  ///< 1/kg of what a body bears, if it bears nothing heavy
constexpr float kMinSupportSlope = 0.3f;  ///< vertical part of a normal above which one body lies on the other
/// m/s that the warm start may give a body. Balanced impulses cancel.
constexpr float kMaxWarmStartSpeed = 4.0f;
constexpr int kRejectionRounds = 4;  ///< in which the rejection spreads to neighbours that become unbalanced by it

/// The round surface of a part of an object. side: of a normal that points away from it.
RoundAnchor<float> roundAnchor(const CollisionObject& object, size_t part, float side, const glm::vec3& normal) {
    const ColliderPart& touched = *object.collider.parts[part];
    const RoundSurface* round = touched.round();
    if (!round) return {};
    const glm::vec3 axis(object.pose.rotation * touched.frame().rotation * glm::dvec3(round->direction()));
    if (std::abs(glm::dot(axis, normal)) > kEndCosine) return {};
    return {toVec3(axis), round->radius * float(touched.voxelSize()), side};
}

/// What sleeps is not static: contacts with it stay as soft as before it slept, so that they do not jolt.
bool touchesStatic(const PairConstraints& pair) {
    const auto isStatic = [](int body, const CollisionObject* object) { return !body && !(object && object->dynamic); };
    return isStatic(pair.a, pair.manifold->objects.first) || isStatic(pair.b, pair.manifold->objects.second);
}

/// A soft contact overlaps in proportion to its load over its effective mass. That of a body and a sleeper, which
/// stands still, is larger than that of the two awake, so its bias is by this share the slower: they overlap as before.
/// 1 for what does not touch a sleeper.
float awakeMassShare(const ContactSet& set, const PairConstraints& pair, const glm::vec3& arm) {
    const auto [first, second] = pair.manifold->objects;
    const CollisionObject* const still = pair.a && pair.b ? nullptr : !pair.a ? first : second;
    const DynamicBody* const sleeper = still ? still->dynamic : nullptr;
    if (!sleeper) return 1.0f;
    const SolverState& awake = set.states[size_t(pair.a + pair.b)];
    const glm::mat3 inverseInertia(worldInverseInertia(sleeper->motion));
    const glm::vec3 sleeperArm(pair.manifold->origin - sleeper->motion.position);
    float share = 0.0f;
    for (const ManifoldPoint& point : pair.points()) {
        const glm::vec3 a = glm::cross(arm + point.position, point.normal),
                        b = glm::cross(sleeperArm + point.position, point.normal);
        const float own = awake.inverseMass + glm::dot(a, awake.inverseInertia * a);
        share += own / (own + float(sleeper->motion.inverseMass) + glm::dot(b, inverseInertia * b));
    }
    return share / float(std::max(pair.points().size(), size_t(1)));
}

/// Where the manifold's origin is seen from a body's centre of mass. The world has none.
glm::vec3 originFrom(const Manifold& manifold, const SolverBody& body) {
    return glm::vec3(manifold.origin - body.position);
}

ContactStart<float> startOf(const Manifold& manifold, const ManifoldPoint& point, const glm::vec3& up) {
    ContactStart<float> start{.normal = toVec3(point.normal),
                              .distance = point.separation,
                              .separation = effectiveSeparation(manifold, point, up),
                              .isOfB = point.feature & 1 ? 1.0f : 0.0f};
    if (point.feature & kFirstIsRound)
        start.a = roundAnchor(*manifold.objects.first, point.feature >> 6 & 31, -1.0f, point.normal);
    if (point.feature & kSecondIsRound)
        start.b = roundAnchor(*manifold.objects.second, point.feature >> 1 & 31, 1.0f, point.normal);
    return start;
}

/// originA, originB: the manifold's origin from the centres of mass.
Contact<float> contactOf(const PairConstraints& pair, const ManifoldPoint& point, const glm::vec3& originA,
                         const glm::vec3& originB) {
    // Before a fast hit the two touched points are far apart.
    const glm::vec3 half = point.normal * (0.5f * point.separation);
    Contact<float> c{};
    c.tangent1 = toVec3(point.frictionImpulse);  // until they are prepared
    c.anchorA = toVec3(pair.a ? originA + point.position + half : glm::vec3(0.0f));
    c.anchorB = toVec3(pair.b ? originB + point.position - half : glm::vec3(0.0f));
    c.frictionInset = toVec3(point.frictionInset);
    c.friction = point.friction;
    c.normalImpulse = point.normalImpulse;
    return c;
}

/// How many points all lanes of a group have.
uint32_t fullPoints(const ContactSet& set, const PairGroup& group) {
    uint32_t least = group.count;
    for (const uint32_t pair : group.pair)
        least = pair == PairGroup::kNone ? 0 : std::min(least, uint32_t(set.pairs[pair].manifold->count));
    return least;
}

}  // namespace

void prepareStates(ContactSet& set, std::span<const SolverBody> bodies) {
    set.states.assign(bodies.size(), {});
    set.states[0].gravityScale = 0.0f;
    for (size_t i = 1; i < bodies.size(); ++i) {
        SolverState& state = set.states[i];
        state.v = glm::vec3(bodies[i].velocity);
        state.w = glm::vec3(bodies[i].angularVelocity);
        state.inverseMass = float(bodies[i].inverseMass);
        state.gravityScale = bodies[i].gravityScale;
        state.inverseInertia = glm::mat3(worldInverseInertia(bodies[i]));
    }
}

void classifyPair(const ContactSet& set, PairConstraints& pair, std::span<const SolverBody> bodies) {
    const SolverState &A = set.states[size_t(pair.a)], &B = set.states[size_t(pair.b)];
    const glm::vec3 originA = originFrom(*pair.manifold, bodies[size_t(pair.a)]);
    const glm::vec3 originB = originFrom(*pair.manifold, bodies[size_t(pair.b)]);
    const glm::vec3 relative = A.v - B.v;
    float closing = 0.0f, moving2 = 0.0f;
    for (ManifoldPoint& point : pair.points()) {
        const glm::vec3 rA = originA + point.position, rB = originB + point.position;
        point.approach = -glm::dot(relative + glm::cross(A.w, rA) - glm::cross(B.w, rB), point.normal);
        closing = std::max(closing, point.approach);
        const glm::vec3 sliding =
            relative + glm::cross(A.w, rA + point.frictionInset) - glm::cross(B.w, rB + point.frictionInset);
        moving2 = std::max(moving2, glm::dot(sliding, sliding));
        if (point.restitution > 0.0f) {
            pair.isElastic = true;
            pair.reboundSpeed = std::max(pair.reboundSpeed, point.restitution * point.approach);
        }
        const glm::vec3 impulse = point.normal * point.normalImpulse + point.frictionImpulse;
        pair.isWarm |= point.normalImpulse != 0.0f;
        pair.impulse += impulse;
        pair.angularImpulseA += glm::cross(rA, impulse), pair.angularImpulseB += glm::cross(rB, impulse);
    }
    if (const float torsion = pair.manifold->torsionImpulse; torsion != 0.0f && pair.manifold->count == 1) {
        const glm::vec3 angularImpulse = pair.points()[0].normal * torsion;
        pair.angularImpulseA += angularImpulse, pair.angularImpulseB += angularImpulse;
    }
    pair.manifold->approach = closing;
    pair.isHit = closing > kHitSpeed;
    pair.isFollowed = pair.isHit || (pair.a && pair.b && moving2 > kFollowedSpeed * kFollowedSpeed);
}

void fillGroup(ContactSet& set, PairGroup& group, std::span<const SolverBody> bodies, const glm::vec3& up,
               const ContactSoftness& softness, float torsionRadius) {
    for (uint32_t i = fullPoints(set, group); i < group.count; ++i)
        set.contacts[group.from + i] = {}, set.starts[group.from + i] = {};
    for (size_t lane = 0; lane < kLanes; ++lane) {
        if (group.pair[lane] == PairGroup::kNone) continue;
        const PairConstraints& pair = set.pairs[group.pair[lane]];
        const glm::vec3 originA = originFrom(*pair.manifold, bodies[size_t(pair.a)]);
        const glm::vec3 originB = originFrom(*pair.manifold, bodies[size_t(pair.b)]);
        const Softness<float>& soft = pair.isStiff          ? softness.stiff
                                      : touchesStatic(pair) ? softness.withStatic
                                                            : softness.moving;
        group.isHit.at[lane] = pair.isHit ? 1.0f : 0.0f;
        group.biasRate.at[lane] = soft.biasRate * awakeMassShare(set, pair, pair.a ? originA : originB);
        group.massScale.at[lane] = soft.massScale, group.impulseScale.at[lane] = soft.impulseScale;
        if (pair.manifold->count == 1 && !pair.manifold->isRound && torsionRadius > 0.0f) {
            group.anyTorsion = true;
            group.torsionArm.at[lane] = pair.points()[0].friction * torsionRadius;
            group.torsionImpulse.at[lane] = pair.manifold->torsionImpulse;
        }
        for (size_t i = 0; i < pair.points().size(); ++i) {
            set.beginContact(pair, i, contactOf(pair, pair.points()[i], originA, originB));
            set.setStart(pair, i, startOf(*pair.manifold, pair.points()[i], up));
        }
    }
}

void WarmStartFilter::reject(ContactSet& set) {
    for (int round = 0; round < kRejectionRounds; ++round) {
        m_sums.assign(set.states.size(), {});
        for (const PairConstraints& pair : set.pairs) {
            Sum &a = m_sums[size_t(pair.a)], &b = m_sums[size_t(pair.b)];
            a.impulse += pair.impulse, a.angularImpulse += pair.angularImpulseA;
            b.impulse -= pair.impulse, b.angularImpulse -= pair.angularImpulseB;
        }
        for (size_t i = 1; i < set.states.size(); ++i) {
            const SolverState& state = set.states[i];
            Sum& sum = m_sums[i];
            const float speed2 = glm::dot(sum.impulse, sum.impulse) * state.inverseMass * state.inverseMass;
            // Twice the energy of the spin over the mass, which is comparable with a squared speed.
            const float spin2 =
                glm::dot(sum.angularImpulse, state.inverseInertia * sum.angularImpulse) * state.inverseMass;
            sum.isRejected = !state.isJointed && speed2 + spin2 > kMaxWarmStartSpeed * kMaxWarmStartSpeed;
        }
        bool any = false;
        for (PairConstraints& pair : set.pairs) {
            if (!pair.isWarm || (!m_sums[size_t(pair.a)].isRejected && !m_sums[size_t(pair.b)].isRejected)) continue;
            any = true;
            pair.isWarm = false;
            pair.impulse = pair.angularImpulseA = pair.angularImpulseB = glm::vec3(0.0f);
            pair.manifold->torsionImpulse = 0.0f;
            for (ManifoldPoint& point : pair.points()) {
                point.normalImpulse = 0.0f;
                point.frictionImpulse = glm::vec3(0.0f);
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
        if (!pair.a || !pair.b || pair.points().empty()) continue;
        const float rise = glm::dot(pair.points()[0].normal, up);
        if (std::abs(rise) <= kMinSupportSlope) continue;
        const size_t under = size_t(rise > 0.0f ? pair.b : pair.a), upper = size_t(rise > 0.0f ? pair.a : pair.b);
        m_supports.emplace_back(upper, under);
        for (const ManifoldPoint& point : pair.points())
            m_loads[under] += point.normalImpulse * std::abs(glm::dot(point.normal, up));
    }
}

/// Gauss-Seidel converges slowly where a heavy body lies on a light one, and the light one would be pressed into what
/// is under it. Stiffer contacts and more passes over just these pairs help. The load is what the last step found: it
/// goes down from body to body, as far as they are as light, and where it is spread over many they bear little.
void LoadBearing::find(ContactSet& set, const glm::vec3& up, float fall, float ratio) {
    m_pairs.clear();
    const auto isHeavy = [&](size_t upper, size_t under) {
        return set.states[under].inverseMass > ratio * set.states[upper].inverseMass;
    };
    const auto isLight = [&](size_t body) { return set.states[body].inverseMass > ratio * m_heaviest[body]; };
    bool any = false;
    for (const PairConstraints& pair : set.pairs)
        any |= pair.a && pair.b && (isHeavy(size_t(pair.a), size_t(pair.b)) || isHeavy(size_t(pair.b), size_t(pair.a)));
    if (!any) return;
    findLoads(set, up);
    const auto bearsMuch = [&](size_t body) {
        return m_loads[body] == 0.0f || m_loads[body] * set.states[body].inverseMass > ratio * fall;
    };
    m_heaviest.assign(set.states.size(), kNothing);
    for (const auto& [upper, under] : m_supports)
        if (isHeavy(upper, under) && bearsMuch(under))
            m_heaviest[under] = std::min(m_heaviest[under], set.states[upper].inverseMass);
    for (bool more = true; more;) {  // down to the ground
        more = false;
        for (const auto& [upper, under] : m_supports)
            if (isLight(upper) && m_heaviest[upper] < m_heaviest[under] && bearsMuch(under))
                m_heaviest[under] = m_heaviest[upper], more = true;
    }
    for (size_t i = 0; i < set.states.size(); ++i) set.states[i].isLoadBearing = isLight(i);
    for (size_t i = 0; i < set.pairs.size(); ++i) {
        PairConstraints& pair = set.pairs[i];
        if (!set.stateA(pair).isLoadBearing && !set.stateB(pair).isLoadBearing) continue;
        m_pairs.push_back(i);
        pair.isStiff = true;
    }
}

}  // namespace rubble
