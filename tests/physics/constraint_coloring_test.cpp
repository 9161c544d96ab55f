#include "physics/solver/constraint_coloring.h"

#include <gtest/gtest.h>

#include <set>

#include "runtime/core/random.h"

namespace rubble {
namespace {

struct Scene {
    std::vector<SolverBody> bodies;
    std::vector<std::pair<int, int>> pairs;
};

/// Neighbours in a heap 20 m wide; every second one also touches the world; and one pair that is far apart.
Scene heap(int count) {
    Scene scene;
    Random random(7);
    scene.bodies.resize(size_t(count) + 1);
    for (size_t i = 1; i < scene.bodies.size(); ++i) {
        const double x = random.unit() * 20.0, y = random.unit() * 3.0, z = random.unit() * 6.0;
        scene.bodies[i].position = {x, y, z};
    }
    for (int i = 1; i <= count; ++i)
        for (int k = i + 1; k <= count; ++k)
            if (glm::length(scene.bodies[size_t(i)].position - scene.bodies[size_t(k)].position) < 0.9)
                scene.pairs.emplace_back(i, k);
    for (int i = 1; i <= count; i += 2) scene.pairs.emplace_back(i, 0);
    scene.pairs.emplace_back(1, 2);
    return scene;
}

TEST(ConstraintColoring, ParallelTasksShareNoBodyAndCoverAllPairs) {
    const Scene scene = heap(600);
    ConstraintColoring coloring;
    coloring.build(scene.bodies, scene.pairs);
    std::multiset<uint32_t> done;
    size_t widest = 0;
    const ParallelFor watch = [&](size_t count, const std::function<void(size_t)>& body) {
        widest = std::max(widest, count);
        std::vector<int> owner(scene.bodies.size(), -1);
        for (size_t task = 0; task < count; ++task) {
            const std::multiset<uint32_t> before = done;
            body(task);
            for (const uint32_t pair : done) {
                if (before.count(pair)) continue;
                for (const int b : {scene.pairs[pair].first, scene.pairs[pair].second}) {
                    if (b == 0) continue;
                    ASSERT_TRUE(owner[size_t(b)] < 0 || owner[size_t(b)] == int(task))
                        << "body " << b << " is in two tasks";
                    owner[size_t(b)] = int(task);
                }
            }
        }
    };
    coloring.run(&watch, [&](size_t from, size_t to) {
        for (size_t i = from; i < to; ++i) done.insert(coloring.order()[i]);
    });
    ASSERT_EQ(done.size(), scene.pairs.size());
    for (uint32_t i = 0; i < scene.pairs.size(); ++i) ASSERT_EQ(done.count(i), 1u);
    EXPECT_GE(widest, 4u);
}

TEST(ConstraintColoring, ThreadsAreNotWokenForAFewItems) {
    const Scene scene = heap(600);
    ConstraintColoring coloring;
    coloring.build(scene.bodies, scene.pairs);
    coloring.replaceRanges([](size_t from, size_t) { return std::pair(from, from + 1); });
    size_t ran = 0;
    const ParallelFor never = [](size_t, const std::function<void(size_t)>&) { FAIL() << "a thread is woken"; };
    coloring.run(&never, [&](size_t, size_t) { ++ran; });
    EXPECT_GE(ran, 8u);
}

TEST(ConstraintColoring, FewPairsKeepTheirOrder) {
    const Scene scene = heap(100);
    ASSERT_LT(scene.pairs.size(), 2 * ConstraintColoring::kPairsPerStrip);
    ConstraintColoring coloring;
    coloring.build(scene.bodies, scene.pairs);
    for (uint32_t i = 0; i < scene.pairs.size(); ++i) ASSERT_EQ(coloring.order()[i], i);
}

}  // namespace
}  // namespace rubble
