#include "render/passes/show_pass.h"

namespace rubble {

ShowPass::ShowPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/show.frag")) {}

void ShowPass::draw(const FrameContext& frame, const Texture& target, Mode mode, const View& view,
                    glm::vec4 dot) const {
    if (!m_program) return;
    glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
    glViewport(0, 0, view.size.x, view.size.y);
    m_program.use();
    m_program.set("uTarget", target);
    m_program.set("uMode", int(mode));
    m_program.set("uStatusDot", dot);
    frame.drawFullscreen();
}

}  // namespace rubble
