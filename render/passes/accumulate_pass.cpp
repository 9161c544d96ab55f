#include "render/passes/accumulate_pass.h"

#include "render/passes/fullscreen.h"
#include "render/passes/gbuffer_pass.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr double kBrickMetres = 1.6;  // of the shadow volume
constexpr int kTile = 4;              // pixels: passes/light_change.frag

/// Where what casts shadows has changed, for passes/light_change.frag.
void setChangedPlaces(const Program& program, const Scene& scene) {
    std::vector<glm::vec4> corners;
    for (const ChangedPlaces::Box& box : scene.changedPlaces().boxes())
        for (const glm::ivec3& corner : {box.low, box.high})
            corners.emplace_back(glm::vec3(glm::dvec3(corner) * kBrickMetres - scene.origin()), 0.0f);
    program.set("uChangedPlaces", int(corners.size()));
    if (!corners.empty()) program.set("uChanged[0]", std::span<const glm::vec4>(corners));
}

}  // namespace

AccumulatePass::AccumulatePass(ShaderLibrary& shaders)
    : m_change(shaders.loadFullscreen("passes/light_change.frag")), m_program(shaders.loadFullscreen("passes/accumulate.frag", {.limited = true})) {}

const Texture& AccumulatePass::findChanges(const FrameContext& frame, const History& light, const History& surface) const {
    const History pulse = frame.targets.history("lightPulse", GL_RGBA16F, kTile);
    const Texture& trusted = frame.targets.target("lightTrusted", GL_RG8, kTile, Filter::Linear);
    drawFullscreen(frame, m_change, {frame.targets, {&pulse.current, &trusted}}, [&](const Program& program) {
        program.set("uLight", frame.targets.at("light"));
        program.set("uMotion", frame.targets.at("motion"));
        program.set("uLastLight", light.previous);
        program.set("uLastSurface", surface.previous);
        program.set("uLastPulse", pulse.previous);
        program.set("uLastValid", int(light.valid && surface.valid && pulse.valid));
        program.set("uDepth", frame.targets.at("depth"));
        setChangedPlaces(program, frame.scene);
    });
    return trusted;
}

void AccumulatePass::draw(const FrameContext& frame) const {
    if (!m_change || !m_program) return;
    const History light = frame.targets.history("accumulated", GL_RGBA16F);
    const History surface = frame.targets.history("surface", GL_RGBA32F);
    const bool remembers = frame.settings.temporal && light.valid && surface.valid;
    const bool forgets = remembers && frame.settings.forgetsChanges;
    const Texture& trusted = forgets ? findChanges(frame, light, surface) : frame.blueNoise;  // else not looked at
    const glm::vec4 none(0.0f), sky(GBufferPass::kSkyDepth, -1, 0, 0);
    const FullscreenTargets into{frame.targets, {&light.current, &surface.current}, &frame.targets.at("depthBuffer"), {none, sky}};
    drawFullscreen(frame, m_program, into, [&](const Program& program) {
        GBufferPass::bind(program, frame.targets);
        program.set("uLight", frame.targets.at("light"));
        program.set("uSky", int(frame.settings.sky));
        if (frame.settings.sky) program.set("uNearness", frame.targets.at("nearness"));
        program.set("uLastLight", light.previous);
        program.set("uLastSurface", surface.previous);
        program.set("uTrusted", trusted);
        program.set("uForgets", int(forgets));
        program.set("uLastValid", int(remembers));
        program.set("uLongest", float(frame.settings.historyFrames));
    });
}

}  // namespace rubble
