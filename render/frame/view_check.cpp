#include "render/frame/view_check.h"

#include "render/gl/gl.h"

namespace rubble {

std::string ViewCheck::error(const View& view, bool mayAsk) {
    if (!glGetString(GL_VERSION)) return "expected a current GL context on the thread that draws, found none";
    if (mayAsk || m_draws++ % kDrawsPerQuestion == 0) m_isLost = m_isLost || isContextLost();
    if (m_isLost) return "the GL context was lost: destroy this renderer, then make a new context and renderer";
    const bool needsDepth = view.composesDepth();
    if ((mayAsk || view.framebuffer != m_checked) && !m_mark.isCurrent())
        return "expected the GL context that this renderer was made in, found another one";
    if (!mayAsk && view.framebuffer == m_checked && needsDepth == m_hadDepth) return {};
    const auto error = [&](const std::string& text) {
        return "the view's framebuffer " + std::to_string(view.framebuffer) + ": " + text;
    };
    if (view.framebuffer != 0 && !glIsFramebuffer(view.framebuffer))
        return error("expected a framebuffer of this GL context, found none");
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, view.framebuffer);
    const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    GLint depth = GL_NONE;
    if (needsDepth && status == GL_FRAMEBUFFER_COMPLETE)
        glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, view.framebuffer ? GL_DEPTH_ATTACHMENT : GL_DEPTH,
                                              GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &depth);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound));
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return error(status == GL_FRAMEBUFFER_UNDEFINED
                         ? "expected one to draw into, found a GL context without a window or image of its own"
                         : "expected a complete framebuffer, found status " + std::to_string(status));
    if (needsDepth && depth == GL_NONE) return error("expected a depth buffer to compose with, found none");
    m_checked = view.framebuffer;
    m_hadDepth = needsDepth;
    return {};
}

}  // namespace rubble
