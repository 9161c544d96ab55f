#include "render/passes/exposure_pass.h"

#include "render/passes/fullscreen.h"

namespace rubble {
namespace {

constexpr int kOneTexel = 1 << 20;  // a divisor that leaves one texel of any view

}  // namespace

ExposurePass::ExposurePass(ShaderLibrary& shaders) : m_program(shaders.loadFullscreen("passes/exposure.frag")) {}

void ExposurePass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const History exposure = frame.pictures.history("exposure", GL_R32F, kOneTexel, Filter::Nearest);
    drawFullscreen(frame, m_program, {frame.pictures, {&exposure.current}}, [&](const Program& program) {
        program.set("uColor", frame.pictures.at("resolved"));
        program.set("uHistory", exposure.previous);
        program.set("uHistoryValid", int(exposure.valid));
    });
}

}  // namespace rubble
