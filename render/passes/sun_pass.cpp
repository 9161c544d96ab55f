#include "render/passes/sun_pass.h"

#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr float kReach = 200.0f;  // metres: beyond it nothing throws a shadow that is seen

}  // namespace

SunPass::SunPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/sun.frag", kFarVertexShader)) {}

void SunPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    frame.targets.framebuffer({&frame.targets.target("light", GL_RGBA16F)}, &frame.targets.at("depthBuffer")).begin();
    const DepthLimit limit(DepthLimit::To::Surfaces);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    frame.scene.bindShadow(m_program);
    frame.scene.bindSmoke(m_program);
    m_program.set("uBlueNoise", frame.blueNoise);
    m_program.set("uRays", frame.settings.sunRays);
    m_program.set("uReach", kReach);
    frame.drawFullscreen();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace rubble
