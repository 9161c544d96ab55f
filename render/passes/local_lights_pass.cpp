#include "render/passes/local_lights_pass.h"

#include <algorithm>
#include <cmath>

#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr int kTexelsPerLight = 4;

}  // namespace

LocalLightsPass::LocalLightsPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/local_lights.frag", kFarVertexShader)) {}

void LocalLightsPass::upload(const FrameContext& frame) {
    m_texels.clear();
    for (const SnapshotLight& light : frame.scene.lights()) {
        m_texels.emplace_back(glm::vec3(light.position - frame.scene.origin()), light.radius);
        m_texels.emplace_back(light.color, light.reach);
        m_texels.emplace_back(light.direction, 0.0f);
        // A sphere is a cone whose edge lies beyond all directions.
        const bool cone = light.kind == LightKind::Cone;
        const float outer = cone ? std::cos(light.coneOuter) : -3.0f;
        const float inner = cone ? std::cos(light.coneInner) : -2.0f;
        m_texels.emplace_back(outer, 1.0f / std::max(inner - outer, 1e-3f), 0.0f, 0.0f);
    }
    const int rows = int(m_texels.size()) / kTexelsPerLight;
    if (!m_lights || m_lights.size().y != rows) m_lights = Texture(GL_RGBA32F, {kTexelsPerLight, rows});
    m_lights.upload(m_texels.data());
}

void LocalLightsPass::draw(const FrameContext& frame) {
    if (frame.scene.lights().empty()) m_lights = Texture();
    if (!m_program || frame.scene.lights().empty()) return;
    upload(frame);
    frame.targets.framebuffer({&frame.targets.target("light", GL_RGBA16F)}, &frame.targets.at("depthBuffer")).begin();
    const DepthLimit limit(DepthLimit::To::Surfaces);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    frame.scene.bindShadow(m_program);
    m_program.set("uBlueNoise", frame.blueNoise);
    m_program.set("uLights", m_lights);
    frame.drawFullscreen();
    glDisable(GL_BLEND);
}

}  // namespace rubble
