#include "render/scene/body_grid.h"

#include <algorithm>

#include "runtime/core/random.h"
#include "tests/render/gl_fixture.h"

namespace rubble {
namespace {

class BodyGridTest : public GlTest {};

Bodies::Instance anyBody(Random& random) {
    Bodies::Instance body;
    for (int a = 0; a < 3; ++a) {
        body.low[a] = 8 * random.between(0, 2);
        body.high[a] = body.low[a] + random.between(1, random.below(4) ? 20 : 1500);
        body.position[a] = float(random.unit() * 400.0 - 200.0);
    }
    for (int i = 0; i < 4; ++i) body.rotation[i] = float(random.unit() - 0.5);
    body.rotation = glm::normalize(body.rotation);
    return body;
}

glm::vec3 pointIn(const Bodies::Instance& body, Random& random) {
    glm::vec3 cell(0.0f);
    for (int a = 0; a < 3; ++a) cell[a] = float(body.low[a]) + float(random.unit()) * float(body.high[a] - body.low[a]);
    return body.position + body.rotation * (cell * body.voxelSize);
}

bool lists(const BodyGrid& grid, glm::vec3 point, uint32_t slot) {
    const auto bodies = grid.bodiesAt(point);
    return std::find(bodies.begin(), bodies.end(), slot) != bodies.end();
}

TEST_F(BodyGridTest, ListsMovedBodiesAndForgetsRemovedOnes) {
    Random random(11);
    BodyGrid grid;
    std::vector<Bodies::Instance> bodies(300);
    for (int round = 0; round < 6; ++round) {
        for (uint32_t slot = 0; slot < bodies.size(); ++slot) {
            const uint32_t what = round == 0 ? 0 : random.below(4);
            if (what < 2) bodies[slot] = anyBody(random);
            if (what == 2) bodies[slot] = {};
            grid.put(slot, bodies[slot]);
        }
        for (uint32_t slot = 0; slot < bodies.size(); ++slot)
            for (int i = 0; i < 20 && !bodies[slot].empty(); ++i)
                ASSERT_TRUE(lists(grid, pointIn(bodies[slot], random), slot)) << slot;
    }
    for (uint32_t slot = 0; slot < bodies.size(); ++slot) grid.put(slot, {});
    EXPECT_EQ(grid.entries(), 0u);
    EXPECT_TRUE(grid.bodiesAt({1.0f, 2.0f, 3.0f}).empty());
}

TEST_F(BodyGridTest, EntriesPerBodyAreBounded) {
    for (const int side : {1, 10, 100, 1000, 10000, 20000}) {
        BodyGrid grid;
        Bodies::Instance body;
        body.high = glm::ivec3(side);
        grid.put(0, body);
        EXPECT_LE(grid.entries(), 125u) << side;
    }
}

TEST_F(BodyGridTest, UploadsNothingForSmallMoves) {
    Random random(12);
    BodyGrid grid;
    Bodies::Instance body;
    body.high = glm::ivec3(8);
    body.position = glm::vec3(0.1f);
    grid.put(0, body);
    EXPECT_GT(grid.upload(), 0u);
    body.position += 0.05f;
    grid.put(0, body);
    EXPECT_EQ(grid.upload(), 0u);
}

}  // namespace
}  // namespace rubble
