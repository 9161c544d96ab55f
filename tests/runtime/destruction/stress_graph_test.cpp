#include "runtime/destruction/stress_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "tests/runtime/destruction/stress_fixture.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

/// A wall with windows, whose bricks have several nodes each.
StressFixture wallWithWindows() {
    StressFixture f({64, 64, 8});
    f.anchor({{0, 0, 0}, {64, 4, 8}});
    f.fill({{0, 4, 0}, {64, 64, 8}});
    for (int y = 10; y < 60; y += 10)
        for (int x = 3; x < 60; x += 6) f.fill({{x, y, 0}, {x + 4, y + 5, 8}}, 0);
    return f;
}

void setAll(StressGraph& graph, const StressFixture& f) {
    f.grid.forEachBrick(
        [&](glm::ivec3 brick, const BrickRef&) { graph.setBrick(f.grid, f.anchors, f.entries, brick); });
}

/// What bonds a graph has, whatever slots its nodes are in.
auto bondsOf(const StressGraph& graph) {
    std::vector<std::tuple<int, int, int, int, int, uint64_t, double>> out;
    for (uint32_t i = 0; i < graph.nodes().size(); ++i)
        if (graph.nodes()[i].isUsed)
            graph.forEachBond(i, [&](const StressBond& bond, uint32_t other) {
                EXPECT_TRUE(graph.nodes()[other].isUsed);
                EXPECT_TRUE((bond.below == i && bond.above == other) || (bond.above == i && bond.below == other));
                const Section& s = bond.section;
                out.emplace_back(s.brick.x, s.brick.y, s.brick.z, s.axis, s.plane, s.cells, bond.length);
            });
    std::sort(out.begin(), out.end());
    return out;
}

TEST(StressGraph, ChangedBrickByBrickIsAsMadeAtOnce) {
    StressFixture f = wallWithWindows();
    StressGraph changed, whole;
    setAll(changed, f);
    const size_t bonds = bondsOf(changed).size();
    for (const CellBox hole : {CellBox{{20, 20, 0}, {44, 40, 8}}, CellBox{{7, 7, 0}, {9, 9, 8}}}) {
        f.fill(hole, 0);
        for (int y = hole.low.y / 8; y <= (hole.high.y - 1) / 8; ++y)
            for (int x = hole.low.x / 8; x <= (hole.high.x - 1) / 8; ++x)
                changed.setBrick(f.grid, f.anchors, f.entries, {x, y, 0});
    }
    setAll(whole, f);
    EXPECT_EQ(bondsOf(changed), bondsOf(whole));
    EXPECT_LT(bondsOf(changed).size(), bonds);
}

TEST(StressGraph, ToChangeABrickAgainTakesNoMemory) {
    const StressFixture f = wallWithWindows();
    StressGraph graph;
    setAll(graph, f);
    setAll(graph, f);
    const size_t before = allocationCount();
    setAll(graph, f);
    EXPECT_EQ(allocationCount(), before);
}

}  // namespace
}  // namespace rubble
