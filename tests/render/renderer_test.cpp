#include "render/renderer.h"

#include <set>

#include "render/gl/offscreen.h"
#include "runtime/core/random.h"
#include "samples/support/camera.h"
#include "samples/support/image.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/test_scene.h"

namespace rubble {
namespace {

class RendererTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        RenderSettings settings;
        settings.temporal = false;
        auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
        ASSERT_TRUE(made) << made.error();
        renderer = std::move(made).value();
    }
    std::unique_ptr<Renderer> renderer;
};

/// A floor, a wall with a hole, rotated boxes.
TestScene corner() {
    TestScene scene;
    const PaletteRef palette = testPalette();
    VoxelGrid floor({160, 4, 160});
    {
        GridWriter writer(floor);
        for (int z = 0; z < 160; ++z)
            for (int x = 0; x < 160; ++x)
                for (int y = 0; y < 3; ++y) writer.set({x, y, z}, uint8_t(1 + hashCell(x, y, z) % 3));
    }
    scene.add(floor, {{-8, -0.3, -8}, {1, 0, 0, 0}}, palette);
    VoxelGrid wall({80, 40, 4});
    {
        GridWriter writer(wall);
        for (int z = 0; z < 4; ++z)
            for (int y = 0; y < 40; ++y)
                for (int x = 0; x < 80; ++x)
                    if ((x - 40) * (x - 40) + (y - 20) * (y - 20) > 100) writer.set({x, y, z}, uint8_t(10 + y % 4));
    }
    scene.add(wall, {{-4, 0, -3}, {1, 0, 0, 0}}, palette);
    for (int i = 0; i < 6; ++i) {
        VoxelGrid box({10 + i, 8, 12});
        GridWriter writer(box);
        fillBox(writer, {0, 0, 0}, {10 + i, 8, 12}, uint8_t(30 + i));
        writer.flush();
        scene.add(box,
                  {{-4.0 + 1.4 * i, 0.4 + 0.1 * i, -0.5 + 0.3 * i},
                   glm::angleAxis(0.4 * i, glm::normalize(glm::dvec3(1, i, 0.5)))},
                  palette);
    }
    return scene;
}

TEST_F(RendererTest, DrawsACornerInAFewDraws) {
    renderer->apply(corner().take());
    Offscreen target({640, 360});
    Camera camera;
    camera.position = {3, 2.5, 6};
    camera.lookAt({0, 0.8, -1});
    const View view = camera.view(target.size(), target.framebuffer());
    renderer->draw(view, 1.0f);
    EXPECT_EQ(renderer->stats().shapes, 8);
    EXPECT_LE(renderer->stats().bodyDraws, 16);
    EXPECT_GT(renderer->stats().uploadBytes, 0u);
    renderer->draw(view, 1.0f);
    renderer->draw(view, 1.0f);
    EXPECT_EQ(renderer->stats().uploadBytes, 0u) << "nothing changed";
    const std::vector<uint8_t> pixels = target.readRgb();
    EXPECT_GT(std::set<uint8_t>(pixels.begin(), pixels.end()).size(), 50u) << "an empty image";
}

TEST_F(RendererTest, TargetsAreReadAsNumbers) {
    TestScene scene = corner();
    renderer->apply(scene.take());
    Offscreen target({64, 48});
    Camera camera;
    camera.position = {0, 2, 6};
    camera.lookAt({0, 0, 0});
    renderer->draw(camera.view(target.size(), target.framebuffer()), 1.0f);
    const auto depth = renderer->readTarget("depth"), normal = renderer->readTarget("normal");
    ASSERT_TRUE(depth) << depth.error();
    ASSERT_TRUE(normal) << normal.error();
    EXPECT_EQ(depth->size, target.size());
    // The lowest row shows the floor, nearer than the middle of the image.
    EXPECT_NEAR(normal->at(32, 0).y, 1.0f, 0.01f);
    EXPECT_LT(depth->at(32, 0).x, depth->at(32, 16).x);
    EXPECT_FALSE(renderer->readTarget("depthBuffer"));
    EXPECT_FALSE(renderer->readTarget("no such"));
}

}  // namespace
}  // namespace rubble
