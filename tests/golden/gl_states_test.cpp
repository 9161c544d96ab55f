// Each state that core 3.3 and compatibility contexts have, set to something else one at a time: the image is the same,
// and the state is as it was.
#include <functional>
#include <map>

#include "samples/support/osmesa_context.h"
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(48, 32);

/// A state: something that a host may set, and the value of a new context.
struct State {
    std::string name;
    std::function<void()> set, reset;
};

constexpr GLenum kSwitches[] = {GL_BLEND,
                                GL_CLIP_DISTANCE0,
                                GL_CLIP_DISTANCE1,
                                GL_CLIP_DISTANCE2,
                                GL_CLIP_DISTANCE3,
                                GL_CLIP_DISTANCE4,
                                GL_CLIP_DISTANCE5,
                                GL_COLOR_LOGIC_OP,
                                GL_CULL_FACE,
                                GL_DEPTH_CLAMP,
                                GL_DEPTH_TEST,
                                GL_DITHER,
                                GL_FRAMEBUFFER_SRGB,
                                GL_LINE_SMOOTH,
                                GL_MULTISAMPLE,
                                GL_POLYGON_OFFSET_FILL,
                                GL_POLYGON_OFFSET_LINE,
                                GL_POLYGON_OFFSET_POINT,
                                GL_POLYGON_SMOOTH,
                                GL_PRIMITIVE_RESTART,
                                GL_PROGRAM_POINT_SIZE,
                                GL_RASTERIZER_DISCARD,
                                GL_SAMPLE_ALPHA_TO_COVERAGE,
                                GL_SAMPLE_ALPHA_TO_ONE,
                                GL_SAMPLE_COVERAGE,
                                GL_SAMPLE_MASK,
                                GL_SCISSOR_TEST,
                                GL_STENCIL_TEST,
                                GL_TEXTURE_CUBE_MAP_SEAMLESS};
/// GL_ALPHA_TEST, _POLYGON_STIPPLE, _LINE_STIPPLE, _FOG, _LIGHTING, _COLOR_MATERIAL, _NORMALIZE, _TEXTURE_2D,
/// _COLOR_SUM, _VERTEX_PROGRAM_TWO_SIDE, _POINT_SPRITE, _POINT_SMOOTH, _INDEX_LOGIC_OP, _AUTO_NORMAL, _RESCALE_NORMAL.
constexpr GLenum kOldSwitches[] = {0x0BC0, 0x0B42, 0x0B24, 0x0B60, 0x0B50, 0x0B57, 0x0BA1, 0x0DE1,
                                   0x8458, 0x8643, 0x8861, 0x0B10, 0x0BF1, 0x0D80, 0x803A};
/// What glGet answers beside switches: values, then bindings.
constexpr GLenum kValues[] = {GL_BLEND_COLOR,
                              GL_BLEND_SRC_RGB,
                              GL_BLEND_DST_RGB,
                              GL_BLEND_SRC_ALPHA,
                              GL_BLEND_DST_ALPHA,
                              GL_BLEND_EQUATION_RGB,
                              GL_BLEND_EQUATION_ALPHA,
                              GL_CLAMP_READ_COLOR,
                              GL_COLOR_CLEAR_VALUE,
                              GL_COLOR_WRITEMASK,
                              GL_CULL_FACE_MODE,
                              GL_DEPTH_CLEAR_VALUE,
                              GL_DEPTH_FUNC,
                              GL_DEPTH_RANGE,
                              GL_DEPTH_WRITEMASK,
                              GL_FRAGMENT_SHADER_DERIVATIVE_HINT,
                              GL_FRONT_FACE,
                              GL_LINE_SMOOTH_HINT,
                              GL_LINE_WIDTH,
                              GL_LOGIC_OP_MODE,
                              GL_PACK_ALIGNMENT,
                              GL_PACK_ROW_LENGTH,
                              GL_PACK_SKIP_PIXELS,
                              GL_PACK_SKIP_ROWS,
                              GL_PACK_SWAP_BYTES,
                              GL_POINT_FADE_THRESHOLD_SIZE,
                              GL_POINT_SIZE,
                              GL_POLYGON_MODE,
                              GL_POLYGON_OFFSET_FACTOR,
                              GL_POLYGON_OFFSET_UNITS,
                              GL_POLYGON_SMOOTH_HINT,
                              GL_PRIMITIVE_RESTART_INDEX,
                              GL_PROVOKING_VERTEX,
                              GL_SAMPLE_COVERAGE_INVERT,
                              GL_SAMPLE_COVERAGE_VALUE,
                              GL_SCISSOR_BOX,
                              GL_STENCIL_BACK_FAIL,
                              GL_STENCIL_BACK_FUNC,
                              GL_STENCIL_BACK_PASS_DEPTH_FAIL,
                              GL_STENCIL_BACK_PASS_DEPTH_PASS,
                              GL_STENCIL_BACK_REF,
                              GL_STENCIL_BACK_VALUE_MASK,
                              GL_STENCIL_BACK_WRITEMASK,
                              GL_STENCIL_CLEAR_VALUE,
                              GL_STENCIL_FAIL,
                              GL_STENCIL_FUNC,
                              GL_STENCIL_PASS_DEPTH_FAIL,
                              GL_STENCIL_PASS_DEPTH_PASS,
                              GL_STENCIL_REF,
                              GL_STENCIL_VALUE_MASK,
                              GL_STENCIL_WRITEMASK,
                              GL_TEXTURE_COMPRESSION_HINT,
                              GL_UNPACK_ALIGNMENT,
                              GL_UNPACK_IMAGE_HEIGHT,
                              GL_UNPACK_ROW_LENGTH,
                              GL_UNPACK_SKIP_IMAGES,
                              GL_UNPACK_SKIP_PIXELS,
                              GL_UNPACK_SKIP_ROWS,
                              GL_UNPACK_SWAP_BYTES,
                              GL_VIEWPORT,
                              GL_ACTIVE_TEXTURE,
                              GL_ARRAY_BUFFER_BINDING,
                              GL_COPY_READ_BUFFER,
                              GL_COPY_WRITE_BUFFER,
                              GL_CURRENT_PROGRAM,
                              GL_DRAW_FRAMEBUFFER_BINDING,
                              GL_PIXEL_PACK_BUFFER_BINDING,
                              GL_PIXEL_UNPACK_BUFFER_BINDING,
                              GL_READ_FRAMEBUFFER_BINDING,
                              GL_RENDERBUFFER_BINDING,
                              GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
                              GL_UNIFORM_BUFFER_BINDING,
                              GL_VERTEX_ARRAY_BINDING};
/// GL_ALPHA_TEST_FUNC, _ALPHA_TEST_REF, _SHADE_MODEL, _CLAMP_FRAGMENT_COLOR, _CLAMP_VERTEX_COLOR, _MAP_COLOR, and from
/// _RED_SCALE to _DEPTH_BIAS.
constexpr GLenum kFilterControl = 0x8500;  ///< GL_TEXTURE_FILTER_CONTROL
constexpr GLenum kOldValues[] = {0x0BC1, 0x0BC2, 0x0B54, 0x891B, 0x891A, 0x0D10, 0x0D14, 0x0D15,
                                 0x0D18, 0x0D19, 0x0D1A, 0x0D1B, 0x0D1C, 0x0D1D, 0x0D1E, 0x0D1F};
/// Bindings of ranges of buffers: what answers for a number, and how many numbers GL 3.3 promises.
struct RangeBindings {
    GLenum target, name, start, size;
    GLuint count;
};
constexpr RangeBindings kRanges[] = {
    {GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE, 36},
    {GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, GL_TRANSFORM_FEEDBACK_BUFFER_START,
     GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, 4}};
constexpr GLenum kTextures[] = {
    GL_TEXTURE_1D,       GL_TEXTURE_2D,        GL_TEXTURE_3D,       GL_TEXTURE_1D_ARRAY,
    GL_TEXTURE_2D_ARRAY, GL_TEXTURE_RECTANGLE, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_2D_MULTISAMPLE};
constexpr GLenum kTextureBindings[] = {GL_TEXTURE_BINDING_1D,       GL_TEXTURE_BINDING_2D,
                                       GL_TEXTURE_BINDING_3D,       GL_TEXTURE_BINDING_1D_ARRAY,
                                       GL_TEXTURE_BINDING_2D_ARRAY, GL_TEXTURE_BINDING_RECTANGLE,
                                       GL_TEXTURE_BINDING_CUBE_MAP, GL_TEXTURE_BINDING_2D_MULTISAMPLE,
                                       GL_TEXTURE_BINDING_BUFFER,   GL_SAMPLER_BINDING};

std::vector<State> coreStates() {
    std::vector<State> all;
    const auto add = [&](std::string name, auto set, auto reset) { all.push_back({std::move(name), set, reset}); };
    for (const GLenum each : kSwitches) {
        const bool isOn = glIsEnabled(each);
        const auto turn = [each](bool on) { on ? glEnable(each) : glDisable(each); };
        add(
            "switch " + std::to_string(each), [=] { turn(!isOn); }, [=] { turn(isOn); });
    }
    add(
        "blend colour", [] { glBlendColor(0.1f, 0.2f, 0.3f, 0.4f); }, [] { glBlendColor(0, 0, 0, 0); });
    add(
        "blend function", [] { glBlendFuncSeparate(GL_ZERO, GL_ZERO, GL_ONE, GL_DST_ALPHA); },
        [] { glBlendFunc(GL_ONE, GL_ZERO); });
    add(
        "blend equation", [] { glBlendEquation(GL_FUNC_REVERSE_SUBTRACT); }, [] { glBlendEquation(GL_FUNC_ADD); });
    add(
        "clear values", [] { glClearColor(1, 0, 1, 0), glClearDepth(0.3), glClearStencil(7); },
        [] { glClearColor(0, 0, 0, 0), glClearDepth(1.0), glClearStencil(0); });
    add(
        "clamped reads", [] { glClampColor(GL_CLAMP_READ_COLOR, GL_TRUE); },
        [] { glClampColor(GL_CLAMP_READ_COLOR, GL_FIXED_ONLY); });
    add(
        "colour mask", [] { glColorMask(0, 1, 0, 0); }, [] { glColorMask(1, 1, 1, 1); });
    add(
        "culled face", [] { glCullFace(GL_FRONT_AND_BACK); }, [] { glCullFace(GL_BACK); });
    add(
        "front face", [] { glFrontFace(GL_CW); }, [] { glFrontFace(GL_CCW); });
    add(
        "depth function", [] { glDepthFunc(GL_NEVER); }, [] { glDepthFunc(GL_LESS); });
    add(
        "depth mask", [] { glDepthMask(GL_FALSE); }, [] { glDepthMask(GL_TRUE); });
    add(
        "depth range", [] { glDepthRange(1.0, 0.25); }, [] { glDepthRange(0.0, 1.0); });
    for (const GLenum hint :
         {GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_TEXTURE_COMPRESSION_HINT, GL_FRAGMENT_SHADER_DERIVATIVE_HINT})
        add(
            "hint " + std::to_string(hint), [=] { glHint(hint, GL_FASTEST); }, [=] { glHint(hint, GL_DONT_CARE); });
    add(
        "line width", [] { glLineWidth(0.5f); }, [] { glLineWidth(1.0f); });
    add(
        "logic operation", [] { glLogicOp(GL_CLEAR); }, [] { glLogicOp(GL_COPY); });
    add(
        "point size", [] { glPointSize(5.0f); }, [] { glPointSize(1.0f); });
    add(
        "points", [] { glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT); },
        [] { glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_UPPER_LEFT); });
    add(
        "polygon mode", [] { glPolygonMode(GL_FRONT_AND_BACK, GL_POINT); },
        [] { glPolygonMode(GL_FRONT_AND_BACK, GL_FILL); });
    add(
        "polygon offset", [] { glPolygonOffset(9.0f, 9000.0f); }, [] { glPolygonOffset(0, 0); });
    add(
        "restart index", [] { glPrimitiveRestartIndex(1); }, [] { glPrimitiveRestartIndex(0); });
    add(
        "provoking vertex", [] { glProvokingVertex(GL_FIRST_VERTEX_CONVENTION); },
        [] { glProvokingVertex(GL_LAST_VERTEX_CONVENTION); });
    add(
        "sample coverage", [] { glSampleCoverage(0.0f, GL_TRUE); }, [] { glSampleCoverage(1.0f, GL_FALSE); });
    add(
        "sample mask", [] { glSampleMaski(0, 0); }, [] { glSampleMaski(0, ~0u); });
    add(
        "scissor", [] { glScissor(1, 2, 3, 4); }, [] { glScissor(0, 0, 16, 16); });
    add(
        "stencil function", [] { glStencilFunc(GL_NEVER, 1, 2); }, [] { glStencilFunc(GL_ALWAYS, 0, ~0u); });
    add(
        "stencil mask", [] { glStencilMask(0); }, [] { glStencilMask(~0u); });
    add(
        "stencil operation", [] { glStencilOp(GL_ZERO, GL_ZERO, GL_INVERT); },
        [] { glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP); });
    add(
        "stencil function of back faces", [] { glStencilFuncSeparate(GL_BACK, GL_NEVER, 1, 2); },
        [] { glStencilFuncSeparate(GL_BACK, GL_ALWAYS, 0, ~0u); });
    add(
        "stencil mask of back faces", [] { glStencilMaskSeparate(GL_BACK, 5); },
        [] { glStencilMaskSeparate(GL_BACK, ~0u); });
    add(
        "stencil operation of back faces", [] { glStencilOpSeparate(GL_BACK, GL_ZERO, GL_INCR, GL_INVERT); },
        [] { glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_KEEP); });
    add(
        "viewport", [] { glViewport(1, 2, 3, 4); }, [] { glViewport(0, 0, 16, 16); });
    for (const GLenum each : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_SWAP_BYTES,
                              GL_UNPACK_ROW_LENGTH, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS,
                              GL_UNPACK_SKIP_IMAGES, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST, GL_PACK_LSB_FIRST})
        add(
            "pixels " + std::to_string(each), [=] { glPixelStorei(each, 1); }, [=] { glPixelStorei(each, 0); });
    for (const GLenum each : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT})
        add(
            "pixels " + std::to_string(each), [=] { glPixelStorei(each, 8); }, [=] { glPixelStorei(each, 4); });
    for (const GLenum each :
         {GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_PIXEL_PACK_BUFFER, GL_PIXEL_UNPACK_BUFFER,
          GL_TEXTURE_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER, GL_UNIFORM_BUFFER}) {
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBuffer(each, buffer);
        glBufferData(each, 64, nullptr, GL_STATIC_DRAW);
        glBindBuffer(each, 0);
        add(
            "buffer " + std::to_string(each), [=] { glBindBuffer(each, buffer); }, [=] { glBindBuffer(each, 0); });
    }
    for (const GLenum each : kTextures) {
        GLuint texture = 0;
        glGenTextures(1, &texture);
        const auto bind = [=](GLuint bound) {
            for (GLuint unit = 0; unit < 40; ++unit) glActiveTexture(GL_TEXTURE0 + unit), glBindTexture(each, bound);
            glActiveTexture(GL_TEXTURE0);
        };
        add(
            "texture " + std::to_string(each), [=] { bind(texture); }, [=] { bind(0); });
    }
    for (const RangeBindings& each : kRanges) {
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBuffer(each.target, buffer);
        glBufferData(each.target, 65536, nullptr, GL_STATIC_DRAW);
        add(
            "ranges of buffer " + std::to_string(each.target),
            [=] {
                for (GLuint i = 0; i < each.count; ++i)
                    glBindBufferRange(each.target, i, buffer, GLintptr(256 * i), GLsizeiptr(64 + 16 * i));
            },
            [=] {
                for (GLuint i = 0; i < each.count; ++i) glBindBufferBase(each.target, i, 0);
            });
    }
    add(
        "active texture", [] { glActiveTexture(GL_TEXTURE7); }, [] { glActiveTexture(GL_TEXTURE0); });
    GLuint sampler = 0, biased = 0, biasedTexture = 0, renderbuffer = 0, array = 0;
    glGenSamplers(1, &sampler), glGenRenderbuffers(1, &renderbuffer), glGenVertexArrays(1, &array);
    const auto bindSampler = [](GLuint bound) {
        for (GLuint unit = 0; unit < 40; ++unit) glBindSampler(unit, bound);
    };
    add(
        "sampler", [=] { bindSampler(sampler); }, [=] { bindSampler(0); });
    glGenSamplers(1, &biased), glGenTextures(1, &biasedTexture);
    glSamplerParameterf(biased, GL_TEXTURE_LOD_BIAS, 3.0f);
    add(
        "level of detail bias of samplers", [=] { bindSampler(biased); }, [=] { bindSampler(0); });
    glBindTexture(GL_TEXTURE_2D, biasedTexture);
    glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, 3.0f);
    const auto bindTexture = [](GLuint bound) {
        for (GLuint unit = 0; unit < 40; ++unit)
            glActiveTexture(GL_TEXTURE0 + unit), glBindTexture(GL_TEXTURE_2D, bound);
        glActiveTexture(GL_TEXTURE0);
    };
    bindTexture(0);
    add(
        "level of detail bias of textures", [=] { bindTexture(biasedTexture); }, [=] { bindTexture(0); });
    add(
        "renderbuffer", [=] { glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer); },
        [] { glBindRenderbuffer(GL_RENDERBUFFER, 0); });
    add(
        "vertex array", [=] { glBindVertexArray(array); }, [] { glBindVertexArray(0); });
    return all;
}

template <class... A>
auto oldFunction(const char* name) {
    return reinterpret_cast<void (*)(A...)>(testContext().loader()(name));
}

/// What only compatibility profiles have.
std::vector<State> compatibilityStates() {
    std::vector<State> all;
    const auto add = [&](std::string name, auto set, auto reset) { all.push_back({std::move(name), set, reset}); };
    const auto alpha = oldFunction<GLenum, GLfloat>("glAlphaFunc");
    const auto stipple = oldFunction<const GLubyte*>("glPolygonStipple");
    const auto transfer = oldFunction<GLenum, GLfloat>("glPixelTransferf");
    const auto shade = oldFunction<GLenum>("glShadeModel");
    const auto environment = oldFunction<GLenum, GLenum, GLfloat>("glTexEnvf");
    constexpr GLenum kNever = GL_NEVER, kFlat = 0x1D00, kSmooth = 0x1D01;
    alpha(kNever, 0.5f);
    static const GLubyte kNothing[128] = {};
    stipple(kNothing);
    for (const GLenum each : kOldSwitches)
        add(
            "switch " + std::to_string(each), [=] { glEnable(each); }, [=] { glDisable(each); });
    const auto setBias = [=](float bias) {
        for (GLuint unit = 0; unit < 40; ++unit)
            glActiveTexture(GL_TEXTURE0 + unit), environment(kFilterControl, GL_TEXTURE_LOD_BIAS, bias);
        glActiveTexture(GL_TEXTURE0);
    };
    add(
        "level of detail bias of units", [=] { setBias(3.0f); }, [=] { setBias(0.0f); });
    add(
        "shade model", [=] { shade(kFlat); }, [=] { shade(kSmooth); });
    for (const GLenum each : {0x891Bu, 0x891Au})
        add(
            "clamp " + std::to_string(each), [=] { glClampColor(each, GL_TRUE); },
            [=] { glClampColor(each, GL_FIXED_ONLY); });
    for (size_t i = 6; i < std::size(kOldValues); ++i)
        add(
            "pixel transfer " + std::to_string(kOldValues[i]), [=] { transfer(kOldValues[i], 0.25f); },
            [=] { transfer(kOldValues[i], i % 2 == 0 ? 1.0f : 0.0f); });
    return all;
}

std::map<std::string, std::vector<double>> stateNow() {
    std::map<std::string, std::vector<double>> all;
    const auto ask = [&](GLenum name) {
        std::vector<double> values(16);
        glGetDoublev(name, values.data());
        all["value " + std::to_string(name)] = values;
    };
    const auto askSwitch = [&](GLenum name) { all["switch " + std::to_string(name)] = {double(glIsEnabled(name))}; };
    for (const GLenum each : kSwitches) askSwitch(each);
    for (const GLenum each : kValues) ask(each);
    if (isCompatibility())
        for (const GLenum each : kOldSwitches) askSwitch(each);
    if (isCompatibility())
        for (const GLenum each : kOldValues) ask(each);
    for (const RangeBindings& each : kRanges)
        for (GLuint i = 0; i < each.count; ++i) {
            GLint name = 0;
            GLint64 start = 0, size = 0;
            glGetIntegeri_v(each.name, i, &name);
            glGetInteger64i_v(each.start, i, &start), glGetInteger64i_v(each.size, i, &size);
            all["range " + std::to_string(i) + " of " + std::to_string(each.target)] = {double(name), double(start),
                                                                                        double(size)};
        }
    GLint active = 0;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLuint unit = 0; unit < 40; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        std::vector<double>& bound = all["unit " + std::to_string(unit)];
        for (const GLenum each : kTextureBindings) {
            GLint name = 0;
            glGetIntegerv(each, &name);
            bound.push_back(name);
        }
        GLfloat bias = 0.0f;
        if (isCompatibility())
            oldFunction<GLenum, GLenum, GLfloat*>("glGetTexEnvfv")(kFilterControl, GL_TEXTURE_LOD_BIAS, &bias);
        bound.push_back(double(bias));
    }
    glActiveTexture(GLenum(active));
    return all;
}

class GlStatesTest : public Drawing {
protected:
    void expectKept(const std::vector<State>& states) {
        LitScene street = streetScene();
        street.environment.fogDensity = 0.02f;
        start(street, kSize);
        FrameSnapshot snapshot = street.snapshot();
        const std::vector<glm::dvec3> rope = {{-4.0, 3.0, -5.0}, {0.0, 1.0, -6.0}, {4.0, 3.0, -5.0}};
        snapshot.ropes.push_back({JointHandle::make(1, 1, 0), rope, rope, 0.1f, glm::vec3(0.7f, 0.5f, 0.3f)});
        snapshot.ropesChanged = true;
        renderer->apply(std::move(snapshot));
        const std::vector<uint8_t> plain = drawn();
        for (const State& state : states) {
            state.set();
            const auto before = stateNow();
            drawOnly();
            const auto after = stateNow();
            state.reset();
            for (const auto& [name, values] : before)
                EXPECT_EQ(after.at(name), values) << name << " is not restored after " << state.name;
            EXPECT_EQ(target->readRgb(), plain) << state.name << " changes the image";
            ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << state.name;
        }
        renderer.reset();
        target.reset();
    }

private:
    void drawOnly() {
        View view = streetCamera(0).view(kSize, target->framebuffer());
        view.cut = true;
        renderer->draw(view, 1.0f);
    }
    std::vector<uint8_t> drawn() {
        drawOnly();
        return target->readRgb();
    }
};

TEST_F(GlStatesTest, OfCoreChangeNothingAndAreKept) {
    expectKept(coreStates());
}

TEST_F(GlStatesTest, OfCompatibilityChangeNothingAndAreKept) {
    auto compatibility = OsMesaContext::create(OsMesaContext::Profile::Compatibility);
    if (!compatibility || !loadGl(compatibility.value()->loader()) || !isCompatibility()) {
        testContext().makeCurrent();
        GTEST_SKIP() << "no compatibility profile of OpenGL 3.3";
    }
    expectKept(coreStates());
    expectKept(compatibilityStates());
    compatibility.value().reset();
    testContext().makeCurrent();
    ASSERT_TRUE(loadGl(testContext().loader()));
}

}  // namespace
}  // namespace rubble
