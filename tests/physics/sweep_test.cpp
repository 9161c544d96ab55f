#include <gtest/gtest.h>

#include "physics/collision/feature_query.h"
#include "tests/physics/physics_scene.h"

namespace rubble {
namespace {

/// A corner that sticks out everywhere: every face is accepted.
FeatureQuery anyCorner(const glm::vec3& point) {
    FeatureQuery query{};
    query.kind = &featureKinds()[0];
    query.point = point;
    return query;
}

/// The first solid cell on a line, by walking it in small steps; nothing found: a cell outside.
Cell firstSolidCell(Occupancy& occupancy, const glm::vec3& from, const glm::vec3& displacement) {
    const int steps = int(glm::length(displacement) * 50.0f);
    for (int i = 0; i <= steps; ++i) {
        const glm::vec3 at = from + displacement * (float(i) / float(steps));
        if (occupancy.solid(cellOf(at))) return cellOf(at);
    }
    return Cell(-1);
}

TEST(Sweep, LongOnesMeetTheFaceThatShortStepsMeet) {
    PhysicsScene scene;
    scene.add(gridOf({12, 12, 12}, [](glm::ivec3 c) { return uint8_t((c.x + c.y * 3 + c.z * 5) % 4 == 0 ? 7 : 0); }),
              {0, 0, 0}, true);
    scene.load();
    const ColliderPart part(scene.world.shapes().at(scene.world.shapes().handleAt(0)), Pose{}, scene.world.materials());
    Occupancy occupancy(part);
    Random random(4);
    int hits = 0, misses = 0;
    for (int i = 0; i < 400; ++i) {
        const float a = random.unit(), b = random.unit(), c = random.unit(), far = random.unit();
        const glm::vec3 direction = glm::normalize(glm::vec3(a - 0.5f, b - 0.5f, c - 0.5f));
        const glm::vec3 middle(1.0f + 10.0f * b, 1.0f + 10.0f * c, 1.0f + 10.0f * a);
        const glm::vec3 from = middle - direction * (20.0f + 400.0f * far), displacement = direction * 300.0f;
        const Cell expected = firstSolidCell(occupancy, from, displacement);
        const Face face = sweepToFace(occupancy, cellOf(from), from, displacement, anyCorner(from));
        if (expected == Cell(-1)) {
            misses += face.axis < 0;
            continue;
        }
        hits += face.axis >= 0 && occupancy.solid(face.cell) &&
                glm::length(glm::vec3(face.cell - expected)) < 2.0f;  // short steps may jump over the corner of a cell
    }
    EXPECT_GT(hits, 200);
    EXPECT_GE(hits + misses, 396);
}

TEST(Sweep, EndsAtOnceWhereNothingIsAheadAndLeapsOverALongWayThere) {
    PhysicsScene scene;
    scene.add(solidGrid({4, 4, 4}, 7), {0, 0, 0}, true);
    scene.load();
    const ColliderPart part(scene.world.shapes().at(scene.world.shapes().handleAt(0)), Pose{}, scene.world.materials());
    Occupancy occupancy(part);
    for (const float away : {1e3f, 1e5f, 1e7f}) {  // walked cell by cell, 400 of the last take minutes
        for (int i = 0; i < 400; ++i) {
            const glm::vec3 from(2.2f, 9.5f, 2.3f);
            EXPECT_LT(sweepToFace(occupancy, cellOf(from), from, {0.01f, away, 0.02f}, anyCorner(from)).axis, 0);
            EXPECT_EQ(sweepToFace(occupancy, cellOf(from), from, {0.0f, -away, 0.0f}, anyCorner(from)).axis, 1);
        }
        const glm::vec3 far(2.2f, 0.9f * away, 2.3f);
        const Face face = sweepToFace(occupancy, cellOf(far), far, {0.0f, -away, 0.0f}, anyCorner(far));
        EXPECT_EQ(face.cell, Cell(2, 3, 2));
    }
}

}  // namespace
}  // namespace rubble
