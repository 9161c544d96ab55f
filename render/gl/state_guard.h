#pragma once
#include <array>

#include "render/gl/gl.h"

namespace rubble {

/// Saves the GL state that the renderer changes, sets what the renderer expects (no blending, no culling, no tests),
/// and restores the host's state at the end of its scope.
class GlStateGuard {
public:
    /// Of the context that is current.
    GlStateGuard();
    ~GlStateGuard();
    GlStateGuard(const GlStateGuard&) = delete;
    GlStateGuard& operator=(const GlStateGuard&) = delete;

private:
    static constexpr int kImages = 2;  ///< units that compute programs store into
    struct Image {
        GLint name, level, layered, layer, access, format;
    };
    static constexpr std::array<GLenum, 7> kSwitches = {
        GL_BLEND,        GL_CULL_FACE,        GL_DEPTH_TEST,       GL_SCISSOR_TEST,
        GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB, GL_PRIMITIVE_RESTART};
    GLint m_drawFramebuffer, m_readFramebuffer, m_program, m_vertexArray, m_arrayBuffer, m_uniformBuffer,
        m_uniformBuffer0;
    GLint m_copyReadBuffer, m_copyWriteBuffer, m_pixelUnpackBuffer, m_pixelPackBuffer;
    GLint m_activeTexture, m_cullFace, m_frontFace, m_depthFunc, m_unpackAlignment, m_packAlignment, m_unpackRowLength;
    GLint m_blend[6];
    GLint m_viewport[4];
    GLboolean m_depthMask, m_colorMask[4];
    std::array<GLint, kTextureUnits> m_texture2D, m_textureBuffer, m_sampler;
    std::array<GLboolean, kSwitches.size()> m_switches;
    std::array<Image, kImages> m_images;  ///< where hasCompute()
};

}  // namespace rubble
