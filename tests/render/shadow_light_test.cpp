// Sunlight by rays through the worker's own volume: a body does not shadow itself, a closed room lets nothing in.
#include <cmath>

#include "render/gl/framebuffer.h"
#include "samples/scenes/town.h"
#include "tests/render/gbuffer_fixture.h"
#include "tests/support/level_snapshot.h"

namespace rubble {
namespace {

class ShadowLightTest : public GBufferTest {
protected:
    struct Count {
        int facing = 0, lit = 0;
    };
    /// Pixels that face the sun, and those of them that the sun's rays reach.
    Count sunlit(Scene& scene, const View& view, glm::vec3 toSun) {
        draw(scene, view);
        block.sunDirection = glm::vec4(toSun, 0.0f);
        glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
        const Program& program = shaders->load("../tests/render/shaders/sunlit.frag");
        EXPECT_TRUE(program) << shaders->errors().front();
        const Texture out(GL_RGBA32F, targets.at(Target::Depth).size());
        const Framebuffer framebuffer({&out});
        framebuffer.begin();
        program.use();
        GBufferPass::bind(program, targets);
        scene.bindShadow(program);
        context(scene).drawTriangle();
        Count count;
        for (const glm::vec4& pixel : read(out)) {
            count.facing += pixel.x > 0.0f;
            count.lit += pixel.y > 0.0f;
        }
        return count;
    }
    static LevelBody bodyOf(VoxelGrid grid, const Pose& pose) {
        LevelBody body;
        body.pose = pose;
        body.isStatic = false;
        LevelShape shape;
        shape.grid = std::move(grid);
        shape.palette = testPalette();
        body.shapes.push_back(std::move(shape));
        return body;
    }
};

TEST_F(ShadowLightTest, SingleCubeIsLitInSixteenRotations) {
    const glm::vec3 toSun = glm::normalize(glm::vec3(-0.6f, 0.36f, 0.5f));
    Count all;
    for (int i = 0; i < 16; ++i) {
        VoxelGrid cube({10, 10, 10});
        {
            GridWriter writer(cube);
            fillBox(writer, {0, 0, 0}, {10, 10, 10}, 4);
        }
        const glm::dquat rotation = glm::angleAxis(0.39 * i, glm::normalize(glm::dvec3(1.0, 0.4 * i, 0.3)));
        const glm::dvec3 center(0.013 * i, 3.0 - 0.037 * i, 0.0);  // falling: not aligned with the cells
        Level level;
        level.bodies.push_back(bodyOf(cube, {center - rotation * glm::dvec3(0.5), rotation}));
        Scene scene;
        scene.apply(levelSnapshot(level));
        View view;
        view.size = {240, 180};
        view.position = glm::dvec3(toSun) * 2.5 + glm::dvec3(0.6, 2.8, 0.2);
        view.rotation = glm::quatLookAt(glm::normalize(center - view.position), glm::dvec3(0, 1, 0));
        const Count count = sunlit(scene, view, toSun);
        EXPECT_GT(count.facing, 3000);
        EXPECT_GE(count.lit, count.facing * 0.995) << "rotation " << i;
        all.facing += count.facing;
        all.lit += count.lit;
    }
    RecordProperty("lit", std::to_string(double(all.lit) / all.facing));
}

TEST_F(ShadowLightTest, FacesFarFromTheWorldsOriginAreLitLikeOthers) {
    for (const double away : {0.0, 1e6, 1e7})
        for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
            VoxelGrid cube({10, 10, 10});
            {
                GridWriter writer(cube);
                fillBox(writer, {0, 0, 0}, {10, 10, 10}, 4);
            }
            const glm::dvec3 corner = axis * away;
            Level level;
            level.bodies.push_back(bodyOf(cube, {corner, {1, 0, 0, 0}}));
            Scene scene;
            scene.apply(levelSnapshot(level));
            const glm::vec3 toSun = glm::normalize(glm::vec3(0.6f, 0.5f, 0.4f));
            View view;
            view.size = {120, 90};
            view.position = corner + 0.5 + glm::dvec3(toSun) * 2.5;
            view.rotation = glm::quatLookAt(glm::normalize(corner + 0.5 - view.position), glm::dvec3(0, 1, 0));
            const Count count = sunlit(scene, view, toSun);
            EXPECT_GT(count.facing, 1000);
            EXPECT_GE(count.lit, count.facing * 0.995) << away << " m along " << axis.x << axis.y << axis.z;
        }
}

TEST_F(ShadowLightTest, ClosedRoomIsDarkInside) {
    for (const double turn : {0.0, 0.3, 0.785}) {
        VoxelGrid room({30, 24, 26});
        {
            GridWriter writer(room);
            fillBox(writer, {0, 0, 0}, {30, 24, 26}, 4);
            fillBox(writer, {1, 1, 1}, {29, 23, 25}, 0);
        }
        const glm::dquat rotation = glm::angleAxis(turn, glm::normalize(glm::dvec3(0.2, 1.0, 0.1)));
        Level level;
        level.bodies.push_back(bodyOf(room, {glm::dvec3(0.03, 0.21, 0.07), rotation}));
        Scene scene;
        scene.apply(levelSnapshot(level));
        for (int side = 0; side < 4; ++side) {
            View view;
            view.size = {160, 120};
            view.verticalFov = 1.4f;
            view.position = glm::dvec3(0.03, 0.21, 0.07) + rotation * glm::dvec3(1.5, 1.2, 1.3);
            view.rotation = glm::angleAxis(1.57 * side, glm::dvec3(0, 1, 0));
            const Count count = sunlit(scene, view, glm::normalize(glm::vec3(-0.6f, 0.36f, 0.5f)));
            EXPECT_EQ(count.lit, 0) << "of " << count.facing << ", turned by " << turn;
        }
    }
}

/// A floor, and a wall of one voxel across its middle which hides the sun from one half of it.
LevelShape floorWithWall() {
    constexpr int kSide = 40, kFloor = 2, kWall = 20;
    LevelShape shape;
    shape.grid = VoxelGrid({kSide, kSide, kSide});
    GridWriter writer(shape.grid);
    fillBox(writer, {0, 0, 0}, {kSide, kFloor, kSide}, 4);
    fillBox(writer, {0, kFloor, kWall}, {kSide, kSide, kWall + 1}, 4);
    shape.palette = testPalette();
    return shape;
}

/// Voxels below the size of shadow cells lie anywhere in them, and share them at the feet of walls.
TEST_F(ShadowLightTest, FeetOfWallsAreLitOnOneSideAndDarkOnTheOther) {
    const glm::dvec3 toSun = glm::normalize(glm::dvec3(0.1, 0.6, 1.0));
    for (const float size : {0.01f, 0.02f, 0.04f, 0.0625f, 0.07f, 0.08f, 0.1f, 0.125f, 0.25f})
        for (const double place : {0.0, 0.013, 0.037, 0.05, 0.081})
            for (const double turn : {0.0, 0.3}) {
                const Pose pose{glm::dvec3(place), glm::angleAxis(turn, glm::normalize(glm::dvec3(0.2, 1.0, 0.1)))};
                Level level;
                level.bodies.push_back(bodyOf(VoxelGrid(), pose));
                level.bodies[0].shapes[0] = floorWithWall();
                level.bodies[0].shapes[0].voxelSize = size;
                Scene scene;
                scene.apply(levelSnapshot(level));
                const auto look = [&](glm::dvec3 from, glm::dvec3 to) {
                    View view;
                    view.size = {80, 60};
                    view.verticalFov = 0.8f;
                    view.position = pose.transformPoint(from * double(size));
                    view.rotation =
                        glm::quatLookAt(pose.rotation * glm::normalize(to - from), pose.rotation * glm::dvec3(0, 1, 0));
                    return sunlit(scene, view, glm::vec3(pose.rotation * toSun));
                };
                const Count front = look({20.0, 10.0, 33.0}, {20.0, 2.0, 21.0});
                EXPECT_GT(front.facing, 3000);
                EXPECT_GE(front.lit, front.facing * 0.99)
                    << "voxels of " << size << " m at " << place << ", turned by " << turn;
                const Count back = look({20.0, 10.0, 8.0}, {20.0, 2.0, 20.0});
                EXPECT_GT(back.facing, 1000);
                EXPECT_EQ(back.lit, 0) << "voxels of " << size << " m at " << place << ", turned by " << turn;
            }
}

TEST_F(ShadowLightTest, OneVoxelFarAwayTakesNoShadow) {
    Level level;
    level.bodies.push_back(bodyOf(VoxelGrid(), {}));
    level.bodies[0].shapes[0] = floorWithWall();
    const glm::vec3 toSun = glm::normalize(glm::vec3(0.1f, 0.6f, 1.0f));
    View view;
    view.size = {80, 60};
    view.position = {2.0, 6.0, -1.0};
    view.rotation = glm::quatLookAt(glm::normalize(glm::dvec3(0.0, -6.0, 3.0)), glm::dvec3(0, 1, 0));
    Scene alone;
    alone.apply(levelSnapshot(level));
    const Count expected = sunlit(alone, view, toSun);
    ASSERT_GT(expected.facing - expected.lit, 500) << "the wall's shadow";
    VoxelGrid voxel({1, 1, 1});
    {
        GridWriter writer(voxel);
        fillBox(writer, {0, 0, 0}, {1, 1, 1}, 4);
    }
    level.bodies.insert(level.bodies.begin(), bodyOf(voxel, {{5000.0, 0.0, 5000.0}, {1, 0, 0, 0}}));
    Scene scene;
    scene.apply(levelSnapshot(level));
    pass = std::make_unique<GBufferPass>(*shaders);  // it remembers a scene's bodies
    const Count count = sunlit(scene, view, toSun);
    EXPECT_EQ(count.facing, expected.facing);
    EXPECT_EQ(count.lit, expected.lit);
}

/// Teardown keeps a byte for 2x2x2 cells of the whole box, and two smaller copies of that.
TEST_F(ShadowLightTest, TownTakesAQuarterOfADenseVolume) {
    FrameSnapshot town = levelSnapshot(makeTown(1));
    glm::ivec3 low(1 << 20), high(-(1 << 20));
    for (const ShadowPatch& patch : town.shadow) {
        if (!patch.content) continue;
        low = glm::min(low, patch.brick);
        high = glm::max(high, patch.brick + 1);
    }
    const glm::dvec3 bytes = glm::dvec3(high - low) * double(kShadowBrickCells) / 2.0;
    const double dense = bytes.x * bytes.y * bytes.z * (1.0 + 1.0 / 8.0 + 1.0 / 64.0);
    Scene scene;
    scene.apply(std::move(town));
    View view;
    view.size = {64, 36};
    draw(scene, view);
    EXPECT_LT(double(scene.shadow().bytes()), 0.25 * dense);
    EXPECT_GT(double(scene.shadow().bytes()), 0.05 * dense) << "has it been sent at all?";
}

}  // namespace
}  // namespace rubble
