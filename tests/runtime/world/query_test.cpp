#include "runtime/world/queries/query.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <thread>

#include "runtime/core/random.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

using namespace test;

/// A voxel as a rotated cube in the world, for a reference without grids.
struct Cube {
    glm::dvec3 middle;
    glm::dmat3 axes;
    double half;
    ShapeHandle shape;
    glm::ivec3 cell;

    glm::dvec3 closest(glm::dvec3 point) const {
        const glm::dvec3 local = glm::transpose(axes) * (point - middle);
        return middle + axes * glm::clamp(local, -half, half);
    }
    double distance(glm::dvec3 point) const { return glm::length(point - closest(point)); }
};

struct CubeScene {
    World world;
    std::vector<Cube> cubes;
};

double between(Random& random, double low, double high) {
    return low + (high - low) * double(random.unit());
}
glm::dvec3 pointIn(Random& random, double size) {
    const double x = between(random, -size, size);
    const double y = between(random, -size, size);
    const double z = between(random, -size, size);
    return {x, y, z};
}
glm::dquat turn(Random& random) {
    const glm::dvec3 axis = glm::normalize(pointIn(random, 1.0) + glm::dvec3(1e-9));
    return glm::angleAxis(between(random, 0.0, 6.28), axis);
}

CubeScene randomScene(uint64_t seed) {
    Random random(seed);
    Level level = oneShapeLevel(VoxelGrid({1, 1, 1}), true);
    level.bodies.clear();
    for (int i = 0; i < 7; ++i) {
        VoxelGrid grid({14, 9 + i, 11});
        {
            GridWriter writer(grid);
            for (int v = 0; v < 60; ++v) {
                const int x = int(random.below(14)), y = int(random.below(uint32_t(9 + i))), z = int(random.below(11));
                writer.set({x, y, z}, uint8_t(1 + random.below(4)));
            }
            if (i % 2)  // a solid block
                for (int v = 0; v < 4 * 5 * 4; ++v) writer.set({2 + v % 4, 2 + v / 4 % 5, 3 + v / 20}, 2);
        }
        LevelBody body{.name = "body", .pose = {pointIn(random, 1.6), turn(random)}, .isStatic = i % 3 != 0};
        body.shapes.push_back(levelShape("shape", std::move(grid)));
        body.shapes[0].voxelSize = i % 3 == 1 ? 0.05f : 0.1f;
        body.shapes[0].local = {pointIn(random, 0.3), turn(random)};
        body.shapes[0].collisionLayer = uint8_t(1 << (i % 3));
        level.bodies.push_back(std::move(body));
    }
    CubeScene scene;
    scene.world.load(level);
    scene.world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
        const Pose pose = shapeToWorld(scene.world, handle);
        for (int z = 0; z < shape.grid.size().z; ++z)
            for (int y = 0; y < shape.grid.size().y; ++y)
                for (int x = 0; x < shape.grid.size().x; ++x)
                    if (shape.grid.at({x, y, z}))
                        scene.cubes.push_back(
                            {pose.transformPoint((glm::dvec3(x, y, z) + 0.5) * double(shape.voxelSize)),
                             glm::mat3_cast(pose.rotation),
                             0.5 * shape.voxelSize,
                             handle,
                             {x, y, z}});
    });
    return scene;
}

/// Distance from a segment to a cube, by ternary search: the distance is convex along the segment.
double segmentDistance(const Cube& cube, glm::dvec3 a, glm::dvec3 b) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double first = low + (high - low) / 3.0, second = high - (high - low) / 3.0;
        if (cube.distance(a + (b - a) * first) < cube.distance(a + (b - a) * second))
            high = second;
        else
            low = first;
    }
    return cube.distance(a + (b - a) * (0.5 * (low + high)));
}

/// Whether two boxes overlap: part of a face of one is left after clipping by the planes of the other, or one contains
/// the other's centre.
bool boxesMeet(const Cube& cube, const QueryShape& box) {
    const glm::dmat3 axes = glm::mat3_cast(box.rotation);
    const auto inBox = [&](glm::dvec3 p) { return glm::transpose(axes) * (p - box.position); };
    const glm::dvec3 middle = glm::abs(inBox(cube.middle));
    if (middle.x <= box.halfSize.x && middle.y <= box.halfSize.y && middle.z <= box.halfSize.z) return true;
    if (cube.distance(box.position) == 0.0) return true;
    for (int face = 0; face < 6; ++face) {
        const int a = face >> 1, b = (a + 1) % 3, c = (a + 2) % 3;
        std::vector<glm::dvec3> polygon;
        for (const auto& [u, v] :
             {std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(1.0, 1.0), std::pair(-1.0, 1.0)})
            polygon.push_back(inBox(cube.middle + cube.half * (cube.axes[a] * (face & 1 ? 1.0 : -1.0) +
                                                               cube.axes[b] * u + cube.axes[c] * v)));
        for (int plane = 0; plane < 6 && !polygon.empty(); ++plane) {
            const double side = plane & 1 ? 1.0 : -1.0;
            const auto inside = [&](glm::dvec3 p) { return box.halfSize[plane >> 1] - side * p[plane >> 1]; };
            std::vector<glm::dvec3> left;
            for (size_t i = 0; i < polygon.size(); ++i) {
                const glm::dvec3 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
                const double dp = inside(p), dq = inside(q);
                if (dp >= 0.0) left.push_back(p);
                if ((dp < 0.0) != (dq < 0.0)) left.push_back(p + (q - p) * (dp / (dp - dq)));
            }
            polygon = left;
        }
        if (!polygon.empty()) return true;
    }
    return false;
}

bool boxMeetsAny(const CubeScene& scene, QueryShape box, glm::dvec3 moved) {
    box.position += moved;
    return std::any_of(scene.cubes.begin(), scene.cubes.end(), [&](const Cube& cube) {
        return glm::length(cube.middle - box.position) < glm::length(box.halfSize) + 2.0 * cube.half &&
               boxesMeet(cube, box);
    });
}

double distanceTo(const Cube& cube, const QueryShape& shape, glm::dvec3 moved) {
    const glm::dvec3 b = shape.kind == QueryShapeKind::Capsule ? shape.end : shape.position;
    return (shape.kind == QueryShapeKind::Sphere ? cube.distance(shape.position + moved)
                                                 : segmentDistance(cube, shape.position + moved, b + moved)) -
           shape.radius;
}

/// The first time of contact, by conservative advancement: steps of the distance to the nearest cube. Infinite: none.
double firstTouch(const CubeScene& scene, const QueryShape& shape, glm::dvec3 direction, double maxDistance,
                  double accuracy) {
    const WorldBox bounds = shape.bounds();
    const glm::dvec3 middle = (bounds.low + bounds.high) * 0.5;
    const double size = glm::length(bounds.high - bounds.low) * 0.5;
    double best = std::numeric_limits<double>::infinity();
    for (const Cube& cube : scene.cubes) {
        const double along = std::clamp(glm::dot(cube.middle - middle, direction), 0.0, maxDistance);
        if (glm::length(cube.middle - middle - direction * along) > size + 2.0 * cube.half) continue;
        for (double t = 0.0; t <= std::min(maxDistance, best);) {
            const double gap = distanceTo(cube, shape, direction * t);
            if (gap < accuracy) {
                best = std::min(best, t);
                break;
            }
            t += gap;
        }
    }
    return best;
}

QueryShape randomShape(Random& random, QueryShapeKind kind, glm::dvec3 position) {
    QueryShape shape{.kind = kind, .position = position};
    shape.end = position + pointIn(random, 0.3);
    shape.radius = between(random, 0.01, 0.25);
    shape.halfSize = glm::abs(pointIn(random, 0.25)) + 0.02;
    shape.rotation = turn(random);
    return shape;
}

TEST(Query, RaysMatchBruteForce) {
    Random random(1);
    int hits = 0;
    for (uint64_t seed = 0; seed < 5; ++seed) {
        const CubeScene scene = randomScene(seed);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec3 origin = pointIn(random, 4.0), direction = glm::normalize(pointIn(random, 1.5) - origin);
            const double maxDistance = between(random, 1.0, 8.0);
            double expected = std::numeric_limits<double>::infinity();
            for (const Cube& cube : scene.cubes) {
                const glm::dvec3 o = glm::transpose(cube.axes) * (origin - cube.middle),
                                 d = glm::transpose(cube.axes) * direction;
                const glm::dvec3 first = (-cube.half - o) / d, second = (cube.half - o) / d;
                const glm::dvec3 low = glm::min(first, second), high = glm::max(first, second);
                const double enter = std::max({low.x, low.y, low.z, 0.0}),
                             leave = std::min({high.x, high.y, high.z, maxDistance});
                if (enter <= leave) expected = std::min(expected, enter);
            }
            const WorldHit hit = castRay(scene.world, {origin, direction * 3.0, maxDistance});
            ASSERT_EQ(hit.hit, std::isfinite(expected)) << seed << " " << i;
            if (!hit.hit) continue;
            ++hits;
            ASSERT_NEAR(hit.distance, expected, 1e-9);
            const auto cube = std::find_if(scene.cubes.begin(), scene.cubes.end(),
                                           [&](const Cube& c) { return c.shape == hit.shape && c.cell == hit.cell; });
            ASSERT_TRUE(cube != scene.cubes.end());
            ASSERT_LT(cube->distance(hit.position), 1e-9);
        }
    }
    EXPECT_GT(hits, 1500);
}

void checkCasts(QueryShapeKind kind, int casts, double accuracy) {
    Random random(uint64_t(kind) + 10);
    int hits = 0;
    for (uint64_t seed = 0; seed < 4; ++seed) {
        const CubeScene scene = randomScene(seed + 20);
        for (int i = 0; i < casts / 4; ++i) {
            const glm::dvec3 from = pointIn(random, i % 10 ? 4.0 : 1.5);
            const QueryShape shape = randomShape(random, kind, from);
            const glm::dvec3 direction = glm::normalize(pointIn(random, 1.5) - from);
            const double maxDistance = between(random, 0.5, 7.0);
            const double expected = firstTouch(scene, shape, direction, maxDistance, accuracy);
            const WorldHit hit = castShape(scene.world, {shape, direction, maxDistance});
            if (hit.hit && hit.distance > maxDistance - 10 * accuracy) continue;
            if (!hit.hit) {  // within the reference's accuracy a near miss may count
                ASSERT_GT(firstTouch(scene, shape, direction, maxDistance - accuracy, 1e-10), maxDistance - 0.05)
                    << seed << " " << i;
                continue;
            }
            ++hits;
            if (std::abs(hit.distance - expected) >
                20 * accuracy) {  // a grazing contact: there must be one there, and none before
                ASSERT_LT(expected, hit.distance) << seed << " " << i;
                ASSERT_GT(firstTouch(scene, shape, direction, hit.distance - 1e-3, -1e-7), hit.distance - 1e-3)
                    << seed << " " << i;
            }
            const auto cube = std::find_if(scene.cubes.begin(), scene.cubes.end(),
                                           [&](const Cube& c) { return c.shape == hit.shape && c.cell == hit.cell; });
            ASSERT_TRUE(cube != scene.cubes.end());
            ASSERT_LT(distanceTo(*cube, shape, direction * hit.distance), 20 * accuracy) << seed << " " << i;
            if (hit.distance > 0.0) {
                ASSERT_NEAR(glm::length(hit.normal), 1.0, 1e-9);
                ASSERT_LE(glm::dot(hit.normal, direction), 1e-9) << "the normal faces the shape";
            }
        }
    }
    EXPECT_GT(hits, casts / 10);
}

TEST(Query, SphereCastsTouchWhereTheReferenceDoes) {
    checkCasts(QueryShapeKind::Sphere, 6000, 1e-8);
}
TEST(Query, CapsuleCastsTouchWhereTheReferenceDoes) {
    checkCasts(QueryShapeKind::Capsule, 2000, 1e-7);
}
/// Places are up to 2e9 m, and voxels may have 1 mm.
TEST(Query, CastsFromAfarHitAsFromNear) {
    VoxelGrid grid({4, 4, 4});
    GridWriter(grid).set({1, 1, 1}, uint8_t(1));
    Level level = oneShapeLevel(std::move(grid), true);
    level.bodies[0].shapes[0].voxelSize = 1e-3f;
    World world;
    world.load(level);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(-1.0, -0.5, 0.25));
    const WorldHit near = castShape(world, {{.position = -direction, .radius = 0.01}, direction, 2.0});
    ASSERT_TRUE(near.hit);
    for (const double distance : {2e4, 9e5}) {
        const WorldHit far = castShape(world, {{.position = -direction * distance, .radius = 0.01}, direction, 1e6});
        ASSERT_TRUE(far.hit) << distance;
        EXPECT_NEAR(far.distance, near.distance + distance - 1.0, 1e-6);
        EXPECT_NEAR(glm::length(far.position - near.position), 0.0, 1e-6);
    }
    EXPECT_FALSE(castShape(world, {{.position = -direction * 9e5, .radius = 0.01}, -direction, 1e6}).hit);
    EXPECT_FALSE(castShape(world, {{.position = -direction * 9e5, .radius = 0.01}, direction, 8e5}).hit);
    const WorldHit large = castShape(world, {{.position = {0.0, 2e4, 0.0}, .radius = 1e4}, {0.0, -1.0, 0.0}, 1e6});
    EXPECT_TRUE(large.hit) << "the largest radius among the smallest voxels";
}

TEST(Query, SpheresThatOverlapWhereTheyStartMeetTheNearestVoxel) {
    Level level = oneShapeLevel(solidGrid({20, 20, 2}, 1), true);
    level.bodies.push_back(oneShapeLevel(solidGrid({2, 20, 20}, 1), true, {{-0.5, 0.0, -2.0}}).bodies[0]);
    World world;
    world.load(level);
    for (const double x : {0.33, 0.71, 1.0, 1.52})
        for (const double sign : {1.0, -1.0}) {
            const WorldHit hit = castRay(world, {{x, 1.03, -0.3}, {0.0, 0.0, sign}, 100.0, 0.9});
            ASSERT_TRUE(hit.hit);
            EXPECT_EQ(hit.distance, 0.0);
            EXPECT_NEAR(glm::length(hit.position - glm::dvec3(x, 1.03, 0.0)), 0.0, 1e-9) << x;
            EXPECT_NEAR(glm::length(hit.normal - glm::dvec3(0.0, 0.0, -1.0)), 0.0, 1e-9) << x;
        }
    const WorldHit inside = castRay(world, {{1.03, 1.03, 0.13}, {1.0, 0.0, 0.0}, 100.0, 0.5});
    EXPECT_EQ(inside.normal, glm::dvec3(-1.0, 0.0, 0.0));
}

TEST(Query, CapsulesThatOverlapWhereTheyStartMeetTheVoxelNearestToTheirAxis) {
    World world;
    world.load(oneShapeLevel(solidGrid({20, 20, 2}, 1), true));
    for (const double sign : {1.0, -1.0})
        for (const double x : {0.33, 0.71, 1.52}) {
            const glm::dvec3 low{x, 1.03, -0.25}, high{x, 1.74, -0.95};
            const WorldHit hit = castShape(
                world,
                {{QueryShapeKind::Capsule, sign > 0 ? low : high, sign > 0 ? high : low, 0.6}, {0.0, 0.0, sign}});
            ASSERT_TRUE(hit.hit && hit.distance == 0.0);
            EXPECT_NEAR(glm::length(hit.position - glm::dvec3(x, 1.03, 0.0)), 0.0, 1e-9) << x;
            EXPECT_NEAR(glm::length(hit.normal - glm::dvec3(0.0, 0.0, -1.0)), 0.0, 1e-9) << x;
        }
    const WorldHit through =
        castShape(world, {{QueryShapeKind::Capsule, {1.0, 1.0, -0.5}, {1.0, 1.0, 0.5}, 0.2}, {1.0, 0.0, 0.0}, 5.0});
    EXPECT_EQ(through.normal, glm::dvec3(-1.0, 0.0, 0.0)) << "its axis is in the voxels";
}

TEST(Query, BoxCastsStopAtTheFirstContact) {
    Random random(6);
    int hits = 0;
    for (uint64_t seed = 0; seed < 4; ++seed) {
        const CubeScene scene = randomScene(seed + 30);
        for (int i = 0; i < 500; ++i) {
            const glm::dvec3 from = pointIn(random, i % 10 ? 4.0 : 1.5);
            const QueryShape box = randomShape(random, QueryShapeKind::Box, from);
            const glm::dvec3 direction = glm::normalize(pointIn(random, 1.5) - from);
            const double maxDistance = between(random, 0.5, 7.0);
            const WorldHit hit = castShape(scene.world, {box, direction, maxDistance});
            const double free = hit.hit ? hit.distance - 1e-6 : maxDistance;
            for (int k = 0; k <= 20 && free > 0.0; ++k)
                ASSERT_FALSE(boxMeetsAny(scene, box, direction * (free * k / 20.0))) << seed << " " << i;
            if (!hit.hit) continue;
            ++hits;
            const auto cube = std::find_if(scene.cubes.begin(), scene.cubes.end(),
                                           [&](const Cube& c) { return c.shape == hit.shape && c.cell == hit.cell; });
            ASSERT_TRUE(cube != scene.cubes.end());
            QueryShape there = box;
            there.position += direction * (hit.distance + 1e-6);
            there.halfSize += 1e-6;
            ASSERT_TRUE(boxesMeet(*cube, there)) << seed << " " << i;
            ASSERT_LE(glm::dot(hit.normal, direction), hit.distance > 0.0 ? 1e-9 : 1.0);
        }
    }
    EXPECT_GT(hits, 200);
}

TEST(Query, OverlapsMatchBruteForce) {
    Random random(3);
    int found = 0, missed = 0;
    for (uint64_t seed = 0; seed < 4; ++seed) {
        const CubeScene scene = randomScene(seed + 40);
        for (int i = 0; i < 150; ++i) {
            const QueryShape shape = randomShape(random, QueryShapeKind(i % 3), pointIn(random, 1.8));
            const std::vector<ShapeHandle> shapes = overlappingShapes(scene.world, shape);
            EXPECT_TRUE(std::is_sorted(shapes.begin(), shapes.end()));
            scene.world.shapes().forEach([&](ShapeHandle handle, const Shape& each) {
                bool expected = false;
                for (const Cube& cube : scene.cubes) {
                    if (cube.shape != handle || expected) continue;
                    expected =
                        shape.kind == QueryShapeKind::Box ? boxesMeet(cube, shape) : distanceTo(cube, shape, {}) <= 0.0;
                }
                const bool overlaps = std::find(shapes.begin(), shapes.end(), handle) != shapes.end();
                ASSERT_EQ(overlaps, expected) << seed << " " << i;
                ASSERT_EQ(overlapsBody(scene.world, each.body, shape), overlaps);
                ++(overlaps ? found : missed);
            });
        }
    }
    EXPECT_GT(found, 50);
    EXPECT_GT(missed, 300);
}

TEST(Query, ClosestPointMatchesBruteForce) {
    Random random(4);
    const CubeScene scene = randomScene(60);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 point = pointIn(random, 3.0);
        double expected = 2.0;
        for (const Cube& cube : scene.cubes) expected = std::min(expected, cube.distance(point));
        const WorldHit hit = closestPoint(scene.world, point, 2.0);
        ASSERT_EQ(hit.hit, expected < 2.0);
        if (!hit.hit) continue;
        ASSERT_NEAR(hit.distance, expected, 1e-9);
        ASSERT_NEAR(glm::length(point - hit.position), expected, 1e-9);
    }
}

TEST(Query, FiltersRejectShapes) {
    Level level = oneShapeLevel(VoxelGrid({1, 1, 1}), true);
    level.bodies.clear();
    for (int i = 0; i < 4; ++i) {
        VoxelGrid grid({4, 4, 4});
        GridWriter(grid).set({1, 1, 1}, uint8_t(1));
        LevelBody body{.name = "body", .pose = {{double(i), 0.0, 0.0}}, .isStatic = i < 2};
        body.shapes.push_back(levelShape("shape", std::move(grid)));
        body.shapes[0].collisionLayer = uint8_t(1 << i);
        if (i == 0) {
            auto palette = std::make_shared<Palette>(*body.shapes[0].palette);
            (*palette)[1].opacity = 100;
            body.shapes[0].palette = palette;
        }
        level.bodies.push_back(std::move(body));
    }
    World world;
    world.load(level);
    std::vector<ShapeHandle> shapes;
    std::vector<BodyHandle> bodies;
    world.shapes().forEach(
        [&](ShapeHandle handle, const Shape& shape) { shapes.push_back(handle), bodies.push_back(shape.body); });
    const auto first = [&](const QueryFilter& filter, double radius) {
        const WorldHit hit = castRay(world, {{-1.0, 0.15, 0.15}, {1.0, 0.0, 0.0}, 10.0, radius}, filter);
        return hit.hit ? int(std::find(shapes.begin(), shapes.end(), hit.shape) - shapes.begin()) : -1;
    };
    for (const double radius : {0.0, 0.03}) {
        EXPECT_EQ(first({}, radius), 0);
        EXPECT_EQ(first({.rejectTransparent = true}, radius), 1);
        EXPECT_EQ(first({.rejectStatic = true}, radius), 2);
        EXPECT_EQ(first({.layerMask = 8}, radius), 3);
        EXPECT_EQ(first({.layerMask = 16}, radius), -1);
        EXPECT_EQ(first({.rejectedBodies = {bodies[0]}, .rejectedShapes = {shapes[1]}}, radius), 2);
        EXPECT_EQ(first({.rejectDynamic = true, .rejectedShapes = {shapes[0], shapes[1]}}, radius), -1);
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(castRay(world, {{nan, 0.0, 0.0}, {1.0, 0.0, 0.0}}).hit);
    EXPECT_FALSE(castRay(world, {{0.0, 0.0, 0.0}, {nan, 0.0, 0.0}, 10.0, 0.1}).hit);
    EXPECT_FALSE(castShape(world, {{.position = {0.0, nan, 0.0}}, {1.0, 0.0, 0.0}}).hit);
    EXPECT_FALSE(closestPoint(world, {nan, 0.0, 0.0}, 10.0).hit);
    EXPECT_TRUE(overlappingShapes(world, {.position = {nan, 0.0, 0.0}}).empty());
    const WorldBox bounds = bodyBounds(world, bodies[2]);
    EXPECT_NEAR(bounds.low.x, 2.1, 1e-6);
    EXPECT_NEAR(bounds.high.x, 2.2, 1e-6);
    EXPECT_EQ(bodiesInBox(world, {{0.9, 0.0, 0.0}, {2.1, 0.1, 0.1}}), (std::vector<BodyHandle>{bodies[1], bodies[2]}));
}

TEST(Query, BatchesMatchSingleQueriesOnAnyThreadCount) {
    const CubeScene scene = randomScene(80);
    Random random(5);
    std::vector<RayQuery> rays;
    for (int i = 0; i < 1500; ++i) {
        const glm::dvec3 origin = pointIn(random, 4.0);
        rays.push_back({origin, pointIn(random, 1.0) - origin, 10.0, i % 2 ? 0.05 : 0.0});
    }
    const auto threads = [](size_t count, const std::function<void(size_t)>& body) {
        std::vector<std::thread> running;
        for (size_t first = 0; first < 3; ++first)
            running.emplace_back([=, &body] {
                for (size_t i = first; i < count; i += 3) body(i);
            });
        for (std::thread& thread : running) thread.join();
    };
    std::vector<WorldHit> serial(rays.size()), parallel(rays.size());
    castRays(scene.world, rays, hitsInto(serial));
    castRays(scene.world, rays, hitsInto(parallel), {}, threads);
    for (size_t i = 0; i < rays.size(); ++i) {
        const WorldHit one = castRay(scene.world, rays[i]);
        for (const WorldHit* hit : {&serial[i], &parallel[i]}) {
            ASSERT_EQ(hit->hit, one.hit);
            ASSERT_EQ(hit->distance, one.distance);
            ASSERT_EQ(hit->shape, one.shape);
            ASSERT_EQ(hit->cell, one.cell);
        }
    }
}

/// In a batch a ray is answered from what all of them share; alone, or among too few, it is not. Very many are answered
/// in another order.
TEST(Query, BatchesOfAnySizeMatchSingleQueriesWithFilters) {
    const CubeScene scene = randomScene(120);
    Random random(6);
    std::vector<RayQuery> rays;
    for (int i = 0; i < 1300; ++i) {
        const glm::dvec3 origin = pointIn(random, i % 5 ? 4.0 : 1e5);
        RayQuery ray{origin, pointIn(random, 1.0) - origin, i % 5 ? 10.0 : 1e6};
        if (i % 7 == 0) ray.direction = glm::dvec3(0.0), ray.direction[i % 3] = i % 2 ? 1.0 : -1.0;
        if (i % 97 == 0) ray.direction = glm::dvec3(0.0);
        if (i % 211 == 0) ray.origin.y = i % 2 ? std::numeric_limits<double>::quiet_NaN() : 1e300;
        rays.push_back(ray);
    }
    const std::vector<QueryFilter> filters = {
        {}, {.rejectTransparent = true, .rejectUnphysical = true}, {.layerMask = 1, .rejectStatic = true}};
    for (const QueryFilter& filter : filters)
        for (const size_t count : {size_t(3), size_t(600), rays.size()}) {
            std::vector<WorldHit> hits(count);
            castRays(scene.world, std::span(rays).first(count), hitsInto(hits), filter);
            for (size_t i = 0; i < count; ++i) {
                const WorldHit one = castRay(scene.world, rays[i], filter);
                ASSERT_EQ(hits[i].hit, one.hit) << i;
                ASSERT_EQ(hits[i].distance, one.distance) << i;
                ASSERT_EQ(hits[i].position, one.position) << i;
                ASSERT_EQ(hits[i].normal, one.normal) << i;
                ASSERT_EQ(hits[i].shape, one.shape) << i;
                ASSERT_EQ(hits[i].cell, one.cell) << i;
                ASSERT_EQ(hits[i].entry, one.entry) << i;
            }
        }
}

}  // namespace
}  // namespace rubble
