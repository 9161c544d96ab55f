#include "physics/solver/restitution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

// Restitution of simultaneous impacts by sequential impacts.
//
// A pair whose points close at v_i shall part at e_i v_i (Newton). Impulses that are solved together share an impact
// among all that touch: five balls in a row would go on together. In an elastic row each ball hands the impact on to
// the next one before anything else happens. So pairs are taken one after the other, first those that close, then those
// that touch what was hit, until nothing closes any more (Ivanov, "On multiple impact", 1995; Smith et al.,
// "Reflections on Simultaneous Impact", 2012). Within a pair the points are solved together, so that a box lands flat.
// Each impact keeps the momentum and adds no energy; so does the row.

namespace rubble {
namespace {

constexpr int kPasses = 16;               ///< over the points of a pair
constexpr float kConvergedSpeed = 1e-4f;  ///< share of the fastest point's speed by which none changes any more
constexpr uint8_t kMaxImpacts = 32;       ///< of a pair in a substep
constexpr int kMaxJointRounds = 64;       ///< in a substep, over all joints
constexpr int kJointRounds = 4;           ///< in an impact of what is jointed

}  // namespace

float Restitution::reboundSpeed(const ManifoldPoint& point, float velocity) const {
    const float rebound = -point.restitution * velocity;
    return rebound > m_minRebound ? rebound : 0.0f;
}

void Restitution::begin(ContactSet& set, float minRebound) {
    m_minRebound = minRebound;
    m_fast.clear();
    for (size_t i = 0; i < set.pairs.size(); ++i)
        if (set.pairs[i].reboundSpeed > minRebound) m_fast.push_back(i);
    if (m_fast.empty()) return;
    m_isQueued.assign(set.pairs.size(), false);
    m_impacts.assign(set.pairs.size(), 0);
    findNeighbours(set);
}

void Restitution::findNeighbours(const ContactSet& set) {
    const auto forEachElastic = [&](auto&& f) {
        for (size_t i = 0; i < set.pairs.size(); ++i)
            if (set.pairs[i].isElastic)
                for (const int body : {set.pairs[i].a, set.pairs[i].b})
                    if (body) f(size_t(body), i);
    };
    m_ends.assign(set.states.size() + 1, 0);
    forEachElastic([&](size_t body, size_t) { ++m_ends[body + 1]; });
    std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
    m_neighbours.resize(m_ends.back());
    forEachElastic([&](size_t body, size_t pair) { m_neighbours[m_ends[body]++] = pair; });
}

void Restitution::queue(size_t pair) {
    if (m_isQueued[pair]) return;
    m_isQueued[pair] = true;
    m_queue.push_back(pair);
}

void Restitution::solve(ContactSet& set, float seconds, std::span<const SolverBody> bodies, JointSolver& joints) {
    if (m_fast.empty()) return;
    std::fill(m_impacts.begin(), m_impacts.end(), uint8_t(0));
    m_jointRounds = kMaxJointRounds;
    m_queue.clear();
    for (const size_t pair : m_fast) queue(pair);
    for (size_t next = 0; next < m_queue.size(); ++next) {
        const size_t number = m_queue[next];
        m_isQueued[number] = false;
        const PairConstraints& pair = set.pairs[number];
        if (m_impacts[number] == kMaxImpacts || !isAboutToBounce(set, pair, seconds)) continue;
        ++m_impacts[number];
        collide(set, pair, seconds, bodies, joints);
        for (const int body : {pair.a, pair.b})
            for (size_t i = body ? m_ends[size_t(body) - 1] : m_ends[0]; i < m_ends[size_t(body)]; ++i)  // none of 0
                if (m_neighbours[i] != number) queue(m_neighbours[i]);
    }
}

/// Whether a point of the pair will touch within the substep and bounce.
bool Restitution::isAboutToBounce(ContactSet& set, const PairConstraints& pair, float seconds) const {
    const SolverState &A = set.stateA(pair), &B = set.stateB(pair);
    const MotionPair<float> motion = motionsOf(A, B);
    const VelocityPair<float> velocities = velocitiesOf(A, B);
    for (size_t i = 0; i < pair.points().size(); ++i) {
        if (!(pair.points()[i].restitution > 0.0f)) continue;
        const Contact<float> c = set.contact(pair, i);
        const float velocity = velocities.normalVelocity(c);
        if (reboundSpeed(pair.points()[i], velocity) > 0.0f &&
            set.separation(pair, i, c, motion) + velocity * seconds < 0.0f)
            return true;
    }
    return false;
}

void Restitution::collide(ContactSet& set, const PairConstraints& pair, float seconds,
                          std::span<const SolverBody> bodies, JointSolver& joints) {
    SolverState &A = set.stateA(pair), &B = set.stateB(pair);
    struct Touch {
        float target = 0.0f, impulse = 0.0f, tangent1 = 0.0f, tangent2 = 0.0f;  ///< m/s, then N s
        bool isTouching = false;
    };
    std::array<Touch, kMaxManifoldPoints> touches;
    std::array<Contact<float>, kMaxManifoldPoints> points;
    const size_t count = pair.points().size();
    float fastest = 0.0f;
    const MotionPair<float> motion = motionsOf(A, B);
    const VelocityPair<float> before = velocitiesOf(A, B);
    for (size_t i = 0; i < count; ++i) {
        points[i] = set.contact(pair, i);
        updateJacobian(points[i], set.start(pair, i), set.isRound(pair), motion, before);
        const float velocity = before.normalVelocity(points[i]);
        points[i].currentSeparation = set.separation(pair, i, points[i], motion);
        touches[i].isTouching = points[i].currentSeparation + velocity * seconds < 0.0f;
        touches[i].target = reboundSpeed(pair.points()[i], velocity);
        fastest = std::max(fastest, -velocity);
    }
    const bool isJointed = (A.isJointed || B.isJointed) && !joints.empty();
    for (int round = 0; round < (isJointed ? kJointRounds : 1); ++round) {
        VelocityPair<float> velocities = velocitiesOf(A, B);
        for (int pass = 0; pass < kPasses; ++pass) {
            float changed = 0.0f;  // m/s
            for (size_t i = 0; i < count; ++i) {
                Touch& touch = touches[i];
                if (!touch.isTouching) continue;
                const float old = touch.impulse, missing = touch.target - velocities.normalVelocity(points[i]);
                touch.impulse = std::max(old + points[i].normalMass * missing, 0.0f);
                velocities.applyNormalImpulse(points[i], touch.impulse - old);
                if (touch.impulse != old) changed = std::max(changed, std::abs(missing));
            }
            for (size_t i = 0; i < count; ++i)
                if (touches[i].isTouching)
                    velocities.solveFriction(points[i], points[i].friction * touches[i].impulse, touches[i].tangent1,
                                             touches[i].tangent2);
            if (changed <= kConvergedSpeed * fastest) break;
        }
        storeVelocities(velocities, A, B);
        if (isJointed && m_jointRounds-- > 0) joints.solveImpact(bodies, set.states);
    }
    for (size_t i = 0; i < count; ++i) {
        points[i].totalImpulse += touches[i].impulse;
        set.setContact(pair, i, points[i]);
    }
    A.isSteady = B.isSteady = false;
}

}  // namespace rubble
