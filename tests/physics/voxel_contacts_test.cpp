#include "physics/collision/voxel_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "physics/collision/broadphase.h"
#include "physics/collision/occupancy.h"
#include "runtime/core/random.h"
#include "tests/physics/baseline/voronoi_pit.h"
#include "tests/physics/physics_scene.h"
#include "tests/support/grids.h"

namespace rubble {
namespace {

double between(Random& random, double low, double high) {
    return low + (high - low) * random.unit();
}

glm::dvec3 anyVectorIn(Random& random, double size) {
    glm::dvec3 v;
    for (int k = 0; k < 3; ++k) v[k] = between(random, -size, size);
    return v;
}

void put(CollisionObject& object, const LevelBody& body, const MaterialTable& materials, const Pose& at) {
    Shape shape;
    shape.grid = body.shapes[0].grid;
    shape.palette = body.shapes[0].palette;
    shape.voxelSize = body.shapes[0].voxelSize;
    object.collider.parts.push_back(std::make_unique<ColliderPart>(shape, Pose{}, materials));
    object.radius = object.collider.radius();
    object.setPose(at);
}

/// The corners of all solid cells of a part.
std::vector<glm::vec3> cornersOf(const ColliderPart& part) {
    std::vector<glm::vec3> corners;
    part.grid().forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int v) {
            for (int i = 0; i < 8; ++i)
                corners.push_back(
                    glm::vec3(position * kBrickSize + voxelInBrick(v) + glm::ivec3(i & 1, i >> 1 & 1, i >> 2)));
        });
    });
    return corners;
}

TEST(VoxelContacts, HullAndVoxelsHaveTheSameExtent) {
    const Level level = voronoiPit(30);
    Random random(7);
    for (size_t i = 1; i < level.bodies.size(); ++i) {
        CollisionObject object;
        put(object, level.bodies[i], level.materials, {});
        const ColliderPart& part = *object.collider.parts[0];
        const std::vector<glm::vec3> corners = cornersOf(part);
        ASSERT_LT(part.hull().size() * 20, corners.size());
        for (int k = 0; k < 50; ++k) {
            const glm::vec3 direction = glm::vec3(anyVectorIn(random, 1.0));
            float support = -1e9f;
            for (const glm::vec3& c : corners)
                support = std::max(support, c.x * direction.x + c.y * direction.y + c.z * direction.z);
            ASSERT_EQ(part.hull().support(direction), support);
            const glm::vec3 far = part.hull().supportPoint(direction, support);
            ASSERT_EQ(far.x * direction.x + far.y * direction.y + far.z * direction.z, support);
        }
    }
}

/// Compares with a search cell by cell.
TEST(VoxelContacts, FeaturesAreTheConvexCornersAndEdges) {
    const Level level = voronoiPit(8);
    for (size_t i = 1; i < level.bodies.size(); ++i) {
        CollisionObject object;
        put(object, level.bodies[i], level.materials, {});
        const ColliderPart& part = *object.collider.parts[0];
        std::vector<std::array<int, 4>> found, expected;
        const FeatureList& list = part.whole()->features();
        for (const FeatureList::Pack& pack : list.packs)
            for (size_t k = 0; k < 4 && pack.kind[k] != FeatureList::kNoFeature; ++k) {
                const glm::ivec3 cell = FeatureList::cellOf(pack, k);
                found.push_back({cell.x, cell.y, cell.z, pack.kind[k]});
            }
        const CellBox box = part.bounds();
        for (int z = box.low.z; z < box.high.z; ++z)
            for (int y = box.low.y; y < box.high.y; ++y)
                for (int x = box.low.x; x < box.high.x; ++x)
                    for (int kind = 0; kind < kFeatureKinds && part.grid().at({x, y, z}); ++kind) {
                        const glm::ivec3 out(featureKinds()[size_t(kind)].outward);
                        bool convex = true;
                        for (int side = 1; side < 8; ++side) {
                            const glm::ivec3 d(side & 1 ? out.x : 0, side & 2 ? out.y : 0, side & 4 ? out.z : 0);
                            convex = convex && (d == glm::ivec3(0) || !part.grid().at(glm::ivec3(x, y, z) + d));
                        }
                        if (convex) expected.push_back({x - box.low.x, y - box.low.y, z - box.low.z, kind});
                    }
        std::sort(found.begin(), found.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(found, expected);
        EXPECT_EQ(list.count, expected.size());
    }
}

/// The part of a grid with the default palette and materials.
std::unique_ptr<ColliderPart> partOf(const VoxelGrid& grid) {
    Shape shape;
    shape.palette = materialPalette();
    shape.grid = grid;
    return std::make_unique<ColliderPart>(shape, Pose{}, defaultMaterials());
}

/// In a small part, where the answer is exact, and in a large one, where a box may count as solid that is not.
TEST(VoxelContacts, FourBoxesOfCellsAreLookedUpAsEachIs) {
    for (const int size : {20, 48}) {
        Random random{uint64_t(size)};
        const auto part = partOf(
            gridOf(glm::ivec3(size), [&](glm::ivec3) { return random.unit() < 0.01f ? uint8_t(1) : uint8_t(0); }));
        Occupancy occupancy(*part);
        int hits = 0, misses = 0;
        for (int round = 0; round < 3000; ++round) {
            std::array<Int4, 3> low, high;
            for (size_t axis = 0; axis < 3; ++axis)
                for (int i = 0; i < 4; ++i) {
                    low[axis][i] = int(between(random, -6.0, size + 6.0));
                    high[axis][i] = low[axis][i] + int(between(random, 0.0, 4.0));
                }
            const uint32_t lanes = uint32_t(random.next() & 15), found = occupancy.mayContainSolid(low, high, lanes);
            EXPECT_EQ(found & ~lanes, 0u);
            for (int i = 0; i < 4; ++i) {
                if (!(lanes >> i & 1)) continue;
                const Int4 from{low[0][i], low[1][i], low[2][i], 0}, to{high[0][i], high[1][i], high[2][i], 0};
                bool isSolid = false;
                for (int z = from[2]; z <= to[2]; ++z)
                    for (int y = from[1]; y <= to[1]; ++y)
                        for (int x = from[0]; x <= to[0]; ++x) isSolid = isSolid || part->grid().at({x, y, z});
                const bool isFound = found >> i & 1;
                ++(isFound ? hits : misses);
                EXPECT_EQ(isFound, occupancy.mayContainSolid(from, to));
                if (isSolid || size == 20) {
                    EXPECT_EQ(isFound, isSolid);
                }
                EXPECT_TRUE(!isSolid || occupancy.mayContainBrick(from, to));
            }
        }
        EXPECT_GT(hits, 100);
        EXPECT_GT(misses, 100);
    }
}

TEST(VoxelContacts, PartsKnowTheEntryOfEachVoxel) {
    for (const int entries : {1, 2}) {
        const VoxelGrid grid =
            gridOf({12, 9, 10}, [&](glm::ivec3 c) { return uint8_t((c.x + c.y) % 3 ? 3 + c.z / 3 % entries : 0); });
        const auto part = partOf(grid);
        EXPECT_EQ(part->whole()->entry, entries == 1 ? 3 : 0);
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int v) {
                const glm::ivec3 cell = position * kBrickSize + voxelInBrick(v);
                ASSERT_EQ(part->entryAt(cell), grid.at(cell));
            });
        });
    }
}

/// The contact of a stuck pair acts along the mean normal of its other contacts, or there is none. It has no friction.
TEST(VoxelContacts, TheStuckContactOpposesNoOtherContact) {
    const Level level = voronoiPit(40);
    Random random(5);
    int pushes = 0;
    for (int round = 0; round < 600; ++round) {
        CollisionObject a, b;
        put(a, level.bodies[1 + size_t(round % 40)], level.materials,
            {anyVectorIn(random, 0.3), glm::normalize(glm::dquat(0.5, anyVectorIn(random, 1.0)))});
        put(b, level.bodies[1 + size_t(round * 7 % 40)], level.materials,
            {{}, glm::normalize(glm::dquat(0.5, anyVectorIn(random, 1.0)))});
        std::vector<ContactPoint> found;
        ContactSearch search;
        findContacts(a.collider, {a.pose, a.cellTransforms()}, b.collider, {b.pose, b.cellTransforms()}, {}, search,
                     found);
        if (found.size() < 2 || found.back().friction != 0.0f) continue;
        ++pushes;
        glm::vec3 others(0.0f);
        for (size_t i = 0; i + 1 < found.size(); ++i) others += found[i].normal;
        EXPECT_GT(glm::dot(others, found.back().normal), 0.5f * float(found.size() - 1)) << round;
    }
    EXPECT_GT(pushes, 10);
}

/// Whatever axis the search for a separation begins with, it drops no contact.
TEST(VoxelContacts, DoNotDependOnTheInitialSeparatingAxis) {
    const Level level = voronoiPit(40);
    Random random(3);
    size_t touching = 0;
    for (int round = 0; round < 600; ++round) {
        CollisionObject a, b;
        const bool againstPit = round % 5 == 0;
        const glm::dvec3 apart = againstPit ? glm::dvec3(0.5) : anyVectorIn(random, 0.7);
        put(a, level.bodies[1 + size_t(round % 40)], level.materials,
            {apart, glm::normalize(glm::dquat(0.5, anyVectorIn(random, 1.0)))});
        put(b, level.bodies[againstPit ? 0 : 1 + size_t(round * 7 % 40)], level.materials,
            againstPit ? level.bodies[0].pose
                       : Pose{{0.2, 0.1, 0}, glm::normalize(glm::dquat(0.5, anyVectorIn(random, 1.0)))});
        const double speed = std::array{0.0, 1.0, 30.0}[size_t(round % 3)];
        const auto motionOf = [&](const CollisionObject& object) {
            return Motion{object.pose, object.cellTransforms(), anyVectorIn(random, speed), anyVectorIn(random, speed),
                          object.radius};
        };
        const Motion motionA = motionOf(a), motionB = againstPit ? Motion{b.pose, b.cellTransforms()} : motionOf(b);
        std::vector<ContactPoint> first, again;
        for (int k = 0; k < 8; ++k) {
            ContactSearch search;
            if (k) search.axis = glm::normalize(glm::vec3(anyVectorIn(random, 1.0)));
            std::vector<ContactPoint>& found = k ? again : first;
            found.clear();
            findContacts(a.collider, motionA, b.collider, motionB, {}, search, found);
            ASSERT_EQ(found.size(), first.size()) << round;
            for (size_t i = 0; i < found.size(); ++i)
                ASSERT_TRUE(found[i].feature == first[i].feature && found[i].separation == first[i].separation &&
                            found[i].position == first[i].position);
        }
        touching += !first.empty();
    }
    EXPECT_GT(touching, 100u);
}

/// Two that are apart have no contacts until points of them have moved against each other by their clearance.
TEST(VoxelContacts, NothingTouchesWithinTheClearance) {
    const Level pieces = voronoiPit(40), boxes = boxPit(40);
    Random random(11);
    int apart = 0;
    for (int round = 0; round < 3000; ++round) {
        const Level& level = round % 2 ? pieces : boxes;
        const auto anyPose = [&](double size) {
            return Pose{anyVectorIn(random, size), glm::normalize(glm::dquat(0.5, anyVectorIn(random, 1.0)))};
        };
        CollisionObject a, b;
        put(a, level.bodies[1 + size_t(round % 40)], level.materials, anyPose(1.0));
        put(b, level.bodies[1 + size_t(round * 7 % 40)], level.materials, anyPose(0.0));
        ContactSearch search;
        std::vector<ContactPoint> found;
        const auto touch = [&] {
            return findContacts(a.collider, {a.pose, a.cellTransforms(), {}, {}, a.radius}, b.collider,
                                {b.pose, b.cellTransforms(), {}, {}, b.radius}, {}, search, found);
        };
        if (touch()) {
            EXPECT_EQ(search.clearance, 0.0f) << round;
            continue;
        }
        ++apart;
        ASSERT_GT(search.clearance, 0.0f) << round;
        const double clearance = 0.999 * double(search.clearance), turn = random.unit() * clearance;
        const glm::dquat rotation = glm::angleAxis(turn / a.radius, glm::normalize(anyVectorIn(random, 1.0)));
        a.setPose({a.pose.position - glm::dvec3(search.axis) * (clearance - turn), rotation * a.pose.rotation});
        touch();
        EXPECT_TRUE(found.empty()) << round;
    }
    EXPECT_GT(apart, 500);
}

/// A plate of 200 x 200 voxels with bumps on both sides.
LevelBody roughPlate(uint64_t seed) {
    constexpr int kSide = 200;
    LevelBody body = voronoiPit(1).bodies[1];
    VoxelGrid grid({kSide, 3, kSide});
    {
        GridWriter writer(grid);
        Random random(seed);
        for (int z = 0; z < kSide; ++z)
            for (int x = 0; x < kSide; ++x) {
                writer.set({x, 1, z}, 7);
                for (const int y : {0, 2})
                    if (random.below(3) == 0) writer.set({x, y, z}, 7);
            }
    }
    body.shapes[0].grid = std::move(grid);
    return body;
}

TEST(VoxelContacts, WhatIsInsideOfAHollowPartHasAClearanceInWhichNothingTouches) {
    const Level level = voronoiPit(20);  // in a pit of 8 m
    Random random(13);
    CollisionObject pit;
    put(pit, level.bodies[0], level.materials, level.bodies[0].pose);
    int clear = 0;
    for (int round = 0; round < 500; ++round) {
        CollisionObject piece;
        const glm::dvec3 at = glm::dvec3(4.0) + anyVectorIn(random, 4.0);
        put(piece, level.bodies[1 + size_t(round % 20)], level.materials,
            {at, glm::normalize(glm::dquat(0.5, anyVectorIn(random, 1.0)))});
        ContactSearch search;
        std::vector<ContactPoint> found;
        const auto touch = [&] {
            return findContacts(piece.collider, {piece.pose, piece.cellTransforms(), {}, {}, piece.radius},
                                pit.collider, {pit.pose, pit.cellTransforms()}, {}, search, found);
        };
        if (touch()) continue;
        ++clear;
        EXPECT_GT(search.clearance, 0.3f) << round;
        const double clearance = double(search.clearance);
        for (int k = 0; k < 6; ++k) {
            glm::dvec3 way(0.0);
            way[k / 2] = k % 2 ? clearance : -clearance;
            piece.setPose({at + 0.99 * way, piece.pose.rotation});
            touch();
            EXPECT_TRUE(found.empty()) << round << ", " << k;
        }
    }
    EXPECT_GT(clear, 50);
}

TEST(VoxelContacts, ARoughPlateIsSearchedUntilThereAreEnoughContactsAllOverIt) {
    const MaterialTable materials = voronoiPit(1).materials;
    CollisionObject low, high;
    put(low, roughPlate(1), materials, {});
    put(high, roughPlate(2), materials, {{0.03, 0.295, 0.03}, {1, 0, 0, 0}});
    const auto motionOf = [](const CollisionObject& object) {
        return Motion{.pose = object.pose, .cellTransforms = object.cellTransforms(), .radius = object.radius};
    };
    ContactSearch search;
    std::vector<ContactPoint> contacts;
    ASSERT_TRUE(findContacts(high.collider, motionOf(high), low.collider, motionOf(low), {}, search, contacts));
    EXPECT_GT(contacts.size(), 1000u);
    EXPECT_LT(contacts.size(), 4000u) << "of tens of thousands";
    int quadrants[2][2] = {};
    for (const ContactPoint& contact : contacts) ++quadrants[contact.position.x > 10.0f][contact.position.z > 10.0f];
    for (const auto& row : quadrants)
        for (const int count : row) EXPECT_GT(count, int(contacts.size() / 8));
}

/// A ribbed plate is above a floor and touches only the one voxel that sticks out of it.
TEST(VoxelContacts, ALargeSurfaceIsSearchedInTurnsSoThatALoneBumpIsFoundAndWhatIsLeftOutIsNamed) {
    constexpr int kSide = 400;
    constexpr size_t kBricks = kSide / kBrickSize * kSide / kBrickSize;
    static_assert(kBricks > 2 * kMaxSearchedBricks);
    const MaterialTable materials = voronoiPit(1).materials;
    LevelBody floorBody = voronoiPit(1).bodies[1], plateBody = floorBody;
    floorBody.shapes[0].grid = gridOf({kSide, 2, kSide}, [](glm::ivec3 cell) {
        return cell.y == 0 || cell == glm::ivec3(200, 1, 203) ? uint8_t(7) : uint8_t(0);
    });
    plateBody.shapes[0].grid = gridOf(
        {kSide, 2, kSide}, [](glm::ivec3 cell) { return cell.y == 1 || cell.x % 4 == 0 ? uint8_t(7) : uint8_t(0); });
    CollisionObject floor, plate;
    put(floor, floorBody, materials, {});
    const auto motionOf = [](const CollisionObject& object) {
        return Motion{.pose = object.pose, .cellTransforms = object.cellTransforms(), .radius = object.radius};
    };
    put(plate, plateBody, materials, {{0.0, 0.195, 0.0}, {1, 0, 0, 0}});  // 5 mm in the bump, 95 mm above the floor
    ContactSearch search;
    size_t searches = 0, found = 0;
    for (; searches < 2 * kBricks / kMaxSearchedBricks && !found; ++searches) {
        std::vector<ContactPoint> contacts;
        ASSERT_TRUE(
            findContacts(plate.collider, motionOf(plate), floor.collider, motionOf(floor), {}, search, contacts));
        found = contacts.size();
        EXPECT_GT(search.leftOut, 0u) << "named, not hidden";
    }
    EXPECT_GT(found, 0u) << "after " << searches << " searches";
}

}  // namespace
}  // namespace rubble
