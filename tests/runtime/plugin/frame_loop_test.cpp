#include "runtime/plugin/frame_loop.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "render/gl/offscreen.h"
#include "samples/support/camera.h"
#include "samples/support/gl_context.h"
#include "tests/support/allocation_count.h"

namespace rubble {
namespace {

LevelBody makeBody(const char* material, glm::dvec3 position, glm::ivec3 size, bool isStatic) {
    LevelBody body;
    body.pose.position = position;
    body.isStatic = isStatic;
    auto palette = std::make_shared<Palette>();
    (*palette)[1].material = defaultMaterials().find(material);
    LevelShape shape;
    shape.name = material;
    shape.grid = VoxelGrid(size);
    GridWriter writer(shape.grid);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) writer.set({x, y, z}, 1);
    writer.flush();
    shape.palette = palette;
    body.shapes.push_back(std::move(shape));
    return body;
}

/// A wall and crates on a floor, with a lamp on one of them.
Level yard() {
    Level level;
    level.bodies.push_back(makeBody("brick", {-5, -0.8, -5}, {100, 8, 100}, true));
    level.bodies.push_back(makeBody("brick", {-2, 0, 0}, {40, 20, 3}, true));
    for (int i = 0; i < 4; ++i) level.bodies.push_back(makeBody("wood", {-2.0 + i, 0.3, 1}, {5, 5, 5}, false));
    LevelLight lamp;
    lamp.light.name = "lamp";
    lamp.shapeName = "wood";
    level.lights.push_back(lamp);
    return level;
}

ExplodeEdit blast(int step) {
    ExplodeEdit edit;
    edit.position = {-1.8 + 0.03 * step, 0.9, 0.15};
    edit.size = 0.6;
    return edit;
}

/// Through the wall from side to side: its upper half comes down.
CarveEdit cut() {
    CarveEdit edit;
    edit.kind = BrushKind::Capsule;
    edit.position = {-2.5, 1.0, 0.15};
    edit.end = {2.5, 1.0, 0.15};
    edit.radii.fill(0.25);
    return edit;
}

TEST(FrameLoop, AQuietStepAllocatesNothing) {
    for (const auto mode : {ShadowWorker::Mode::Inline, ShadowWorker::Mode::Thread}) {
        FrameLoopSettings settings;
        settings.shadow = mode;
        FrameLoop loop(settings);
        loop.load(yard());
        loop.edits().push(cut());
        loop.edits().push(blast(40));
        for (int i = 0; i < 900; ++i) loop.step();
        ASSERT_EQ(loop.physics().figures().awake, 0) << "not yet quiet";
        ASSERT_GT(loop.world().shapes().size(), 6u) << "nothing broke off";
        loop.shadow()->waitFor(loop.changes().step);
        loop.step();  // publishes what the worker has just finished
        const size_t before = allocationCount();
        for (int i = 0; i < 10; ++i) loop.step();
        EXPECT_EQ(allocationCount(), before);
        EXPECT_EQ(loop.shadowAge(), 0u);
    }
}

/// Main, shadow worker and render thread at once, none waiting for another: for the thread sanitizer; and the world does not
/// notice who watches.
TEST(FrameLoop, StepsWhileAnotherThreadDraws) {
    constexpr int kSteps = 120;
    const auto run = [](FrameLoop& loop) {
        for (int i = 0; i < kSteps; ++i) {
            if (i % 10 == 0) loop.edits().push(blast(i));
            if (i == 25) loop.edits().push(cut());
            loop.step();
        }
        return loop.world().hash();
    };
    FrameLoop drawn;
    drawn.load(yard());
    std::atomic<bool> ready = false, stop = false;
    int shapes = 0;
    std::thread render([&] {
        auto context = GlContext::create(GlContext::Kind::OsMesa);
        ASSERT_TRUE(context) << context.error();
        auto renderer = Renderer::create(context.value()->loader(), RUBBLE_SOURCE_DIR "/shaders", RenderSettings::preset("fast"));
        ready = true;
        ASSERT_TRUE(renderer) << renderer.error();
        const Offscreen target({64, 36});
        Camera camera;
        camera.position = {0, 2, 6};
        camera.lookAt({0, 0.5, 0});
        while (!stop) drawn.draw(*renderer.value(), camera.view(target.size(), target.framebuffer()), 0.5f);
        drawn.draw(*renderer.value(), camera.view(target.size(), target.framebuffer()), 1.0f);
        shapes = renderer.value()->figures().shapes;
    });
    while (!ready) std::this_thread::yield();
    const uint64_t hash = run(drawn);
    drawn.shadow()->waitFor(drawn.changes().step);
    drawn.step();
    stop = true;
    render.join();
    EXPECT_EQ(size_t(shapes), drawn.world().shapes().size()) << "a snapshot was lost";

    FrameLoopSettings settings;
    settings.shadow = ShadowWorker::Mode::Inline;
    settings.publish = false;
    FrameLoop alone(settings);
    alone.load(yard());
    EXPECT_EQ(run(alone), hash);
}

}  // namespace
}  // namespace rubble
