#include "render/passes/exposure_pass.h"

namespace rubble {
namespace {

constexpr int kOneTexel = 1 << 20;  // a divisor that leaves one texel of any view

}  // namespace

ExposurePass::ExposurePass(ShaderLibrary& shaders) : m_program(shaders.load("passes/exposure.frag")) {}

void ExposurePass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const History exposure = frame.pictures.history("exposure", GL_R32F, kOneTexel, Filter::Nearest);
    frame.pictures.framebuffer({&exposure.current}).begin();
    m_program.use();
    m_program.set("uColor", frame.pictures.at("resolved"));
    m_program.set("uLast", exposure.previous);
    m_program.set("uLastValid", int(exposure.valid));
    frame.drawFullscreen();
}

}  // namespace rubble
