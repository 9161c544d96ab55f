#include <gtest/gtest.h>

#include "tests/physics/scenes/impact_scenes.h"
#include "tests/physics/scenes/known_scenes.h"

namespace rubble {
namespace {

PhysicsSettings withoutSleep() {
    return known::sleepless({});
}

/// Total momentum of all dynamic bodies, its moment about a point, and their energy.
struct Momentum {
    glm::dvec3 linear{0.0}, angular{0.0};
    double energy = 0.0;  ///< of the motion, joules
};
Momentum momentumOf(const PhysicsScene& scene, glm::dvec3 about) {
    Momentum sum;
    for (int i = 0; i < int(scene.level.bodies.size()); ++i) {
        const Body& body = scene.body(i);
        if (body.isStatic) continue;
        const MassProperties mass = bodyMass(scene.world, scene.handle(i));
        const glm::dmat3 axes = glm::mat3_cast(body.pose.rotation * mass.principalAxes);
        const glm::dvec3 p = glm::dvec3(body.velocity) * mass.mass;
        const glm::dvec3 spin = glm::transpose(axes) * glm::dvec3(body.angularVelocity);
        sum.linear += p;
        sum.angular += glm::cross(scene.center(i) - about, p) + axes * (mass.principalInertia * spin);
        sum.energy += 0.5 * (glm::dot(p, glm::dvec3(body.velocity)) + glm::dot(spin, mass.principalInertia * spin));
    }
    return sum;
}

TEST(ImpactTheory, APlankThatLandsOnALedgeTurnsAboutItsEdge) {
    for (const double speed : {1.0, 2.8, 6.0, 15.0, 40.0, 100.0}) {
        const known::LedgeHit hit = known::landOnLedge({}, speed);
        EXPECT_NEAR(hit.spin / hit.expectedSpin, 1.0, 0.03) << speed << " m/s: " << hit.spin;
        EXPECT_NEAR(hit.speed / hit.expectedSpeed, 1.0, 0.03) << speed << " m/s";
    }
}

/// The nearer its middle is to the edge, the less its end is lifted and the slower its impulses converge.
TEST(ImpactTheory, APlankThatLandsOnALedgeTurnsAboutItsEdgeWhateverItsOverhang) {
    for (const double share : {0.1, 0.2, 0.3, 0.4, 0.45})
        for (const double speed : {1.0, 2.8, 15.0}) {
            const known::LedgeHit hit = known::landOnLedge({}, speed, share);
            EXPECT_NEAR(hit.spin / hit.expectedSpin, 1.0, 0.03) << speed << " m/s, " << share << " on the ledge";
            EXPECT_NEAR(hit.speed / hit.expectedSpeed, 1.0, 0.03) << speed << " m/s, " << share << " on the ledge";
        }
}

/// Free bodies that hit each other keep the sum of their momenta and of its moments.
TEST(ImpactTheory, FreeBodiesKeepTheirMomentum) {
    Random random(7);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (double(random.below(1u << 30)) / double(1u << 30));
    };
    double worstLinear = 0.0, worstAngular = 0.0, worstGain = -1.0;
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        PhysicsScene scene(withoutSleep());
        scene.level.environment.gravity = {0, 0, 0};
        const uint8_t light = known::setMaterial(scene, 7, 0.6f, 0.3f, 500),
                      heavy = known::setMaterial(scene, 8, 0.6f, 0.3f, 3000);
        const double speed = std::pow(100.0, uniform(0.0, 1.0));
        for (const int k : {0, 1}) {
            const int x = random.between(1, 12), y = random.between(1, 4), z = random.between(1, 6);
            const double a = uniform(-1, 1), b = uniform(-1, 1), c = uniform(-1, 1), d = uniform(-1, 1);
            const glm::dquat turn = glm::normalize(glm::dquat(a, b, c, d));
            const glm::dvec3 half = glm::dvec3(x, y, z) * 0.05;
            const double aside = uniform(-0.4, 0.4), above = uniform(-0.3, 0.3);
            LevelBody& body = scene.add(solidGrid({x, y, z}, k ? light : heavy),
                                        glm::dvec3(k ? 0.9 : -0.9, aside, above) - turn * half, false, turn);
            const double vy = uniform(-0.3, 0.3), vz = uniform(-0.3, 0.3);
            body.velocity = glm::vec3(glm::dvec3(k ? -1.0 : 1.0, vy, vz) * speed * 0.5);
            const double wx = uniform(-10, 10), wy = uniform(-10, 10), wz = uniform(-10, 10);
            body.angularVelocity = glm::vec3(wx, wy, wz);
        }
        scene.load();
        const Momentum before = momentumOf(scene, glm::dvec3(0.0));
        const glm::dvec3 v = scene.body(0).velocity;
        double linearScale = 0.0, angularScale = 0.0;
        for (const int k : {0, 1}) {
            const MassProperties mass = bodyMass(scene.world, scene.handle(k));
            linearScale += mass.mass * glm::length(scene.body(k).velocity);
            angularScale += mass.mass * glm::length(scene.body(k).velocity) * 1.0;
        }
        scene.step(int(2.0 / speed * 60.0) + 6);
        if (glm::length(v - scene.body(0).velocity) < 1e-3) continue;
        ++hits;
        const Momentum after = momentumOf(scene, glm::dvec3(0.0));
        worstLinear = std::max(worstLinear, glm::length(after.linear - before.linear) / linearScale);
        worstGain = std::max(worstGain, after.energy / before.energy - 1.0);
        worstAngular = std::max(worstAngular, glm::length(after.angular - before.angular) / angularScale);
    }
    EXPECT_GT(hits, 500);
    EXPECT_LT(worstLinear, 1e-5);
    EXPECT_LT(worstAngular, 1e-5);
    EXPECT_LT(worstGain, 1e-5);
}

/// 16 kg hit the end of a free plank.
TEST(ImpactTheory, AHitOnTheEndOfAFreePlankKeepsTheAngularMomentum) {
    for (const double speed : {4.0, 20.0, 60.0}) {
        PhysicsScene scene(withoutSleep());
        scene.level.environment.gravity = {0, 0, 0};
        const uint8_t entry = known::setMaterial(scene, 7, 0.5f, 0.0f, 2000);
        scene.add(solidGrid({20, 1, 4}, entry), {-1.0, -0.05, -0.2}, false);
        scene.add(solidGrid({2, 2, 2}, entry), {0.75, 0.5, -0.1}, false).velocity = {0.0f, -float(speed), 0.0f};
        scene.load();
        const Momentum before = momentumOf(scene, glm::dvec3(0.0));
        scene.step(int(1.0 / speed * 60.0) + 4);
        const Momentum after = momentumOf(scene, glm::dvec3(0.0));
        EXPECT_GT(std::abs(scene.body(0).angularVelocity.z), 0.1) << "it was hit";
        EXPECT_LT(glm::length(after.angular - before.angular) / glm::length(before.angular), 1e-4) << speed;
    }
}

/// Without friction and loss, three bounces reach the height that it fell from.
TEST(ImpactTheory, AnElasticBounceKeepsItsHeight) {
    PhysicsScene scene(withoutSleep());
    const uint8_t entry = known::setMaterial(scene, 7, 0.0f, 1.0f);
    scene.add(solidGrid({40, 4, 40}, entry), {-2.0, -0.4, -2.0}, true);
    scene.add(solidGrid({5, 5, 5}, entry), {-0.25, 2.0, -0.25}, false);
    scene.load();
    std::vector<double> apexes;
    double before = scene.center(1).y, beforeThat = before;
    for (int i = 0; i < 60 * 6 && apexes.size() < 3; ++i) {
        scene.step();
        const double now = scene.center(1).y;
        if (before > beforeThat && now < before) apexes.push_back(before - 0.25);
        beforeThat = before, before = now;
    }
    ASSERT_EQ(apexes.size(), 3u);
    for (const double apex : apexes) EXPECT_NEAR(apex, 2.0, 0.04);
}

/// A plate that hits the floor aslant loses mu (1 + e) v_n of its speed along the floor.
TEST(ImpactTheory, ABounceHasTheFrictionOfItsWholeImpulse) {
    for (const double restitution : {0.0, 0.5, 1.0}) {
        const known::ObliqueBounce bounce = known::bounceAslant({}, 0.2, restitution);
        EXPECT_NEAR(bounce.up, bounce.expectedUp, 0.1) << restitution;
        EXPECT_NEAR(bounce.lost / bounce.expectedLost, 1.0, 0.05) << restitution;
    }
}

}  // namespace
}  // namespace rubble
