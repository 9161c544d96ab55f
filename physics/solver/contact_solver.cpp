#include "physics/solver/contact_solver.h"

#include <algorithm>
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
//
// Eight pairs that share no body are solved at once, one in each lane of the processor's registers: LanePacking forms
// such groups, contact_kernels.cpp solves them by the formulas of contact_math.h. The groups, and so the bits, do not
// depend on the processor. Threads take ranges of groups that share no body: see ConstraintColoring.

namespace rubble {
namespace {

constexpr size_t kGroupsPerTask = 8;
constexpr float kDeep = 0.03f;         ///< metres by which a hit may end deeper than it began
constexpr double kMaxRotations = 1e3;  ///< in a step
constexpr double kMaxRotation = 0.3;   ///< radians by which a free body rotates in one go
constexpr double kArcRotation = 0.1;   ///< radians in a step from which a path is an arc, so that its poses are kept
constexpr double kLoadBearingStiffness = 4.0;  ///< times contactHertz, for contacts of load-bearing bodies

}  // namespace

void ContactSolver::solve(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
                          std::span<const std::pair<int, int>> bodyOf, glm::dvec3 gravity,
                          const SolverSettings& settings, std::span<JointConstraint* const> joints) {
    const double h = settings.seconds / settings.substeps;
    const double hertz = std::min(settings.contactHertz, 0.25 / h);
    m_softness = {makeSoft<float>(hertz, settings.dampingRatio, h),
                  makeSoft<float>(2.0 * hertz, settings.dampingRatio, h),
                  makeSoft<float>(kLoadBearingStiffness * hertz, settings.dampingRatio, h)};
    m_parallelFor = settings.parallelFor;
    const double weight = glm::length(gravity);
    m_up = weight > 0.0 ? glm::vec3(gravity / -weight) : glm::vec3(0.0f);
    m_torsionRadius = float(settings.torsionRadius);
    prepare(bodies, manifolds, bodyOf, settings);
    m_joints.begin(joints, m_set.states);
    m_warmStartFilter.reject(m_set);
    m_loadBearing.clear();
    if (settings.loadBearingPasses > 0 && weight > 0.0)
        m_loadBearing.find(m_set, m_up, float(weight * h), float(settings.loadBearingRatio));
    packGroups(bodies, bodyOf);
    m_restitution.begin(m_set, float(settings.minReboundSpeed));
    m_steadyBodies.begin(m_set, bodies);
    m_start.resize(bodies.size());
    for (size_t i = 0; i < bodies.size(); ++i) m_start[i] = bodies[i].rotation;
    for (int i = 0; i < settings.substeps; ++i) substep(bodies, gravity, settings, i == 0);
    for (size_t i = 1; i < bodies.size(); ++i)
        if (const SolverState& state = m_set.states[i]; state.isConstrained)
            bodies[i].velocity = state.v, bodies[i].angularVelocity = state.w;
        else
            moveFreely(bodies[i], gravity * double(bodies[i].gravityScale), settings.seconds, m_paths[i]);
    forEachBlockwise<kGroupsPerTask>(m_parallelFor, m_set.groups.size(),
                                     [&](size_t i) { storeImpulses(m_set.groups[i]); });
}

void ContactSolver::prepare(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds,
                            std::span<const std::pair<int, int>> bodyOf, const SolverSettings& settings) {
    prepareStates(m_set, bodies);
    m_set.pairs.clear();
    for (size_t i = 0; i < manifolds.size(); ++i) {
        const auto [a, b] = bodyOf[i];
        m_set.states[size_t(a)].isConstrained = m_set.states[size_t(b)].isConstrained = true;
        m_set.pairs.push_back({a, b, manifolds[i]});
    }
    forEachBlockwise(m_parallelFor, m_set.pairs.size(), [&](size_t i) { classifyPair(m_set, m_set.pairs[i], bodies); });
    while (m_paths.size() < bodies.size()) m_paths.emplace_back().reserve(size_t(settings.substeps));
    for (size_t i = 0; i < bodies.size(); ++i) {
        m_paths[i].clear();
        m_set.states[i].keepsPath = glm::length(bodies[i].angularVelocity) * settings.seconds > kArcRotation;
    }
    followHits(bodies, settings);
}

/// Bodies that are hit keep their paths and momentum; the contacts of bodies whose inertia rotates are followed.
void ContactSolver::followHits(std::span<SolverBody> bodies, const SolverSettings& settings) {
    for (const PairConstraints& pair : m_set.pairs) {
        if (!pair.isHit) continue;
        m_set.stateA(pair).keepsPath = m_set.stateB(pair).keepsPath = true;
        if (!settings.hitsConserve) continue;
        for (SolverBody* body : {&bodies[size_t(pair.a)], &bodies[size_t(pair.b)]})
            body->conservesMomentum |= !hasEqualMoments(*body);
    }
    for (PairConstraints& pair : m_set.pairs)
        pair.isFollowed |= (pair.a && bodies[size_t(pair.a)].conservesMomentum) ||
                           (pair.b && bodies[size_t(pair.b)].conservesMomentum);
}

/// Orders the pairs, and fills in the groups that are solved at once.
void ContactSolver::packGroups(std::span<const SolverBody> bodies, std::span<const std::pair<int, int>> bodyOf) {
    m_coloring.build(bodies, bodyOf);
    m_packing.begin(m_set);
    m_coloring.replaceRanges([&](size_t from, size_t to) {
        const size_t first = m_set.groups.size();
        m_packing.pack(m_set, m_coloring.order().subspan(from, to - from));
        return std::pair(first, m_set.groups.size());
    });
    if (m_set.contacts.size() < m_set.contactCount) {
        m_set.contacts.resize(m_set.contactCount);
        m_set.starts.resize(m_set.contactCount);
    }
    const ContactArrays set = arrays();
    forEachBlockwise<kGroupsPerTask>(m_parallelFor, m_set.groups.size(), [&](size_t i) {
        fillGroup(m_set, m_set.groups[i], bodies, m_up, m_softness, m_torsionRadius);
        m_kernels->prepare(set, i, i + 1);
    });
    m_stiffGroups.clear();
    for (const size_t pair : m_loadBearing.pairs())
        if (!m_set.pairs[pair].points().empty()) m_stiffGroups.push_back(m_set.pairs[pair].group);
    std::sort(m_stiffGroups.begin(), m_stiffGroups.end());
    m_stiffGroups.erase(std::unique(m_stiffGroups.begin(), m_stiffGroups.end()), m_stiffGroups.end());
}

void ContactSolver::substep(std::span<SolverBody> bodies, glm::dvec3 gravity, const SolverSettings& settings,
                            bool isFirst) {
    const double h = settings.seconds / settings.substeps;
    m_steadyBodies.startSubstep(m_set, glm::vec3(gravity * h), isFirst);
    if (!m_joints.empty()) m_joints.prepare(bodies, m_set.states, gravity * h, h);
    const ContactArrays set = arrays();
    const auto warmStart = [&](size_t from, size_t to) { m_kernels->warmStart(set, from, to, isFirst); };
    m_coloring.run(m_parallelFor, std::ref(warmStart));  // a copy would take memory
    m_restitution.solve(m_set, float(h), bodies, m_joints);
    ContactPass pass{float(1.0 / h), float(settings.maxPushSpeed), float(settings.slop)};
    pass.useBias = true, pass.addsTotals = !isFirst;
    iterate(bodies, settings, pass);
    move(bodies, h);
    if (!m_joints.empty()) m_joints.followMove(bodies, m_set.states);
    m_restitution.solve(m_set, float(h), bodies, m_joints);
    pass.useBias = pass.addsTotals = false, pass.haveMoved = true;
    iterate(bodies, settings, pass);
    if (!m_joints.empty()) m_joints.endSubstep(m_set.states, settings.seconds);
}

void ContactSolver::iterate(std::span<const SolverBody> bodies, const SolverSettings& settings, ContactPass pass) {
    const ContactArrays set = arrays();
    const auto solve = [&](size_t from, size_t to) { m_kernels->solve(set, from, to, pass); };
    for (int i = 0; i < settings.iterations; ++i) {
        if (!m_joints.empty()) m_joints.solve(bodies, m_set.states, pass.useBias);
        m_coloring.run(m_parallelFor, std::ref(solve));
        pass.addsTotals = pass.haveMoved = false;
        for (int k = 0; k < settings.loadBearingPasses; ++k)
            for (const uint32_t group : m_stiffGroups) m_kernels->solve(set, group, group + 1, pass);
    }
}

/// Whether the end of the step has a point of the pair deeper than contacts are left.
bool ContactSolver::isDeep(const PairConstraints& pair) {
    const MotionPair<float> motion = motionsOf(m_set.stateA(pair), m_set.stateB(pair));
    for (size_t i = 0; i < pair.points().size(); ++i) {
        const Contact<float> c = m_set.contact(pair, i);
        const float before = m_set.start(pair, i).separation;
        if (c.totalImpulse > 0.0f && m_set.separation(pair, i, c, motion) < std::min(before, 0.0f) - kDeep) return true;
    }
    return false;
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

/// Group after group, as their lanes lie.
void ContactSolver::storeImpulses(const PairGroup& group) {
    for (size_t lane = 0; lane < kLanes; ++lane) {
        if (group.pair[lane] == PairGroup::kNone) continue;
        const PairConstraints& pair = m_set.pairs[group.pair[lane]];
        pair.manifold->isPenetrating = pair.isHit && isDeep(pair);
        pair.manifold->torsionImpulse = group.anyTorsion ? group.torsionImpulse.at[lane] : 0.0f;
        const Contact<Lanes>* c = &m_set.contacts[group.from];
        for (ManifoldPoint& point : pair.points()) {
            const auto vector = [&](const Vec3<Lanes>& v) {
                return glm::vec3(v.x.at[lane], v.y.at[lane], v.z.at[lane]);
            };
            point.normalImpulse = c->normalImpulse.at[lane];
            point.frictionImpulse =
                vector(c->tangent1) * c->tangentImpulse1.at[lane] + vector(c->tangent2) * c->tangentImpulse2.at[lane];
            point.totalImpulse = c->totalImpulse.at[lane] + point.normalImpulse;
            ++c;
        }
    }
}

}  // namespace rubble
