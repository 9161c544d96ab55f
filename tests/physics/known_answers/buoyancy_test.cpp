#include <gtest/gtest.h>

#include <cmath>

#include "physics/water/submersion.h"
#include "runtime/core/constants.h"
#include "runtime/core/random.h"
#include "tests/physics/scenes/load_scenes.h"

namespace rubble {
namespace {

/// known::Pool with the default settings.
struct Pool : known::Pool {
    Pool(uint32_t density, double drag, double halfSide = 50.0, double depth = 40.0)
        : known::Pool({}, density, drag, halfSide, depth) {}
};

/// By 64^3 samples, or exactly for aligned planes.
TEST(Buoyancy, ThePartOfACubeBelowAPlaneIsExact) {
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        const double a = random.unit(), b = random.unit(), c = random.unit(), e = random.unit();
        glm::dvec3 n = glm::dvec3(a, b, c) * 2.0 - 1.0;
        if (i % 3 == 0) n.x *= 1e-4;
        if (i % 6 == 0) n.z = 0.0;
        const double low = std::min(n.x, 0.0) + std::min(n.y, 0.0) + std::min(n.z, 0.0),
                     high = std::max(n.x, 0.0) + std::max(n.y, 0.0) + std::max(n.z, 0.0);
        const double d = low + (high - low) * e;
        const CubeBelowPlane part = cubeBelowPlane(n, d);
        const int count = 48;
        double volume = 0.0;
        glm::dvec3 moment(0.0);
        for (int k = 0; k < count * count * count; ++k) {
            const glm::dvec3 p = (glm::dvec3(k % count, k / count % count, k / count / count) + 0.5) / double(count);
            if (glm::dot(n, p) <= d) volume += 1.0, moment += p;
        }
        const double all = std::pow(double(count), 3);
        EXPECT_NEAR(part.volume, volume / all, 0.012) << i;
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(part.moment[k], moment[k] / all, 0.012) << i;
    }
}

/// The part below a plane and the part above it make the whole, with its moment.
TEST(Buoyancy, TwoPartsOfACubeMakeTheWhole) {
    Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const double a = random.unit(), b = random.unit(), c = random.unit(), d = random.unit();
        const glm::dvec3 n = (glm::dvec3(a, b, c) * 2.0 - 1.0) * glm::dvec3(1.0, std::pow(10.0, -(i % 5)), 1.0);
        const CubeBelowPlane below = cubeBelowPlane(n, d), above = cubeBelowPlane(-n, -d);
        EXPECT_NEAR(below.volume + above.volume, 1.0, 1e-6);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(below.moment[k] + above.moment[k], 0.5, 1e-4) << i;
    }
}

TEST(Buoyancy, ABoxFloatsAsDeepAsItIsDense) {
    for (const uint32_t density : {100u, 200u, 350u, 500u, 650u, 800u, 900u, 950u}) {
        Pool scene(density, 1.5);
        const double draught = 0.5 * density / 1000.0;
        scene.add(solidGrid({16, 5, 16}, 1), {-0.8, 0.1 - draught, -0.8}, false);
        scene.load();
        scene.seconds(20.0);
        EXPECT_NEAR((0.25 - scene.center(0).y) / draught, 1.0, 1e-4) << density;
        EXPECT_LT(glm::length(scene.body(0).velocity), 1e-4f) << density << ": what floats still has no velocity";
    }
}

/// The metacentric height of a box of half the density of water: w^2 / (6 h) - h / 4.
TEST(Buoyancy, TheRightingMomentIsThatOfTheMetacentre) {
    for (const auto& [width, height] :
         {std::pair(16, 4), std::pair(12, 8), std::pair(8, 8), std::pair(8, 12), std::pair(4, 16), std::pair(2, 1)}) {
        Pool scene(500, 0.0);
        const double w = 0.1 * width, h = 0.1 * height, tilt = 0.02;
        const glm::dquat turn = glm::angleAxis(tilt, glm::dvec3(0, 0, 1));
        scene.add(solidGrid({width, height, width}, 1), -(turn * (glm::dvec3(w, h, w) * 0.5)), false, turn);
        scene.load();
        const MassProperties mass = bodyMass(scene.world, scene.handle(0));
        scene.step();
        const double metacentric = w * w / (6.0 * h) - h / 4.0;
        const double expected = -mass.mass * kGravity * metacentric * std::sin(tilt) / mass.inertia[2] / 60.0;
        EXPECT_NEAR(double(scene.body(0).angularVelocity.z) / expected, 1.0, 0.02) << width << " x " << height;
    }
}

TEST(Buoyancy, ABoxBobsWithThePeriodOfItsDraught) {
    for (const uint32_t density : {200u, 500u, 800u}) {
        Pool scene(density, 0.005);
        const double draught = 0.8 * density / 1000.0, equilibrium = 0.4 - draught;
        scene.add(solidGrid({20, 8, 20}, 1), {-1.0, equilibrium - 0.4 + 0.05, -1.0}, false);
        scene.load();
        std::vector<double> rises;
        double before = 0.05;
        for (int i = 0; i < 2400 && rises.size() < 6; ++i) {
            scene.step();
            const double now = scene.center(0).y - equilibrium;
            if (before < 0.0 && now >= 0.0) rises.push_back((i + 1 - now / (now - before)) / 60.0);
            before = now;
        }
        ASSERT_EQ(rises.size(), 6u);
        EXPECT_NEAR((rises.back() - rises.front()) / 5.0 / (2.0 * kPi * std::sqrt(draught / kGravity)), 1.0, 0.002)
            << density;
    }
}

TEST(Buoyancy, BobbingWithoutDragKeepsItsHeight) {
    for (const uint32_t density : {200u, 500u, 800u})
        for (const double lift : {0.05, 0.5, 1.5}) {  // in the water, at its surface, and out of it
            Pool scene(density, 0.0);
            const double draught = 0.8 * density / 1000.0;
            scene.add(solidGrid({20, 8, 20}, 1), {-1.0, lift - draught, -1.0}, false);
            scene.load();
            const double start = scene.center(0).y;
            double highest = -1e9;
            for (int i = 0; i < 3600; ++i) {
                scene.step();
                if (i >= 3000) highest = std::max(highest, scene.center(0).y);
            }
            EXPECT_NEAR(highest, start, 0.03 * lift) << density << " from " << lift << " m";
        }
}

/// In water of 0.3 m.
/// The work of buoyancy is that of the water which the body displaces, until it is out.
TEST(Buoyancy, WhatIsLightAndSmallLeapsNoHigherThanTheWaterLiftsIt) {
    for (const float size : {0.01f, 0.1f})
        for (const uint32_t density : {5u, 20u, 100u, 300u})
            for (const double depth : {0.5, 2.0, 5.0}) {  // of its middle, voxels
                Pool scene(density, 0.0);
                const double half = 0.5 * double(size), under = depth * double(size);
                scene.add(solidGrid({1, 1, 1}, 1), {-half, -under - half, -half}, false).shapes[0].voxelSize = size;
                scene.load();
                double highest = -under;
                for (int i = 0; i < 600; ++i) {
                    scene.step();
                    highest = std::max(highest, scene.center(0).y);
                }
                EXPECT_LT(highest, under * (1000.0 / density - 1.0) * 1.03 + 0.002)
                    << size << " m, " << density << " kg/m3, " << depth << " voxels deep";
            }
}

TEST(Buoyancy, SmallThingsFloatInShallowWater) {
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 1), glm::ivec3(2, 1, 1), glm::ivec3(2, 1, 2), glm::ivec3(3, 1, 2),
                                  glm::ivec3(2, 2, 2), glm::ivec3(8, 1, 1)})
        for (const uint32_t density : {300u, 600u, 900u})
            EXPECT_NEAR(known::floatInShallowWater({}, size, density) / (density / 1000.0), 1.0, 1e-3)
                << size.x << " x " << size.y << " x " << size.z << " of " << density;
}

/// In a pool of 2 x 2 m, things at its rim and over its corner.
TEST(Buoyancy, ThingsFloatAtTheRimOfAPool) {
    for (const glm::dvec3 corner : {glm::dvec3(0.78, -0.1, 0.0), glm::dvec3(-0.98, -0.1, -0.98),
                                    glm::dvec3(0.58, -0.1, -0.98), glm::dvec3(0.0, -0.1, 0.58)}) {
        Pool scene(500, 1.5, 1.0, 1.0);
        scene.addFloor(7, {0.0, -1.2, 0.0});
        for (const double side : {-1.0, 1.0}) {
            scene.add(solidGrid({40, 20, 10}, 7), {-2.0, -1.5, side < 0.0 ? -2.05 : 1.05}, true);
            scene.add(solidGrid({10, 20, 40}, 7), {side < 0.0 ? -2.05 : 1.05, -1.5, -2.0}, true);
        }
        scene.add(solidGrid({4, 2, 4}, 1), corner, false);
        scene.load();
        scene.seconds(15.0);
        EXPECT_NEAR(scene.submerged(5), 0.5, 0.02);
        EXPECT_NEAR(scene.center(5).y, 0.0, 0.02);
    }
}

TEST(Buoyancy, OnlyWhatIsWithinTheOutlineIsInTheWater) {
    for (const double outside : {0.05, 0.23, 0.4, 0.61}) {
        Pool scene(500, 1.5, 1.0, 1.0);
        scene.add(solidGrid({8, 2, 4}, 1), {0.2 + outside, -0.5, 0.0}, false);
        scene.load();
        EXPECT_NEAR(scene.submerged(0), 1.0 - outside / 0.8, 0.02) << outside;
    }
    Pool scene(500, 1.5, 1.0, 1.0);
    scene.add(solidGrid({2, 2, 2}, 1), {0.0, -1.13, 0.0}, false);
    scene.load();
    EXPECT_NEAR(scene.submerged(0), 0.35, 1e-6) << "the rest is below the water's bottom";
}

/// 64 t at 0.25 m/s lose what the water's drag of 0.01 / s takes, and nothing else.
TEST(Buoyancy, ARaftIsStoppedByTheWaterAlone) {
    Pool scene(500, 0.01);
    scene.add(solidGrid({80, 20, 80}, 1), {-4.0, -1.0, -4.0}, false).velocity = {0.25f, 0.0f, 0.0f};
    scene.load();
    scene.seconds(10.0);
    EXPECT_NEAR(double(scene.body(0).velocity.x) / (0.25 * std::exp(-0.1)), 1.0, 0.002);
}

}  // namespace
}  // namespace rubble
