#include "render/passes/show_pass.h"

namespace rubble {

ShowPass::ShowPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/show.frag")) {}

void ShowPass::draw(const FrameContext& frame, const Texture& target, Mode mode, unsigned framebuffer, glm::ivec2 size) const {
    if (!m_program) return;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.x, size.y);
    m_program.use();
    m_program.set("uTarget", target);
    m_program.set("uMode", int(mode));
    frame.drawFullscreen();
}

}  // namespace rubble
