#include "tests/abi/test_level.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "runtime/assets/assets.h"

namespace rubble {
namespace {

VoxelGrid tableGrid() {
    VoxelGrid grid({17, 10, 17});
    GridWriter writer(grid);
    for (int x = 0; x < 17; ++x)
        for (int z = 0; z < 17; ++z) {
            const bool leg = x >= 7 && x <= 9 && z >= 7 && z <= 9;
            for (int y = leg ? 0 : 8; y < 10; ++y) writer.set({x, y, z}, 1);
        }
    writer.flush();
    return grid;
}

}  // namespace

std::string writeTestLevel(const char* material) {
    auto palette = std::make_shared<Palette>();
    (*palette)[1].red = 200, (*palette)[1].green = 80, (*palette)[1].blue = 60;
    (*palette)[1].material = defaultMaterials().find(material);
    LevelShape shape;
    shape.name = "table";
    shape.grid = tableGrid();
    shape.palette = palette;
    LevelBody body;
    body.name = "table";
    body.shapes.push_back(std::move(shape));
    Level level;
    level.name = "table";
    level.bodies.push_back(std::move(body));
    level.lights.push_back(
        {.light = {.name = "light", .local = {{1.0, 3.0, 1.0}}, .color = {5.0f, 4.0f, 3.0f}, .reach = 8.0f}});

    const std::string path = std::filesystem::temp_directory_path() /
                             ("rubble_abi_" + std::to_string(getpid()) + "_" + material + ".rubble");
    const Result<Done> written = writeRubble(path, level);
    EXPECT_TRUE(written) << written.error();
    return path;
}

}  // namespace rubble
