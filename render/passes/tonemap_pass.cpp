#include "render/passes/tonemap_pass.h"

#include "render/passes/fullscreen.h"

namespace rubble {

TonemapPass::TonemapPass(ShaderLibrary& shaders) : m_program(shaders.loadFullscreen("passes/tonemap.frag")) {}

void TonemapPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    drawFullscreen(frame, m_program, {frame.pictures, {&frame.pictures.target("final", GL_RGBA8)}},
                   [&](const Program& program) {
                       program.set("uColor", frame.pictures.at("resolved"));
                       program.set("uExposure", frame.pictures.at("exposure"));
                       program.set("uBlueNoise", frame.blueNoise);
                       program.set("uBloomShare", frame.settings.bloom);
                       if (frame.settings.bloom > 0.0f) program.set("uBloom", frame.pictures.at("bloom0"));
                       // TAA softens; without it the picture is as sharp as it gets.
                       program.set("uSharpen", frame.settings.temporal ? 0.35f : 0.0f);
                   });
}

}  // namespace rubble
