#include "render/passes/local_lights_pass.h"

#include <algorithm>

#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr float kFaintest = 0.01f;  // radiance of a white surface at exposure 1: fainter light gets fewer rays

constexpr int kLongest = 16;  // frames that highlights are averaged over

}  // namespace

LocalLightsPass::LocalLightsPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/local_lights.frag", "passes/local_lights.vert")) {
    if (!m_program) logError("local lights are not drawn: " + shaders.errors().back());
}

bool LocalLightsPass::needed(const FrameContext& frame) {
    return frame.settings.localLights && frame.lightGrid && frame.lightGrid->hasLights();
}

void LocalLightsPass::draw(const FrameContext& frame) const {
    const History specular = frame.targets.history("specular", GL_RGBA16F);
    const History surface = frame.targets.history("surface", GL_RGBA32F);
    frame.targets.framebuffer({&frame.targets.target("light", GL_RGBA16F), &specular.current}, &frame.targets.at("depthBuffer")).begin();
    const float none[4] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 1, none);
    if (!m_program || frame.lightGrid->empty()) return;
    const DepthLimit limit(DepthLimit::To::Surfaces);
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    frame.scene.bindShadow(m_program);
    frame.lightGrid->bind(m_program);
    m_program.set("uBlueNoise", frame.blueNoise);
    m_program.set("uLastSpecular", specular.previous);
    m_program.set("uLastSurface", surface.previous);
    m_program.set("uLastValid", int(frame.settings.temporal && specular.valid && surface.valid));
    m_program.set("uLongest", float(std::min(kLongest, frame.lightGrid->framesSinceChange() + 1)));
    m_program.set("uFaintest", kFaintest / frame.block.exposure.x);
    glEnablei(GL_BLEND, 0);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(frame.emptyVertexArray.get());
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, frame.lightGrid->tiles());
    ++frame.figures.drawCalls;
    glDisablei(GL_BLEND, 0);
}

}  // namespace rubble
