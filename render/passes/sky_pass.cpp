#include "render/passes/sky_pass.h"

#include "render/passes/bounce.h"
#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {

SkyPass::SkyPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/sky.frag", kFarVertexShader)) {}

void SkyPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    frame.targets.framebuffer({&frame.targets.target("light", GL_RGBA16F)}, &frame.targets.at("depthBuffer")).begin();
    const DepthLimit limit(DepthLimit::To::Surfaces);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    frame.scene.bindShadow(m_program);
    bindBounce(m_program, frame);
    m_program.set("uBlueNoise", frame.blueNoise);
    m_program.set("uLastLight", frame.targets.history("accumulated", GL_RGBA16F).previous);
    m_program.set("uRays", frame.settings.skyRays);
    m_program.set("uReach", frame.settings.skyDistance);
    frame.drawFullscreen();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace rubble
