#include "render/passes/wetness_pass.h"

#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr float kRoofReach = 60.0f;  // metres

}  // namespace

WetnessPass::WetnessPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/wetness.frag", kFarVertexShader)) {
    if (!m_program) logError("nothing gets wet: " + shaders.errors().back());
}

void WetnessPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const TargetPool& targets = frame.targets;
    // The depth of the G-buffer limits the draw, and what it writes it does not read: roughness comes from a copy.
    const Texture& before = frame.targets.copy(targets.at("material"), "dryMaterial");
    frame.targets.framebuffer({&targets.at("albedo"), &targets.at("material")}, &targets.at("depthBuffer")).begin();
    const DepthLimit limit(DepthLimit::To::Surfaces);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);  // alpha: palette index and motion, which stay
    m_program.use();
    GBufferPass::bind(m_program, targets);
    m_program.set("uMaterial", before);
    frame.scene.bindShadow(m_program);
    m_program.set("uBlueNoise", frame.blueNoise);
    m_program.set("uReach", kRoofReach);
    frame.drawFullscreen();
    glDisable(GL_BLEND);
}

}  // namespace rubble
