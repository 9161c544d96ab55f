#include "runtime/destruction/dense_labels.h"

#include <gtest/gtest.h>

#include "tests/runtime/destruction/reference_algorithms.h"

namespace rubble {
namespace {

TEST(DenseLabels, EqualAFloodFillInItsOrder) {
    for (int percent : {0, 5, 31, 60, 95, 100})
        for (const glm::ivec3 size :
             {glm::ivec3(1), glm::ivec3(64, 3, 2), glm::ivec3(37, 21, 19), glm::ivec3(133, 9, 7)}) {
            SCOPED_TRACE(testing::Message() << percent << " %, " << size.x << "x" << size.y << "x" << size.z);
            const VoxelGrid grid = noiseGrid(size, percent, uint64_t(percent));
            const test::PlainGrid plain(grid);
            const auto expected = test::floodFill(plain);
            std::vector<uint32_t> labels(plain.cells.size(), 77), expectedLabels(plain.cells.size());
            const std::vector<uint64_t> voxels = labelDense(size, plain.cells, labels);
            ASSERT_EQ(voxels.size(), expected.size());
            for (size_t i = 0; i < expected.size(); ++i) {
                EXPECT_EQ(voxels[i], expected[i].size());
                for (const size_t cell : expected[i]) expectedLabels[cell] = uint32_t(i + 1);
            }
            ASSERT_EQ(labels, expectedLabels);
            std::vector<uint64_t> sizes = componentSizes(grid), sortedVoxels = voxels;
            std::sort(sizes.begin(), sizes.end());
            std::sort(sortedVoxels.begin(), sortedVoxels.end());
            ASSERT_EQ(sizes, sortedVoxels);
        }
}

}  // namespace
}  // namespace rubble
