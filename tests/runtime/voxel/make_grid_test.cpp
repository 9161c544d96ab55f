#include "runtime/voxel/make_grid.h"

#include <gtest/gtest.h>

#include <vector>

#include "runtime/core/random.h"

namespace rubble {
namespace {

/// The same grid, written voxel by voxel.
template <class F>
VoxelGrid writtenGrid(glm::ivec3 size, F&& entryAt) {
    VoxelGrid grid(size);
    GridWriter writer(grid);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) writer.set({x, y, z}, entryAt(glm::ivec3(x, y, z)));
    writer.flush();
    return grid;
}

void expectEqual(const VoxelGrid& a, const VoxelGrid& b) {
    EXPECT_EQ(a.size(), b.size());
    EXPECT_EQ(a.voxelCount(), b.voxelCount());
    EXPECT_EQ(a.brickCount(), b.brickCount());
    EXPECT_EQ(a.contentHash(), b.contentHash());
}

constexpr glm::ivec3 kSizes[] = {{1, 1, 1}, {8, 8, 8}, {9, 3, 70}, {33, 64, 31}, {100, 40, 40}};

TEST(MakeGrid, EntriesAreThoseOfTheBytes) {
    Random random(3);
    for (const glm::ivec3 size : kSizes) {
        std::vector<uint8_t> bytes(size_t(size.x * size.y * size.z));
        for (uint8_t& byte : bytes) byte = random.below(3) ? uint8_t(random.below(5)) : uint8_t(0);
        expectEqual(gridOf(size, bytes), writtenGrid(size, [&](glm::ivec3 cell) {
                        return bytes[size_t((cell.z * size.y + cell.y) * size.x + cell.x)];
                    }));
    }
}

TEST(MakeGrid, BoxesAndBallsAreThoseWrittenVoxelByVoxel) {
    for (const glm::ivec3 size : kSizes) {
        expectEqual(solidBox(size, 7), writtenGrid(size, [](glm::ivec3) { return uint8_t(7); }));
        expectEqual(solidEllipsoid(size, 9), writtenGrid(size, [&](glm::ivec3 cell) {
                        double sum = 0.0;
                        for (int a = 0; a < 3; ++a) {
                            const double part = double(2 * cell[a] + 1 - size[a]);
                            sum += part * part / double(size[a] * size[a]);
                        }
                        return uint8_t(sum <= 1.0 ? 9 : 0);
                    }));
    }
}

TEST(MakeGrid, WhatLiesInsideIsShared) {
    const VoxelGrid grid = solidBox({256, 256, 256}, 1);
    EXPECT_EQ(grid.voxelCount(), 256u * 256u * 256u);
    EXPECT_EQ(grid.nodeAt({0, 0, 0}), grid.nodeAt({7, 7, 7}));
}

}  // namespace
}  // namespace rubble
