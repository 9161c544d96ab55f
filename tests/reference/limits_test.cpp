// A GL that has no more than GL 3.3 promises: 16 textures a program, buffer textures of 65,536 texels, sides of 1024.
#include <gtest/gtest.h>

#include "render/gl/offscreen.h"
#include "runtime/core/log.h"
#include "runtime/plugin/frame_loop.h"
#include "samples/scenes/demolition.h"
#include "samples/scenes/town.h"
#include "tests/golden/lit_scene.h"
#include "tests/reference/flip.h"
#include "tests/render/gl_fixture.h"

namespace rubble::reference {
namespace {

constexpr glm::ivec2 kSize(320, 180);

bool isSampler(GLenum type) {
    return (type >= GL_SAMPLER_1D && type <= GL_SAMPLER_2D_RECT_SHADOW) ||
           (type >= GL_SAMPLER_1D_ARRAY && type <= GL_SAMPLER_CUBE_SHADOW) ||
           (type >= GL_INT_SAMPLER_1D && type <= GL_UNSIGNED_INT_SAMPLER_BUFFER);
}

class LimitsTest : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        setLogSink([](void* lines, LogLevel,
                      std::string_view text) { static_cast<std::vector<std::string>*>(lines)->emplace_back(text); },
                   &m_lines);
    }
    void TearDown() override {
        setLogSink(nullptr, nullptr);
        GlTest::TearDown();
    }
    static std::unique_ptr<Renderer> makeRenderer(std::optional<GlLimits> limits, bool compileAhead = false,
                                                  const GlContext& context = testContext()) {
        RenderSettings settings;
        settings.limits = limits;
        settings.compileAhead = compileAhead;
        auto made = Renderer::create(context.loader(), shaderFolder(), settings);
        EXPECT_TRUE(made) << made.error();
        return std::move(made).value();
    }
    FloatImage draw(Renderer& renderer, FrameLoop& loop, double seconds, int frames) {
        const Offscreen target(kSize);
        View view;
        const Pose camera = demolitionCamera(seconds);
        view.position = camera.position;
        view.rotation = camera.rotation;
        view.verticalFov = kDemolitionFov;
        view.size = kSize;
        view.framebuffer = target.framebuffer();
        for (int i = 0; i < frames; ++i) loop.draw(renderer, view, 1.0f);
        EXPECT_EQ(renderer.lastError(), "");
        return FloatImage(kSize, target.readRgb());
    }
    /// The town, half a second into its demolition.
    FloatImage drawTown(Renderer& renderer) {
        FrameLoopSettings settings;
        settings.shadow = ShadowWorker::Mode::Inline;
        settings.waitForShadow = true;
        FrameLoop loop(settings);
        loop.load(makeTown(1));
        draw(renderer, loop, 2.0, 1);
        for (int i = 0; i < 30; ++i) {
            loop.edits().push(demolition(i, 1));
            loop.step();
        }
        return draw(renderer, loop, 2.0, 4);
    }
    std::vector<std::string> m_lines;
};

TEST_F(LimitsTest, EveryProgramKeepsWithinWhatGlPromises) {
    const auto renderer = makeRenderer(GlLimits(), true);
    int programs = 0, most = 0;
    for (GLuint name = 1; name < 2000; ++name) {
        if (!glIsProgram(name)) continue;
        ++programs;
        GLint count = 0, samplers = 0, blocks = 0;
        glGetProgramiv(name, GL_ACTIVE_UNIFORMS, &count);
        for (GLint i = 0; i < count; ++i) {
            char text[128];
            GLint size = 0;
            GLenum type = 0;
            glGetActiveUniform(name, GLuint(i), sizeof text, nullptr, &size, &type, text);
            if (!isSampler(type)) continue;
            samplers += size;
            EXPECT_NE(type, GLenum(GL_SAMPLER_3D)) << text << ": only sides of 256 are promised";
            EXPECT_NE(type, GLenum(GL_UNSIGNED_INT_SAMPLER_BUFFER)) << text;
            EXPECT_NE(type, GLenum(GL_SAMPLER_BUFFER)) << text;
        }
        EXPECT_LE(samplers, GlLimits().textureUnits);
        most = std::max(most, samplers);
        glGetProgramiv(name, GL_ACTIVE_UNIFORM_BLOCKS, &blocks);
        EXPECT_LE(blocks, GlLimits().uniformBlocks);
        for (GLint i = 0; i < blocks; ++i) {
            GLint bytes = 0;
            glGetActiveUniformBlockiv(name, GLuint(i), GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
            EXPECT_LE(bytes, GlLimits().uniformBlockBytes);
        }
    }
    EXPECT_GT(programs, 25) << "some programs were not built";
    std::printf("%d programs, at most %d samplers\n", programs, most);
}

TEST_F(LimitsTest, TheTownLooksTheSame) {
    std::vector<FloatImage> images;
    for (const auto& limits : {std::optional<GlLimits>(), std::optional<GlLimits>(GlLimits())})
        images.push_back(drawTown(*makeRenderer(limits)));
    const double difference = flip(images[0], images[1]);
    EXPECT_LT(difference, 0.01);
    EXPECT_TRUE(m_lines.empty()) << m_lines.front();
    std::printf("FLIP %.5f\n", difference);
}

/// OpenGL ES 3.0, as in browsers, with the same shaders: every program builds, and the image is the same.
TEST_F(LimitsTest, OpenGlEsDrawsTheSame) {
    const FloatImage desktop = drawTown(*makeRenderer(GlLimits()));
    auto embedded = GlContext::create(GlContext::Kind::EglEs);
    ASSERT_TRUE(embedded) << embedded.error();
    FloatImage image;
    {
        const auto renderer = makeRenderer({}, true, **embedded);
        ASSERT_TRUE(isEmbedded());
        image = drawTown(*renderer);
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
    }
    EXPECT_LT(flip(desktop, image), 0.01);
    EXPECT_TRUE(m_lines.empty()) << m_lines.front();
    embedded->reset();
    testContext().makeCurrent();
    ASSERT_TRUE(loadGl(testContext().loader()));
    EXPECT_FALSE(isEmbedded());
}

/// Where even the shared textures are too small, what has no room is left out, said once, and nothing is read or
/// written beyond.
TEST_F(LimitsTest, WhatHasNoRoomIsLeftOutAndSaid) {
    for (const int layers : {1, 4, 16}) {
        GlLimits tiny;
        tiny.textureSide = 64;
        tiny.arrayLayers = layers;
        m_lines.clear();
        const auto renderer = makeRenderer(tiny);
        const Offscreen target(kSize);
        renderer->apply(streetScene().snapshot());
        for (int i = 0; i < 3; ++i) renderer->draw(streetCamera(0).view(kSize, target.framebuffer()), 1.0f);
        EXPECT_EQ(renderer->lastError(), "");
        EXPECT_FALSE(m_lines.empty()) << "with " << layers << " layers";
        for (const std::string& line : m_lines) EXPECT_EQ(std::count(m_lines.begin(), m_lines.end(), line), 1) << line;
    }
}

}  // namespace
}  // namespace rubble::reference
