#include "physics/collision/broadphase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "runtime/core/random.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// Objects of one voxel each, at places.
std::vector<std::unique_ptr<CollisionObject>> makeObjects(size_t count,
                                                          const std::function<glm::dvec3(size_t)>& place) {
    PhysicsScene scene;
    scene.add(solidGrid({1, 1, 1}, 7), {0, 0, 0}, true);
    scene.load();
    const Shape& shape = scene.world.shapes().at(scene.body(0).shapes[0]);
    std::vector<std::unique_ptr<CollisionObject>> objects;
    for (size_t i = 0; i < count; ++i) {
        objects.push_back(std::make_unique<CollisionObject>());
        CollisionObject& object = *objects.back();
        object.collider.parts.push_back(std::make_unique<ColliderPart>(shape, Pose{}, scene.world.materials()));
        object.number = uint32_t(i);
        object.setPose({place(i)});
    }
    return objects;
}

/// Depth of the tree of `count` objects that are added in order.
int depthOf(size_t count, bool moves, const std::function<glm::dvec3(size_t)>& place) {
    const auto objects = makeObjects(count, place);
    Broadphase broadphase;
    for (const auto& object : objects) broadphase.add(*object, moves);
    return broadphase.depth();
}

TEST(Broadphase, ObjectsInOnePlaceMakeAShallowTree) {
    for (const double away : {0.0, 3.0, 1e4, 1e6})
        for (const bool moves : {false, true})
            EXPECT_LT(depthOf(5000, moves, [&](size_t) { return glm::dvec3(away, 0.5 * away, 3.0); }), 60)
                << away << " m from the origin";
}

TEST(Broadphase, ObjectsThatMoveToOnePlaceMakeAShallowTree) {
    const auto objects = makeObjects(5000, [](size_t i) { return glm::dvec3(0.3 * double(i), 0.0, 0.0); });
    Broadphase broadphase;
    for (const auto& object : objects) broadphase.add(*object, true);
    for (const auto& object : objects) {
        object->setPose({{1.0, 2.0, 3.0}});
        broadphase.setBounds(*object, {0.0, 0.0, 0.0}, 0.02), broadphase.move(*object);
    }
    EXPECT_LT(broadphase.depth(), 60);
}

TEST(Broadphase, AnyOrderOfObjectsMakesATreeOfLimitedDepth) {
    constexpr size_t kCount = 5000;
    const double limit = 50.0 + 6.0 * std::sqrt(double(kCount));  // far below the 5,000 of a list
    EXPECT_LT(depthOf(kCount, false, [](size_t i) { return glm::dvec3(0.5 * double(i), 0, 0); }), limit) << "a row";
    EXPECT_LT(depthOf(kCount, false, [](size_t i) { return glm::dvec3(1e6 / double(i + 1), 0, 0); }), limit)
        << "ever closer";
    EXPECT_LT(depthOf(kCount, false, [](size_t i) { return glm::dvec3(double(i % 71), 0.0, double(i / 71)); }), 120)
        << "a square, row by row";
}

TEST(Broadphase, FindsWhatOverlapsABoxThroughMovesAndRemovals) {
    Random random(3);
    const auto anywhere = [&](size_t) { return glm::dvec3(random.unit(), random.unit(), random.unit()) * 4.0; };
    const auto objects = makeObjects(300, anywhere);
    Broadphase broadphase;
    for (int round = 0; round < 20; ++round) {
        std::vector<CollisionObject*> expected, found;
        for (const auto& object : objects) {
            broadphase.remove(*object);
            object->setPose({anywhere(0)});
            if (random.below(4) == 0) continue;
            broadphase.add(*object, true);
            broadphase.setBounds(*object, {0.3 * random.unit(), 0.0, 0.0}, 0.01), broadphase.move(*object);
            const WorldBox bounds{object->low, object->high};
            if (bounds.overlaps({glm::dvec3(1.0), glm::dvec3(2.5)})) expected.push_back(object.get());
        }
        broadphase.find(glm::dvec3(1.0), glm::dvec3(2.5), found);
        const auto byNumber = [](const CollisionObject* a, const CollisionObject* b) { return a->number < b->number; };
        std::sort(found.begin(), found.end(), byNumber);
        EXPECT_EQ(found, expected);
    }
}

TEST(Broadphase, PairsAreAllOverlapsOfWhatMovesOnceAndSorted) {
    Random random(4);
    const auto objects =
        makeObjects(300, [&](size_t) { return glm::dvec3(random.unit(), random.unit(), random.unit()) * 2.0; });
    Broadphase broadphase;
    std::vector<CollisionObject*> moving;
    std::vector<ObjectPair> expected, found;
    for (const auto& object : objects) {
        broadphase.add(*object, object->number % 3 != 0);
        if (object->number % 3 == 0) continue;
        broadphase.setBounds(*object, glm::dvec3(0.0), 0.01), broadphase.move(*object);
        moving.push_back(object.get());
    }
    for (const auto& a : objects)
        for (const auto& b : objects) {
            if (a->number >= b->number || (a->number % 3 == 0 && b->number % 3 == 0)) continue;
            if (WorldBox{a->low, a->high}.overlaps({b->low, b->high})) expected.emplace_back(a.get(), b.get());
        }
    EXPECT_EQ(broadphase.findPairs(moving, found), 0u);
    EXPECT_EQ(found, expected);
    EXPECT_GT(found.size(), 30u);
}

}  // namespace
}  // namespace rubble
