#include "render/gl/pass_timer.h"

#include "render/gl/offscreen.h"
#include "render/renderer.h"
#include "samples/support/camera.h"
#include "tests/render/gl_calls.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/test_scene.h"

namespace rubble {
namespace {

class PassTimerTest : public GlTest {
protected:
    static void drawFrame(PassTimer& timer, int tag = 0, bool isOn = true) {
        timer.beginFrame(isOn);
        for (const char* pass : {"sun", "sky"}) {
            timer.begin(pass, tag);
            timer.end();
        }
    }
};

TEST_F(PassTimerTest, DoesNotMeetAHostsTimerQuery) {
    PassTimer timer(false, false);
    GLuint query = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_TIME_ELAPSED, query);
    for (int i = 0; i < 3; ++i) drawFrame(timer);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    glEndQuery(GL_TIME_ELAPSED);
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << "the host's query was ended";
    glDeleteQueries(1, &query);
}

void neverReady(GLuint, GLenum, GLint* out) {
    *out = GL_FALSE;
}

TEST_F(PassTimerTest, NeverWaitsForTheGpu) {
    PassTimer timer(false, false);
    {
        const GlReplaced busy(glad_glGetQueryObjectiv, decltype(glad_glGetQueryObjectiv)(neverReady));
        const GlCalls<&glad_glGetQueryObjectui64v> results;
        const GlCalls<&glad_glQueryCounter> timestamps;
        for (int i = 0; i < 20; ++i) {
            drawFrame(timer, i);
            EXPECT_TRUE(timer.take().empty());
        }
        EXPECT_EQ(results.count(), 0) << "asks for a result that is not ready";
        EXPECT_LE(timestamps.count(), 4 * 4) << "queries pile up";
    }
    glFinish();
    drawFrame(timer, 20);
    const PassTimer::Times times = timer.take();
    ASSERT_EQ(times.size(), 2u);
    EXPECT_STREQ(times[1].name, "sky");
    EXPECT_EQ(times[1].tag, 3) << "the newest frame that was timed";
    EXPECT_GE(times[1].ms, 0.0);
}

TEST_F(PassTimerTest, CostsNothingUnlessWanted) {
    RenderSettings settings;
    settings.fullscreen = Fullscreen::Fragment;  // to find the faster method takes times
    auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
    ASSERT_TRUE(made) << made.error();
    const Offscreen target({32, 24});
    const GlCalls<&glad_glQueryCounter> timestamps;
    const GlCalls<&glad_glBeginQuery> queries;
    const GlCalls<&glad_glFinish> waits;
    for (int i = 0; i < 3; ++i) (*made)->draw(Camera().view(target.size(), target.framebuffer()), 1.0f);
    EXPECT_EQ(timestamps.count() + queries.count() + waits.count(), 0);
    EXPECT_TRUE((*made)->stats().passMs.empty());
    EXPECT_FALSE((*made)->stats().passes.empty());
}

TEST_F(PassTimerTest, TimesEachPassWhereWanted) {
    RenderSettings settings;
    settings.passTimes = true;
    auto made = Renderer::create(testContext().loader(), shaderFolder(), settings);
    ASSERT_TRUE(made) << made.error();
    const Offscreen target({32, 24});
    for (int i = 0; i < 3; ++i) (*made)->draw(Camera().view(target.size(), target.framebuffer()), 1.0f);
    const RenderStats& stats = (*made)->stats();
    if (isSoftwareGl()) {
        EXPECT_EQ(stats.passMs.size(), stats.passes.size());
    }
}

}  // namespace
}  // namespace rubble
