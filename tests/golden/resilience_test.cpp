#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <thread>

#include "render/gl/offscreen.h"
#include "render/renderer.h"
#include "runtime/core/log.h"
#include "tests/golden/drawing.h"
#include "tests/render/gl_calls.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(64, 48);

int g_refusals = 0;            ///< how many of the renderer's framebuffers the GL will still refuse
GLuint g_viewFramebuffer = 0;  ///< the host's, which is never refused
GLenum refuseSome(GLenum) {
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    return GLuint(bound) != g_viewFramebuffer && g_refusals-- > 0 ? GL_FRAMEBUFFER_UNSUPPORTED
                                                                  : GL_FRAMEBUFFER_COMPLETE;
}
decltype(glad_glTexImage2D) g_texImage2D = nullptr;
/// A GL that has no memory for textures of the image's size.
void texImageNotOfTheView(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLint border,
                          GLenum format, GLenum type, const void* data) {
    if (glm::ivec2(width, height) != kSize)
        g_texImage2D(target, level, internal, width, height, border, format, type, data);
}
GLenum statusWithoutWindow(GLenum) {
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    return bound == 0 ? GL_FRAMEBUFFER_UNDEFINED : GL_FRAMEBUFFER_COMPLETE;
}
GLenum g_resetStatus = GL_NO_ERROR;
bool g_resetIsToldOnce = false;
GLenum resetStatus() {
    return g_resetIsToldOnce ? std::exchange(g_resetStatus, GLenum(GL_NO_ERROR)) : g_resetStatus;
}
double g_seconds = 0.0;  ///< the renderer's clock
double testSeconds() {
    return g_seconds;
}
GLenum alwaysAnError() {
    return GL_OUT_OF_MEMORY;
}
void* loaderOfALostContext(const char* name) {
    if (std::strstr(name, "glGetGraphicsResetStatus")) return reinterpret_cast<void*>(&resetStatus);
    return testContext().loader()(name);
}

/// Failures around the renderer: there is always a message, and an image where that is possible.
class ResilienceTest : public Drawing {
protected:
    void SetUp() override {
        Drawing::SetUp();
        setLogSink([](void* lines, LogLevel,
                      std::string_view text) { static_cast<std::vector<std::string>*>(lines)->emplace_back(text); },
                   &m_lines);
    }
    void TearDown() override {
        setLogSink(nullptr, nullptr);
        Drawing::TearDown();
    }
    bool wasLogged(std::string_view text) const {
        return std::any_of(m_lines.begin(), m_lines.end(),
                           [&](const std::string& line) { return line.find(text) != std::string::npos; });
    }
    static size_t colors(const Image& image) {
        std::set<uint32_t> all;
        for (size_t i = 0; i < image.rgb.size(); i += 3)
            all.insert(uint32_t(image.rgb[i] | image.rgb[i + 1] << 8 | image.rgb[i + 2] << 16));
        return all.size();
    }
    std::vector<std::string> m_lines;
};

TEST_F(ResilienceTest, AViewWithoutPixelsDrawsNothingAndTheNextOneIsFine) {
    start(streetScene(), kSize);
    for (const glm::ivec2 size : {glm::ivec2(0, 0), glm::ivec2(0, 48), glm::ivec2(64, 0), glm::ivec2(-3, 5)}) {
        renderer->draw(streetCamera(0).view(size, target->framebuffer()), 1.0f);
        EXPECT_EQ(renderer->lastError(), "");
    }
    EXPECT_GT(colors(draw(streetCamera(0))), 50u);
}

TEST_F(ResilienceTest, SizesMayChangeWithEveryFrame) {
    start(streetScene(), {97, 61});
    for (const glm::ivec2 size :
         {glm::ivec2(97, 61), glm::ivec2(1, 1), glm::ivec2(5, 61), glm::ivec2(97, 2), glm::ivec2(97, 61)})
        renderer->draw(streetCamera(0).view(size, target->framebuffer()), 1.0f);
    EXPECT_GT(colors(draw(streetCamera(0))), 50u);
}

TEST_F(ResilienceTest, AFramebufferThatTheGlRefusesIsDrawnSmaller) {
    start(streetScene(), kSize);
    const auto real = std::exchange(glad_glCheckFramebufferStatus, refuseSome);
    g_refusals = 2;
    g_viewFramebuffer = target->framebuffer();
    const Image image = draw(streetCamera(0));
    glad_glCheckFramebufferStatus = real;
    EXPECT_TRUE(wasLogged("drawn at 1/2")) << "no warning was logged";
    EXPECT_EQ(renderer->lastError(), "");
    EXPECT_GT(colors(image), 50u);
}

TEST_F(ResilienceTest, TargetsThatTheGlHasNoMemoryForLeaveTheHostNoError) {
    start(streetScene(), kSize);
    g_texImage2D = glad_glTexImage2D;
    Image image;
    {
        const GlReplaced refusal(glad_glTexImage2D, decltype(glad_glTexImage2D)(texImageNotOfTheView));
        image = draw(streetCamera(0));
    }
    EXPECT_TRUE(wasLogged("drawn at 1/2")) << "no warning was logged";
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    EXPECT_EQ(renderer->lastError(), "");
    EXPECT_GT(colors(image), 50u);
}

TEST_F(ResilienceTest, AGlThatRefusesEverythingIsReported) {
    start(streetScene(), kSize);
    const auto real = std::exchange(glad_glCheckFramebufferStatus, refuseSome);
    g_refusals = 1 << 30;
    g_viewFramebuffer = target->framebuffer();
    renderer->draw(streetCamera(0).view(kSize, target->framebuffer()), 1.0f);
    glad_glCheckFramebufferStatus = real;
    EXPECT_NE(renderer->lastError().find("out of memory"), std::string::npos);
}

TEST_F(ResilienceTest, ALostContextIsReportedOnceAndDrawsNothing) {
    auto made = Renderer::create(loaderOfALostContext, shaderFolder(), {});
    ASSERT_TRUE(made) << made.error();
    const auto lost = std::move(made).value();
    g_resetStatus = 0x8253;  // GL_GUILTY_CONTEXT_RESET
    const Offscreen offscreen(kSize);
    for (int i = 0; i < 3; ++i) lost->draw(streetCamera(0).view(kSize, offscreen.framebuffer()), 1.0f);
    g_resetStatus = GL_NO_ERROR;
    static_cast<void>(loadGl(testContext().loader()));
    EXPECT_NE(lost->lastError().find("lost"), std::string::npos);
    EXPECT_EQ(m_lines.size(), 1u);
}

/// Drivers tell of a reset once; afterwards the new context seems fine, but all objects are gone.
TEST_F(ResilienceTest, ALostContextStaysLost) {
    auto made = Renderer::create(loaderOfALostContext, shaderFolder(), {});
    ASSERT_TRUE(made) << made.error();
    const Offscreen offscreen(kSize);
    g_resetIsToldOnce = true;
    g_resetStatus = 0x8253;  // GL_GUILTY_CONTEXT_RESET
    for (int i = 0; i < 3; ++i) {
        (*made)->draw(streetCamera(0).view(kSize, offscreen.framebuffer()), 1.0f);
        EXPECT_NE((*made)->lastError().find("lost"), std::string::npos) << "draw " << i;
    }
    EXPECT_FALSE((*made)->readTarget("final"));
    EXPECT_FALSE((*made)->reloadShaders());
    g_resetIsToldOnce = false;
    static_cast<void>(loadGl(testContext().loader()));
}

/// In another context the renderer's names mean objects of the host.
TEST_F(ResilienceTest, InAnotherContextNothingIsDrawnOrDeleted) {
    start(streetScene(), kSize);
    draw(streetCamera(0), 2);
    {
        const auto other = GlContext::create(testContextKind());
        ASSERT_TRUE(other) << other.error();
        constexpr int kNames = 256;
        GLuint buffers[kNames], textures[kNames];
        glGenBuffers(kNames, buffers);
        glGenTextures(kNames, textures);
        for (int i = 0; i < kNames; ++i) {
            glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
            glBindTexture(GL_TEXTURE_2D, textures[i]);
        }
        renderer->draw(streetCamera(0).view(kSize, 0), 1.0f);
        EXPECT_NE(renderer->lastError().find("found another one"), std::string::npos) << renderer->lastError();
        renderer.reset();
        for (int i = 0; i < kNames; ++i)
            EXPECT_TRUE(glIsBuffer(buffers[i]) && glIsTexture(textures[i])) << "name " << buffers[i];
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    }
    testContext().makeCurrent();
}

TEST_F(ResilienceTest, AHostsErrorIsLeftToTheHost) {
    start(streetScene(), kSize);
    glEnable(GL_TEXTURE_BINDING_2D);  // an invalid enum
    draw(streetCamera(0), 2);
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

TEST_F(ResilienceTest, AContextThatHasAlwaysAnErrorDoesNotStopADraw) {
    start(streetScene(), kSize);
    const GlReplaced errors(glad_glGetError, decltype(glad_glGetError)(alwaysAnError));
    EXPECT_GT(colors(draw(streetCamera(0))), 50u);
}

TEST_F(ResilienceTest, AViewThatCannotBeDrawnSaysWhyAndTheNextOneIsDrawn) {
    start(streetScene(), kSize);
    const Image before = draw(streetCamera(0));
    GLuint incomplete = 0;
    glGenFramebuffers(1, &incomplete);
    glBindFramebuffer(GL_FRAMEBUFFER, incomplete);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    for (const auto& [framebuffer, error] :
         {std::pair(GLuint(999), "found none"), std::pair(incomplete, "found status 36055")}) {
        renderer->draw(streetCamera(0).view(kSize, framebuffer), 1.0f);
        EXPECT_NE(renderer->lastError().find(error), std::string::npos) << renderer->lastError();
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    }
    glDeleteFramebuffers(1, &incomplete);

    std::thread([&] { renderer->draw(streetCamera(0).view({64, 48}, 0), 1.0f); }).join();
    EXPECT_NE(renderer->lastError().find("current GL context"), std::string::npos) << renderer->lastError();

    const Image after = draw(streetCamera(0));
    EXPECT_EQ(renderer->lastError(), "");
    EXPECT_EQ(colors(before) > 50, colors(after) > 50);
}

TEST_F(ResilienceTest, AContextWithoutAWindowHasNothingToDrawInto) {
    for (const HostState host : {HostState::Restored, HostState::Reset}) {
        RenderSettings settings;
        settings.hostState = host;
        start(streetScene(), kSize, settings);
        const GlReplaced status(glad_glCheckFramebufferStatus,
                                decltype(glad_glCheckFramebufferStatus)(statusWithoutWindow));
        for (int i = 0; i < 2; ++i) renderer->draw(streetCamera(0).view(kSize, 0), 1.0f);
        EXPECT_NE(renderer->lastError().find("without a window"), std::string::npos) << renderer->lastError();
        EXPECT_FALSE(renderer->readTarget("radiance")) << "it was drawn all the same";
        draw(streetCamera(0));
        EXPECT_EQ(renderer->lastError(), "");
    }
}

TEST_F(ResilienceTest, ABrokenShaderKeepsTheImageAndShowsARedDot) {
    namespace fs = std::filesystem;
    const TempFolder copies;
    const fs::path folder = copies.path() / "shaders";
    fs::copy(shaderFolder(), folder, fs::copy_options::recursive);
    RenderSettings settings;
    settings.seconds = testSeconds;
    auto made = Renderer::create(testContext().loader(), folder.string(), settings);
    ASSERT_TRUE(made) << made.error();
    renderer = std::move(made).value();
    renderer->apply(streetScene().snapshot());
    target = std::make_unique<Offscreen>(kSize);
    const Image before = draw(streetCamera(0));

    const fs::path file = folder / "passes/tonemap.frag";
    std::ifstream in(file);
    const std::string good((std::istreambuf_iterator<char>(in)), {});
    std::ofstream(file) << good << "\nvoid broken() { oops }\n";
    fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(5));
    renderer->reloadShaders();
    ASSERT_EQ(renderer->shaderErrors().size(), 1u);
    EXPECT_NE(renderer->shaderErrors()[0].find("passes/tonemap.frag:"), std::string::npos)
        << renderer->shaderErrors()[0];
    const Image broken = draw(streetCamera(0));
    EXPECT_GT(broken.at(12, kSize.y - 13)[0], 200) << "no red dot";
    EXPECT_LT(broken.at(12, kSize.y - 13)[2], 60);
    EXPECT_EQ(colors(before) > 50, colors(broken) > 50) << "the last good program is not in use";

    std::ofstream(file) << good;
    fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(10));
    EXPECT_TRUE(renderer->reloadShaders());
    EXPECT_TRUE(renderer->shaderErrors().empty());
    g_seconds += 0.9;
    EXPECT_GT(draw(streetCamera(0)).at(12, kSize.y - 13)[1], 150) << "no green dot";
    g_seconds += 0.2;
    EXPECT_LT(draw(streetCamera(0)).at(12, kSize.y - 13)[1], 150) << "the green dot stays";
}

}  // namespace
}  // namespace rubble
