#include "samples/scenes/town.h"

#include <gtest/gtest.h>

#include <set>

#include "runtime/core/hash.h"
#include "samples/scenes/canvas.h"
#include "tests/samples/scenes/level_shapes.h"

namespace rubble {
namespace {

const Level& town() {
    static const Level level = makeTown(1);
    return level;
}

uint64_t hashShapes(const Level& level) {
    uint64_t hash = 0;
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) {
            hash = hashValue(shape.grid.contentHash(), hash);
            hash = hashValue(hashPalette(*shape.palette), hash);
            const Pose pose = body.pose * shape.local;
            const double numbers[7] = {pose.position.x, pose.position.y, pose.position.z, pose.rotation.w,
                                       pose.rotation.x, pose.rotation.y, pose.rotation.z};
            hash = hashBytes(numbers, sizeof numbers, hash);
        }
    return hash;
}

TEST(Town, IsTheSameForTheSameSeed) {
    EXPECT_EQ(hashShapes(town()), hashShapes(makeTown(1)));
    EXPECT_NE(hashShapes(town()), hashShapes(makeTown(2)));
}

TEST(Town, EveryVoxelIsConnectedToTheBottomLayer) {
    forEachShape(town(), [](const LevelBody&, const LevelShape& shape) {
        const std::vector<bool> anchored = scenes::anchoredCells(shape.grid);
        const glm::ivec3 size = shape.grid.size();
        uint64_t loose = 0;
        glm::ivec3 example(0);
        size_t i = 0;
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x, ++i)
                    if (!anchored[i] && shape.grid.at({x, y, z})) ++loose, example = {x, y, z};
        EXPECT_EQ(loose, 0u) << shape.name << ": for example cell " << example.x << " " << example.y << " "
                             << example.z;
    });
}

TEST(Town, PalettesLeaveEntriesForPaint) {
    forEachShape(town(), [](const LevelBody&, const LevelShape& shape) {
        int used = 0;
        for (size_t i = 1; i < 256; ++i) used += (*shape.palette)[i].material != 0;
        EXPECT_LE(used, 160) << shape.name;
        shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
            forEachVoxel(brick->occupancy,
                         [&](int cell) { ASSERT_NE((*shape.palette)[brick->at(cell)].material, 0) << shape.name; });
        });
    });
}

TEST(Town, FitsItsBudget) {
    uint64_t voxels = 0;
    int loose = 0;
    forEachShape(town(), [&](const LevelBody& body, const LevelShape& shape) {
        voxels += shape.grid.voxelCount();
        loose += !body.isStatic;
        EXPECT_GT(shape.grid.voxelCount(), 0u) << shape.name;
        const glm::dvec3 high = (body.pose * shape.local).position + glm::dvec3(shape.grid.size()) * 0.1;
        EXPECT_LE(high.y, 22.0) << shape.name;
    });
    EXPECT_GT(voxels, 3'000'000u);
    EXPECT_LT(voxels, 9'000'000u);
    EXPECT_GE(loose, 40);
}

TEST(Town, EveryLightHasItsHostAndGroup) {
    std::multiset<std::string> names;
    forEachShape(town(), [&](const LevelBody&, const LevelShape& shape) { names.insert(shape.name); });
    for (const std::string& name : names) EXPECT_EQ(names.count(name), 1u) << name << " is not unique";
    for (const LevelLight& light : town().lights) {
        EXPECT_EQ(names.count(light.shapeName), 1u) << light.light.name << " hangs on " << light.shapeName;
        bool found = false;
        for (const LightGroup& group : town().lightGroups) found = found || group.name == light.groupName;
        EXPECT_TRUE(found) << light.groupName;
    }
    std::vector<uint64_t> voxels(town().lightGroups.size() + 1);
    forEachShape(town(), [&](const LevelBody&, const LevelShape& shape) {
        shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int cell) {
                const uint32_t group = (*shape.palette)[brick->at(cell)].lightGroup;
                ASSERT_LT(group, voxels.size());
                ++voxels[group];
            });
        });
    });
    for (size_t i = 1; i < voxels.size(); ++i)
        EXPECT_GT(voxels[i], 3u) << town().lightGroups[i - 1].name << " has no voxels";
}

TEST(StreetStage, PutsAModelOnTheSquare) {
    Level model;
    model.lightGroups.push_back({"its own light"});
    LevelBody body;
    body.pose.position = {-3.0, 5.0, 100.0};
    LevelShape shape;
    shape.name = "model";
    shape.grid = VoxelGrid({30, 40, 20});
    GridWriter(shape.grid).set({0, 0, 0}, 1);
    auto palette = std::make_shared<Palette>();
    (*palette)[1].material = 1;
    (*palette)[1].lightGroup = 1;
    shape.palette = palette;
    body.shapes.push_back(std::move(shape));
    model.bodies.push_back(std::move(body));

    glm::dvec3 low, high;
    const Level stage = makeStreetStage(model, 1, low, high);
    EXPECT_NEAR(low.y, 0.0, 1e-9);
    EXPECT_NEAR(high.y, 4.0, 1e-6);
    EXPECT_GT(low.x, 14.0);
    EXPECT_LT(high.z, 44.6);
    EXPECT_EQ(stage.lightGroups.front().name, "its own light");
    EXPECT_GT(stage.lightGroups.size(), 1u);
    EXPECT_EQ(stage.bodies.back().shapes.front().name, "model");
    EXPECT_NEAR(stage.bodies.back().pose.position.y, 0.0, 1e-9);
}

TEST(StreetStage, LeavesOutWhatTheModelWouldTouch) {
    Level model;
    LevelBody body;
    LevelShape shape;
    shape.grid = VoxelGrid({600, 30, 600});
    GridWriter(shape.grid).set({0, 0, 0}, 1);
    shape.palette = std::make_shared<Palette>();
    body.shapes.push_back(std::move(shape));
    model.bodies.push_back(std::move(body));
    glm::dvec3 low, high;
    const Level stage = makeStreetStage(model, 1, low, high);
    for (const LevelLight& light : stage.lights) {
        bool found = false;
        forEachShape(stage,
                     [&](const LevelBody&, const LevelShape& each) { found = found || each.name == light.shapeName; });
        EXPECT_TRUE(found) << light.shapeName;
    }
    EXPECT_LT(stage.bodies.size(), 10u);
}

}  // namespace
}  // namespace rubble
