#include "render/passes/bloom_pass.h"

#include <algorithm>
#include <array>

#include "render/passes/fullscreen.h"

namespace rubble {
namespace {

constexpr std::array kLevels = {Target::Bloom0, Target::Bloom1, Target::Bloom2, Target::Bloom3, Target::Bloom4};
constexpr float kThreshold = 3.0f;  ///< radiance that blooms, at exposure 1: three times white

glm::vec2 texel(const Texture& texture) {
    return 1.0f / glm::vec2(texture.size());
}

}  // namespace

BloomPass::BloomPass(ShaderLibrary& shaders)
    : m_down(shaders.loadFullscreen("passes/bloom_down.frag")),
      m_up(shaders.loadFullscreen("passes/bloom_up.frag", {.merge = {Merge::Add}})) {}

void BloomPass::draw(const FrameContext& frame) const {
    if (!m_down || !m_up) return;
    std::array<const Texture*, kLevels.size()> levels;
    for (size_t i = 0; i < kLevels.size(); ++i) levels[i] = &frame.targets.target(kLevels[i]);
    const Texture* source = &frame.targets.at(Target::Resolved);
    for (size_t i = 0; i < kLevels.size(); ++i) {
        drawFullscreen(frame, m_down, {{levels[i]}}, [&](const Program& program) {
            program.set("uSource", *source);
            program.set("uTexel", texel(*source));
            program.set("uThreshold", i == 0 ? kThreshold / std::max(frame.block.exposure.x, 1e-3f) : 0.0f);
        });
        source = levels[i];
    }
    for (size_t i = kLevels.size() - 1; i > 0; --i)
        drawFullscreen(frame, m_up, {{levels[i - 1]}}, [&](const Program& program) {
            program.set("uSource", *levels[i]);
            program.set("uTexel", texel(*levels[i]));
        });
}

}  // namespace rubble
