#include "render/passes/fog_pass.h"

#include <algorithm>

#include "render/passes/local_lights_pass.h"
#include "render/scene/light_grid.h"
#include "render/scene/scene.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

constexpr int kLongest = 12;  // frames that are averaged: as many as a wall that opens may take to be seen

}  // namespace

FogPass::FogPass(ShaderLibrary& shaders)
    : m_light(shaders.load("passes/fog_light.frag")), m_filter(shaders.load("passes/fog_filter.frag")), m_over(shaders.load("passes/fog.frag")) {
    if (!m_light || !m_filter || !m_over) logError("fog is not drawn: " + shaders.errors().back());
}

bool FogPass::needed(const FrameContext& frame) {
    return frame.settings.fog && frame.block.fog.x > 0.0f;
}

void FogPass::drawLight(const FrameContext& frame) const {
    const History light = frame.targets.history("fogLight", GL_RGBA16F, 2);
    frame.targets.framebuffer({&light.current}).begin();
    m_light.use();
    frame.scene.bindShadow(m_light);
    const bool lights = LocalLightsPass::needed(frame) && !frame.lightGrid->empty();
    if (lights) frame.lightGrid->bind(m_light);
    m_light.set("uLocalLights", int(lights));
    m_light.set("uDepth", frame.targets.at("depth"));
    m_light.set("uBlueNoise", frame.blueNoise);
    m_light.set("uLast", light.previous);
    m_light.set("uLastValid", int(frame.settings.temporal && light.valid));
    m_light.set("uSunUp", int(frame.settings.sun && frame.block.sunDirection.y > 0.0f));
    m_light.set("uLongest", float(frame.lightGrid ? std::min(kLongest, frame.lightGrid->framesSinceChange() + 1) : kLongest));
    frame.drawFullscreen();
}

void FogPass::drawFiltered(const FrameContext& frame) const {
    frame.targets.framebuffer({&frame.targets.target("fog", GL_RGBA16F, 2, Filter::Linear)}).begin();
    m_filter.use();
    m_filter.set("uLight", frame.targets.at("fogLight"));
    m_filter.set("uDepth", frame.targets.at("depth"));
    frame.drawFullscreen();
}

void FogPass::drawOver(const FrameContext& frame) const {
    frame.targets.framebuffer({&frame.targets.at("radiance")}).begin();
    m_over.use();
    m_over.set("uLight", frame.targets.at("fog"));
    m_over.set("uDepth", frame.targets.at("depth"));
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_SRC_ALPHA);
    frame.drawFullscreen();
    glDisable(GL_BLEND);
}

void FogPass::draw(const FrameContext& frame) const {
    if (!m_light || !m_filter || !m_over) return;
    drawLight(frame);
    drawFiltered(frame);
    drawOver(frame);
}

}  // namespace rubble
