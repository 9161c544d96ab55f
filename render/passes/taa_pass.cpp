#include "render/passes/taa_pass.h"

#include "render/passes/fullscreen.h"
#include "render/passes/known_changes.h"
#include "render/scene/scene.h"

namespace rubble {

TaaPass::TaaPass(ShaderLibrary& shaders) : m_program(shaders.loadFullscreen("passes/taa.frag")) {}

void TaaPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const History resolved = frame.targets.history(Target::Resolved);
    const History surface = frame.targets.history(Target::Surface);
    const Texture& confidence = frame.targets.orNone(Target::HistoryConfidence);
    drawFullscreen(frame, m_program, {{&resolved.current}}, [&](const Program& program) {
        program.set("uColor", frame.targets.at(Target::Radiance));
        program.set("uHistory", resolved.previous);
        program.set("uHistoryValid", int(frame.settings.temporal && resolved.valid && surface.valid));
        program.set("uHasConfidence", int(confidence && frame.settings.rejectStaleHistory));
        program.set("uHistoryConfidence", confidence);
        setLastConfidence(program, frame);
        const Texture& mirrors = frame.targets.orNone(Target::AccumulatedReflection);
        program.set("uMirrorsMayChange", int(mirrors && hasKnownChanges(frame)));
        program.set("uMirrorHistory", mirrors);
        program.set("uSurface", surface.current);
        program.set("uSurfaceHistory", surface.previous);
        program.set("uMotion", frame.targets.at(Target::Motion));
        program.set("uHasGlass", int(frame.scene.hasGlass()));
        program.set("uGlassSurface", frame.targets.orNone(Target::GlassSurface));
    });
}

}  // namespace rubble
