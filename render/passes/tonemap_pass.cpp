#include "render/passes/tonemap_pass.h"

namespace rubble {

TonemapPass::TonemapPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/tonemap.frag")) {}

void TonemapPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    frame.pictures.framebuffer({&frame.pictures.target("final", GL_RGBA8)}).begin();
    m_program.use();
    m_program.set("uColor", frame.pictures.at("resolved"));
    m_program.set("uExposure", frame.pictures.at("exposure"));
    m_program.set("uBlueNoise", frame.blueNoise);
    m_program.set("uBloomShare", frame.settings.bloom);
    if (frame.settings.bloom > 0.0f) m_program.set("uBloom", frame.pictures.at("bloom0"));
    // TAA softens; without it the picture is as sharp as it gets.
    m_program.set("uSharpen", frame.settings.temporal ? 0.35f : 0.0f);
    frame.drawFullscreen();
}

}  // namespace rubble
