#include "physics/solver/contact_kernels.h"

#include <cstddef>

#include "physics/math/float8.h"
#include "physics/solver/contact_set.h"

// This file is compiled twice, once for AVX2 (RUBBLE_AVX2_KERNELS). All that it calls is its own, or in the namespace
// of float8.h: of an inline function that both builds had, the linker would keep one. See contact_solver.cpp for the
// method.

namespace rubble {
namespace {

constexpr int kHitPasses = 64;       ///< over the normals of a pair that closes fast, at most
constexpr float kConverged = 1e-4f;  ///< share of a pair's largest impulse by which none of them changes any more

using Vec = Vec3<Float8>;

using rubble::load;
using rubble::store;

Vec load(const Vec3<Lanes>& from) {
    return {load(from.x), load(from.y), load(from.z)};
}
void store(const Vec& from, Vec3<Lanes>& to) {
    store(from.x, to.x), store(from.y, to.y), store(from.z, to.z);
}
Contact<Float8> load(const Contact<Lanes>& c) {
    return {load(c.tangent1),
            load(c.tangent2),
            load(c.anchorA),
            load(c.anchorB),
            load(c.frictionInset),
            load(c.friction),
            load(c.normalImpulse),
            load(c.tangentImpulse1),
            load(c.tangentImpulse2),
            load(c.totalImpulse),
            load(c.normal),
            load(c.rA),
            load(c.rB),
            load(c.separation),
            load(c.normalMass),
            load(c.tangentMass1),
            load(c.tangentMass2),
            load(c.currentSeparation)};
}
RoundAnchor<Float8> load(const RoundAnchor<Lanes>& anchor) {
    return {load(anchor.axis), load(anchor.radius), load(anchor.side)};
}
ContactStart<Float8> load(const ContactStart<Lanes>& start) {
    return {load(start.normal), load(start.distance), load(start.separation),
            load(start.isOfB),  load(start.a),        load(start.b)};
}

/// Where the floats of a state are.
constexpr size_t kV = 0, kW = 4, kInertia = 8, kRotation = 17, kPosition = 26;
static_assert(offsetof(SolverState, inverseMass) == 12 && offsetof(SolverState, w) == 4 * kW &&
              offsetof(SolverState, inverseInertia) == 4 * kInertia &&
              offsetof(SolverState, deltaRotation) == 4 * kRotation &&
              offsetof(SolverState, deltaPosition) == 4 * kPosition);

Columns4 loadStates(const SolverState* states, const int (&bodies)[kLanes], size_t at) {
    const float* rows[kLanes];
    for (int i = 0; i < kLanes; ++i) rows[i] = reinterpret_cast<const float*>(states + bodies[i]) + at;
    return loadRows(rows);
}

struct Body {
    Vec v, w;
    Float8 inverseMass;
    SymmetricMat3<Float8> inverseInertia;
};
Body loadBody(const SolverState* states, const int (&bodies)[kLanes]) {
    const Columns4 v = loadStates(states, bodies, kV), w = loadStates(states, bodies, kW),
                   x = loadStates(states, bodies, kInertia), y = loadStates(states, bodies, kInertia + 4),
                   z = loadStates(states, bodies, kInertia + 5);
    return {{v.at[0], v.at[1], v.at[2]},
            {w.at[0], w.at[1], w.at[2]},
            v.at[3],
            {x.at[0], x.at[1], x.at[2], y.at[0], y.at[1], z.at[3]}};
}
VelocityPair<Float8> loadVelocities(const SolverState* states, const PairGroup& group) {
    const Body a = loadBody(states, group.a), b = loadBody(states, group.b);
    return {a.v, a.w, b.v, b.w, a.inverseMass, b.inverseMass, a.inverseInertia, b.inverseInertia};
}

/// The world's state is not written: several threads read it.
void storeBody(SolverState* states, const int (&bodies)[kLanes], const Vec& v, const Vec& w, const Float8& inverseMass,
               bool storesSteady) {
    float *vRows[kLanes], *wRows[kLanes];
    for (int i = 0; i < kLanes; ++i) {
        SolverState& body = states[bodies[i]];
        float* const state = bodies[i] && (storesSteady || !body.isSteady) ? reinterpret_cast<float*>(&body) : nullptr;
        vRows[i] = state, wRows[i] = state ? state + kW : nullptr;
    }
    storeRows({{v.x, v.y, v.z, inverseMass}}, vRows);
    storeRows({{w.x, w.y, w.z, Float8(0.0f)}}, wRows);
}
void storeVelocities(SolverState* states, const PairGroup& group, const VelocityPair<Float8>& bodies,
                     bool storesSteady = true) {
    storeBody(states, group.a, bodies.vA, bodies.wA, bodies.inverseMassA, storesSteady);
    storeBody(states, group.b, bodies.vB, bodies.wB, bodies.inverseMassB, storesSteady);
}

struct BodyMotion {
    Mat3<Float8> rotation;
    Vec position;
};
BodyMotion loadMotion(const SolverState* states, const int (&bodies)[kLanes]) {
    const Columns4 x = loadStates(states, bodies, kRotation), y = loadStates(states, bodies, kRotation + 4),
                   z = loadStates(states, bodies, kRotation + 8);
    return {{{x.at[0], x.at[1], x.at[2]}, {x.at[3], y.at[0], y.at[1]}, {y.at[2], y.at[3], z.at[0]}},
            {z.at[1], z.at[2], z.at[3]}};
}
MotionPair<Float8> loadMotions(const SolverState* states, const PairGroup& group) {
    const BodyMotion a = loadMotion(states, group.a), b = loadMotion(states, group.b);
    return {a.position - b.position, a.rotation, b.rotation};
}

void updateJacobians(const ContactArrays& set, const PairGroup& group, const MotionPair<Float8>& motion,
                     const VelocityPair<Float8>& bodies) {
    for (uint32_t i = group.from; i < group.from + group.count; ++i) {
        Contact<Lanes>& to = set.contacts[i];
        Contact<Float8> c = load(to);
        updateJacobian(c, load(set.starts[i]), group.anyRound, motion, bodies);
        store(c.normal, to.normal), store(c.rA, to.rA), store(c.rB, to.rB);
        store(c.separation, to.separation), store(c.normalMass, to.normalMass);
        store(c.tangentMass1, to.tangentMass1), store(c.tangentMass2, to.tangentMass2);
    }
}

/// Two unit vectors across the normal. t1 comes from two of its components; the threshold, about 1 / sqrt(3), sees to
/// it that these are not both small.
void tangentsOf(const Vec& n, Vec& t1, Vec& t2) {
    const Float8 zero(0.0f);
    const Bool8 isAlongX = larger(n.x, zero - n.x) > Float8(0.57f);
    const Vec across = {select(isAlongX, n.y, zero), select(isAlongX, zero - n.x, n.z),
                        select(isAlongX, zero, zero - n.y)};
    t1 = across * (Float8(1.0f) / rootOf(larger(dot(across, across), Float8(1e-30f))));
    t2 = cross(n, t1);
}

/// Computes the tangents, of which the first is the impulse of friction to start with, and its parts along them.
void beginTangents(const ContactArrays& set, const PairGroup& group) {
    for (uint32_t i = group.from; i < group.from + group.count; ++i) {
        Contact<Lanes>& to = set.contacts[i];
        const Vec impulse = load(to.tangent1);
        Vec t1, t2;
        tangentsOf(load(set.starts[i].normal), t1, t2);
        store(t1, to.tangent1), store(t2, to.tangent2);
        store(dot(impulse, t1), to.tangentImpulse1), store(dot(impulse, t2), to.tangentImpulse2);
    }
}

/// Computes the separations of a group's contacts now.
void updateSeparations(const ContactArrays& set, const PairGroup& group) {
    const MotionPair<Float8> motion = loadMotions(set.states, group);
    for (uint32_t i = group.from; i < group.from + group.count; ++i) {
        Contact<Lanes>& at = set.contacts[i];
        if (group.anyRound) {
            const ContactStart<Float8> start = load(set.starts[i]);
            store(motion.separation(load(at), &start), at.currentSeparation);
        } else {
            store(motion.separation(load(at), nullptr), at.currentSeparation);
        }
    }
}

/// What a contact adds to the normal velocity (m/s), and how soft it is: see Softness.
struct ContactBias {
    Float8 velocity, massScale, impulseScale;
};
/// A point that is still apart may close by its separation within the substep (speculative contact). A penetration is
/// corrected by a soft constraint, at most at maxPushSpeed.
ContactBias biasOf(const ContactArrays& set, const PairGroup& group, uint32_t contact, const ContactPass& pass) {
    const Float8 zero(0.0f), one(1.0f), separation = load(set.contacts[contact].currentSeparation);
    const Bool8 isApart = separation > zero;
    const Float8 speculative = separation * Float8(pass.inverseSeconds);
    if (!pass.useBias) return {select(isApart, speculative, zero), one, zero};
    const Float8 push =
        larger(load(group.biasRate) * smaller(separation + Float8(pass.slop), zero), Float8(-pass.maxPushSpeed));
    return {select(isApart, speculative, push), select(isApart, one, load(group.massScale)),
            select(isApart, zero, load(group.impulseScale))};
}

/// The impulse along the normal that the bias asks for.
Float8 normalImpulse(const Contact<Float8>& c, const ContactBias& bias, const VelocityPair<Float8>& bodies) {
    const Float8 velocity = bodies.normalVelocity(c) + bias.velocity;
    return larger(c.normalImpulse - c.normalMass * bias.massScale * velocity - bias.impulseScale * c.normalImpulse,
                  Float8(0.0f));
}

/// The normals of a group, by what an impulse at one point adds to the normal velocity of another (the Delassus
/// matrix): passes over these need no more of the bodies.
struct NormalRows {
    NormalRows(const ContactArrays& set, const PairGroup& group, const ContactBias* biases,
               const VelocityPair<Float8>& bodies) {
        Vec normals[kMaxManifoldPoints], armsA[kMaxManifoldPoints], armsB[kMaxManifoldPoints];
        for (uint32_t i = 0; i < group.count; ++i) {
            const Contact<Float8> c = load(set.contacts[group.from + i]);
            const Vec &armA = armsA[i] = cross(c.rA, c.normal), &armB = armsB[i] = cross(c.rB, c.normal);
            normals[i] = c.normal;
            velocity[i] = bodies.normalVelocity(c) + biases[i].velocity;
            before[i] = impulse[i] = c.normalImpulse;
            mass[i] = c.normalMass * biases[i].massScale, softness[i] = biases[i].impulseScale;
            const Vec turnA = bodies.inverseInertiaA * armA, turnB = bodies.inverseInertiaB * armB;
            const Float8 inverseMass = bodies.inverseMassA + bodies.inverseMassB;
            for (uint32_t k = 0; k <= i; ++k)
                gain[i][k] = gain[k][i] =
                    dot(armsA[k], turnA) + dot(armsB[k], turnB) + dot(normals[k], c.normal) * inverseMass;
        }
    }
    Float8 velocity[kMaxManifoldPoints];                             ///< m/s, with the bias
    Float8 mass[kMaxManifoldPoints];                                 ///< effective
    Float8 softness[kMaxManifoldPoints];                             ///< the impulse scale: see Softness
    Float8 impulse[kMaxManifoldPoints], before[kMaxManifoldPoints];  ///< N s, now and at the start
    Float8 gain[kMaxManifoldPoints][kMaxManifoldPoints];             ///< m/s for 1 N s
};

/// More passes over the normals of the pairs that close fast, until they converge.
void solveHits(const ContactArrays& set, const PairGroup& group, const ContactBias* biases, Float8 changed,
               Float8 largest, VelocityPair<Float8>& bodies) {
    const Bool8 isHit = load(group.isHit) > Float8(0.5f);
    Bool8 isActive = isHit & (changed > largest * Float8(kConverged));
    if (!any(isActive)) return;
    NormalRows rows(set, group, biases, bodies);
    for (int pass = 1; pass < kHitPasses && any(isActive); ++pass) {
        changed = largest = Float8(0.0f);
        for (uint32_t i = 0; i < group.count; ++i) {
            const Float8 old = rows.impulse[i],
                         solved = larger(old - rows.mass[i] * rows.velocity[i] - rows.softness[i] * old, Float8(0.0f)),
                         impulse = select(isActive, solved, old), change = impulse - old;
            rows.impulse[i] = impulse;
            for (uint32_t k = 0; k < group.count; ++k) rows.velocity[k] = rows.velocity[k] + rows.gain[i][k] * change;
            changed = larger(changed, larger(change, Float8(0.0f) - change));
            largest = larger(largest, impulse);
        }
        isActive = isHit & (changed > largest * Float8(kConverged));
    }
    for (uint32_t i = 0; i < group.count; ++i) {
        Contact<Lanes>& at = set.contacts[group.from + i];
        bodies.applyNormalImpulse(load(at), rows.impulse[i] - rows.before[i]);
        store(rows.impulse[i], at.normalImpulse);
    }
}

/// The spin of a lone point about its normal. Points beside each other resist it by their friction.
void applyTorsion(const Contact<Float8>& c, const Float8& impulse, VelocityPair<Float8>& bodies) {
    bodies.wA = bodies.wA + bodies.inverseInertiaA * (c.normal * impulse);
    bodies.wB = bodies.wB - bodies.inverseInertiaB * (c.normal * impulse);
}
void solveTorsion(const ContactArrays& set, PairGroup& group, VelocityPair<Float8>& bodies) {
    const Contact<Float8> c = load(set.contacts[group.from]);
    const Float8 inverse = dot(c.normal, bodies.inverseInertiaA * c.normal + bodies.inverseInertiaB * c.normal),
                 spin = dot(c.normal, bodies.wA - bodies.wB), before = load(group.torsionImpulse),
                 limit = load(group.torsionArm) * c.normalImpulse,
                 wanted = before - spin / larger(inverse, Float8(1e-30f)),
                 impulse = larger(smaller(wanted, limit), Float8(0.0f) - limit);
    applyTorsion(c, impulse - before, bodies);
    store(impulse, group.torsionImpulse);
}

/// All normals of two bodies first, then their friction: an impulse that is too large is corrected by the next point's
/// before it limits friction.
[[gnu::flatten]] void solveGroup(const ContactArrays& set, PairGroup& group, const ContactPass& pass) {
    // Until the bodies move again they stay as they are, but where normals have turned since.
    if (group.anyFollowed || pass.haveMoved) updateSeparations(set, group);
    VelocityPair<Float8> bodies = loadVelocities(set.states, group);
    ContactBias biases[kMaxManifoldPoints];
    for (uint32_t i = 0; i < group.count; ++i) biases[i] = biasOf(set, group, group.from + i, pass);
    // What is followed has just moved. With the old effective masses, the impulses on a spinning rod would be larger
    // than it takes to stop it, again and again.
    if (!pass.useBias && group.anyFollowed) updateJacobians(set, group, loadMotions(set.states, group), bodies);
    Float8 changed(0.0f), largest(0.0f);
    for (uint32_t i = 0; i < group.count; ++i) {
        Contact<Lanes>& at = set.contacts[group.from + i];
        const Contact<Float8> c = load(at);
        if (pass.addsTotals) store(c.totalImpulse + c.normalImpulse, at.totalImpulse);
        const Float8 impulse = normalImpulse(c, biases[i], bodies), change = impulse - c.normalImpulse;
        bodies.applyNormalImpulse(c, change);
        store(impulse, at.normalImpulse);
        changed = larger(changed, larger(change, Float8(0.0f) - change));
        largest = larger(largest, impulse);
    }
    if (group.anyHit) solveHits(set, group, biases, changed, largest, bodies);
    for (uint32_t i = 0; i < group.count; ++i) {
        Contact<Lanes>& at = set.contacts[group.from + i];
        Contact<Float8> c = load(at);
        bodies.solveFriction(c, c.friction * c.normalImpulse, c.tangentImpulse1, c.tangentImpulse2);
        store(c.tangentImpulse1, at.tangentImpulse1);
        store(c.tangentImpulse2, at.tangentImpulse2);
    }
    if (group.anyTorsion) solveTorsion(set, group, bodies);
    storeVelocities(set.states, group, bodies);
}

[[gnu::flatten]] void prepare(const ContactArrays& set, size_t from, size_t to) {
    for (size_t g = from; g < to; ++g) {
        const PairGroup& group = set.groups[g];
        beginTangents(set, group);
        updateJacobians(set, group, loadMotions(set.states, group), loadVelocities(set.states, group));
        for (uint32_t i = group.from; i < group.from + group.count; ++i)
            set.contacts[i].currentSeparation = set.contacts[i].separation;
    }
}

[[gnu::flatten]] void warmStart(const ContactArrays& set, size_t from, size_t to, bool isFirst) {
    for (size_t g = from; g < to; ++g) {
        const PairGroup& group = set.groups[g];
        if (!isFirst && group.isSteady) continue;
        VelocityPair<Float8> bodies = loadVelocities(set.states, group);
        for (uint32_t i = group.from; i < group.from + group.count; ++i) {
            const Contact<Float8> c = load(set.contacts[i]);
            bodies.applyNormalImpulse(c, c.normalImpulse);
            bodies.applyFrictionImpulse(c, c.tangentImpulse1, c.tangentImpulse2);
        }
        if (group.anyTorsion) applyTorsion(load(set.contacts[group.from]), load(group.torsionImpulse), bodies);
        storeVelocities(set.states, group, bodies, isFirst);
    }
}

void solve(const ContactArrays& set, size_t from, size_t to, const ContactPass& pass) {
    for (size_t g = from; g < to; ++g) solveGroup(set, set.groups[g], pass);
}

constexpr ContactKernels kKernels = {prepare, warmStart, solve};

}  // namespace

#ifdef RUBBLE_AVX2_KERNELS
const ContactKernels* avx2ContactKernels() {
    static const bool isSupported = __builtin_cpu_supports("avx2");
    return isSupported ? &kKernels : nullptr;
}
#else
const ContactKernels& baselineContactKernels() {
    return kKernels;
}
#ifndef RUBBLE_HAS_AVX2_KERNELS
const ContactKernels* avx2ContactKernels() {
    return nullptr;
}
#endif
const ContactKernels& contactKernels() {
    const ContactKernels* avx2 = avx2ContactKernels();
    return avx2 ? *avx2 : baselineContactKernels();
}
#endif

}  // namespace rubble
