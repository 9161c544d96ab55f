#include "render/passes/glare_pass.h"

#include "render/gl/draw_state.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {

GlarePass::GlarePass(ShaderLibrary& shaders)
    : m_program(shaders.load("passes/glare.frag", "passes/glare.vert", "glare is not drawn")) {}

void GlarePass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    frame.targets.framebuffer({&frame.targets.at(Target::Radiance)}).begin();
    m_program.use();
    frame.scene.bindShadow(m_program);
    LightGrid::bind(m_program, frame.lightGrid);
    m_program.set("uDepth", frame.targets.at(Target::Depth));
    setBlend({GL_ONE, GL_ONE, GL_ONE, GL_ONE});
    glBindVertexArray(frame.emptyVertexArray.get());
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, frame.lightGrid->lights());
    ++frame.stats.drawCalls;
    disableBlend();
}

}  // namespace rubble
