#include "render/scene/body_tiles.h"

#include "render/frame/frame_camera.h"
#include "render/scene/scene.h"
#include "runtime/core/random.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/test_scene.h"

namespace rubble {
namespace {

/// Bodies of 0.8 m on a square of the ground, 3 m apart, and a jittered camera.
class BodyTilesTest : public GlTest {
protected:
    void addBodies(int count) {
        cube = VoxelGrid(glm::ivec3(8));
        GridWriter writer(cube);
        fillBox(writer, glm::ivec3(0), glm::ivec3(8), 1);
        writer.flush();
        TestScene made;
        for (int i = 0, across = int(std::sqrt(count)); i < count; ++i)
            bodies.push_back(
                made.add(cube, {{i % across * 3.0, 0.0, i / across * 3.0}, glm::dquat(1, 0, 0, 0)}, palette));
        scene.apply(made.take());
        view.size = {320, 180};
    }
    void move(ShapeHandle body, glm::dvec3 to) {
        const Pose pose{to, glm::dquat(1, 0, 0, 0)};
        FrameSnapshot moved;
        moved.poses.push_back({body, pose, pose});
        scene.apply(std::move(moved));
    }
    void lookAcross() {
        view.position = {-10.0, 30.0, -10.0};
        view.rotation = glm::dquat(glm::dvec3(0, -2.35, 0)) * glm::dquat(glm::dvec3(-0.3, 0, 0));
    }
    void drawTo(BodyTiles& tiles) {
        scene.beginFrame(1.0f, view.position, false, view.hidden);
        camera.begin(view, view.size, true, scene.origin(), block);
        tiles.update(scene.bodies(), block);
    }
    VoxelGrid cube;
    PaletteRef palette = testPalette();
    std::vector<ShapeHandle> bodies;
    Scene scene;
    View view;
    FrameCamera camera;
    FrameBlock block{};
};

TEST_F(BodyTilesTest, OneBodyThatMovesAmongManyAtRestIsTheOnlyOneProjected) {
    addBodies(20000);
    lookAcross();
    BodyTiles tiles;
    for (int i = 0; i < 3; ++i) drawTo(tiles);
    EXPECT_GT(tiles.order().size(), 19000u);
    const uint64_t projected = tiles.projected(), compared = tiles.compared();
    for (int i = 0; i < 10; ++i) {
        move(bodies[10100], {200.0, 0.1 * i, 200.0});
        drawTo(tiles);
    }
    EXPECT_EQ(tiles.projected() - projected, 10u);
    EXPECT_EQ(tiles.compared() - compared, 10u);
}

TEST_F(BodyTilesTest, BodiesOutOfViewCostNothing) {
    addBodies(20000);
    view.position = {213.0, 2.0, 213.0};
    view.rotation = glm::dquat(glm::dvec3(-1.5, 0, 0));
    BodyTiles tiles;
    drawTo(tiles);
    EXPECT_LE(tiles.projected(), 10u);
    EXPECT_LE(tiles.compared(), 200u) << "of the tree of bounds";
}

TEST_F(BodyTilesTest, HiddenBodiesAreLeftOutAndOnlyTheyAreProjectedAgain) {
    addBodies(2500);
    lookAcross();
    BodyTiles tiles;
    for (int i = 0; i < 3; ++i) drawTo(tiles);
    const size_t all = tiles.order().size();
    ASSERT_GT(all, 2000u);
    uint64_t projected = tiles.projected();
    view.hidden = {bodies[1300], bodies[1210]};
    for (int i = 0; i < 5; ++i) drawTo(tiles);
    EXPECT_EQ(tiles.order().size(), all - 2);
    EXPECT_EQ(tiles.projected(), projected);
    move(bodies[1300], {60.0, 1.0, 60.0});
    for (int i = 0; i < 3; ++i) drawTo(tiles);
    EXPECT_EQ(tiles.order().size(), all - 2) << "it moves unseen";
    projected = tiles.projected();
    view.hidden.clear();
    for (int i = 0; i < 5; ++i) drawTo(tiles);
    EXPECT_EQ(tiles.order().size(), all);
    EXPECT_EQ(tiles.projected() - projected, 2u);
}

TEST_F(BodyTilesTest, ListsThatWereKeptAreThoseOfAFreshStart) {
    addBodies(300);
    lookAcross();
    view.position.y = 10.0;
    BodyTiles kept;
    Random random(3);
    auto glass = std::make_shared<Palette>(*testPalette());
    (*glass)[1].opacity = 100;
    for (int round = 0; round < 60; ++round) {
        const auto any = [&] { return bodies[random.below(uint32_t(bodies.size()))]; };
        for (int i = 0; i < 5; ++i) move(any(), glm::dvec3(random.unit(), 0.3 * random.unit(), random.unit()) * 30.0);
        FrameSnapshot change;
        if (round % 3 == 0) change.destroyed.push_back(any());
        if (round % 4 == 0) change.palettes.push_back({any(), round % 8 ? palette : PaletteRef(glass), nullptr});
        if (round % 5 == 0) change.bricks.push_back({any(), {0, 0, 0}, nullptr});
        scene.apply(std::move(change));
        if (round % 20 == 19) view.position.x += 1.0;
        if (round % 6 == 0) view.hidden = {any(), any(), any()};
        drawTo(kept);
        BodyTiles fresh;
        fresh.update(scene.bodies(), block);
        ASSERT_EQ(kept.order(), fresh.order());
        for (const auto which : {BodyTiles::Which::All, BodyTiles::Which::Glass})
            for (int y = 0; y < view.size.y; y += 8)
                for (int x = 0; x < view.size.x; x += 8)
                    ASSERT_EQ(kept.bodiesAt({x, y}, which), fresh.bodiesAt({x, y}, which)) << x << " " << y;
    }
}

class BodyBoundsTest : public GlTest {};

TEST_F(BodyBoundsTest, FollowTheBricksThatExist) {
    VoxelGrid grid(glm::ivec3(100, 70, 40));
    GridWriter writer(grid);
    fillBox(writer, glm::ivec3(0), grid.size(), 1);
    writer.flush();
    TestScene made;
    const ShapeHandle shape = made.add(grid, {}, testPalette());
    Bodies bodies;
    const FrameSnapshot snapshot = made.take();
    bodies.create(snapshot.created[0]);
    std::vector<BrickChange> left = snapshot.created[0].bricks;
    Random random(9);
    while (!left.empty()) {
        const size_t i = random.below(uint32_t(left.size()));
        bodies.setBrick({shape, left[i].brick, nullptr});
        left.erase(left.begin() + std::ptrdiff_t(i));
        glm::ivec3 low(1 << 20), high(0);
        for (const BrickChange& brick : left) {
            low = glm::min(low, brick.brick * kBrickSize);
            high = glm::max(high, glm::min((brick.brick + 1) * kBrickSize, grid.size()));
        }
        bodies.beginFrame(1.0f, {});
        const Bodies::Instance& body = bodies.instances()[shape.slot()];
        ASSERT_EQ(body.empty(), left.empty());
        if (left.empty()) break;
        ASSERT_EQ(body.low, low);
        ASSERT_EQ(body.high, high);
    }
}

}  // namespace
}  // namespace rubble
