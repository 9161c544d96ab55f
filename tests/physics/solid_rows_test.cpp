#include "physics/shapes/solid_rows.h"

#include <gtest/gtest.h>

#include "runtime/core/random.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

/// The same cell by cell.
int widestGapByCells(const VoxelGrid& grid) {
    int widest = 0;
    const glm::ivec3 size = grid.size();
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < size[u]; ++i)
            for (int k = 0; k < size[v]; ++k) {
                int last = -1;
                for (int n = 0; n < size[axis]; ++n) {
                    glm::ivec3 cell;
                    cell[axis] = n, cell[u] = i, cell[v] = k;
                    if (!grid.at(cell)) continue;
                    if (last >= 0) widest = std::max(widest, n - last - 1);
                    last = n;
                }
            }
    }
    return widest;
}

TEST(SolidRows, TheWidestGapIsThatOfItsCells) {
    Random random(3);
    int none = 0, wide = 0;
    for (int i = 0; i < 600; ++i) {
        const glm::ivec3 size(random.between(1, 20), random.between(1, 20), random.between(1, 20));
        const int percent = random.between(0, 100);
        VoxelGrid grid = gridOf(size, [&](glm::ivec3) { return uint8_t(random.between(1, 100) <= percent); });
        const SolidRows rows(grid, {glm::ivec3(0), size});
        ASSERT_EQ(rows.widestGap(), widestGapByCells(grid)) << "grid " << i;
        none += rows.widestGap() == 0, wide += rows.widestGap() > 4;
    }
    EXPECT_GT(none, 10);
    EXPECT_GT(wide, 10);
}

/// Whether any cell from low to high, both included, is solid.
bool anyByCells(const VoxelGrid& grid, glm::ivec3 low, glm::ivec3 high) {
    low = glm::max(low, 0), high = glm::min(high, grid.size() - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                if (grid.at({x, y, z})) return true;
    return false;
}

TEST(SolidRows, BoxesAndNeighboursAreThoseOfTheCells) {
    Random random(4);
    int found = 0, missed = 0;
    for (int i = 0; i < 3000; ++i) {
        const glm::ivec3 size(random.between(1, 12), random.between(1, 12), random.between(1, 12));
        VoxelGrid grid = gridOf(size, [&](glm::ivec3) { return uint8_t(random.between(1, 100) <= 30); });
        const SolidRows rows(grid, {glm::ivec3(0), size});
        const auto cell = [&] {
            return glm::ivec3(random.between(-4, 14), random.between(-4, 14), random.between(-4, 14));
        };
        const glm::ivec3 low = cell(),
                         high = low + glm::ivec3(random.between(-1, 4), random.between(-1, 4), random.between(-1, 4));
        const bool any = anyByCells(grid, low, high);
        ASSERT_EQ(rows.any(Int4{low.x, low.y, low.z, 0}, Int4{high.x, high.y, high.z, 0}), any) << "grid " << i;
        any ? ++found : ++missed;
        const glm::ivec3 at = cell();
        if (!rows.coversAround(at)) continue;
        uint32_t neighbours = 0;
        for (int bit = 0; bit < 6; ++bit) {
            glm::ivec3 beside = at;
            beside[bit / 2] += bit % 2 ? 1 : -1;
            neighbours |= uint32_t(rows.solid(beside)) << bit;
        }
        ASSERT_EQ(rows.solidNeighbours(at), neighbours) << "grid " << i;
    }
    EXPECT_GT(found, 100);
    EXPECT_GT(missed, 100);
}

}  // namespace
}  // namespace rubble
