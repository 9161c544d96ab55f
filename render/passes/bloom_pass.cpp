#include "render/passes/bloom_pass.h"

#include <algorithm>
#include <array>

namespace rubble {
namespace {

constexpr std::array kLevels = {"bloom0", "bloom1", "bloom2", "bloom3", "bloom4"};
constexpr float kThreshold = 3.0f;  // in units of what exposure 1 shows just below white

glm::vec2 texel(const Texture& texture) {
    return 1.0f / glm::vec2(texture.size());
}

}  // namespace

BloomPass::BloomPass(ShaderLibrary& shaders) : m_down(shaders.load("passes/bloom_down.frag")), m_up(shaders.load("passes/bloom_up.frag")) {}

void BloomPass::draw(const FrameContext& frame) const {
    if (!m_down || !m_up) return;
    std::array<const Texture*, kLevels.size()> levels;
    for (size_t i = 0; i < kLevels.size(); ++i) levels[i] = &frame.pictures.target(kLevels[i], GL_RGBA16F, 2 << i, Filter::Linear);
    const Texture* source = &frame.pictures.at("resolved");
    m_down.use();
    for (size_t i = 0; i < kLevels.size(); ++i) {
        frame.pictures.framebuffer({levels[i]}).begin();
        m_down.set("uSource", *source);
        m_down.set("uTexel", texel(*source));
        m_down.set("uThreshold", i == 0 ? kThreshold / std::max(frame.block.exposure.x, 1e-3f) : 0.0f);
        frame.drawFullscreen();
        source = levels[i];
    }
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    m_up.use();
    for (size_t i = kLevels.size() - 1; i > 0; --i) {
        frame.pictures.framebuffer({levels[i - 1]}).begin();
        m_up.set("uSource", *levels[i]);
        m_up.set("uTexel", texel(*levels[i]));
        frame.drawFullscreen();
    }
    glDisable(GL_BLEND);
}

}  // namespace rubble
