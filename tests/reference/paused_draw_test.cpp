// Draws without steps between them: a pause, or an editor in which no time passes.
#include "render/gl/offscreen.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/test_scenes.h"
#include "tests/render/gl_fixture.h"

namespace rubble::reference {
namespace {

class PausedDraw : public GlTest {};

TEST_F(PausedDraw, ShowsTheLastStepOnceItsShadowIsThere) {
    FrameLoop loop((FrameLoopSettings()));
    loop.load(makeSingleCube(8, 1.0));
    loop.step();
    loop.shadow()->waitFor(loop.world().step());
    auto made = Renderer::create(testContext().loader(), shaderFolder(), RenderSettings{});
    ASSERT_TRUE(made) << made.error();
    const Offscreen target({32, 18});
    const View view{.size = target.size(), .framebuffer = target.framebuffer()};
    loop.draw(**made, view, 1.0f);
    const int shapes = (*made)->stats().shapes;
    ASSERT_GT(shapes, 0) << "nobody has stepped since the shadow was there";
    ShapeHandle last;
    loop.world().shapes().forEach([&](ShapeHandle handle, const Shape&) { last = handle; });
    loop.edits().push(Edit(DestroyShapeEdit{last}));
    loop.step(World::Follows::Nothing);
    loop.shadow()->waitFor(loop.world().step());
    loop.draw(**made, view, 1.0f);
    EXPECT_EQ((*made)->stats().shapes, shapes - 1);
}

}  // namespace
}  // namespace rubble::reference
