#include "render/passes/taa_pass.h"

#include "render/scene/scene.h"

namespace rubble {

TaaPass::TaaPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/taa.frag")) {}

void TaaPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const History resolved = frame.pictures.history("resolved", GL_RGBA16F, 1, Filter::Linear);
    frame.pictures.framebuffer({&resolved.current}).begin();
    m_program.use();
    m_program.set("uColor", frame.targets.at("radiance"));
    m_program.set("uHistory", resolved.previous);
    m_program.set("uHistoryValid", int(frame.settings.temporal && resolved.valid));
    m_program.set("uSurface", frame.targets.at("surface"));
    m_program.set("uMotion", frame.targets.at("motion"));
    m_program.set("uGlass", int(frame.scene.hasGlass()));
    if (frame.scene.hasGlass()) m_program.set("uGlassSurface", frame.targets.at("glassSurface"));
    frame.drawFullscreen();
}

}  // namespace rubble
