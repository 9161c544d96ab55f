#include "physics/contact_solver.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr int kHitPasses = 2, kFastPasses = 8;  ///< over the normals of two bodies that meet; over others one
constexpr float kHit = 1.0f, kFast = 20.0f;     ///< m/s
constexpr float kSameFace = 0.9f;               ///< cosine between normals of one face
constexpr float kSlope = 0.3f;                  ///< how far up a normal points where one body lies on the other
constexpr float kJolt = 4.0f;                   ///< m/s that the impulses of the last step may give a body before they count as out of balance
constexpr int kBalanceRounds = 4;               ///< in which those that were held by what is out of balance follow
constexpr size_t kBlock = 64;                   ///< bodies or pairs that a thread takes at once
constexpr size_t kWorthIt = 4;                  ///< blocks from which on threads are asked
constexpr double kStiffer = 4.0;                ///< times as stiff, in hertz, are contacts of what bears

/// Two directions across the normal.
void tangentsOf(const glm::vec3& n, glm::vec3& t1, glm::vec3& t2) {
    t1 = std::abs(n.x) > 0.57f ? glm::vec3(n.y, -n.x, 0.0f) : glm::vec3(0.0f, n.z, -n.y);
    t1 /= std::sqrt(glm::dot(t1, t1));
    t2 = glm::cross(n, t1);
}

}  // namespace

/// Kept in registers, not in m_states, while the contacts of two bodies are gone through.
struct ContactSolver::Moving {
    Moving(const SolverState& A, const SolverState& B)
        : vA(four(A.v)),
          wA(four(A.w)),
          vB(four(B.v)),
          wB(four(B.w)),
          massA(A.inverseMass),
          massB(B.inverseMass),
          inertiaA(A.inverseInertia),
          inertiaB(B.inverseInertia) {}
    /// The world is not written to: several threads read it.
    void store(SolverState& A, SolverState& B) const {
        if (massA != 0.0f) A.v = vec3(vA), A.w = vec3(wA);
        if (massB != 0.0f) B.v = vec3(vB), B.w = vec3(wB);
    }

    float speedAlong(const Constraint& c) const {
        const Four parts = c.normal * (vA - vB) + c.leverA * wA - c.leverB * wB;
        return parts[0] + parts[1] + parts[2];
    }
    Four relativeVelocity(const Constraint& c) const { return vA + cross(wA, c.rA) - vB - cross(wB, c.rB); }
    /// An impulse along the normal.
    void push(const Constraint& c, float impulse) {
        vA += c.normal * four(impulse * massA);
        wA += c.spinA * four(impulse);
        vB -= c.normal * four(impulse * massB);
        wB -= c.spinB * four(impulse);
    }
    /// Impulses along the tangents.
    void rub(const Constraint& c, float impulse1, float impulse2) {
        const Four impulse = c.tangent1 * four(impulse1) + c.tangent2 * four(impulse2);
        vA += impulse * four(massA);
        wA += inertiaA * cross(c.rA, impulse);
        vB -= impulse * four(massB);
        wB -= inertiaB * cross(c.rB, impulse);
    }

    Four vA, wA, vB, wB;
    float massA, massB;
    FourColumns inertiaA, inertiaB;
};

/// How two bodies have moved since the step began.
struct ContactSolver::Moved {
    Moved(const SolverState& A, const SolverState& B) : way(four(A.moved - B.moved)), turnedA(A.turned), turnedB(B.turned) {}
    Four way;
    FourColumns turnedA, turnedB;
};

template <class F>
void ContactSolver::forEach(size_t count, F&& f) const {
    const auto runBlock = [&](size_t block) {
        for (size_t i = block * kBlock; i < std::min(count, (block + 1) * kBlock); ++i) f(i);
    };
    if (m_parallelFor && count >= kWorthIt * kBlock) return (*m_parallelFor)((count + kBlock - 1) / kBlock, runBlock);
    for (size_t i = 0; i < count; ++i) f(i);
}

template <class F>
void ContactSolver::forRanges(F&& f) {
    m_strips.run(m_parallelFor, [&](size_t from, size_t to) {
        for (size_t i = from; i < to; ++i) f(m_ranges[i]);
    });
}

ContactSolver::Softness ContactSolver::soften(double hertz, double dampingRatio, double seconds) {
    const double omega = 2.0 * 3.14159265358979 * hertz;
    const double a1 = 2.0 * dampingRatio + seconds * omega, a2 = seconds * omega * a1, a3 = 1.0 / (1.0 + a2);
    return {float(omega / a1), float(a2 * a3), float(a3)};
}

/// Two that meet so fast that one could turn its way past the few points which touch it: their cores, spheres as wide as their
/// smallest sides, may not pass the plane that they meet at, however they tumble.
void ContactSolver::addCore(Range& range, const Constraint& fastest) {
    const SolverState &A = m_states[size_t(range.a)], &B = m_states[size_t(range.b)];
    Constraint core = fastest;
    core.separation = 1e9f;  // of the point that leaves the cores least: the fastest may be one that a spin brings round from above
    for (size_t i = range.from; i < range.to; ++i) {
        const Constraint& c = m_constraints[i];
        if (dot(c.normal, core.normal) < kSameFace) continue;
        const float overA = range.a ? std::max(0.0f, -dot(c.rA, c.normal) - A.reach) : 0.0f;
        const float overB = range.b ? std::max(0.0f, dot(c.rB, c.normal) - B.reach) : 0.0f;
        core.separation = std::min(core.separation, c.separation + overA + overB);
    }
    core.rA = core.rB = core.leverA = core.leverB = core.spinA = core.spinB = four(0.0f);
    core.normalMass = 1.0f / (A.inverseMass + B.inverseMass);
    core.friction = core.restitution = 0.0f;
    core.normalImpulse = core.tangentImpulse1 = core.tangentImpulse2 = 0.0f;
    core.isCore = true;
    m_constraints[range.to++] = core;
}

void ContactSolver::prepare(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds, std::span<const std::pair<int, int>> bodyOf,
                            float seconds) {
    m_states.assign(bodies.size(), {});
    for (size_t i = 1; i < bodies.size(); ++i) {
        SolverState& state = m_states[i];
        state.v = glm::vec3(bodies[i].velocity);
        state.w = glm::vec3(bodies[i].angularVelocity);
        state.inverseMass = float(bodies[i].inverseMass);
        state.reach = float(bodies[i].reach);
        state.inverseInertia = glm::mat3(worldInverseInertia(bodies[i]));
    }
    m_strips.layOut(bodies, bodyOf);
    m_ranges.clear();
    size_t count = 0;
    for (const uint32_t m : m_strips.order()) {
        const auto [a, b] = bodyOf[m];
        m_states[size_t(a)].touches = m_states[size_t(b)].touches = true;
        m_ranges.push_back({a, b, count, count + manifolds[m]->all().size(), 1, manifolds[m]});
        count = m_ranges.back().to + 1;  // there may be a core
    }
    m_constraints.resize(count);
    forEach(m_ranges.size(), [&](size_t i) { prepareRange(m_ranges[i], bodies, seconds); });
    addCoresOfHit();
}

/// What a fast one hits is knocked against the world within the step, and may turn its way past it as well.
void ContactSolver::addCoresOfHit() {
    bool any = false;
    for (const Range& range : m_ranges)
        if (range.hasCore()) m_states[size_t(range.a)].isHit = m_states[size_t(range.b)].isHit = any = true;
    if (!any) return;
    for (Range& range : m_ranges) {
        if ((range.a && range.b) || !m_states[size_t(range.a + range.b)].isHit || range.hasCore()) continue;
        const auto from = m_constraints.begin() + std::ptrdiff_t(range.from), to = m_constraints.begin() + std::ptrdiff_t(range.to);
        const Constraint fastest = *std::min_element(from, to, [](const Constraint& c, const Constraint& d) { return c.approach < d.approach; });
        addCore(range, fastest);
    }
}

void ContactSolver::prepareRange(Range& range, std::span<const SolverBody> bodies, float seconds) {
    const int a = range.a, b = range.b;
    const SolverState &A = m_states[size_t(a)], &B = m_states[size_t(b)];
    const glm::vec3 originA = glm::vec3(range.manifold->origin - bodies[size_t(a)].position);
    const glm::vec3 originB = glm::vec3(range.manifold->origin - bodies[size_t(b)].position);
    size_t fastest = range.from, at = range.from;
    float nearing = 0.0f;  // m/s, of a point or of all of the two: a spinning body may come while the points that touch go
    for (ManifoldPoint& point : range.points()) {
        Constraint& c = m_constraints[at++];
        const glm::vec3 half = point.normal * (0.5f * point.separation);  // far apart before a fast hit: where each is touched
        const glm::vec3 rA = a ? originA + point.position + half : glm::vec3(0.0f), rB = b ? originB + point.position - half : glm::vec3(0.0f);
        glm::vec3 tangent1, tangent2;
        tangentsOf(point.normal, tangent1, tangent2);
        const auto massAlong = [&](const glm::vec3& d) {
            const glm::vec3 xa = glm::cross(rA, d), xb = glm::cross(rB, d);
            const float k = A.inverseMass + B.inverseMass + glm::dot(xa, A.inverseInertia * xa) + glm::dot(xb, B.inverseInertia * xb);
            return k > 0.0f ? 1.0f / k : 0.0f;
        };
        c.normal = four(point.normal), c.tangent1 = four(tangent1), c.tangent2 = four(tangent2);
        c.rA = four(rA), c.rB = four(rB);
        c.leverA = cross(c.rA, c.normal), c.leverB = cross(c.rB, c.normal);
        c.spinA = four(A.inverseInertia * vec3(c.leverA)), c.spinB = four(B.inverseInertia * vec3(c.leverB));
        c.normalMass = massAlong(point.normal);
        c.tangentMass1 = massAlong(tangent1);
        c.tangentMass2 = massAlong(tangent2);
        c.separation = pushedSeparation(*range.manifold, point, m_up);
        c.friction = point.friction;
        c.restitution = point.restitution;
        c.approach = Moving(A, B).speedAlong(c);
        c.normalImpulse = point.normalImpulse;
        c.tangentImpulse1 = glm::dot(point.frictionImpulse, tangent1);
        c.tangentImpulse2 = glm::dot(point.frictionImpulse, tangent2);
        c.total = c.most = c.bounceImpulse = 0.0f;
        c.isStiff = c.isCore = false;
        c.isStatic = A.inverseMass == 0.0f || B.inverseMass == 0.0f;
        c.point = &point;
        if (c.approach < m_constraints[fastest].approach) fastest = at - 1;
        nearing = std::max({nearing, -c.approach, -glm::dot(A.v - B.v, point.normal)});
    }
    const float speed = -m_constraints[fastest].approach;
    range.passes = speed > kFast ? kFastPasses : speed > kHit ? kHitPasses : 1;
    const float thin = std::min(a ? A.reach : 1e9f, b ? B.reach : 1e9f);
    if (nearing * seconds > thin) addCore(range, m_constraints[fastest]);
}

/// Bodies that something much heavier lies on, and those that these lie on in turn: as stiff as their own weight asks for, and
/// passed over as often as others, they would be pressed into each other.
void ContactSolver::findBearers(glm::vec3 up, float ratio) {
    m_bearing.clear();
    const auto lower = [&](const Range& range) -> SolverState* {
        const float rise = range.to > range.from ? glm::dot(vec3(m_constraints[range.from].normal), up) : 0.0f;
        return rise > kSlope ? &m_states[size_t(range.b)] : rise < -kSlope ? &m_states[size_t(range.a)] : nullptr;
    };
    const auto upper = [&](const Range& range, const SolverState* under) {
        return &m_states[size_t(under == &m_states[size_t(range.b)] ? range.a : range.b)];
    };
    bool any = false;
    for (const Range& range : m_ranges) {
        if (!range.a || !range.b) continue;
        const float a = m_states[size_t(range.a)].inverseMass, b = m_states[size_t(range.b)].inverseMass;
        if (a <= ratio * b && b <= ratio * a) continue;
        SolverState* under = lower(range);
        if (under && under->inverseMass > ratio * upper(range, under)->inverseMass) under->bears = any = true;
    }
    for (bool more = any; more;) {
        more = false;
        for (const Range& range : m_ranges) {
            SolverState* under = lower(range);
            if (under && under->inverseMass > 0.0f && !under->bears && upper(range, under)->bears) under->bears = more = true;
        }
    }
    if (!any) return;
    for (size_t i = 0; i < m_ranges.size(); ++i) {
        const Range& range = m_ranges[i];
        if (!m_states[size_t(range.a)].bears && !m_states[size_t(range.b)].bears) continue;
        m_bearing.push_back(i);
        for (size_t k = range.from; k < range.to; ++k) m_constraints[k].isStiff = true;
    }
}

/// Where a contact has gone since the last step, what it held back would throw a light body that something heavy presses on:
/// the impulses of its other contacts do not start from the last step then.
void ContactSolver::dropUnbalanced(std::span<const SolverBody> bodies) {
    for (int round = 0; round < kBalanceRounds; ++round) {
        m_jolts.assign(bodies.size(), {});
        for (const Range& range : m_ranges) {
            Jolt &a = m_jolts[size_t(range.a)], &b = m_jolts[size_t(range.b)];
            for (size_t i = range.from; i < range.to; ++i) {
                const Constraint& c = m_constraints[i];
                const Four impulse = c.normal * four(c.normalImpulse) + c.tangent1 * four(c.tangentImpulse1) + c.tangent2 * four(c.tangentImpulse2);
                a.impulse += impulse, a.turn += cross(c.rA, impulse);
                b.impulse -= impulse, b.turn -= cross(c.rB, impulse);
            }
        }
        for (size_t i = 1; i < bodies.size(); ++i) {
            const SolverState& state = m_states[i];
            Jolt& jolt = m_jolts[i];
            const float speed2 = dot(jolt.impulse, jolt.impulse) * state.inverseMass * state.inverseMass;
            const float spin2 = dot(jolt.turn, FourColumns(state.inverseInertia) * jolt.turn) * state.inverseMass;
            jolt.isTooHard = !state.isJointed && speed2 + spin2 > kJolt * kJolt;
        }
        bool any = false;
        for (const Range& range : m_ranges) {
            if (!m_jolts[size_t(range.a)].isTooHard && !m_jolts[size_t(range.b)].isTooHard) continue;
            for (size_t i = range.from; i < range.to; ++i) {
                Constraint& c = m_constraints[i];
                any |= c.normalImpulse != 0.0f;
                c.normalImpulse = c.tangentImpulse1 = c.tangentImpulse2 = 0.0f;
            }
        }
        if (!any) return;
    }
}

/// Starts a substep with the impulses of the one before, which are counted.
void ContactSolver::warmStart(const Range& range, bool isFirst) {
    SolverState &A = m_states[size_t(range.a)], &B = m_states[size_t(range.b)];
    Moving bodies(A, B);
    for (size_t i = range.from; i < range.to; ++i) {
        Constraint& c = m_constraints[i];
        if (!isFirst) c.total += c.normalImpulse;
        bodies.push(c, c.normalImpulse);
        bodies.rub(c, c.tangentImpulse1, c.tangentImpulse2);
    }
    bodies.store(A, B);
}

ContactSolver::Push ContactSolver::pushOf(const Constraint& c, const Moved& moving, float inverseSeconds, bool pushApart) const {
    const Four moved = moving.way + moving.turnedA * c.rA - moving.turnedB * c.rB;
    const float s = c.separation + dot(moved, c.normal);
    if (s > 0.0f) return {s * inverseSeconds};
    if (!pushApart) return {};
    const Softness& soft = c.isStiff ? m_stiff : c.isStatic ? m_softStatic : m_soft;
    return {std::max(soft.biasRate * std::min(s + m_slop, 0.0f), -m_pushSpeed), soft.massScale, soft.impulseScale};
}

/// What an impulse does after one of the two has turned. With the masses of before, a rod would be pushed more than it takes
/// to stop it, time and again.
void ContactSolver::turnInertia(Constraint& c, const SolverState& A, const SolverState& B) {
    const FourColumns inertiaA(A.inverseInertia), inertiaB(B.inverseInertia);
    c.spinA = inertiaA * c.leverA, c.spinB = inertiaB * c.leverB;
    const float mass = A.inverseMass + B.inverseMass;
    c.normalMass = 1.0f / (mass + dot(c.leverA, c.spinA) + dot(c.leverB, c.spinB));
    const auto massAlong = [&](const Four& d) {
        const Four xa = cross(c.rA, d), xb = cross(c.rB, d);
        return 1.0f / (mass + dot(xa, inertiaA * xa) + dot(xb, inertiaB * xb));
    };
    c.tangentMass1 = massAlong(c.tangent1), c.tangentMass2 = massAlong(c.tangent2);
}

void ContactSolver::solveNormal(Constraint& c, const Push& push, Moving& bodies) {
    const float old = c.normalImpulse;
    c.normalImpulse = std::max(old - c.normalMass * push.massScale * (bodies.speedAlong(c) + push.bias) - push.impulseScale * old, 0.0f);
    c.most = std::max(c.most, c.normalImpulse);
    bodies.push(c, c.normalImpulse - old);
}

void ContactSolver::solveFriction(Constraint& c, Moving& bodies) {
    const Four relative = bodies.relativeVelocity(c);
    const float limit = c.friction * c.normalImpulse;
    float t1 = c.tangentImpulse1 - c.tangentMass1 * dot(relative, c.tangent1);
    float t2 = c.tangentImpulse2 - c.tangentMass2 * dot(relative, c.tangent2);
    const float size2 = t1 * t1 + t2 * t2;
    if (size2 > limit * limit) {
        const float shrink = limit / std::sqrt(size2);
        t1 *= shrink;
        t2 *= shrink;
    }
    bodies.rub(c, t1 - c.tangentImpulse1, t2 - c.tangentImpulse2);
    c.tangentImpulse1 = t1;
    c.tangentImpulse2 = t2;
}

/// All normals of two bodies first, then their friction: what one point takes too much of, the next gives back before it rubs.
void ContactSolver::solveRange(const Range& range, float inverseSeconds, bool pushApart) {
    SolverState &A = m_states[size_t(range.a)], &B = m_states[size_t(range.b)];
    const std::span<Constraint> points(m_constraints.data() + range.from, range.to - range.from);
    const Moved moved(A, B);
    std::array<Push, kMaxManifoldPoints + 1> pushes;  // a core may be one more
    for (size_t i = 0; i < points.size(); ++i) {
        Constraint& c = points[i];
        pushes[i] = pushOf(c, moved, inverseSeconds, pushApart);
        if (!pushApart && (A.inertiaTurns || B.inertiaTurns)) turnInertia(c, A, B);  // just after they have turned
    }
    Moving bodies(A, B);
    for (int pass = 0; pass < range.passes; ++pass)
        for (size_t i = 0; i < points.size(); ++i) solveNormal(points[i], pushes[i], bodies);
    for (Constraint& c : points) solveFriction(c, bodies);
    bodies.store(A, B);
}

void ContactSolver::solveContacts(float inverseSeconds, bool pushApart) {
    forRanges([&](const Range& range) { solveRange(range, inverseSeconds, pushApart); });
    if (m_bearing.empty()) return;
    for (int pass = 0; pass < m_heavyPasses; ++pass)
        for (const size_t i : m_bearing) solveRange(m_ranges[i], inverseSeconds, pushApart);
}

void ContactSolver::solvePasses(std::span<const SolverBody> bodies, int passes, double seconds, bool pushApart) {
    for (int i = 0; i < passes; ++i) {
        if (!m_joints.empty()) m_joints.solve(bodies, m_states, pushApart);
        solveContacts(float(1.0 / seconds), pushApart);
    }
}

void ContactSolver::bounce(float threshold) {
    for (const Range& range : m_ranges) {
        SolverState &A = m_states[size_t(range.a)], &B = m_states[size_t(range.b)];
        const std::span<Constraint> points(m_constraints.data() + range.from, range.to - range.from);
        const auto bounces = [&](const Constraint& c) { return c.restitution != 0.0f && c.approach <= -threshold && c.most != 0.0f; };
        if (std::none_of(points.begin(), points.end(), bounces)) continue;
        Moving bodies(A, B);
        for (int pass = 0; pass < kFastPasses; ++pass)
            for (Constraint& c : points) {
                if (!bounces(c)) continue;
                // On top of what the contact bears, which the next step starts with.
                const float old = c.bounceImpulse;
                c.bounceImpulse = std::max(old - c.normalMass * (bodies.speedAlong(c) + c.restitution * c.approach), 0.0f);
                bodies.push(c, c.bounceImpulse - old);
            }
        bodies.store(A, B);
    }
}

void ContactSolver::solve(std::span<SolverBody> bodies, std::span<Manifold* const> manifolds, std::span<const std::pair<int, int>> bodyOf,
                          glm::dvec3 gravity, const SolverSettings& settings, std::span<JointConstraint* const> joints) {
    const double h = settings.seconds / settings.substeps;
    const double hertz = std::min(settings.contactHertz, 0.25 / h);
    m_soft = soften(hertz, settings.dampingRatio, h);
    m_softStatic = soften(2.0 * hertz, settings.dampingRatio, h);
    m_stiff = soften(kStiffer * hertz, settings.dampingRatio, h);
    m_pushSpeed = float(settings.pushSpeed);
    m_slop = float(settings.slop);
    m_parallelFor = settings.parallelFor;
    const double weight = glm::length(gravity);
    m_up = weight > 0.0 ? glm::vec3(gravity / -weight) : glm::vec3(0.0f);
    prepare(bodies, manifolds, bodyOf, float(settings.seconds));
    m_joints.begin(joints, m_states);
    dropUnbalanced(bodies);
    m_heavyPasses = settings.heavyPasses;
    m_bearing.clear();
    if (settings.heavyPasses > 0 && weight > 0.0) findBearers(m_up, float(settings.heavyRatio));
    m_start.resize(bodies.size());
    for (size_t i = 0; i < bodies.size(); ++i) m_start[i] = bodies[i].rotation;
    const glm::vec3 fall = glm::vec3(gravity * h);
    for (int substep = 0; substep < settings.substeps; ++substep) {
        for (size_t i = 1; i < bodies.size(); ++i) m_states[i].v += fall;
        if (!m_joints.empty()) m_joints.prepare(bodies, m_states, h);
        forRanges([&](const Range& range) { warmStart(range, substep == 0); });
        solvePasses(bodies, settings.iterations, h, true);
        move(bodies, gravity, h);
        solvePasses(bodies, settings.iterations, h, false);
        if (!m_joints.empty()) m_joints.note(settings.seconds);
    }
    bounce(float(settings.bounceSpeed));
    for (size_t i = 1; i < bodies.size(); ++i)
        if (m_states[i].touches) bodies[i].velocity = m_states[i].v, bodies[i].angularVelocity = m_states[i].w;
    store();
}

void ContactSolver::move(std::span<SolverBody> bodies, glm::dvec3 gravity, double h) {
    forEach(bodies.size() - 1, [&](size_t i) { moveBody(bodies[i + 1], m_states[i + 1], m_start[i + 1], gravity, h); });
}

/// Integrates its position. Bodies without contacts stay in doubles: nothing is rounded in free flight.
void ContactSolver::moveBody(SolverBody& body, SolverState& state, const glm::dquat& start, glm::dvec3 gravity, double h) {
    if (state.touches) {
        body.velocity = state.v;
        body.angularVelocity = state.w;
    } else
        body.velocity += gravity * h;
    const glm::dvec3 way = body.velocity * h;
    body.position += way;
    rotateBody(body, h);
    if (!state.touches) return;
    state.moved += glm::vec3(way);
    state.turned = glm::mat3(glm::mat3_cast(body.rotation * glm::conjugate(start)) - glm::dmat3(1.0));
    if (body.conserves) {
        state.w = glm::vec3(body.angularVelocity);
        state.inverseInertia = glm::mat3(worldInverseInertia(body));
        state.inertiaTurns = true;
    }
}

void ContactSolver::store() {
    forEach(m_ranges.size(), [&](size_t i) { store(m_ranges[i]); });
}

void ContactSolver::store(const Range& range) {
    for (size_t i = range.from; i < range.to; ++i) {
        Constraint& c = m_constraints[i];
        c.total += c.normalImpulse;
        c.total += c.bounceImpulse;
        if (c.isCore) {
            c.point->totalImpulse += c.total;
            continue;
        }
        c.point->normalImpulse = c.normalImpulse;
        c.point->frictionImpulse = vec3(c.tangent1 * four(c.tangentImpulse1) + c.tangent2 * four(c.tangentImpulse2));
        c.point->totalImpulse = c.total;
        c.point->approach = -c.approach;
    }
}

}  // namespace rubble
