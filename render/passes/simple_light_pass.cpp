#include "render/passes/simple_light_pass.h"

#include "render/passes/gbuffer_pass.h"

namespace rubble {

SimpleLightPass::SimpleLightPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/simple_light.frag")) {}

void SimpleLightPass::draw(const FrameContext& frame) {
    if (!m_program) return;
    frame.targets.framebuffer({&frame.targets.target("final", GL_RGBA8)}).begin();
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    frame.drawFullscreen();
}

}  // namespace rubble
