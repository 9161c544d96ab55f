#include "physics/collision/packed_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/core/random.h"

namespace rubble {
namespace {

/// A point on a lattice that floats hold exactly.
glm::dvec3 latticePoint(Random& random, uint32_t size) {
    return glm::dvec3(random.below(size), random.below(size), random.below(size)) * 0.125;
}

/// Finds what overlaps each of the boxes, and compares with all pairs.
void expectAllOverlaps(const std::vector<WorldBox>& boxes, const glm::dvec3& origin) {
    PackedBoxes packed;
    packed.build(boxes, origin);
    std::vector<uint32_t> found, expected;
    for (const WorldBox& box : boxes) {
        found.clear(), expected.clear();
        packed.find(box, found);
        std::sort(found.begin(), found.end());
        for (uint32_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].overlaps(box)) expected.push_back(i);
        ASSERT_EQ(found, expected) << "of " << boxes.size();
    }
}

TEST(PackedBoxes, FindWhatOverlapsWhateverTheirNumberAndSize) {
    Random random(5);
    for (const uint32_t count : {0u, 1u, 7u, 8u, 9u, 64u, 65u, 600u}) {
        std::vector<WorldBox> boxes;
        for (uint32_t i = 0; i < count; ++i) {
            const glm::dvec3 low = latticePoint(random, 80);
            boxes.push_back({low, low + latticePoint(random, i % 50 ? 10 : 200)});
        }
        expectAllOverlaps(boxes, glm::dvec3(0.0));
        expectAllOverlaps(boxes, glm::dvec3(64.0, -512.0, 0.5));
    }
}

TEST(PackedBoxes, FindBoxesInOnePlaceAndInOneLine) {
    std::vector<WorldBox> boxes(100, {glm::dvec3(1.0), glm::dvec3(2.0)});
    expectAllOverlaps(boxes, glm::dvec3(0.0));
    for (int i = 0; i < 100; ++i) boxes.push_back({glm::dvec3(i, 1.0, 1.0), glm::dvec3(i + 1.0, 2.0, 2.0)});
    expectAllOverlaps(boxes, glm::dvec3(0.0));
}

/// Where floats are 6 cm apart, some are found that miss by less, but none is missed.
TEST(PackedBoxes, MissNothingFarFromTheOrigin) {
    Random random(6);
    std::vector<WorldBox> boxes;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 low =
            glm::dvec3(1e6, -1e6, 1e6) + 3.0 * glm::dvec3(random.unit(), random.unit(), random.unit());
        boxes.push_back({low, low + 0.1});
    }
    PackedBoxes packed;
    packed.build(boxes, glm::dvec3(0.0));
    std::vector<uint32_t> found;
    for (const WorldBox& box : boxes) {
        found.clear();
        packed.find(box, found);
        for (uint32_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].overlaps(box)) {
                EXPECT_NE(std::find(found.begin(), found.end(), i), found.end()) << i;
            }
    }
}

}  // namespace
}  // namespace rubble
