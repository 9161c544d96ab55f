#include "render/passes/exposure_pass.h"

#include "render/passes/fullscreen.h"

namespace rubble {

ExposurePass::ExposurePass(ShaderLibrary& shaders) : m_program(shaders.loadFullscreen("passes/exposure.frag")) {}

void ExposurePass::draw(const FrameContext& frame, bool isFixed) const {
    if (!m_program) return;
    const History exposure = frame.targets.history(Target::Exposure);
    drawFullscreen(frame, m_program, {{&exposure.current}}, [&](const Program& program) {
        program.set("uColor", frame.targets.at(Target::Resolved));
        program.set("uHistory", exposure.previous);
        program.set("uHistoryValid", int(exposure.valid));
        program.set("uSeconds", frame.seconds);
        program.set("uIsFixed", int(isFixed));
    });
}

}  // namespace rubble
