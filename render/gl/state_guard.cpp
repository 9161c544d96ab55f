#include "render/gl/state_guard.h"

namespace rubble {
namespace {

GLint asked(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void setSwitch(GLenum name, bool on) {
    on ? glEnable(name) : glDisable(name);
}

void askBindings(GlState& s) {
    s.drawFramebuffer = asked(GL_DRAW_FRAMEBUFFER_BINDING);
    s.readFramebuffer = asked(GL_READ_FRAMEBUFFER_BINDING);
    s.program = asked(GL_CURRENT_PROGRAM);
    s.vertexArray = asked(GL_VERTEX_ARRAY_BINDING);
    s.arrayBuffer = asked(GL_ARRAY_BUFFER_BINDING);
    s.copyReadBuffer = asked(GL_COPY_READ_BUFFER);
    s.copyWriteBuffer = asked(GL_COPY_WRITE_BUFFER);
    s.unpackBuffer = asked(GL_PIXEL_UNPACK_BUFFER_BINDING);
    s.uniformBuffer = asked(GL_UNIFORM_BUFFER_BINDING);
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 0, &s.uniformBuffer0);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_START, 0, &s.uniformStart0);
    glGetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, 0, &s.uniformSize0);
}

void askUnits(GlState& s, const GlUse& use) {
    s.activeTexture = asked(GL_ACTIVE_TEXTURE);
    s.unitCount = use.units;
    for (int i = 0; i < s.unitCount; ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + i));
        GlState::Unit& unit = s.units[size_t(i)];
        unit.texture2D = asked(GL_TEXTURE_BINDING_2D);
        unit.sampler = asked(GL_SAMPLER_BINDING);
        unit.array = use.sharedTexels ? asked(GL_TEXTURE_BINDING_2D_ARRAY) : GlState::kUntouched;
        unit.buffer = use.sharedTexels ? GlState::kUntouched : asked(GL_TEXTURE_BINDING_BUFFER);
    }
    glActiveTexture(GLenum(s.activeTexture));
}

void askImages(GlState& s) {
    s.images.emplace();
    for (GLuint i = 0; i < GlState::kImages; ++i) {
        ImageBinding& image = (*s.images)[i];
        glGetIntegeri_v(GL_IMAGE_BINDING_NAME, i, &image.name);
        glGetIntegeri_v(GL_IMAGE_BINDING_LEVEL, i, &image.level);
        glGetIntegeri_v(GL_IMAGE_BINDING_LAYERED, i, &image.layered);
        glGetIntegeri_v(GL_IMAGE_BINDING_LAYER, i, &image.layer);
        glGetIntegeri_v(GL_IMAGE_BINDING_ACCESS, i, &image.access);
        glGetIntegeri_v(GL_IMAGE_BINDING_FORMAT, i, &image.format);
    }
}

void askRasterizer(GlState& s) {
    s.polygonMode[1] = 0;  // GL writes one number or two
    glGetIntegerv(GL_POLYGON_MODE, s.polygonMode);
    if (GLAD_GL_ARB_clip_control) {
        s.clipOrigin = asked(GL_CLIP_ORIGIN);
        s.clipDepth = asked(GL_CLIP_DEPTH_MODE);
    }
    s.provokingVertex = asked(GL_PROVOKING_VERTEX);
    if (isCompatibility()) s.compatibility = CompatibilityState::current();
    s.cullFace = asked(GL_CULL_FACE_MODE);
    s.frontFace = asked(GL_FRONT_FACE);
    s.depthFunc = asked(GL_DEPTH_FUNC);
    glGetDoublev(GL_DEPTH_RANGE, s.depthRange);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &s.depthMask);
    s.scissorTest = glIsEnabled(GL_SCISSOR_TEST);
    glGetFloatv(GL_VIEWPORT, s.viewport.emplace().data());
    glGetIntegerv(GL_SCISSOR_BOX, s.scissor.emplace().data());
    s.blend = currentBlend();
    for (GLuint i = 0; i < GlState::kTargets; ++i) {
        s.blends[i] = glIsEnabledi(GL_BLEND, i);
        glGetBooleani_v(GL_COLOR_WRITEMASK, i, s.colorMasks[i].data());
    }
    for (size_t i = 0; i < s.switches.size(); ++i) s.switches[i] = glIsEnabled(GlState::kSwitches[i]);
    for (size_t i = 0; i < s.unpack.size(); ++i) s.unpack[i] = asked(GlState::kUnpack[i]);
}

void setUnits(const GlState& s) {
    for (int i = 0; i < s.unitCount; ++i) {
        const GlState::Unit& unit = s.units[size_t(i)];
        glActiveTexture(GLenum(GL_TEXTURE0 + i));
        glBindTexture(GL_TEXTURE_2D, GLuint(unit.texture2D));
        if (unit.array != GlState::kUntouched) glBindTexture(GL_TEXTURE_2D_ARRAY, GLuint(unit.array));
        if (unit.buffer != GlState::kUntouched) glBindTexture(GL_TEXTURE_BUFFER, GLuint(unit.buffer));
        glBindSampler(GLuint(i), GLuint(unit.sampler));
    }
    glActiveTexture(GLenum(s.activeTexture));
}

void setRasterizer(const GlState& s) {
    // Core contexts have one mode for both sides; others may have two.
    if (s.polygonMode[0] == s.polygonMode[1] || s.polygonMode[1] == 0)
        glPolygonMode(GL_FRONT_AND_BACK, GLenum(s.polygonMode[0]));
    else
        glPolygonMode(GL_FRONT, GLenum(s.polygonMode[0])), glPolygonMode(GL_BACK, GLenum(s.polygonMode[1]));
    if (GLAD_GL_ARB_clip_control) glClipControl(GLenum(s.clipOrigin), GLenum(s.clipDepth));
    glProvokingVertex(GLenum(s.provokingVertex));
    if (isCompatibility()) s.compatibility.set();
    glCullFace(GLenum(s.cullFace));
    glFrontFace(GLenum(s.frontFace));
    glDepthFunc(GLenum(s.depthFunc));
    setDepthRange(s.depthRange[0], s.depthRange[1]);
    glDepthMask(s.depthMask);
    setScissorTest(s.scissorTest);
    if (s.viewport) setViewport({(*s.viewport)[0], (*s.viewport)[1], (*s.viewport)[2], (*s.viewport)[3]});
    if (s.scissor) setScissor({(*s.scissor)[0], (*s.scissor)[1]}, {(*s.scissor)[2], (*s.scissor)[3]});
    setBlendFunctions(s.blend);
    for (GLuint i = 0; i < GlState::kTargets; ++i) {
        s.blends[i] ? glEnablei(GL_BLEND, i) : glDisablei(GL_BLEND, i);
        const auto& mask = s.colorMasks[i];
        glColorMaski(i, mask[0], mask[1], mask[2], mask[3]);
    }
    for (size_t i = 0; i < s.switches.size(); ++i) setSwitch(GlState::kSwitches[i], s.switches[i]);
    for (size_t i = 0; i < s.unpack.size(); ++i) glPixelStorei(GlState::kUnpack[i], s.unpack[i]);
}

/// What a draw needs of a new context's state, where it does not set it itself.
void setForDrawing(const GlUse& use) {
    static const GlState fresh;
    // Mesa tells apart whether the first target ever had other functions than the rest: it has from here on.
    setBlendFunctions({.destination = GL_ONE});
    setRasterizer(fresh);
    for (GLuint i = 0; i < GLuint(use.units); ++i) glBindSampler(i, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

}  // namespace

GlState GlState::current(const GlUse& use) {
    GlState state;
    state.transformFeedback = TransformFeedback::current();
    askRasterizer(state);
    askBindings(state);
    if (use.images) askImages(state);
    askUnits(state, use);
    return state;
}

void GlState::set() const {
    setRasterizer(*this);
    if (images)
        for (GLuint i = 0; i < kImages; ++i) {
            const ImageBinding& image = (*images)[i];
            glBindImageTexture(i, GLuint(image.name), image.level, image.layered ? GL_TRUE : GL_FALSE, image.layer,
                               GLenum(image.access), GLenum(image.format));
        }
    setUnits(*this);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, GLuint(unpackBuffer));
    glBindBuffer(GL_COPY_WRITE_BUFFER, GLuint(copyWriteBuffer));
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(copyReadBuffer));
    if (uniformSize0 > 0)
        glBindBufferRange(GL_UNIFORM_BUFFER, 0, GLuint(uniformBuffer0), GLintptr(uniformStart0),
                          GLsizeiptr(uniformSize0));
    else
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, GLuint(uniformBuffer0));
    glBindBuffer(GL_UNIFORM_BUFFER, GLuint(uniformBuffer));
    glBindVertexArray(GLuint(vertexArray));
    glBindBuffer(GL_ARRAY_BUFFER, GLuint(arrayBuffer));
    glUseProgram(GLuint(program));
    transformFeedback.resume();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(drawFramebuffer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(readFramebuffer));
}

GlStateGuard::GlStateGuard(HostState host, const GlUse& use) {
    if (host == HostState::Restored) m_after = GlState::current(use);
    if (host == HostState::Reset && use.images) m_after.images.emplace();
    m_after.unitCount = use.units;
    m_after.transformFeedback.pause();
    setForDrawing(use);
}

GlStateGuard::~GlStateGuard() {
    m_after.set();
    if (std::uncaught_exceptions() > m_exceptions) dropErrors();
}

void dropErrors() {
    constexpr int kMaxErrors = 16;  // without a context there is no last one
    for (int i = 0; i < kMaxErrors && glGetError() != GL_NO_ERROR;) ++i;
}

PixelPackGuard::PixelPackGuard() : m_buffer(asked(GL_PIXEL_PACK_BUFFER_BINDING)) {
    for (size_t i = 0; i < m_pack.size(); ++i) {
        m_pack[i] = asked(kPack[i]);
        glPixelStorei(kPack[i], kPack[i] == GL_PACK_ALIGNMENT ? 1 : 0);
    }
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

PixelPackGuard::~PixelPackGuard() {
    for (size_t i = 0; i < m_pack.size(); ++i) glPixelStorei(kPack[i], m_pack[i]);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(m_buffer));
}

}  // namespace rubble
