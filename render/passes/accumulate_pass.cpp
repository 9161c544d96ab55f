#include "render/passes/accumulate_pass.h"

#include "render/passes/depth_limit.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr double kBrickMetres = 1.6;  // of the shadow volume
constexpr int kTile = 4;              // pixels: passes/light_change.frag

}  // namespace

AccumulatePass::AccumulatePass(ShaderLibrary& shaders)
    : m_change(shaders.load("passes/light_change.frag")), m_program(shaders.load("passes/accumulate.frag", kFarVertexShader)) {}

void AccumulatePass::setChangedPlaces(const Scene& scene) const {
    std::vector<glm::vec4> corners;
    for (const ChangedPlaces::Box& box : scene.changedPlaces().boxes())
        for (const glm::ivec3& corner : {box.low, box.high})
            corners.emplace_back(glm::vec3(glm::dvec3(corner) * kBrickMetres - scene.origin()), 0.0f);
    m_change.set("uChangedPlaces", int(corners.size()));
    if (!corners.empty()) m_change.set("uChanged[0]", std::span<const glm::vec4>(corners));
}

const Texture& AccumulatePass::findChanges(const FrameContext& frame, const History& light, const History& surface) const {
    const History pulse = frame.targets.history("lightPulse", GL_RGBA16F, kTile);
    const Texture& trusted = frame.targets.target("lightTrusted", GL_RG8, kTile, Filter::Linear);
    frame.targets.framebuffer({&pulse.current, &trusted}).begin();
    m_change.use();
    m_change.set("uLight", frame.targets.at("light"));
    m_change.set("uMotion", frame.targets.at("motion"));
    m_change.set("uLastLight", light.previous);
    m_change.set("uLastSurface", surface.previous);
    m_change.set("uLastPulse", pulse.previous);
    m_change.set("uLastValid", int(light.valid && surface.valid && pulse.valid));
    m_change.set("uDepth", frame.targets.at("depth"));
    setChangedPlaces(frame.scene);
    frame.drawFullscreen();
    return trusted;
}

void AccumulatePass::draw(const FrameContext& frame) const {
    if (!m_change || !m_program) return;
    const History light = frame.targets.history("accumulated", GL_RGBA16F);
    const History surface = frame.targets.history("surface", GL_RGBA32F);
    const bool remembers = frame.settings.temporal && light.valid && surface.valid;
    const bool forgets = remembers && frame.settings.forgetsChanges;
    const Texture& trusted = forgets ? findChanges(frame, light, surface) : frame.blueNoise;  // else not looked at
    frame.targets.framebuffer({&light.current, &surface.current}, &frame.targets.at("depthBuffer")).begin();
    const float none[4] = {0, 0, 0, 0}, sky[4] = {GBufferPass::kSkyDepth, -1, 0, 0};
    glClearBufferfv(GL_COLOR, 0, none);
    glClearBufferfv(GL_COLOR, 1, sky);
    const DepthLimit limit(DepthLimit::To::Surfaces);
    m_program.use();
    GBufferPass::bind(m_program, frame.targets);
    m_program.set("uLight", frame.targets.at("light"));
    m_program.set("uLastLight", light.previous);
    m_program.set("uLastSurface", surface.previous);
    m_program.set("uTrusted", trusted);
    m_program.set("uForgets", int(forgets));
    m_program.set("uLastValid", int(remembers));
    m_program.set("uLongest", float(frame.settings.historyFrames));
    frame.drawFullscreen();
}

}  // namespace rubble
