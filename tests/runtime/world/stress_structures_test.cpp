// Structures of beam theory in a World: at 0.9 of their breaking load they stand, at 1.1 they break where theory says.
#include "tests/runtime/world/stress_structures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

using namespace test;

constexpr int kSteps = 300;
constexpr double kTenth[] = {0.9, 1.1};  ///< multiples of the breaking load

/// The cracks of a structure at a multiple of its breaking load; none if it stands. `strengthScale`: at which it just
/// stands.
std::vector<CrackOpened> cracksUnder(double overload, World& world, const Structure& structure, double strengthScale) {
    const Outcome out = stand(world, structure.level(), strengthScale / overload, kSteps);
    EXPECT_EQ(out.isBroken(), overload > 1.0);
    EXPECT_FALSE(world.data().stress->isBusy());
    EXPECT_TRUE(voxelAccounting(world).balances());
    EXPECT_TRUE(world.bodies().at(world.shapes().at(firstShape(world)).body).isStatic) << "what is anchored stands";
    return out.cracks;
}

TEST(StressStructures, SimplySupportedBeamBreaksInTheMiddle) {
    for (const int depth : {4, 8})
        for (const double overload : kTenth) {
            const int length = 16 * depth;
            Structure beam({280, 40, 40});
            const glm::ivec3 low(11), high = low + glm::ivec3(length, depth, depth), middle = low + depth / 2;
            beam.fill({low, high});
            for (const int x : {low.x, high.x - 1}) beam.fill({{x, low.y, low.z}, {x + 1, high.y, high.z}}, 2);
            for (const int x : {low.x - 1, high.x})  // a pinned support: one face of a cell that never breaks
                beam.anchor({{x, middle.y, middle.z}, {x + 1, middle.y + 1, middle.z + 1}}, 2);
            const double l = length * 0.1, d = depth * 0.1;
            World world;
            const auto cracks =
                cracksUnder(overload, world, beam, kConcreteWeight * 0.75 * l * l / d / kConcreteTension);
            if (cracks.empty()) continue;
            EXPECT_NEAR(cracks[0].position.x, 1.1 + l / 2.0, 0.25);
            EXPECT_EQ(cracks[0].cause, FailureMode::Tension);
        }
}

TEST(StressStructures, ColumnIsCrushedAtItsFoot) {
    for (const int height : {60, 160})
        for (const double overload : kTenth) {
            Structure column({40, 200, 40});
            column.anchor({{11, 3, 11}, {19, 4, 19}});
            column.fill({{11, 4, 11}, {19, 4 + height, 19}});
            World world;
            const auto cracks =
                cracksUnder(overload, world, column, kConcreteWeight * height * 0.1 / kConcreteCompression);
            if (cracks.empty()) continue;
            EXPECT_NEAR(cracks[0].position.y, 0.4, 1e-6);
            EXPECT_EQ(cracks[0].cause, FailureMode::Compression);
        }
}

TEST(StressStructures, PortalFrameBreaksWhereItsMomentIsLargest) {
    for (const int depth : {4, 8})
        for (const int rise : {40, 80})
            for (const double overload : kTenth) {
                const int low = 11, span = 96, foot = low + 4, width = span + depth, top = foot + rise + depth / 2;
                Structure frame({160, 140, 40});
                for (const int x : {low, low + width - depth}) {
                    frame.anchor({{x, low, low}, {x + depth, foot, low + depth}});
                    frame.fill({{x, foot, low}, {x + depth, top, low + depth}});
                }
                frame.fill({{low, top - depth, low}, {low + width, top, low + depth}});
                // Kleinlogel's formulas for portal frames, at the faces of the joints: tension in the beam's middle, at
                // its end, and on top of a column.
                const double l = span * 0.1, h = rise * 0.1, d = depth * 0.1, load = kConcreteWeight * d * d,
                             modulus = d * d * d / 6.0;
                const double corner = load * l * l / (6.0 * (h / l + 2.0)), thrust = 1.5 * corner / h;
                const double middle = (load * l * l / 8.0 - corner) / modulus - thrust / (d * d);
                const double end = (corner - load * l * d / 4.0 + load * d * d / 8.0) / modulus - thrust / (d * d);
                const double columnTop = (corner - thrust * d / 2.0) / modulus - load * l / 2.0 / (d * d);
                World world;
                const auto cracks =
                    cracksUnder(overload, world, frame, std::max({middle, end, columnTop}) / kConcreteTension);
                if (cracks.empty()) continue;
                EXPECT_EQ(cracks[0].cause, FailureMode::Tension);
                const double away = std::fabs(cracks[0].position.x - 0.1 * (low + width / 2));
                if (middle > 1.15 * std::max(end, columnTop)) {
                    EXPECT_LE(away, 0.4) << depth << " " << rise;
                }
                if (middle < 0.85 * std::max(end, columnTop)) {
                    EXPECT_NEAR(away, l / 2.0, d) << depth << " " << rise;
                }
            }
}

TEST(StressStructures, ANeckBreaksUnderItsHeadAndTheBaseStands) {
    for (const int neck : {4, 6})
        for (const int offset : {0, 3, 5})
            for (const double overload : kTenth) {
                const int width = 20, below = 20, above = 40;
                const glm::ivec3 low(8 + offset, offset, 8 + offset),
                    waist = low + glm::ivec3((width - neck) / 2, below, (width - neck) / 2);
                Structure hourglass({48, 80, 48});
                hourglass.anchor({low, low + glm::ivec3(width, 1, width)});
                hourglass.fill({low + glm::ivec3(0, 1, 0), low + glm::ivec3(width, below, width)});
                hourglass.fill({waist, waist + glm::ivec3(neck, 2, neck)});
                hourglass.fill({low + glm::ivec3(0, below + 2, 0), low + glm::ivec3(width, below + 2 + above, width)});
                const double area = neck * neck, head = kConcreteWeight * 0.1 * (above * width * width + area);
                World world;
                const auto cracks = cracksUnder(overload, world, hourglass, head / area / kConcreteCompression);
                if (cracks.empty()) continue;
                EXPECT_NEAR(cracks[0].position.y, 0.1 * (waist.y + 1), 0.11);
                EXPECT_EQ(cracks[0].cause, FailureMode::Compression);
                // Only the neck and the head are gone or came off.
                const VoxelAccounting accounting = voxelAccounting(world);
                EXPECT_GE(accounting.standing, uint64_t(below * width * width - neck * neck));
                EXPECT_LE(accounting.removed, uint64_t(4 * neck * neck));
                EXPECT_GE(accounting.inPieces, uint64_t(above * width * width - 3 * neck * neck));
            }
}

/// A wooden post under a block of metal, with a quarter of its strength in reserve.
Structure post() {
    Structure out({24, 48, 24});
    out.anchor({{8, 0, 8}, {16, 1, 16}});
    out.fill({{8, 1, 8}, {16, 25, 16}});
    out.fill({{0, 25, 0}, {24, 41, 24}}, 2);
    return out;
}

struct Stood {
    int steps = 0;
    uint64_t removed = 0;  ///< before it broke
};

Stood untilItBreaks(bool burns, int maxSteps) {
    const double weight = 7850.0 * 9.81 * 24 * 24 * 16 * 1e-3;
    World world;
    world.setSettings(stressOn(weight / 0.64 / 21e6 * 1.25));
    world.load(post().level("wood"));
    for (int step = 0; step < maxSteps; ++step) {
        const uint64_t removed = voxelAccounting(world).removed;
        Edits edits;
        if (burns && step == 30) edits.push_back(spawnFire({1.2, 1.2, 1.2}, 1.0));
        if (!world.applyEdits(edits).cracks.empty()) return {step, removed};
        EXPECT_TRUE(voxelAccounting(world).balances());
    }
    return {maxSteps, voxelAccounting(world).removed};
}

TEST(StressStructures, ABurningPostFailsBeforeItIsConsumed) {
    EXPECT_EQ(untilItBreaks(false, 600).steps, 600);
    const Stood burning = untilItBreaks(true, 600);
    EXPECT_GT(burning.steps, 60);
    EXPECT_LT(burning.steps, 400);
    EXPECT_EQ(burning.removed, 0u) << "char has weakened it before any voxel is gone";
}

}  // namespace
}  // namespace rubble
