// Files go through other programs and come back with equal voxels, where those programs are installed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "editor/core/cells.h"
#include "editor/core/palette.h"
#include "editor/core/rotation.h"
#include "tests/editor/editor_level.h"

namespace editor {
namespace {

using Colors = std::map<std::array<int, 3>, std::array<int, 3>>;

/// Whether a command of the shell works.
bool works(const std::string& command) {
    return std::system((command + " > other_program.txt 2>&1").c_str()) == 0;
}

/// The cells of 0.1 m in which a level has voxels, counted from their lowest corner, with their colours.
Colors colorsOf(Editor& editor) {
    Colors found, moved;
    std::array<int, 3> low{1 << 30, 1 << 30, 1 << 30};
    for (const rubble_shape shape : editor.world().get_objects(RUBBLE_KIND_SHAPE)) {
        const rubble_shape_state state = editor.world().get_shape_state(shape);
        const Cells grid = gridOf(editor.world(), shape);
        const std::vector<uint8_t> voxels = readCells(editor.world(), shape, grid);
        const std::vector<rubble_palette_entry> palette = paletteOf(editor.world(), shape);
        for (size_t i = 0; i < voxels.size(); ++i) {
            if (!voxels[i]) continue;
            const int x = int(i) % grid.size.x, y = int(i) / grid.size.x % grid.size.y;
            const glm::dvec3 middle = glm::dvec3(x, y, int(i) / grid.size.x / grid.size.y) + 0.5;
            const glm::dvec3 at = vectorOf(state.position) + quaternionOf(state.rotation) * (middle * state.voxel_size);
            std::array<int, 3> cell{};
            for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], cell[a] = int(std::floor(at[a] * 10.0 + 1e-3)));
            const uint8_t(&color)[3] = palette[voxels[i]].color;
            found[cell] = {color[0], color[1], color[2]};
        }
    }
    for (const auto& [cell, color] : found) moved[{cell[0] - low[0], cell[1] - low[1], cell[2] - low[2]}] = color;
    return moved;
}

bool hasGoxel() {
    return works("command -v goxel") && works("command -v xvfb-run");
}
constexpr const char* kNoGoxel = "goxel or xvfb-run is not installed";

bool goxel(const std::string& from, const std::string& to) {
    return works(fmt::format("timeout 60 xvfb-run -a goxel {} --export {}", from, to));
}

TEST(OtherPrograms, GoxelGivesBackTheVoxelsThatItGets) {
    const ExampleFolder folder;
    if (!hasGoxel()) GTEST_SKIP() << kNoGoxel;
    Editor editor, again;
    runAll(editor, {"create 8,6,4 name=a index=7 static=yes", "voxel 0,0,0 erase shape=a",
                    "voxel 1,1,3 paint 9 shape=a", "create 4,6,4 2,1,1 name=b index=9", "entry 9 color=#ff8000 shape=b",
                    "create 2,4,2 -2,0,0 index=5 name=c", "export ours.vox"});
    ASSERT_TRUE(goxel("ours.vox", "theirs.vox"));
    runAll(again, {"open theirs.vox"});
    EXPECT_EQ(again.world().get_objects(RUBBLE_KIND_SHAPE).size(), 1u) << "it writes one object of all";
    EXPECT_EQ(colorsOf(again), colorsOf(editor));
    runAll(again, {"export ours_again.vox"});
    ASSERT_TRUE(goxel("ours_again.vox", "theirs_again.vox"));
    runAll(again, {"open theirs_again.vox"});
    EXPECT_EQ(colorsOf(again), colorsOf(editor));
}

TEST(OtherPrograms, AFileByGoxelComesIn) {
    const ExampleFolder folder;
    if (!hasGoxel()) GTEST_SKIP() << kNoGoxel;
    std::ofstream("dots.txt") << "# x y z rrggbb, z up\n0 0 0 ff0000\n1 0 0 00ff00\n0 2 3 0000ff\n-1 2 3 0000ff\n";
    ASSERT_TRUE(goxel("dots.txt", "dots.vox"));
    Editor editor;
    runAll(editor, {"import dots.vox"});
    const Colors expected{
        {{1, 0, 2}, {255, 0, 0}}, {{2, 0, 2}, {0, 255, 0}}, {{1, 3, 0}, {0, 0, 255}}, {{0, 3, 0}, {0, 0, 255}}};
    EXPECT_EQ(colorsOf(editor), expected) << "y is up here";
}

TEST(OtherPrograms, BlenderGivesBackTheMeshThatItGets) {
    const ExampleFolder folder;
    if (!works("command -v blender")) GTEST_SKIP() << "blender is not installed";
    Editor editor, again({.vdbTool = RUBBLE_VDB_PROGRAM});
    runAll(editor, {"create 10,12,14 name=crate index=5", "entry 5 color=#204060 shape=crate",
                    "sphere 0,0,0 5 erase shape=crate", "export ours.glb"});
    std::ofstream("through.py") << "import bpy, numpy\nnumpy.bool = bool  # an older name that Blender 3 uses\n"
                                   "bpy.ops.object.select_all(action='SELECT')\nbpy.ops.object.delete()\n"
                                   "bpy.ops.import_scene.gltf(filepath='ours.glb')\n"
                                   "bpy.ops.export_scene.gltf(filepath='theirs.glb', export_colors=True)\n";
    ASSERT_TRUE(works("timeout 120 blender -b --factory-startup --python-exit-code 1 -P through.py"));
    runAll(again, {"import theirs.glb voxels=0"});
    EXPECT_EQ(colorsOf(again), colorsOf(editor));
}

}  // namespace
}  // namespace editor
