#include "render/passes/taa_pass.h"

#include "render/passes/fullscreen.h"
#include "render/scene/scene.h"

namespace rubble {

TaaPass::TaaPass(ShaderLibrary& shaders) : m_program(shaders.loadFullscreen("passes/taa.frag")) {}

void TaaPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const History resolved = frame.pictures.history("resolved", GL_RGBA16F, 1, Filter::Linear);
    const Texture* trusted = frame.settings.rejectStaleHistory ? frame.targets.find("historyConfidence") : nullptr;
    drawFullscreen(frame, m_program, {frame.pictures, {&resolved.current}}, [&](const Program& program) {
        program.set("uColor", frame.targets.at("radiance"));
        program.set("uHistory", resolved.previous);
        program.set("uHistoryValid", int(frame.settings.temporal && resolved.valid));
        program.set("uHasConfidence", int(trusted != nullptr));
        if (trusted) program.set("uHistoryConfidence", *trusted);
        program.set("uSurface", frame.targets.at("surface"));
        program.set("uMotion", frame.targets.at("motion"));
        program.set("uHasGlass", int(frame.scene.hasGlass()));
        if (frame.scene.hasGlass()) program.set("uGlassSurface", frame.targets.at("glassSurface"));
    });
}

}  // namespace rubble
