#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <tuple>

#include "runtime/assets/assets.h"
#include "tests/support/models.h"

namespace rubble {
namespace {

/// What a model holds, counted by an independent script.
struct KnownModel {
    const char* file;
    int models, shapes;
    uint64_t voxels;
    int colors;
};

void PrintTo(const KnownModel& known, std::ostream* out) {
    *out << known.file;
}

class RealModels : public testing::TestWithParam<KnownModel> {};

TEST_P(RealModels, HaveKnownPartsVoxelsAndColours) {
    const KnownModel& known = GetParam();
    const std::string path = modelPath(known.file);
    RUBBLE_REQUIRE_MODELS(path);
    ImportReport report;
    const Result<Level> level = importVox(path, {}, &report);
    ASSERT_TRUE(level) << level.error();
    std::map<int, uint64_t> colors;
    uint64_t voxels = 0;
    for (const LevelBody& body : level->bodies)
        for (const LevelShape& shape : body.shapes) {
            voxels += shape.grid.voxelCount();
            shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
                forEachVoxel(brick->occupancy, [&](int i) {
                    ++colors[brick->at(i)];
                    ASSERT_NE(int((*shape.palette)[brick->at(i)].material), 0);
                });
            });
        }
    EXPECT_EQ(report.models, known.models);
    EXPECT_EQ(report.shapes, known.shapes);
    EXPECT_EQ(report.voxels, known.voxels);
    EXPECT_EQ(voxels, known.voxels);
    EXPECT_EQ(int(colors.size()), known.colors);
    std::printf("| %s | %d | %d | %llu | %d |\n", known.file, report.models, report.shapes,
                static_cast<unsigned long long>(voxels), int(colors.size()));
}

INSTANTIATE_TEST_SUITE_P(
    Files, RealModels,
    testing::Values(KnownModel{"axes.vox", 4, 10, 12452, 4}, KnownModel{"chr_cop1.vox", 1, 1, 267, 10},
                    KnownModel{"metal-material.vox", 1, 1, 20, 1}, KnownModel{"obj_house3.vox", 1, 1, 119892, 9},
                    KnownModel{"obj_store12.vox", 1, 1, 85149, 12}, KnownModel{"obj_store15.vox", 1, 1, 125486, 14},
                    KnownModel{"placeholder-with-materials.vox", 1, 1, 4, 4},
                    KnownModel{"scene_checkpoint.vox", 1, 1, 130774, 44},
                    KnownModel{"scene_depot.vox", 1, 1, 120245, 29}, KnownModel{"scene_house6.vox", 1, 1, 207466, 24},
                    KnownModel{"scene_store7.vox", 1, 1, 173018, 42}, KnownModel{"scene_theater.vox", 1, 1, 128329, 30},
                    KnownModel{"test_multiple_model_scene.vox", 41, 104, 12926, 7},
                    KnownModel{"veh_bus.vox", 1, 1, 27286, 13}, KnownModel{"veh_cab1.vox", 1, 1, 3097, 11},
                    KnownModel{"veh_fire.vox", 1, 1, 15302, 17}, KnownModel{"veh_police1.vox", 1, 1, 3132, 11}),
    [](const auto& parameter) {
        std::string name = parameter.param.file;
        for (char& c : name)
            if (!isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    });

TEST(RealModels, PartsOfAMultiModelSceneDoNotOverlap) {
    const std::string path = modelPath("test_multiple_model_scene.vox");
    RUBBLE_REQUIRE_MODELS(path);
    const Result<Level> level = importVox(path, {});
    ASSERT_TRUE(level) << level.error();
    std::map<std::tuple<int, int, int>, std::string> cells;
    int overlaps = 0;
    for (const LevelBody& body : level->bodies) {
        const LevelShape& shape = body.shapes.at(0);
        const glm::ivec3 corner(glm::round(body.pose.position / 0.1));
        shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
            forEachVoxel(content->occupancy, [&](int i) {
                const glm::ivec3 c = corner + brick * kBrickSize + voxelInBrick(i);
                const auto [at, fresh] = cells.emplace(std::tuple(c.x, c.y, c.z), shape.name);
                if (!fresh && overlaps++ < 5)
                    std::printf("overlap of %s and %s at %d %d %d\n", at->second.c_str(), shape.name.c_str(), c.x, c.y,
                                c.z);
            });
        });
    }
    EXPECT_EQ(overlaps, 0);
}

}  // namespace
}  // namespace rubble
