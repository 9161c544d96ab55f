// What the frames of a loaded level send to the GL: the first one all of it, once, without copies of the whole.
#include <cstdio>

#include "render/gl/offscreen.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/demolition.h"
#include "samples/scenes/town.h"
#include "tests/render/gl_calls.h"
#include "tests/render/gl_fixture.h"

namespace rubble::reference {
namespace {

struct Sent {
    uint64_t bytes = 0, calls = 0, largest = 0;
};

class LevelUpload : public GlTest {
protected:
    /// What glBufferSubData sends for the next frame.
    static Sent nextFrame(FrameLoop& loop, Renderer& renderer, const Offscreen& target) {
        static Sent sent;
        static PFNGLBUFFERSUBDATAPROC real;
        sent = {}, real = glad_glBufferSubData;
        const GlReplaced<PFNGLBUFFERSUBDATAPROC> counting(
            glad_glBufferSubData, [](GLenum kind, GLintptr offset, GLsizeiptr size, const void* data) {
                ++sent.calls, sent.bytes += uint64_t(size), sent.largest = std::max(sent.largest, uint64_t(size));
                real(kind, offset, size, data);
            });
        const Pose camera = demolitionCamera(2.0);
        const View view{.position = camera.position,
                        .rotation = camera.rotation,
                        .size = target.size(),
                        .framebuffer = target.framebuffer()};
        loop.draw(renderer, view, 1.0f);
        return sent;
    }
};

TEST_F(LevelUpload, SendsTheTownOnceInTheFirstFrame) {
    FrameLoopSettings settings;
    settings.shadow = ShadowWorker::Mode::Inline;
    settings.waitForShadow = true;
    FrameLoop loop(settings);
    loop.load(makeTown(1));
    loop.step();
    auto made = Renderer::create(testContext().loader(), shaderFolder(), RenderSettings{});
    ASSERT_TRUE(made) << made.error();
    Renderer& renderer = **made;
    const Offscreen target({64, 36});
    const Sent first = nextFrame(loop, renderer, target), second = nextFrame(loop, renderer, target),
               third = nextFrame(loop, renderer, target);
    std::printf("first frame: %.1f MB in %d calls of at most %.2f MB\n", double(first.bytes) * 1e-6, int(first.calls),
                double(first.largest) * 1e-6);
    EXPECT_EQ(renderer.stats().waitingBytes, 0u);
    EXPECT_GT(first.bytes, uint64_t(renderer.stats().bricks) * 576) << "all bricks";
    EXPECT_LT(first.bytes, renderer.stats().textureBytes) << "no byte twice";
    EXPECT_LT(first.largest, 1u << 20) << "what is gathered for a call must stay in the processor's cache";
    EXPECT_LT(first.calls, 128u);
    EXPECT_LT(second.bytes, 32u << 10);
    EXPECT_LT(third.bytes, 8u << 10);
}

}  // namespace
}  // namespace rubble::reference
