#include "physics/solver/contact_solver.h"

#include <gtest/gtest.h>

#include <deque>

namespace rubble {
namespace {

SolverBody body(double mass, glm::dvec3 inertia) {
    SolverBody body;
    body.inverseMass = 1.0 / mass;
    body.inertia = inertia;
    return body;
}

double energy(const SolverBody& body) {
    const glm::dvec3 spin = glm::conjugate(body.rotation) * body.angularVelocity;
    return 0.5 * glm::dot(body.velocity, body.velocity) / body.inverseMass + 0.5 * glm::dot(body.inertia * spin, spin);
}

ManifoldPoint contact(glm::vec3 position, glm::vec3 normal) {
    ManifoldPoint point;
    point.position = position;
    point.normal = normal;
    point.friction = 0.5f;
    return point;
}

TEST(ContactSolver, NoWarmStartWhenTheSupportOfASqueezedBodyIsGone) {
    std::vector<SolverBody> bodies = {{}, body(17e3, glm::dvec3(2e4)), body(1.5, glm::dvec3(0.01))};
    LoneManifold manifold;  // the light body comes first; its contact on the other side is gone since the last step
    for (const float y : {-0.05f, 0.05f}) {
        ManifoldPoint point = contact({-0.05f, y, 0.0f}, {1, 0, 0});
        point.normalImpulse = 1000.0f;
        point.frictionImpulse = {0.0f, 100.0f, 0.0f};
        manifold.points[size_t(manifold.count++)] = point;
    }
    Manifold* const manifolds[] = {&manifold};
    const std::pair<int, int> bodyOf[] = {{2, 1}};
    SolverSettings settings;
    settings.iterations = 0;  // the warm start alone
    ContactSolver().solve(bodies, manifolds, bodyOf, {0, 0, 0}, settings);
    EXPECT_LT(glm::length(bodies[2].velocity), 0.5);
    EXPECT_LT(glm::length(bodies[2].angularVelocity), 5.0);
}

/// Which bodies of 1 kg are load-bearing under one of 100 kg that rests on `count` of them, which rest on one each.
std::vector<bool> loadBearing(size_t count, bool isNew) {
    constexpr float kFall = 10.0f / 360.0f;  // m/s in a substep
    ContactSet set;
    set.states.resize(2 + 2 * count);
    std::deque<LoneManifold> manifolds;
    set.states[1].inverseMass = 0.01f;
    const auto rest = [&](size_t upper, size_t under, float load) {
        Manifold& manifold = manifolds.emplace_back();
        manifold.count = 1;
        manifold.points[0] = contact({0, 0, 0}, {0, 1, 0});
        manifold.points[0].normalImpulse = isNew ? 0.0f : load * kFall;
        set.pairs.push_back({int(upper), int(under), &manifold});
    };
    for (size_t i = 0; i < count; ++i) {
        const size_t top = 2 + i, bottom = 2 + count + i;
        set.states[top].inverseMass = set.states[bottom].inverseMass = 1.0f;
        rest(1, top, 100.0f / float(count));
        rest(top, bottom, 100.0f / float(count) + 1.0f);
        rest(bottom, 0, 100.0f / float(count) + 2.0f);
    }
    LoadBearing().find(set, {0, 1, 0}, kFall, 30.0f);
    std::vector<bool> result;
    for (size_t i = 2; i < set.states.size(); ++i) result.push_back(set.states[i].isLoadBearing);
    return result;
}

TEST(ContactSolver, ALoadSpreadOverManyMakesNoneOfThemLoadBearing) {
    EXPECT_EQ(loadBearing(1, false), (std::vector<bool>{true, true}));
    EXPECT_EQ(loadBearing(2, false), (std::vector<bool>{true, true, true, true}));
    EXPECT_EQ(loadBearing(4, false), std::vector<bool>(8, false));
    EXPECT_EQ(loadBearing(2, true), (std::vector<bool>{true, true, true, true})) << "what has just been laid on them";
}

/// A column under 100 kg, just built. The contacts of what is not light under the load are not stiff, nor is what is
/// under that.
TEST(ContactSolver, WhatIsNotLightUnderALoadIsNotLoadBearing) {
    ContactSet set;
    set.states.resize(6);
    std::deque<LoneManifold> manifolds;
    for (const auto& [body, mass] :
         {std::pair(1, 100.0f), std::pair(2, 1.0f), std::pair(3, 1.0f), std::pair(4, 50.0f), std::pair(5, 1.0f)}) {
        set.states[size_t(body)].inverseMass = 1.0f / mass;
        Manifold& manifold = manifolds.emplace_back();
        manifold.count = 1;
        manifold.points[0] = contact({0, 0, 0}, {0, 1, 0});
        set.pairs.push_back({body, (body + 1) % 6, &manifold});
    }
    LoadBearing().find(set, {0, 1, 0}, 10.0f / 360.0f, 30.0f);
    std::vector<bool> result;
    for (const SolverState& state : set.states) result.push_back(state.isLoadBearing);
    EXPECT_EQ(result, (std::vector<bool>{false, false, true, true, false, true}))
        << "1 kg under 50 bears a load of its own";
}

/// Half a second with friction 0.5 takes 0.75 rad/s from 15 N on a point with an arm of 2 mm; a whole one stops it.
TEST(ContactSolver, ALonePointResistsSpinByItsArm) {
    for (const double spin : {1.0, -1.0}) {
        std::vector<SolverBody> bodies = {{}, body(1.5, glm::dvec3(0.01))};
        bodies[1].angularVelocity = {0.0, spin, 0.0};
        LoneManifold manifold;
        manifold.points[size_t(manifold.count++)] = contact({0, -0.05f, 0}, {0, 1, 0});
        Manifold* const manifolds[] = {&manifold};
        const std::pair<int, int> bodyOf[] = {{1, 0}};
        SolverSettings settings;
        settings.torsionRadius = 0.002;
        ContactSolver solver;
        const auto step = [&] { solver.solve(bodies, manifolds, bodyOf, {0, -10, 0}, settings); };
        for (int i = 0; i < 30; ++i) step();
        EXPECT_NEAR(bodies[1].angularVelocity.y, 0.25 * spin, 0.01);
        for (int i = 0; i < 30; ++i) step();
        EXPECT_NEAR(bodies[1].angularVelocity.y, 0.0, 1e-4);
        manifold.isRound = true;  // as a ball that spins on
        bodies[1].angularVelocity = {0.0, spin, 0.0};
        for (int i = 0; i < 30; ++i) step();
        EXPECT_NEAR(bodies[1].angularVelocity.y, spin, 1e-4);
    }
}

TEST(ContactSolver, ALoadedContactWarmStarts) {
    std::vector<SolverBody> bodies = {{}, body(1.5, glm::dvec3(0.01))};
    const double weight = 1.5 * 10.0 * SolverSettings{}.seconds / SolverSettings{}.substeps;
    LoneManifold manifold;
    ManifoldPoint point = contact({0, -0.05f, 0}, {0, 1, 0});
    point.normalImpulse = float(weight);
    manifold.points[size_t(manifold.count++)] = point;
    Manifold* const manifolds[] = {&manifold};
    const std::pair<int, int> bodyOf[] = {{1, 0}};
    SolverSettings settings;
    settings.iterations = 0;  // the warm start alone
    ContactSolver().solve(bodies, manifolds, bodyOf, {0, -10, 0}, settings);
    EXPECT_LT(glm::length(bodies[1].velocity), 1e-4);
}

TEST(ContactSolver, EachImpulseIsInheritedOnce) {
    LoneManifold before;
    before.points[size_t(before.count++)] = contact({0, 0, 0}, {0, 1, 0});
    before.points[0].feature = 7;
    before.points[0].normalImpulse = 10.0f;
    std::vector<ContactPoint> contacts = {contact({0, 0, 0}, {0, 1, 0}), contact({0.01f, 0, 0}, {0.1f, 0.995f, 0}),
                                          contact({0, 0, 0}, {1, 0, 0})};
    for (ContactPoint& each : contacts) each.feature = 7;
    LoneManifold now;
    reduceContacts(contacts, &before, kRestingLimits, now);
    float up = 0.0f, aside = 0.0f;
    for (const ManifoldPoint& point : now.all()) (point.normal.y > 0.5f ? up : aside) += point.normalImpulse;
    EXPECT_EQ(up, 10.0f);
    EXPECT_EQ(aside, 0.0f) << "an impulse is not inherited by a contact of another direction";
}

TEST(ContactSolver, ARotatingRodGainsNoEnergyFromItsContacts) {
    for (const double spin : {30.0, 90.0, 200.0}) {
        std::vector<SolverBody> bodies = {{}, body(2.0, {0.0283, 0.0283, 0.0013})};
        SolverBody& rod = bodies[1];
        rod.conservesMomentum = true;
        rod.angularVelocity = {5.0, spin, 0.0};
        rod.velocity = {0, -3, 0};
        LoneManifold manifold;
        for (const float z : {-0.2f, 0.2f})
            manifold.points[size_t(manifold.count++)] = contact({0.02f, -0.05f, z}, {0, 1, 0});
        Manifold* const manifolds[] = {&manifold};
        const std::pair<int, int> bodyOf[] = {{1, 0}};
        const double before = energy(rod);
        ContactSolver().solve(bodies, manifolds, bodyOf, {0, 0, 0}, {});
        EXPECT_LE(energy(rod), 1.001 * before) << spin;
    }
}

}  // namespace
}  // namespace rubble
