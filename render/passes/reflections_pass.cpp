#include "render/passes/reflections_pass.h"

#include "render/passes/bounce.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {

ReflectionsPass::ReflectionsPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/reflections.frag")) {}

bool ReflectionsPass::needed(const FrameContext& frame) {
    return frame.settings.reflections;
}

void ReflectionsPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    frame.targets.framebuffer({&frame.targets.target("reflection", GL_RGBA16F)}).begin();
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    frame.scene.bindShadow(m_program);
    bindBounce(m_program, frame);
    m_program.set("uLight", frame.targets.at("lighting"));
    m_program.set("uBlueNoise", frame.blueNoise);
    const Texture* pane = frame.targets.find("glassSurface");
    m_program.set("uGlass", int(pane && frame.scene.hasGlass()));
    if (pane) m_program.set("uGlassSurface", *pane);
    frame.drawFullscreen();
}

}  // namespace rubble
