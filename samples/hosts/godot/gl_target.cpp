#include "samples/hosts/godot/gl_target.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include "samples/hosts/godot/host_services.h"

namespace rubble_godot {
namespace {

template <class Function>
Function find(const char* name) {
    return reinterpret_cast<Function>(hostServices().gl_get_proc_address(name));
}

/// The framebuffer that is drawn to, until the end of its scope.
class BoundFramebuffer {
public:
    explicit BoundFramebuffer(GLuint name) {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_before);
        bind(name);
    }
    ~BoundFramebuffer() { bind(GLuint(m_before)); }

private:
    static void bind(GLuint name) {
        static const auto bindFramebuffer = find<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer");
        bindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
    }
    GLint m_before = 0;
};

void setStorage(GLuint texture, GLint storage, GLenum format, int32_t width, int32_t height) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, storage, width, height, 0, format, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

GlTarget::GlTarget() {
    find<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &m_name);
}

GlTarget::~GlTarget() {
    find<PFNGLDELETEFRAMEBUFFERSPROC>("glDeleteFramebuffers")(1, &m_name);
}

void GlTarget::attach(uint32_t colors, uint32_t depths, int32_t width, int32_t height) {
    static const auto attachTexture = find<PFNGLFRAMEBUFFERTEXTURE2DPROC>("glFramebufferTexture2D");
    GLint texture = 0, unpackBuffer = 0;
    static const auto bindBuffer = find<PFNGLBINDBUFFERPROC>("glBindBuffer");
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture);
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &unpackBuffer);
    bindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    setStorage(colors, GL_RGBA16F, GL_RGBA, width, height);
    setStorage(depths, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, width, height);
    glBindTexture(GL_TEXTURE_2D, GLuint(texture));
    bindBuffer(GL_PIXEL_UNPACK_BUFFER, GLuint(unpackBuffer));
    const BoundFramebuffer bound(m_name);
    attachTexture(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colors, 0);
    attachTexture(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths, 0);
}

void GlTarget::clear() const {
    static const auto clearValues = find<PFNGLCLEARBUFFERFVPROC>("glClearBufferfv");
    const BoundFramebuffer bound(m_name);
    GLboolean colorMask[4], depthMask = GL_FALSE;
    const GLboolean scissor = glIsEnabled(GL_SCISSOR_TEST);
    const GLfloat black[4] = {}, far = 1.0f;
    glGetBooleanv(GL_COLOR_WRITEMASK, colorMask);
    glGetBooleanv(GL_DEPTH_WRITEMASK, &depthMask);
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    clearValues(GL_COLOR, 0, black);
    clearValues(GL_DEPTH, 0, &far);
    if (scissor) glEnable(GL_SCISSOR_TEST);
    glColorMask(colorMask[0], colorMask[1], colorMask[2], colorMask[3]);
    glDepthMask(depthMask);
}

}  // namespace rubble_godot
