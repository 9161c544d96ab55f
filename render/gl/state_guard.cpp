#include "render/gl/state_guard.h"

namespace rubble {
namespace {

constexpr GLenum kBlendNames[6] = {GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                                   GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};

void setSwitch(GLenum name, bool on) {
    on ? glEnable(name) : glDisable(name);
}

}  // namespace

GlStateGuard::GlStateGuard() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_drawFramebuffer);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_readFramebuffer);
    glGetIntegerv(GL_CURRENT_PROGRAM, &m_program);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertexArray);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &m_arrayBuffer);
    glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &m_uniformBuffer);
    glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, 0, &m_uniformBuffer0);
    glGetIntegerv(GL_COPY_READ_BUFFER, &m_copyReadBuffer);
    glGetIntegerv(GL_COPY_WRITE_BUFFER, &m_copyWriteBuffer);
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &m_pixelUnpackBuffer);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &m_pixelPackBuffer);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glGetIntegerv(GL_ACTIVE_TEXTURE, &m_activeTexture);
    glGetIntegerv(GL_CULL_FACE_MODE, &m_cullFace);
    glGetIntegerv(GL_FRONT_FACE, &m_frontFace);
    glGetIntegerv(GL_DEPTH_FUNC, &m_depthFunc);
    glGetIntegerv(GL_UNPACK_ALIGNMENT, &m_unpackAlignment);
    glGetIntegerv(GL_PACK_ALIGNMENT, &m_packAlignment);
    glGetIntegerv(GL_UNPACK_ROW_LENGTH, &m_unpackRowLength);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    for (int i = 0; i < 6; ++i) glGetIntegerv(kBlendNames[i], &m_blend[i]);
    glGetIntegerv(GL_VIEWPORT, m_viewport);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &m_depthMask);
    glGetBooleanv(GL_COLOR_WRITEMASK, m_colorMask);
    for (int i = 0; i < kTextureUnits; ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + i));
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &m_texture2D[size_t(i)]);
        glGetIntegerv(GL_TEXTURE_BINDING_BUFFER, &m_textureBuffer[size_t(i)]);
        glGetIntegerv(GL_SAMPLER_BINDING, &m_sampler[size_t(i)]);
        glBindSampler(GLuint(i), 0);
    }
    for (GLuint i = 0; i < kImages && hasCompute(); ++i) {
        Image& image = m_images[i];
        glGetIntegeri_v(GL_IMAGE_BINDING_NAME, i, &image.name);
        glGetIntegeri_v(GL_IMAGE_BINDING_LEVEL, i, &image.level);
        glGetIntegeri_v(GL_IMAGE_BINDING_LAYERED, i, &image.layered);
        glGetIntegeri_v(GL_IMAGE_BINDING_LAYER, i, &image.layer);
        glGetIntegeri_v(GL_IMAGE_BINDING_ACCESS, i, &image.access);
        glGetIntegeri_v(GL_IMAGE_BINDING_FORMAT, i, &image.format);
    }
    for (size_t i = 0; i < kSwitches.size(); ++i) {
        m_switches[i] = glIsEnabled(kSwitches[i]);
        glDisable(kSwitches[i]);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glFrontFace(GL_CCW);
}

GlStateGuard::~GlStateGuard() {
    for (size_t i = 0; i < kSwitches.size(); ++i) setSwitch(kSwitches[i], m_switches[i]);
    for (int i = 0; i < kTextureUnits; ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + i));
        glBindTexture(GL_TEXTURE_2D, GLuint(m_texture2D[size_t(i)]));
        glBindTexture(GL_TEXTURE_BUFFER, GLuint(m_textureBuffer[size_t(i)]));
        glBindSampler(GLuint(i), GLuint(m_sampler[size_t(i)]));
    }
    for (GLuint i = 0; i < kImages && hasCompute(); ++i) {
        const Image& image = m_images[i];
        glBindImageTexture(i, GLuint(image.name), image.level, image.layered ? GL_TRUE : GL_FALSE, image.layer,
                           GLenum(image.access), GLenum(image.format));
    }
    glActiveTexture(GLenum(m_activeTexture));
    glColorMask(m_colorMask[0], m_colorMask[1], m_colorMask[2], m_colorMask[3]);
    glDepthMask(m_depthMask);
    glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
    glBlendFuncSeparate(GLenum(m_blend[0]), GLenum(m_blend[1]), GLenum(m_blend[2]), GLenum(m_blend[3]));
    glBlendEquationSeparate(GLenum(m_blend[4]), GLenum(m_blend[5]));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, m_unpackRowLength);
    glPixelStorei(GL_PACK_ALIGNMENT, m_packAlignment);
    glPixelStorei(GL_UNPACK_ALIGNMENT, m_unpackAlignment);
    glDepthFunc(GLenum(m_depthFunc));
    glFrontFace(GLenum(m_frontFace));
    glCullFace(GLenum(m_cullFace));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(m_pixelPackBuffer));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, GLuint(m_pixelUnpackBuffer));
    glBindBuffer(GL_COPY_WRITE_BUFFER, GLuint(m_copyWriteBuffer));
    glBindBuffer(GL_COPY_READ_BUFFER, GLuint(m_copyReadBuffer));
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, GLuint(m_uniformBuffer0));
    glBindBuffer(GL_UNIFORM_BUFFER, GLuint(m_uniformBuffer));
    glBindVertexArray(GLuint(m_vertexArray));
    glBindBuffer(GL_ARRAY_BUFFER, GLuint(m_arrayBuffer));
    glUseProgram(GLuint(m_program));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(m_drawFramebuffer));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(m_readFramebuffer));
}

}  // namespace rubble
