#include "runtime/world/impacts/impact_damage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

/// A block of one default material on the ground of another.
Level blockOnGround(const char* material, glm::ivec3 size, const char* ground = "rock") {
    Level level;
    auto palette = std::make_shared<Palette>();
    (*palette)[1].material = defaultMaterials().find(material);
    (*palette)[2].material = defaultMaterials().find(ground);
    const auto add = [&](VoxelGrid grid, glm::dvec3 corner, bool isStatic) {
        LevelBody body{.name = "body", .pose = {corner}, .isStatic = isStatic};
        body.shapes.push_back({.name = "shape", .grid = std::move(grid), .palette = palette});
        level.bodies.push_back(std::move(body));
    };
    add(solidGrid(size, 1), {0, 0, 0}, false);
    add(solidGrid({40, 4, 40}, 2), {-1.0, -0.4, -1.0}, true);
    return level;
}

struct Hit {
    explicit Hit(const Level& level) {
        world.load(level);
        std::vector<BodyHandle> bodies;
        world.bodies().forEach([&](BodyHandle handle, const Body&) { bodies.push_back(handle); });
        impact = {.body = bodies[0], .other = bodies[1], .position = {0.5, 0.0, 0.5}};
        mass = bodyMass(world, bodies[0]).mass;
    }
    /// Edits that an impact of this impulse, N s, causes.
    Edits with(double impulse) {
        impact.impulse = impulse;
        return impactDamage(world, {&impact, 1});
    }
    /// The impulse, N s, from which on it breaks something.
    double threshold() {
        double low = 0.0, high = 1e9;
        while (high - low > 1e-3) (with(0.5 * (low + high)).empty() ? low : high) = 0.5 * (low + high);
        return high;
    }
    World world;
    Impact impact;
    double mass;
};

TEST(ImpactDamage, ImpactsBreakRestingWeightDoesNot) {
    Hit hit(blockOnGround("concrete", {20, 20, 20}));
    EXPECT_TRUE(hit.with(hit.mass * 9.81 / 60.0).empty()) << "it only stands there";
    const Edits edits = hit.with(hit.mass * 5.0);
    ASSERT_EQ(edits.size(), 1u) << "the block breaks, rock does not";
    const FrameChanges changes = hit.world.applyEdits(edits);
    EXPECT_FALSE(changes.splits.empty());
    EXPECT_GT(voxelAccounting(hit.world).inPieces, 0u);
    EXPECT_TRUE(voxelAccounting(hit.world).balances());
    EXPECT_EQ(voxelAccounting(hit.world).imported, 8000u + 6400u);
}

TEST(ImpactDamage, AHoleInFineVoxelsHasABoundedNumberOfCells) {
    Level level = blockOnGround("concrete", {20, 20, 20});
    level.bodies[0].shapes[0].voxelSize = 0.004f;
    Hit hit(level);
    hit.impact.position = {0.04, 0.0, 0.04};
    const Edits edits = hit.with(1e9);
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_LE(std::get<BreakEdit>(edits[0]).radii[0], 32.0 * 0.0041) << "metres";
}

TEST(ImpactDamage, DamageDependsOnTheMaterial) {
    const auto threshold = [](const char* material) { return Hit(blockOnGround(material, {4, 4, 4})).threshold(); };
    EXPECT_NEAR(threshold("concrete"), 2000.0 * 2.0, 1.0) << "medium: twice the scene's threshold";
    EXPECT_LT(threshold("glass"), threshold("wood") / 5.0);
    EXPECT_LT(threshold("wood"), threshold("brick"));
    EXPECT_LT(threshold("brick"), threshold("concrete"));
    EXPECT_LT(threshold("concrete"), threshold("metal"));
    Hit rock(blockOnGround("rock", {4, 4, 4}));
    EXPECT_TRUE(rock.with(1e9).empty());
}

TEST(ImpactDamage, BothBodiesBreakByTheirMaterial) {
    Hit hit(blockOnGround("brick", {8, 8, 8}, "glass"));
    EXPECT_EQ(hit.with(1500.0).size(), 1u) << "glass only";
    EXPECT_EQ(hit.with(9000.0).size(), 2u);
}

TEST(ImpactDamage, OnlyTheHardestImpactsCount) {
    Hit hit(blockOnGround("plaster", {4, 4, 4}));
    std::vector<Impact> impacts(40, hit.impact);
    for (size_t i = 0; i < impacts.size(); ++i) impacts[i].impulse = 1500.0 + 100.0 * double(i);
    impacts[3].impulse = std::nan("");
    impacts[39].position = {0.1, 0.0, 0.1};
    const Edits edits = impactDamage(hit.world, impacts);
    ASSERT_EQ(edits.size(), hit.world.settings().impactsPerStep);
    EXPECT_EQ(std::get<BreakEdit>(edits[0]).position.x, 0.1);
    for (Impact& impact : impacts) impact.impulse = 20.0;
    EXPECT_TRUE(impactDamage(hit.world, impacts).empty());
}

}  // namespace
}  // namespace rubble
