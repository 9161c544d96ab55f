#include "render/passes/taa_pass.h"

#include <glm/exponential.hpp>

namespace rubble {
namespace {

/// Of three pixels in a row, for the one sample that lies `away` pixels beside each one's centre.
glm::vec3 gaussianWeights(float away) {
    const glm::vec3 distance = glm::vec3(-1.0f, 0.0f, 1.0f) + away;
    const glm::vec3 weights = glm::exp(-2.3f * distance * distance);
    return weights / (weights.x + weights.y + weights.z);
}

}  // namespace

TaaPass::TaaPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/taa.frag")) {}

void TaaPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const History resolved = frame.targets.history("resolved", GL_RGBA16F, 1, Filter::Linear);
    frame.targets.framebuffer({&resolved.current}).begin();
    m_program.use();
    m_program.set("uWeightsAcross", gaussianWeights(frame.block.jitter.x * frame.block.targetSize.x));
    m_program.set("uWeightsUp", gaussianWeights(frame.block.jitter.y * frame.block.targetSize.y));
    m_program.set("uColor", frame.targets.at("radiance"));
    m_program.set("uHistory", resolved.previous);
    m_program.set("uHistoryValid", int(frame.settings.temporal && resolved.valid));
    m_program.set("uDepth", frame.targets.at("depth"));
    m_program.set("uMotion", frame.targets.at("motion"));
    frame.drawFullscreen();
}

}  // namespace rubble
