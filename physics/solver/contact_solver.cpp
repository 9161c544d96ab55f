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
// n. What closes fast and is elastic bounces before each iteration: see restitution.cpp.

namespace rubble {
namespace {

constexpr float kDeep = 0.03f;         ///< metres by which a hit may end deeper than it began
constexpr double kMaxRotations = 1e3;  ///< in a step
constexpr double kMaxRotation = 0.3;   ///< radians by which a free body rotates in one go
constexpr double kArcRotation = 0.1;   ///< radians in a step from which a path is an arc, so that its poses are kept
constexpr float kConverged = 1e-3f;    ///< share of a pair's largest impulse by which none of them changes any more
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
    m_restitution.begin(m_set, float(settings.restitutionThreshold));
    m_loadBearingPasses = settings.loadBearingPasses;
    m_loadBearing.clear();
    if (settings.loadBearingPasses > 0 && weight > 0.0)
        m_loadBearing.find(m_set, m_up, float(weight * h), float(settings.loadBearingRatio));
    m_start.resize(bodies.size());
    for (size_t i = 0; i < bodies.size(); ++i) m_start[i] = bodies[i].rotation;
    for (int i = 0; i < settings.substeps; ++i) substep(bodies, gravity, settings, i == 0);
    for (size_t i = 1; i < bodies.size(); ++i)
        if (const SolverState& state = m_set.states[i]; state.isConstrained)
            bodies[i].velocity = state.v, bodies[i].angularVelocity = state.w;
        else
            moveFreely(bodies[i], gravity, settings.seconds, m_paths[i]);
    forEachBlockwise(m_parallelFor, m_set.pairs.size(), [&](size_t i) { storeImpulses(m_set.pairs[i]); });
}

void ContactSolver::prepare(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
                            std::span<const std::pair<int, int>> bodyOf, const SolverSettings& settings) {
    prepareStates(m_set, bodies);
    m_coloring.build(bodies, bodyOf);
    m_set.pairs.clear();
    size_t count = 0;
    for (const uint32_t m : m_coloring.order()) {
        const auto [a, b] = bodyOf[m];
        m_set.states[size_t(a)].isConstrained = m_set.states[size_t(b)].isConstrained = true;
        m_set.pairs.push_back({a, b, count, count + manifolds[m]->all().size(), 1, false, false, manifolds[m]});
        count = m_set.pairs.back().to;
    }
    m_set.constraints.resize(count);
    const bool anyRound =
        std::any_of(manifolds.begin(), manifolds.end(), [](const Manifold* manifold) { return manifold->isRound; });
    m_set.rounds.assign(anyRound ? count : 0, {});
    forEachBlockwise(m_parallelFor, m_set.pairs.size(),
                     [&](size_t i) { preparePair(m_set, m_set.pairs[i], bodies, m_up); });
    if (m_paths.size() < bodies.size()) m_paths.resize(bodies.size());
    for (size_t i = 0; i < bodies.size(); ++i) {
        m_paths[i].clear();
        m_set.states[i].keepsPath = glm::length(bodies[i].angularVelocity) * settings.seconds > kArcRotation;
    }
    for (const PairConstraints& pair : m_set.pairs) {
        if (!pair.isHit) continue;
        m_set.stateA(pair).keepsPath = m_set.stateB(pair).keepsPath = true;
        if (settings.hitsConserve)
            bodies[size_t(pair.a)].conservesMomentum = bodies[size_t(pair.b)].conservesMomentum = true;
    }
}

void ContactSolver::substep(std::span<SolverBody> bodies, glm::dvec3 gravity, const SolverSettings& settings,
                            bool isFirst) {
    const double h = settings.seconds / settings.substeps;
    const glm::vec3 fall = glm::vec3(gravity * h);
    for (size_t i = 1; i < bodies.size(); ++i) m_set.states[i].v += fall;
    if (!m_joints.empty()) m_joints.prepare(bodies, m_set.states, h);
    forEachPair([&](const PairConstraints& pair) { warmStart(pair, isFirst); });
    m_restitution.solve(m_set, float(h), bodies, m_joints);
    iterate(bodies, settings.iterations, h, true);
    move(bodies, h);
    m_restitution.solve(m_set, float(h), bodies, m_joints);
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
    for (int pass = 0; pass < m_loadBearingPasses; ++pass)
        for (const size_t i : m_loadBearing.pairs()) solvePair(m_set.pairs[i], inverseSeconds, useBias);
}

/// All normals of two bodies first, then their friction: an impulse that is too large is corrected by the next point's
/// before it limits friction.
void ContactSolver::solvePair(const PairConstraints& pair, float inverseSeconds, bool useBias) {
    SolverState &A = m_set.stateA(pair), &B = m_set.stateB(pair);
    const std::span<ContactConstraint> points = m_set.of(pair);
    const DeltaPair deltas(A, B);
    std::array<ContactBias, kMaxManifoldPoints> biases;
    for (size_t i = 0; i < points.size(); ++i) {
        biases[i] = biasOf(points[i], deltas, inverseSeconds, useBias);
        // They have just moved. With the old effective masses, the impulses on a spinning rod would be larger than it
        // takes to stop it, again and again.
        if (!useBias && (pair.isFollowed || A.inertiaRotates || B.inertiaRotates)) updateJacobian(points[i], A, B);
    }
    VelocityPair bodies(A, B);
    for (int pass = 0; pass < pair.passes; ++pass) {
        float changed = 0.0f, largest = 0.0f;  // N s
        for (size_t i = 0; i < points.size(); ++i) {
            changed = std::max(changed, solveNormal(points[i], biases[i], bodies));
            largest = std::max(largest, points[i].normalImpulse);
        }
        if (changed <= kConverged * largest) break;
    }
    for (ContactConstraint& c : points)
        bodies.solveFriction(c, c.friction * c.normalImpulse, c.tangentImpulse1, c.tangentImpulse2);
    bodies.store(A, B);
}

/// Whether the end of the step has a point of the pair deeper than contacts are left.
bool ContactSolver::isDeep(const PairConstraints& pair) {
    const DeltaPair deltas(m_set.stateA(pair), m_set.stateB(pair));
    for (const ContactConstraint& c : m_set.of(pair))
        if (c.totalImpulse + c.bounceImpulse > 0.0f && deltas.separation(c) < std::min(c.separation, 0.0f) - kDeep)
            return true;
    return false;
}

/// A point that is still apart may close by its separation within the substep (speculative contact). A penetration is
/// corrected by a soft constraint, at most at maxPushSpeed.
ContactSolver::ContactBias ContactSolver::biasOf(const ContactConstraint& c, const DeltaPair& deltas,
                                                 float inverseSeconds, bool useBias) const {
    const float s = deltas.separation(c);
    if (s > 0.0f) return {s * inverseSeconds};
    if (!useBias) return {};
    const Softness<float>& soft = c.isStiff ? m_stiff : c.isStatic ? m_softStatic : m_soft;
    return {std::max(soft.biasRate * std::min(s + m_slop, 0.0f), -m_maxPushSpeed), soft.massScale, soft.impulseScale};
}

/// Returns by how much the impulse changed, N s.
float ContactSolver::solveNormal(ContactConstraint& c, const ContactBias& bias, VelocityPair& bodies) {
    const float old = c.normalImpulse;
    const float velocity = bodies.normalVelocity(c) + bias.velocity;
    c.normalImpulse = std::max(old - c.normalMass * bias.massScale * velocity - bias.impulseScale * old, 0.0f);
    bodies.applyNormalImpulse(c, c.normalImpulse - old);
    return std::abs(c.normalImpulse - old);
}

void ContactSolver::move(std::span<SolverBody> bodies, double h) {
    forEachBlockwise(m_parallelFor, bodies.size() - 1, [&](size_t i) {
        SolverBody& body = bodies[i + 1];
        SolverState& state = m_set.states[i + 1];
        if (!state.isConstrained) return;
        moveConstrained(body, state, m_start[i + 1], h);
        if (state.keepsPath) m_paths[i + 1].push_back({body.position, body.rotation});
    });
}

/// Integrates the pose of a body whose velocity the constraints have set.
void ContactSolver::moveConstrained(SolverBody& body, SolverState& state, const glm::dquat& start, double h) {
    body.velocity = state.v;
    body.angularVelocity = state.w;
    const glm::dvec3 displacement = body.velocity * h;
    body.position += displacement;
    rotateBody(body, h);
    state.deltaPosition += glm::vec3(displacement);
    state.deltaRotation = glm::mat3(glm::mat3_cast(body.rotation * glm::conjugate(start)) - glm::dmat3(1.0));
    if (body.conservesMomentum) {
        state.w = glm::vec3(body.angularVelocity);
        state.inverseInertia = glm::mat3(worldInverseInertia(body));
        state.inertiaRotates = true;
    }
}

/// Integrates the pose of a body without constraints through the whole step: exactly, in constant gravity, and in
/// double, so that free flight is not rounded to float.
void ContactSolver::moveFreely(SolverBody& body, const glm::dvec3& gravity, double seconds, std::vector<Pose>& path) {
    const glm::dvec3 from = body.position, displacement = (body.velocity + gravity * (0.5 * seconds)) * seconds;
    body.velocity += gravity * seconds;
    const double angle = glm::length(body.angularVelocity) * seconds;
    const int parts = angle > kMaxRotation ? int(std::ceil(std::min(angle / kMaxRotation, kMaxRotations))) : 1;
    for (int i = 1; i <= parts; ++i) {
        rotateBody(body, seconds / parts);
        body.position = i < parts ? from + displacement * (double(i) / parts) : from + displacement;
        if (parts > 1) path.push_back({body.position, body.rotation});
    }
}

void ContactSolver::storeImpulses(const PairConstraints& pair) {
    pair.manifold->isPenetrating = pair.isHit && isDeep(pair);
    for (ContactConstraint& c : m_set.of(pair)) {
        c.totalImpulse += c.normalImpulse;
        c.totalImpulse += c.bounceImpulse;
        c.point->normalImpulse = c.normalImpulse;
        c.point->frictionImpulse =
            vec3(c.tangent1 * float4(c.tangentImpulse1) + c.tangent2 * float4(c.tangentImpulse2));
        c.point->totalImpulse = c.totalImpulse;
        c.point->approach = -c.initialNormalVelocity;
    }
}

}  // namespace rubble
