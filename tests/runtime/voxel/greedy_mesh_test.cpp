#include "runtime/voxel/greedy_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "tests/support/grids.h"

namespace rubble {
namespace {

/// A face of one voxel: the voxel, and the side that it looks to.
using Face = std::tuple<int, int, int, int>;
/// What it looks like: entry and paint.
using Look = std::pair<int, int>;

/// Entry 3 can be seen through.
Palette paletteWithGlass() {
    Palette palette;
    palette[3].opacity = 100;
    return palette;
}

/// All faces that are seen, by looking at every voxel and its six neighbours.
std::map<Face, Look> facesOf(const VoxelGrid& grid, const OpaqueEntries& entries) {
    std::map<Face, Look> out;
    for (int z = 0; z < grid.size().z; ++z)
        for (int y = 0; y < grid.size().y; ++y)
            for (int x = 0; x < grid.size().x; ++x) {
                const glm::ivec3 cell(x, y, z);
                const uint8_t entry = grid.at(cell);
                if (!entry) continue;
                for (int side = 0; side < 6; ++side) {
                    glm::ivec3 beyond = cell;
                    beyond[side / 2] += side % 2 ? 1 : -1;
                    const uint8_t other = grid.at(beyond);
                    if (other && (entries.opaque[other] || !entries.opaque[entry])) continue;
                    const uint8_t paint = grid.brickAt(brickOfCell(cell))->paintAt(voxelIndex(cellInBrick(cell)));
                    out[{x, y, z, side}] = {entry, paint};
                }
            }
    return out;
}

/// The faces that the rectangles of all bricks cover; a face that is covered twice fails.
std::map<Face, Look> facesOfMesh(const VoxelGrid& grid, const OpaqueEntries& entries, size_t& quadCount) {
    std::map<Face, Look> out;
    std::vector<FaceQuad> quads;
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) {
        quads.clear();
        meshBrick(grid, brick, entries, quads);
        EXPECT_LE(quads.size(), kMaxBrickQuads);
        quadCount += quads.size();
        for (const FaceQuad& quad : quads) {
            const int axis = quad.side / 2;
            for (int v = 0; v < quad.height; ++v)
                for (int u = 0; u < quad.width; ++u) {
                    glm::ivec3 cell = brick * kBrickSize;
                    cell[axis] += quad.layer;
                    cell[(axis + 1) % 3] += quad.u + u;
                    cell[(axis + 2) % 3] += quad.v + v;
                    const bool isNew =
                        out.try_emplace({cell.x, cell.y, cell.z, quad.side}, quad.entry, quad.paint).second;
                    EXPECT_TRUE(isNew) << "covered twice";
                }
        }
    });
    return out;
}

TEST(GreedyMesh, CoversEachSeenFaceOnce) {
    for (const int percent : {3, 30, 50, 70, 97, 100})
        for (const glm::ivec3 size : {glm::ivec3(8, 8, 8), glm::ivec3(19, 11, 26)})
            for (const bool withGlass : {false, true}) {
                const VoxelGrid grid = noiseGrid(size, percent, uint64_t(percent));
                const OpaqueEntries entries(withGlass ? paletteWithGlass() : Palette{});
                size_t quads = 0;
                EXPECT_EQ(facesOfMesh(grid, entries, quads), facesOf(grid, entries)) << percent << " " << withGlass;
            }
}

TEST(GreedyMesh, CoversPaintedVoxelsByTheirPaint) {
    VoxelGrid grid = towerGrid({24, 24, 24});
    Random random(5);
    grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        BrickIndices indices, paint;
        expandBrick(brick.get(), indices);
        for (uint8_t& each : paint) each = random.below(3) ? uint8_t(0) : uint8_t(0x11 + random.below(2));
        grid.setBrick(position, makeBrick(indices, &paint));
    });
    const OpaqueEntries entries{Palette{}};
    size_t quads = 0;
    EXPECT_EQ(facesOfMesh(grid, entries, quads), facesOf(grid, entries));
}

TEST(GreedyMesh, AFlatWallIsARectangleABrickAndSide) {
    const VoxelGrid grid = solidGrid({32, 16, 8});
    const OpaqueEntries entries{Palette{}};
    size_t quads = 0;
    const auto faces = facesOfMesh(grid, entries, quads);
    EXPECT_EQ(faces.size(), size_t(2 * (32 * 16 + 16 * 8 + 8 * 32)));
    EXPECT_EQ(quads, size_t(2 * (4 * 2 + 2 * 1 + 1 * 4)));
}

TEST(GreedyMesh, ACheckerboardHasAsManyRectanglesAsThereCanBe) {
    const VoxelGrid grid = gridOf({8, 8, 8}, [](glm::ivec3 cell) { return uint8_t((cell.x + cell.y + cell.z) % 2); });
    std::vector<FaceQuad> quads;
    meshBrick(grid, {0, 0, 0}, OpaqueEntries{Palette{}}, quads);
    EXPECT_EQ(quads.size(), kMaxBrickQuads);
}

TEST(GreedyMesh, CornersGoCounterClockwiseAroundTheirNormal) {
    const VoxelGrid grid = noiseGrid({16, 16, 16}, 40, 9);
    std::vector<FaceQuad> quads;
    meshBrick(grid, {1, 0, 1}, OpaqueEntries{Palette{}}, quads);
    ASSERT_FALSE(quads.empty());
    for (const FaceQuad& quad : quads) {
        const auto corners = cornersOf(quad, {1, 0, 1});
        const glm::ivec3 a = corners[1] - corners[0], b = corners[3] - corners[0];
        EXPECT_EQ(corners[2], corners[1] + b);
        glm::ivec3 normal(0);
        normal[quad.side / 2] = quad.side % 2 ? 1 : -1;
        EXPECT_EQ(glm::ivec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x),
                  normal * (quad.width * quad.height));
    }
}

}  // namespace
}  // namespace rubble
