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

}  // namespace
}  // namespace rubble
