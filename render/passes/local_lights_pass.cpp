#include "render/passes/local_lights_pass.h"

#include <cmath>
#include <glm/common.hpp>
#include <optional>

#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

struct PixelBox {
    glm::ivec2 low, size;
};

/// Pixels that a sphere can cover: those of the box around it; all if the box reaches behind the eye. Nothing if it is out of view.
std::optional<PixelBox> pixelsOf(glm::vec3 centerWorld, float radius, const FrameBlock& block) {
    glm::vec2 low(1.0f), high(-1.0f);
    int behind = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 side = glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2) * 2.0f - 1.0f;
        const glm::vec4 clip = block.viewProjection * glm::vec4(centerWorld + side * radius, 1.0f);
        if (clip.w < 0.05f) {
            ++behind;
            continue;
        }
        low = glm::min(low, glm::vec2(clip) / clip.w);
        high = glm::max(high, glm::vec2(clip) / clip.w);
    }
    if (behind == 8) return {};
    if (behind > 0) low = glm::vec2(-1.0f), high = glm::vec2(1.0f);
    const glm::vec2 size(block.targetSize);
    const glm::ivec2 first(glm::floor(glm::clamp(low * 0.5f + 0.5f, 0.0f, 1.0f) * size));
    const glm::ivec2 last(glm::ceil(glm::clamp(high * 0.5f + 0.5f, 0.0f, 1.0f) * size));
    if (first.x >= last.x || first.y >= last.y) return {};
    return PixelBox{first, last - first};
}

void setLight(const Program& program, const SnapshotLight& light, glm::vec3 position, int index) {
    // A sphere is a cone whose edge lies beyond all directions.
    const bool cone = light.kind == LightKind::Cone;
    const float outer = cone ? std::cos(light.coneOuter) : -3.0f;
    const float inner = cone ? std::cos(light.coneInner) : -2.0f;
    program.set("uPlace", glm::vec4(position, light.radius));
    program.set("uPower", glm::vec4(light.color, light.reach));
    program.set("uAxis", light.direction);
    program.set("uCone", glm::vec2(outer, 1.0f / std::max(inner - outer, 1e-3f)));
    program.set("uIndex", index);
}

}  // namespace

LocalLightsPass::LocalLightsPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/local_lights.frag", kFarVertexShader)) {}

void LocalLightsPass::draw(const FrameContext& frame) const {
    if (!m_program || frame.scene.lights().empty()) return;
    frame.targets.framebuffer({&frame.targets.target("light", GL_RGBA16F)}, &frame.targets.at("depthBuffer")).begin();
    const DepthLimit limit(DepthLimit::To::Surfaces);
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    frame.scene.bindShadow(m_program);
    m_program.set("uBlueNoise", frame.blueNoise);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glEnable(GL_SCISSOR_TEST);
    for (size_t i = 0; i < frame.scene.lights().size(); ++i) {
        const SnapshotLight& light = frame.scene.lights()[i];
        const glm::vec3 position(light.position - frame.scene.origin());
        const auto box = pixelsOf(position, light.reach, frame.block);
        if (!box) continue;
        glScissor(box->low.x, box->low.y, box->size.x, box->size.y);
        setLight(m_program, light, position, int(i));
        frame.drawFullscreen();
    }
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
}

}  // namespace rubble
