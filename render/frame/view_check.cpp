#include "render/frame/view_check.h"

#include "render/gl/gl.h"

namespace rubble {

std::string ViewCheck::error(const View& view, bool mayAsk) {
    if (!glGetString(GL_VERSION)) return "expected a current GL context on the thread that draws, found none";
    if (mayAsk || m_draws++ % kDrawsPerQuestion == 0) m_isLost = m_isLost || isContextLost();
    if (m_isLost) return "the GL context was lost: destroy this renderer, then make a new context and renderer";
    if (!mayAsk && view.framebuffer == m_checked) return {};
    const auto error = [&](const std::string& text) {
        return "the view's framebuffer " + std::to_string(view.framebuffer) + ": " + text;
    };
    if (view.framebuffer != 0 && !glIsFramebuffer(view.framebuffer))
        return error("expected a framebuffer of this GL context, found none");
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, view.framebuffer);
    const GLenum status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound));
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return error(status == GL_FRAMEBUFFER_UNDEFINED
                         ? "expected one to draw into, found a GL context without a window or image of its own"
                         : "expected a complete framebuffer, found status " + std::to_string(status));
    m_checked = view.framebuffer;
    return {};
}

}  // namespace rubble
