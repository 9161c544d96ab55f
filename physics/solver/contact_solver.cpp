#include "physics/solver/contact_solver.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr int kHitPasses = 2, kFastPasses = 8;         ///< over the normals of two bodies that meet; over others one
constexpr float kHitSpeed = 1.0f, kFastSpeed = 20.0f;  ///< m/s
constexpr float kSameFace = 0.9f;                      ///< cosine between normals of one face
constexpr float kMinSupportSlope = 0.3f;               ///< how far up a normal points where one body lies on the other
constexpr float kMaxWarmStartSpeed =
    4.0f;  ///< m/s that the impulses of the last step may give a body before they count as out of balance
constexpr int kRejectionRounds = 4;  ///< in which those that were held by what is out of balance updateCachedContacts
constexpr size_t kBlockSize = 64;    ///< bodies or pairs that a thread takes at once
constexpr size_t kMinParallelBlocks = 4;       ///< blocks from which on threads are asked
constexpr double kLoadBearingStiffness = 4.0;  ///< times as stiff, in hertz, are contacts of what isLoadBearing

/// Two directions across the normal.
void tangentsOf(const glm::vec3& n, glm::vec3& t1, glm::vec3& t2) {
    t1 = std::abs(n.x) > 0.57f ? glm::vec3(n.y, -n.x, 0.0f) : glm::vec3(0.0f, n.z, -n.y);
    t1 /= std::sqrt(glm::dot(t1, t1));
    t2 = glm::cross(n, t1);
}

}  // namespace

/// Kept in registers, not in m_states, while the contacts of two bodies are gone through.
struct ContactSolver::VelocityPair {
    VelocityPair(const SolverState& A, const SolverState& B)
        : vA(float4(A.v)),
          wA(float4(A.w)),
          vB(float4(B.v)),
          wB(float4(B.w)),
          massA(A.inverseMass),
          massB(B.inverseMass),
          inertiaA(A.inverseInertia),
          inertiaB(B.inverseInertia) {}
    /// The world is not written to: several threads read it.
    void store(SolverState& A, SolverState& B) const {
        if (massA != 0.0f) A.v = vec3(vA), A.w = vec3(wA);
        if (massB != 0.0f) B.v = vec3(vB), B.w = vec3(wB);
    }

    float normalVelocity(const Constraint& c) const {
        const Float4 parts = c.normal * (vA - vB) + c.angularA * wA - c.angularB * wB;
        return parts[0] + parts[1] + parts[2];
    }
    Float4 relativeVelocity(const Constraint& c) const { return vA + cross(wA, c.rA) - vB - cross(wB, c.rB); }
    /// An impulse along the normal.
    void applyNormalImpulse(const Constraint& c, float impulse) {
        vA += c.normal * float4(impulse * massA);
        wA += c.angularChangeA * float4(impulse);
        vB -= c.normal * float4(impulse * massB);
        wB -= c.angularChangeB * float4(impulse);
    }
    /// Impulses along the tangents.
    void applyFrictionImpulse(const Constraint& c, float impulse1, float impulse2) {
        const Float4 impulse = c.tangent1 * float4(impulse1) + c.tangent2 * float4(impulse2);
        vA += impulse * float4(massA);
        wA += inertiaA * cross(c.rA, impulse);
        vB -= impulse * float4(massB);
        wB -= inertiaB * cross(c.rB, impulse);
    }

    Float4 vA, wA, vB, wB;
    float massA, massB;
    SimdMat3 inertiaA, inertiaB;
};

/// How two bodies have movement since the step began.
struct ContactSolver::DeltaPair {
    DeltaPair(const SolverState& A, const SolverState& B)
        : displacement(float4(A.deltaPosition - B.deltaPosition)),
          deltaRotationA(A.deltaRotation),
          deltaRotationB(B.deltaRotation) {}
    Float4 displacement;
    SimdMat3 deltaRotationA, deltaRotationB;
};

template <class F>
void ContactSolver::forEach(size_t count, F&& f) const {
    const auto runBlock = [&](size_t block) {
        for (size_t i = block * kBlockSize; i < std::min(count, (block + 1) * kBlockSize); ++i) f(i);
    };
    if (m_parallelFor && count >= kMinParallelBlocks * kBlockSize)
        return (*m_parallelFor)((count + kBlockSize - 1) / kBlockSize, runBlock);
    for (size_t i = 0; i < count; ++i) f(i);
}

template <class F>
void ContactSolver::forEachPair(F&& f) {
    m_coloring.run(m_parallelFor, [&](size_t from, size_t to) {
        for (size_t i = from; i < to; ++i) f(m_pairs[i]);
    });
}

ContactSolver::Softness ContactSolver::makeSoft(double hertz, double dampingRatio, double seconds) {
    const double omega = 2.0 * 3.14159265358979 * hertz;
    const double a1 = 2.0 * dampingRatio + seconds * omega, a2 = seconds * omega * a1, a3 = 1.0 / (1.0 + a2);
    return {float(omega / a1), float(a2 * a3), float(a3)};
}

/// Two that meet so fast that one could turn its displacement past the few points which touch it: their cores, spheres
/// as wide as their smallest sides, may not pass the plane that they meet at, however they tumble.
void ContactSolver::addInscribedSphere(PairConstraints& pair, const Constraint& fastest) {
    const SolverState &A = m_states[size_t(pair.a)], &B = m_states[size_t(pair.b)];
    Constraint sphere = fastest;
    sphere.separation =
        1e9f;  // of the point that leaves the cores least: the fastest may be one that a spin brings round from above
    for (size_t i = pair.from; i < pair.to; ++i) {
        const Constraint& c = m_constraints[i];
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
    m_constraints[pair.to++] = sphere;
}

void ContactSolver::prepare(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
                            std::span<const std::pair<int, int>> bodyOf, float seconds) {
    m_states.assign(bodies.size(), {});
    for (size_t i = 1; i < bodies.size(); ++i) {
        SolverState& state = m_states[i];
        state.v = glm::vec3(bodies[i].velocity);
        state.w = glm::vec3(bodies[i].angularVelocity);
        state.inverseMass = float(bodies[i].inverseMass);
        state.minHalfExtent = float(bodies[i].minHalfExtent);
        state.inverseInertia = glm::mat3(worldInverseInertia(bodies[i]));
    }
    m_coloring.build(bodies, bodyOf);
    m_pairs.clear();
    size_t count = 0;
    for (const uint32_t m : m_coloring.order()) {
        const auto [a, b] = bodyOf[m];
        m_states[size_t(a)].isConstrained = m_states[size_t(b)].isConstrained = true;
        m_pairs.push_back({a, b, count, count + manifolds[m]->all().size(), 1, manifolds[m]});
        count = m_pairs.back().to + 1;  // there may be a sphere
    }
    m_constraints.resize(count);
    forEach(m_pairs.size(), [&](size_t i) { preparePair(m_pairs[i], bodies, seconds); });
    addInscribedSpheresOfHit();
}

/// What a fast one hits is knocked against the world within the step, and may turn its displacement past it as well.
void ContactSolver::addInscribedSpheresOfHit() {
    bool any = false;
    for (const PairConstraints& pair : m_pairs)
        if (pair.hasInscribedSphere())
            m_states[size_t(pair.a)].isHitByFast = m_states[size_t(pair.b)].isHitByFast = any = true;
    if (!any) return;
    for (PairConstraints& pair : m_pairs) {
        if ((pair.a && pair.b) || !m_states[size_t(pair.a + pair.b)].isHitByFast || pair.hasInscribedSphere()) continue;
        const auto from = m_constraints.begin() + std::ptrdiff_t(pair.from),
                   to = m_constraints.begin() + std::ptrdiff_t(pair.to);
        const Constraint fastest = *std::min_element(
            from, to, [](const Constraint& c, const Constraint& d) { return c.approach < d.approach; });
        addInscribedSphere(pair, fastest);
    }
}

void ContactSolver::preparePair(PairConstraints& pair, std::span<const SolverBody> bodies, float seconds) {
    const int a = pair.a, b = pair.b;
    const SolverState &A = m_states[size_t(a)], &B = m_states[size_t(b)];
    const glm::vec3 originA = glm::vec3(pair.manifold->origin - bodies[size_t(a)].position);
    const glm::vec3 originB = glm::vec3(pair.manifold->origin - bodies[size_t(b)].position);
    size_t fastest = pair.from, at = pair.from;
    float nearing =
        0.0f;  // m/s, of a point or of all of the two: a spinning body may come while the points that touch go
    for (ManifoldPoint& point : pair.points()) {
        Constraint& c = m_constraints[at++];
        const glm::vec3 half =
            point.normal * (0.5f * point.separation);  // far apart before a fast hit: where each is touched
        const glm::vec3 rA = a ? originA + point.position + half : glm::vec3(0.0f),
                        rB = b ? originB + point.position - half : glm::vec3(0.0f);
        glm::vec3 tangent1, tangent2;
        tangentsOf(point.normal, tangent1, tangent2);
        const auto massAlong = [&](const glm::vec3& d) {
            const glm::vec3 xa = glm::cross(rA, d), xb = glm::cross(rB, d);
            const float k = A.inverseMass + B.inverseMass + glm::dot(xa, A.inverseInertia * xa) +
                            glm::dot(xb, B.inverseInertia * xb);
            return k > 0.0f ? 1.0f / k : 0.0f;
        };
        c.normal = float4(point.normal), c.tangent1 = float4(tangent1), c.tangent2 = float4(tangent2);
        c.rA = float4(rA), c.rB = float4(rB);
        c.angularA = cross(c.rA, c.normal), c.angularB = cross(c.rB, c.normal);
        c.angularChangeA = float4(A.inverseInertia * vec3(c.angularA)),
        c.angularChangeB = float4(B.inverseInertia * vec3(c.angularB));
        c.normalMass = massAlong(point.normal);
        c.tangentMass1 = massAlong(tangent1);
        c.tangentMass2 = massAlong(tangent2);
        c.separation = effectiveSeparation(*pair.manifold, point, m_up);
        c.friction = point.friction;
        c.restitution = point.restitution;
        c.approach = VelocityPair(A, B).normalVelocity(c);
        c.normalImpulse = point.normalImpulse;
        c.tangentImpulse1 = glm::dot(point.frictionImpulse, tangent1);
        c.tangentImpulse2 = glm::dot(point.frictionImpulse, tangent2);
        c.totalImpulse = c.maxImpulse = c.bounceImpulse = 0.0f;
        c.isStiff = c.isInscribedSphere = false;
        c.isStatic = A.inverseMass == 0.0f || B.inverseMass == 0.0f;
        c.point = &point;
        if (c.approach < m_constraints[fastest].approach) fastest = at - 1;
        nearing = std::max({nearing, -c.approach, -glm::dot(A.v - B.v, point.normal)});
    }
    const float speed = -m_constraints[fastest].approach;
    pair.passes = speed > kFastSpeed ? kFastPasses : speed > kHitSpeed ? kHitPasses : 1;
    const float thin = std::min(a ? A.minHalfExtent : 1e9f, b ? B.minHalfExtent : 1e9f);
    if (nearing * seconds > thin) addInscribedSphere(pair, m_constraints[fastest]);
}

/// Bodies that something much heavier lies on, and those that these lie on in turn: as stiff as their own weight asks
/// for, and passed over as often as others, they would be pressed into each other.
void ContactSolver::findLoadBearing(glm::vec3 up, float ratio) {
    m_loadBearingPairs.clear();
    const auto lower = [&](const PairConstraints& pair) -> SolverState* {
        const float rise = pair.to > pair.from ? glm::dot(vec3(m_constraints[pair.from].normal), up) : 0.0f;
        return rise > kMinSupportSlope    ? &m_states[size_t(pair.b)]
               : rise < -kMinSupportSlope ? &m_states[size_t(pair.a)]
                                          : nullptr;
    };
    const auto upper = [&](const PairConstraints& pair, const SolverState* under) {
        return &m_states[size_t(under == &m_states[size_t(pair.b)] ? pair.a : pair.b)];
    };
    bool any = false;
    for (const PairConstraints& pair : m_pairs) {
        if (!pair.a || !pair.b) continue;
        const float a = m_states[size_t(pair.a)].inverseMass, b = m_states[size_t(pair.b)].inverseMass;
        if (a <= ratio * b && b <= ratio * a) continue;
        SolverState* under = lower(pair);
        if (under && under->inverseMass > ratio * upper(pair, under)->inverseMass) under->isLoadBearing = any = true;
    }
    for (bool more = any; more;) {
        more = false;
        for (const PairConstraints& pair : m_pairs) {
            SolverState* under = lower(pair);
            if (under && under->inverseMass > 0.0f && !under->isLoadBearing && upper(pair, under)->isLoadBearing)
                under->isLoadBearing = more = true;
        }
    }
    if (!any) return;
    for (size_t i = 0; i < m_pairs.size(); ++i) {
        const PairConstraints& pair = m_pairs[i];
        if (!m_states[size_t(pair.a)].isLoadBearing && !m_states[size_t(pair.b)].isLoadBearing) continue;
        m_loadBearingPairs.push_back(i);
        for (size_t k = pair.from; k < pair.to; ++k) m_constraints[k].isStiff = true;
    }
}

/// Where a contact has gone since the last step, what it held back would throw a light body that something heavy
/// presses on: the impulses of its other contacts do not start from the last step then.
void ContactSolver::rejectWarmStart(std::span<const SolverBody> bodies) {
    for (int round = 0; round < kRejectionRounds; ++round) {
        m_warmStartImpulses.assign(bodies.size(), {});
        for (const PairConstraints& pair : m_pairs) {
            WarmStartImpulse &a = m_warmStartImpulses[size_t(pair.a)], &b = m_warmStartImpulses[size_t(pair.b)];
            for (size_t i = pair.from; i < pair.to; ++i) {
                const Constraint& c = m_constraints[i];
                const Float4 impulse = c.normal * float4(c.normalImpulse) + c.tangent1 * float4(c.tangentImpulse1) +
                                       c.tangent2 * float4(c.tangentImpulse2);
                a.impulse += impulse, a.turn += cross(c.rA, impulse);
                b.impulse -= impulse, b.turn -= cross(c.rB, impulse);
            }
        }
        for (size_t i = 1; i < bodies.size(); ++i) {
            const SolverState& state = m_states[i];
            WarmStartImpulse& warmStartImpulse = m_warmStartImpulses[i];
            const float speed2 =
                dot(warmStartImpulse.impulse, warmStartImpulse.impulse) * state.inverseMass * state.inverseMass;
            const float spin2 =
                dot(warmStartImpulse.turn, SimdMat3(state.inverseInertia) * warmStartImpulse.turn) * state.inverseMass;
            warmStartImpulse.isRejected = !state.isJointed && speed2 + spin2 > kMaxWarmStartSpeed * kMaxWarmStartSpeed;
        }
        bool any = false;
        for (const PairConstraints& pair : m_pairs) {
            if (!m_warmStartImpulses[size_t(pair.a)].isRejected && !m_warmStartImpulses[size_t(pair.b)].isRejected)
                continue;
            for (size_t i = pair.from; i < pair.to; ++i) {
                Constraint& c = m_constraints[i];
                any |= c.normalImpulse != 0.0f;
                c.normalImpulse = c.tangentImpulse1 = c.tangentImpulse2 = 0.0f;
            }
        }
        if (!any) return;
    }
}

/// Starts a substep with the impulses of the one before, which are counted.
void ContactSolver::warmStart(const PairConstraints& pair, bool isFirst) {
    SolverState &A = m_states[size_t(pair.a)], &B = m_states[size_t(pair.b)];
    VelocityPair bodies(A, B);
    for (size_t i = pair.from; i < pair.to; ++i) {
        Constraint& c = m_constraints[i];
        if (!isFirst) c.totalImpulse += c.normalImpulse;
        bodies.applyNormalImpulse(c, c.normalImpulse);
        bodies.applyFrictionImpulse(c, c.tangentImpulse1, c.tangentImpulse2);
    }
    bodies.store(A, B);
}

ContactSolver::ContactBias ContactSolver::biasOf(const Constraint& c, const DeltaPair& deltas, float inverseSeconds,
                                                 bool useBias) const {
    const Float4 movement = deltas.displacement + deltas.deltaRotationA * c.rA - deltas.deltaRotationB * c.rB;
    const float s = c.separation + dot(movement, c.normal);
    if (s > 0.0f) return {s * inverseSeconds};
    if (!useBias) return {};
    const Softness& soft = c.isStiff ? m_stiff : c.isStatic ? m_softStatic : m_soft;
    return {std::max(soft.biasRate * std::min(s + m_slop, 0.0f), -m_maxPushSpeed), soft.massScale, soft.impulseScale};
}

/// What an impulse does after one of the two has turned. With the masses of before, a rod would be pushed more than it
/// takes to stop it, time and again.
void ContactSolver::rotateInertia(Constraint& c, const SolverState& A, const SolverState& B) {
    const SimdMat3 inertiaA(A.inverseInertia), inertiaB(B.inverseInertia);
    c.angularChangeA = inertiaA * c.angularA, c.angularChangeB = inertiaB * c.angularB;
    const float mass = A.inverseMass + B.inverseMass;
    c.normalMass = 1.0f / (mass + dot(c.angularA, c.angularChangeA) + dot(c.angularB, c.angularChangeB));
    const auto massAlong = [&](const Float4& d) {
        const Float4 xa = cross(c.rA, d), xb = cross(c.rB, d);
        return 1.0f / (mass + dot(xa, inertiaA * xa) + dot(xb, inertiaB * xb));
    };
    c.tangentMass1 = massAlong(c.tangent1), c.tangentMass2 = massAlong(c.tangent2);
}

void ContactSolver::solveNormal(Constraint& c, const ContactBias& bias, VelocityPair& bodies) {
    const float old = c.normalImpulse;
    c.normalImpulse = std::max(
        old - c.normalMass * bias.massScale * (bodies.normalVelocity(c) + bias.bias) - bias.impulseScale * old, 0.0f);
    c.maxImpulse = std::max(c.maxImpulse, c.normalImpulse);
    bodies.applyNormalImpulse(c, c.normalImpulse - old);
}

void ContactSolver::solveFriction(Constraint& c, VelocityPair& bodies) {
    const Float4 relative = bodies.relativeVelocity(c);
    const float limit = c.friction * c.normalImpulse;
    float t1 = c.tangentImpulse1 - c.tangentMass1 * dot(relative, c.tangent1);
    float t2 = c.tangentImpulse2 - c.tangentMass2 * dot(relative, c.tangent2);
    const float size2 = t1 * t1 + t2 * t2;
    if (size2 > limit * limit) {
        const float shrink = limit / std::sqrt(size2);
        t1 *= shrink;
        t2 *= shrink;
    }
    bodies.applyFrictionImpulse(c, t1 - c.tangentImpulse1, t2 - c.tangentImpulse2);
    c.tangentImpulse1 = t1;
    c.tangentImpulse2 = t2;
}

/// All normals of two bodies first, then their friction: what one point takes too much of, the next isSoft back before
/// it hasBallFriction.
void ContactSolver::solvePair(const PairConstraints& pair, float inverseSeconds, bool useBias) {
    SolverState &A = m_states[size_t(pair.a)], &B = m_states[size_t(pair.b)];
    const std::span<Constraint> points(m_constraints.data() + pair.from, pair.to - pair.from);
    const DeltaPair movement(A, B);
    std::array<ContactBias, kMaxManifoldPoints + 1> biases;  // a sphere may be one more
    for (size_t i = 0; i < points.size(); ++i) {
        Constraint& c = points[i];
        biases[i] = biasOf(c, movement, inverseSeconds, useBias);
        if (!useBias && (A.inertiaRotates || B.inertiaRotates)) rotateInertia(c, A, B);  // just after they have turned
    }
    VelocityPair bodies(A, B);
    for (int pass = 0; pass < pair.passes; ++pass)
        for (size_t i = 0; i < points.size(); ++i) solveNormal(points[i], biases[i], bodies);
    for (Constraint& c : points) solveFriction(c, bodies);
    bodies.store(A, B);
}

void ContactSolver::solveContacts(float inverseSeconds, bool useBias) {
    forEachPair([&](const PairConstraints& pair) { solvePair(pair, inverseSeconds, useBias); });
    if (m_loadBearingPairs.empty()) return;
    for (int pass = 0; pass < m_loadBearingPasses; ++pass)
        for (const size_t i : m_loadBearingPairs) solvePair(m_pairs[i], inverseSeconds, useBias);
}

void ContactSolver::solvePasses(std::span<const SolverBody> bodies, int passes, double seconds, bool useBias) {
    for (int i = 0; i < passes; ++i) {
        if (!m_joints.empty()) m_joints.solve(bodies, m_states, useBias);
        solveContacts(float(1.0 / seconds), useBias);
    }
}

void ContactSolver::bounce(float threshold) {
    for (const PairConstraints& pair : m_pairs) {
        SolverState &A = m_states[size_t(pair.a)], &B = m_states[size_t(pair.b)];
        const std::span<Constraint> points(m_constraints.data() + pair.from, pair.to - pair.from);
        const auto bounces = [&](const Constraint& c) {
            return c.restitution != 0.0f && c.approach <= -threshold && c.maxImpulse != 0.0f;
        };
        if (std::none_of(points.begin(), points.end(), bounces)) continue;
        VelocityPair bodies(A, B);
        for (int pass = 0; pass < kFastPasses; ++pass)
            for (Constraint& c : points) {
                if (!bounces(c)) continue;
                // On top of what the contact isLoadBearing, which the next step starts with.
                const float old = c.bounceImpulse;
                c.bounceImpulse =
                    std::max(old - c.normalMass * (bodies.normalVelocity(c) + c.restitution * c.approach), 0.0f);
                bodies.applyNormalImpulse(c, c.bounceImpulse - old);
            }
        bodies.store(A, B);
    }
}

void ContactSolver::solve(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
                          std::span<const std::pair<int, int>> bodyOf, glm::dvec3 gravity,
                          const SolverSettings& settings, std::span<JointConstraint* const> joints) {
    const double h = settings.seconds / settings.substeps;
    const double hertz = std::min(settings.contactHertz, 0.25 / h);
    m_soft = makeSoft(hertz, settings.dampingRatio, h);
    m_softStatic = makeSoft(2.0 * hertz, settings.dampingRatio, h);
    m_stiff = makeSoft(kLoadBearingStiffness * hertz, settings.dampingRatio, h);
    m_maxPushSpeed = float(settings.maxPushSpeed);
    m_slop = float(settings.slop);
    m_parallelFor = settings.parallelFor;
    const double weight = glm::length(gravity);
    m_up = weight > 0.0 ? glm::vec3(gravity / -weight) : glm::vec3(0.0f);
    prepare(bodies, manifolds, bodyOf, float(settings.seconds));
    m_joints.begin(joints, m_states);
    rejectWarmStart(bodies);
    m_loadBearingPasses = settings.loadBearingPasses;
    m_loadBearingPairs.clear();
    if (settings.loadBearingPasses > 0 && weight > 0.0) findLoadBearing(m_up, float(settings.loadBearingRatio));
    m_start.resize(bodies.size());
    for (size_t i = 0; i < bodies.size(); ++i) m_start[i] = bodies[i].rotation;
    const glm::vec3 fall = glm::vec3(gravity * h);
    for (int substep = 0; substep < settings.substeps; ++substep) {
        for (size_t i = 1; i < bodies.size(); ++i) m_states[i].v += fall;
        if (!m_joints.empty()) m_joints.prepare(bodies, m_states, h);
        forEachPair([&](const PairConstraints& pair) { warmStart(pair, substep == 0); });
        solvePasses(bodies, settings.iterations, h, true);
        move(bodies, gravity, h);
        solvePasses(bodies, settings.iterations, h, false);
        if (!m_joints.empty()) m_joints.note(settings.seconds);
    }
    bounce(float(settings.restitutionThreshold));
    for (size_t i = 1; i < bodies.size(); ++i)
        if (m_states[i].isConstrained) bodies[i].velocity = m_states[i].v, bodies[i].angularVelocity = m_states[i].w;
    store();
}

void ContactSolver::move(std::span<SolverBody> bodies, glm::dvec3 gravity, double h) {
    forEach(bodies.size() - 1, [&](size_t i) { moveBody(bodies[i + 1], m_states[i + 1], m_start[i + 1], gravity, h); });
}

/// Integrates its position. Bodies without contacts stay in doubles: nothing is rounded in free flight.
void ContactSolver::moveBody(SolverBody& body, SolverState& state, const glm::dquat& start, glm::dvec3 gravity,
                             double h) {
    if (state.isConstrained) {
        body.velocity = state.v;
        body.angularVelocity = state.w;
    } else
        body.velocity += gravity * h;
    const glm::dvec3 displacement = body.velocity * h;
    body.position += displacement;
    rotateBody(body, h);
    if (!state.isConstrained) return;
    state.deltaPosition += glm::vec3(displacement);
    state.deltaRotation = glm::mat3(glm::mat3_cast(body.rotation * glm::conjugate(start)) - glm::dmat3(1.0));
    if (body.conservesMomentum) {
        state.w = glm::vec3(body.angularVelocity);
        state.inverseInertia = glm::mat3(worldInverseInertia(body));
        state.inertiaRotates = true;
    }
}

void ContactSolver::store() {
    forEach(m_pairs.size(), [&](size_t i) { store(m_pairs[i]); });
}

void ContactSolver::store(const PairConstraints& pair) {
    for (size_t i = pair.from; i < pair.to; ++i) {
        Constraint& c = m_constraints[i];
        c.totalImpulse += c.normalImpulse;
        c.totalImpulse += c.bounceImpulse;
        if (c.isInscribedSphere) {
            c.point->totalImpulse += c.totalImpulse;
            continue;
        }
        c.point->normalImpulse = c.normalImpulse;
        c.point->frictionImpulse =
            vec3(c.tangent1 * float4(c.tangentImpulse1) + c.tangent2 * float4(c.tangentImpulse2));
        c.point->totalImpulse = c.totalImpulse;
        c.point->approach = -c.approach;
    }
}

}  // namespace rubble
