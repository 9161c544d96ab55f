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

using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;

/// The pairs that overlap, of all, sorted.
Pairs overlapsOf(const std::vector<WorldBox>& boxes) {
    Pairs pairs;
    for (uint32_t i = 0; i < boxes.size(); ++i)
        for (uint32_t k = i + 1; k < boxes.size(); ++k)
            if (boxes[i].overlaps(boxes[k])) pairs.emplace_back(i, k);
    return pairs;
}

/// The pairs that are found, sorted.
Pairs findPairs(const std::vector<WorldBox>& boxes, const glm::dvec3& origin) {
    PackedBoxes packed;
    packed.build(boxes, origin);
    Pairs found;
    packed.findPairs(found);
    for (auto& [a, b] : found)
        if (a > b) std::swap(a, b);
    std::sort(found.begin(), found.end());
    return found;
}

/// Finds the pairs that overlap, and compares with all.
void expectAllOverlaps(const std::vector<WorldBox>& boxes, const glm::dvec3& origin) {
    ASSERT_EQ(findPairs(boxes, origin), overlapsOf(boxes)) << "of " << boxes.size();
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
    const Pairs found = findPairs(boxes, glm::dvec3(0.0)), overlaps = overlapsOf(boxes);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), overlaps.begin(), overlaps.end()));
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
}

}  // namespace
}  // namespace rubble
