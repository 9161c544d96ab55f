#include "render/passes/accumulate_pass.h"

#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"

namespace rubble {
namespace {

constexpr float kSkyDepth = 65000.0f;  // lib/gbuffer.glsl

}  // namespace

AccumulatePass::AccumulatePass(ShaderLibrary& shaders) : m_program(shaders.load("passes/accumulate.frag", kFarVertexShader)) {}

void AccumulatePass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const History light = frame.targets.history("accumulated", GL_RGBA16F);
    const History surface = frame.targets.history("surface", GL_RGBA32F);
    frame.targets.framebuffer({&light.current, &surface.current}, &frame.targets.at("depthBuffer")).begin();
    const float none[4] = {0, 0, 0, 0}, sky[4] = {kSkyDepth, -1, 0, 0};
    glClearBufferfv(GL_COLOR, 0, none);
    glClearBufferfv(GL_COLOR, 1, sky);
    const DepthLimit limit(DepthLimit::To::Surfaces);
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    m_program.set("uLight", frame.targets.at("light"));
    m_program.set("uLastLight", light.previous);
    m_program.set("uLastSurface", surface.previous);
    m_program.set("uLastValid", int(frame.settings.temporal && light.valid && surface.valid));
    m_program.set("uLongest", float(frame.settings.historyFrames));
    frame.drawFullscreen();
}

}  // namespace rubble
