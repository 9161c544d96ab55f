// The renderer between a host's own draws: what the host has set does not change the image, and stays set.
#include <functional>

#include "render/gl/state_guard.h"
#include "tests/golden/compare.h"
#include "tests/golden/drawing.h"
#include "tests/render/gl_calls.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(64, 48);

GLuint makeBuffer(GLsizeiptr bytes) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, bytes, nullptr, GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    return buffer;
}

/// Something that a host may have set.
struct Hostile {
    const char* name;
    void (*set)();
};
const Hostile kHostile[] = {
    {"wireframe", [] { glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); }},
    {"rasterizer discard", [] { glEnable(GL_RASTERIZER_DISCARD); }},
    {"a logic operation",
     [] {
         glEnable(GL_COLOR_LOGIC_OP);
         glLogicOp(GL_XOR);
     }},
    {"an origin at the upper left, and depths from 0",
     [] {
         if (GLAD_GL_ARB_clip_control) glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
     }},
    {"reversed depth", [] { glDepthRange(1.0, 0.25); }},
    {"a polygon offset",
     [] {
         glEnable(GL_POLYGON_OFFSET_FILL);
         glPolygonOffset(-4.0f, -4000.0f);
     }},
    {"tests and culling",
     [] {
         for (const GLenum each : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DEPTH_TEST, GL_CULL_FACE}) glEnable(each);
         glScissor(3, 4, 5, 6);
         glStencilFunc(GL_NEVER, 1, 255);
         glDepthFunc(GL_NEVER);
         glDepthMask(GL_FALSE);
         glFrontFace(GL_CW);
         glCullFace(GL_FRONT_AND_BACK);
     }},
    {"masks and blending of single targets",
     [] {
         for (GLuint i = 0; i < 8; ++i) {
             glColorMaski(i, i % 2 ? GL_TRUE : GL_FALSE, GL_FALSE, GL_TRUE, GL_FALSE);
             i % 3 ? glEnablei(GL_BLEND, i) : glDisablei(GL_BLEND, i);
             if (GLAD_GL_ARB_draw_buffers_blend) glBlendFuncSeparateiARB(i, GL_DST_COLOR, GL_ZERO, GL_ZERO, GL_ONE);
         }
     }},
    {"coverage from a mask",
     [] {
         glEnable(GL_SAMPLE_MASK);
         glSampleMaski(0, 0);
         glEnable(GL_SAMPLE_COVERAGE);
         glSampleCoverage(0.0f, GL_FALSE);
         glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
     }},
    {"clip planes and clamped depth",
     [] {
         for (GLenum i = 0; i < 8; ++i) glEnable(GL_CLIP_DISTANCE0 + i);
         glEnable(GL_DEPTH_CLAMP);
     }},
    {"parts of larger images to upload",
     [] {
         glPixelStorei(GL_UNPACK_SKIP_PIXELS, 1000);
         glPixelStorei(GL_UNPACK_SKIP_ROWS, 1000);
         glPixelStorei(GL_UNPACK_SKIP_IMAGES, 100);
         glPixelStorei(GL_UNPACK_ROW_LENGTH, 5000);
         glPixelStorei(GL_UNPACK_IMAGE_HEIGHT, 5000);
         glPixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE);
         glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
     }},
    {"pixels from and to buffers",
     [] {
         glBindBuffer(GL_PIXEL_UNPACK_BUFFER, makeBuffer(64));
         glBindBuffer(GL_COPY_READ_BUFFER, makeBuffer(64));
         glBindBuffer(GL_COPY_WRITE_BUFFER, makeBuffer(64));
     }},
    {"a range of a uniform buffer", [] { glBindBufferRange(GL_UNIFORM_BUFFER, 0, makeBuffer(4096), 1024, 256); }},
    {"textures and samplers",
     [] {
         GLuint sampler = 0, textures[2] = {};
         glGenSamplers(1, &sampler);
         glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
         glGenTextures(2, textures);
         for (GLuint i = 0; i < GLuint(kTextureUnits); ++i) {
             glActiveTexture(GL_TEXTURE0 + i);
             glBindSampler(i, sampler);
             glBindTexture(GL_TEXTURE_2D, textures[0]);
             glBindTexture(GL_TEXTURE_2D_ARRAY, textures[1]);
         }
         glActiveTexture(GL_TEXTURE5);
     }},
    {"several viewports",
     [] {
         if (!GLAD_GL_ARB_viewport_array) return;
         for (GLuint i = 0; i < 4; ++i) {
             glViewportIndexedf(i, 1.5f, 2.0f, 3.0f + float(i), 4.0f);
             glDepthRangeIndexed(i, 0.5, 0.25 * i);
             glEnablei(GL_SCISSOR_TEST, i);
             glScissorIndexed(i, 1, 2, 3 + GLint(i), 4);
         }
     }},
};

/// All that the renderer may change, and the parts of arrays that it must not.
std::vector<double> stateNow() {
    std::vector<double> all;
    const GlState s = GlState::current();
    for (const GLint each : {s.drawFramebuffer,
                             s.readFramebuffer,
                             s.program,
                             s.vertexArray,
                             s.arrayBuffer,
                             s.copyReadBuffer,
                             s.copyWriteBuffer,
                             s.unpackBuffer,
                             s.uniformBuffer,
                             s.uniformBuffer0,
                             s.activeTexture,
                             s.polygonMode[0],
                             s.clipOrigin,
                             s.clipDepth,
                             s.cullFace,
                             s.frontFace,
                             s.depthFunc,
                             GLint(s.depthMask),
                             GLint(s.scissorTest),
                             GLint(s.blend.source),
                             GLint(s.blend.destination),
                             GLint(s.blend.sourceAlpha),
                             GLint(s.blend.destinationAlpha),
                             GLint(s.blend.equation),
                             GLint(s.blend.equationAlpha)})
        all.push_back(each);
    for (const double each : {double(s.uniformStart0), double(s.uniformSize0), s.depthRange[0], s.depthRange[1]})
        all.push_back(each);
    for (const GLfloat each : *s.viewport) all.push_back(each);
    for (const GLint each : *s.scissor) all.push_back(each);
    for (const GLboolean each : s.switches) all.push_back(each);
    for (const GLint each : s.unpack) all.push_back(each);
    for (const bool shared : {false, true})
        for (const GlState::Unit& unit : GlState::current({.sharedTexels = shared}).units)
            for (const GLint each : {unit.texture2D, unit.array, unit.buffer, unit.sampler}) all.push_back(each);
    for (GLuint i = 0; i < 8; ++i) {
        GLboolean mask[4] = {};
        glGetBooleani_v(GL_COLOR_WRITEMASK, i, mask);
        for (const GLboolean each : mask) all.push_back(each);
        all.push_back(glIsEnabledi(GL_BLEND, i));
        GLint source = 0;
        if (GLAD_GL_ARB_draw_buffers_blend) glGetIntegeri_v(GL_BLEND_SRC_RGB, i, &source);
        all.push_back(source);
    }
    for (GLuint i = 0; i < 4 && GLAD_GL_ARB_viewport_array; ++i) {
        GLfloat viewport[4] = {};
        GLdouble depths[2] = {};
        glGetFloati_v(GL_VIEWPORT, i, viewport);
        glGetDoublei_v(GL_DEPTH_RANGE, i, depths);
        GLint scissor[4] = {};
        glGetIntegeri_v(GL_SCISSOR_BOX, i, scissor);
        for (const GLfloat each : viewport) all.push_back(each);
        for (const GLint each : scissor) all.push_back(each);
        for (const GLdouble each : depths) all.push_back(each);
        all.push_back(glIsEnabledi(GL_SCISSOR_TEST, i));
    }
    return all;
}

class HostStateTest : public Drawing, public testing::WithParamInterface<size_t> {
protected:
    void TearDown() override {
        GlState().set();
        for (GLuint i = 0; i < 8; ++i) {
            glColorMaski(i, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
            glDisablei(GL_BLEND, i);
        }
        glBlendFunc(GL_ONE, GL_ZERO);
        glDepthRange(0.0, 1.0);
        glDisable(GL_SCISSOR_TEST);
        Drawing::TearDown();
    }
    /// The street with water, which is drawn in a part of the view.
    static FrameSnapshot wetStreet() {
        FrameSnapshot snapshot = streetScene().snapshot();
        Water water;
        water.outline = {{-2.0, 0.0}, {1.0, 0.0}, {1.0, 3.0}, {-2.0, 3.0}};
        water.surface = 0.2;
        snapshot.waters = {water};
        snapshot.watersChanged = true;
        return snapshot;
    }
    void startWet(const RenderSettings& settings = {}) {
        start(streetScene(), kSize, settings);
        renderer->apply(wetStreet());
    }
    /// The street from a cut on.
    void drawStreet() {
        View view = streetCamera(0).view(kSize, target->framebuffer());
        view.cut = true;
        renderer->draw(view, 1.0f);
    }
    std::vector<uint8_t> imageAfter(const std::function<void()>& set) {
        startWet();
        set();
        drawStreet();
        GlState().set();
        for (const GLenum each : {GL_PACK_SWAP_BYTES, GL_PACK_SKIP_ROWS}) glPixelStorei(each, 0);
        return target->readRgb();
    }
};

TEST_P(HostStateTest, NeitherChangesTheImageNorIsChanged) {
    const Hostile& hostile = kHostile[GetParam()];
    const std::vector<uint8_t> plain = imageAfter([] {});
    std::vector<double> before;
    startWet();
    hostile.set();
    before = stateNow();
    drawStreet();
    EXPECT_EQ(stateNow(), before) << hostile.name << ": the host's state is not restored";
    GlState().set();
    EXPECT_EQ(target->readRgb(), plain) << hostile.name << " changes the image";
}

TEST_P(HostStateTest, IsThatOfANewContextWhereTheHostWantsThat) {
    const Hostile& hostile = kHostile[GetParam()];
    const std::vector<uint8_t> plain = imageAfter([] {});
    RenderSettings settings;
    settings.hostState = HostState::Reset;
    startWet(settings);
    hostile.set();
    drawStreet();
    const GlState after = GlState::current(), fresh;
    EXPECT_EQ(after.switches, fresh.switches) << hostile.name;
    EXPECT_EQ(after.blends, fresh.blends) << hostile.name;
    EXPECT_EQ(after.colorMasks, fresh.colorMasks) << hostile.name;
    EXPECT_EQ(after.unpack, fresh.unpack) << hostile.name;
    EXPECT_EQ(after.depthFunc, fresh.depthFunc) << hostile.name;
    EXPECT_EQ(after.program, 0) << hostile.name;
    for (const GlState::Unit& unit : after.units)
        EXPECT_EQ(unit.texture2D + unit.buffer + unit.sampler, 0) << hostile.name;
    EXPECT_EQ(target->readRgb(), plain) << hostile.name << " changes the image";
}

INSTANTIATE_TEST_SUITE_P(Each, HostStateTest, testing::Range(size_t(0), std::size(kHostile)));

/// What the GL is asked in a draw. The first question after a draw makes a driver wait that works on a thread.
struct Questions {
    GlCalls<&glad_glGetIntegerv> integers;
    GlCalls<&glad_glGetIntegeri_v> indexedIntegers;
    GlCalls<&glad_glGetInteger64i_v> longs;
    GlCalls<&glad_glGetBooleanv> booleans;
    GlCalls<&glad_glGetBooleani_v> indexedBooleans;
    GlCalls<&glad_glGetFloatv> floats;
    GlCalls<&glad_glGetDoublev> doubles;
    GlCalls<&glad_glIsEnabled> switches;
    GlCalls<&glad_glIsEnabledi> indexedSwitches;
    GlCalls<&glad_glGetTexLevelParameteriv> textures;
    GlCalls<&glad_glGetBufferParameteri64v> buffers;
    GlCalls<&glad_glCheckFramebufferStatus> framebuffers;
    GlCalls<&glad_glIsFramebuffer> names;
    GlCalls<&glad_glGetProgramiv> programs;
    GlCalls<&glad_glGetError> errors;
    GlCalls<&glad_glFinish> waits;
    int count() const {
        return integers.count() + indexedIntegers.count() + longs.count() + booleans.count() + indexedBooleans.count() +
               floats.count() + doubles.count() + switches.count() + indexedSwitches.count() + textures.count() +
               buffers.count() + framebuffers.count() + names.count() + programs.count() + errors.count() +
               waits.count();
    }
};

class QuestionsTest : public Drawing {
protected:
    int questionsOfADraw(HostState hostState) {
        RenderSettings settings;
        settings.hostState = hostState;
        start(streetScene(), kSize, settings);
        draw(streetCamera(0), 3);
        const View view = streetCamera(0).view(kSize, target->framebuffer());
        const Questions questions;
        renderer->draw(view, 1.0f);
        return questions.count();
    }
};

TEST_F(QuestionsTest, AreNotAskedWhereTheHostTakesAResetState) {
    EXPECT_EQ(questionsOfADraw(HostState::Reset), 0);
}

TEST_F(QuestionsTest, AreLimitedWhereTheStateIsRestored) {
    const int count = questionsOfADraw(HostState::Restored);
    EXPECT_LE(count, 175);
    RecordProperty("questions", count);
    std::printf("%d questions a draw\n", count);
}

}  // namespace
}  // namespace rubble
