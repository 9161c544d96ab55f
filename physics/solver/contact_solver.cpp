#include "physics/solver/contact_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/solver/blockwise.h"

// Contacts by sequential impulses in substeps ("soft step").
//
// A contact point with the normal n and the arms rA, rB has the separation s >= 0 and the normal velocity
//     Jv = n . (vA + wA x rA - vB - wB x rB).
// An impulse l >= 0 along n changes it by l / m, with the effective mass m = 1 / (J M^-1 J^T)
//     = 1 / (1/mA + 1/mB + (rA x n) . IA^-1 (rA x n) + (rB x n) . IB^-1 (rB x n)).
// Signorini's condition says l >= 0, Jv + s/h >= 0, and one of them is 0. For one point this is solved by adding
// -m (Jv + s/h) to l and clamping the sum at 0; for all points by iterating, which is projected Gauss-Seidel (Catto,
// "Iterative Dynamics with Temporal Coherence", 2005). Friction is the same along two tangents, with the sum clamped to
// Coulomb's |l_t| <= mu l. A penetration s < 0 is a soft constraint (soft_constraint.h).
//
// A substep of h seconds: apply gravity; warm start with the last impulses; iterate with bias; move; iterate without
// bias ("relax"), which takes out the velocity that pushed penetrations apart. Substeps with one iteration each
// converge better than many iterations of a long step (Macklin et al., "Small Steps in Physics Simulation", 2019;
// Catto, "Solver2D", 2024). Contacts are found once a step; within it, s follows the movements of the two anchors along
// n. Restitution is one more solve at the end of the step, of the points that were approached fast enough.

namespace rubble {
namespace {

constexpr int kBouncePasses = 8;
constexpr double kLoadBearingStiffness = 4.0;  ///< times contactHertz, for contacts of load-bearing bodies

}  // namespace

template <class F>
void ContactSolver::forEachPair(F&& f) {
    m_coloring.run(m_parallelFor, [&](size_t from, size_t to) {
        for (size_t i = from; i < to; ++i) f(m_set.pairs[i]);
    });
}

void ContactSolver::solve(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
                          std::span<const std::pair<int, int>> bodyOf, glm::dvec3 gravity,
                          const SolverSettings& settings, std::span<JointConstraint* const> joints) {
    const double h = settings.seconds / settings.substeps;
    const double hertz = std::min(settings.contactHertz, 0.25 / h);
    m_soft = makeSoft<float>(hertz, settings.dampingRatio, h);
    m_softStatic = makeSoft<float>(2.0 * hertz, settings.dampingRatio, h);
    m_stiff = makeSoft<float>(kLoadBearingStiffness * hertz, settings.dampingRatio, h);
    m_maxPushSpeed = float(settings.maxPushSpeed);
    m_slop = float(settings.slop);
    m_parallelFor = settings.parallelFor;
    const double weight = glm::length(gravity);
    m_up = weight > 0.0 ? glm::vec3(gravity / -weight) : glm::vec3(0.0f);
    prepare(bodies, manifolds, bodyOf, settings);
    m_joints.begin(joints, m_set.states);
    m_warmStartFilter.reject(m_set);
    m_loadBearingPasses = settings.loadBearingPasses;
    m_loadBearingPairs.clear();
    if (settings.loadBearingPasses > 0 && weight > 0.0)
        findLoadBearing(m_set, m_up, float(settings.loadBearingRatio), m_loadBearingPairs);
    m_start.resize(bodies.size());
    for (size_t i = 0; i < bodies.size(); ++i) m_start[i] = bodies[i].rotation;
    for (int i = 0; i < settings.substeps; ++i) substep(bodies, gravity, settings, i == 0);
    bounce(float(settings.restitutionThreshold));
    for (size_t i = 1; i < bodies.size(); ++i)
        if (const SolverState& state = m_set.states[i]; state.isConstrained)
            bodies[i].velocity = state.v, bodies[i].angularVelocity = state.w;
    forEachBlockwise(m_parallelFor, m_set.pairs.size(), [&](size_t i) { storeImpulses(m_set.pairs[i]); });
}

void ContactSolver::prepare(std::span<const SolverBody> bodies, std::span<Manifold* const> manifolds,
                            std::span<const std::pair<int, int>> bodyOf, const SolverSettings& settings) {
    prepareStates(m_set, bodies);
    m_coloring.build(bodies, bodyOf);
    m_set.pairs.clear();
    size_t count = 0;
    for (const uint32_t m : m_coloring.order()) {
        const auto [a, b] = bodyOf[m];
        m_set.states[size_t(a)].isConstrained = m_set.states[size_t(b)].isConstrained = true;
        m_set.pairs.push_back({a, b, count, count + manifolds[m]->all().size(), 1, manifolds[m]});
        count = m_set.pairs.back().to + 1;  // one more for an inscribed sphere
    }
    m_set.constraints.resize(count);
    forEachBlockwise(m_parallelFor, m_set.pairs.size(),
                     [&](size_t i) { preparePair(m_set, m_set.pairs[i], bodies, m_up, float(settings.seconds)); });
    addInscribedSpheresOfHit(m_set);
}

void ContactSolver::substep(std::span<SolverBody> bodies, glm::dvec3 gravity, const SolverSettings& settings,
                            bool isFirst) {
    const double h = settings.seconds / settings.substeps;
    const glm::vec3 fall = glm::vec3(gravity * h);
    for (size_t i = 1; i < bodies.size(); ++i) m_set.states[i].v += fall;
    if (!m_joints.empty()) m_joints.prepare(bodies, m_set.states, h);
    forEachPair([&](const PairConstraints& pair) { warmStart(pair, isFirst); });
    iterate(bodies, settings.iterations, h, true);
    move(bodies, gravity, h);
    iterate(bodies, settings.iterations, h, false);
    if (!m_joints.empty()) m_joints.accumulateForces(settings.seconds);
}

/// Starts a substep with the impulses of the one before, and adds those to the totals.
void ContactSolver::warmStart(const PairConstraints& pair, bool isFirst) {
    SolverState &A = m_set.stateA(pair), &B = m_set.stateB(pair);
    VelocityPair bodies(A, B);
    for (ContactConstraint& c : m_set.of(pair)) {
        if (!isFirst) c.totalImpulse += c.normalImpulse;
        bodies.applyNormalImpulse(c, c.normalImpulse);
        bodies.applyFrictionImpulse(c, c.tangentImpulse1, c.tangentImpulse2);
    }
    bodies.store(A, B);
}

void ContactSolver::iterate(std::span<const SolverBody> bodies, int iterations, double seconds, bool useBias) {
    for (int i = 0; i < iterations; ++i) {
        if (!m_joints.empty()) m_joints.solve(bodies, m_set.states, useBias);
        solveContacts(float(1.0 / seconds), useBias);
    }
}

void ContactSolver::solveContacts(float inverseSeconds, bool useBias) {
    forEachPair([&](const PairConstraints& pair) { solvePair(pair, inverseSeconds, useBias); });
    if (m_loadBearingPairs.empty()) return;
    for (int pass = 0; pass < m_loadBearingPasses; ++pass)
        for (const size_t i : m_loadBearingPairs) solvePair(m_set.pairs[i], inverseSeconds, useBias);
}

/// All normals of two bodies first, then their friction: an impulse that is too large is corrected by the next point's
/// before it limits friction.
void ContactSolver::solvePair(const PairConstraints& pair, float inverseSeconds, bool useBias) {
    SolverState &A = m_set.stateA(pair), &B = m_set.stateB(pair);
    const std::span<ContactConstraint> points = m_set.of(pair);
    const DeltaPair deltas(A, B);
    std::array<ContactBias, kMaxManifoldPoints + 1> biases;  // one more for an inscribed sphere
    for (size_t i = 0; i < points.size(); ++i) {
        biases[i] = biasOf(points[i], deltas, inverseSeconds, useBias);
        if (!useBias && (A.inertiaRotates || B.inertiaRotates)) rotateInertia(points[i], A, B);  // they have just moved
    }
    VelocityPair bodies(A, B);
    for (int pass = 0; pass < pair.passes; ++pass)
        for (size_t i = 0; i < points.size(); ++i) solveNormal(points[i], biases[i], bodies);
    for (ContactConstraint& c : points) solveFriction(c, bodies);
    bodies.store(A, B);
}

/// A point that is still apart may close by its separation within the substep (speculative contact). A penetration is
/// corrected by a soft constraint, at most at maxPushSpeed.
ContactSolver::ContactBias ContactSolver::biasOf(const ContactConstraint& c, const DeltaPair& deltas,
                                                 float inverseSeconds, bool useBias) const {
    const Float4 movement = deltas.position + deltas.rotationA * c.rA - deltas.rotationB * c.rB;
    const float s = c.separation + dot(movement, c.normal);
    if (s > 0.0f) return {s * inverseSeconds};
    if (!useBias) return {};
    const Softness<float>& soft = c.isStiff ? m_stiff : c.isStatic ? m_softStatic : m_soft;
    return {std::max(soft.biasRate * std::min(s + m_slop, 0.0f), -m_maxPushSpeed), soft.massScale, soft.impulseScale};
}

/// Recomputes effective masses after a body has rotated. With the old ones, the impulses on a spinning rod would be
/// larger than it takes to stop it, again and again.
void ContactSolver::rotateInertia(ContactConstraint& c, const SolverState& A, const SolverState& B) {
    const SimdMat3 inverseInertiaA(A.inverseInertia), inverseInertiaB(B.inverseInertia);
    c.angularChangeA = inverseInertiaA * c.angularA, c.angularChangeB = inverseInertiaB * c.angularB;
    const float inverseMass = A.inverseMass + B.inverseMass;
    c.normalMass = 1.0f / (inverseMass + dot(c.angularA, c.angularChangeA) + dot(c.angularB, c.angularChangeB));
    const auto effectiveMass = [&](const Float4& d) {
        const Float4 xa = cross(c.rA, d), xb = cross(c.rB, d);
        return 1.0f / (inverseMass + dot(xa, inverseInertiaA * xa) + dot(xb, inverseInertiaB * xb));
    };
    c.tangentMass1 = effectiveMass(c.tangent1), c.tangentMass2 = effectiveMass(c.tangent2);
}

void ContactSolver::solveNormal(ContactConstraint& c, const ContactBias& bias, VelocityPair& bodies) {
    const float old = c.normalImpulse;
    const float velocity = bodies.normalVelocity(c) + bias.velocity;
    c.normalImpulse = std::max(old - c.normalMass * bias.massScale * velocity - bias.impulseScale * old, 0.0f);
    c.maxImpulse = std::max(c.maxImpulse, c.normalImpulse);
    bodies.applyNormalImpulse(c, c.normalImpulse - old);
}

void ContactSolver::solveFriction(ContactConstraint& c, VelocityPair& bodies) {
    const Float4 relative = bodies.relativeVelocity(c);
    const float limit = c.friction * c.normalImpulse;
    float t1 = c.tangentImpulse1 - c.tangentMass1 * dot(relative, c.tangent1);
    float t2 = c.tangentImpulse2 - c.tangentMass2 * dot(relative, c.tangent2);
    const float size2 = t1 * t1 + t2 * t2;
    if (size2 > limit * limit) {
        const float scale = limit / std::sqrt(size2);
        t1 *= scale;
        t2 *= scale;
    }
    bodies.applyFrictionImpulse(c, t1 - c.tangentImpulse1, t2 - c.tangentImpulse2);
    c.tangentImpulse1 = t1;
    c.tangentImpulse2 = t2;
}

void ContactSolver::move(std::span<SolverBody> bodies, glm::dvec3 gravity, double h) {
    forEachBlockwise(m_parallelFor, bodies.size() - 1,
                     [&](size_t i) { moveBody(bodies[i + 1], m_set.states[i + 1], m_start[i + 1], gravity, h); });
}

/// Integrates the pose. A body without constraints stays in double: free flight is not rounded to float.
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

/// Restitution: points that were approached faster than the threshold, and took an impulse, shall recede at
/// restitution * approach.
void ContactSolver::bounce(float threshold) {
    for (const PairConstraints& pair : m_set.pairs) {
        const std::span<ContactConstraint> points = m_set.of(pair);
        const auto bounces = [&](const ContactConstraint& c) {
            return c.restitution != 0.0f && c.initialNormalVelocity <= -threshold && c.maxImpulse != 0.0f;
        };
        if (std::none_of(points.begin(), points.end(), bounces)) continue;
        SolverState &A = m_set.stateA(pair), &B = m_set.stateB(pair);
        VelocityPair bodies(A, B);
        for (int pass = 0; pass < kBouncePasses; ++pass)
            for (ContactConstraint& c : points) {
                if (!bounces(c)) continue;
                // Kept apart from the normal impulse, with which the next step starts.
                const float old = c.bounceImpulse;
                c.bounceImpulse = std::max(
                    old - c.normalMass * (bodies.normalVelocity(c) + c.restitution * c.initialNormalVelocity), 0.0f);
                bodies.applyNormalImpulse(c, c.bounceImpulse - old);
            }
        bodies.store(A, B);
    }
}

void ContactSolver::storeImpulses(const PairConstraints& pair) {
    for (ContactConstraint& c : m_set.of(pair)) {
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
        c.point->approach = -c.initialNormalVelocity;
    }
}

}  // namespace rubble
