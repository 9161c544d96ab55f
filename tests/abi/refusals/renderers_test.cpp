// The functions of renderers with every wrong value of each argument. They need a GL context: without one these tests
// are skipped, or fail in CI.
#include <cstdlib>
#include <set>
#include <thread>

#include "render/gl/gl.h"
#include "render/gl/offscreen.h"
#include "samples/support/gl_context.h"
#include "tests/abi/refusals/refusals_fixture.h"

namespace rubble {
namespace {

class RendererRefusals : public Refusals {
protected:
    static void SetUpTestSuite() {
        const char* kind = std::getenv("RUBBLE_TEST_GL");
        auto made = GlContext::create(GlContext::kindOf(kind ? kind : "osmesa"));
        if (!made || !loadGl(made.value()->loader())) return;
        s_context = std::move(made).value();
        s_target = std::make_unique<Offscreen>(glm::ivec2(16));
        drawTarget() = s_target->framebuffer();
        Refusals::SetUpTestSuite();
    }
    static void TearDownTestSuite() {
        Refusals::TearDownTestSuite();
        s_target.reset();
        s_context.reset();
    }
    void SetUp() override {
        if (!s_context && std::getenv("CI")) FAIL() << "there is no OpenGL";
        if (!s_context) GTEST_SKIP() << "there is no OpenGL";
        auto host = sized<rubble_host>();
        host.gl_get_proc_address = s_context->loader();
        ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
        FullWorld world(callFiles().level, 0);
        world.addRenderer();
        s_goneRenderer = world.live().at("rubble_renderer");
    }
    void TearDown() override {
        if (s_context) {
            EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        }
        Refusals::TearDown();
    }
    static inline std::unique_ptr<GlContext> s_context;
    static inline std::unique_ptr<Offscreen> s_target;
};

TEST_F(RendererRefusals, EveryFunctionIsAcceptedAsAHostCallsIt) {
    expectUsualCallsAccepted(true);
}

TEST_F(RendererRefusals, EveryWrongArgumentIsRefusedByNameAndChangesNothing) {
    expectWrongArgumentsRefused(true);
}

/// Where no context is current. Debug view, figures and what an overlay is given ask nothing of the GL.
TEST_F(RendererRefusals, AThreadWithoutTheContextIsRefused) {
    for (const FunctionDescription& function : functions(true)) {
        static const std::set<std::string> kNothing{"set_debug_view", "get_draw_stats", "set_overlay",
                                                    "set_overlay_image"};
        if (kNothing.contains(function.name)) continue;
        SCOPED_TRACE(function.name);
        const auto world = makePrepared(function, waysOf(function)[0]);
        const uint64_t before = world->hash();
        HostCall call(function, *world);
        waysOf(function)[0](call);
        std::thread([&] {
            EXPECT_EQ(call.call(), RUBBLE_ERROR_GL) << api()->get_last_error();
            expectNamed(function, "context");
        }).join();
        EXPECT_EQ(world->hash(), before);
        EXPECT_EQ(run(call, function), RUBBLE_OK) << "here: " << api()->get_last_error();
    }
}

/// What a log callback calls inside of a draw.
struct RendererListener {
    const FunctionDescription* function;
    const FullWorld* world;
    int calls = 0;
};

TEST_F(RendererRefusals, ACallFromACallbackIsRefused) {
    RendererListener listener{};
    auto host = sized<rubble_host>();
    host.gl_get_proc_address = s_context->loader();
    host.user = &listener;
    host.log = [](void* user, int32_t, const char*) {
        auto& inside = *static_cast<RendererListener*>(user);
        if (!inside.function) return;
        HostCall call(*inside.function, *inside.world);
        waysOf(*inside.function)[0](call);
        // It is no argument of create_renderer(), but the world has the renderer that draws.
        const bool isCreate = isOfWorld(*inside.function);
        EXPECT_EQ(call.call(), isCreate ? RUBBLE_ERROR_ARGUMENT : RUBBLE_ERROR_BUSY) << api()->get_last_error();
        expectNamed(*inside.function, "renderer");
        ++inside.calls;
    };
    ASSERT_EQ(api()->set_host(&host), RUBBLE_OK);
    for (const FunctionDescription& function : functions(true)) {
        SCOPED_TRACE(function.name);
        const auto world = makeWorld(function);
        if (isOfWorld(function)) world->addRenderer();
        const uint64_t before = world->hash();
        auto view = sized<rubble_view>();
        view.framebuffer = ~0u, view.width = view.height = 16;
        listener = {&function, world.get()};
        const rubble_renderer renderer = world->live().at("rubble_renderer");
        EXPECT_EQ(api()->draw(renderer, &view), RUBBLE_ERROR_GL) << "it logs that there is no such framebuffer";
        EXPECT_EQ(listener.calls, 1);
        listener.function = nullptr;
        EXPECT_EQ(world->hash(), before);
        view.framebuffer = drawTarget();
        EXPECT_EQ(api()->draw(renderer, &view), RUBBLE_OK) << api()->get_last_error();
    }
}

}  // namespace
}  // namespace rubble
