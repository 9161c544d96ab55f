// MagicaVoxel files that were written: importVox() gives the level again.
#include "runtime/assets/vox_export.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "runtime/assets/assets.h"
#include "tests/support/grids.h"
#include "tests/support/models.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

std::vector<const LevelShape*> shapesOf(const Level& level) {
    std::vector<const LevelShape*> out;
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes) out.push_back(&shape);
    return out;
}

/// The level as it comes back; `lost` receives what the file could not hold.
Level writeAndRead(const Level& level, std::vector<std::string>& lost) {
    const TempFolder folder;
    const Result<Done> written = writeVox(folder / "out.vox", level, lost);
    if (!written) throw std::runtime_error(written.error());
    Result<Level> again = importVox(folder / "out.vox", {});
    if (!again) throw std::runtime_error(again.error());
    return std::move(*again);
}

LevelBody bodyOf(VoxelGrid grid, PaletteRef palette, glm::dvec3 position) {
    LevelBody body{.name = "body", .pose = {position}};
    LevelShape& shape = body.shapes.emplace_back();
    shape.name = "shape";
    shape.grid = std::move(grid);
    shape.palette = std::move(palette);
    return body;
}

uint8_t materialNamed(const char* name) {
    return defaultMaterials().find(name);
}

TEST(VoxExport, AllModelsComeBackWithEqualVoxelsPaletteAndMaterials) {
    RUBBLE_REQUIRE_MODELS(modelPath(""));
    for (const auto& path : modelPaths()) {
        const Result<Level> level = importVox(path, {});
        ASSERT_TRUE(bool(level)) << level.error();
        std::vector<std::string> lost;
        const Level again = writeAndRead(*level, lost);
        for (const std::string& line : lost)  // the import makes tags of layers and frames
            EXPECT_TRUE(line.ends_with("objects: their tags") || line.ends_with("1 object: their tags"))
                << path << ": " << line;
        const std::vector<const LevelShape*> before = shapesOf(*level), after = shapesOf(again);
        ASSERT_EQ(after.size(), before.size()) << path;
        ASSERT_EQ(again.bodies.size(), level->bodies.size()) << path;
        EXPECT_EQ(again.lights.size(), level->lights.size()) << path;
        for (size_t i = 0; i < before.size(); ++i) {
            const LevelShape &was = *before[i], &is = *after[i];
            EXPECT_EQ(is.name, was.name) << path;
            EXPECT_EQ(is.hidden, was.hidden) << path << ": " << was.name;
            EXPECT_EQ(is.grid.size(), was.grid.size()) << path << ": " << was.name;
            EXPECT_EQ(is.grid.contentHash(), was.grid.contentHash()) << path << ": " << was.name;
            EXPECT_EQ(*is.palette, *was.palette) << path << ": " << was.name;
            EXPECT_EQ(again.bodies[i].pose.position, level->bodies[i].pose.position) << path << ": " << was.name;
        }
    }
}

TEST(VoxExport, SplitsWhatIsLargerThanAModel) {
    Level level;
    auto palette = std::make_shared<Palette>();
    (*palette)[7].material = materialNamed("wood");
    level.bodies.push_back(bodyOf(solidGrid({300, 20, 520}, 7), palette, {-1.0, 2.0, 3.0}));
    std::vector<std::string> lost;
    const Level again = writeAndRead(level, lost);
    EXPECT_TRUE(lost.empty());
    uint64_t voxels = 0;
    glm::dvec3 low(1e9), high(-1e9);
    EXPECT_EQ(again.bodies.size(), 2u * 1u * 3u);
    for (const LevelBody& body : again.bodies) {
        const LevelShape& shape = body.shapes.at(0);
        voxels += shape.grid.voxelCount();
        low = glm::min(low, body.pose.position);
        high = glm::max(high, body.pose.position + glm::dvec3(shape.grid.size()) * 0.1);
        EXPECT_EQ((*shape.palette)[7].material, materialNamed("wood")) << "white would be plaster";
    }
    EXPECT_EQ(voxels, 300u * 20u * 520u);
    EXPECT_LT(glm::length(low - glm::dvec3(-1.0, 2.0, 3.0)), 1e-6);
    EXPECT_LT(glm::length(high - glm::dvec3(29.0, 4.0, 55.0)), 1e-6);
}

TEST(VoxExport, KeepsLooksAndMaterialsThatColoursDoNotTell) {
    Level level;
    auto palette = std::make_shared<Palette>();
    const auto set = [&](size_t i, PaletteEntry entry) { (*palette)[i] = entry; };
    set(1, {.red = 10, .green = 200, .blue = 30, .material = materialNamed("concrete")});
    set(2, {.opacity = 77, .roughness = 3, .reflectivity = 21, .material = materialNamed("glass")});
    set(3, {.roughness = 60, .metallic = 190, .material = materialNamed("metal")});
    set(4, {.opacity = 200, .roughness = 9, .metallic = 130, .reflectivity = 63, .material = materialNamed("brick")});
    set(5, {.roughness = 26, .material = materialNamed("wood"), .emission = 7.3f});
    VoxelGrid grid({5, 1, 1});
    {
        GridWriter writer(grid);
        for (int i = 0; i < 5; ++i) writer.set({i, 0, 0}, uint8_t(i + 1));
    }
    level.bodies.push_back(bodyOf(grid, palette, {}));
    std::vector<std::string> lost;
    const Level again = writeAndRead(level, lost);
    for (const std::string& line : lost) ADD_FAILURE() << line;
    Palette read = *shapesOf(again).at(0)->palette;
    for (size_t i = 1; i <= 5; ++i) {
        read[i].lightGroup = 0;
        EXPECT_EQ(read[i], (*palette)[i]) << "entry " << i;
    }
}

TEST(VoxExport, MergesPalettesAndTellsWhatIsLost) {
    Level level;
    for (const uint8_t red : {10, 20, 10}) {
        auto palette = std::make_shared<Palette>();
        (*palette)[1] = {.red = red, .green = 0, .blue = 0, .material = materialNamed("brick")};
        level.bodies.push_back(bodyOf(solidGrid({2, 2, 2}, 1), palette, glm::dvec3(double(red), 0.0, 0.04)));
    }
    level.waters.emplace_back();
    std::vector<std::string> lost;
    const Level again = writeAndRead(level, lost);
    ASSERT_EQ(lost.size(), 2u);
    EXPECT_EQ(lost[0], "3 shapes: the nearest whole cells and right angles stand for their places");
    EXPECT_EQ(lost[1], "1 body of water");
    const std::vector<const LevelShape*> shapes = shapesOf(again);
    ASSERT_EQ(shapes.size(), 3u);
    const auto colorOf = [&](size_t i) { return int((*shapes[i]->palette)[shapes[i]->grid.at(glm::ivec3(0))].red); };
    EXPECT_EQ(colorOf(0), 10);
    EXPECT_EQ(colorOf(1), 20);
    EXPECT_EQ(colorOf(2), 10);
}

}  // namespace
}  // namespace rubble
